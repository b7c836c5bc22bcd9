//! Joint mean of several recordings, compared with the true values of their walkers.

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use gaitcam_gait::error::Result;
use gaitcam_gait::{
    Cycle, CycleSource, Feet, Foot, Interpretation, JointMean, Kind, LeftOut, Note, OpenQuestion,
    ReadOptions, Trial, cycle, joint_mean, read, stances,
};

use crate::fault;

const RATE: f64 = 500.0;
const STANCE: f64 = 0.62;

/// A walker (or runner) on two insoles.
#[derive(Clone, Copy)]
struct Walker {
    stride_s: f64,
    /// Ratio of the force to that of the usual walker.
    strength: f64,
    /// Ratio of the force of the left foot to that of the right foot.
    left: f64,
    /// Time of the first heel strike of the left foot, s.
    start_s: f64,
}

const USUAL: Walker = Walker {
    stride_s: 1.1,
    strength: 1.0,
    left: 1.0,
    start_s: 0.3,
};

/// Force of a stance at the fraction x of its duration, N.
fn stance(x: f64) -> f64 {
    if (0.0..1.0).contains(&x) {
        720.0 * ((PI * x).sin() + 0.3 * (3.0 * PI * x).sin())
    } else {
        0.0
    }
}

impl Walker {
    fn foot(&self, t: f64, first: f64) -> f64 {
        let strike = t - first;
        if strike < 0.0 {
            return 0.0;
        }
        stance(strike.rem_euclid(self.stride_s) / (STANCE * self.stride_s))
    }

    /// A recording of seven strides.
    fn file(&self) -> String {
        let mut text = "Time,left fz,right fz\n".to_string();
        for i in 0..(7.0 * self.stride_s * RATE) as usize {
            let t = i as f64 / RATE;
            let left = self.strength * self.left * self.foot(t, self.start_s);
            let right = self.strength * self.foot(t, self.start_s + 0.5 * self.stride_s);
            writeln!(text, "{t:.4},{left:.4},{right:.4}").unwrap();
        }
        text
    }

    /// Mean cycle of the walker's recording, and its interpretation with open questions.
    fn trial(&self) -> (Cycle, Interpretation) {
        let text = self.file();
        let options = ReadOptions::default();
        let r = read(Path::new("walk.csv"), text.as_bytes(), &options).unwrap();
        let s = stances(&r);
        let c = cycle(&r, &s, Feet::Both).unwrap_or_else(|e| panic!("{e}"));
        let understood = Interpretation::of("walk.csv", &r, &s, Some(&c), Feet::Both);
        (c, understood)
    }
}

fn joint(walkers: &[Walker]) -> (Vec<Cycle>, Result<JointMean>) {
    let all: Vec<(Cycle, Interpretation)> = walkers.iter().map(Walker::trial).collect();
    let open: Vec<_> = all.iter().map(|(_, u)| u.doubts()).collect();
    let trials: Vec<Trial> = all
        .iter()
        .zip(&open)
        .map(|((cycle, _), open)| Trial { cycle, open })
        .collect();
    let joint = joint_mean(&trials);
    (all.into_iter().map(|(c, _)| c).collect(), joint)
}

