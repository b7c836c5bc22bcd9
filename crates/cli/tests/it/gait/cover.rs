//! `gaitcam cover` and `gaitcam gait --against`: the written files agree, and `gaitcam synth` reproduces the cams.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::support::{object, run_in, stderr, stdout, walk};

/// Writes a table of walkers of two alternating kinds, with the rows of each.
fn table(path: &Path, count: usize) {
    let mut text = String::from("walker,speed_m_per_s,mass_kg,period_s");
    (0..=100).for_each(|i| write!(text, ",f_{i:03}").unwrap());
    text.push('\n');
    for w in 0..count {
        let (f, a) = [(1.6, 0.28), (2.1, 0.5)][w % 2];
        let a = a + 0.002 * w as f64;
        write!(text, "W{w:02},,,{}", 1.0 / f).unwrap();
        for i in 0..=100 {
            let x = TAU * f64::from(i % 100) / 100.0;
            write!(
                text,
                ",{}",
                700.0 * (1.0 + a * x.sin() + 0.08 * (2.0 * x).cos())
            )
            .unwrap();
        }
        text.push('\n');
    }
    fs::write(path, text).unwrap();
}

fn rows(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    let rows = text.lines().skip(1);
    rows.map(|l| l.split(',').map(str::to_string).collect())
        .collect()
}

#[test]
fn the_scenes_of_a_cover_make_its_cams_and_a_walker_is_served_by_the_cam_of_his_kind() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    table(&at.join("walkers.csv"), 12);
    let arguments = [
        "cover",
        "walkers.csv",
        "--cams",
        "1:3",
        "--out",
        "out",
        "--set",
        "law.robust=worst",
    ];
    let answer = run_in(at, &arguments);
    assert!(answer.status.success(), "{}", stderr(&answer));
    assert!(
        stdout(&answer).contains("shape") || stdout(&answer).contains("size"),
        "{}",
        stdout(&answer)
    );
    let covers = rows(&at.join("out/cover.csv"));
    assert_eq!(covers.len(), 3);
    let number = |text: &str| text.parse::<f64>().unwrap();
    assert!(
        number(&covers[1][2]) < 0.5 * number(&covers[0][2]),
        "{covers:?}"
    );
    assert!(
        covers
            .iter()
            .all(|c| number(&c[3]) <= number(&c[2]) * (1.0 + 1e-9)),
        "{covers:?}"
    );
    let assigned = rows(&at.join("out/assignment.csv"));
    let two: Vec<&Vec<String>> = assigned.iter().filter(|a| a[0] == "2").collect();
    assert_eq!(two.len(), 12);
    assert!((0..12).all(|i| two[i][2] == two[i % 2][2]));
    // The scene alone makes the same cam.
    let scene = format!("out/cams_2/cam_{}.toml", two[0][2]);
    let again = object(&run_in(at, &["synth", &scene, "--json"]));
    let own = two
        .iter()
        .filter(|a| a[2] == two[0][2])
        .map(|a| number(&a[3]));
    let worst = again["population"]["worst_percent"].as_f64().unwrap();
    assert!(
        (worst / own.fold(0.0, f64::max) - 1.0).abs() < 1e-9,
        "{worst}"
    );
    assert_eq!(again["population"]["walkers"], 6);
    assert_eq!(
        rows(&at.join("out/folds.csv"))
            .iter()
            .filter(|r| r[0] == "2")
            .count(),
        2
    );
    for file in ["cover.svg", "cover.png", "cycles.csv"] {
        assert!(at.join("out").join(file).exists());
    }
    let text = fs::read_to_string(at.join("walkers.csv")).unwrap();
    let new: Vec<&str> = text
        .lines()
        .enumerate()
        .filter(|(i, _)| [0, 1].contains(i))
        .map(|l| l.1)
        .collect();
    let cycle: String = new[1].split(',').skip(4).take(100).enumerate().fold(
        "t_s,force_n\n".to_string(),
        |mut out, (i, f)| {
            writeln!(out, "{},{f}", 0.00625 * i as f64).unwrap();
            out
        },
    );
    fs::write(at.join("new.csv"), cycle).unwrap();
    let answer = run_in(
        at,
        &[
            "gait",
            "new.csv",
            "--period",
            "0.625 s",
            "--against",
            "out",
            "--json",
        ],
    );
    let against = object(&answer)["against"].as_array().unwrap().clone();
    assert_eq!(against.len(), 3, "{against:?}");
    assert_eq!(against[1]["scene"], scene[4..]);
    let error = against[1]["rms_error_percent"].as_f64().unwrap();
    assert!(
        (error - number(&two[0][3])).abs() < 1e-6,
        "{error} {}",
        two[0][3]
    );
}

