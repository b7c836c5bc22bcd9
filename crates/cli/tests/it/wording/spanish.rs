//! A run in Spanish prints no English words.

use std::path::Path;

use crate::support::{both, gaitcam, walk};

/// Frequent words of the English messages that are neither Spanish words nor words of a scene file.
const ENGLISH: &[&str] = &[
    "acceptable",
    "active",
    "and",
    "are",
    "at",
    "before",
    "best",
    "built",
    "by",
    "contact",
    "convex",
    "curvature",
    "cycle",
    "default",
    "design",
    "designs",
    "equality",
    "follower",
    "force",
    "infeasible",
    "is",
    "largest",
    "law",
    "lift",
    "lift-off",
    "limit",
    "limits",
    "maximum",
    "mean",
    "minimum",
    "not",
    "of",
    "power",
    "pressure",
    "prime",
    "radius",
    "recording",
    "rigid",
    "roller",
    "row",
    "rows",
    "satisfied",
    "speed",
    "stroke",
    "target",
    "the",
    "then",
    "torque",
    "velocity",
    "width",
    "with",
    "within",
];

/// Text of a run in Spanish on both streams. Asserts the exit code `code`.
fn said(arguments: &[&str], code: i32) -> String {
    let run = gaitcam(&[&["--lang", "es"], arguments].concat());
    let text = both(&run);
    assert_eq!(run.status.code(), Some(code), "{arguments:?}: {text}");
    assert!(!text.trim().is_empty(), "{arguments:?}");
    text
}

/// Words of a text without the surrounding punctuation. A quoted text, a path or a key is one word.
fn words(text: &str) -> impl Iterator<Item = &str> {
    // What begins with a colon is typed as it stands: `force_error:jerk`, or `:jerk`.
    text.split_whitespace()
        .filter(|word| !word.starts_with(':'))
        .map(|word| word.trim_matches(['(', ')', ',', ';', ':', '.', '!', '?']))
}

/// Text without literal values: the choices of an argument, `[valores: walking, running]`, lists of texts, `["0.4", "0.1 at -90 deg"]`, and the
/// default of a key.
fn without_typed(mut text: String) -> String {
    for begin in ["[valores:", "[\""] {
        while let Some(from) = text.find(begin) {
            let length = text[from..].find(']').unwrap();
            text.replace_range(from..=from + length, "");
        }
    }
    let defaults = text.split("por defecto ").enumerate();
    let typed = |part: &str| part.find(char::is_whitespace).unwrap_or(part.len());
    let rests = defaults.map(|(i, part)| if i == 0 { part } else { &part[typed(part)..] });
    rests.collect()
}

/// Asserts that a run in Spanish prints no English word.
fn assert_spanish(arguments: &[&str], code: i32) {
    let text = without_typed(said(arguments, code));
    // Choices of a key, `both | one | left`, are typed as they stand.
    for line in text.lines().filter(|line| !line.contains(" | ")) {
        let found = words(line).find(|w| ENGLISH.contains(&w.to_lowercase().as_str()));
        assert!(found.is_none(), "{found:?} in {line:?} of {arguments:?}");
    }
}

/// Whether a line contains a number with a decimal point.
fn has_decimal_point(line: &str) -> bool {
    words(line).any(|word| {
        let digits = |part: &str| part.chars().all(|c| c.is_ascii_digit());
        let number = word.trim_start_matches(['-', '−', '+']);
        let number = number.trim_end_matches(['°', '%']);
        let parts = number.split_once('.');
        parts.is_some_and(|(a, b)| !a.is_empty() && !b.is_empty() && digits(a) && digits(b))
    })
}

#[test]
fn the_words_looked_for_are_those_of_the_english_messages() {
    let messages = [
        include_str!("../../../words/en/cli.ftl"),
        include_str!("../../../../../src/wording/en/names.ftl"),
        include_str!("../../../../../src/wording/en/figures.ftl"),
        include_str!("../../../../../src/wording/en/limits.ftl"),
        include_str!("../../../../../src/wording/en/synth.ftl"),
        include_str!("../../../../../src/wording/en/dynamics.ftl"),
        include_str!("../../../../../src/wording/en/solver.ftl"),
        include_str!("../../../../../src/wording/en/law.ftl"),
        include_str!("../../../../../src/wording/en/cam.ftl"),
        include_str!("../../../../gait/src/wording/en/force.ftl"),
    ]
    .concat();
    for word in ENGLISH {
        assert!(words(&messages).any(|w| w == *word), "{word}");
    }
}

#[test]
fn designs_in_spanish_hold_no_english_word_and_no_decimal_point() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    for scene in [
        "footbridge",
        "camdas_01_roller",
        "camdas_02_oscillating_roller",
        "translating_cam",
    ] {
        let out = path(scene);
        assert_spanish(&["synth", scene, "--out", &out], 0);
        let shown = said(&["synth", scene, "--out", &out], 0);
        let point = shown.lines().find(|line| has_decimal_point(line));
        assert_eq!(point, None, "{scene}");
    }
    // The closed form is named where it is passed over.
    for limit in ["limits.stroke=48.5 mm", "limits.jerk=65 m/s^3"] {
        let automatic = [
            "synth",
            "footbridge",
            "--set",
            "law.family=auto",
            "--set",
            limit,
            "--verbose",
            "--out",
        ];
        let shown = said(&[&automatic[..], &[&path("auto")]].concat(), 0);
        assert!(
            shown.contains("la solución inversa por armónicos"),
            "{shown}"
        );
        assert!(!shown.contains("inverse"), "{shown}");
    }
    let out = path("none");
    let short = [
        "synth",
        "footbridge",
        "--set",
        "limits.stroke=10 mm",
        "--out",
        &out,
    ];
    assert_spanish(&short, 3);
    assert_spanish(&["synth", "footbridge", "--explain", "--out", &out], 0);
    assert_spanish(&["simulate", "footbridge", "--out", &path("run")], 0);
    let (one, other) = (path("footbridge"), path("translating_cam"));
    assert_spanish(&["compare", &one, &other, "--out", &path("both")], 0);
}

