//! CAM-DAS: what its manual prints of its examples (theory §5), and misprints of its formulae.

use super::{Row, Rows, strip};
use gaitcam::cam::{Cam, Closure, Conjugate, Follower, ProfilePoint};
use gaitcam::error::Result;
use gaitcam::law::{Extent, Law, Rise, Segment, constant_breadth, program};
use gaitcam_output::overlay;
use gaitcam_output::picture::Picture;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Segments of (motion, lift, degrees).
fn segments(list: &[(Rise, f64, f64)]) -> Vec<Segment> {
    list.iter()
        .map(|(motion, lift, degrees)| Segment {
            motion: motion.clone(),
            lift: *lift,
            angle: degrees.to_radians(),
        })
        .collect()
}

/// Lifts are numbers in the unit printed, mm or degrees.
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

/// Smallest and largest value of a derivative at whole degrees.
fn at_degrees(law: &Law, order: usize) -> (f64, f64) {
    (0..360).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), i| {
        let at = law.svaj(f64::from(i).to_radians());
        let x = [at.s, at.v, at.a, at.j][order];
        (l.min(x), h.max(x))
    })
}

pub(super) fn rows() -> Result<Vec<Row>> {
    let mut rows = Rows::of("Serrano Muñoz (2010), CAM-DAS");
    kinematics(&mut rows)?;
    geometry(&mut rows)?;
    formulae(&mut rows)?;
    Ok(rows.list)
}

fn kinematics(rows: &mut Rows) -> Result<()> {
    let law = example_11()?;
    let units = ["", "per rad", "per rad²", "per rad³"];
    for (order, name, low, high) in [
        (1, "velocity", "-34.82", "34.82"),
        (2, "acceleration", "-121.51", "121.51"),
        (3, "jerk", "-1080.44", "1080.44"),
    ] {
        let (exact, sampled) = (law.extremes(order), at_degrees(&law, order));
        let label = |side: &str| format!("Ejemplo11: {side} {name}");
        rows.sampled(
            &label("largest"),
            units[order],
            high,
            sampled.1,
            exact.1.value,
        );
        rows.sampled(
            &label("smallest"),
            units[order],
            low,
            sampled.0,
            exact.0.value,
        );
    }
    // The fall of 20° in 45° alone decides the printed extremes; half-period motions rise before it.
    let half = [
        (Rise::SemicycloidalStart, 4.0, 72.0),
        (Rise::ConstantVelocity, 12.0, 108.0),
        (Rise::SemicycloidalEnd, 4.0, 72.0),
        (Rise::Dwell, 0.0, 63.0),
        (Rise::Poly4567, -20.0, 45.0),
    ];
    let law = turn(&half)?;
    for (order, name, side, stated) in [
        (1, "velocity", 0, "-55.62"),
        (2, "acceleration", 1, "243.02"),
        (2, "acceleration", 0, "-243.02"),
        (3, "jerk", 1, "2160.88"),
        (3, "jerk", 0, "-1733.58"),
    ] {
        let (exact, sampled) = (law.extremes(order), at_degrees(&law, order));
        let (word, exact, sampled) = if side == 1 {
            ("largest", exact.1.value, sampled.1)
        } else {
            ("smallest", exact.0.value, sampled.0)
        };
        rows.sampled(
            &format!("Ejemplo4: {word} {name}"),
            units[order],
            stated,
            sampled,
            exact,
        );
    }
    for (rise, lift, stated, name) in [
        (Rise::Poly345, 60.0, "107.43", "rise by 3-4-5"),
        (Rise::Poly4567, -60.0, "-125.33", "fall by 4-5-6-7"),
    ] {
        let value = lift * rise.factors()?.cv / 60f64.to_radians();
        rows.stated(
            &format!("fig. 8.19, 60 mm in 60°, {name}: velocity"),
            "mm/rad",
            stated,
            value,
        );
    }
    Ok(())
}

