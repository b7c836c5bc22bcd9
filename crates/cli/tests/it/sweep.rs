//! Sweeps from the outside: nothing is lost, whatever ends the process; bad input is refused in words.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

fn gaitcam() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gaitcam"));
    command
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .arg("sweep");
    command
}

fn sweep(out: &Path, arguments: &[&str]) -> Output {
    gaitcam()
        .args(arguments)
        .arg("--out")
        .arg(out)
        .output()
        .unwrap()
}

fn start(out: &Path, arguments: &[&str]) -> Child {
    let mut command = gaitcam();
    command.args(arguments).arg("--out").arg(out);
    command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// The table without its last column, the time.
fn rows(table: &Path) -> Vec<String> {
    let text = fs::read_to_string(table).unwrap();
    text.lines()
        .map(|l| l.rsplit_once(',').unwrap().0.to_string())
        .collect()
}

fn words(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn refused(arguments: &[&str], say: &str) {
    let folder = tempfile::tempdir().unwrap();
    let output = sweep(&folder.path().join("t.csv"), arguments);
    assert_eq!(
        output.status.code(),
        Some(2),
        "{arguments:?}: {}",
        words(&output)
    );
    assert!(
        words(&output).contains(say),
        "{arguments:?}: {}",
        words(&output)
    );
    assert!(
        fs::read_dir(folder.path()).unwrap().next().is_none(),
        "{arguments:?} left a file"
    );
}

/// Numbers that look random and are the same in every run of the test but for the process's own number.
struct Dice(u64);

impl Dice {
    fn up_to(&mut self, most: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % most
    }
}

const SLOW: [&str; 6] = [
    "--vary",
    "gait.step_frequency=1.5 Hz:2.3 Hz:10",
    "--vary",
    "limits.stroke=35 mm:60 mm:12",
    "--vary",
    "law.family=spline,harmonic,program",
];
const FAST: [&str; 8] = [
    "--set",
    "law.family=harmonic",
    "--vary",
    "gait.body_weight=400 N:1000 N:40",
    "--vary",
    "gait.step_frequency=1.6 Hz:2.2 Hz:20",
    "--vary",
    "limits.curvature=1 mm:9 mm:50",
];

/// Kills a sweep at random moments and resumes it until it ends by itself; returns how often it was killed.
fn killed_again_and_again(out: &Path, arguments: &[&str], kills: usize, longest_ms: u64) -> usize {
    let mut dice = Dice(u64::from(std::process::id()));
    let resume = [arguments, &["--resume"]].concat();
    let mut done = 0;
    for _ in 0..kills {
        let mut child = start(out, &resume);
        std::thread::sleep(Duration::from_millis(5 + dice.up_to(longest_ms)));
        let ended = child.try_wait().unwrap().is_some();
        child.kill().unwrap();
        child.wait().unwrap();
        if ended {
            // The table stands: begin again, so that every kill meets a running sweep.
            for ending in ["", ".partial", ".partial.json", ".sweep.json"] {
                let _ = fs::remove_file(PathBuf::from(format!("{}{ending}", out.display())));
            }
        } else {
            done += 1;
        }
    }
    let last = sweep(out, &resume);
    assert_eq!(last.status.code(), Some(0), "{}", words(&last));
    done
}

#[test]
fn a_sweep_killed_twenty_times_ends_with_the_same_table() {
    let folder = tempfile::tempdir().unwrap();
    let mut kills = 0;
    // On a busy machine many a sweep ends before it is killed: as many rounds as twenty hits need.
    for round in 0..10 {
        for (name, arguments) in [("slow", &SLOW[..]), ("fast", &FAST[..])] {
            let calm = folder.path().join(format!("{name}-calm-{round}.csv"));
            let start = std::time::Instant::now();
            assert_eq!(sweep(&calm, arguments).status.code(), Some(0));
            // Kills fall within the first three quarters of what an undisturbed run takes here and now.
            let longest_ms = (start.elapsed().as_millis() as u64 * 3 / 4).max(10);
            let killed = folder.path().join(format!("{name}-killed-{round}.csv"));
            kills += killed_again_and_again(&killed, arguments, 12, longest_ms);
            assert_eq!(rows(&calm), rows(&killed));
            let left = format!("{name}-killed-{round}.csv.partial");
            assert!(!folder.path().join(left).exists());
        }
        if kills >= 20 {
            break;
        }
    }
    println!("{kills} kills met a running sweep");
    assert!(kills >= 20, "{kills}");
}

#[test]
fn rows_are_the_same_for_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let (one, three) = (folder.path().join("1.csv"), folder.path().join("3.csv"));
    let short = [
        "--sample",
        "40",
        "--vary",
        "limits.stroke=35 mm:60 mm",
        "--vary",
        "law.family=spline,harmonic",
    ];
    sweep(&one, &[&short[..], &["--jobs", "1"]].concat());
    sweep(&three, &[&short[..], &["--jobs", "3"]].concat());
    assert_eq!(rows(&one).len(), 41);
    assert_eq!(rows(&one), rows(&three));
}

/// A journal that a killed sweep left behind.
fn interrupted(out: &Path, arguments: &[&str]) -> PathBuf {
    let journal = PathBuf::from(format!("{}.partial", out.display()));
    let mut child = start(out, arguments);
    for _ in 0..2000 {
        std::thread::sleep(Duration::from_millis(5));
        if fs::metadata(&journal).is_ok_and(|m| m.len() > 10_000) {
            break;
        }
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(journal.exists());
    journal
}

#[test]
fn a_truncated_last_chunk_is_repaired() {
    let folder = tempfile::tempdir().unwrap();
    let (calm, out) = (folder.path().join("calm.csv"), folder.path().join("t.csv"));
    sweep(&calm, &SLOW);
    let journal = interrupted(&out, &SLOW);
    let bytes = fs::read(&journal).unwrap();
    fs::write(&journal, &bytes[..bytes.len() - 100]).unwrap();
    let output = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", words(&output));
    assert!(
        words(&output).contains("cut short by a crash"),
        "{}",
        words(&output)
    );
    assert_eq!(rows(&calm), rows(&out));
    // A finished sweep resumed is finished.
    let again = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert_eq!(again.status.code(), Some(0));
    assert!(String::from_utf8_lossy(&again.stdout).contains("already complete"));
}

#[test]
fn a_stopped_sweep_is_neither_overwritten_nor_mixed_with_another() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let journal = interrupted(&out, &SLOW);
    let before = fs::read(&journal).unwrap();
    let output = sweep(&out, &SLOW);
    assert_eq!(output.status.code(), Some(2));
    assert!(words(&output).contains("--resume"), "{}", words(&output));
    let mut other = [&SLOW[..], &["--resume"]].concat();
    other[3] = "limits.stroke=35 mm:61 mm:12";
    let output = sweep(&out, &other);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        words(&output).contains("limits.stroke: 0.035 m:0.06 m:12 before, 0.035 m:0.061 m:12 now"),
        "{}",
        words(&output)
    );
    let output = sweep(
        &out,
        &[&SLOW[..], &["--resume", "--set", "cam.bore=14 mm"]].concat(),
    );
    assert!(
        words(&output).contains("bore = \"14 mm\"\" only now"),
        "{}",
        words(&output)
    );
    assert!(
        fs::read(&journal).unwrap() == before,
        "the journal was touched"
    );
}

