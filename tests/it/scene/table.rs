use gaitcam::error::Error;
use gaitcam::scene::keys::{self, KEYS, Kind, Value};
use gaitcam::scene::{self, SCENES, Scene};
use gaitcam::wording::{Language, key_doc};
use toml::Table;

use super::random::{Numbers, table, typed};

/// Number of random tables to read.
const TABLES: u64 = 4_000;
/// Minimum number of tables that are valid scenes.
const SCENES_WANTED: usize = 120;

#[test]
fn a_scene_reads_back_exactly_from_toml_and_from_json() {
    let mut built = 0;
    for seed in 0..TABLES {
        let table = table(&mut Numbers(seed));
        let read = scene::read_keys(&table).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{table}"));
        // Not every scene whose keys are right is one that can be designed.
        if scene::read(&table).is_err() {
            continue;
        }
        built += 1;
        let text = toml::to_string(&read).unwrap();
        let again: Scene = toml::from_str(&text).unwrap_or_else(|e| panic!("{seed}: {e}\n{text}"));
        assert_eq!(again, read, "seed {seed}\n{table}\n→\n{text}");
        let text = serde_json::to_string(&read).unwrap();
        assert_eq!(serde_json::from_str::<Scene>(&text).unwrap(), read);
    }
    assert!(
        built >= SCENES_WANTED,
        "only {built} of {TABLES} are scenes"
    );
}

#[test]
fn every_built_in_scene_reads_back_exactly() {
    for built_in in SCENES {
        let table: Table = built_in.toml.parse().unwrap();
        let Ok(read) = scene::read(&table) else {
            // It leaves its recording to the user.
            assert_eq!(built_in.name, "measured_walk");
            continue;
        };
        let text = toml::to_string(&read).unwrap();
        assert_eq!(toml::from_str::<Scene>(&text).unwrap(), read, "{text}");
    }
}

/// For every key in a scene that uses it, text, change and direct number lead to the same scene.
#[test]
fn a_file_a_change_and_a_sweep_set_the_same() {
    let mut met = vec![0; KEYS.len()];
    let mut direct = 0;
    for seed in 0..400 {
        let mut numbers = Numbers(seed);
        let base = table(&mut numbers);
        let read = scene::read_keys(&base).unwrap();
        for (row, key) in KEYS.iter().enumerate().filter(|(_, k)| k.exists(&read)) {
            let there = key.list().is_none() || key.get(&read, 0).is_some();
            let gaitless = key.section() == "gait" && read.gait.is_none();
            let decides = matches!(key.path, "cam.follower" | "drive.kind" | "law.family");
            let Some(text) = typed(key, &read, &mut numbers) else {
                continue;
            };
            if !there || gaitless || decides {
                continue;
            }
            let path = key.path_at(0);
            let mut changed = base.clone();
            scene::set(&mut changed, &format!("{path}={text}")).unwrap();
            let Ok(by_text) = scene::read_keys(&changed) else {
                continue;
            };
            met[row] += 1;
            let value = key.get(&by_text, 0);
            let mut by_row = read.clone();
            if let Some(Value::Number(x)) = value
                && key.set_number(&mut by_row, 0, x)
            {
                direct += 1;
                // The family that a scene gets without naming one may follow from a change.
                by_row.law.family = by_text.law.family;
                assert_eq!(by_row, by_text, "{path} = {text}, seed {seed}");
            }
        }
    }
    let never: Vec<_> = (KEYS.iter().zip(&met))
        .filter(|(k, n)| {
            **n == 0 && !matches!(k.path, "cam.follower" | "drive.kind" | "law.family")
        })
        .collect();
    assert!(
        never.is_empty() && direct > 2000,
        "{direct} direct, never {never:?}"
    );
}

#[test]
fn defaults_of_the_table_are_the_values_of_an_empty_scene() {
    let empty = Scene::default();
    for key in KEYS
        .iter()
        .filter(|k| k.exists(&empty) && k.list().is_none())
    {
        if matches!(key.default, "" | "auto") || key.section() == "gait" {
            continue;
        }
        let mut table = Table::new();
        scene::set(&mut table, &format!("{}={}", key.path, key.default)).unwrap();
        let read = scene::read_keys(&table).unwrap();
        assert_eq!(read, empty, "{} = {}", key.path, key.default);
    }
}

