//! A sweep that is killed, stopped or started twice loses no row and mixes none.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use super::{SLOW, rows, start, sweep};
use crate::support::{stderr, stdout};

/// Pseudo-random numbers seeded by the process id.
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

/// Kills a sweep at random moments and resumes it until it finishes. Returns the number of kills.
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
            for ending in ["", ".sweep.json"] {
                let _ = fs::remove_file(PathBuf::from(format!("{}{ending}", out.display())));
            }
            let _ = fs::remove_dir_all(journal(out));
        } else {
            done += 1;
        }
    }
    let last = sweep(out, &resume);
    assert_eq!(last.status.code(), Some(0), "{}", stderr(&last));
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
            assert!(!journal(&killed).exists());
        }
        if kills >= 20 {
            break;
        }
    }
    println!("{kills} kills met a running sweep");
    assert!(kills >= 20, "{kills}");
}

/// Folder of the unfinished table of a sweep.
fn journal(out: &Path) -> PathBuf {
    PathBuf::from(format!("{}.partial", out.display()))
}

/// Files of a folder with their content, without the lock file.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|e| e.path()).filter(|p| !p.ends_with(".lock"));
    paths
        .filter_map(|p| Some((p.clone(), fs::read(p).ok()?)))
        .collect()
}

/// Blocks of the unfinished table, in order.
fn blocks(journal: &Path) -> Vec<PathBuf> {
    let is_block = |p: &PathBuf| p.extension().is_some_and(|e| e == "csv");
    files(journal).into_keys().filter(is_block).collect()
}

/// Waits until a running sweep has written `count` blocks.
fn wait_for_blocks(journal: &Path, count: usize) {
    for _ in 0..2000 {
        if blocks(journal).len() >= count {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Folder that a killed sweep leaves behind.
fn interrupted(out: &Path, arguments: &[&str]) -> PathBuf {
    let journal = journal(out);
    let mut child = start(out, arguments);
    wait_for_blocks(&journal, 2);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(blocks(&journal).len() >= 2 && !out.exists());
    journal
}

#[test]
fn a_truncated_block_is_computed_again() {
    let folder = tempfile::tempdir().unwrap();
    let (calm, out) = (folder.path().join("calm.csv"), folder.path().join("t.csv"));
    sweep(&calm, &SLOW);
    let journal = interrupted(&out, &SLOW);
    let last = blocks(&journal).pop().unwrap();
    let bytes = fs::read(&last).unwrap();
    fs::write(&last, &bytes[..bytes.len() - 100]).unwrap();
    let output = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(
        stderr(&output).contains("is damaged"),
        "{}",
        stderr(&output)
    );
    assert_eq!(rows(&calm), rows(&out));
    // A finished sweep resumed is finished.
    let again = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert_eq!(again.status.code(), Some(0));
    assert!(stdout(&again).contains("already complete"));
}

#[test]
fn a_stopped_sweep_is_neither_overwritten_nor_mixed_with_another() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let journal = interrupted(&out, &SLOW);
    let before = files(&journal);
    let output = sweep(&out, &SLOW);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("--resume"), "{}", stderr(&output));
    let mut other = [&SLOW[..], &["--resume"]].concat();
    other[3] = "limits.stroke=35 mm:61 mm:12";
    let output = sweep(&out, &other);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        stderr(&output).contains("limits.stroke: 0.035 m:0.06 m:12 before, 0.035 m:0.061 m:12 now"),
        "{}",
        stderr(&output)
    );
    let output = sweep(
        &out,
        &[&SLOW[..], &["--resume", "--set", "cam.bore=14 mm"]].concat(),
    );
    assert!(
        stderr(&output).contains("only this run contains \"bore = \"14 mm\"\""),
        "{}",
        stderr(&output)
    );
    assert!(files(&journal) == before, "the journal was touched");
}

#[test]
fn two_processes_on_one_table_refuse_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let mut first = start(&out, &SLOW);
    wait_for_blocks(&journal(&out), 1);
    let second = sweep(&out, &[&SLOW[..], &["--resume"]].concat());
    assert_eq!(second.status.code(), Some(2), "{}", stderr(&second));
    assert!(
        stderr(&second).contains("another gaitcam"),
        "{}",
        stderr(&second)
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
    wait_for_blocks(&journal(&out), 2);
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
    assert!(
        !stderr(&output).contains("is damaged"),
        "{}",
        stderr(&output)
    );
    assert_eq!(rows(&calm), rows(&out));
}
