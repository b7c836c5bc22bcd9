//! Every limit of a scene as the same thing: a linear row that must hold over a range of angles.

use super::demand::Demand;
use super::problem::{Limit, Meaning, OFFSET, Program, RADIUS, RISE};
use crate::scene::Scene;

/// Limits over the whole turn that are linear in the law.
///
/// `level` says that the law's zero is the base circle: either the drive or a demand fixes the lift, or
/// the caller pins the lowest point. Limits on the distance to the base circle are added only then.
pub fn linear(scene: &Scene, demand: &Demand, level: bool) -> Vec<Limit> {
    let mut list = List {
        limits: Vec::new(),
        length: demand.length,
    };
    let limits = &scene.limits;
    let speed = demand.drive.speed;
    if level || limits.stroke.is_some() {
        list.push(
            "base_circle",
            [-1.0, 0.0, 0.0, 0.0, 0.0],
            0.0,
            Meaning::Structure,
        );
    }
    if let Some(h) = limits.stroke {
        list.push("stroke", [1.0, 0.0, 0.0, 0.0, 0.0], h, same(1.0));
    }
    let timed = [
        ("velocity", 1, limits.velocity),
        ("acceleration", 2, limits.acceleration),
        ("jerk", 3, limits.jerk),
    ];
    for (name, order, limit) in timed {
        if let Some(limit) = limit {
            for sign in [1.0, -1.0] {
                let mut weights = [0.0; 5];
                weights[order] = sign;
                let per_time = speed.powi(order as i32);
                list.push(name, weights, limit / per_time, same(per_time));
            }
        }
    }
    let w = demand.drive.weights();
    let force_scale = demand
        .target
        .as_ref()
        .map_or(demand.drive.rest_force.abs(), |t| t.mean_n().abs());
    if let Some(low) = limits.force_min {
        let weights = [-w[0], -w[1], -w[2], 0.0, 0.0];
        let rest = demand.drive.rest_force;
        let meaning = Meaning::Value {
            factor: -1.0,
            offset: rest,
        };
        list.push_scaled("force_min", weights, rest - low, force_scale, meaning);
    }
    if let Some(high) = limits.force_max {
        let weights = [w[0], w[1], w[2], 0.0, 0.0];
        let rest = demand.drive.rest_force;
        let meaning = Meaning::Value {
            factor: 1.0,
            offset: rest,
        };
        list.push_scaled("force_max", weights, high - rest, force_scale, meaning);
    }
    if level {
        on_the_cam(scene, &mut list);
    }
    list.limits
}

/// Limits of the profile that are linear once the cam's size is given (FACTS §6).
fn on_the_cam(scene: &Scene, list: &mut List) {
    let (cam, limits) = (&scene.cam, &scene.limits);
    if cam.follower == "flat-translating" {
        if let (Some(base), Some(rho)) = (cam.base_radius, limits.curvature) {
            let meaning = Meaning::Value {
                factor: -1.0,
                offset: base,
            };
            list.push_scaled(
                "curvature",
                [-1.0, 0.0, -1.0, 0.0, 0.0],
                base - rho,
                base,
                meaning,
            );
        }
        return;
    }
    if let Some(prime) = prime_radius(scene) {
        let e = cam.offset.unwrap_or(0.0);
        let rise = (prime * prime - e * e).max(0.0).sqrt();
        if let Some(angle) = limits.pressure_angle_rise {
            let t = angle.tan();
            let meaning = Meaning::PrimeRadius { tan: t, offset: e };
            list.push_scaled(
                "pressure_angle_rise",
                [-t, 1.0, 0.0, 0.0, 0.0],
                t * rise + e,
                prime,
                meaning,
            );
        }
        if let Some(angle) = limits.pressure_angle_fall {
            let t = angle.tan();
            let meaning = Meaning::PrimeRadius { tan: t, offset: -e };
            list.push_scaled(
                "pressure_angle_fall",
                [-t, -1.0, 0.0, 0.0, 0.0],
                t * rise - e,
                prime,
                meaning,
            );
        }
    }
}

