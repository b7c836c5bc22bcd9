//! Responses to the page.

use serde_json::{Value, json};

use super::client::Running;
use gaitcam::scene::{DEFAULT, SCENES};
use gaitcam_studio::{Options, open};

fn design(studio: &Running, ask: &Value) -> Value {
    studio.post("design", ask.to_string().as_bytes()).json()
}

#[test]
fn every_scene_but_the_one_without_a_recording_is_designed_and_drawn() {
    let studio = Running::new();
    for scene in SCENES.iter().filter(|s| s.name != "heel_tester_fitted") {
        let answer = design(&studio, &json!({"scene": scene.toml}));
        if scene.name == "measured_walk" {
            assert_eq!(answer["error"]["key"], "gait.file", "{answer}");
            continue;
        }
        assert!(
            answer["error"].is_null(),
            "{}: {}",
            scene.name,
            answer["error"]
        );
        let count = answer["curves"]["theta"].as_array().unwrap().len();
        assert!(count > 300);
        for panel in answer["curves"]["panels"].as_array().unwrap() {
            for line in panel["lines"].as_array().unwrap() {
                assert_eq!(
                    line["y"].as_array().unwrap().len(),
                    count,
                    "{}",
                    panel["id"]
                );
            }
        }
        assert!(answer["drawing"].as_str().unwrap().contains("cam-follower"));
        let picture = json!({"name": scene.name}).to_string();
        let picture = studio.post("scene-picture", picture.as_bytes()).json();
        assert!(picture["svg"].is_string(), "{}: {picture}", scene.name);
    }
}

/// While a radius is dragged, the response is a law that satisfies the limits, or at once that there is none. The final response agrees.
#[test]
fn a_radius_under_the_hand_is_answered_soon_and_alike() {
    let studio = Running::new();
    let scene = SCENES.iter().find(|s| s.name == "heel_tester_fitted");
    let scene = scene.unwrap().toml;
    let answers = [
        ("cam.prime_radius", "45 mm", "unacceptable"),
        ("cam.prime_radius", "60 mm", "acceptable"),
        ("limits.prime_radius", "45 mm", "unacceptable"),
        ("limits.prime_radius", "60 mm", "acceptable"),
    ];
    for (key, radius, verdict) in answers {
        let changes = [json!({"set": {"key": key, "value": radius}})];
        let ask = |quick: Value| {
            let ask = json!({"scene": scene, "changes": changes, "quick": quick});
            design(&studio, &ask)
        };
        let (quick, whole) = (ask(json!([0.0501, 0.0008])), ask(Value::Null));
        assert_eq!(quick["quick"], true, "{radius}");
        assert_eq!(quick["verdict"], verdict, "{radius}: {}", quick["reasons"]);
        assert_eq!(whole["quick"], false);
        assert_eq!(whole["verdict"], verdict, "{radius}: {}", whole["reasons"]);
        assert_eq!(quick["scene"], whole["scene"]);
    }
}

#[test]
fn the_speed_of_a_shaft_under_its_motor_is_a_diagram_of_its_own() {
    let studio = Running::new();
    let set = |key: &str, value: &str| json!({"set": {"key": key, "value": value}});
    let motor = [
        set("machine.motor.slope", "10 N m s/rad"),
        set("machine.inertia", "0.5 kg m^2"),
    ];
    let diagram = |changes: &[Value], id: &str| -> Option<Value> {
        let answer = design(&studio, &json!({"scene": DEFAULT, "changes": changes}));
        let panels = answer["curves"]["panels"].as_array().unwrap();
        panels.iter().find(|p| p["id"] == id).cloned()
    };
    let values = |panel: &Value| -> Vec<f64> {
        let y = panel["lines"][0]["y"].as_array().unwrap();
        y.iter().map(|y| y.as_f64().unwrap()).collect()
    };
    assert_eq!(diagram(&[], "speed"), None);
    let panel = diagram(&motor, "speed").unwrap();
    let speed = values(&panel);
    let low = speed.iter().copied().fold(f64::INFINITY, f64::min);
    let high = speed.iter().copied().fold(0.0, f64::max);
    // The ripple of the guide's example.
    let ripple = (high - low) / panel["levels"][0]["y"].as_f64().unwrap();
    assert!((ripple - 0.2544).abs() < 1e-3, "{ripple}");
    // Power is torque times the speed there.
    let [torque, power] = ["torque", "power"].map(|id| values(&diagram(&motor, id).unwrap()));
    for ((p, t), w) in power.iter().zip(&torque).zip(&speed) {
        assert!((p - t * w).abs() < 1e-2, "{p} {t} {w}");
    }
}

