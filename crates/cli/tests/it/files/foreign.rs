//! Foreign folders and inputs: links, pipes, names and devices that point elsewhere or never end.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{command, gaitcam, run_in, stderr};

/// Everything below a folder: contents of files and targets of links.
fn state(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut out = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().flatten() {
        let (path, kind) = (entry.path(), entry.file_type().unwrap());
        if kind.is_dir() {
            out.extend(state(&path));
            out.insert(path, Vec::new());
        } else if kind.is_symlink() {
            let target = fs::read_link(&path).unwrap();
            out.insert(path, target.into_os_string().into_encoded_bytes());
        } else if kind.is_file() {
            out.insert(path.clone(), fs::read(path).unwrap());
        }
    }
    out
}

/// Prepares a folder that is not a result, for which a careless program would remove or move files of `outside`.
type Trap = fn(result: &Path, outside: &Path);

fn stale(result: &Path, names: &str) {
    fs::create_dir(result.join(".gaitcam.ready")).unwrap();
    fs::write(result.join(".gaitcam.ready/.stale"), names).unwrap();
}

const TRAPS: [(&str, Trap); 9] = [
    ("absolute names", |result, outside| {
        stale(
            result,
            &format!("{}\n", outside.join("victim.txt").display()),
        );
    }),
    ("names with dots", |result, _| {
        stale(
            result,
            "../outside/victim.txt\nx/../../outside/law.csv\nnotes.txt",
        );
    }),
    ("a list that is a link", |result, outside| {
        fs::create_dir(result.join(".gaitcam.ready")).unwrap();
        symlink(
            outside.join("names.txt"),
            result.join(".gaitcam.ready/.stale"),
        )
        .unwrap();
    }),
    ("a folder that is a link", |result, outside| {
        symlink(outside, result.join(".gaitcam.ready")).unwrap();
    }),
    ("files that are links", |result, outside| {
        stale(result, "law.csv");
        for name in ["law.csv", "summary.json", "profile.csv"] {
            symlink(
                outside.join("law.csv"),
                result.join(".gaitcam.ready").join(name),
            )
            .unwrap();
        }
    }),
    ("places that are links", |result, outside| {
        stale(result, "profile.csv\nreport.html");
        fs::remove_file(result.join("profile.csv")).unwrap();
        for name in ["profile.csv", "report.html"] {
            symlink(outside.join("law.csv"), result.join(name)).unwrap();
        }
    }),
    ("a lock that is a link", |result, outside| {
        symlink(outside.join("new.txt"), result.join(".gaitcam.lock")).unwrap();
    }),
    ("a lock that is a file of the user", |result, outside| {
        fs::hard_link(outside.join("victim.txt"), result.join(".gaitcam.lock")).unwrap();
    }),
    ("stages that are links and folders", |result, outside| {
        symlink(outside, result.join(".gaitcam.77.new")).unwrap();
        fs::create_dir(result.join(".gaitcam.mine.new")).unwrap();
        fs::write(result.join(".gaitcam.mine.new/thesis.txt"), "mine").unwrap();
        fs::create_dir(result.join(".gaitcam.78.new")).unwrap();
        fs::write(result.join(".gaitcam.78.new/thesis.txt"), "mine").unwrap();
    }),
];

/// Makes both folders anew: a copy of a good result with a note of the user, and files outside of it.
fn afresh(good: &Path, result: &Path, outside: &Path) {
    for folder in [result, outside] {
        let _ = fs::remove_dir_all(folder);
        fs::create_dir(folder).unwrap();
    }
    for (file, text) in [
        ("victim.txt", "mine"),
        ("law.csv", "mine"),
        ("names.txt", "law.csv"),
        ("summary.json", "{}"),
    ] {
        fs::write(outside.join(file), text).unwrap();
    }
    for file in ["law.csv", "profile.csv", "summary.json", "scene.toml"] {
        fs::copy(good.join(file), result.join(file)).unwrap();
    }
    fs::write(result.join("notes.txt"), "mine").unwrap();
}