fn geometry(rows: &mut Rows) -> Result<()> {
    let harmonic = |lift: f64| {
        turn(&[
            (Rise::SimpleHarmonic, lift, 180.0),
            (Rise::SimpleHarmonic, -lift, 180.0),
        ])
    };
    let mm = 1e3;
    for radius in [0.005, 0.5] {
        let cam = Cam::new(
            harmonic(0.05)?,
            Follower::RollerTranslating {
                prime_radius: 0.05 + radius,
                offset: 0.0,
                roller_radius: radius,
            },
        )?;
        let (low, high) = cam
            .profile(3600)
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(l, h), p| {
                (l.min(p.rho), h.max(p.rho))
            });
        let words = if radius < 0.1 {
            "not circular"
        } else {
            "nearly circular"
        };
        let reason = format!("CAM-DAS says {words}");
        let label = |what: &str| format!("Ejemplo1RT, roller {} mm: {what}", mm * radius);
        rows.silent(
            &label("largest pressure angle"),
            "°",
            cam.pressure_angle_extremes().1.value.to_degrees(),
            &reason,
        );
        rows.silent(
            &label("smallest radius of curvature"),
            "mm",
            mm * low,
            &reason,
        );
        rows.silent(
            &label("largest radius of curvature"),
            "mm",
            mm * high,
            &reason,
        );
    }
    let double = turn(&[
        (Rise::DoubleHarmonic, 0.1, 180.0),
        (Rise::DoubleHarmonic, -0.1, 180.0),
    ])?;
    let first = Cam::new(double, Follower::FlatTranslating { base_radius: 0.045 })?;
    let pair = Conjugate::new(&first, Closure::Distance(0.225), None)?;
    let second = pair.second.follower.base_radius();
    rows.stated(
        "Ejemplo8DA: second base radius at 225 mm",
        "mm",
        "80",
        mm * second,
    );
    let spread = (0..3600).map(|i| pair.sum(f64::from(i) * TAU / 3600.0) - pair.total);
    let spread = spread.fold(0.0_f64, |w, x| w.max(x.abs()));
    rows.silent(
        "Ejemplo8DA: largest change of the distance",
        "mm",
        mm * spread,
        "the distance is constant",
    );
    let circle = Cam::new(
        harmonic(0.02)?,
        Follower::FlatTranslating { base_radius: 0.03 },
    )?;
    let (low, high) = circle
        .law
        .combination([1.0, 0.0, 1.0, 0.0], 0.03)
        .extremes();
    let reason = "a circle: ρ = Rb + L/2 for base 30 mm, lift 20 mm, both chosen";
    rows.silent(
        "Ejemplo10EX: smallest radius of curvature",
        "mm",
        mm * low.value,
        reason,
    );
    rows.silent(
        "Ejemplo10EX: largest radius of curvature",
        "mm",
        mm * high.value,
        reason,
    );
    let half = segments(&[
        (Rise::SimpleHarmonic, 0.03, 120.0),
        (Rise::Dwell, 0.0, 60.0),
    ]);
    let breadth = 0.15;
    let law = constant_breadth(&half)?;
    let base_radius = 0.5 * (breadth - law.stroke());
    let cam = Cam::new(law, Follower::FlatTranslating { base_radius })?;
    let face = |theta: f64| cam.follower.base_radius() + cam.law.svaj(theta).s;
    let miss = (0..3600)
        .map(|i| f64::from(i) * TAU / 3600.0)
        .map(|x| (face(x) + face(x + 0.5 * TAU) - breadth).abs())
        .fold(0.0, f64::max);
    rows.silent(
        "Ejemplo6: largest change of the breadth",
        "mm",
        mm * miss,
        "breadth = 2Rb + s_max, 150 mm chosen",
    );
    let nine = turn(&[
        (Rise::ModifiedSine, 0.01, 50.0),
        (Rise::Dwell, 0.0, 40.0),
        (Rise::Cycloidal, -0.01, 50.0),
        (Rise::Dwell, 0.0, 40.0),
        (Rise::Poly345, 0.01, 50.0),
        (Rise::Dwell, 0.0, 40.0),
        (Rise::Poly4567, -0.01, 50.0),
        (Rise::Dwell, 0.0, 40.0),
    ])?;
    let cam = Cam::new(
        nine,
        Follower::RollerTranslating {
            prime_radius: 0.042,
            offset: 0.0,
            roller_radius: 0.007,
        },
    )?;
    let sharpest = cam.curvature().convex.value;
    rows.silent(
        "Ejemplo9RT: smallest convex radius",
        "mm",
        mm * sharpest,
        "no undercut, as CAM-DAS says",
    );
    Ok(())
}

