//! Dual active-set method of Goldfarb and Idnani (1983): minimises ½xᵀHx − pᵀx subject to planes aᵀx ≤ b and aᵀx = b.
//!
//! With H = LLᵀ and y = Lᵀx, the solution is the point nearest to L⁻¹p that satisfies the planes zᵀy ≤ b, z = L⁻¹a. The active planes are
//! stored as an orthonormal basis Q and an upper triangular matrix R, with Z = QR for the matrix Z of their normals z. A plane is added or
//! removed in O(n·active) operations.

use crate::band::ArrowFactor;
use crate::basis::{Entries, apply, dense};
use crate::frame::{Apart, Frame, square};
use gaitcam_base::halt::Halt;

/// An active plane with its multiplier.
struct Member {
    /// Index of the inequality; `None` for an equality, which is always active.
    row: Option<usize>,
    bound: f64,
    multiplier: f64,
}

/// Active planes, and the optimum at which they are satisfied as equalities.
pub struct Dual<'a> {
    factor: &'a ArrowFactor,
    /// Unconstrained optimum L⁻¹p, in the coordinates y = Lᵀx.
    free: Vec<f64>,
    /// Coefficients x of the optimum on the active planes.
    pub x: Vec<f64>,
    members: Vec<Member>,
    frame: Frame,
    /// Number of steps so far. The next field is the maximum number of steps.
    pub steps: usize,
    most_steps: usize,
    /// Threshold for linear dependence. The normal of a plane is split into a component in the span of the active planes' normals and the
    /// remaining component. The plane is dependent if the squared length of the remaining component is below this fraction of the normal's
    /// squared length.
    dependent: f64,
}

/// Inequality aᵀx ≤ b of the quadratic program.
pub struct Plane<'p> {
    pub entries: &'p Entries,
    pub bound: f64,
    /// Unit in which an excess over the bound is measured.
    pub unit: f64,
}

/// Error if the method ends before all planes are satisfied.
pub struct DualFailure {
    /// Excess over a plane that depends on the active planes; infinite if the maximum number of steps was reached.
    pub excess: f64,
}

impl<'a> Dual<'a> {
    /// Creates the method without planes. It starts at the unconstrained optimum `x`. The vector `pull` is the linear term p.
    pub fn new(
        factor: &'a ArrowFactor,
        mut pull: Vec<f64>,
        x: Vec<f64>,
        dependent: f64,
        most_steps: usize,
    ) -> Self {
        factor.forward(&mut pull);
        Dual {
            factor,
            free: pull,
            x,
            members: Vec::new(),
            frame: Frame::default(),
            steps: 0,
            most_steps,
            dependent,
        }
    }

    /// Adds a vector to the linear term p of the objective.
    pub fn add_pull(&mut self, mut change: Vec<f64>) {
        self.factor.forward(&mut change);
        for (f, c) in self.free.iter_mut().zip(change) {
            *f += c;
        }
    }

    /// Number of active planes.
    fn active(&self) -> usize {
        self.members.len()
    }

    /// Whether each of the inequalities is active.
    pub fn held(&self, planes: usize) -> Vec<bool> {
        let mut held = vec![false; planes];
        let rows = self.members.iter().filter_map(|m| m.row);
        rows.for_each(|row| held[row] = true);
        held
    }

    /// Adds an active plane; `false` if it depends on the active planes.
    pub fn hold(
        &mut self,
        row: Option<usize>,
        entries: &Entries,
        bound: f64,
        multiplier: f64,
    ) -> bool {
        let z = self.whitened(entries);
        let apart = self.frame.split(&z);
        let independent = apart.left > self.dependent * square(&z);
        if independent {
            self.push(apart, row, bound, multiplier);
        }
        independent
    }

    /// Computes the optimum and the multipliers from the active planes alone.
    pub fn refresh(&mut self) {
        let bounds: Vec<f64> = self.members.iter().map(|m| m.bound).collect();
        let (mut y, away) = self.frame.nearest(&self.free, &bounds);
        self.factor.backward(&mut y);
        self.x = y;
        let multipliers = self.frame.back_substituted(&away);
        for (member, multiplier) in self.members.iter_mut().zip(multipliers) {
            member.multiplier = multiplier;
        }
    }

