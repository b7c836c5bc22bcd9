//! Factorisation Z = QR of the normals Z of active planes, with an orthonormal basis Q and an upper triangular matrix R. A plane is added
//! or removed in O(n·planes) operations.

/// Planes of an active set, represented by the factors Q and R of their normals.
#[derive(Default)]
pub struct Frame {
    /// Vectors of the basis Q, one after the other.
    q: Vec<f64>,
    /// Columns of the upper triangular matrix R.
    r: Vec<Vec<f64>>,
}

/// A normal, split into a part in the span of Q and a part orthogonal to Q.
pub struct Apart {
    /// Coordinates of the part in the span of Q.
    pub along: Vec<f64>,
    /// Orthogonal part of the normal.
    pub rest: Vec<f64>,
    /// Squared length of the orthogonal part `rest`.
    pub left: f64,
}

impl Frame {
    /// Splits a normal into the part in the span of Q and the part orthogonal to Q.
    pub fn split(&self, z: &[f64]) -> Apart {
        let mut rest = z.to_vec();
        let mut along = Vec::with_capacity(self.r.len() + 1);
        along.resize(self.r.len(), 0.0);
        let mut left = square(&rest);
        // If most of z cancels, a second pass restores orthogonality up to rounding errors.
        for _ in 0..2 {
            let before = left;
            for (q, d) in self.q.chunks_exact(z.len()).zip(&mut along) {
                let part = dot(q, &rest);
                *d += part;
                for (r, q) in rest.iter_mut().zip(q) {
                    *r -= part * q;
                }
            }
            left = square(&rest);
            if left > 0.25 * before {
                break;
            }
        }
        Apart { along, rest, left }
    }

    /// Adds a plane, given by its split normal.
    pub fn push(&mut self, apart: Apart) {
        let Apart {
            mut along,
            mut rest,
            left,
        } = apart;
        let length = left.sqrt();
        rest.iter_mut().for_each(|x| *x /= length);
        along.push(length);
        self.q.extend_from_slice(&rest);
        self.r.push(along);
    }

    /// Removes plane `j` from Q and R.
    pub fn remove(&mut self, j: usize) {
        self.rotate_out(j, &mut []);
        self.forget_last();
    }

    /// Removes plane `j`. The component of the split normal `apart` along the removed direction is moved to its orthogonal part. This
    /// avoids a second split.
    pub fn remove_beside(&mut self, j: usize, apart: &mut Apart) {
        self.rotate_out(j, &mut apart.along);
        let n = apart.rest.len();
        let last = &self.q[self.r.len() * n..];
        if let Some(part) = apart.along.pop() {
            for (rest, q) in apart.rest.iter_mut().zip(last) {
                *rest += part * q;
            }
        }
        apart.left = square(&apart.rest);
        self.forget_last();
    }

    fn forget_last(&mut self) {
        let planes = self.r.len();
        self.q.truncate(self.q.len() / (planes + 1) * planes);
    }

    /// Removes column `j` from R. Q and the coordinates `along` in Q are rotated until the last vector of Q is the removed direction.
    fn rotate_out(&mut self, j: usize, along: &mut [f64]) {
        let n = self.q.len() / self.r.len();
        self.r.remove(j);
        let k = self.r.len();
        for i in j..k {
            let (a, b) = (self.r[i][i], self.r[i][i + 1]);
            let length = libm::hypot(a, b);
            let (c, s) = (a / length, b / length);
            for column in &mut self.r[i..] {
                let (p, q) = (column[i], column[i + 1]);
                column[i] = c * p + s * q;
                column[i + 1] = c * q - s * p;
            }
            self.r[i].truncate(i + 1);
            if let Some([p, q]) = along.get_mut(i..i + 2) {
                (*p, *q) = (c * *p + s * *q, c * *q - s * *p);
            }
            let (left, right) = self.q[i * n..].split_at_mut(n);
            for (p, q) in left.iter_mut().zip(right) {
                let (a, b) = (*p, *q);
                *p = c * a + s * b;
                *q = c * b - s * a;
            }
        }
    }