#[test]
fn recordings_of_a_folder_are_covered_and_results_never_lie_among_them() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::create_dir(at.join("walks")).unwrap();
    for name in ["a.csv", "b.csv", "c.csv"] {
        walk(&at.join("walks").join(name));
    }
    let inside = run_in(at, &["cover", "walks", "--out", "walks/out"]);
    assert_eq!(inside.status.code(), Some(2), "{}", stderr(&inside));
    assert!(stderr(&inside).contains("--out"));
    assert!(!at.join("walks/out/cover.csv").exists());
    let answer = run_in(at, &["cover", "walks", "--cams", "1:6", "--out", "out"]);
    assert!(answer.status.success(), "{}", stderr(&answer));
    // Of three walkers at most three cams; fewer than ten are not left out in turn.
    assert_eq!(rows(&at.join("out/cover.csv")).len(), 3);
    assert!(rows(&at.join("out/folds.csv")).is_empty());
    fs::write(at.join("walks/nothing.csv"), "no recording\n").unwrap();
    for (language, why) in [("en", "no column of"), ("es", "ninguna columna de")] {
        let refused = run_in(at, &["--lang", language, "cover", "walks", "--out", "out"]);
        assert_eq!(refused.status.code(), Some(2));
        let told = stderr(&refused);
        for part in ["nothing.csv: ", why, "gait.leave_out"] {
            assert!(told.contains(part), "{part}: {told}");
        }
        // Reasons of which there is no case are not listed.
        assert!(!told.contains("weight") && !told.contains("peso"), "{told}");
    }
    let told = run_in(
        at,
        &[
            "cover",
            "walks",
            "--out",
            "out",
            "--cams",
            "1",
            "--set",
            "gait.leave_out=[\"nothing.csv\"]",
        ],
    );
    assert!(told.status.success(), "{}", stderr(&told));
}

