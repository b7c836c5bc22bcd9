//! Every limit of a scene as the same thing: a linear row that must hold over a range of angles.

use super::loads::{Loads, Pressure};
use super::nonconvex::{Beyond, Follower, Size};
use super::qp::{FACE_END, LOWEST, Limit, Meaning, OFFSET, PEAK, Program, RADIUS, RISE};
use super::sequence::ENLARGED;
use crate::cam::FollowerKind;
use crate::dynamics::hertz::{STEEL, modulus};
use crate::force::ForceCurve;
use crate::poly::PiecewisePoly;
use crate::problem::{Problem, Size as Sizing};
use crate::scene::Minimise;

/// Limits over the whole turn that are linear in the law.
///
/// `level` says that the law's zero is the base circle: either the drive or a demand fixes the lift, or
/// the caller pins the lowest point. Limits on the distance to the base circle are added only then.
pub fn linear(problem: &Problem, level: bool) -> Vec<Limit> {
    let mut list = List {
        limits: Vec::new(),
        length: problem.length,
    };
    let limits = &problem.limits;
    let speed = problem.drive.speed;
    if problem.above_base_circle && (level || limits.stroke.is_some()) {
        let scale = limits
            .stroke
            .map_or(problem.length, |h| h.min(problem.length));
        list.push_scaled(
            "base_circle",
            [-1.0, 0.0, 0.0, 0.0, 0.0],
            0.0,
            scale,
            Meaning::Structure,
        );
    }
    if let Some(h) = limits.stroke {
        let window = problem.level_is_known().then_some(LOWEST);
        list.push_range("stroke", 0, h, window);
    }
    if let (Some(width), FollowerKind::FlatTranslating) = (limits.face_width, problem.cam.follower)
    {
        // The contact wanders by v (theory §6).
        list.push_range("face_width", 1, width, Some(FACE_END));
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
    let w = problem.drive.weights();
    let force_scale = problem
        .target
        .as_ref()
        .map_or(problem.drive.rest_force.abs(), |t| t.mean_n().abs());
    if let Some(low) = limits.force_min {
        let weights = [-w[0], -w[1], -w[2], 0.0, 0.0];
        let rest = problem.drive.rest_force;
        let meaning = Meaning::Value {
            factor: -1.0,
            offset: rest,
        };
        list.push_scaled("force_min", weights, rest - low, force_scale, meaning);
    }
    if let Some(high) = limits.force_max {
        let weights = [w[0], w[1], w[2], 0.0, 0.0];
        let rest = problem.drive.rest_force;
        let meaning = Meaning::Value {
            factor: 1.0,
            offset: rest,
        };
        list.push_scaled("force_max", weights, high - rest, force_scale, meaning);
    }
    if level {
        on_the_cam(problem, &mut list);
    }
    list.limits
}

/// Limits of the profile that are linear once the cam's size is given (theory §6).
fn on_the_cam(problem: &Problem, list: &mut List) {
    let (cam, limits) = (&problem.cam, &problem.limits);
    if cam.follower == FollowerKind::FlatTranslating {
        if let (Some(base), Some(rho)) = (problem.base_radius(), limits.curvature) {
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
    if let Some(prime) = problem
        .prime_radius()
        .filter(|_| cam.follower.is_translating())
    {
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
/// −(s + a) − Rb ≤ −ρ. Roller: v − e ≤ tan φ₁·(s + D), −(v − e) ≤ tan φ₂·(s + D), Rp = ‖(D, e)‖ (theory §6).
///
/// The radius is what is minimised, or it stays below the scene's limit while something else is.
pub fn with_size(problem: &Problem, program: &mut Program) {
    let limits = &problem.limits;
    let length = problem.length;
    let cost = match problem.objective() {
        Minimise::Size => 1.0,
        Minimise::Weighed(weigh) => weigh.prime_radius.map_or(0.0, |one| 1.0 / one),
        _ => 0.0,
    };
    // A size that no cost holds down is held by its limit: one row, at angle 0.
    // What the sequence for a roller's curvature enlarges in the end is kept free.
    let kept = if bent(problem).is_some() {
        1.0 - 2.0 * ENLARGED
    } else {
        1.0
    };
    let at_most = |radius: f64, variable: usize| {
        let mut limit = Limit::new("prime_radius", [0.0; 5], radius * kept, length);
        limit.extra[variable] = 1.0;
        limit.domain = (0.0, 0.0);
        limit.meaning = same(1.0);
        limit
    };
    let mut base = Limit::new("base_circle", [-1.0, 0.0, 0.0, 0.0, 0.0], 0.0, length);
    base.meaning = Meaning::Structure;
    program
        .limits
        .extend(Some(base).filter(|_| problem.above_base_circle));
    if problem.cam.follower == FollowerKind::FlatTranslating {
        let rho = limits.curvature.unwrap_or(0.0);
        let mut limit = Limit::new("curvature", [-1.0, 0.0, -1.0, 0.0, 0.0], -rho, length);
        limit.extra[RADIUS] = -1.0;
        limit.meaning = Meaning::Value {
            factor: -1.0,
            offset: 0.0,
        };
        program.limits.push(limit);
        // F ≤ π L p²/E*·(Rb + s + a): linear in law and radius together.
        program
            .limits
            .extend(super::machine::pressed(problem, 0.0).map(|mut limit| {
                limit.extra[RADIUS] = limit.weights[2] - problem.drive.weights()[2];
                limit
            }));
        program
            .limits
            .extend(limits.prime_radius.map(|r| at_most(r, RADIUS)));
        program.cost[RADIUS] = cost;
        return;
    }
    let [rise, fall] = problem.sizing_pressure_angles();
    let sides = [
        ("pressure_angle_rise", rise, 1.0),
        ("pressure_angle_fall", fall, -1.0),
    ];
    for (name, angle, side) in sides {
        let t = angle.min(super::sizing::NEARLY_RIGHT).tan();
        let given = problem.cam.offset.unwrap_or(0.0);
        let mut limit = Limit::new(name, [-t, side, 0.0, 0.0, 0.0], side * given, length);
        limit.meaning = Meaning::Sized;
        limit.extra[RISE] = -t;
        if problem.cam.offset.is_none() {
            limit.extra[OFFSET] = -side;
        }
        program.limits.push(limit);
    }
    if let Some(offset) = problem.cam.offset {
        // With the offset given, the prime radius grows with D alone.
        let rise = |r: f64| (r * r - offset * offset).max(0.0).sqrt();
        program
            .limits
            .extend(limits.prime_radius.map(|r| at_most(rise(r), RISE)));
        program.cost[RISE] = cost;
    } else {
        program
            .limits
            .extend(limits.prime_radius.map(|r| at_most(r, RADIUS)));
        program.cost[RADIUS] = cost;
        program.cone = true;
    }
}

/// All limits of the scene that no row of a convex program can say; `None` where there are none.
pub fn beyond_convex(problem: &Problem) -> Option<Beyond> {
    let follower = bent(problem);
    let limits = &problem.limits;
    let roller = match follower {
        Some(Follower::Roller(_)) => Some(problem.cam.roller_radius).filter(|r| *r > 0.0),
        _ => None,
    };
    let most = limits.hertz_pressure;
    let loads = Loads {
        drive: problem.drive,
        torque: limits.torque,
        torque_rate: limits.torque_rate,
        pressure: roller.zip(most).map(|(roller, most)| Pressure {
            spread: std::f64::consts::PI * problem.cam.thickness / modulus(STEEL, STEEL),
            roller,
            most,
        }),
    };
    let loads = (!loads.named().is_empty()).then_some(loads);
    (follower.is_some() || loads.is_some()).then_some(Beyond { follower, loads })
}

/// The follower with those limits of the profile that no row of a convex program can say; `None` where there
/// are none, or where the size is found after the law.
fn bent(problem: &Problem) -> Option<Follower> {
    let (cam, limits) = (&problem.cam, &problem.limits);
    let rho = limits.curvature.unwrap_or(0.0);
    let pitch = rho + cam.roller_radius;
    match cam.follower {
        FollowerKind::RollerTranslating
        | FollowerKind::KnifeTranslating
        | FollowerKind::MushroomTranslating => {
            let offset = cam.offset.unwrap_or(0.0);
            let rise = match problem.prime_radius() {
                Some(prime) => (prime * prime - offset * offset).max(0.0).sqrt(),
                None if problem.size() == Sizing::Sought => 0.0,
                None => return None,
            };
            (pitch > 0.0).then_some(Follower::Roller(Size {
                rise,
                offset,
                rho: pitch,
            }))
        }
        FollowerKind::RollerOscillating | FollowerKind::KnifeOscillating => {
            let (pivot, arm, prime) = (cam.pivot_distance?, cam.arm?, problem.prime_radius()?);
            let cos = (arm * arm + pivot * pivot - prime * prime) / (2.0 * arm * pivot);
            // A sharp edge has no radius of its own; a millionth of the cam's keeps the division finite.
            Some(Follower::Arm {
                pivot,
                arm,
                rest: cos.clamp(-1.0, 1.0).acos(),
                rho: pitch.max(1e-6 * prime),
                tan: [limits.pressure_angle_rise, limits.pressure_angle_fall]
                    .map(|angle| angle.map(f64::tan)),
            })
        }
        FollowerKind::FlatOscillating => {
            let (pivot, base) = (cam.pivot_distance?, cam.base_radius?);
            Some(Follower::Face {
                pivot,
                offset: cam.face_offset,
                rest: ((base - cam.face_offset) / pivot).clamp(-1.0, 1.0).asin(),
                rho,
            })
        }
        _ => None,
    }
}

/// Limits on the distance of the force to the target: the band that the scene asks for, and the largest
/// error where that is what is minimised. Their shapes and cost join the program.
pub fn about_the_target(problem: &Problem, program: &mut Program) -> Vec<Limit> {
    let Some(target) = &problem.target else {
        return Vec::new();
    };
    let w = problem.drive.weights();
    let rest = problem.drive.rest_force;
    let scale = target.mean_n().abs().max(f64::MIN_POSITIVE);
    let mut out = Vec::new();
    // ±(F₀ + w·svaj) ≤ ±edge(θ) + bound
    let mut side = |name: &'static str, sign: f64, edge: &ForceCurve, half: f64| {
        program.shapes.push(PiecewisePoly::combine(
            &[(sign, &edge.curve())],
            -sign * rest,
        ));
        Limit {
            shape: Some(program.shapes.len() - 1),
            meaning: Meaning::Value {
                factor: 1.0,
                offset: half,
            },
            ..Limit::new(
                name,
                [sign * w[0], sign * w[1], sign * w[2], 0.0, 0.0],
                0.0,
                scale,
            )
        }
    };
    if let Some([low, high]) = &problem.band {
        // Told as the band's mean half width.
        let half = 0.5 * (high.mean_n() - low.mean_n());
        out.push(side("band", 1.0, high, half));
        out.push(side("band", -1.0, low, half));
    }
    if problem.objective() == Minimise::PeakForceError {
        out.push(side("peak", 1.0, &target.curve, 0.0).minimised());
        out.push(side("peak", -1.0, &target.curve, 0.0).minimised());
        program.cost[PEAK] = 1.0;
    }
    out
}

/// The law rises or falls steadily between neighbouring points whose lifts differ; `lift_of` gives each
/// point's lift where it is known.
pub fn monotone(problem: &Problem) -> Vec<Limit> {
    let mut points: Vec<(f64, f64)> = problem
        .law
        .points
        .iter()
        .filter_map(|p| Some((p.angle, p.lift.or_else(|| problem.lift_of_force(p.force?))?)))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut list = List {
        limits: Vec::new(),
        length: problem.length,
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

    /// A derivative within a range of the given width, from 0 on or from where a variable says.
    fn push_range(&mut self, name: &'static str, order: usize, width: f64, window: Option<usize>) {
        let mut weights = [0.0; 5];
        weights[order] = 1.0;
        self.push(name, weights, width, same(1.0));
        let Some(variable) = window else { return };
        if let Some(top) = self.limits.last_mut() {
            top.extra[variable] = -1.0;
        }
        weights[order] = -1.0;
        self.push_scaled(name, weights, 0.0, width, Meaning::Structure);
        if let Some(bottom) = self.limits.last_mut() {
            bottom.extra[variable] = 1.0;
        }
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
