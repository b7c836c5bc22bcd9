//! C3D files of one stance, whose foot and stride time follow only from the heel markers.

use std::f64::consts::PI;
use std::path::Path;

use super::dice::Dice;
use crate::c3d_file::{Build, Marker, Processor, build_with};
use gaitcam_gait::{
    Cycle, Feet, Foot, Note, PeriodSource, ReadOptions, Recording, cycle, read, stances,
};

const FRAMES_HZ: f64 = 100.0;
const LABELS: [[&str; 2]; 6] = [
    ["LHEE", "RHEE"],
    ["LHEEL", "RHEEL"],
    ["walker:LHEE", "walker:RHEE"],
    ["L_Heel", "R_Heel"],
    ["LCAL", "RCAL"],
    ["Left Heel", "Right Heel"],
];

/// A walker on one plate, with heel strikes of one foot at `strike_s` and in whole strides after it.
struct Walk {
    stride_s: f64,
    duty: f64,
    strike_s: f64,
    foot: Foot,
    frames: usize,
    length_mm: f64,
    /// Ratio of the belt speed of a treadmill and the speed of the walker.
    belt: f64,
    heading: f64,
}

impl Walk {
    fn drawn(dice: &mut Dice) -> Self {
        let stride_s = dice.between(0.9, 1.4);
        Walk {
            stride_s,
            duty: dice.between(0.58, 0.66),
            strike_s: dice.between(0.8, 1.2),
            foot: dice.of(&[Foot::Left, Foot::Right]),
            frames: (FRAMES_HZ * (1.2 + dice.between(1.2, 2.6) * stride_s)) as usize,
            length_mm: dice.between(1000.0, 1500.0),
            belt: dice.of(&[0.0, 0.0, 1.0]),
            heading: dice.between(0.0, 2.0 * PI),
        }
    }

    /// Number of strides since the foot first landed on the plate.
    fn phase(&self, frame: f64) -> f64 {
        (frame / FRAMES_HZ - self.strike_s) / self.stride_s
    }

    /// Position of a heel, mm. It is constant from heel strike until the heel rises. It then moves to the next position with minimum jerk (Flash and
    /// Hogan 1985) and with a rise above the floor.
    fn heel(&self, frame: f64, foot: Foot) -> [f64; 3] {
        let now = self.phase(frame);
        let turn = if foot == self.foot { now } else { now + 0.5 };
        let rises = 0.65 * self.duty;
        let x = ((turn - turn.floor() - rises) / (1.0 - rises)).max(0.0);
        let ahead = turn.floor() + x.powi(3) * (10.0 - 15.0 * x + 6.0 * x * x) - (turn - now);
        let along = self.length_mm * (ahead - self.belt * now - (1.0 - self.belt) * 0.5);
        let beside = if foot == Foot::Left { 60.0 } else { -60.0 };
        let (s, c) = self.heading.sin_cos();
        [
            along * c - beside * s,
            along * s + beside * c,
            30.0 + 150.0 * (PI * x).sin(),
        ]
    }

    /// Force on the plate at an analog sample, N, downwards negative.
    fn force(&self, sample: usize, rate_hz: f64) -> f64 {
        let x = (sample as f64 / rate_hz - self.strike_s) / (self.duty * self.stride_s);
        let on = (0.0..1.0).contains(&x);
        let hump = (PI * x).sin() + 0.3 * (3.0 * PI * x).sin();
        if on { -70.0 * 9.81 * 1.2 * hump } else { 0.0 }
    }

    fn file(&self, dice: &mut Dice, noise_mm: f64, lost: f64) -> Vec<u8> {
        let built = Build {
            before: 0,
            processor: dice.of(&[Processor::Intel, Processor::Dec, Processor::Sgi]),
            float: dice.chance(50.0),
            kind: dice.of(&[1, 2, 3, 4]),
            per_frame: dice.of(&[5, 10]),
            frames: self.frames,
            scale: 0.05,
            offset: 0,
        };
        let mut path = |foot: Foot| -> Vec<Option<[f64; 3]>> {
            let seen = |frame: usize| {
                let at = self.heel(frame as f64, foot);
                let noisy = at.map(|x| x + noise_mm * dice.normal());
                (!dice.chance(lost)).then_some(noisy)
            };
            (0..self.frames).map(seen).collect()
        };
        let (left, right) = (path(Foot::Left), path(Foot::Right));
        let labels = dice.of(&LABELS);
        let rate = FRAMES_HZ * built.per_frame as f64;
        let toe = |_| Some([500.0, 20.0, 30.0]);
        let markers: [Marker; 3] = [
            ("LTOE", &toe),
            (labels[1], &|i| right[i]),
            (labels[0], &|i| left[i]),
        ];
        build_with(&built, |i| self.force(i, rate), &markers)
    }
}

fn opened(bytes: &[u8]) -> (Recording, Cycle) {
    let recording = read(Path::new("made.c3d"), bytes, &ReadOptions::default()).unwrap();
    let mean = cycle(&recording, &stances(&recording), Feet::One).unwrap();
    (recording, mean)
}

#[test]
fn heel_markers_give_the_foot_and_the_stride_of_a_single_stance() {
    let mut named = 0;
    for seed in 0..120 {
        let dice = &mut Dice::new(seed);
        let walk = Walk::drawn(dice);
        let noise_mm = dice.of(&[0.0, 0.5, 1.0]);
        let (recording, mean) = opened(&walk.file(dice, noise_mm, 0.0));
        let used = stances(&recording).used;
        assert_eq!(used.len(), 1, "{seed}");
        assert_eq!(used[0].foot, Some(walk.foot), "{seed}");
        if mean.period.from == PeriodSource::HeelMarkers {
            named += 1;
            let off = mean.curve.period_s / walk.stride_s - 1.0;
            assert!(off.abs() < 0.015, "{seed}: {off}");
        } else {
            // Fewer than two moments of one heel ahead of the other lie within the record.
            let seconds = walk.frames as f64 / FRAMES_HZ;
            assert!(seconds < 2.0 * walk.stride_s, "{seed}: {seconds}");
        }
    }
    assert!(named > 100, "{named}");
}

#[test]
fn markers_that_are_often_lost_never_give_a_wrong_foot_or_stride() {
    let mut named = 0;
    for seed in 0..120 {
        let dice = &mut Dice::new(1000 + seed);
        let walk = Walk::drawn(dice);
        let lost = dice.of(&[1.0, 5.0, 30.0, 80.0]);
        let (recording, mean) = opened(&walk.file(dice, 0.5, lost));
        let foot = stances(&recording).used[0].foot;
        assert!(foot.is_none_or(|f| f == walk.foot), "{seed}");
        named += usize::from(foot.is_some());
        if mean.period.from == PeriodSource::HeelMarkers {
            let off = mean.curve.period_s / walk.stride_s - 1.0;
            assert!(off.abs() < 0.015, "{seed}: {off}");
        }
    }
    assert!(named > 60, "{named}");
}

#[test]
fn a_stride_from_one_pair_of_moments_is_said_with_its_error() {
    let dice = &mut Dice::new(3);
    let walk = Walk {
        frames: 230,
        stride_s: 1.1,
        strike_s: 0.9,
        ..Walk::drawn(dice)
    };
    let (_, mean) = opened(&walk.file(dice, 0.5, 0.0));
    assert_eq!(mean.period.from, PeriodSource::HeelMarkers);
    let one = |n: &Note| matches!(n, Note::StrideFromOne { .. });
    assert_eq!(mean.period.spread_s.is_none(), mean.notes.iter().any(one));
}