/// Limits of the profile with the cam's size among the variables, and what the size costs. Flat face:
/// −(s + a) − Rb ≤ −ρ. Roller: v − e ≤ tan φ₁·(s + D), −(v − e) ≤ tan φ₂·(s + D), Rp = ‖(D, e)‖ (FACTS §6).
pub fn with_size(scene: &Scene, demand: &Demand, program: &mut Program) {
    let limits = &scene.limits;
    let length = demand.length;
    let mut base = Limit::new("base_circle", [-1.0, 0.0, 0.0, 0.0, 0.0], 0.0, length);
    base.meaning = Meaning::Structure;
    program.limits.push(base);
    if scene.cam.follower == "flat-translating" {
        let rho = limits.curvature.unwrap_or(0.0);
        let mut limit = Limit::new("curvature", [-1.0, 0.0, -1.0, 0.0, 0.0], -rho, length);
        limit.extra[RADIUS] = -1.0;
        limit.meaning = Meaning::Value {
            factor: -1.0,
            offset: 0.0,
        };
        program.limits.push(limit);
        program.cost[RADIUS] = 1.0;
        return;
    }
    let usual = super::design::USUAL_PRESSURE_ANGLE;
    let sides = [
        (
            "pressure_angle_rise",
            limits.pressure_angle_rise.unwrap_or(usual),
            1.0,
        ),
        (
            "pressure_angle_fall",
            limits.pressure_angle_fall.unwrap_or(usual),
            -1.0,
        ),
    ];
    for (name, angle, side) in sides {
        let t = angle.tan();
        let given = scene.cam.offset.unwrap_or(0.0);
        let mut limit = Limit::new(name, [-t, side, 0.0, 0.0, 0.0], side * given, length);
        limit.meaning = Meaning::Sized;
        limit.extra[RISE] = -t;
        if scene.cam.offset.is_none() {
            limit.extra[OFFSET] = -side;
        }
        program.limits.push(limit);
    }
    if scene.cam.offset.is_some() {
        // With the offset given, the prime radius grows with D alone.
        program.cost[RISE] = 1.0;
    } else {
        program.cost[RADIUS] = 1.0;
        program.cone = true;
    }
}

/// The prime radius where the scene fixes it, directly or through the base radius.
pub fn prime_radius(scene: &Scene) -> Option<f64> {
    let cam = &scene.cam;
    cam.prime_radius
        .or(cam.base_radius.map(|b| b + cam.roller_radius))
}

/// Whether the scene fixes the cam's size, so that the law has to fit it.
pub fn size_is_given(scene: &Scene) -> bool {
    prime_radius(scene).is_some()
}

/// The law rises or falls steadily between neighbouring points whose lifts differ; `lift_of` gives each
/// point's lift where it is known.
pub fn monotone(scene: &Scene, demand: &Demand) -> Vec<Limit> {
    let mut points: Vec<(f64, f64)> = scene
        .law
        .points
        .iter()
        .filter_map(|p| Some((p.angle, p.lift.or_else(|| lift_of_force(demand, p.force?))?)))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut list = List {
        limits: Vec::new(),
        length: demand.length,
    };
    for pair in points.windows(2) {
        let ((from, before), (to, after)) = (pair[0], pair[1]);
        if before == after {
            continue;
        }
        let sign = if after > before { -1.0 } else { 1.0 };
        list.push(
            "monotone",
            [0.0, sign, 0.0, 0.0, 0.0],
            0.0,
            Meaning::Structure,
        );
        if let Some(limit) = list.limits.last_mut() {
            limit.domain = (from, to);
        }
    }
    list.limits
}

/// The lift that belongs to a force where lift alone decides (hydraulic drive, light spring).
pub fn lift_of_force(demand: &Demand, force: f64) -> Option<f64> {
    let w = demand.drive.weights();
    (w[0] != 0.0 && w[1] == 0.0 && w[2] == 0.0).then(|| (force - demand.drive.rest_force) / w[0])
}

struct List {
    limits: Vec<Limit>,
    length: f64,
}

impl List {
    fn push(&mut self, name: &'static str, weights: [f64; 5], bound: f64, meaning: Meaning) {
        let scale = if bound == 0.0 {
            self.length
        } else {
            bound.abs()
        };
        self.push_scaled(name, weights, bound, scale, meaning);
    }

    fn push_scaled(
        &mut self,
        name: &'static str,
        weights: [f64; 5],
        bound: f64,
        scale: f64,
        meaning: Meaning,
    ) {
        self.limits.push(Limit {
            meaning,
            ..Limit::new(name, weights, bound, scale)
        });
    }
}

/// The scene's value is the bound times a factor.
fn same(factor: f64) -> Meaning {
    Meaning::Value {
        factor,
        offset: 0.0,
    }
}
