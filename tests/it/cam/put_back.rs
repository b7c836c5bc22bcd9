//! Independent check of the profile: a follower placed on the emitted profile has the lift of the law.
//!
//! The profile has 1440 points. Between them it is interpolated by polynomials of degree 5 through six neighbours, because the error of straight
//! chords is 1e-7 m for a cam of 5 cm. The follower is placed half way between the samples by separate formulas from the conventions of the
//! interface.

use gaitcam::cam::{BarrelGroove, Cam, Closure, Conjugate, Follower, ProfilePoint, Rollers, Wall};
use gaitcam::law::{Extent, Law, Rise, Segment, constant_breadth, program};
use gaitcam_test_support::{segments, turn};
use std::f64::consts::{PI, TAU};

const POINTS: usize = 1440;
/// Maximum gap or overlap, m.
const GAP: f64 = 1e-7;

fn lopsided(lift: f64) -> Law {
    turn(&[
        ("modified-sine", lift, 110.0),
        ("dwell", 0.0, 40.0),
        ("3-4-5", -0.4 * lift, 80.0),
        ("4-5-6-7", -0.6 * lift, 100.0),
        ("dwell", 0.0, 30.0),
    ])
}

/// A curve through the points, with parameter = index.
struct Curve {
    points: Vec<[f64; 2]>,
    closed: bool,
}

impl Curve {
    fn new(profile: &[ProfilePoint], closed: bool) -> Self {
        Curve {
            points: profile.iter().map(|p| [p.x, p.y]).collect(),
            closed,
        }
    }

    fn at(&self, t: f64) -> [f64; 2] {
        let n = self.points.len() as i64;
        let mut first = t.floor() as i64 - 2;
        if !self.closed {
            first = first.clamp(0, n - 6);
        }
        let mut out = [0.0; 2];
        for i in 0..6 {
            let mut weight = 1.0;
            for j in 0..6 {
                if i != j {
                    weight *= (t - (first + j) as f64) / (i - j) as f64;
                }
            }
            let p = self.points[(first + i).rem_euclid(n) as usize];
            out[0] += weight * p[0];
            out[1] += weight * p[1];
        }
        out
    }

    /// Minimum of `f` over the curve: best sample, then golden-section search around it.
    fn least(&self, f: impl Fn([f64; 2]) -> f64) -> f64 {
        let best = (0..self.points.len())
            .min_by(|&i, &j| f(self.points[i]).total_cmp(&f(self.points[j])))
            .unwrap() as f64;
        let top = (self.points.len() - 1) as f64;
        let (mut a, mut b) = (best - 1.5, best + 1.5);
        if !self.closed {
            (a, b) = (a.max(0.0), b.min(top));
        }
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..60 {
            let (x, y) = (b - ratio * (b - a), a + ratio * (b - a));
            if f(self.at(x)) < f(self.at(y)) {
                b = y;
            } else {
                a = x;
            }
        }
        f(self.at(0.5 * (a + b)))
    }
}

/// Point in the frame of the cam: R(−θ)·p.
fn into_cam(theta: f64, p: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = theta.sin_cos();
    [cos * p[0] + sin * p[1], cos * p[1] - sin * p[0]]
}

/// Position of the follower in space for a lift: centre of the circle, or normal of the face with its distance.
enum Stand {
    Centre([f64; 2]),
    Face([f64; 2], f64),
}

fn stand(follower: &Follower, s: f64) -> Stand {
    match *follower {
        Follower::FlatTranslating { base_radius } => Stand::Face([0.0, 1.0], base_radius + s),
        Follower::RollerTranslating {
            prime_radius,
            offset,
            ..
        }
        | Follower::MushroomTranslating {
            prime_radius,
            offset,
            ..
        } => Stand::Centre([offset, (prime_radius.powi(2) - offset.powi(2)).sqrt() + s]),
        Follower::RollerOscillating {
            pivot_distance: c,
            arm,
            prime_radius,
            ..
        }
        | Follower::MushroomOscillating {
            pivot_distance: c,
            arm,
            prime_radius,
            ..
        } => {
            let m = c.abs();
            let xi =
                ((arm * arm + m * m - prime_radius * prime_radius) / (2.0 * arm * m)).acos() + s;
            Stand::Centre([c - c.signum() * arm * xi.cos(), arm * xi.sin()])
        }
        Follower::FlatOscillating {
            pivot_distance: c,
            face_offset,
            base_radius,
        } => {
            let xi = ((base_radius - face_offset) / c.abs()).asin() + s;
            // The arm points from the pivot to (−σ cos ξ, sin ξ); the face's normal is square to it.
            let normal = [c.signum() * xi.sin(), xi.cos()];
            Stand::Face(normal, face_offset + c.abs() * xi.sin())
        }
        _ => unreachable!("straight cams are put back elsewhere"),
    }
}

