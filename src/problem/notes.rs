//! What a user should know of the problem before looking at a result.

use std::f64::consts::TAU;

use super::Problem;
use crate::drive::DriveKind;

/// Differences of the mean force from M·g below this part of it are not worth a remark.
const CLOSURE: f64 = 1e-6;
/// A force below this part of the mean asks the moving axis for free fall.
const FREE_FALL: f64 = 0.02;
/// A turn that differs from the force cycle by less, as a part of it, is that cycle.
const SAME_PERIOD: f64 = 1e-3;

impl Problem {
    /// Remarks on the scene, the speed, the closure of a moving axis and the phase that was found.
    pub fn remarks(&self) -> Vec<String> {
        let mut out = self.given.remarks.clone();
        out.extend(self.stretched());
        if self.drive.kind == DriveKind::MovingAxis {
            out.extend(self.closure());
        }
        if self.phase_is_free {
            out.push(format!(
                "The cam's turn begins at {:.3}° of the force cycle: the phase with the least error.",
                self.phase.to_degrees()
            ));
        }
        out
    }

    fn stretched(&self) -> Option<String> {
        let (speed, target) = (self.given.drive.speed?, self.target.as_ref()?);
        let (turn, cycle) = (TAU / speed, target.curve.period_s);
        ((turn / cycle - 1.0).abs() > SAME_PERIOD).then(|| {
            format!(
                "One turn takes {turn:.4} s, the force cycle {cycle:.4} s: the curve is stretched to the turn."
            )
        })
    }

    /// Closure of the moving axis (theory §1): mean(F) = M g, free fall, the least stroke.
    fn closure(&self) -> Vec<String> {
        let Some(target) = &self.target else {
            return Vec::new();
        };
        let curve = &target.curve;
        let (mass, speed) = (self.drive.mass, self.drive.speed);
        let weight = self.drive.rest_force;
        let mean = curve.mean_n();
        let mut remarks = Vec::new();
        if (mean - weight).abs() > CLOSURE * weight.abs() {
            remarks.push(format!(
                "The mean of the wanted force is {mean:.4} N but the mass weighs {weight:.4} N. A cam lifts and lowers; \
                 over a turn it cannot change the mean, so the error stays at {:.4} N at least. \
                 Set drive.mass = \"auto\" or gait.scale = \"to-mass\".",
                (mean - weight).abs()
            ));
        }
        let n = curve.force_n.len();
        let falling = curve
            .force_n
            .iter()
            .filter(|f| **f < FREE_FALL * mean)
            .count();
        if falling > 0 {
            let seconds = falling as f64 / n as f64 * TAU / speed;
            remarks.push(format!(
                "For {:.0} % of the turn ({seconds:.3} s) the wanted force is near zero: the mass must fall freely there, \
                 which alone needs about {:.0} mm of lift. Both feet together (feet = \"both\") never leave the ground.",
                100.0 * falling as f64 / n as f64,
                1e3 * weight / mass * seconds * seconds / 8.0
            ));
        }
        let hardest = curve
            .force_n
            .iter()
            .fold(0.0_f64, |x, f| x.max((f - mean).abs()))
            / mass;
        let period = TAU / speed;
        let largest_stroke = hardest * period * period / 16.0;
        let stroke = self.limits.stroke.filter(|h| *h > largest_stroke);
        remarks.push(format!(
            "The wanted force accelerates the mass by up to {hardest:.3} m/s², so the stroke is at most {:.1} mm (16 h/T² ≤ max|a|){}.",
            1e3 * largest_stroke,
            if stroke.is_some() { "; the stroke limit cannot bind" } else { "" }
        ));
        remarks
    }
}