    /// Computes the optimum and the multipliers, and removes inequalities with negative multipliers, the most negative first.
    pub fn retreat(&mut self) {
        loop {
            self.refresh();
            let worst = (0..self.members.len())
                .filter(|&j| self.members[j].row.is_some() && self.members[j].multiplier < 0.0)
                .min_by(|&a, &b| {
                    let [a, b] = [a, b].map(|j| self.members[j].multiplier);
                    a.total_cmp(&b)
                });
            match worst {
                Some(j) => self.remove(j),
                None => return,
            }
        }
    }

    /// Removes an inequality, if it is active, before its coefficients change.
    pub fn forget(&mut self, row: usize) {
        if let Some(j) = self.members.iter().position(|m| m.row == Some(row)) {
            self.remove(j);
            self.retreat();
        }
    }

    /// Adds violated planes, the most violated first, until no plane is violated by more than `resolved` times its unit.
    pub fn settle(
        &mut self,
        planes: &[Plane],
        resolved: f64,
        most_active: usize,
        halt: &Halt,
    ) -> Result<(), DualFailure> {
        let stuck = DualFailure {
            excess: f64::INFINITY,
        };
        loop {
            let Some(i) = self.most_violated(planes, resolved) else {
                self.refresh();
                return Ok(());
            };
            if halt.is_asked() {
                return Err(stuck);
            }
            self.bring_in(i, planes[i].entries, planes[i].bound)?;
            if self.active() > most_active {
                return Err(stuck);
            }
        }
    }

    /// Index of the most violated inactive plane. All planes are checked in every step, because partial pricing gives no
    /// certificate for minimax problems with 25 spans.
    fn most_violated(&self, planes: &[Plane], resolved: f64) -> Option<usize> {
        let mut worst = (0.0, None);
        for (i, plane) in planes.iter().enumerate() {
            let excess = apply(plane.entries, &self.x) - plane.bound - resolved * plane.unit;
            if excess <= worst.0 * plane.unit {
                continue;
            }
            let gap = (excess - rounding(plane.entries, &self.x)) / plane.unit;
            if gap > worst.0 && !self.is_active(i) {
                worst = (gap, Some(i));
            }
        }
        worst.1
    }

    fn is_active(&self, row: usize) -> bool {
        self.members.iter().any(|m| m.row == Some(row))
    }

    /// Adds a violated inequality to the active planes. Inequalities whose multiplier decreases to zero become inactive.
    pub fn bring_in(
        &mut self,
        row: usize,
        entries: &Entries,
        bound: f64,
    ) -> Result<(), DualFailure> {
        let z = self.whitened(entries);
        let length = square(&z);
        let mut multiplier = 0.0;
        let mut apart = self.frame.split(&z);
        loop {
            self.steps += 1;
            if self.steps > self.most_steps {
                return Err(DualFailure {
                    excess: f64::INFINITY,
                });
            }
            let shift = self.frame.back_substituted(&apart.along);
            let blocking = self.blocking(&shift);
            let excess = apply(entries, &self.x) - bound;
            let full = (apart.left > self.dependent * length).then_some(excess / apart.left);
            let (step, leaves) = match (full, blocking) {
                (Some(full), Some((j, most))) if most < full => (most, Some(j)),
                (Some(full), _) => (full, None),
                (None, Some((j, most))) => (most, Some(j)),
                (None, None) => return Err(DualFailure { excess }),
            };
            for (member, shift) in self.members.iter_mut().zip(&shift) {
                member.multiplier -= step * shift;
            }
            multiplier += step;
            if full.is_some() {
                let mut direction = apart.rest.clone();
                self.factor.backward(&mut direction);
                for (x, p) in self.x.iter_mut().zip(&direction) {
                    *x -= step * p;
                }
            }
            match leaves {
                Some(j) => {
                    self.members.remove(j);
                    self.frame.remove_beside(j, &mut apart);
                }
                None => {
                    self.push(apart, Some(row), bound, multiplier);
                    return Ok(());
                }
            }
        }
    }

    /// The active inequality whose multiplier becomes zero first, and the corresponding step length.
    fn blocking(&self, shift: &[f64]) -> Option<(usize, f64)> {
        let mut first: Option<(usize, f64)> = None;
        for (j, (member, shift)) in self.members.iter().zip(shift).enumerate() {
            if member.row.is_some() && *shift > 0.0 {
                let most = member.multiplier.max(0.0) / shift;
                if first.is_none_or(|b| most < b.1) {
                    first = Some((j, most));
                }
            }
        }
        first
    }