#[test]
fn two_processes_on_one_table_refuse_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let mut first = start(&out, &SLOW);
    let journal = PathBuf::from(format!("{}.partial", out.display()));
    while !fs::metadata(&journal).is_ok_and(|m| m.len() > 0) {
        std::thread::sleep(Duration::from_millis(2));
    }
    let second = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert_eq!(second.status.code(), Some(2), "{}", words(&second));
    assert!(
        words(&second).contains("another gaitcam"),
        "{}",
        words(&second)
    );
    assert!(first.wait().unwrap().success());
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_cleanly_and_resume_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let (calm, out) = (folder.path().join("calm.csv"), folder.path().join("t.csv"));
    sweep(&calm, &SLOW);
    let mut child = start(&out, &SLOW);
    let journal = PathBuf::from(format!("{}.partial", out.display()));
    while !fs::metadata(&journal).is_ok_and(|m| m.len() > 5_000) {
        std::thread::sleep(Duration::from_millis(2));
    }
    let id = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &id])
            .status()
            .unwrap()
            .success()
    );
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let output = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert!(!words(&output).contains("cut short"), "{}", words(&output));
    assert_eq!(rows(&calm), rows(&out));
}

#[test]
fn bad_sweeps_are_refused_before_anything_is_written() {
    refused(&[], "no key varies");
    refused(
        &["--vary", "limits.strok=1 mm:2 mm:3"],
        "did you mean \"stroke\"?",
    );
    refused(&["--vary", "name=a,b"], "cannot vary");
    refused(&["--vary", "limits.stroke=1 mm:2 mm:0"], "empty grid");
    refused(&["--vary", "law.family="], "empty grid");
    refused(&["--vary", "limits.stroke=1:2:3"], "has no unit");
    refused(
        &[
            "--vary",
            "limits.stroke=1 mm:2 mm:1000000",
            "--vary",
            "limits.jerk=1 m/s^3:2 m/s^3:1000000",
        ],
        "1000000000000 combinations",
    );
    refused(&["--list", "no-such-file.csv"], "cannot be read");
    refused(&["--sample", "5"], "empty grid");
    refused(&["--recordings", "no-such-folder"], "cannot be read");
    let folder = tempfile::tempdir().unwrap();
    let output = sweep(&folder.path().join("t.txt"), &["--vary", "law.degree=3,5"]);
    assert!(words(&output).contains("neither .csv nor .parquet"));
    if !cfg!(feature = "parquet") {
        let output = sweep(
            &folder.path().join("t.parquet"),
            &["--vary", "law.degree=3,5"],
        );
        assert!(words(&output).contains("feature \"parquet\"") && words(&output).contains(".csv"));
    }
    fs::write(folder.path().join("t.csv.partial"), "my own notes").unwrap();
    let output = sweep(
        &folder.path().join("t.csv"),
        &["--vary", "law.degree=3,5", "--resume"],
    );
    assert!(
        words(&output).contains("not the partial table of a sweep"),
        "{}",
        words(&output)
    );
}