#[test]
fn no_command_touches_what_lies_outside_a_result_folder() {
    let here = tempfile::tempdir().unwrap();
    let good = here.path().join("good");
    assert!(
        gaitcam(&["synth", "--no-png", "--out", good.to_str().unwrap()])
            .status
            .success()
    );
    let points = here.path().join("points.csv");
    fs::copy(good.join("profile.csv"), &points).unwrap();
    let read = [
        vec!["compare", "good", "R", "--out", "compared"],
        vec!["front", "R"],
        vec!["inspect", "R", "points.csv", "--json"],
        vec!["simulate", "R/summary.json", "--out", "simulated"],
    ];
    let write = [
        vec!["synth", "--no-png", "--out", "R"],
        vec!["simulate", "--out", "R"],
        vec!["inspect", "good/scene.toml", "points.csv", "--out", "R"],
    ];
    for (name, trap) in TRAPS {
        for (reads, arguments) in
            (read.iter().map(|a| (true, a))).chain(write.iter().map(|a| (false, a)))
        {
            let (result, outside) = (here.path().join("R"), here.path().join("outside"));
            afresh(&good, &result, &outside);
            trap(&result, &outside);
            let (before, inside) = (state(&outside), state(&result));
            run_in(here.path(), arguments);
            assert_eq!(state(&outside), before, "{name}: {arguments:?}");
            let after = state(&result);
            assert!(
                !reads || after == inside,
                "{name}: {arguments:?} has changed the folder"
            );
            for (path, content) in &inside {
                let mine = content == b"mine" && !path.ends_with(".gaitcam.lock");
                assert!(
                    !mine || after.get(path) == Some(content),
                    "{name}: {path:?}"
                );
            }
        }
    }
}

#[test]
fn a_result_that_a_killed_process_left_half_moved_is_read_whole() {
    let here = tempfile::tempdir().unwrap();
    for (name, stroke) in [("old", "61 mm"), ("new", "62 mm")] {
        let change = format!("limits.stroke={stroke}");
        assert!(
            run_in(
                here.path(),
                &["synth", "--no-png", "--set", &change, "--out", name]
            )
            .status
            .success()
        );
    }
    let compared = |folder: &str| {
        let output = run_in(
            here.path(),
            &["compare", "old", folder, "--json", "--out", "compared"],
        );
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout)
            .unwrap()
            .replace(folder, "F")
    };
    let whole = compared("new");
    // Some files of the new result have been moved into the folder of the old one, some not yet.
    let half = here.path().join("half");
    run_in(
        here.path(),
        &[
            "synth",
            "--no-png",
            "--set",
            "limits.stroke=61 mm",
            "--out",
            "half",
        ],
    );
    let ready = half.join(".gaitcam.ready");
    fs::create_dir(&ready).unwrap();
    fs::remove_file(half.join("summary.json")).unwrap();
    for name in ["law.csv", "profile.csv", "summary.json"] {
        let place = if name == "law.csv" { &half } else { &ready };
        fs::copy(here.path().join("new").join(name), place.join(name)).unwrap();
    }
    let before = state(&half);
    assert_eq!(compared("half"), whole);
    assert_eq!(state(&half), before);
}

#[test]
fn a_folder_in_the_place_of_a_file_costs_nothing_that_is_there() {
    let here = tempfile::tempdir().unwrap();
    assert!(
        run_in(here.path(), &["synth", "--no-png", "--out", "R"])
            .status
            .success()
    );
    let result = here.path().join("R");
    fs::remove_file(result.join("profile.csv")).unwrap();
    fs::create_dir(result.join("profile.csv")).unwrap();
    let before = state(&result);
    let output = run_in(
        here.path(),
        &[
            "synth",
            "--no-png",
            "--set",
            "limits.stroke=70 mm",
            "--out",
            "R",
        ],
    );
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(
        stderr(&output).contains("profile.csv: this file has the name of a gaitcam file"),
        "{}",
        stderr(&output)
    );
    assert_eq!(state(&result), before);
}

/// Process that is killed when this value is dropped.
struct Ended(Child);

