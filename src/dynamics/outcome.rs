//! What a run of the cam found, for machines (JSON, CSV) and people (a table).

use super::contact::Impact;
use super::hertz::Contact;
use crate::cam::Measures;
use serde_json::{Value, json};
use std::fmt::Write;

/// Which model ran.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// Start rigid, go as far as the numbers ask.
    Auto,
    /// Rigid bodies that stay in contact.
    Rigid,
    /// A follower that gives, in steady vibration.
    Flexible,
    /// Contact that can be lost.
    Contact,
}

impl Model {
    /// The word users write after `--model`.
    pub fn name(self) -> &'static str {
        match self {
            Model::Auto => "auto",
            Model::Rigid => "rigid",
            Model::Flexible => "flexible",
            Model::Contact => "contact",
        }
    }

    /// The model of that name.
    pub fn parse(word: &str) -> Option<Self> {
        [Model::Auto, Model::Rigid, Model::Flexible, Model::Contact]
            .into_iter()
            .find(|m| m.name() == word)
    }
}

/// One row of `dynamics.csv`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row {
    /// Cam angle, rad; over as many turns as the motion takes to repeat.
    pub theta: f64,
    /// Force along the follower's motion, N; 0 in flight.
    pub contact_force: f64,
    /// Torque of the shaft in the sense of growing θ, N·m.
    pub torque: f64,
    /// Power of the shaft, W.
    pub power: f64,
    /// Height of the moved mass over its place on the base circle, m.
    pub lift: f64,
    /// Gap between mass and cam, m.
    pub gap: f64,
    /// Force normal to the surfaces, N.
    pub normal_force: f64,
    /// Speed at which the cam rubs along the follower, m/s.
    pub sliding: f64,
    /// Mean speed of both surfaces relative to the contact, m/s.
    pub entraining: f64,
    /// Thrust across the guides, N.
    pub side_thrust: f64,
    /// What the load cell shows, N (the contact force where there is no cell).
    pub load_cell: f64,
}

/// Names of the columns of `dynamics.csv`, in order.
pub const COLUMNS: [&str; 11] = [
    "theta_rad",
    "contact_force_n",
    "torque_nm",
    "power_w",
    "lift_m",
    "gap_m",
    "normal_force_n",
    "sliding_m_per_s",
    "entraining_m_per_s",
    "side_thrust_n",
    "load_cell_n",
];

impl Row {
    fn values(&self) -> [f64; 11] {
        [
            self.theta,
            self.contact_force,
            self.torque,
            self.power,
            self.lift,
            self.gap,
            self.normal_force,
            self.sliding,
            self.entraining,
            self.side_thrust,
            self.load_cell,
        ]
    }
}

/// Extremes and error of the force, N.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Force {
    /// Smallest.
    pub min: f64,
    /// Largest; blows that take no time are not in it.
    pub max: f64,
    /// RMS distance to the target, where there is one.
    pub rms_error: Option<f64>,
}

/// Torque of the shaft, N·m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Torque {
    /// Smallest.
    pub min: f64,
    /// Largest.
    pub max: f64,
    /// Mean over the repetition, blows included.
    pub mean: f64,
    /// Root mean square; blows are not in it.
    pub rms: f64,
}

/// What the next model up would change.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The model that was run for comparison.
    pub model: Model,
    /// Its smallest force less this one's, N.
    pub force_min: f64,
    /// Its largest force less this one's, N.
    pub force_max: f64,
    /// Its RMS error less this one's, N.
    pub rms_error: Option<f64>,
    /// Its lost fraction less this one's.
    pub lost_fraction: f64,
    /// In words, where it could not be run.
    pub failed: Option<String>,
}

/// The highest line pressure and where it acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressure {
    /// Cam angle, rad.
    pub theta: f64,
    /// The contact there.
    pub contact: Contact,
}

/// What a run found.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The model whose numbers these are; never `Auto`.
    pub model: Model,
    /// The numbers that decided for it.
    pub why: String,
    /// Whether the follower leaves the cam.
    pub contact_lost: bool,
    /// Part of the motion without contact.
    pub lost_fraction: f64,
    /// Contact force.
    pub force: Force,
    /// Shaft torque.
    pub torque: Torque,
    /// Speed at which contact is first lost, rad/s; `None`: at no speed.
    pub liftoff_speed: Option<f64>,
    /// Turns before the motion repeats; `None`: it does not.
    pub settle_cycles: Option<usize>,
    /// Turns of one repetition.
    pub period_turns: usize,
    /// Landings of the whole run, settling included.
    pub impacts: Vec<Impact>,
    /// Highest line pressure of the rows, where the surfaces are known; blows are not in it.
    pub hertz: Option<Pressure>,
    /// What the next model would change, where `auto` chose.
    pub next: Option<Difference>,
    /// Largest distance between emitted points and the curve that was run, m.
    pub profile_mismatch: f64,
    /// Largest difference between the lift of the emitted points and the law's, m.
    pub law_mismatch: f64,
    /// Anything else a person should know.
    pub notes: Vec<String>,
    /// One repetition at equal angles.
    pub rows: Vec<Row>,
}

impl Outcome {
    /// `simulate --json`, followed by `details`.
    pub fn json(&self) -> Value {
        let impacts: Vec<Value> = self.impacts.iter().map(impact_json).collect();
        json!({
            "model": self.model.name(),
            "why": self.why,
            "contact_lost": self.contact_lost,
            "lost_fraction": self.lost_fraction,
            "force": {
                "min": self.force.min,
                "max": self.force.max,
                "rms_error_n": self.force.rms_error,
            },
            "torque": {
                "min": self.torque.min,
                "max": self.torque.max,
                "mean": self.torque.mean,
                "rms": self.torque.rms,
            },
            "liftoff_speed_rad_per_s": self.liftoff_speed,
            "settle_cycles": self.settle_cycles,
            "details": {
                "period_turns": self.period_turns,
                "impacts": impacts,
                "hertz": self.hertz.map(pressure_json),
                "next": self.next.as_ref().map(difference_json),
                "profile_mismatch_m": self.profile_mismatch,
                "law_mismatch_m": self.law_mismatch,
                "notes": self.notes,
            },
        })
    }