fn largest_gap(cam: &Cam, profile: &[ProfilePoint], half_turn: bool) -> f64 {
    let curve = Curve::new(profile, true);
    let flip = if half_turn { -1.0 } else { 1.0 };
    (0..POINTS)
        .map(|i| {
            let theta = TAU * (i as f64 + 0.5) / POINTS as f64;
            let s = cam.law.svaj(theta).s;
            match stand(&cam.follower, s) {
                Stand::Centre(c) => {
                    let [x, y] = into_cam(theta, [flip * c[0], flip * c[1]]);
                    let near = curve.least(|p| (p[0] - x).hypot(p[1] - y));
                    (near - cam.follower.roller_radius()).abs()
                }
                Stand::Face(n, distance) => {
                    let [nx, ny] = into_cam(theta, [flip * n[0], flip * n[1]]);
                    let reach = -curve.least(|p| -(nx * p[0] + ny * p[1]));
                    (reach - distance).abs()
                }
            }
        })
        .fold(0.0, f64::max)
}

fn translating() -> [Follower; 4] {
    [
        Follower::FlatTranslating { base_radius: 0.05 },
        Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: 0.008,
            roller_radius: 0.01,
        },
        Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: -0.004,
            roller_radius: 0.0,
        },
        Follower::MushroomTranslating {
            prime_radius: 0.24,
            offset: 0.003,
            arc_radius: 0.2,
        },
    ]
}

fn oscillating(pivot: f64) -> [Follower; 4] {
    [
        Follower::RollerOscillating {
            pivot_distance: pivot,
            arm: 0.08,
            prime_radius: 0.05,
            roller_radius: 0.01,
        },
        Follower::RollerOscillating {
            pivot_distance: pivot,
            arm: 0.08,
            prime_radius: 0.05,
            roller_radius: 0.0,
        },
        Follower::MushroomOscillating {
            pivot_distance: pivot,
            arm: 0.11,
            prime_radius: 0.09,
            arc_radius: 0.05,
        },
        Follower::FlatOscillating {
            pivot_distance: pivot,
            face_offset: 0.006,
            base_radius: 0.04,
        },
    ]
}

fn rotating() -> Vec<Cam> {
    let with = |followers: [Follower; 4], lift: f64| {
        followers.map(|follower| Cam::new(lopsided(lift), follower).unwrap())
    };
    [
        with(translating(), 0.02),
        with(oscillating(0.1), 0.25),
        with(oscillating(-0.1), 0.25),
    ]
    .into_iter()
    .flatten()
    .collect()
}

#[test]
fn every_follower_stands_on_its_emitted_profile() {
    for cam in rotating() {
        let gap = largest_gap(&cam, &cam.profile(POINTS), false);
        println!("{}: gap {gap:.2e} m", cam.follower.name());
        assert!(gap < GAP, "{} {:?}", cam.follower.name(), cam.follower);
    }
}

#[test]
fn both_members_of_every_conjugate_pair_hold_the_follower() {
    for cam in rotating() {
        if cam.follower.roller_radius() == 0.0 && !cam.follower.is_flat() {
            continue;
        }
        let base = match cam.follower {
            Follower::MushroomTranslating { .. } => 0.05,
            _ => 0.045,
        };
        let roller = cam.follower.roller_radius();
        for second in [None, Some(0.8 * roller)] {
            let pair = Conjugate::new(&cam, Closure::SecondBaseRadius(base), second).unwrap();
            let gap = largest_gap(&pair.second, &pair.second_profile(POINTS), true);
            println!("{}: second gap {gap:.2e} m", cam.follower.name());
            assert!(gap < GAP, "{:?}", pair.second.follower);
            for i in 0..POINTS {
                let theta = TAU * i as f64 / POINTS as f64;
                assert!((pair.sum(theta) - pair.total).abs() < 1e-12);
            }
            // Closed by its total, the same second cam comes back.
            let closure = if cam.follower.is_oscillating() {
                Closure::Angle(pair.total)
            } else {
                Closure::Distance(pair.total)
            };
            let again = Conjugate::new(&cam, closure, second).unwrap();
            let difference = again.second.follower.base_radius() - base;
            assert!(difference.abs() < 1e-12);
        }
    }
}

#[test]
fn constant_breadth_is_constant_over_all_directions() {
    // theory §5, Ejemplo6: SHM 120°, dwell 60°, SHM 120°, dwell 60°; breadth = 2Rb + s_max.
    let half = segments(&[("simple-harmonic", 0.03, 120.0), ("dwell", 0.0, 60.0)]);
    let breadth = 0.13;
    let cam = between_faces(&half, breadth);
    assert!((cam.follower.base_radius() - 0.05).abs() < 1e-15);
    // The support in every direction, from the cam's own contacts, found without the law of the face.
    let curve = Curve::new(&cam.profile(4 * POINTS), true);
    for i in 0..997 {
        let (ny, nx) = (TAU * f64::from(i) / 997.0).sin_cos();
        let reach = |sx: f64, sy: f64| -curve.least(|p| -(sx * p[0] + sy * p[1]));
        let width = reach(nx, ny) + reach(-nx, -ny);
        assert!((width - breadth).abs() < 1e-9, "{i} {width}");
    }
    let smooth = between_faces(&segments(&[("3-4-5", 0.03, 180.0)]), breadth);
    let pair = Conjugate::new(&smooth, Closure::Distance(breadth), None).unwrap();
    for (p, q) in smooth
        .profile(POINTS)
        .iter()
        .zip(pair.second_profile(POINTS).iter().cycle().skip(POINTS / 2))
    {
        // The conjugate of a constant-breadth cam is the cam itself.
        assert!((p.x - q.x).hypot(p.y - q.y) < 1e-12);
    }
}

