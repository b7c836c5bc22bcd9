//! An outcome for machines (JSON, CSV) and for people (a table).

use super::contact::Impact;
use super::outcome::{Difference, Outcome, Pressure, Row};
use super::reason::RunNote;
use crate::cam::Measures;
use crate::wording::{self, Language};
use serde_json::{Value, json};
use std::fmt::Write;

/// Labels and values of the table: messages of the area `simulation`.
pub const LABELS: &[&str] = &[
    "model",
    "why",
    "contact",
    "contact-kept",
    "contact-lost",
    "force",
    "error",
    "torque",
    "push",
    "torque-values",
    "pressure",
    "pressure-values",
    "lift-off",
    "never",
    "settles",
    "settled",
    "unsettled",
    "impacts",
    "impact-values",
    "next-model",
    "next-failed",
    "next-rms",
    "next-same",
    "next-changes",
    "note",
];

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

    /// The columns of `dynamics.csv`.
    pub fn columns(&self) -> Vec<(&'static str, Vec<f64>)> {
        let column = |i: usize| self.rows.iter().map(|r| r.values()[i]).collect();
        (COLUMNS.iter().enumerate())
            .map(|(i, name)| (*name, column(i)))
            .collect()
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
    pub fn table(&self, measures: Measures, language: Language) -> String {
        let say = Say { language, measures };
        let mut lines = vec![
            ("model", say.name(self.model.name())),
            ("why", self.why.sentence(language)),
            ("contact", self.contact_words(say)),
        ];
        lines.extend(self.loads(say));
        lines.extend(self.motion(say));
        if let Some(next) = &self.next {
            lines.push(("next-model", next.sentence(language)));
        }
        for note in &self.notes {
            lines.push(("note", note.sentence(language)));
        }
        let lines: Vec<(String, String)> = lines
            .into_iter()
            .map(|(label, value)| (say.fill(label, json!({})), value))
            .collect();
        let width = lines.iter().map(|l| l.0.chars().count()).max().unwrap_or(0);
        lines.iter().fold(String::new(), |mut out, (name, value)| {
            // Writing to a String cannot fail.
            let _ = writeln!(out, "{name:width$}  {value}");
            out
        })
    }

    fn contact_words(&self, say: Say) -> String {
        if self.contact_lost {
            let percent = say.number(format!("{:.3}", 100.0 * self.lost_fraction));
            say.fill("contact-lost", json!({"percent": percent}))
        } else {
            say.fill("contact-kept", json!({}))
        }
    }

    /// Force, its error, torque and pressure.
    fn loads(&self, say: Say) -> Vec<(&'static str, String)> {
        let force = say.measures.force().name;
        let (low, high) = (self.force.min, self.force.max);
        let mut lines = vec![("force", say.number(format!("{low:.4} … {high:.4} {force}")))];
        if let Some(error) = self.force.rms_error {
            lines.push(("error", say.number(format!("{error:.4} {force} RMS"))));
        }
        let t = &self.torque;
        let (label, unit) = match say.measures {
            Measures::Straight => ("push", "N"),
            Measures::Translating | Measures::Oscillating => ("torque", "N·m"),
        };
        let torque = json!({
            "least": say.number(format!("{:.5}", t.min)),
            "most": say.number(format!("{:.5} {unit}", t.max)),
            "mean": say.number(format!("{:.5}", t.mean + 0.0)),
            "rms": say.number(format!("{:.5}", t.rms)),
        });
        lines.push((label, say.fill("torque-values", torque)));
        if let Some(p) = &self.hertz {
            let pressure = json!({
                "pressure": say.number(format!("{:.1} MPa", 1e-6 * p.contact.pressure)),
                "at": say.number(say.measures.place(p.theta, 1)),
                "width": say.number(format!("{:.4} mm", 1e3 * p.contact.half_width)),
                "depth": say.number(format!("{:.4} mm", 1e3 * p.contact.shear_depth)),
            });
            lines.push(("pressure", say.fill("pressure-values", pressure)));
        }
        lines
    }

    /// Lift-off, settling and impacts.
    fn motion(&self, say: Say) -> Vec<(&'static str, String)> {
        let measures = say.measures;
        let liftoff = match self.liftoff_speed {
            Some(w) => say.number(measures.speed_words(w, 6)),
            None => say.fill("never", json!({})),
        };
        let settles = match self.settle_cycles {
            Some(turns) => {
                let values = json!({"turns": turns, "period": self.period_turns});
                say.fill("settled", values)
            }
            None => say.fill("unsettled", json!({})),
        };
        let mut lines = vec![("lift-off", liftoff), ("settles", settles)];
        let bounce = self.impacts.iter().fold(0.0_f64, |m, i| m.max(i.height));
        let fastest = self
            .impacts
            .iter()
            .max_by(|a, b| a.speed.total_cmp(&b.speed));
        if let Some(hit) = fastest {
            let (lift, speed) = (measures.lift(0), measures.by_time(1).name);
            let bounce = lift.after(&format!("{:.4}", lift.factor * bounce));
            let impacts = json!({
                "count": self.impacts.len(),
                "speed": say.number(format!("{:.4} {speed}", hit.speed)),
                "at": say.number(measures.place(hit.at, 2)),
                "bounce": say.number(bounce),
            });
            lines.push(("impacts", say.fill("impact-values", impacts)));
        }
        lines
    }
}

/// Changes of a force, N, or of the lost part below this are rounding.
const LEAST_CHANGE: f64 = 5e-5;

/// Language and units of a table.
#[derive(Clone, Copy)]
struct Say {
    language: Language,
    measures: Measures,
}

impl Say {
    fn fill(self, message: &str, values: Value) -> String {
        wording::sentence(self.language, "simulation", &json!({ message: values }))
    }

    fn name(self, typed: &str) -> String {
        wording::catalogue(self.language).name(typed)
    }

    /// A number that is written already, with the decimal sign of the language.
    fn number(self, written: String) -> String {
        match self.language {
            Language::En => written,
            Language::Es => written.replace('.', ","),
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

impl Difference {
    /// What the next model up would change.
    pub fn sentence(&self, language: Language) -> String {
        let measures = Measures::Translating;
        let say = Say { language, measures };
        let model = say.name(self.model.name());
        if let Some(fault) = &self.failed {
            let fault = fault.sentence(language);
            return say.fill("next-failed", json!({"model": model, "fault": fault}));
        }
        let same = self.force_min.abs().max(self.force_max.abs()) < LEAST_CHANGE
            && self.rms_error.is_none_or(|e| e.abs() < LEAST_CHANGE)
            && self.lost_fraction.abs() < LEAST_CHANGE;
        if same {
            return say.fill("next-same", json!({"model": model}));
        }
        let written = |x: f64| {
            let sign = if x > 0.0 { "+" } else { "" };
            format!("{sign}{}", say.number(format!("{x:.4}")))
        };
        let rms = self.rms_error.map_or(String::new(), |e| {
            say.fill("next-rms", json!({"rms": written(e)}))
        });
        let values = json!({
            "model": model,
            "least": written(self.force_min),
            "most": written(self.force_max),
            "error": rms,
            "lost": written(100.0 * self.lost_fraction),
        });
        say.fill("next-changes", values)
    }
}
