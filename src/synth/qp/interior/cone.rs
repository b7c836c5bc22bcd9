//! The cone R ≥ ‖(D, e)‖ in an interior-point method: Nesterov and Todd's scaling of its three unknowns.
//!
//! The scaling W takes the multiplier z and the slack s to the same point, λ = W z = W⁻¹ s; with u∘v =
//! (uᵀv, u₀v₁ + v₀u₁) the central path is λ∘λ = μ (1, 0, 0).

type Three = [f64; 3];

/// Slack and multiplier, both inside the cone.
#[derive(Debug, Clone, Copy)]
pub struct Cone {
    pub s: Three,
    pub z: Three,
}

/// The scaling at a point and the point as it takes it.
#[derive(Debug, Clone, Copy)]
pub struct Scaling {
    /// W, symmetric.
    w: [Three; 3],
    inverse: [Three; 3],
    pub lambda: Three,
}

/// The middle of the cone.
pub const MIDDLE: Three = [1.0, 0.0, 0.0];

impl Cone {
    pub fn gap(&self) -> f64 {
        dot(&self.s, &self.z)
    }

    /// The scaling; `None` where rounding has left the cone.
    pub fn scaling(&self) -> Option<Scaling> {
        let (s_size, z_size) = (size(&self.s)?, size(&self.z)?);
        let s = self.s.map(|v| v / s_size);
        let z = self.z.map(|v| v / z_size);
        let gamma = (0.5 * (1.0 + dot(&s, &z))).sqrt();
        let w = [s[0] + z[0], s[1] - z[1], s[2] - z[2]].map(|v| v / (2.0 * gamma));
        let beta = (s_size / z_size).sqrt();
        let root = (2.0 * (w[0] + 1.0)).sqrt();
        let v = [(w[0] + 1.0) / root, w[1] / root, w[2] / root];
        let mirror = [1.0, -1.0, -1.0];
        let (mut matrix, mut inverse) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        for i in 0..3 {
            for j in 0..3 {
                let reflected = if i == j { mirror[i] } else { 0.0 };
                matrix[i][j] = beta * (2.0 * v[i] * v[j] - reflected);
                inverse[i][j] = (2.0 * mirror[i] * v[i] * v[j] * mirror[j] - reflected) / beta;
            }
        }
        let lambda = times(&matrix, &self.z);
        let finite = lambda.iter().all(|l| l.is_finite());
        finite.then_some(Scaling {
            w: matrix,
            inverse,
            lambda,
        })
    }

    /// Longest step along both directions that stays in the cone.
    pub fn longest(&self, ds: &Three, dz: &Three) -> f64 {
        longest(&self.s, ds).min(longest(&self.z, dz))
    }
}

impl Scaling {
    /// W v.
    pub fn scaled(&self, v: &Three) -> Three {
        times(&self.w, v)
    }

    /// W⁻¹ v.
    pub fn unscaled(&self, v: &Three) -> Three {
        times(&self.inverse, v)
    }

    /// W⁻².
    pub fn weight(&self) -> [Three; 3] {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                (0..3)
                    .map(|k| self.inverse[i][k] * self.inverse[k][j])
                    .sum()
            })
        })
    }

    /// The x with λ∘x = b.
    pub fn divided(&self, b: &Three) -> Three {
        let l = &self.lambda;
        let square = l[0] * l[0] - l[1] * l[1] - l[2] * l[2];
        let first = (l[0] * b[0] - l[1] * b[1] - l[2] * b[2]) / square;
        let rest = |k: usize| (b[k] - first * l[k]) / l[0];
        [first, rest(1), rest(2)]
    }
}

/// u∘v.
pub fn product(u: &Three, v: &Three) -> Three {
    let rest = |k: usize| u[0] * v[k] + v[0] * u[k];
    [dot(u, v), rest(1), rest(2)]
}

pub fn times(m: &[Three; 3], v: &Three) -> Three {
    std::array::from_fn(|i| dot(&m[i], v))
}

/// How far a point is inside the cone, along its middle.
pub fn inside(v: &Three) -> f64 {
    v[0] - v[1].hypot(v[2])
}

fn size(v: &Three) -> Option<f64> {
    let rest = v[1].hypot(v[2]);
    let square = (v[0] - rest) * (v[0] + rest);
    (v[0] > rest && square > 0.0).then(|| square.sqrt())
}

fn dot(a: &Three, b: &Three) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Where v + t d leaves the cone: the first root of (v₀ + t d₀)² = ‖v₁ + t d₁‖².
fn longest(v: &Three, d: &Three) -> f64 {
    let a = d[0] * d[0] - d[1] * d[1] - d[2] * d[2];
    let b = v[0] * d[0] - v[1] * d[1] - v[2] * d[2];
    let c = v[0] * v[0] - v[1] * v[1] - v[2] * v[2];
    let mut first = if d[0] < 0.0 {
        -v[0] / d[0]
    } else {
        f64::INFINITY
    };
    let square = b * b - a * c;
    if square >= 0.0 {
        // a t² + 2 b t + c = 0 without cancellation.
        let q = -(b + b.signum() * square.sqrt());
        for t in [q / a, c / q] {
            if t > 0.0 {
                first = first.min(t);
            }
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scaling_takes_slack_and_multiplier_to_one_point() {
        let cone = Cone {
            s: [2.0, 1.5, -0.3],
            z: [0.7, -0.2, 0.5],
        };
        let scaling = cone.scaling().unwrap();
        let (a, b) = (scaling.scaled(&cone.z), scaling.unscaled(&cone.s));
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-14));
        let quotient = scaling.divided(&cone.z);
        let back = product(&scaling.lambda, &quotient);
        assert!((0..3).all(|k| (back[k] - cone.z[k]).abs() < 1e-14));
        let weight = times(&scaling.weight(), &scaling.scaled(&scaling.scaled(&cone.s)));
        assert!((0..3).all(|k| (weight[k] - cone.s[k]).abs() < 1e-13));
    }

    #[test]
    fn a_step_ends_on_the_surface() {
        let (v, d) = ([1.0, 0.3, 0.2], [-0.1, 0.5, 0.0]);
        let t = longest(&v, &d);
        let end: Three = std::array::from_fn(|k| v[k] + t * d[k]);
        assert!(inside(&end).abs() < 1e-12);
        assert_eq!(longest(&v, &MIDDLE), f64::INFINITY);
    }
}