/// Cam of constant breadth between two faces, from the law of its first half turn.
fn between_faces(half: &[Segment], breadth: f64) -> Cam {
    let law = constant_breadth(half).unwrap();
    let base_radius = 0.5 * (breadth - law.stroke());
    Cam::new(law, Follower::FlatTranslating { base_radius }).unwrap()
}

#[test]
fn a_cam_of_constant_diameter_holds_both_rollers() {
    let half = segments(&[("cycloidal", 0.03, 120.0), ("dwell", 0.0, 60.0)]);
    let law = constant_breadth(&half).unwrap();
    let follower = Follower::RollerTranslating {
        prime_radius: 0.5 * (0.15 - law.stroke()),
        offset: 0.0,
        roller_radius: 0.01,
    };
    let cam = Cam::new(law, follower).unwrap();
    for i in 0..POINTS {
        let theta = TAU * i as f64 / POINTS as f64;
        let (p, q) = (cam.point(theta), cam.point(theta + PI));
        let across = (p.pitch_x - q.pitch_x).hypot(p.pitch_y - q.pitch_y);
        assert!((across - 0.15).abs() < 1e-12);
    }
    assert!(largest_gap(&cam, &cam.profile(POINTS), false) < GAP);
}

#[test]
fn rollers_stand_on_straight_cams() {
    let length = 0.3;
    let quarter = |motion: Rise, lift: f64| Segment {
        motion,
        lift,
        angle: 0.25 * length,
    };
    let law = program(
        &[
            quarter(Rise::Poly345, 0.03),
            quarter(Rise::Dwell, 0.0),
            quarter(Rise::Cycloidal, -0.02),
            quarter(Rise::Dwell, 0.0),
        ],
        Extent::Length(length),
    )
    .unwrap();
    let follower = Follower::TranslatingCam {
        base_height: 0.01,
        roller_radius: 0.008,
    };
    let cam = Cam::new(law, follower).unwrap();
    let curve = Curve::new(&cam.profile(POINTS), false);
    for i in 0..POINTS - 1 {
        let travel = length * (i as f64 + 0.5) / (POINTS - 1) as f64;
        let centre = [travel, 0.01 + 0.008 + cam.law.svaj(travel).s];
        let near = curve.least(|p| (p[0] - centre[0]).hypot(p[1] - centre[1]));
        assert!((near - 0.008).abs() < GAP, "{travel} {near}");
    }
}

#[test]
fn rollers_stand_between_the_walls_of_a_barrel_groove() {
    // A cylinder of radius R_f about a radial axis touches the wall: over all points of the wall taken at
    // many θ and depths, the least distance from the roller's axis is R_f.
    let up = Segment {
        motion: Rise::BerzakD,
        lift: 0.04,
        angle: TAU,
    };
    let down = Segment {
        lift: -0.04,
        ..up.clone()
    };
    let law = program(&[up, down], Extent::Turns(2)).unwrap();
    for rollers in [
        Rollers::One { radius: 0.005 },
        Rollers::TwoEccentric {
            radius: 0.005,
            eccentricity: 0.0004,
        },
    ] {
        let groove = BarrelGroove::new(law.clone(), 0.021, 0.03, rollers).unwrap();
        for wall in [Wall::Upper, Wall::Lower] {
            for i in 0..60 {
                let theta = 2.0 * TAU * (f64::from(i) + 0.5) / 60.0;
                let z = law.svaj(theta).s + groove.axis_offset(wall);
                let direction = [theta.cos(), -theta.sin()];
                for radius in [0.021, 0.026, 0.03] {
                    let distance = |t: f64| {
                        let p = groove.wall_point(t, radius, wall);
                        let across = p[0] * direction[1] - p[1] * direction[0];
                        across.hypot(p[2] - z)
                    };
                    let least = (-400..=400)
                        .map(|k| distance(theta + 1e-3 * f64::from(k)))
                        .fold(f64::INFINITY, f64::min);
                    let own = distance(theta);
                    assert!(
                        (own - 0.005).abs() < 1e-15 && own - least < 1e-12,
                        "{theta} {own} {least}"
                    );
                }
            }
        }
    }
}
