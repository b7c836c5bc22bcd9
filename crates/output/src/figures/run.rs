//! Figure of a simulation: force, torque and gap over the cam angle, or over time if the shaft speed varies.

use plotters::style::{Color, RGBAColor};

use std::f64::consts::TAU;

use super::force::force_frame;
use crate::plot::axes::{Panel, padded, ticks};
use crate::plot::layout::{Figure, Layout, columns, strips};
use crate::plot::palette::{BLUE, ORANGE, PURPLE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Drawn, Frame};
use crate::pose::target_at;
use crate::words::{self, Words};
use gaitcam::cam::Measures;
use gaitcam::dynamics::{Model, Outcome};
use gaitcam::force::ForceCurve;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

/// An entry of the legend: colour, line width (points) and name of a curve.
type Entry = (RGBAColor, f64, String);

/// A simulation whose quantities are drawn over the displayed cam angle, or over time if the shaft speed varies.
struct Shown<'a> {
    synthesis: &'a Design,
    outcome: &'a Outcome,
    measures: Measures,
}

impl Shown<'_> {
    /// Cam angle of sample `i`, rad (m of travel for a translating cam).
    fn angle(&self, i: usize) -> f64 {
        let (start, length) = self.synthesis.cam.law.extent();
        let span = length * self.outcome.period_turns as f64;
        start + span * i as f64 / self.outcome.rows.len() as f64
    }

    /// Time of one turn, s.
    fn period(&self) -> f64 {
        TAU / self.synthesis.problem.drive.speed.abs()
    }

    /// Horizontal position of sample `i`: displayed cam angle, or time in s.
    fn across(&self, i: usize) -> f64 {
        if self.outcome.shaft.is_none() {
            return self.measures.angle().factor * self.angle(i);
        }
        let a_turn = self.outcome.rows.len() / self.outcome.period_turns;
        self.outcome.rows[i % a_turn].time + (i / a_turn) as f64 * self.period()
    }

    /// Points (horizontal position, value) of a quantity at all samples, with the first value repeated at the end.
    fn curve(&self, value: impl Fn(usize) -> f64) -> Vec<(f64, f64)> {
        let total = self.outcome.rows.len();
        let point = |i: usize| (self.across(i), value(i % total));
        (0..=total).map(point).collect()
    }

    fn panel<'a, 'c>(&self, f: &Figure<'a, 'c>, frame: Frame, y: [f64; 2]) -> Drawn<Panel<'a, 'c>> {
        let x = [0, self.outcome.rows.len()].map(|i| self.across(i));
        let columns = match self.outcome.shaft {
            Some(_) => ticks(x[0], x[1], 8.0),
            None => columns(x, self.measures != Measures::Straight),
        };
        f.panel(frame, x, columns, y)
    }

    /// Draws the simulated force. The target and the force of the rigid model are drawn behind it. Returns the entries of the legend.
    fn force(&self, f: &Figure, frame: Frame, words: &Words) -> Drawn<Vec<Entry>> {
        let law = &self.synthesis.cam.law;
        let (start, length) = law.extent();
        let within = |i: usize| start + (self.angle(i) - start) % length;
        let on_shaft = self.outcome.shaft.is_some();
        let target = self.synthesis.target_in_time();
        let wanted = |t: &ForceCurve, i: usize| match on_shaft {
            true => t.at(TAU * self.outcome.rows[i].time / self.period()),
            false => target_at(t, law, within(i)),
        };
        let target = target.map(|t| self.curve(|i| wanted(t, i)));
        let rigid = |i: usize| self.synthesis.problem.drive.force(law.svaj(within(i)));
        let apart = self.outcome.model != Model::Rigid || on_shaft;
        let mut rigid = apart.then(|| self.curve(rigid));
        if on_shaft {
            // The rigid model runs at constant speed. It therefore passes each angle at another time than the simulated cam.
            let at = |i: usize| (self.angle(i) - start) / TAU * self.period();
            let points = rigid.iter_mut().flatten().enumerate();
            points.for_each(|(i, point)| point.0 = at(i));
        }
        let grey = if on_shaft {
            "figure-constant-speed"
        } else {
            "figure-rigid"
        };
        let force = self.curve(|i| self.outcome.rows[i].contact_force);
        let curves = [
            (target, ORANGE.mix(0.55), 8.0, "figure-target"),
            (rigid, QUIET, 1.4, grey),
            (Some(force), BLUE, 2.2, "figure-simulated"),
        ];
        let values = curves.iter().filter_map(|c| c.0.as_ref()).flatten();
        let y = padded(values.map(|p| p.1).chain([0.0]), 0.08);
        let panel = self.panel(f, frame, y)?;
        let mut entries = Vec::new();
        for (curve, colour, width, key) in &curves {
            if let Some(curve) = curve {
                panel.curve(curve, *colour, *width)?;
                entries.push((*colour, *width, words.text(key)));
            }
        }
        panel.quantity(&words.text(match self.measures {
            Measures::Oscillating => "figure-moment",
            _ => "figure-force",
        }))?;
        Ok(entries)
    }
}

