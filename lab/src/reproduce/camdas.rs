//! CAM-DAS: printed examples of its manual (theory §5), and discrepancies in its formulas.

use super::{Value, strip};
use gaitcam::cam::{Cam, Closure, Conjugate, Follower, ProfilePoint};
use gaitcam::error::Result;
use gaitcam::law::{Extent, Law, Rise, Segment, constant_breadth, program};
use gaitcam::scene;
use gaitcam_output::overlay;
use gaitcam_output::picture::Picture;
use std::f64::consts::TAU;

/// Millimetres per metre.
const MM: f64 = 1e3;
/// Roller radii of Ejemplo1RT, m.
const ROLLERS: [f64; 2] = [0.005, 0.5];

/// Segments from (motion, lift, degrees).
fn segments(list: &[(Rise, f64, f64)]) -> Vec<Segment> {
    list.iter()
        .map(|(motion, lift, degrees)| Segment {
            motion: motion.clone(),
            lift: *lift,
            angle: degrees.to_radians(),
        })
        .collect()
}

/// Law of a turn from segments; the lifts are in the printed unit, mm or degrees.
fn turn(list: &[(Rise, f64, f64)]) -> Result<Law> {
    program(&segments(list), Extent::TURN)
}

fn example_11() -> Result<Law> {
    let p = Rise::Poly4567;
    turn(&[
        (Rise::Dwell, 0.0, 90.0),
        (p.clone(), 25.0, 90.0),
        (p.clone(), -10.0, 45.0),
        (p.clone(), 10.0, 45.0),
        (p, -25.0, 90.0),
    ])
}

/// Minimum and maximum of a derivative at whole degrees.
fn at_degrees(law: &Law, order: usize) -> (f64, f64) {
    (0..360).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), i| {
        let at = law.svaj(f64::from(i).to_radians());
        let x = [at.s, at.v, at.a, at.j][order];
        (l.min(x), h.max(x))
    })
}

pub(super) fn values() -> Result<Vec<Value>> {
    let mut values = kinematics()?;
    values.extend(arm()?.map(Value::from));
    values.extend(rollers()?.map(Value::from));
    values.extend(faces()?.map(Value::from));
    values.push((MM * eight_segments()?.curvature().convex.value).into());
    values.extend(formulae()?.map(Value::from));
    Ok(values)
}

/// Extreme of a derivative, with the extreme at whole degrees that the manual states.
fn extreme(law: &Law, order: usize, is_high: bool) -> Value {
    let (exact, sampled) = (law.extremes(order), at_degrees(law, order));
    let (exact, sampled) = match is_high {
        true => (exact.1, sampled.1),
        false => (exact.0, sampled.0),
    };
    Value::with(exact.value, format!("{sampled:.4}"))
}

fn kinematics() -> Result<Vec<Value>> {
    let law = example_11()?;
    let both = |order| [true, false].map(|is_high| extreme(&law, order, is_high));
    let mut values: Vec<Value> = (1..=3).flat_map(both).collect();
    // The fall of 20° in 45° alone determines the printed extremes. The rise before it consists of half-period motions.
    let law = turn(&[
        (Rise::SemicycloidalStart, 4.0, 72.0),
        (Rise::ConstantVelocity, 12.0, 108.0),
        (Rise::SemicycloidalEnd, 4.0, 72.0),
        (Rise::Dwell, 0.0, 63.0),
        (Rise::Poly4567, -20.0, 45.0),
    ])?;
    let falls = [(1, false), (2, true), (2, false), (3, true), (3, false)];
    let printed = [(1, true)].into_iter().chain(falls);
    values.extend(printed.map(|(order, is_high)| extreme(&law, order, is_high)));
    for (rise, lift) in [(Rise::Poly345, 60.0), (Rise::Poly4567, -60.0)] {
        values.push((lift * rise.factors()?.cv / 60f64.to_radians()).into());
    }
    let law = turn(&[
        (Rise::Poly345, 60.0, 60.0),
        (Rise::Dwell, 0.0, 120.0),
        (Rise::Poly4567, -60.0, 60.0),
        (Rise::Dwell, 0.0, 120.0),
    ])?;
    let printed = [(2, true), (2, false), (3, true), (3, false)];
    values.extend(printed.map(|(order, is_high)| extreme(&law, order, is_high)));
    Ok(values)
}

/// Law of a turn: rise and return of the same lift, m.
fn there_and_back(motion: Rise, lift: f64) -> Result<Law> {
    turn(&[(motion.clone(), lift, 180.0), (motion, -lift, 180.0)])
}

/// Pressure angles and minimum convex pitch radius of Ejemplo11 with an arm. Its three lengths reproduce the values of fig. 7.19.
fn arm() -> Result<[f64; 3]> {
    let cam = scene::built_in("camdas_11_oscillating_roller")?
        .scene()?
        .design()?
        .cam;
    let (least, most) = cam.pressure_angle_extremes();
    let pitch = cam.curvature().convex.value + cam.follower.roller_radius();
    // CAM-DAS turns clockwise, which swaps the signs.
    let [most, least] = [least, most].map(|angle| -angle.value.to_degrees());
    Ok([most, least, MM * pitch])
}

