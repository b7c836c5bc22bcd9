//! Limits of a scene as sums over s, v, a, j and further variables.

use super::asked::{Asked, Follower, Objective};
use super::splines::ORDERS;

/// Limit Σ w s⁽ᵏ⁾ + extra·y ≤ bound + sign (F*(θ) − F₀).
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    pub name: &'static str,
    pub weights: [f64; ORDERS],
    pub bound: f64,
    pub shape: f64,
    /// Index and weight of the further variable.
    pub extra: Option<(usize, f64)>,
    /// Reference value of a relative excess.
    pub scale: f64,
}

/// Further variable: the minimised peak or radius, or the lower end of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extra {
    pub cost: f64,
}

/// Limits as rows, and the further variables.
pub fn limits(asked: &Asked) -> (Vec<Limit>, Vec<Extra>) {
    let mut list = List {
        length: asked.length(),
        ..List::default()
    };
    let limits = &asked.limits;
    if asked.level_is_known() {
        let scale = limits.stroke.unwrap_or(f64::INFINITY).min(list.length);
        list.plain("base circle", [-1.0, 0.0, 0.0, 0.0], 0.0, scale);
    }
    if let Some(stroke) = limits.stroke {
        let lowest = list.variable(0.0);
        list.beside(
            "stroke",
            [1.0, 0.0, 0.0, 0.0],
            stroke,
            stroke,
            (lowest, -1.0),
        );
        list.beside("stroke", [-1.0, 0.0, 0.0, 0.0], 0.0, stroke, (lowest, 1.0));
    }
    let timed = [limits.velocity, limits.acceleration, limits.jerk];
    for (order, limit) in timed.into_iter().enumerate() {
        if let Some(limit) = limit {
            let bound = limit / asked.speed.powi(order as i32 + 1);
            let name = ["velocity", "acceleration", "jerk"][order];
            for sign in [1.0, -1.0] {
                list.plain(name, only(order + 1, sign), bound, bound);
            }
        }
    }
    list.forces(asked);
    list.cam(asked);
    list.peaks(asked);
    (list.limits, list.extras)
}

pub fn only(order: usize, weight: f64) -> [f64; ORDERS] {
    let mut out = [0.0; ORDERS];
    out[order] = weight;
    out
}

#[derive(Default)]
struct List {
    length: f64,
    limits: Vec<Limit>,
    extras: Vec<Extra>,
}

impl List {
    fn variable(&mut self, cost: f64) -> usize {
        self.extras.push(Extra { cost });
        self.extras.len() - 1
    }

    fn plain(&mut self, name: &'static str, weights: [f64; ORDERS], bound: f64, scale: f64) {
        self.limits.push(Limit {
            name,
            weights,
            bound,
            shape: 0.0,
            extra: None,
            scale,
        });
    }

    fn beside(
        &mut self,
        name: &'static str,
        weights: [f64; ORDERS],
        bound: f64,
        scale: f64,
        extra: (usize, f64),
    ) {
        self.plain(name, weights, bound, scale);
        self.limits.last_mut().expect("just pushed").extra = Some(extra);
    }

    fn forces(&mut self, asked: &Asked) {
        let [k, c, m] = asked.weights;
        let mean = asked
            .target
            .as_ref()
            .map_or(asked.rest, |t| t.0.mean_n())
            .abs();
        if let Some(low) = asked.limits.force_min {
            self.plain("force_min", [-k, -c, -m, 0.0], asked.rest - low, mean);
        }
        if let Some(high) = asked.limits.force_max {
            self.plain("force_max", [k, c, m, 0.0], high - asked.rest, mean);
        }
        for (sign, half) in [1.0, -1.0].into_iter().zip(asked.band.into_iter().cycle()) {
            self.plain("band", [k, c, m, 0.0].map(|w| sign * w), half, mean);
            self.limits.last_mut().expect("just pushed").shape = sign;
        }
    }

    /// Adds the rows of the cam: Rb + s + a ≥ ρ for a flat face; ±(v − e) ≤ tan φ (s + D) for a knife edge.
    fn cam(&mut self, asked: &Asked) {
        let limits = &asked.limits;
        let bend = [-1.0, 0.0, -1.0, 0.0];
        match asked.follower {
            Follower::Flat { base } => {
                let rho = limits.curvature.unwrap_or(0.0);
                let cost = match asked.objective {
                    Objective::Size => Some(1.0),
                    _ => None,
                };
                if let Some(cost) = cost {
                    let radius = self.variable(cost);
                    self.beside("curvature", bend, -rho, self.length, (radius, -1.0));
                    self.beside("radius", [0.0; ORDERS], 0.0, self.length, (radius, -1.0));
                    if let Some(most) = limits.prime_radius {
                        self.beside(
                            "prime radius",
                            [0.0; ORDERS],
                            most,
                            self.length,
                            (radius, 1.0),
                        );
                    }
                } else if let (Some(base), Some(rho)) =
                    (base.or(limits.prime_radius), limits.curvature)
                {
                    // The law brings ρ − Rb: where that is the larger, an excess is a part of it, and less than that of ρ.
                    self.plain("curvature", bend, base - rho, base.max(rho - base));
                }
            }
            Follower::Knife { prime, offset } => {
                let rise = (prime * prime - offset * offset).sqrt();
                let sides = [("pressure rise", 1.0), ("pressure fall", -1.0)];
                for ((name, side), angle) in sides.into_iter().zip(limits.pressure_angle) {
                    if let Some(tan) = angle.map(f64::tan) {
                        let bound = tan * rise + side * offset;
                        self.plain(name, [-tan, side, 0.0, 0.0], bound, prime);
                    }
                }
                // At the lowest point the follower turns, so that the limits of both sides hold there: |e| ≤ tan φ (s + D).
                let least = limits.pressure_angle.into_iter().flatten();
                if let Some(tan) = least.map(f64::tan).reduce(f64::min) {
                    let bound = tan * rise - offset.abs();
                    self.plain("pressure turn", [-tan, 0.0, 0.0, 0.0], bound, prime);
                }
            }
        }
    }

    fn peaks(&mut self, asked: &Asked) {
        let [k, c, m] = asked.weights;
        let (weights, shape, scale) = match asked.objective {
            Objective::Peak(order) => (only(order, 1.0), 0.0, self.length),
            Objective::PeakForceError => {
                let mean = asked.target.as_ref().map_or(1.0, |t| t.0.mean_n());
                ([k, c, m, 0.0], 1.0, mean)
            }
            _ => return,
        };
        let peak = self.variable(1.0);
        for sign in [1.0, -1.0] {
            self.beside("peak", weights.map(|w| sign * w), 0.0, scale, (peak, -1.0));
            self.limits.last_mut().expect("just pushed").shape = sign * shape;
        }
    }
}