#[test]
fn mean_and_spread_are_those_of_all_cycles_of_all_trials() {
    let strengths = [1.0, 1.04, 0.97];
    let walkers = strengths.map(|strength| Walker { strength, ..USUAL });
    let (cycles, joint) = joint(&walkers);
    let joint = joint.unwrap();
    assert_eq!((joint.trials(), joint.kind), (3, Kind::Walking));
    let counts: Vec<f64> = cycles.iter().map(|c| c.averaged as f64).collect();
    let all: f64 = counts.iter().sum();
    assert!(all > 9.0 && joint.cycles == all as usize);
    let pairs = || counts.iter().zip(strengths);
    let mean = pairs().map(|(n, s)| n * s).sum::<f64>() / all;
    let square = pairs().map(|(n, s)| n * (s - mean).powi(2)).sum::<f64>();
    let deviation = (square / (all - 1.0)).sqrt();
    let spread = joint.curve.spread_n.as_ref().unwrap();
    let plain = cycles[0].curve.mean_n();
    assert!((joint.curve.mean_n() / (mean * plain) - 1.0).abs() < 1e-3);
    for ((force, spread), one) in joint
        .curve
        .force_n
        .iter()
        .zip(spread)
        .zip(&cycles[0].curve.force_n)
    {
        assert!((force - mean * one).abs() < 2.0, "{force} {one}");
        assert!((spread - deviation * one).abs() < 2.0, "{spread} {one}");
    }
    assert!((joint.curve.period_s - 1.1).abs() < 1e-3);
}

#[test]
fn trials_of_another_speed_or_in_doubt_are_left_out_with_their_reason() {
    let slow = Walker {
        stride_s: 1.5,
        ..USUAL
    };
    let (cycles, joint) = joint(&[USUAL, slow, USUAL]);
    let joint = joint.unwrap();
    assert_eq!(cycles.len(), 3);
    let Some(LeftOut::OtherSpeed { period, low, high }) = &joint.left_out[1] else {
        panic!("{:?}", joint.left_out)
    };
    assert!((period.value - 1.5).abs() < 1e-3 && low.value < 1.11 && high.value > 1.09);
    assert_eq!(joint.trials(), 2);
    assert!((joint.curve.period_s - 1.1).abs() < 1e-3);
    let open = [OpenQuestion::Clock];
    let trials = [
        Trial {
            cycle: &cycles[2],
            open: &open,
        },
        Trial {
            cycle: &cycles[0],
            open: &[],
        },
    ];
    let joint = joint_mean(&trials).unwrap();
    assert_eq!(
        joint.left_out,
        [
            Some(LeftOut::Open {
                questions: open.to_vec()
            }),
            None
        ]
    );
    let none = joint_mean(&trials[..1]).unwrap_err();
    assert_eq!(fault(&none), "force-no-joint-mean");
}

#[test]
fn walkers_of_several_masses_are_averaged_in_body_weights() {
    let heavy = Walker {
        strength: 1.5,
        ..USUAL
    };
    let (cycles, joint) = joint(&[USUAL, heavy]);
    let joint = joint.unwrap();
    let several = |n: &Note| matches!(n, Note::SeveralMasses { .. });
    assert!(joint.notes.iter().any(several), "{:?}", joint.notes);
    let masses = [cycles[0].mass_kg, cycles[1].mass_kg];
    assert!((masses[1] / masses[0] - 1.5).abs() < 1e-3);
    assert!((joint.mass_kg / masses[0] - 1.25).abs() < 1e-2);
    // In body weights both walk alike, so nothing is left between them.
    let spread = joint.curve.spread_n.unwrap();
    let highest = spread.iter().copied().fold(0.0, f64::max);
    assert!(highest < 5.0, "{highest} N");
}

#[test]
fn a_cycle_from_the_left_foot_is_shifted_to_the_right_one() {
    let limping = Walker {
        left: 0.86,
        ..USUAL
    };
    let shifted = Walker {
        start_s: 0.3 - 0.55,
        ..limping
    };
    let (cycles, joint) = joint(&[limping, shifted]);
    let from = |c: &Cycle| match c.source {
        CycleSource::WholeStrides { from, .. } => from,
        _ => None,
    };
    let feet: Vec<Option<Foot>> = cycles.iter().map(from).collect();
    assert!(
        feet.contains(&Some(Foot::Left)) && feet.contains(&Some(Foot::Right)),
        "{feet:?}"
    );
    // Both are of one walker: on one phase they do not differ.
    let spread = joint.unwrap().curve.spread_n.unwrap();
    let highest = spread.iter().copied().fold(0.0, f64::max);
    assert!(highest < 8.0, "{highest} N");
}