#[test]
fn numbers_without_a_unit_and_outside_their_range_are_refused_at_their_key() {
    let empty = Scene::default();
    for key in KEYS
        .iter()
        .filter(|k| k.exists(&empty) && k.list().is_none())
    {
        let Kind::Number(measure) = key.kind else {
            continue;
        };
        let mut table = Table::new();
        let bare = match measure.translating.si() {
            "" => "-1",
            _ => "3",
        };
        scene::set(&mut table, &format!("{}={bare}", key.path)).unwrap();
        let e = scene::read_keys(&table).unwrap_err();
        let place = gaitcam::error::Place::Key(key.path.to_string());
        assert_eq!(e.place, place, "{e}");
        assert!(e.help(Language::En).is_some(), "{e}");
    }
}

#[test]
fn a_key_without_effect_is_noted() {
    let with = |changes: &[&str]| {
        let mut table: Table = scene::DEFAULT.parse().unwrap();
        for change in changes {
            scene::set(&mut table, change).unwrap();
        }
        let read = scene::read(&table).unwrap();
        let notes = read.notes();
        let words: Vec<String> = notes
            .iter()
            .map(|n| Error::from(n.clone()).what(Language::En))
            .collect();
        words.join("\n")
    };
    assert_eq!(with(&[]), "");
    let recording = with(&["gait.file=walk.mot", "gait.body_weight=600 N"]);
    assert!(recording.contains("gait.body_weight") && recording.contains("recording"));
    let roller = with(&[
        "cam.follower=roller-translating",
        "cam.roller_radius=10 mm",
        "limits.face_width=80 mm",
    ]);
    assert!(roller.contains("limits.face_width") && roller.contains("roller-translating"));
    assert!(with(&["law.family=harmonic", "law.degree=5"]).contains("law.degree"));
}

#[test]
fn a_derivative_that_a_degree_does_not_have_is_no_objective() {
    let objectives = [("acceleration", 2), ("jerk", 3), ("snap", 4)];
    for (name, order) in objectives {
        for objective in [name.to_string(), format!("peak-{name}")] {
            for degree in 3..=9 {
                let mut table: Table = scene::DEFAULT.parse().unwrap();
                for change in [
                    format!("law.minimise={objective}"),
                    format!("law.degree={degree}"),
                ] {
                    scene::set(&mut table, &change).unwrap();
                }
                let refused = scene::read(&table).err().map(|e| e.to_string());
                let named = refused.as_ref().is_some_and(|e| e.contains("law.degree"));
                assert_eq!(named, degree < order, "{objective} {degree}: {refused:?}");
            }
        }
    }
}

/// The schema is a list of patterns. The test evaluates enough of it to accept every scene and to reject typing errors.
#[test]
fn the_schema_accepts_every_built_in_scene_and_refuses_unknown_keys() {
    let schema = scene::keys::schema(Language::En);
    for built_in in SCENES {
        let table: Table = built_in.toml.parse().unwrap();
        let value = serde_json::to_value(&table).unwrap();
        assert_eq!(fault(&schema, &value), None, "{}", built_in.name);
    }
    // Every key that is a text or a table with keys of its own.
    let keys = scene::keys::KEYS.iter();
    let both: Vec<&str> = (keys.clone().map(|k| k.path))
        .filter(|path| {
            keys.clone()
                .any(|k| k.path.starts_with(&format!("{path}.")))
        })
        .collect();
    assert!(both.contains(&"cam.material"), "{both:?}");
    for path in both {
        let (section, name) = path.split_once('.').unwrap();
        let inner = keys
            .clone()
            .find(|k| k.path.starts_with(&format!("{path}.")));
        let inner = &inner.unwrap().path[path.len() + 1..];
        for text in [
            format!("[{section}]\n{name} = \"bronze\""),
            format!("[{section}.{name}]\n{inner} = \"3 GPa\""),
        ] {
            let table: Table = text.parse().unwrap();
            let value = serde_json::to_value(&table).unwrap();
            assert_eq!(fault(&schema, &value), None, "{text}");
        }
    }
    let wrong = [
        "[cam]\nmaterial = 3",
        "[cam.material]\nyung = \"3 GPa\"",
        "[limits]\nstrok = \"40 mm\"",
        "[limits]\nstroke = 40",
        "[limits]\nstroke = \"40\"",
        "[cam]\nfollower = \"flat\"",
        "[law]\ndegree = 0",
    ];
    for text in wrong {
        let table: Table = text.parse().unwrap();
        let value = serde_json::to_value(&table).unwrap();
        assert!(fault(&schema, &value).is_some(), "{text}");
    }
}

