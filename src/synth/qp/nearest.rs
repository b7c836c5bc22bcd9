//! The law nearest to one that exceeds a limit by the last digits of the interior-point method.
//!
//! Where limits leave a band of 1e-9 of their size, an exchange of rows ends a hair outside. In the distance of
//! the coefficients the program is perfectly conditioned: the dual active-set method ends inside to rounding,
//! and the objective moves by no more than the hair.

use super::program::{EXTRAS, Limit, PEAK, Program, Solution};

/// A law that misses by more is no last digit.
const HAIR: f64 = 1e-6;

impl Program {
    /// The solution brought inside its limits, where it is a hair outside and that can be done; otherwise as it
    /// is.
    pub(super) fn brought_inside(&self, solution: Solution) -> Solution {
        let outside = solution.violation > self.settings.tolerance && solution.violation < HAIR;
        if !outside || self.cone || !self.settings.exchange.moves_inside {
            return solution;
        }
        let Ok(nearest) = self.nearest_to(&solution).solve() else {
            return solution;
        };
        let mut moved = Solution {
            x: nearest.x,
            ..solution.clone()
        };
        self.raise_peak(&mut moved);
        moved.violation = self.violation(&moved.x, &moved.extra);
        if moved.violation < solution.violation {
            moved
        } else {
            solution
        }
    }

    /// ½‖x − x₀‖² under the limits, the variables beside the law held.
    fn nearest_to(&self, solution: &Solution) -> Program {
        let mut out = self.clone();
        out.hessian.scale(0.0);
        for i in 0..out.hessian.dimension() {
            out.hessian.add(i, i, 1.0);
        }
        out.gradient = solution.x.iter().map(|x| -x).collect();
        out.cost = [0.0; EXTRAS];
        out.limits.retain(|limit| !limit.is_peak());
        for limit in &mut out.limits {
            limit.bound = limit.room(&solution.extra);
            limit.extra = [0.0; EXTRAS];
        }
        out.seeds.clear();
        // The size of a range is that of its bound where its beginning is held.
        out.settings.tolerance *= 0.1;
        out.settings.exchange.moves_inside = false;
        out
    }

    /// Raises the minimised bound to what the law takes.
    fn raise_peak(&self, solution: &mut Solution) {
        let own = solution.extra;
        let level = |limit: &Limit| self.room(limit, &solution.x, &own);
        let mut most = own[PEAK];
        self.each_peak_above(&solution.x, level, |index, peak| {
            let limit = &self.limits[index];
            if limit.is_peak() {
                let excess = peak.value - self.room(limit, &solution.x, &own);
                most = most.max(own[PEAK] - excess / limit.extra[PEAK]);
            }
        });
        solution.extra[PEAK] = most;
    }
}