    /// `dynamics.csv`: a header and one row per angle, numbers that read back exactly.
    pub fn csv(&self) -> String {
        let mut out = COLUMNS.join(",");
        out.push('\n');
        for row in &self.rows {
            let cells: Vec<String> = row.values().iter().map(|x| format!("{x}")).collect();
            out.push_str(&cells.join(","));
            out.push('\n');
        }
        out
    }

    /// The findings for people, in the units of the follower that ran.
    pub fn table(&self, measures: Measures) -> String {
        let (force, lift) = (measures.force().name, measures.lift(0));
        let torque = match measures {
            Measures::Straight => ["push", "N"],
            _ => ["torque", "N·m"],
        };
        let mut lines: Vec<(&str, String)> = vec![
            ("model", self.model.name().to_string()),
            ("why", self.why.clone()),
            ("contact", self.contact_words()),
            (
                "force",
                format!("{:.4} … {:.4} {force}", self.force.min, self.force.max),
            ),
        ];
        if let Some(error) = self.force.rms_error {
            lines.push(("error to target", format!("{error:.4} {force} RMS")));
        }
        let t = &self.torque;
        lines.push((
            torque[0],
            format!(
                "{:.5} … {:.5} {}, mean {:.3e}, RMS {:.5}",
                t.min, t.max, torque[1], t.mean, t.rms
            ),
        ));
        let liftoff = match self.liftoff_speed {
            Some(w) => measures.speed_words(w, 6),
            None => "at no speed".to_string(),
        };
        lines.push(("lift-off", liftoff));
        let settles = match self.settle_cycles {
            Some(n) => format!(
                "after {n} turns; repeats every {} turn(s)",
                self.period_turns
            ),
            None => "not within the turns run".to_string(),
        };
        lines.push(("settles", settles));
        let bounce = self.impacts.iter().fold(0.0_f64, |m, i| m.max(i.height));
        if let Some(hit) = self
            .impacts
            .iter()
            .max_by(|a, b| a.speed.total_cmp(&b.speed))
        {
            lines.push((
                "impacts",
                format!(
                    "{} in the run, fastest {:.4} {} at {}, highest bounce {}",
                    self.impacts.len(),
                    hit.speed,
                    measures.by_time(1).name,
                    measures.place(hit.at, 2),
                    lift.after(&format!("{:.4}", lift.factor * bounce)),
                ),
            ));
        }
        if let Some(p) = &self.hertz {
            lines.push((
                "pressure",
                format!(
                    "{:.1} MPa at {}, half-width {:.4} mm, largest shear {:.4} mm deep",
                    1e-6 * p.contact.pressure,
                    measures.place(p.theta, 1),
                    1e3 * p.contact.half_widths[1],
                    1e3 * p.contact.shear.map_or(0.0, |s| s.0)
                ),
            ));
        }
        if let Some(next) = &self.next {
            lines.push(("next model", difference_words(next)));
        }
        for note in &self.notes {
            lines.push(("note", note.clone()));
        }
        let width = lines.iter().map(|l| l.0.len()).max().unwrap_or(0);
        lines.iter().fold(String::new(), |mut out, (name, value)| {
            // Writing to a String cannot fail.
            let _ = writeln!(out, "{name:width$}  {value}");
            out
        })
    }

    fn contact_words(&self) -> String {
        if self.contact_lost {
            format!("lost for {:.3} % of the motion", 100.0 * self.lost_fraction)
        } else {
            "kept all the way round".to_string()
        }
    }
}

fn impact_json(hit: &Impact) -> Value {
    json!({
        "at_rad": hit.at,
        "left_at_rad": hit.since,
        "cam": hit.surface,
        "speed_m_per_s": hit.speed,
        "rebound_m_per_s": hit.pulse.rebound,
        "height_m": hit.height,
        "impulse_n_s": hit.pulse.impulse,
        "peak_force_n": (hit.pulse.duration > 0.0).then_some(hit.pulse.peak_force),
        "duration_s": hit.pulse.duration,
    })
}

fn pressure_json(p: Pressure) -> Value {
    json!({
        "at_rad": p.theta,
        "pressure_pa": p.contact.pressure,
        "half_width_m": p.contact.half_widths[1],
        "shear_depth_m": p.contact.shear.map(|s| s.0),
        "shear_pa": p.contact.shear.map(|s| s.1),
    })
}

fn difference_json(next: &Difference) -> Value {
    json!({
        "model": next.model.name(),
        "force_min_change_n": next.force_min,
        "force_max_change_n": next.force_max,
        "rms_error_change_n": next.rms_error,
        "lost_fraction_change": next.lost_fraction,
        "failed": next.failed,
    })
}

/// What the next model up would change, in words.
pub fn difference_words(next: &Difference) -> String {
    if let Some(reason) = &next.failed {
        return format!("{} could not be run: {reason}", next.model.name());
    }
    let rms = next
        .rms_error
        .map_or(String::new(), |e| format!(", RMS error {e:+.3e} N"));
    format!(
        "{} would change the smallest force by {:+.3e} N, the largest by {:+.3e} N{rms}, the lost part by {:+.3e}",
        next.model.name(),
        next.force_min,
        next.force_max,
        next.lost_fraction
    )
}