/// Position at which a value violates a schema, for the keywords of JSON Schema that the schema uses.
fn fault(schema: &serde_json::Value, value: &serde_json::Value) -> Option<String> {
    if let Some(any) = schema["anyOf"].as_array() {
        return any
            .iter()
            .all(|s| fault(s, value).is_some())
            .then(|| format!("{value} fits none of {schema}"));
    }
    if let Some(words) = schema["enum"].as_array() {
        return (!words.contains(value)).then(|| format!("{value} is not in {schema}"));
    }
    if !schema["const"].is_null() {
        return (schema["const"].as_f64() != value.as_f64()).then(|| format!("{value} is not 0"));
    }
    if let Some(types) = schema["type"].as_array() {
        let alone = |one: &serde_json::Value| {
            let mut of_type = schema.clone();
            of_type["type"] = one.clone();
            fault(&of_type, value)
        };
        return (types.iter())
            .all(|one| alone(one).is_some())
            .then(|| format!("{value} is none of {types:?}"));
    }
    let fits = match schema["type"].as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("integer") => value.is_u64(),
        Some("number") => value.is_number(),
        _ => false,
    };
    if !fits {
        return Some(format!("{value} is no {}", schema["type"]));
    }
    if let (Some(low), Some(high)) = (schema["minimum"].as_u64(), schema["maximum"].as_u64())
        && !(low..=high).contains(&value.as_u64()?)
    {
        return Some(format!("{value} is outside {low} … {high}"));
    }
    // Patterns only ask for a unit after a number here.
    if let (Some(pattern), Some(text)) = (schema["pattern"].as_str(), value.as_str()) {
        let bare = text.parse::<f64>().is_ok_and(|x| x != 0.0);
        return (bare && pattern.contains("[^\\s\\d.]")).then(|| format!("{text} has no unit"));
    }
    if let Some(items) = value.as_array() {
        return items.iter().find_map(|v| fault(&schema["items"], v));
    }
    let keys = value.as_object()?;
    keys.iter()
        .find_map(|(key, inner)| match schema["properties"].get(key) {
            None => Some(format!("there is no {key}")),
            Some(schema) => fault(schema, inner),
        })
}

#[test]
fn the_reference_page_is_that_of_the_table() {
    let page = include_str!("../../../docs/keys.md");
    assert_eq!(
        page.trim_end(),
        keys::markdown().trim_end(),
        "docs/keys.md is old: write it anew with `gaitcam keys --markdown > docs/keys.md`"
    );
}

#[test]
fn every_key_has_its_sentence_in_both_languages() {
    for key in KEYS.iter() {
        for language in [Language::En, Language::Es] {
            assert!(
                key_doc(language, key.path).ends_with(['.', '…']),
                "{}",
                key.path
            );
        }
    }
}

/// Every limit is a number or none. The program never selects a limit.
#[test]
fn a_limit_is_a_number_or_none_and_never_auto() {
    let mut tried = 0;
    for name in [
        "footbridge",
        "heel_tester_fitted",
        "camdas_11_oscillating_roller",
    ] {
        let scene = scene::built_in(name).unwrap().scene().unwrap();
        for key in KEYS
            .iter()
            .filter(|k| k.limit.is_some() && k.exists(&scene))
        {
            let error = scene.with(key.path, "auto").unwrap_err().to_string();
            assert!(
                error.contains(key.path) && error.contains("auto"),
                "{error}"
            );
            let without = scene.with(key.path, "none").unwrap();
            assert_eq!(key.number(&without), None, "{name} {}", key.path);
            tried += 1;
        }
    }
    println!("{tried} limits of three scenes");
    assert!(tried > 40);
}
