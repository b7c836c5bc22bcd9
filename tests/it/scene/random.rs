//! Random admissible scenes, generated from the key table only.

use gaitcam::scene::keys::{KEYS, Key, Kind, Range};
use gaitcam::scene::{self, Scene};
use toml::Table;

/// Deterministic random numbers, so that a failure can be repeated.
pub struct Numbers(pub u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// Number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Integer from 0 to n − 1.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}

/// Random value of a key as a user might type it; `None` if no random text is meaningful.
pub fn typed(key: &Key, scene: &Scene, numbers: &mut Numbers) -> Option<String> {
    let number = |numbers: &mut Numbers| {
        let (low, high) = match key.range {
            Range::Any => (-2.0, 2.0),
            Range::Between(low, high) => (low, high),
            Range::Acute => (0.01, 1.5),
            _ => (1e-3, 2.0),
        };
        let x = low + numbers.unit() * (high - low);
        Some(format!("{x} {}", key.dimension(scene)?.si()))
    };
    match key.kind {
        Kind::Number(_) => number(numbers),
        Kind::NumberOr(_, word) if numbers.below(3) == 0 => Some(word.to_string()),
        Kind::NumberOr(..) => number(numbers),
        Kind::NumberOrSeveral(_) if numbers.below(3) == 0 => Some("1.4 Hz:2.4 Hz:11".to_string()),
        Kind::NumberOrSeveral(_) => number(numbers),
        Kind::Count(low, high) => Some((low + numbers.below(high - low + 1)).to_string()),
        Kind::Choice(words) => {
            let words = words();
            Some(words[numbers.below(words.len())].to_string())
        }
        Kind::Flag => Some((numbers.below(2) == 0).to_string()),
        Kind::Text if key.name() == "motion" => Some("cycloidal".to_string()),
        Kind::Text if key.name() == "curve" => Some("0 20 10 5".to_string()),
        Kind::Text if key.name() == "accept" => Some("clock, mass".to_string()),
        Kind::Text if key.name() == "hardness" => Some(format!("{} HRC", 20 + numbers.below(45))),
        Kind::Text if key.name() == "robust" => Some(format!("cvar 0.{}", numbers.below(10))),
        Kind::Texts if key.name() == "adjust" => Some("mass, phase".to_string()),
        Kind::Texts if key.name() == "harmonics" => {
            let factor = numbers.unit() + 0.01;
            Some(format!("{factor}, 0.1 at {} deg", numbers.below(360)))
        }
        Kind::Texts if key.name() == "learned_force" => Some(format!("{} N", numbers.below(9))),
        Kind::Text | Kind::Texts => Some(format!("word{}", numbers.below(9))),
        _ => None,
    }
}

/// Table of random values, including entries of lists.
pub fn table(numbers: &mut Numbers) -> Table {
    let mut table = Table::new();
    let mut scene = Scene::default();
    let with_force = numbers.below(2) == 0;
    let chance = [0.05, 0.2, 0.6][numbers.below(3)];
    let lists = [
        "gait.weight",
        "law.point",
        "law.dwell",
        "law.segment",
        "machine.floor.mode",
    ];
    let lists = lists.map(|l| (l, numbers.below(6).saturating_sub(2)));
    for key in KEYS.iter() {
        if key.section() == "gait" && !with_force {
            continue;
        }
        let deciding = ["cam.follower", "drive.kind", "law.family", "gait.model"];
        let count = match key.list() {
            Some(list) => lists.iter().find(|l| l.0 == list).map_or(0, |l| l.1),
            None => 1,
        };
        for index in 0..count {
            let wanted =
                deciding.contains(&key.path) || key.is_required(&scene) || numbers.unit() < chance;
            if !wanted || !key.exists(&scene) {
                continue;
            }
            let Some(text) = typed(key, &scene, numbers) else {
                continue;
            };
            if let Some(list) = key.list() {
                grow(&mut table, list, index);
            }
            let change = format!("{}={text}", key.path_at(index));
            scene::set(&mut table, &change).unwrap_or_else(|e| panic!("{change}: {e}"));
        }
        // Later keys depend on follower and drive.
        if deciding.contains(&key.path)
            && let Some(value) = lookup(&table, key.path)
        {
            let text = gaitcam::scene::keys::Value::Text(value);
            key.set(&mut scene, 0, text).unwrap();
        }
    }
    complete_motor(&mut table);
    complete_floor(&mut table);
    table
}

/// Reduces a motor to one torque line and sets the inertia of its shaft.
fn complete_motor(table: &mut Table) {
    let Some(machine) = table.get_mut("machine").and_then(|m| m.as_table_mut()) else {
        return;
    };
    let Some(motor) = machine.get_mut("motor").and_then(|m| m.as_table_mut()) else {
        return;
    };
    let lines = ["rated_torque", "slope", "stall_torque", "curve"];
    let kept = lines.into_iter().find(|line| motor.contains_key(*line));
    let is_other = |key: &str| lines.contains(&key) && Some(key) != kept;
    motor.retain(|key, _| !is_other(key));
    if kept != Some("stall_torque") {
        motor.remove("no_load_speed");
    }
    for key in ["rated_speed", "synchronous_speed"] {
        motor.remove(key);
    }
    if kept == Some("rated_torque") {
        motor.insert("rated_speed".into(), toml::Value::String("1395 rpm".into()));
    }
    let inertia = || toml::Value::String("0.5 kg m^2".to_string());
    machine.entry("inertia").or_insert_with(inertia);
}

/// Reduces a floor to its listed modes or to one complete mode, and removes motor and flexible follower. Phases are random, weights equal.
fn complete_floor(table: &mut Table) {
    let Some(machine) = table.get_mut("machine").and_then(|m| m.as_table_mut()) else {
        return;
    };
    if let Some(walkers) = machine.get_mut("walkers").and_then(|w| w.as_table_mut()) {
        walkers.retain(|key, _| key == "count");
    }
    let rivals = ["motor", "natural_frequency", "stiffness"];
    if rivals.iter().any(|rival| machine.contains_key(*rival)) {
        machine.remove("floor");
    }
    let Some(floor) = machine.get_mut("floor").and_then(|f| f.as_table_mut()) else {
        return;
    };
    if floor.contains_key("mode") {
        floor.retain(|key, _| key == "mode");
        return;
    }
    for (key, usual) in [
        ("mass", "5000 kg"),
        ("frequency", "2 Hz"),
        ("damping", "0.01"),
    ] {
        let usual = || toml::Value::String(usual.to_string());
        floor.entry(key).or_insert_with(usual);
    }
}

fn lookup(table: &Table, path: &str) -> Option<String> {
    let (section, name) = path.split_once('.')?;
    Some(table.get(section)?.get(name)?.as_str()?.to_string())
}

/// Extends a list of the table to at least `index + 1` entries.
pub fn grow(table: &mut Table, list: &str, index: usize) {
    let empty = || toml::Value::Table(Table::new());
    let (sections, name) = list.rsplit_once('.').unwrap();
    let section = sections.split('.').fold(table, |at, section| {
        let inner = at.entry(section).or_insert_with(empty);
        inner.as_table_mut().unwrap()
    });
    let entries = section
        .entry(name)
        .or_insert_with(|| toml::Value::Array(Vec::new()));
    let entries = entries.as_array_mut().unwrap();
    while entries.len() <= index {
        entries.push(empty());
    }
}
