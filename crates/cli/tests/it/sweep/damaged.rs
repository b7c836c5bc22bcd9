//! Damage to the files of an interrupted sweep never reaches its table.

use std::fs;
use std::path::{Path, PathBuf};

use super::{rows, start, sweep};
use crate::support::{run_in, stderr};

/// Next number below `most` of a fixed sequence (Knuth's linear congruential generator).
fn next(seed: &mut u64, most: usize) -> usize {
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) as usize % most
}

/// Number of random damages. Each of the eight kinds is among them.
const CASES: usize = 32;

const QUICK: [&str; 4] = [
    "--set",
    "law.family=harmonic",
    "--vary",
    "gait.body_weight=400 N:1000 N:5000",
];

fn copy(from: &Path, to: &Path) {
    let _ = fs::remove_dir_all(to);
    fs::create_dir(to).unwrap();
    for entry in fs::read_dir(from).unwrap().flatten() {
        fs::copy(entry.path(), to.join(entry.file_name())).unwrap();
    }
}

/// Damages the blocks: changes a digit, a letter or any byte, truncates, repeats or removes a line, exchanges two blocks or renames one.
fn damage(blocks: &[PathBuf], seed: &mut u64) {
    let path = &blocks[next(seed, blocks.len())];
    let mut bytes = fs::read(path).unwrap();
    let at = next(seed, bytes.len());
    match next(seed, 8) {
        0 => bytes[at] = b'0' + next(seed, 10) as u8,
        1 => bytes[at] ^= 1 << next(seed, 8),
        2 => bytes.truncate(at),
        3 => {
            let mut lines: Vec<&[u8]> = bytes.split_inclusive(|b| *b == b'\n').collect();
            lines.remove(next(seed, lines.len()));
            bytes = lines.concat();
        }
        4 => {
            let lines: Vec<&[u8]> = bytes.split_inclusive(|b| *b == b'\n').collect();
            let line = lines[next(seed, lines.len())];
            bytes = [&bytes[..], line].concat();
        }
        5 => {
            let other = &blocks[next(seed, blocks.len())];
            bytes = fs::read(other).unwrap();
        }
        6 => drop(bytes.splice(at..at, *b"77")),
        _ => {
            let name = path
                .file_name()
                .unwrap()
                .to_string_lossy()
                .replace("000000000", "000000001");
            fs::rename(path, path.with_file_name(name)).unwrap();
            return;
        }
    }
    fs::write(path, bytes).unwrap();
}

#[test]
fn random_damages_all_end_with_the_right_table() {
    let folder = tempfile::tempdir().unwrap();
    let (calm, out) = (folder.path().join("calm.csv"), folder.path().join("t.csv"));
    assert!(sweep(&calm, &QUICK).status.success());
    let (journal, kept) = (
        folder.path().join("t.csv.partial"),
        folder.path().join("kept"),
    );
    // Until a run is killed after some blocks and before its end.
    let blocks = |folder: &Path| -> Vec<PathBuf> {
        let all = fs::read_dir(folder).into_iter().flatten().flatten();
        let mut blocks: Vec<PathBuf> = (all.map(|e| e.path()))
            .filter(|p| p.extension().is_some_and(|e| e == "csv"))
            .collect();
        blocks.sort();
        blocks
    };
    for _ in 0..100 {
        let _ = fs::remove_dir_all(&journal);
        let _ = fs::remove_file(&out);
        let mut child = start(&out, &QUICK);
        while blocks(&journal).len() < 3 && child.try_wait().unwrap().is_none() {
            std::thread::sleep(std::time::Duration::from_micros(200));
        }
        let _ = child.kill();
        child.wait().unwrap();
        if blocks(&journal).len() >= 3 && !out.exists() {
            break;
        }
    }
    copy(&journal, &kept);
    assert!(blocks(&kept).len() >= 3);
    let (mut seed, expected) = (7, rows(&calm));
    for case in 0..CASES {
        copy(&kept, &journal);
        let _ = fs::remove_file(&out);
        damage(&blocks(&journal), &mut seed);
        let output = sweep(&out, &[&QUICK[..], &["--resume"]].concat());
        assert_eq!(output.status.code(), Some(0), "{case}: {}", stderr(&output));
        assert!(rows(&out) == expected, "case {case}");
    }
}

#[test]
fn a_finished_table_that_was_changed_is_not_believed() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let arguments = [
        "sweep",
        "--vary",
        "limits.stroke=50 mm:60 mm:20",
        "--out",
        "t.csv",
        "--resume",
    ];
    let run = || run_in(at, &arguments).status.code();
    assert_eq!([run(), run()], [Some(0), Some(0)]);
    let whole = fs::read(at.join("t.csv")).unwrap();
    let mut swapped = whole.clone();
    let digit = whole.iter().rposition(u8::is_ascii_digit).unwrap();
    swapped[digit] ^= 1;
    for damaged in [&whole[..0], &whole[..whole.len() / 2], &swapped] {
        fs::write(at.join("t.csv"), damaged).unwrap();
        assert_eq!(run(), Some(2));
        assert_eq!(fs::read(at.join("t.csv")).unwrap(), damaged);
    }
    fs::write(at.join("t.csv"), &whole).unwrap();
    assert_eq!(run(), Some(0));
}