fn formulae(rows: &mut Rows) -> Result<()> {
    let semi = Rise::SemicycloidalStart.ends()?.end.at.v;
    let harmonic = format!("{FRAC_PI_2:.4}");
    rows.misprint(
        "semicycloidal, V_i = 0: end speed, printed π/2·L/β",
        "L/β",
        &harmonic,
        semi,
        "π/2 is the semiharmonic's; the semicycloidal leaves with 2L/β",
    );
    rows.silent(
        "semiharmonic, V_i = 0: end speed",
        "L/β",
        Rise::SemiharmonicStart.ends()?.end.at.v,
        "",
    );
    let common = Rise::Freudenstein13.ends()?.start.at.v;
    rows.misprint(
        "Freudenstein 1-3 with 1/54, as commonly printed: speed at the ends",
        "h/β",
        "0.000",
        common,
        "it does not rest at its ends (v = −1/56); with 1/81 it does: freudenstein-1-3-at-rest",
    );
    rows.stated(
        "Freudenstein 1-3 with 1/81: speed at the ends",
        "h/β",
        "0.000",
        Rise::Freudenstein13AtRest.ends()?.start.at.v,
    );
    // An arm's start angle from its sine: CAM-DAS §4.2.4 prints arctan of the ratio.
    let (base, pivot) = (0.03, 0.05);
    let face = Follower::FlatOscillating {
        pivot_distance: pivot,
        face_offset: 0.0,
        base_radius: base,
    };
    let printed = format!("{:.4}", (base / pivot).atan().to_degrees());
    rows.misprint(
        "§4.2.4: start angle of a swinging face, base 30 mm and pivot 50 mm chosen",
        "°",
        &printed,
        face.start_angle().unwrap_or(f64::NAN).to_degrees(),
        "arctan is printed where the geometry, f + c·sin ξ₀ = Rb, asks for arcsin",
    );
    // §4: C = m + A cos[ξ(1 + ξ′)] is printed; the bracket belongs to the cosine alone.
    let (m, arm, xi, speed) = (80.0, 60.0, 2.0_f64, 0.2);
    let printed = format!("{:.4}", m + arm * (xi * (1.0 + speed)).cos());
    rows.misprint(
        "oscillating roller: C for m 80, A 60 mm, ξ 2 rad, ξ′ 0.2, chosen",
        "mm",
        &printed,
        m + arm * xi.cos() * (1.0 + speed),
        "the bracket is misplaced: C = m + A cos ξ (1 + ξ′)",
    );
    Ok(())
}

/// Radius of curvature and pressure angle of Ejemplo1RT under a small and a large roller.
pub(super) fn picture() -> Result<Picture> {
    let law = turn(&[
        (Rise::SimpleHarmonic, 0.05, 180.0),
        (Rise::SimpleHarmonic, -0.05, 180.0),
    ])?;
    let mut curvature = Vec::new();
    let mut pressure = Vec::new();
    for roller_radius in [0.005, 0.5] {
        let follower = Follower::RollerTranslating {
            prime_radius: 0.05 + roller_radius,
            offset: 0.0,
            roller_radius,
        };
        let rows = Cam::new(law.clone(), follower)?.profile(720);
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
