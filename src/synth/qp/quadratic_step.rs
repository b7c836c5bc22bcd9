//! A small dense quadratic program: ½dᵀGd + qᵀd under planes, G positive definite (Goldfarb and Idnani 1983).

use super::frame::{Frame, square};
use nalgebra::{Cholesky, DVector, Dyn};

/// A plane nᵀd ≤ bound, or nᵀd = bound.
pub struct Plane {
    /// n, of a size near 1.
    pub normal: DVector<f64>,
    /// Its bound.
    pub bound: f64,
    /// Whether it holds as an equality.
    pub equal: bool,
}

/// The optimum with the multipliers of the planes; 0 where a plane does not push.
pub struct Step {
    /// d.
    pub way: DVector<f64>,
    /// Multipliers, by plane.
    pub pushes: Vec<f64>,
}

/// Excess of a plane that counts as none.
const RESOLVED: f64 = 1e-14;
/// A plane whose part outside the span of those that are active is below this share of its square length depends on
/// them.
const DEPENDENT: f64 = 1e-25;
/// A plane that depends on the active ones and is broken by less than this is left to rounding.
const ROUNDING: f64 = 1e-9;
/// Steps for each unknown; two are usual.
const STEPS: usize = 10;

/// Solves with the factor of G; `None` where the planes leave nothing.
pub fn solve(
    factor: &Cholesky<f64, Dyn>,
    gradient: &DVector<f64>,
    planes: &[Plane],
) -> Option<Step> {
    let whitened = |v: &DVector<f64>| {
        let mut out = v.clone();
        factor.l_dirty().solve_lower_triangular_mut(&mut out);
        out.as_slice().to_vec()
    };
    let normals: Vec<Vec<f64>> = planes.iter().map(|p| whitened(&p.normal)).collect();
    let free: Vec<f64> = whitened(gradient).iter().map(|y| -y).collect();
    let mut set = Set {
        planes,
        normals,
        y: free.clone(),
        free,
        frame: Frame::default(),
        members: Vec::new(),
        left_out: vec![false; planes.len()],
    };
    set.settle()?;
    Some(set.answer(factor))
}

struct Set<'a> {
    planes: &'a [Plane],
    normals: Vec<Vec<f64>>,
    free: Vec<f64>,
    y: Vec<f64>,
    frame: Frame,
    /// Active planes with their multipliers.
    members: Vec<(usize, f64)>,
    left_out: Vec<bool>,
}

impl Set<'_> {
    fn excess(&self, i: usize) -> f64 {
        let value: f64 = self.normals[i]
            .iter()
            .zip(&self.y)
            .map(|(n, y)| n * y)
            .sum();
        value - self.planes[i].bound
    }

    fn settle(&mut self) -> Option<()> {
        for i in 0..self.planes.len() {
            if self.planes[i].equal {
                let apart = self.frame.split(&self.normals[i]);
                if apart.left > DEPENDENT * square(&self.normals[i]) {
                    self.frame.push(apart);
                    self.members.push((i, 0.0));
                }
            }
        }
        self.refresh();
        let mut steps = STEPS * self.y.len();
        loop {
            let open = |i: &usize| {
                !self.planes[*i].equal
                    && !self.left_out[*i]
                    && !self.members.iter().any(|m| m.0 == *i)
            };
            let worst = (0..self.planes.len())
                .filter(open)
                .map(|i| (i, self.excess(i)))
                .max_by(|a, b| a.1.total_cmp(&b.1));
            match worst {
                Some((i, excess)) if excess > RESOLVED => self.bring_in(i, &mut steps)?,
                _ => {
                    self.refresh();
                    return Some(());
                }
            }
        }
    }

    /// Law and multipliers anew from the active planes.
    fn refresh(&mut self) {
        let bounds: Vec<f64> = (self.members.iter())
            .map(|m| self.planes[m.0].bound)
            .collect();
        let (y, away) = self.frame.nearest(&self.free, &bounds);
        self.y = y;
        let pushes = self.frame.back_substituted(&away);
        for (member, push) in self.members.iter_mut().zip(pushes) {
            member.1 = push;
        }
    }

    fn bring_in(&mut self, index: usize, steps: &mut usize) -> Option<()> {
        let length = square(&self.normals[index]);
        let mut push = 0.0;
        loop {
            *steps = steps.checked_sub(1)?;
            let apart = self.frame.split(&self.normals[index]);
            let shift = self.frame.back_substituted(&apart.along);
            let mut blocking: Option<(usize, f64)> = None;
            for (j, (member, shift)) in self.members.iter().zip(&shift).enumerate() {
                if !self.planes[member.0].equal && *shift > 0.0 {
                    let most = member.1.max(0.0) / shift;
                    if blocking.is_none_or(|b| most < b.1) {
                        blocking = Some((j, most));
                    }
                }
            }
            let excess = self.excess(index);
            let full = (apart.left > DEPENDENT * length).then_some(excess / apart.left);
            let (step, leaves) = match (full, blocking) {
                (Some(full), Some((j, most))) if most < full => (most, Some(j)),
                (Some(full), _) => (full, None),
                (None, Some((j, most))) => (most, Some(j)),
                (None, None) if excess < ROUNDING => {
                    self.left_out[index] = true;
                    return Some(());
                }
                (None, None) => return None,
            };
            for (member, shift) in self.members.iter_mut().zip(&shift) {
                member.1 -= step * shift;
            }
            push += step;
            if full.is_some() {
                for (y, p) in self.y.iter_mut().zip(&apart.rest) {
                    *y -= step * p;
                }
            }
            match leaves {
                Some(j) => {
                    self.members.remove(j);
                    self.frame.remove(j);
                }
                None => {
                    self.frame.push(apart);
                    self.members.push((index, push));
                    return Some(());
                }
            }
        }
    }

    fn answer(&self, factor: &Cholesky<f64, Dyn>) -> Step {
        let mut way = DVector::from_column_slice(&self.y);
        factor.l_dirty().tr_solve_lower_triangular_mut(&mut way);
        let mut pushes = vec![0.0; self.planes.len()];
        for &(i, push) in &self.members {
            pushes[i] = push;
        }
        Step { way, pushes }
    }
}