/// Figure of a simulation: force with target and rigid force, torque, speed if it varies, and gap if contact is lost.
pub fn run(synthesis: &Design, outcome: &Outcome, language: Language) -> Picture {
    run_in(synthesis, outcome, Layout::ALONE, &words::words(language))
}

pub(crate) fn run_in(
    synthesis: &Design,
    outcome: &Outcome,
    layout: Layout,
    words: &Words,
) -> Picture {
    layout.picture(words.language(), |f| {
        let (e, rows) = (f.e, &outcome.rows);
        let measures = synthesis.cam.follower.measures();
        let shown = Shown {
            synthesis,
            outcome,
            measures,
        };
        let frame = force_frame(layout);
        let more = [outcome.shaft.is_some(), outcome.contact_lost];
        let more = more.iter().filter(|is_drawn| **is_drawn);
        let shares: Vec<f64> = [1.9, 1.0].into_iter().chain(more.map(|_| 0.8)).collect();
        let frames = strips(frame, &shares, 0.9 * e);
        let entries = shown.force(&f, frames[0], words)?;
        let torque = shown.curve(|i| rows[i].torque);
        let y = padded(torque.iter().map(|p| p.1).chain([0.0]), 0.12);
        let mut last = shown.panel(&f, frames[1], y)?;
        last.curve(&torque, PURPLE, 2.0)?;
        last.quantity(&words.text(match measures {
            Measures::Straight => "figure-push",
            _ => "figure-torque",
        }))?;
        if outcome.shaft.is_some() {
            let speed = shown.curve(|i| rows[i].speed);
            let y = padded(speed.iter().map(|p| p.1), 0.12);
            last = shown.panel(&f, frames[2], y)?;
            last.curve(&speed, RED, 2.0)?;
            last.quantity(&words.text("figure-shaft-speed"))?;
        }
        if outcome.contact_lost {
            let lift = measures.lift(0);
            let gap = shown.curve(|i| lift.factor * rows[i].gap);
            let top = padded(gap.iter().map(|p| p.1).chain([0.0]), 0.12)[1];
            last = shown.panel(&f, frames[frames.len() - 1], [0.0, top])?;
            last.curve(&gap, RED, 2.0)?;
            last.quantity(&words.fill("figure-gap", &[("unit", lift.name)]))?;
        }
        last.across(&match outcome.shaft {
            Some(_) => words.text("figure-time"),
            None => words::across(words, measures),
        })?;
        let entries: Vec<_> = (entries.iter())
            .map(|(c, w, name)| (*c, *w, &**name))
            .collect();
        f.key([frame.left, frame.top - 1.1 * e], e, &entries)
    })
}