    /// Product R⁻¹d, computed by back substitution.
    pub fn back_substituted(&self, d: &[f64]) -> Vec<f64> {
        let mut out = d.to_vec();
        for i in (0..out.len()).rev() {
            out[i] /= self.r[i][i];
            let value = out[i];
            for (x, r) in out[..i].iter_mut().zip(&self.r[i]) {
                *x -= r * value;
            }
        }
        out
    }

    /// Point nearest to `free` in the intersection of all planes. The second vector is the displacement from this point to `free`, in
    /// coordinates of Q. R⁻¹ times the displacement gives the multipliers.
    pub fn nearest(&self, free: &[f64], bounds: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = free.len();
        let mut away: Vec<f64> = self.q.chunks_exact(n).map(|q| dot(q, free)).collect();
        let mut on_planes: Vec<f64> = Vec::with_capacity(away.len());
        for (bound, column) in bounds.iter().zip(&self.r) {
            let i = on_planes.len();
            on_planes.push((bound - dot(&column[..i], &on_planes)) / column[i]);
        }
        for (a, b) in away.iter_mut().zip(&on_planes) {
            *a -= b;
        }
        let mut y = free.to_vec();
        for (q, part) in self.q.chunks_exact(n).zip(&away) {
            for (y, q) in y.iter_mut().zip(q) {
                *y -= part * q;
            }
        }
        (y, away)
    }
}

/// Inner product as four independent sums, for vectorisation.
#[inline]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len().min(b.len());
    let (fours_a, rest_a) = a[..n].as_chunks::<4>();
    let (fours_b, rest_b) = b[..n].as_chunks::<4>();
    let mut sums = [0.0; 4];
    for (a, b) in fours_a.iter().zip(fours_b) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    let tail: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums[0] + sums[1] + (sums[2] + sums[3]) + tail
}

/// Squared length of a vector.
pub fn square(a: &[f64]) -> f64 {
    dot(a, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Linearly independent normals in four dimensions.
    const NORMALS: [[f64; 4]; 4] = [
        [1.0, 2.0, 0.0, -1.0],
        [0.0, 1.0, 1.0, 3.0],
        [2.0, 0.0, -1.0, 1.0],
        [1.0, 1.0, 1.0, 1.0],
    ];

    fn frame(of: &[usize]) -> Frame {
        let mut frame = Frame::default();
        for &i in of {
            let apart = frame.split(&NORMALS[i]);
            frame.push(apart);
        }
        frame
    }

    #[test]
    fn a_split_follows_a_plane_that_leaves() {
        for j in 0..3 {
            let mut frame = frame(&[0, 1, 2]);
            let mut kept = frame.split(&NORMALS[3]);
            frame.remove_beside(j, &mut kept);
            let anew = frame.split(&NORMALS[3]);
            let near = |a: &[f64], b: &[f64]| {
                assert_eq!(a.len(), b.len());
                a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14)
            };
            assert!(near(&kept.along, &anew.along) && near(&kept.rest, &anew.rest));
            assert!((kept.left - anew.left).abs() < 1e-14, "{j}");
        }
    }

    /// The point on two planes that is nearest to (1, 1, 1, 1) satisfies both planes, and the displacement is a combination of their normals.
    #[test]
    fn the_nearest_point_lies_on_the_planes() {
        let bounds = [0.5, -2.0];
        let own = frame(&[0, 2]);
        let (point, away) = own.nearest(&[1.0; 4], &bounds);
        let multipliers = own.back_substituted(&away);
        for (&i, bound) in [0, 2].iter().zip(bounds) {
            assert!((dot(&NORMALS[i], &point) - bound).abs() < 1e-14);
        }
        for k in 0..4 {
            let moved = multipliers[0] * NORMALS[0][k] + multipliers[1] * NORMALS[2][k];
            assert!((1.0 - point[k] - moved).abs() < 1e-14);
        }
    }
}