#[test]
fn numbers_in_spanish_have_a_decimal_comma() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (out, table) = (path("out"), path("t.csv"));
    let walkers = "gait.step_frequency=1.4 Hz:2.4 Hz:3";
    let vary = "limits.stroke=45 mm:50 mm:2";
    let mut commands = vec![
        vec!["synth", "footbridge", "--set", walkers, "--out", &out],
        vec![
            "cover",
            "footbridge",
            "--set",
            walkers,
            "--cams",
            "2",
            "--out",
            &out,
        ],
        vec![
            "simulate",
            "footbridge",
            "--speeds",
            "1.4 Hz:2.3 Hz:3",
            "--out",
            &out,
        ],
        vec![
            "synth",
            "footbridge",
            "--front",
            "force_error:stroke",
            "--out",
            &out,
        ],
        vec!["sweep", "footbridge", "--vary", vary, "--out", &table],
        vec!["laws"],
    ];
    // The one left out needs a recording.
    let scenes = gaitcam::scene::SCENES
        .iter()
        .filter(|s| s.name != "measured_walk");
    commands.extend(scenes.map(|s| vec!["synth", s.name, "--verbose", "--no-png", "--out", &out]));
    assert!(commands.len() > 25);
    for command in commands {
        let shown = both(&gaitcam(&[&["--lang", "es"], &command[..]].concat()));
        let point = shown.lines().find(|line| has_decimal_point(line));
        assert_eq!(point, None, "{command:?}");
    }
}

#[test]
fn sweeps_in_spanish_hold_no_english_word() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (table, samples) = (path("t.csv"), path("s.csv"));
    let vary = "limits.stroke=35 mm:60 mm:4";
    assert_spanish(&["sweep", "footbridge", "--vary", vary, "--out", &table], 0);
    let goals = "force_error,torque_max";
    assert_spanish(
        &[
            "front",
            &table,
            "--minimise",
            goals,
            "--out",
            &path("front"),
        ],
        0,
    );
    let scatter = ["--tolerance", "mass=5 %", "--band", "5 %", "--sample", "50"];
    assert_spanish(
        &[&["sweep", "footbridge", "--out", &samples], &scatter[..]].concat(),
        0,
    );
    // The pages beside them.
    for page in [path("front/report.html"), format!("{samples}.report.html")] {
        let page = std::fs::read_to_string(page).unwrap();
        for heading in [
            "Heat map",
            "Parallel",
            "compromise",
            "manufactur",
            "As designed",
            "Yield",
        ] {
            assert!(!page.contains(heading), "{heading}");
        }
    }
}

#[test]
fn lists_and_recordings_in_spanish_hold_no_english_word() {
    let folder = tempfile::tempdir().unwrap();
    for verb in ["laws", "scenes", "keys"] {
        assert_spanish(&[verb], 0);
    }
    let file = folder.path().join("andar.csv");
    walk(Path::new(&file));
    let out = folder.path().join("ciclo.csv").display().to_string();
    assert_spanish(&["gait", file.to_str().unwrap(), "--out", &out], 0);
}

#[test]
fn help_in_spanish_holds_no_english_word() {
    assert_spanish(&["--help"], 0);
    for verb in [
        "synth",
        "gait",
        "simulate",
        "sweep",
        "front",
        "compare",
        "studio",
        "keys",
        "scenes",
        "laws",
        "init",
        "doctor",
        "completions",
        "inspect",
        "identify",
        "recut",
    ] {
        assert_spanish(&[verb, "--help"], 0);
        let page = said(&[verb, "--help"], 0);
        for word in ["Usage", "Options", "Print", "default:", "possible"] {
            assert!(!page.contains(word), "{word} in {page}");
        }
    }
    assert_spanish(&["init"], 0);
    assert_spanish(&["doctor", "footbridge"], 0);
}

#[test]
fn pages_and_pictures_in_spanish_show_no_decimal_point() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("puente").display().to_string();
    said(&["synth", "footbridge", "--no-png", "--out", &out], 0);
    said(&["simulate", "footbridge", "--out", &out], 0);
    for file in ["report.html", "force.svg", "svaj.svg", "cam.svg"] {
        let page = std::fs::read_to_string(format!("{out}/{file}")).unwrap();
        // Scripts, styles and code are for machines.
        let mut seen = page;
        for name in ["script", "style", "code"] {
            while let Some(from) = seen.find(&format!("<{name}")) {
                let length = seen[from..].find(&format!("</{name}>")).unwrap();
                seen.replace_range(from..from + length, "");
            }
        }
        let behind = |part: &str| {
            part.split_once('>')
                .map_or("", |(_, text)| text)
                .to_string()
        };
        let text: Vec<String> = seen.split('<').skip(1).map(behind).collect();
        let text = text.join("\n");
        let point = text.lines().find(|line| has_decimal_point(line));
        assert_eq!(point, None, "{file}");
        // The title of a load model names the feet by their key.
        assert!(!text.contains("both feet"), "{file}");
    }
}
