//! Area, centre and unbalance of cams whose integrals are known.

use std::f64::consts::PI;

use gaitcam::cam::{Bore, Cam, Follower, LEAST_WALL};
use gaitcam::law::{Extent, Law, Rise, Segment, program};

/// s = e (1 + sin θ) under a flat face: a circle of radius Rb + e about (e, 0).
fn disc(base: f64, e: f64) -> Cam {
    let law = Law::harmonic(e, &[(0.0, e)]);
    Cam::new(law, Follower::FlatTranslating { base_radius: base }).unwrap()
}

#[test]
fn an_eccentric_disc_has_the_area_and_the_centre_of_its_circle() {
    let (base, e, bore) = (0.03, 0.004, 0.012);
    let solid = PI * (base + e) * (base + e);
    let body = disc(base, e).body(None).unwrap();
    assert!((body.area / solid - 1.0).abs() < 1e-13);
    assert!((body.centroid[0] / e - 1.0).abs() < 1e-12 && body.centroid[1].abs() < 1e-16);
    // A bore about the centre of rotation takes area but no moment.
    let bored = disc(base, e).body(Some(Bore::plain(bore))).unwrap();
    assert!((bored.area / (solid - PI * bore * bore / 4.0) - 1.0).abs() < 1e-13);
    assert!((bored.moment() / (solid * e) - 1.0).abs() < 1e-12);
}

#[test]
fn a_segmented_cam_has_the_area_of_its_fine_polygon() {
    let segment = |lift: f64| Segment {
        motion: Rise::Cycloidal,
        lift,
        angle: 0.5 * PI,
    };
    let dwell = |angle: f64| Segment {
        motion: Rise::Dwell,
        lift: 0.0,
        angle,
    };
    let parts = [
        segment(0.01),
        dwell(0.25 * PI),
        segment(-0.01),
        dwell(0.75 * PI),
    ];
    let law = program(&parts, Extent::TURN).unwrap();
    let follower = Follower::RollerTranslating {
        prime_radius: 0.05,
        offset: 0.003,
        roller_radius: 0.01,
    };
    let cam = Cam::new(law, follower).unwrap();
    let n = 400_000;
    let p = cam.profile(n);
    let (mut area, mut x) = (0.0, 0.0);
    for i in 0..n {
        let (a, b) = (&p[i], &p[(i + 1) % n]);
        let cross = b.x * a.y - b.y * a.x;
        area += cross / 2.0;
        x += (a.x + b.x) * cross / 6.0;
    }
    let body = cam.body(None).unwrap();
    // The polygon misses (2π/n)²/6 of the area.
    assert!((body.area / area - 1.0).abs() < 1e-10);
    assert!((body.centroid[0] - x / area).abs() < 1e-12);
}

#[test]
fn the_hole_takes_the_unbalance_away_and_leaves_its_walls() {
    let (base, e, bore) = (0.03, 0.001, 0.012);
    let cam = disc(base, e);
    let hole = cam.balance_hole(Some(Bore::plain(bore))).unwrap();
    let taken = PI * hole.diameter * hole.diameter / 4.0 * hole.centre[0];
    let moment = PI * (base + e) * (base + e) * e;
    assert!((taken / moment - 1.0).abs() < 1e-10 && hole.centre[1].abs() < 1e-15);
    let radius = 0.5 * hole.diameter;
    assert!(hole.centre[0] - radius - 0.5 * bore >= LEAST_WALL);
    // The circle's own wall, from its centre (e, 0).
    assert!(base + e - (hole.centre[0] - e) - radius >= LEAST_WALL - 1e-5);
    // A disc with too much unbalance for one hole.
    assert_eq!(
        disc(0.012, 0.01).balance_hole(Some(Bore::plain(0.01))),
        None
    );
}