#[test]
fn a_change_is_in_the_scene_that_comes_back() {
    let studio = Running::new();
    let changes = json!([{"set": {"key": "limits.stroke", "value": "55 mm"}}]);
    let answer = design(&studio, &json!({"scene": DEFAULT, "changes": changes}));
    assert_eq!(answer["fields"]["limits.stroke"]["text"], "55 mm");
    let again = design(&studio, &json!({"scene": answer["scene"]}));
    assert_eq!(again["fields"], answer["fields"]);
    assert_eq!(again["figures"], answer["figures"]);
}

#[test]
fn a_fault_names_its_key_in_the_language_of_the_page() {
    let studio = Running::new();
    let changes = json!([{"set": {"key": "limits.stroke", "value": "55"}}]);
    let say = |language: &str| {
        let ask = json!({"scene": DEFAULT, "changes": changes, "language": language});
        let answer = design(&studio, &ask);
        assert_eq!(answer["error"]["key"], "limits.stroke");
        answer["error"]["message"].as_str().unwrap().to_string()
    };
    assert_ne!(say("en"), say("es"));
}

#[test]
fn an_infeasible_scene_names_its_conflict_and_a_relaxation_mends_it() {
    let studio = Running::new();
    let changes = json!([{"set": {"key": "limits.stroke", "value": "20 mm"}}]);
    let answer = design(&studio, &json!({"scene": DEFAULT, "changes": changes}));
    assert_eq!(answer["verdict"], "unacceptable");
    let which = json!({"scene": answer["scene"]}).to_string();
    let relaxed = studio.post("relax", which.as_bytes()).json();
    let all = relaxed["relaxations"].as_array().unwrap();
    let one = all.iter().find(|r| r["value"].is_string()).unwrap();
    let changes = json!([{"set": {"key": one["key"], "value": one["value"]}}]);
    let mended = design(
        &studio,
        &json!({"scene": answer["scene"], "changes": changes}),
    );
    assert_eq!(mended["verdict"], "acceptable", "{}", mended["reasons"]);
}

#[test]
fn exported_tables_are_those_of_the_library_and_the_scene_reads_back() {
    let studio = Running::new();
    let answer = design(&studio, &json!({"scene": DEFAULT}));
    let export = |name: &str| {
        let question = json!({"scene": answer["scene"], "name": name});
        studio.post("export", question.to_string().as_bytes())
    };
    let scene = gaitcam::scene::parse(DEFAULT).unwrap();
    let target =
        gaitcam::force::model("young", Some(1.85), 700.0, gaitcam::force::Feet::Both).unwrap();
    let own = gaitcam::synth::synthesise(&scene, Some(&target)).unwrap();
    assert_eq!(
        export("law.csv").body,
        gaitcam_output::csv::law(&own, 1440).into_bytes()
    );
    assert_eq!(
        export("profile.csv").body,
        gaitcam_output::csv::profile(&own, 1440).into_bytes()
    );
    let text = String::from_utf8(export("scene.toml").body).unwrap();
    assert_eq!(gaitcam::scene::parse(&text).unwrap(), scene);
}