impl Drop for Ended {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn signal(child: &Child, name: &str) {
    let id = child.id().to_string();
    assert!(
        Command::new("kill")
            .args([name, &id])
            .status()
            .unwrap()
            .success()
    );
}

#[test]
fn a_folder_that_a_stopped_process_holds_is_given_up_within_the_time_limit() {
    let here = tempfile::tempdir().unwrap();
    let lock = here.path().join("R/.gaitcam.lock");
    // It waits for its scene with the folder locked: the recording is read after it, from a pipe that stays open.
    fs::write(
        here.path().join("piped.toml"),
        "[gait]\nfile = \"/dev/stdin\"\nperiod = \"1 s\"\n[drive]\nkind = \"moving-axis\"\n",
    )
    .unwrap();
    let mut first = command(here.path());
    first
        .args(["synth", "piped.toml", "--out", "R"])
        .stdin(Stdio::piped());
    let first = Ended(first.stderr(Stdio::null()).spawn().unwrap());
    let begun = Instant::now();
    while fs::read(&lock).is_ok_and(|text| text.is_empty()) || !lock.exists() {
        assert!(begun.elapsed() < Duration::from_secs(20));
        std::thread::sleep(Duration::from_millis(10));
    }
    signal(&first.0, "-STOP");
    let begun = Instant::now();
    let output = run_in(
        here.path(),
        &["synth", "--no-png", "--out", "R", "--time-limit", "2"],
    );
    let took = begun.elapsed().as_secs_f64();
    assert_eq!(output.status.code(), Some(2));
    let words = stderr(&output);
    assert!(
        words.contains(&format!("process ({})", first.0.id())) && words.contains("--out"),
        "{words}"
    );
    assert!((2.0..3.2).contains(&took), "{took} s");
    // Once it is gone the folder is free.
    drop(first);
    assert!(
        run_in(here.path(), &["synth", "--no-png", "--out", "R"])
            .status
            .success()
    );
}

#[test]
fn a_pipe_in_the_place_of_a_file_is_refused_at_once() {
    let here = tempfile::tempdir().unwrap();
    let lock = "this file has the name of a gaitcam file";
    let table = "is a pipe or a device";
    let sweep = "sweep --vary law.family=spline,harmonic --out t.csv";
    for (pipe, arguments, said) in [
        ("R/.gaitcam.lock", "synth --no-png --out R", lock),
        ("t.csv.partial/.lock", sweep, lock),
        ("table/table.csv", "front table/table.csv", table),
        ("R2/summary.json", "compare R2 R2", table),
        ("R2/summary.json", "inspect R2 R2/summary.json", table),
    ] {
        let pipe = here.path().join(pipe);
        let _ = fs::create_dir(pipe.parent().unwrap());
        let _ = fs::remove_file(&pipe);
        assert!(
            Command::new("mkfifo")
                .arg(&pipe)
                .status()
                .unwrap()
                .success()
        );
        let begun = Instant::now();
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let output = run_in(here.path(), &arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).contains(said), "{}", stderr(&output));
        assert!(begun.elapsed() < Duration::from_secs(5));
    }
}

#[test]
fn an_input_that_does_not_end_is_given_up_within_the_time_limit() {
    let here = tempfile::tempdir().unwrap();
    fs::write(
        here.path().join("piped.toml"),
        "[gait]\nfile = \"/dev/stdin\"\nperiod = \"1 s\"\n",
    )
    .unwrap();
    for scene in ["-", "piped.toml"] {
        let mut child = command(here.path());
        child.args(["synth", scene, "--json", "--time-limit", "1"]);
        child
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let begun = Instant::now();
        let mut child = Ended(child.spawn().unwrap());
        let mut answer = String::new();
        let out = child.0.stdout.as_mut().unwrap();
        out.read_to_string(&mut answer).unwrap();
        assert_eq!(child.0.wait().unwrap().code(), Some(2));
        assert!(begun.elapsed().as_secs_f64() < 2.1, "{:?}", begun.elapsed());
        assert!(answer.contains("cli-input-time"), "{answer}");
    }
}

#[test]
fn a_million_columns_are_read_or_refused_in_seconds() {
    let here = tempfile::tempdir().unwrap();
    let file = here.path().join("wide.csv");
    for (name, separator) in [("c", ","), ("fz", ","), ("Force [N]", ";"), ("", "\t")] {
        let row = |cell: &str| format!("0.1{}\n", format!("{separator}{cell}").repeat(1_000_000));
        let header = row(name).replace("0.1", "time");
        let header = if name.is_empty() { "" } else { &header };
        fs::write(
            &file,
            [header, &row("1.5"), &row("1.6"), &row("1.7")].concat(),
        )
        .unwrap();
        let begun = Instant::now();
        let output = run_in(here.path(), &["gait", "wide.csv"]);
        // Other work may share the machine: a second alone.
        assert!(
            begun.elapsed() < Duration::from_secs(20),
            "{name}: {:?}",
            begun.elapsed()
        );
        assert_eq!(output.status.code(), Some(2), "{name}");
        println!("{name:?}: {:?}", begun.elapsed());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_input_takes_a_bounded_memory_and_time() {
    let here = tempfile::tempdir().unwrap();
    let scene = "[gait]\nfile = \"/dev/stdin\"\n";
    fs::write(here.path().join("s.toml"), scene).unwrap();
    for arguments in [
        vec!["gait", "/dev/stdin"],
        vec!["synth", "s.toml", "--json"],
        vec!["synth", "-", "--json"],
        vec!["inspect", "s.toml", "/dev/stdin", "--json"],
    ] {
        let begun = Instant::now();
        let zero = fs::File::open("/dev/zero").unwrap();
        let mut limited = Command::new("prlimit");
        limited.args(["--as=2147483648", env!("CARGO_BIN_EXE_gaitcam")]);
        let output = limited
            .args(&arguments)
            .current_dir(here.path())
            .stdin(zero)
            .output()
            .unwrap();
        assert_eq!(
            output.status.code(),
            Some(2),
            "{arguments:?}: {}",
            stderr(&output)
        );
        assert!(stderr(&output).contains("MiB"), "{}", stderr(&output));
        assert!(begun.elapsed() < Duration::from_secs(10));
    }
}