/// The scene of each cam contains its share of the worst part.
#[test]
fn the_scenes_of_a_cover_of_the_worst_part_make_its_cams() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    table(&at.join("walkers.csv"), 12);
    let settings = ["--set", "law.robust=cvar 0.5", "--set", "law.spans=6"];
    let cover = ["cover", "walkers.csv", "--cams", "2", "--out", "out"];
    let answer = run_in(at, &[&cover[..], &settings[..]].concat());
    assert!(answer.status.success(), "{}", stderr(&answer));
    let served = rows(&at.join("out/assignment.csv"));
    assert_eq!(served.len(), 12);
    let mut compared = 0;
    for cam in ["1", "2"] {
        let scene = format!("out/cams_2/cam_{cam}.toml");
        let again = run_in(at, &["synth", &scene, "--out", "again", "--no-png"]);
        assert!(
            again.status.code().is_some_and(|c| c != 2),
            "{}",
            stderr(&again)
        );
        for own in rows(&at.join("again/walkers.csv")) {
            let row = served.iter().find(|r| r[1] == own[0]).unwrap();
            assert_eq!(row[2], cam);
            let error = |text: &str| text.parse::<f64>().unwrap();
            assert!(
                (error(&own[4]) / error(&row[3]) - 1.0).abs() < 1e-6,
                "{own:?} {row:?}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 12);
}

/// Rows without a cycle are all listed with their lines. They are left out only if named by name or by line.
#[test]
fn rows_of_a_table_without_a_cycle_are_listed_by_line_and_left_out_when_said() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    table(&at.join("walkers.csv"), 12);
    let text = fs::read_to_string(at.join("walkers.csv")).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    let spoil = |line: &str, column: usize, cell: &str| {
        let mut cells: Vec<&str> = line.split(',').collect();
        cells[column] = cell;
        cells.join(",")
    };
    lines[3] = spoil(&lines[3], 3, "-0.5");
    lines[5] = spoil(&lines[5], 20, "soon");
    lines[8] = lines[8].split(',').take(40).collect::<Vec<_>>().join(",");
    fs::write(at.join("walkers.csv"), lines.join("\n")).unwrap();
    let run = |language: &str, out: &str| {
        let setting = format!("gait.leave_out={out}");
        let cover = [
            "--lang",
            language,
            "cover",
            "walkers.csv",
            "--cams",
            "1",
            "--out",
            "out",
        ];
        run_in(at, &[&cover[..], &["--set", &setting]].concat())
    };
    for (language, line) in [("en", "line"), ("es", "línea")] {
        let refused = run(language, "[]");
        assert_eq!(refused.status.code(), Some(2));
        let told = stderr(&refused);
        for part in [4, 6, 9].map(|n| format!("walkers.csv {line} {n}: ")) {
            assert!(told.contains(&part), "{part}: {told}");
        }
        assert!(
            told.contains("soon") && told.contains("f_016") && told.contains("3 "),
            "{told}"
        );
    }
    let some = run("en", r#"["W02", "W04"]"#);
    let told = stderr(&some);
    assert!(
        told.contains("line 9") && !told.contains("line 4") && !told.contains("line 6"),
        "{told}"
    );
    let all = run("en", r#"["W02", "walkers.csv:6", "W07"]"#);
    assert!(all.status.success(), "{}", stderr(&all));
    assert_eq!(rows(&at.join("out/assignment.csv")).len(), 9);
}

/// A cover with errors in newtons: the tables state newtons, the sums agree, and a new walker is assessed in newtons.
#[test]
fn a_cover_of_errors_in_newtons_has_its_tables_in_newtons() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    table(&at.join("walkers.csv"), 12);
    let settings = [
        "--set",
        "law.robust=worst",
        "--set",
        "law.error=absolute",
        "--json",
    ];
    let cover = ["cover", "walkers.csv", "--cams", "1:2", "--out", "out"];
    let answer = object(&run_in(at, &[&cover[..], &settings[..]].concat()));
    let head = |name: &str| {
        let text = fs::read_to_string(at.join("out").join(name)).unwrap();
        text.lines().next().unwrap().to_string()
    };
    assert_eq!(head("cover.csv"), "cams,mean_n,worst_n,bound_n");
    assert_eq!(
        head("assignment.csv"),
        "cams,walker,cam,rms_error_n,weight_n,speed_n,shape_n"
    );
    assert_eq!(
        head("folds.csv"),
        "cams,walkers,in_mean_n,in_worst_n,out_mean_n,out_worst_n"
    );
    let number = |text: &str| text.parse::<f64>().unwrap();
    let covers = rows(&at.join("out/cover.csv"));
    for (i, cover) in covers.iter().enumerate() {
        let own = rows(&at.join("out/assignment.csv"));
        let own = own.iter().filter(|r| r[0] == cover[0]);
        let worst = own.map(|r| {
            let sum: f64 = r[4..7].iter().map(|x| number(x).powi(2)).sum();
            assert!((sum.sqrt() / number(&r[3]) - 1.0).abs() < 1e-9, "{r:?}");
            number(&r[3])
        });
        let worst = worst.fold(0.0, f64::max);
        assert!((worst / number(&cover[2]) - 1.0).abs() < 1e-9);
        assert_eq!(answer["covers"][i]["worst_n"], number(&cover[2]));
        let scene = format!("out/cams_{}/cam_1.toml", cover[0]);
        let again = object(&run_in(at, &["synth", &scene, "--json"]));
        assert_eq!(again["population"]["error"], "absolute");
        if i == 0 {
            let own = again["population"]["worst_n"].as_f64().unwrap();
            assert!((own / worst - 1.0).abs() < 1e-9, "{own} {worst}");
        }
    }
    let told = stdout(&run_in(
        at,
        &["synth", "out/cams_1/cam_1.toml", "--no-png", "--out", "one"],
    ));
    assert!(told.contains(" N on average"), "{told}");
    let page = fs::read_to_string(at.join("one/report.html")).unwrap();
    let shown = format!("{:.1}", number(&covers[0][2]));
    assert!(page.contains(&shown) && page.contains("\u{a0}N"), "{shown}");
}

#[test]
fn numbers_of_cams_and_folders_that_are_none_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    table(&at.join("walkers.csv"), 4);
    for cams in ["0", "3:2", "two", "1:99"] {
        let answer = run_in(at, &["cover", "walkers.csv", "--cams", cams]);
        assert_eq!(answer.status.code(), Some(2), "{cams}");
        assert!(
            stderr(&answer).contains("--cams") && stderr(&answer).contains(cams),
            "{}",
            stderr(&answer)
        );
    }
    let none = run_in(at, &["cover", "nowhere"]);
    assert_eq!(none.status.code(), Some(2), "{}", stderr(&none));
    assert!(stderr(&none).contains("nowhere"), "{}", stderr(&none));
    fs::create_dir(at.join("empty")).unwrap();
    fs::write(at.join("empty/cover.csv"), "a,b\n1,2\n").unwrap();
    walk(&at.join("walk.csv"));
    let answer = run_in(at, &["gait", "walk.csv", "--against", "empty"]);
    assert_eq!(answer.status.code(), Some(2));
    assert!(stderr(&answer).contains("cover.csv"), "{}", stderr(&answer));
}
