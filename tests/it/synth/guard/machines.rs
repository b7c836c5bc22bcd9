//! Random machines with their target force, and the random numbers for them.

use super::asked::{Asked, Follower, Limits, Objective};
use super::scenes::Kind;
use gaitcam::force::{Feet, ForceCurve, catalogue, model};
use std::f64::consts::{PI, TAU};

/// Numbers of spans for the random choice; a repeated number is more likely.
const SPANS: [usize; 9] = [8, 9, 10, 12, 14, 16, 20, 24, 32];
/// Numbers of spans for scenes with few or many spans.
const LONG: [usize; 9] = [4, 5, 6, 40, 64, 80, 100, 150, 200];

/// Random numbers by SplitMix64, with the numbers of spans for the choice.
pub struct Random(u64, [usize; 9]);

impl Random {
    pub fn new(kind: Kind, seed: usize) -> Self {
        let spans = if kind == Kind::Long { LONG } else { SPANS };
        Random((kind as u64) << 32 | seed as u64, spans)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Number in [0, 1).
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    pub fn chance(&mut self, part: f64) -> bool {
        self.unit() < part
    }

    pub fn maybe<T>(&mut self, part: f64, value: T) -> Option<T> {
        self.chance(part).then_some(value)
    }
}

pub fn bare(r: &mut Random) -> Asked {
    Asked {
        degree: 3 + r.below(5),
        spans: r.1[r.below(9)],
        weights: [0.0; 3],
        rest: 0.0,
        speed: 1.0,
        target: None,
        objective: Objective::ForceError,
        follower: Follower::Flat { base: None },
        points: Vec::new(),
        dwells: Vec::new(),
        limits: Limits::default(),
        ranges: Vec::new(),
        band: None,
        train: None,
        machine: String::new(),
    }
}

/// Load model with its table `[gait]`.
fn force(r: &mut Random) -> (ForceCurve, String) {
    let info = &catalogue()[r.below(catalogue().len())];
    let (low, high) = info.frequency_hz;
    let frequency = r.within(low.max(1.2), high.min(2.4));
    let curve = model(info.name, Some(frequency), 700.0, Feet::Both).expect("a known model");
    let name = info.name;
    let text = format!(
        "[gait]\nmodel = \"{name}\"\nstep_frequency = \"{frequency} Hz\"\nbody_weight = \"700 N\"\nfeet = \"both\"\n"
    );
    (curve, text)
}

pub fn moving(r: &mut Random) -> Asked {
    let (curve, mut machine) = force(r);
    let speed = TAU / curve.period_s;
    let own = curve.mean_n() / 9.81;
    let (mass, target) = if r.chance(0.3) {
        let mass = r.within(0.5, 20.0);
        machine += &format!(
            "scale = \"to-mass\"\n[drive]\nkind = \"moving-axis\"\nmass = \"{mass} kg\"\n"
        );
        (mass, curve.scaled(mass / own))
    } else {
        machine += "[drive]\nkind = \"moving-axis\"\nmass = \"auto\"\n";
        (own, curve.clone())
    };
    Asked {
        weights: [0.0, 0.0, mass * speed * speed],
        rest: mass * 9.81,
        speed,
        target: Some((target, curve)),
        machine,
        ..bare(r)
    }
}

pub fn fixed(r: &mut Random) -> Asked {
    let (curve, mut machine) = force(r);
    let speed = TAU / curve.period_s;
    let (mass, preload) = (r.within(1.0, 8.0), r.within(0.0, 150.0));
    let damping = if r.chance(0.7) {
        r.within(0.0, 150.0)
    } else {
        0.0
    };
    // Without a spring the level is open.
    let spring = if r.chance(0.9) {
        r.within(3e3, 2e4)
    } else {
        0.0
    };
    machine += &format!(
        "[drive]\nkind = \"fixed-axis\"\nmass = \"{mass} kg\"\nspring_rate = \"{spring} N/m\"\npreload = \"{preload} N\"\ndamping = \"{damping} N s/m\"\n"
    );
    Asked {
        weights: [spring, damping * speed, mass * speed * speed],
        rest: preload,
        speed,
        target: Some((curve.clone(), curve)),
        machine,
        ..bare(r)
    }
}

pub fn hydraulic(r: &mut Random) -> Asked {
    let (curve, mut machine) = force(r);
    let speed = TAU / curve.period_s;
    let (pressure, radius) = (r.within(5e9, 5e10), r.within(0.015, 0.025));
    machine += &format!(
        "[drive]\nkind = \"hydraulic\"\npressure_per_volume = \"{pressure} Pa/m^3\"\npiston_radius = \"{radius} m\"\n"
    );
    let area = PI * radius * radius;
    Asked {
        weights: [pressure * area * area, 0.0, 0.0],
        speed,
        target: Some((curve.clone(), curve)),
        machine,
        ..bare(r)
    }
}

/// Requirements with a follower of negligible force.
pub fn light(r: &mut Random) -> Asked {
    let speed = r.within(1.0, 30.0);
    Asked {
        weights: [0.0, 0.0, 2.0 * speed * speed],
        speed,
        objective: Objective::Energy(2 + r.below(2)),
        machine: format!(
            "[drive]\nkind = \"fixed-axis\"\nspeed = \"{speed} rad/s\"\nmass = \"2 kg\"\n"
        ),
        ..bare(r)
    }
}
