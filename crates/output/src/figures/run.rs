//! The picture of a simulation: force, torque and gap over the cam angle.

use plotters::style::Color;

use super::force::force_frame;
use crate::plot::axes::padded;
use crate::plot::layout::{Layout, columns, strips};
use crate::plot::palette::{BLUE, ORANGE, PURPLE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::Frame;
use crate::pose::target_at;
use crate::words::{self, Words};
use gaitcam::cam::Measures;
use gaitcam::dynamics::{Model, Outcome};
use gaitcam::synth::Design;

/// Force with target and rigid force behind it, torque, and the gap where there is one.
pub(crate) fn run_in(
    synthesis: &Design,
    outcome: &Outcome,
    layout: Layout,
    words: &Words,
) -> Picture {
    layout.picture(words.language(), |f| {
        let law = &synthesis.cam.law;
        let (start, length) = law.extent();
        let turns = outcome.period_turns;
        let e = f.e;
        let total = outcome.rows.len();
        let span = length * turns as f64;
        let measures = synthesis.cam.follower.measures();
        let across = measures.angle().factor;
        let straight = measures == Measures::Straight;
        let panel = |frame: Frame, y: [f64; 2]| {
            let x = [across * start, across * (start + span)];
            f.panel(frame, x, columns(x, !straight), y)
        };
        let angle = |i: usize| start + span * i as f64 / total as f64;
        let curve = |f: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
            (0..=total)
                .map(|i| (across * angle(i), f(i % total)))
                .collect()
        };
        let rows = &outcome.rows;
        let force = curve(&|i| rows[i].contact_force);
        let torque = curve(&|i| rows[i].torque);
        let lift = measures.lift(0);
        let gap = curve(&|i| lift.factor * rows[i].gap);
        let within = |i: usize| start + (angle(i) - start) % length;
        let rigid = (outcome.model != Model::Rigid)
            .then(|| curve(&|i| synthesis.drive.force(law.svaj(within(i)))));
        let target = synthesis
            .target
            .as_ref()
            .map(|t| curve(&|i| target_at(t, law, within(i))));
        let frame = force_frame(layout);
        let shares: &[f64] = if outcome.contact_lost {
            &[1.9, 1.0, 0.8]
        } else {
            &[1.9, 1.0]
        };
        let frames = strips(frame, shares, 0.9 * e);
        let values = force
            .iter()
            .chain(rigid.iter().flatten())
            .chain(target.iter().flatten())
            .map(|p| p.1);
        let forces = panel(frames[0], padded(values.chain([0.0]), 0.08))?;
        let [target_name, rigid_name, run_name] =
            ["figure-target", "figure-rigid", "figure-simulated"].map(|k| words.text(k));
        let mut entries = Vec::new();
        if let Some(target) = &target {
            forces.curve(target, ORANGE.mix(0.55), 8.0)?;
            entries.push((ORANGE.mix(0.55), 8.0, target_name.as_str()));
        }
        if let Some(rigid) = &rigid {
            forces.curve(rigid, QUIET, 1.4)?;
            entries.push((QUIET, 1.4, rigid_name.as_str()));
        }
        forces.curve(&force, BLUE, 2.2)?;
        entries.push((BLUE, 2.2, run_name.as_str()));
        let pressing = words.text(match measures {
            Measures::Oscillating => "figure-moment",
            _ => "figure-force",
        });
        forces.quantity(&pressing)?;
        let y = padded(torque.iter().map(|p| p.1).chain([0.0]), 0.12);
        let torques = panel(frames[1], y)?;
        torques.curve(&torque, PURPLE, 2.0)?;
        let turning = words.text(if straight {
            "figure-push"
        } else {
            "figure-torque"
        });
        torques.quantity(&turning)?;
        if outcome.contact_lost {
            let top = padded(gap.iter().map(|p| p.1).chain([0.0]), 0.12)[1];
            let gaps = panel(frames[2], [0.0, top])?;
            gaps.curve(&gap, RED, 2.0)?;
            gaps.quantity(&words.fill("figure-gap", &[("unit", lift.name)]))?;
            gaps.across(&words::across(words, measures))?;
        } else {
            torques.across(&words::across(words, measures))?;
        }
        f.key([frame.left, frame.top - 1.1 * e], e, &entries)
    })
}
