//! Pose of a measured cam in the frame of the measuring machine.

use nalgebra::{Matrix3, Vector3};

/// Rigid motion from the measuring frame to the cam's frame: q = R(angle)(m − pivot) + place. Here m is a measured point, q the same point
/// in the cam's frame, and R the rotation matrix.
#[derive(Debug, Clone, Copy)]
pub struct Pose {
    pub angle: f64,
    pub pivot: [f64; 2],
    pub place: [f64; 2],
}

impl Pose {
    /// Converts a measured point to the cam's frame.
    pub fn seen(&self, m: [f64; 2]) -> [f64; 2] {
        let [x, y] = [m[0] - self.pivot[0], m[1] - self.pivot[1]];
        let (sin, cos) = libm::sincos(self.angle);
        [
            cos * x - sin * y + self.place[0],
            sin * x + cos * y + self.place[1],
        ]
    }

    /// Copy of the pose after a further rotation about `place`, rad, and a further shift, m.
    pub fn moved(&self, [turn, x, y]: [f64; 3]) -> Pose {
        Pose {
            angle: self.angle + turn,
            pivot: self.pivot,
            place: [self.place[0] + x, self.place[1] + y],
        }
    }

    /// Position of the cam's centre in the measuring frame, m.
    pub fn centre(&self) -> [f64; 2] {
        let (sin, cos) = libm::sincos(self.angle);
        let [x, y] = self.place;
        [
            self.pivot[0] - (cos * x + sin * y),
            self.pivot[1] - (cos * y - sin * x),
        ]
    }
}

/// Centre of the least-squares circle through points, m. The equation x² + y² = 2ax + 2by + c is linear in the unknowns a, b and c.
pub fn middle(points: &[[f64; 2]]) -> [f64; 2] {
    let n = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for p in points {
        let [x, y] = [p[0] - mean[0], p[1] - mean[1]];
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        matrix += row * row.transpose();
        right += (x * x + y * y) * row;
    }
    match matrix.lu().solve(&right) {
        Some(c) if c[0].is_finite() && c[1].is_finite() => [mean[0] + c[0], mean[1] + c[1]],
        _ => mean,
    }
}

/// Angle in (−π, π], rad, that differs from `angle` by whole turns.
pub fn wrapped(angle: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    let inside = angle.rem_euclid(turn);
    if inside > 0.5 * turn {
        inside - turn
    } else {
        inside
    }
}