#[test]
fn unusable_recordings_and_impossible_scenes_are_rows_with_their_reason() {
    let folder = tempfile::tempdir().unwrap();
    let recordings = folder.path().join("recordings");
    fs::create_dir(&recordings).unwrap();
    let good = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("data/gait_curves/setra_2Hz_700N.csv");
    fs::copy(good, recordings.join("b.csv")).unwrap();
    fs::write(recordings.join("a.txt"), "no numbers here\n").unwrap();
    fs::write(recordings.join("c.csv"), "").unwrap();
    let out = folder.path().join("t.csv");
    let output = sweep(
        &out,
        &[
            "--recordings",
            recordings.to_str().unwrap(),
            "--vary",
            "law.family=spline,program",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", words(&output));
    let mut reader = csv::Reader::from_path(&out).unwrap();
    let header = reader.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let table: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let outcomes: Vec<&str> = table.iter().map(|r| &r[column("outcome")]).collect();
    assert_eq!(
        outcomes,
        ["error", "error", "built", "error", "error", "error"]
    );
    assert!(
        table[0][column("error")].contains("a.txt"),
        "{:?}",
        table[0]
    );
    assert!(
        table[3][column("error")].contains("segments"),
        "{:?}",
        table[3]
    );
}

#[test]
fn lists_and_several_scenes_give_their_rows_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("list.csv");
    fs::write(
        &list,
        "limits.stroke,law.family\n50 mm,spline\n55 mm,harmonic\n",
    )
    .unwrap();
    let out = folder.path().join("t.csv");
    let output = sweep(
        &out,
        &[
            "scenes/footbridge.toml",
            "scenes/footbridge_thesis_scale.toml",
            "--list",
            list.to_str().unwrap(),
            "--vary",
            "law.degree=4,5",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", words(&output));
    let rows = rows(&out);
    assert!(rows[0].starts_with("row,scene,limits.stroke_m,law.family,law.degree,"));
    let starts: Vec<String> = rows[1..]
        .iter()
        .map(|r| r.split(',').take(5).collect::<Vec<_>>().join(","))
        .collect();
    assert_eq!(starts[0], "0,scenes/footbridge.toml,0.05,spline,4");
    assert_eq!(starts[3], "3,scenes/footbridge.toml,0.055,harmonic,5");
    assert_eq!(
        starts[4],
        "4,scenes/footbridge_thesis_scale.toml,0.05,spline,4"
    );
    assert_eq!(starts.len(), 8);
}

fn gaitcam_front(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_gaitcam"))
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .arg("front")
        .args(arguments)
        .output()
        .unwrap()
}

#[test]
fn the_best_of_a_sweep_opens_as_the_design_that_its_row_describes() {
    let folder = tempfile::tempdir().unwrap();
    let (table, out) = (folder.path().join("t.csv"), folder.path().join("front"));
    let vary = [
        "--set",
        "accuracy.rms=20 %",
        "--vary",
        "limits.stroke=42 mm:50 mm:5",
        "--vary",
        "law.spans=12,16",
        "--vary",
        "limits.curvature=5 mm:40 mm:3",
    ];
    assert_eq!(sweep(&table, &vary).status.code(), Some(0));
    let (file, dir) = (table.to_str().unwrap(), out.to_str().unwrap());
    let front = gaitcam_front(&[
        file,
        "--minimise",
        "force_error,prime_radius,jerk",
        "--out",
        dir,
        "--json",
    ]);
    assert_eq!(front.status.code(), Some(0), "{}", words(&front));
    let json: serde_json::Value = serde_json::from_slice(&front.stdout).unwrap();
    for name in [
        "front.csv",
        "front.svg",
        "front.png",
        "parallel.png",
        "report.html",
    ] {
        assert!(out.join(name).metadata().unwrap().len() > 100, "{name}");
    }
    let best = gaitcam_front(&[
        file,
        "--minimise",
        "force_error,prime_radius,jerk",
        "--out",
        dir,
        "--best",
        "--json",
    ]);
    assert_eq!(best.status.code(), Some(0), "{}", words(&best));
    let summary: serde_json::Value = serde_json::from_slice(&best.stdout).unwrap();
    let of_table = json["best"]["force_rms_error_percent"].as_f64().unwrap();
    let of_design = summary["force"]["rms_error_percent_of_mean"]
        .as_f64()
        .unwrap();
    assert!(
        (of_table / of_design - 1.0).abs() < 1e-9,
        "{of_table} {of_design}"
    );
    let radius = json["best"]["prime_radius_m"].as_f64().unwrap();
    assert!((radius / summary["cam"]["prime_radius_m"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    assert!(out.join("best/profile.csv").exists() && out.join("best.toml").exists());
}

#[test]
fn front_refuses_what_is_no_sweep_and_unknown_objectives() {
    let folder = tempfile::tempdir().unwrap();
    let no_sweep = gaitcam_front(&["data/gait_curves/young_1.85Hz_700N.csv"]);
    assert_eq!(no_sweep.status.code(), Some(2));
    assert!(
        words(&no_sweep).contains("young_1.85Hz_700N.csv"),
        "{}",
        words(&no_sweep)
    );
    let table = folder.path().join("t.csv");
    sweep(
        &table,
        &[
            "--vary",
            "law.harmonics=2,3",
            "--set",
            "law.family=harmonic",
        ],
    );
    let unknown = gaitcam_front(&[table.to_str().unwrap(), "--minimise", "prime_radus"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(
        words(&unknown).contains("did you mean \"prime_radius\"?"),
        "{}",
        words(&unknown)
    );
    // Nothing passes: that is no fault of the input.
    sweep(&table, &["--vary", "limits.stroke=1 mm,2 mm"]);
    assert_eq!(
        gaitcam_front(&[table.to_str().unwrap()]).status.code(),
        Some(3)
    );
}

#[test]
fn scatter_of_no_width_is_the_design_and_wider_tolerances_cost_yield() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let run = |tolerance: &str| -> serde_json::Value {
        let output = sweep(
            &out,
            &[
                "--tolerance",
                tolerance,
                "--tolerance",
                "speed=0.5 %",
                "--sample",
                "2000",
                "--band",
                "1 %",
                "--json",
            ],
        );
        assert_eq!(output.status.code(), Some(0), "{}", words(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let (narrow, wide) = (run("mass=0 %"), run("mass=3 %"));
    assert_eq!(narrow["yield"], 1.0);
    // 3 % of the mass miss the mean force by up to 3 %: two thirds of the cams leave a band of 1 %.
    let share = wide["yield"].as_f64().unwrap();
    assert!(share > 0.2 && share < 0.4, "{share}");
    assert_eq!(rows(&out).len(), 2001);
    refused(
        &["--tolerance", "colour=1 mm"],
        "parts with a tolerance: profile",
    );
    refused(&["--tolerance", "profile=1"], "no unit");
    refused(
        &["--tolerance", "mass=1 %", "--vary", "law.degree=3,5"],
        "one design",
    );
}

#[test]
fn a_folder_of_recordings_fills_a_scene_that_names_none() {
    let folder = tempfile::tempdir().unwrap();
    let records = folder.path().join("records");
    fs::create_dir(&records).unwrap();
    for name in ["a.csv", "b.csv"] {
        fs::copy(
            concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../data/gait_curves/young_1.85Hz_700N.csv"
            ),
            records.join(name),
        )
        .unwrap();
    }
    for name in ["README.md", "LICENSE", "LICENCE.txt", "people_metadata.csv"] {
        fs::write(records.join(name), "words about the recordings").unwrap();
    }
    let table = folder.path().join("t.csv");
    let output = sweep(
        &table,
        &[
            "scenes/measured_walk.toml",
            "--recordings",
            records.to_str().unwrap(),
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", words(&output));
    assert!(
        words(&output).contains("4 file(s) beside"),
        "{}",
        words(&output)
    );
    assert_eq!(fs::read_to_string(&table).unwrap().lines().count(), 3);
    let about = records.join("README.md");
    fs::remove_file(records.join("a.csv")).unwrap();
    fs::remove_file(records.join("b.csv")).unwrap();
    let none = sweep(
        &folder.path().join("u.csv"),
        &[
            "scenes/measured_walk.toml",
            "--recordings",
            records.to_str().unwrap(),
        ],
    );
    assert_eq!(none.status.code(), Some(2));
    assert!(words(&none).contains("none of 4 files"), "{}", words(&none));
    assert!(about.exists());
}

#[test]
fn values_that_do_not_go_with_another_key_cost_their_rows_only() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    // The bore of 12 mm leaves no base circle of 5 mm.
    let output = sweep(&table, &["--vary", "cam.base_radius=5 mm:20 mm:4"]);
    assert_eq!(output.status.code(), Some(0), "{}", words(&output));
    let text = fs::read_to_string(&table).unwrap();
    let faults = text.lines().filter(|l| l.contains("bore")).count();
    assert_eq!((text.lines().count(), faults), (5, 1), "{text}");
}

/// Blocks are Parquet files, which a plain build cannot write.
#[cfg(not(feature = "parquet"))]
#[test]
fn shards_need_the_build_that_writes_parquet() {
    let folder = tempfile::tempdir().unwrap();
    let output = sweep(
        &folder.path().join("blocks"),
        &["--vary", "law.degree=3,5", "--shard", "1/2"],
    );
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("--features parquet"), "{said}");
}

#[cfg(feature = "parquet")]
#[test]
fn shards_fill_one_folder_that_front_reads() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("blocks");
    let vary = [
        "--vary",
        "law.family=harmonic",
        "--vary",
        "gait.body_weight=600 N:800 N:10",
    ];
    let share = |which: &str| {
        let more = ["--shard", which, "--block-rows", "3"];
        sweep(&out, &[&vary[..], &more].concat())
    };
    for which in ["1/2", "2/2", "1/2"] {
        let output = share(which);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
    let mut names: Vec<String> = std::fs::read_dir(&out)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names.len(), 5, "{names:?}");
    assert_eq!(names[0], "_plan.json");
    assert_eq!(names[4], "rows-000000000009-000000000010.parquet");
    let other = [
        "--vary",
        "gait.body_weight=600 N:900 N:10",
        "--shard",
        "1/2",
        "--block-rows",
        "3",
    ];
    let refused = sweep(&out, &other);
    assert_eq!(refused.status.code(), Some(2));
    let front = Command::new(env!("CARGO_BIN_EXE_gaitcam"))
        .args(["front", "--json", "--minimise", "stroke", "--out"])
        .arg(folder.path().join("front"))
        .arg(&out)
        .output()
        .unwrap();
    let found: serde_json::Value = serde_json::from_slice(&front.stdout).unwrap();
    assert_eq!(found["rows"], 10);
}
