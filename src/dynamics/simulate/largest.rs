//! Maximum loads of a simulation. They include maxima between the rows if the force depends only on the angle.

use super::prepared::Prepared;
use crate::dynamics::outcome::{Loads, Model, Outcome, Pressure, Row};
use crate::dynamics::rigid::hertz;
use crate::dynamics::rigid::touch::Touch;
use crate::dynamics::run::Run;
use crate::poly::{Extreme, stand_in};

/// Fraction of the maximum over the rows below which a peak is ignored.
const NEAR: f64 = 0.99;
/// Relative difference from its neighbours below which a row is a rounding error, not a peak.
const LEVEL: f64 = 1e-9;
/// Relative accuracy of the polynomial approximations whose extremes are computed.
const STAND_IN: f64 = 1e-12;

impl Prepared {
    /// Computes the rows from the forces and heights at equal angles, and the maximum loads.
    pub fn fill(&self, input: &Run, out: &mut Outcome, forces: &[f64], heights: &[f64]) {
        out.rows = self.rows(input, forces, heights);
        let touched = |i: usize| {
            let angle = self.start + self.step * i as f64;
            let at = self.nodes[i % self.nodes.len()];
            self.touch(
                input,
                self.speed(i % self.nodes.len()),
                angle,
                at,
                forces[i],
            )
        };
        let follows = match out.model {
            Model::Rigid => self.shaft.is_none() && self.machine.is_none(),
            Model::Contact => self.shaft.is_none() && out.lost_fraction == 0.0,
            Model::Flexible | Model::Auto => false,
        };
        let largest = |row: fn(&Row) -> f64, load: fn(&Touch) -> f64| {
            let values: Vec<f64> = (0..forces.len())
                .map(|i| row(&out.rows[self.place(i, forces.len())]).abs())
                .collect();
            self.largest(input, &values, follows, load)
        };
        out.loads = Loads {
            normal_force: largest(|r| r.normal_force, |t| t.normal.abs()).value,
            side_thrust: largest(|r| r.side_thrust, |t| t.side_thrust.abs()).value,
        };
        let Some(face) = input.machine.face else {
            return;
        };
        // The pressure increases with the product of force and curvature.
        let product = |t: &Touch| (t.normal * t.curvature).abs();
        let values: Vec<f64> = (0..forces.len()).map(|i| product(&touched(i))).collect();
        let highest = self.largest(input, &values, follows, product);
        let modulus = hertz::modulus(face.cam, face.follower);
        let curvature = self.curvature_at(input, highest.at, forces);
        out.hertz = Some(Pressure {
            theta: self.theta(highest.at, forces.len()),
            contact: hertz::line(highest.value / curvature, face.length, curvature, modulus),
        });
    }

    /// Sum of the curvatures of cam and follower, 1/m, at an angle measured in the direction of rotation. The nearest row determines which
    /// cam is loaded.
    fn curvature_at(&self, input: &Run, angle: f64, forces: &[f64]) -> f64 {
        let row = ((angle - self.start) / self.step).round().max(0.0) as usize;
        let force = forces[row % forces.len()];
        let touch = self.touch(input, self.drive.speed, angle, self.lift.svaj(angle), force);
        touch.curvature.abs()
    }

    /// Converts an angle measured in the direction of rotation to the cam angle, in the range of the rows.
    fn theta(&self, angle: f64, rows: usize) -> f64 {
        let turns = (rows / self.nodes.len()) as f64;
        let wrapped = |x: f64, from: f64| match self.cycle.closed {
            true => from + (x - from).rem_euclid(turns * self.cycle.length),
            false => x,
        };
        match self.reversed {
            true => wrapped(-angle, -(self.start + self.cycle.length)),
            false => wrapped(angle, self.start),
        }
    }

    /// Maximum of a load and its angle. `values` are the loads at the rows, in the order of rotation. If `follows`, maxima between the rows
    /// are included.
    fn largest(
        &self,
        input: &Run,
        values: &[f64],
        follows: bool,
        load: impl Fn(&Touch) -> f64,
    ) -> Extreme {
        let n = values.len();
        let at = |i: usize| self.start + self.step * i as f64;
        let highest = (0..n).max_by(|i, j| values[*i].total_cmp(&values[*j]));
        let highest = highest.unwrap_or_default();
        let mut best = Extreme {
            at: at(highest),
            value: values[highest],
        };
        if !follows || !best.value.is_finite() {
            return best;
        }
        let is_peak = |i: &usize| {
            let beside = [(i + n - 1) % n, (i + 1) % n].map(|k| values[*i] - values[k]);
            let rises = beside.iter().any(|rise| *rise > LEVEL * best.value);
            values[*i] >= NEAR * best.value && beside.iter().all(|rise| *rise >= 0.0) && rises
        };
        let (first, last) = (self.start, self.start + self.cycle.length);
        for i in (0..n).filter(is_peak).collect::<Vec<_>>() {
            let mut ends = [at(i) - self.step, at(i) + self.step];
            if !self.cycle.closed {
                ends = [ends[0].max(first), ends[1].min(last)];
            }
            let breaks = self.cut(ends);
            let value = |x: f64| {
                let motion = self.lift.svaj(x);
                let force = self.drive.force(motion);
                load(&self.touch(input, self.drive.speed, x, motion, force))
            };
            let (_, high) = stand_in(&breaks, STAND_IN, |_, x| value(x)).extremes();
            if high.value > best.value {
                best = high;
            }
        }
        best
    }

    /// Ends of a range of angles, and the breaks of the lift between them.
    fn cut(&self, [from, to]: [f64; 2]) -> Vec<f64> {
        let turns = [-1.0, 0.0, 1.0].map(|k| k * self.cycle.length);
        let breaks = turns
            .iter()
            .flat_map(|turn| self.lift.breaks().iter().map(move |b| b + turn));
        // A break that differs from another only by rounding errors would leave an interval of length zero.
        let room = 1e-9 * (to - from);
        let mut cut = vec![from];
        for b in breaks.filter(|b| *b < to - room) {
            if b > cut[cut.len() - 1] + room {
                cut.push(b);
            }
        }
        cut.push(to);
        cut
    }
}
