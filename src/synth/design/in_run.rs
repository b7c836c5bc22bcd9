//! Verdict from a simulation of the output profile. The simulated values replace the values of the designed law in the checks of force,
//! loads and motion.

use std::f64::consts::TAU;

use crate::cam::{Check, Criterion, LimitKind, Verdict};
use crate::criterion::DependsOn;
use crate::dynamics::{Outcome, Row};
use crate::poly::Extreme;
use crate::synth::design::Design;
use crate::synth::report::reason::Reason;
use crate::synth::verdict::verdict;
use crate::units::Quantity;

/// Relative violation of a bound that is accepted in a simulation, because the simulated points have a finite spacing.
const RESOLVED: f64 = 1e-3;

impl Design {
    /// The design with its verdict from a simulation of the output profile. Where the simulation gives a value, this value replaces the
    /// value of the check. Loss of contact makes the cam unacceptable, unless the scene switches this check off or permits a negative
    /// contact force.
    #[must_use]
    pub fn judged_in(self, run: &Outcome) -> Design {
        let force = run.force.max.abs().max(run.force.min.abs());
        let judged = |check: &Check| {
            let Some(seen) = self.seen(check.name, run) else {
                return check.clone();
            };
            let mut own = Check::of(check.name, seen, check.limit, RESOLVED);
            if check.name == LimitKind::ForceMin {
                own.pass = seen.value >= check.limit - RESOLVED * force;
            }
            own
        };
        let checks: Vec<Check> = self.checks.iter().map(judged).collect();
        let mut every = checks.iter().chain(&self.checks);
        let is_settled = self.infeasible.is_some() || every.all(|check| check.pass);
        let (verdict, reasons) = match is_settled {
            true => (self.verdict, self.reasons),
            // Reasons about violated limits contain the values of the simulation.
            false => {
                let own = verdict(&self.problem, &self.cam, &checks, &self.force);
                (own.0, own.1.into_iter().map(of_run).collect())
            }
        };
        let out = Design {
            verdict,
            reasons,
            checks,
            ..self
        };
        out.losing_contact(run)
    }

    /// Most critical value of a criterion in a simulation; `None` if the simulation does not provide a value.
    fn seen(&self, criterion: Criterion, run: &Outcome) -> Option<Extreme> {
        let largest = |value: &dyn Fn(&Row) -> f64| {
            let at = |row: &Row| Extreme {
                at: row.theta,
                value: value(row),
            };
            let rows = run.rows.iter().map(at);
            rows.max_by(|a, b| a.value.total_cmp(&b.value))
        };
        let exactly = |value: f64, row: Option<Extreme>| row.map(|row| Extreme { value, ..row });
        let force = |sign: f64| largest(&|row: &Row| sign * row.contact_force);
        match criterion {
            // The contact force is zero while contact is lost. The check of the designed law is kept, because the force of this law may be
            // negative.
            Criterion::Limit(LimitKind::ForceMin) if run.contact_lost => None,
            Criterion::Limit(LimitKind::ForceMin) => exactly(run.force.min, force(-1.0)),
            Criterion::Limit(LimitKind::ForceMax) => exactly(run.force.max, force(1.0)),
            Criterion::Limit(LimitKind::Torque) => {
                let most = run.torque.max.max(-run.torque.min);
                exactly(most, largest(&|row: &Row| row.torque.abs()))
            }
            Criterion::Limit(LimitKind::TorqueRate) => steepest(run),
            Criterion::Limit(LimitKind::Power) => largest(&|row: &Row| row.power.abs()),
            Criterion::Limit(LimitKind::PowerMean) => mean_power(run),
            Criterion::Limit(LimitKind::HertzPressure) => run.hertz.as_ref().map(|most| Extreme {
                at: most.theta,
                value: most.contact.pressure,
            }),
            Criterion::RmsError => {
                let in_time = run.force_time.as_ref().map(|error| error.rms_error_n);
                let value = in_time.or(run.force.rms_error)?;
                Some(Extreme { at: 0.0, value })
            }
            Criterion::Limit(kind) => match kind.facts().depends_on {
                DependsOn::Motion(order) => self.motion(order, run),
                _ => None,
            },
            _ => None,
        }
    }

    /// Maximum absolute time derivative of the lift. At constant speed it is computed from the continuous law. With a motor it is computed
    /// from the simulated points, for velocity and acceleration only.
    fn motion(&self, order: usize, run: &Outcome) -> Option<Extreme> {
        if run.shaft.is_none() {
            let most = Extreme::largest(self.cam.derivative_extremes(order));
            let per_time = self.problem.drive.speed.powi(order as i32);
            return Some(most.map(|value| value * per_time));
        }
        let count = run.rows.len();
        let values = (0..count).map(|i| {
            let (row, at) = (&run.rows[i], self.cam.law.svaj(run.rows[i].theta));
            let [before, after] =
                [(i + count - 1) % count, (i + 1) % count].map(|k| run.rows[k].speed);
            let step = TAU * run.period_turns as f64 / count as f64;
            let rate = row.speed * (after - before) / (2.0 * step);
            let value = match order {
                1 => row.speed * at.v,
                2 => row.speed * row.speed * at.a + rate * at.v,
                _ => return None,
            };
            Some(Extreme {
                at: row.theta,
                value: value.abs(),
            })
        });
        let values: Option<Vec<Extreme>> = values.collect();
        values?
            .into_iter()
            .max_by(|a, b| a.value.total_cmp(&b.value))
    }

    /// Adds the loss of contact to the reasons for the verdict, unless another reason already states the loss of contact.
    fn losing_contact(self, run: &Outcome) -> Design {
        let limits = &self.problem.limits;
        let pulls_allowed = limits[LimitKind::ForceMin].is_some_and(|low| low < 0.0);
        if !run.contact_lost || limits.unjudged.contact_force || pulls_allowed {
            return self;
        }
        let known = |r: &Reason| {
            matches!(
                r,
                Reason::ContactLost { .. }
                    | Reason::LiftsOff { .. }
                    | Reason::LiftsOffAsPrescribed { .. }
            )
        };
        let is_known = self.reasons.iter().any(known);
        let share = Quantity::share(run.lost_fraction);
        let own = (!is_known).then_some(Reason::ContactLostInRun { share });
        let others = self.reasons.into_iter();
        let others = others.filter(|r| is_known || *r != Reason::AllHold);
        Design {
            verdict: Verdict::Unacceptable,
            reasons: own.into_iter().chain(others).collect(),
            ..self
        }
    }
}

/// Maximum absolute rate of change of the torque between adjacent simulated points, N·m/rad.
fn steepest(run: &Outcome) -> Option<Extreme> {
    let rates = run.rows.windows(2).map(|rows| Extreme {
        at: rows[0].theta,
        value: ((rows[1].torque - rows[0].torque) / (rows[1].theta - rows[0].theta)).abs(),
    });
    rates.max_by(|a, b| a.value.total_cmp(&b.value))
}

/// Mean power over time, W, computed from points at equal steps of the cam angle.
fn mean_power(run: &Outcome) -> Option<Extreme> {
    let (mut work, mut time) = (0.0, 0.0);
    for row in &run.rows {
        work += row.torque;
        time += 1.0 / row.speed;
    }
    let at = run.rows.first()?.theta;
    Some(Extreme {
        at,
        value: work / time,
    })
}

/// Replaces a reason that suggests a new design by the corresponding reason for a simulation.
fn of_run(reason: Reason) -> Reason {
    match reason {
        Reason::ForceError { error, allowed } => Reason::ForceErrorInRun { error, allowed },
        other => other,
    }
}