#[test]
fn every_file_that_the_page_lists_is_exported() {
    let studio = Running::new();
    let answer = design(&studio, &json!({"scene": DEFAULT}));
    let export = |name: &str| {
        let question = json!({"scene": answer["scene"], "name": name});
        studio.post("export", question.to_string().as_bytes())
    };
    for name in [
        "profile.dxf",
        "profile.svg",
        "svaj.svg",
        "force.svg",
        "cam.svg",
        "svaj.png",
        "force.png",
        "cam.png",
        "report.html",
        "summary.json",
        "profile.stl",
        "profile.3mf",
        "cam.step",
        "profile.xlsx",
        "cutter.csv",
    ] {
        let answer = export(name);
        assert_eq!(answer.status, 200, "{name}");
        assert!(
            answer
                .head
                .contains(&format!("attachment; filename=\"{name}\"")),
            "{}",
            answer.head
        );
        assert!(answer.body.len() > 100, "{name}");
    }
    let nothing = export("nothing.csv").json();
    assert_eq!(nothing["error"]["code"], "studio-no-file");
    // The page lists what the command writes, and each is there.
    let listed: Vec<String> = (answer["exports"].as_array().unwrap().iter())
        .flat_map(|group| group[1].as_array().unwrap())
        .map(|name| name.as_str().unwrap().to_string())
        .collect();
    for name in ["drawing.pdf", "cutter.nc", "cam.step", "scene.toml"] {
        assert!(listed.iter().any(|n| n == name), "{name}");
    }
    for name in &listed {
        assert_eq!(export(name).status, 200, "{name}");
    }
}

#[test]
fn a_scene_is_saved_beside_what_is_there_never_over_it() {
    let studio = Running::new();
    let save = |text: &str| {
        let body = json!({"scene": text, "name": "walk"}).to_string();
        studio.post("save", body.as_bytes()).json()["written"][0]
            .as_str()
            .unwrap()
            .to_string()
    };
    assert_eq!(save("name = \"a\"\n"), "walk.toml");
    assert_eq!(save("name = \"b\"\n"), "walk-2.toml");
    let first = std::fs::read_to_string(studio.inside().join("walk.toml")).unwrap();
    assert_eq!(first, "name = \"a\"\n");
}

#[test]
fn an_invalid_name_of_a_scene_leaves_no_recording_behind() {
    let studio = Running::new();
    let files = json!([{"name": "hand.csv", "hash": drawn(&studio, 300.0)}]);
    let scene = "name = \"a\"\n[gait]\nfile = \"hand.csv\"\n";
    for name in ["", " ", ".toml", "a/b", "a:b.toml"] {
        let body = json!({"scene": scene, "name": name, "files": files}).to_string();
        let answer = studio.post("save", body.as_bytes()).json();
        assert_eq!(answer["error"]["code"], "studio-file-name", "{name}");
        assert!(!studio.inside().join("hand.csv").exists(), "{name}");
    }
    let body = json!({"scene": scene, "name": "a", "files": files}).to_string();
    let answer = studio.post("save", body.as_bytes()).json();
    assert_eq!(answer["written"], json!(["hand.csv", "a.toml"]), "{answer}");
}

#[test]
fn scenes_saved_at_once_under_one_name_each_keep_their_text() {
    let studio = Running::new();
    let save = &|k: usize| {
        let text = format!("name = \"scene {k}\"\n");
        let body = json!({"scene": text, "name": "walk"}).to_string();
        let written = studio.post("save", body.as_bytes()).json()["written"][0].clone();
        (text, written.as_str().unwrap().to_string())
    };
    let saved: Vec<(String, String)> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..24).map(|k| scope.spawn(move || save(k))).collect();
        all.into_iter().map(|t| t.join().unwrap()).collect()
    });
    for (text, name) in saved {
        let there = std::fs::read_to_string(studio.inside().join(&name)).unwrap();
        assert_eq!(there, text, "{name}");
    }
}