/// Cam of Ejemplo1RT with a roller on a base circle of 50 mm.
fn example_1(roller_radius: f64) -> Result<Cam> {
    let law = there_and_back(Rise::SimpleHarmonic, 0.05)?;
    let follower = Follower::RollerTranslating {
        prime_radius: 0.05 + roller_radius,
        offset: 0.0,
        roller_radius,
    };
    Cam::new(law, follower)
}

/// Pressure angle and radii of curvature of Ejemplo1RT with both rollers.
fn rollers() -> Result<[f64; 6]> {
    let mut values = [0.0; 6];
    for (three, radius) in values.chunks_exact_mut(3).zip(ROLLERS) {
        let cam = example_1(radius)?;
        let rho = cam.profile(3600).into_iter().map(|p| p.rho);
        let range = |(l, h): (f64, f64), x: f64| (l.min(x), h.max(x));
        let (low, high) = rho.fold((f64::INFINITY, 0.0), range);
        let angle = cam.pressure_angle_extremes().1.value.to_degrees();
        three.copy_from_slice(&[angle, MM * low, MM * high]);
    }
    Ok(values)
}

/// Maximum absolute value of a function over a turn, at 3600 angles.
fn largest(of: impl Fn(f64) -> f64) -> f64 {
    let angles = (0..3600).map(|i| f64::from(i) * TAU / 3600.0);
    angles.map(|x| of(x).abs()).fold(0.0, f64::max)
}

/// Values of Ejemplo8DA (conjugate pair), Ejemplo10EX (circle) and Ejemplo6 (constant breadth).
fn faces() -> Result<[f64; 5]> {
    let law = there_and_back(Rise::DoubleHarmonic, 0.1)?;
    let first = Cam::new(law, Follower::FlatTranslating { base_radius: 0.045 })?;
    let pair = Conjugate::new(&first, Closure::Distance(0.225), None)?;
    let second = pair.second.follower.base_radius();
    let spread = largest(|theta| pair.sum(theta) - pair.total);
    let circle = there_and_back(Rise::SimpleHarmonic, 0.02)?;
    let radius = circle.combination([1.0, 0.0, 1.0, 0.0], 0.03);
    let (low, high) = radius.extremes();
    let half = segments(&[
        (Rise::SimpleHarmonic, 0.03, 120.0),
        (Rise::Dwell, 0.0, 60.0),
    ]);
    let breadth = 0.15;
    let law = constant_breadth(&half)?;
    let base_radius = 0.5 * (breadth - law.stroke());
    let face = |theta: f64| base_radius + law.svaj(theta).s;
    let miss = largest(|x| face(x) + face(x + 0.5 * TAU) - breadth);
    Ok([second, spread, low.value, high.value, miss].map(|x| MM * x))
}

/// Cam of Ejemplo9RT: four motions with dwells.
fn eight_segments() -> Result<Cam> {
    let rest = (Rise::Dwell, 0.0, 40.0);
    let law = turn(&[
        (Rise::ModifiedSine, 0.01, 50.0),
        rest.clone(),
        (Rise::Cycloidal, -0.01, 50.0),
        rest.clone(),
        (Rise::Poly345, 0.01, 50.0),
        rest.clone(),
        (Rise::Poly4567, -0.01, 50.0),
        rest,
    ])?;
    let follower = Follower::RollerTranslating {
        prime_radius: 0.042,
        offset: 0.0,
        roller_radius: 0.007,
    };
    Cam::new(law, follower)
}

fn formulae() -> Result<[f64; 6]> {
    // The start angle of an arm follows from its sine. CAM-DAS §4.2.4 prints the arctangent of the ratio.
    let face = Follower::FlatOscillating {
        pivot_distance: 0.05,
        face_offset: 0.0,
        base_radius: 0.03,
    };
    // Printed in §4: C = m + A cos[ξ(1 + ξ′)]. The factor in parentheses must be outside the cosine.
    let (m, arm, xi, speed) = (80.0, 60.0, 2.0_f64, 0.2);
    Ok([
        Rise::SemicycloidalStart.ends()?.end.at.v,
        Rise::SemiharmonicStart.ends()?.end.at.v,
        Rise::Freudenstein13.ends()?.start.at.v,
        Rise::Freudenstein13AtRest.ends()?.start.at.v,
        face.start_angle().unwrap_or(f64::NAN).to_degrees(),
        m + arm * xi.cos() * (1.0 + speed),
    ])
}

/// Picture of radius of curvature and pressure angle of Ejemplo1RT with a small and a large roller.
pub(super) fn picture() -> Result<Picture> {
    let mut curvature = Vec::new();
    let mut pressure = Vec::new();
    for radius in ROLLERS {
        let rows = example_1(radius)?.profile(720);
        let curve = |pick: fn(&ProfilePoint) -> f64| {
            rows.iter()
                .map(|p| (p.theta.to_degrees(), pick(p)))
                .collect()
        };
        curvature.push(curve(|p| 1e3 * p.rho));
        pressure.push(curve(|p| p.pressure_angle.to_degrees()));
    }
    let names = ["roller 5 mm", "roller 500 mm"].map(str::to_string);
    let rows = [
        strip("radius of curvature, mm", curvature),
        strip("pressure angle, °", pressure),
    ];
    Ok(overlay::diagrams(
        "Ejemplo1RT",
        "nearly a circle only under a large roller",
        &names,
        &rows,
    ))
}
