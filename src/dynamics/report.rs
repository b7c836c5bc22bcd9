//! An outcome for machines (JSON, CSV) and for people (a table).

use super::contact::Impact;
use super::outcome::{Difference, Outcome, Pressure, Row};
use super::reason::RunNote;
use crate::cam::Measures;
use crate::wording::Language;
use serde_json::{Value, json};
use std::fmt::Write;

/// Names of the columns of `dynamics.csv`, in order.
pub const COLUMNS: [&str; 10] = [
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
];

impl Row {
    fn values(&self) -> [f64; 10] {
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
        ]
    }
}

impl Outcome {
    /// `simulate --json`, followed by `details`.
    pub fn json(&self) -> Value {
        let impacts: Vec<Value> = self.impacts.iter().map(impact_json).collect();
        json!({
            "model": self.model.name(),
            "why": self.why.sentence(Language::En),
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
                "notes": self.notes.iter().map(said).collect::<Vec<_>>(),
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
            ("why", self.why.sentence(Language::En)),
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
                    1e3 * p.contact.half_width,
                    1e3 * p.contact.shear_depth
                ),
            ));
        }
        if let Some(next) = &self.next {
            lines.push(("next model", difference_words(next)));
        }
        for note in &self.notes {
            lines.push(("note", said(note)));
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

fn said(note: &RunNote) -> String {
    note.sentence(Language::En)
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
    })
}

fn pressure_json(p: Pressure) -> Value {
    json!({
        "at_rad": p.theta,
        "pressure_pa": p.contact.pressure,
        "half_width_m": p.contact.half_width,
        "shear_depth_m": p.contact.shear_depth,
        "shear_pa": p.contact.shear,
    })
}

fn difference_json(next: &Difference) -> Value {
    json!({
        "model": next.model.name(),
        "force_min_change_n": next.force_min,
        "force_max_change_n": next.force_max,
        "rms_error_change_n": next.rms_error,
        "lost_fraction_change": next.lost_fraction,
        "failed": next.failed.as_ref().map(ToString::to_string),
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
