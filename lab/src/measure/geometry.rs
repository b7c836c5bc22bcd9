//! Chart (c): curvature of the profile.

use std::ops::{Add, Mul};

use super::Watch;
use crate::chart::Chart;
use gaitcam::cam::{Cam, Follower};
use gaitcam::error::Result;
use gaitcam::law::Law;

const RADIUS: f64 = 0.03;
const ECCENTRICITY: f64 = 0.01;
/// Number of angles at which every method is evaluated.
const ANGLES: usize = 360;

/// Chart for an eccentric disc with a flat face. Its profile is a circle, whose radius is the exact result.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let law = Law::harmonic(ECCENTRICITY, &[(0.0, ECCENTRICITY)]);
    let base_radius = RADIUS - ECCENTRICITY;
    let cam = Cam::new(law, Follower::FlatTranslating { base_radius })?;
    let mut rows = Vec::new();
    for degrees in [10.0, 3.0, 1.0, 0.3, 0.1, 0.01, 0.001] {
        let step = f64::to_radians(degrees);
        let (radii, timing) = watch.time(|| all(|theta| by_differences(&cam, theta, step)));
        let mut row = timing.row(
            "finite differences of the profile",
            format!("{degrees}°"),
            worst(&radii),
        );
        if degrees == 1.0 {
            row.note = "what CAM-DAS does".to_string();
        }
        rows.push(row);
    }
    let (radii, timing) = watch.time(|| all(|theta| by_jets(&cam, theta)));
    rows.push(timing.row("second-order dual numbers", "exact rules", worst(&radii)));
    let (radii, timing) = watch.time(|| all(|theta| cam.point(theta).rho));
    let row = timing.row("closed form", "one point at a time", worst(&radii));
    rows.push(row.noted("x, y, pressure angle included"));
    let radii = || -> Vec<f64> { cam.profile(ANGLES).iter().map(|p| p.rho).collect() };
    let (radii, timing) = watch.time(radii);
    let row = timing.row("closed form", "whole profile", worst(&radii));
    rows.push(row.by_default().noted("x, y, pressure angle included"));
    Ok(Chart {
        file: "speed_accuracy_c".to_string(),
        title: "(c) Curvature of the profile".to_string(),
        task: format!("Radius of curvature at {ANGLES} angles of an eccentric disc of 30 mm, 10 mm eccentricity, with a flat face; the reference is the radius of the disc."),
        error: "largest relative error of the radius".to_string(),
        advice: "Use the closed form. It is the fastest method and exact to rounding. Differences are worst for the smallest steps.".to_string(),
        rows,
        ..Chart::default()
    })
}

fn all(radius: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..ANGLES)
        .map(|i| radius(std::f64::consts::TAU * i as f64 / ANGLES as f64))
        .collect()
}

fn worst(radii: &[f64]) -> f64 {
    radii
        .iter()
        .fold(0.0, |m, r| (r / RADIUS - 1.0).abs().max(m))
}

/// Radius of curvature from first and second central differences of x and y.
fn by_differences(cam: &Cam, theta: f64, step: f64) -> f64 {
    let [a, b, c] = [-step, 0.0, step].map(|d| cam.point(theta + d));
    let first = |l: f64, r: f64| (r - l) / (2.0 * step);
    let second = |l: f64, m: f64, r: f64| (l - 2.0 * m + r) / (step * step);
    let (dx, dy) = (first(a.x, c.x), first(a.y, c.y));
    // The sign is negative, because the cam rotates opposite to the sense in which the profile is traversed.
    -radius(dx, dy, second(a.x, b.x, c.x), second(a.y, b.y, c.y))
}

fn radius(dx: f64, dy: f64, ddx: f64, ddy: f64) -> f64 {
    dx.hypot(dy).powi(3) / (dx * ddy - dy * ddx)
}

/// Value with its first two derivatives.
#[derive(Clone, Copy)]
struct Jet(f64, f64, f64);

impl Add for Jet {
    type Output = Jet;
    fn add(self, o: Jet) -> Jet {
        Jet(self.0 + o.0, self.1 + o.1, self.2 + o.2)
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, o: Jet) -> Jet {
        Jet(
            self.0 * o.0,
            self.1 * o.0 + self.0 * o.1,
            self.2 * o.0 + 2.0 * self.1 * o.1 + self.0 * o.2,
        )
    }
}

/// Radius of curvature from the contact (v, Rb + s), rotated by −θ, with its derivatives. The law supplies the derivatives up to the jerk; the others
/// follow from the product rule.
fn by_jets(cam: &Cam, theta: f64) -> f64 {
    let at = cam.law.svaj(theta);
    let (sin, cos) = theta.sin_cos();
    let (c, s) = (Jet(cos, -sin, -cos), Jet(sin, cos, -sin));
    let minus = Jet(-1.0, 0.0, 0.0);
    let across = Jet(at.v, at.a, at.j);
    let up = Jet(cam.follower.base_radius() + at.s, at.v, at.a);
    let x = c * across + s * up;
    let y = minus * s * across + c * up;
    -radius(x.1, y.1, x.2, y.2)
}
