//! A row of a sweep equals the design of its scene.

use gaitcam::halt::Halt;
use gaitcam::scene::keys::{KEYS, Key};
use gaitcam::scene::{self, Gait, SCENES};
use gaitcam::sweep::{
    Files, NUMBERS, Outcome, Plan, Records, Row, Sampling, Subject, Sweep, WORDS,
};
use gaitcam::synth::synthesise;
use toml::Table;

use crate::scene::random::{Numbers, grow, typed};

/// Maximum difference between rows and single designs, relative to the value or the mean force. A sweep scales the force of a walker of 1 N, and the
/// solver propagates this rounding.
const SAME: f64 = 1e-6;

/// Random scene after several changes, with the last change.
struct Drawn {
    table: Table,
    last: String,
}

/// Built-in scene without a recording, with up to four changed keys from the whole table, so that it is still valid. Half of the scenes have harmonic
/// laws.
fn drawn(numbers: &mut Numbers) -> Option<Drawn> {
    let own = SCENES.iter().filter(|s| !s.toml.contains("file ="));
    let own: Vec<_> = own.collect();
    let base = own[numbers.below(own.len())];
    let harmonic = numbers.below(2) == 0;
    let text = if harmonic { scene::DEFAULT } else { base.toml };
    let mut table: Table = text.parse().unwrap();
    if harmonic {
        scene::set(&mut table, "law.family=harmonic").unwrap();
        scene::set(&mut table, "limits.stroke=1 m").unwrap();
    }
    let mut last = None;
    for _ in 0..1 + numbers.below(4) {
        let key = &KEYS[numbers.below(KEYS.len())];
        if let Some((changed, change)) = changed(&table, key, numbers) {
            (table, last) = (changed, Some(change));
        }
    }
    last.map(|last| Drawn { table, last })
}

/// Scene with a random value of a key, and this change; `None` if the result is not a valid scene.
fn changed(table: &Table, key: &Key, numbers: &mut Numbers) -> Option<(Table, String)> {
    let read = scene::read(table).ok()?;
    let text = typed(key, &read, numbers).filter(|_| key.exists(&read))?;
    let mut out = table.clone();
    if let Some(list) = key.list() {
        grow(&mut out, list, 0);
    }
    let change = format!("{}={text}", key.path_at(0));
    scene::set(&mut out, &change).ok()?;
    let read = scene::read(&out).ok()?;
    // There is no file to read.
    let is_recording = read.gait.as_ref().is_some_and(Gait::is_recording);
    (!is_recording).then_some((out, change))
}

/// Row of a sweep over the single value of the last change, or over no value if its text is a list.
fn swept(drawn: &Drawn) -> Records {
    let is_one = !drawn.last.contains([',', ':']);
    let sweep = |vary: &[&str]| {
        let plan = Plan::of(drawn.table.clone(), vary, Sampling::Grid)?;
        Sweep::with_files(Subject::Designs(plan), Files::new())
    };
    let varied = is_one.then(|| sweep(&[&drawn.last]).ok()).flatten();
    let sweep = varied.unwrap_or_else(|| sweep(&[]).unwrap());
    let runner = sweep.runner(&Halt::never, None).unwrap();
    runner.run(0..1, 1, &|| false)
}

/// Row of the single design of the scene.
fn single(drawn: &Drawn) -> Row {
    let scene = scene::read(&drawn.table).unwrap();
    let force = scene.model_force();
    match force.and_then(|force| synthesise(&scene, force.as_ref())) {
        Ok(design) => Row::of(&design),
        Err(e) if e.is_answer() => Row {
            outcome: Outcome::Infeasible,
            verdict: Some(gaitcam::cam::Verdict::Unacceptable),
            ..Row::error(e.to_string())
        },
        Err(e) => Row::error(e.to_string()),
    }
}

fn compare(drawn: &Drawn, swept: &Records, single: &Row) {
    for (name, word) in WORDS.iter().zip(single.words()) {
        let own = swept.words(name).and_then(|w| w.at(0)).unwrap_or("");
        assert_eq!(own, word, "{name} after {}\n{}", drawn.last, drawn.table);
    }
    let mean = NUMBERS.iter().position(|n| *n == "target_mean_n").unwrap();
    for (name, &number) in NUMBERS.iter().zip(&single.numbers) {
        let own = swept.numbers(name).unwrap()[0];
        if own.is_nan() && number.is_nan() {
            continue;
        }
        let size = match name.starts_with("force_") {
            true if name.ends_with("percent") => 100.0,
            true => number.abs().max(single.numbers[mean].abs()),
            false => number.abs(),
        };
        let apart = (own - number).abs();
        let what = || {
            format!(
                "{name}: {own} for {number} after {}\n{}",
                drawn.last, drawn.table
            )
        };
        assert!(apart <= SAME * size || own == number, "{}", what());
    }
}

/// Compares `count` random scenes.
fn rows_are_single_designs(count: usize) {
    let (mut built, mut spectral, mut met) = (0, 0, vec![false; KEYS.len()]);
    let mut numbers = Numbers(11);
    let mut scenes = 0;
    while scenes < count {
        let Some(drawn) = drawn(&mut numbers) else {
            continue;
        };
        scenes += 1;
        let path = drawn.last.split('=').next().unwrap_or_default();
        let key = KEYS.iter().position(|key| key.index_in(path).is_some());
        met[key.unwrap()] = true;
        let single = single(&drawn);
        compare(&drawn, &swept(&drawn), &single);
        built += usize::from(single.outcome == Outcome::Built);
        spectral += usize::from(single.tier.is_some_and(|tier| tier.name() == "spectral"));
    }
    let keys = met.iter().filter(|met| **met).count();
    println!("{scenes} scenes: {built} built, {spectral} of them in closed form, {keys} keys last");
    assert!(
        2 * built > count,
        "only {built} of {count} scenes are built"
    );
    assert!(
        10 * spectral > count,
        "only {spectral} of {count} are spectral"
    );
}

#[test]
fn rows_of_a_hundred_random_scenes_equal_single_designs() {
    rows_are_single_designs(100);
}

#[test]
#[ignore = "minutes"]
fn rows_of_two_thousand_random_scenes_equal_single_designs() {
    rows_are_single_designs(2000);
}

/// A force of the machine outside the drive was once missing in rows of the closed form.
#[test]
fn a_learned_force_counts_in_rows() {
    let mut table: Table = scene::DEFAULT.parse().unwrap();
    for change in [
        "law.family=harmonic",
        "machine.learned_force=[\"0 N\", \"60 N\", \"20 N at 90 deg\"]",
    ] {
        scene::set(&mut table, change).unwrap();
    }
    let last = "gait.body_weight=700 N".to_string();
    let drawn = Drawn { table, last };
    let single = single(&drawn);
    assert_eq!(single.outcome, Outcome::Built);
    compare(&drawn, &swept(&drawn), &single);
}