#[test]
fn a_force_drawn_by_hand_becomes_a_cam() {
    let studio = Running::new();
    let points = json!([[0.0, 100.0], [0.1, 300.0], [0.25, 180.0], [0.4, 250.0]]);
    let body = json!({"file": "hand.csv", "period_s": 0.5, "points": points}).to_string();
    let drawn = studio.post("force", body.as_bytes()).json();
    assert_eq!(drawn["use"], "hand.csv");
    let changes = json!([{"set": {"key": "gait.file", "value": "hand.csv"}}, {"set": {"key": "limits.stroke", "value": ""}}]);
    let files = json!([{"name": "hand.csv", "hash": drawn["hash"]}]);
    let ask = json!({"scene": DEFAULT, "changes": changes, "files": files});
    let answer = design(&studio, &ask);
    assert!(answer["error"].is_null(), "{}", answer["error"]);
    assert_eq!(answer["force_hash"], drawn["hash"]);
    let target = &answer["curves"]["panels"][0]["lines"][1];
    assert_eq!(target["role"], "target");
    let highest = target["y"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(Value::as_f64)
        .fold(0.0, f64::max);
    assert!((highest - 300.0).abs() < 0.5, "{highest}");
    assert!(studio.files().iter().all(|f| !f.0.ends_with("hand.csv")));
}

#[test]
fn sensitivities_and_fronts_are_answered_for_the_default_scene() {
    let studio = Running::new();
    let body = json!({"scene": DEFAULT, "quantity": "acceleration_max_m_per_s2", "share": 0.05})
        .to_string();
    let bars = studio.post("sensitivity", body.as_bytes()).json();
    let first = &bars["bars"][0];
    // Faster steps press harder.
    assert_eq!(first["key"], "gait.step_frequency", "{bars}");
    assert!(first["low"].as_f64() < first["high"].as_f64());
    let body = json!({"scene": DEFAULT, "against": "stroke"}).to_string();
    let front = studio.post("front", body.as_bytes()).json();
    let points = front["points"].as_array().unwrap();
    assert!(points.len() > 3, "{front}");
}

#[test]
fn a_motion_is_read_from_a_file_of_the_folder_and_from_nowhere_else() {
    let studio = Running::new();
    let rows = "angle_deg,lift_mm\n0,0\n60,5\n120,10\n";
    std::fs::write(studio.inside().join("lift.csv"), rows).unwrap();
    std::fs::write(studio.folder.path().join("secret.csv"), rows).unwrap();
    let scene = |motion: &str| {
        format!(
            "[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[law]\nfamily = \"program\"\n\
             [[law.segment]]\nmotion = \"{motion}\"\n\
             [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-10 mm\"\nangle = \"240 deg\"\n\
             [cam]\nfollower = \"flat-translating\"\nbase_radius = \"60 mm\"\n"
        )
    };
    let file = design(&studio, &json!({"scene": scene("table lift.csv")}));
    assert!(file["error"].is_null(), "{file}");
    let sizes = "table 0 0 0.5 0.5 1 1\"\nlift = \"10 mm\"\nangle = \"120 deg";
    let inline = design(&studio, &json!({"scene": scene(sizes)}));
    assert_eq!(file["figures"], inline["figures"]);
    assert_eq!(file["curves"], inline["curves"]);
    // The page keeps the name of the file, also over a choice that needs more keys.
    assert_eq!(
        file["fields"]["law.segment.1.motion"]["text"],
        "table lift.csv"
    );
    let changes = json!([{"set": {"key": "cam.follower", "value": "roller-translating"}}]);
    let roller = design(
        &studio,
        &json!({"scene": file["scene"], "changes": changes}),
    );
    assert!(roller["error"].is_null(), "{roller}");
    assert_eq!(
        roller["fields"]["law.segment.1.motion"]["text"],
        "table lift.csv"
    );
    for outside in ["../secret.csv", "/etc/passwd"] {
        let answer = design(
            &studio,
            &json!({"scene": scene(&format!("table {outside}"))}),
        );
        assert_eq!(answer["error"]["code"], "studio-outside", "{answer}");
    }
}

/// Points of a force with the maximum `peak`, stored by the studio; returns their hash.
fn drawn(studio: &Running, peak: f64) -> Value {
    let points = json!([[0.0, 100.0], [0.1, peak], [0.25, 180.0], [0.4, 250.0]]);
    let body = json!({"file": "same.csv", "period_s": 0.5, "points": points}).to_string();
    studio.post("force", body.as_bytes()).json()["hash"].clone()
}

#[test]
fn two_files_of_one_name_never_take_each_others_place() {
    let studio = Running::new();
    let peaks = [300.0, 320.0, 340.0, 360.0, 380.0];
    let hashes = peaks.map(|peak| drawn(&studio, peak));
    let changes = json!([{"set": {"key": "gait.file", "value": "same.csv"}}, {"set": {"key": "limits.stroke", "value": ""}}]);
    for k in (0..peaks.len()).chain((0..peaks.len()).rev()) {
        let files = json!([{"name": "same.csv", "hash": hashes[k]}]);
        let ask = json!({"scene": DEFAULT, "changes": changes, "files": files});
        let answer = design(&studio, &ask);
        assert_eq!(answer["force_hash"], hashes[k]);
        let target = answer["curves"]["panels"][0]["lines"][1]["y"].as_array();
        let values = target.unwrap().iter().filter_map(Value::as_f64);
        let highest = values.fold(0.0, f64::max);
        assert!(
            (highest - peaks[k]).abs() < 0.5,
            "{highest} for {}",
            peaks[k]
        );
    }
}

#[test]
fn an_answer_names_its_question_and_the_files_that_are_not_kept() {
    let studio = Running::new();
    let of = |text: &str| gaitcam_app::page::Hash::of(text.as_bytes()).to_string();
    let question = json!({"scene": DEFAULT}).to_string();
    let answer = studio.post("design", question.as_bytes()).json();
    assert_eq!(answer["of"], of(&question));
    let unknown = of("a file that nobody has sent");
    let files = json!([{"name": "walk.csv", "hash": unknown}]);
    let question = json!({"scene": DEFAULT, "files": files}).to_string();
    let answer = studio.post("design", question.as_bytes()).json();
    assert_eq!(answer["missing"], json!([unknown]));
    let kept = studio.post("keep", b"a file that nobody has sent").json();
    assert_eq!(kept["hash"], unknown);
    let answer = studio.post("design", question.as_bytes()).json();
    assert_eq!(answer["verdict"], "acceptable", "{answer}");
}

#[test]
fn a_scene_without_its_recording_is_read_with_its_form() {
    let studio = Running::new();
    let scene = gaitcam::scene::built_in("measured_walk").unwrap().toml;
    let changes = json!([{"set": {"key": "limits.stroke", "value": "55 mm"}}, {"set": {"key": "gait.file", "value": "walk.csv"}}]);
    let question = json!({"scene": scene, "changes": changes}).to_string();
    let read = studio.post("read", question.as_bytes()).json();
    assert_eq!(read["name"], "measured_walk", "{read}");
    assert_eq!(read["fields"]["limits.stroke"]["text"], "55 mm");
}

#[test]
fn verdicts_over_a_value_are_those_of_its_designs() {
    let studio = Running::new();
    let question = json!({
        "scene": DEFAULT, "key": "limits.stroke", "unit": " mm", "from": 20, "to": 80, "count": 4,
    });
    let mut verdicts = Vec::new();
    while verdicts.len() < 4 {
        let mut rest = question.clone();
        rest["from"] = json!(20 + 20 * verdicts.len());
        rest["count"] = json!(4 - verdicts.len());
        let answer = studio.post("range", rest.to_string().as_bytes()).json();
        verdicts.extend(answer["values"].as_array().unwrap().clone());
    }
    for (i, verdict) in verdicts.iter().enumerate() {
        let value = format!("{} mm", 20 + 20 * i);
        let changes = json!([{"set": {"key": "limits.stroke", "value": value}}]);
        let answer = design(&studio, &json!({"scene": DEFAULT, "changes": changes}));
        let is_infeasible = answer["infeasible"] == true;
        let name = match is_infeasible {
            true => "infeasible",
            false => answer["verdict"].as_str().unwrap(),
        };
        assert_eq!(verdict[1], name, "{value}");
    }
    // A value of the wrong dimension is a fault of its design, not of the question.
    let wrong = json!({
        "scene": DEFAULT, "key": "limits.stroke", "unit": " kg", "from": 20, "to": 20, "count": 1,
    });
    let answer = studio.post("range", wrong.to_string().as_bytes()).json();
    assert_eq!(answer["values"], json!([[20.0, "fault"]]));
}

#[test]
fn a_restart_on_the_same_folder_keeps_the_address() {
    let folder = tempfile::tempdir().unwrap();
    let options = || Options {
        open: Some(folder.path().to_path_buf()),
        ..Options::default()
    };
    let first = open(&options()).unwrap().url();
    assert_eq!(open(&options()).unwrap().url(), first);
    let other = tempfile::tempdir().unwrap();
    let other = Options {
        open: Some(other.path().to_path_buf()),
        ..Options::default()
    };
    assert_ne!(open(&other).unwrap().url(), first);
}
