//! Damaged files: for any bytes, a reader returns a result or an error quickly, and never panics.
//!
//! The corpus is that of the cargo-fuzz targets in fuzz/, which need a nightly compiler. The damage is reproducible. GAITCAM_FUZZ_ROUNDS extends the
//! test.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use gaitcam_gait::{
    Feet, ForceUnit, Interpretation, ReadOptions, cycle, force_curve, read, stances,
};

/// Applies all readers of a file. Returns whether it is read as a recording or a cycle.
fn exercise(bytes: &[u8], options: &ReadOptions) -> bool {
    let path = Path::new("fuzz");
    let curve = force_curve(path, bytes, options, Feet::Both);
    let recording = read(path, bytes, options);
    let is_read = curve.is_ok() || recording.is_ok();
    if let Ok(r) = recording {
        let s = stances(&r);
        for feet in [Feet::Both, Feet::One, Feet::Left] {
            let c = cycle(&r, &s, feet);
            let understood = Interpretation::of("x", &r, &s, c.as_ref().ok(), feet);
            assert!(understood.json()["contacts"].is_array());
            if let Ok(c) = c {
                assert!(c.curve.force_n.iter().all(|f| f.is_finite()));
            }
        }
    }
    is_read
}

/// Xorshift generator, which produces the same damage in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % below.max(1)
    }
}

/// Words that have a meaning for readers.
const WORDS: &[&[u8]] = &[
    b"nan",
    b"inf",
    b"-1e308",
    b"1e-320",
    b"99999999999999999999",
    b"\n",
    b"\r\n",
    b"\t",
    b";",
    b",",
    b"#",
    b"\"",
    b"00:01,5",
    b"time",
    b"force_n",
    b"Fz",
    b"endheader",
    b"nRows=99999999",
    b"# cycle, period_s = 1e-9\n",
    b"# critical points\n",
    b"\0",
    b"\xFF\xFE",
    b"\xFF\xFF\xFF\xFF",
    b"\xFF\x7F",
    b"\x00\x80",
    b"Devices\n1000\n",
    b"F_V_RAW_1",
    b" ",
];

fn damage(dice: &mut Dice, corpus: &[Vec<u8>]) -> Vec<u8> {
    let mut b = corpus[dice.roll(corpus.len())].clone();
    for _ in 0..=dice.roll(6) {
        let at = dice.roll(b.len() + 1);
        let end = (at + 1 + dice.roll(64)).min(b.len());
        match dice.roll(8) {
            0 if at < b.len() => b[at] ^= 1 << dice.roll(8),
            1 if at < b.len() => b[at] = dice.roll(256) as u8,
            2 => b.truncate(at),
            3 if at < end => drop(b.drain(at..end)),
            4 if at < end => {
                let piece = b[at..end].to_vec();
                let times = 1 + dice.roll(8);
                b.splice(at..at, piece.repeat(times));
            }
            5 => drop(b.splice(at..at, WORDS[dice.roll(WORDS.len())].iter().copied())),
            6 if at < end => drop(b.splice(at..end, WORDS[dice.roll(WORDS.len())].iter().copied())),
            7 => {
                let other = &corpus[dice.roll(corpus.len())];
                let from = dice.roll(other.len() + 1);
                b.truncate(at);
                b.extend(&other[from..]);
            }
            _ => (),
        }
    }
    b
}

fn folder(reader: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("fuzz/corpus")
        .join(reader)
}

/// The present case and the time of its start.
type Case = Arc<Mutex<(Vec<u8>, Instant)>>;

/// Ends the test if one case takes longer than ten seconds, and stores the case in a file.
fn watch(reader: &str) -> Case {
    let case: Case = Arc::new(Mutex::new((Vec::new(), Instant::now())));
    let (watched, reader) = (Arc::downgrade(&case), reader.to_string());
    std::thread::spawn(move || {
        while let Some(case) = watched.upgrade() {
            let at = case.lock().unwrap();
            if at.1.elapsed() > Duration::from_secs(10) {
                let file = std::env::temp_dir().join(format!("gaitcam_fuzz_{reader}_hang.bin"));
                std::fs::write(&file, &at.0).unwrap();
                eprintln!("{reader}: a case hangs ({})", file.display());
                std::process::exit(101);
            }
            drop(at);
            drop(case);
            std::thread::sleep(Duration::from_millis(200));
        }
    });
    case
}

/// Options that lead through all branches of the readers.
fn options() -> [ReadOptions; 5] {
    [
        ReadOptions::default(),
        ReadOptions {
            rate_hz: Some(100.0),
            mass_kg: Some(70.0),
            ..ReadOptions::default()
        },
        ReadOptions {
            force: vec!["1".to_string(), "2".to_string(), "2".to_string()],
            ..ReadOptions::default()
        },
        ReadOptions {
            time: Some("2".to_string()),
            unit: Some(ForceUnit::PercentBodyWeight),
            mass_kg: Some(70.0),
            ..ReadOptions::default()
        },
        ReadOptions {
            force: vec!["2".to_string()],
            ..ReadOptions::default()
        },
    ]
}

fn run(reader: &str) {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder(reader))
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    files.sort();
    assert!(!files.is_empty(), "no corpus for {reader}");
    let corpus: Vec<Vec<u8>> = files.iter().map(|f| std::fs::read(f).unwrap()).collect();
    let rounds = std::env::var("GAITCAM_FUZZ_ROUNDS")
        .ok()
        .and_then(|s| s.parse().ok())
        .unwrap_or(2000u64);
    let seed = std::env::var("GAITCAM_FUZZ_SEED")
        .ok()
        .and_then(|s| s.parse().ok())
        .unwrap_or(1u64);
    let options = options();
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ (seed << 1));
    for (file, bytes) in files.iter().zip(&corpus) {
        assert!(!bytes.is_empty(), "{}", file.display());
        exercise(bytes, &options[0]);
    }
    let mut readable = 0;
    let case = watch(reader);
    for round in 0..rounds {
        let bytes = damage(&mut dice, &corpus);
        let options = &options[dice.roll(options.len())];
        let started = Instant::now();
        *case.lock().unwrap() = (bytes.clone(), started);
        let answer = std::panic::catch_unwind(|| exercise(&bytes, options));
        let slow = started.elapsed() > Duration::from_secs(2);
        if answer.is_err() || slow {
            let case = std::env::temp_dir().join(format!("gaitcam_fuzz_{reader}_{round}.bin"));
            std::fs::write(&case, &bytes).unwrap();
            panic!(
                "{reader} round {round}: {} ({})",
                if slow { "too slow" } else { "panicked" },
                case.display()
            );
        }
        readable += u64::from(answer.is_ok_and(|is_read| is_read));
    }
    // Damage that no file survives would test only the refusal.
    assert!(
        10 * readable > rounds,
        "{reader}: {readable} of {rounds} read"
    );
}

#[test]
fn damaged_texts_are_answered() {
    run("text");
}

#[test]
fn damaged_c3d_files_are_answered() {
    run("c3d");
}

#[test]
fn damaged_cycles_are_answered() {
    run("cycle");
}