    /// Active inequalities with their multipliers.
    pub fn multipliers(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.members
            .iter()
            .filter_map(|m| Some((m.row?, m.multiplier)))
    }

    fn whitened(&self, entries: &Entries) -> Vec<f64> {
        let mut z = dense(entries, self.x.len());
        self.factor.forward(&mut z);
        z
    }

    fn push(&mut self, apart: Apart, row: Option<usize>, bound: f64, multiplier: f64) {
        self.frame.push(apart);
        self.members.push(Member {
            row,
            bound,
            multiplier,
        });
    }

    fn remove(&mut self, j: usize) {
        self.members.remove(j);
        self.frame.remove(j);
    }
}

/// Upper bound of the rounding error in the value of a row.
pub fn rounding(entries: &Entries, x: &[f64]) -> f64 {
    let size: f64 = entries.iter().map(|&(i, a)| (a * x[i]).abs()).sum();
    4.0 * f64::EPSILON * size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::band::ArrowMatrix;

    const DEPENDENT: f64 = 1e-13;

    /// Factor of the Hessian of ½(x² + 4y²).
    fn factor() -> ArrowFactor {
        let mut matrix = ArrowMatrix::zero(2, 0, 2);
        matrix.add(0, 0, 1.0);
        matrix.add(1, 1, 4.0);
        matrix.factor().unwrap()
    }

    /// Minimises ½(x² + 4y²) − 2x − 4y, whose minimum is at (2, 1), subject to planes.
    fn solved(rows: &[([f64; 2], f64)]) -> Result<([f64; 2], Vec<f64>), DualFailure> {
        let entries: Vec<Entries> = rows
            .iter()
            .map(|r| vec![(0, r.0[0]), (1, r.0[1])])
            .collect();
        let planes = entries.iter().zip(rows);
        let planes: Vec<Plane> = planes
            .map(|(entries, &(_, bound))| Plane {
                entries,
                bound,
                unit: 1.0,
            })
            .collect();
        let factor = factor();
        let mut dual = Dual::new(&factor, vec![2.0, 4.0], vec![2.0, 1.0], DEPENDENT, 20);
        dual.settle(&planes, 1e-12, 2, &Halt::never())?;
        let mut multipliers = vec![0.0; rows.len()];
        dual.multipliers().for_each(|(i, m)| multipliers[i] = m);
        Ok(([dual.x[0], dual.x[1]], multipliers))
    }

    fn near(a: &[f64], b: &[f64]) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14)
    }

    #[test]
    fn an_idle_plane_has_no_multiplier() {
        let (x, multipliers) = solved(&[([1.0, 0.0], 3.0)]).ok().unwrap();
        assert!(near(&x, &[2.0, 1.0]) && multipliers == [0.0]);
    }

    /// The problem with x + y ≤ 2 and the multiplier λ: x = 2 − λ and y = 1 − λ/4, so λ = 0.8.
    #[test]
    fn one_plane_takes_its_share_of_the_gradient() {
        let (x, multipliers) = solved(&[([1.0, 1.0], 2.0)]).ok().unwrap();
        assert!(near(&x, &[1.2, 0.8]) && near(&multipliers, &[0.8]));
    }

    /// x ≤ 1 is added first; with x + 2y ≤ 1 it is satisfied without being active.
    #[test]
    fn a_plane_leaves_when_another_makes_it_idle() {
        let rows = [([1.0, 0.0], 1.0), ([0.1, 0.2], 0.1)];
        let (x, multipliers) = solved(&rows).ok().unwrap();
        // x = 2 − 0.1 λ, 4y = 4 − 0.2 λ and x + 2y = 4 − 0.2 λ = 1.
        assert!(near(&x, &[0.5, 0.25]) && near(&multipliers, &[0.0, 15.0]));
    }

    #[test]
    fn planes_that_exclude_each_other_are_stuck() {
        let rows = [([1.0, 0.0], 0.0), ([-1.0, 0.0], -1.0)];
        assert!(solved(&rows).is_err_and(|stuck| stuck.excess.is_finite()));
    }
}
