//! Eccentric at 35 rad/s above the lift-off speed with plastic landing: error of the follower's height against wall time, by rapier's time steps and
//! by gaitcam's events, compared with the closed form.
//!
//! A plate of 1 kg lies on the cam. In the frame of the shaft, this is the moving axis of theory §1. Rapier uses the exact contour, a ball whose
//! centre moves on a circle; gaitcam uses the emitted points. The result is part of reports/dynamics.md:
//! `cargo run --release --manifest-path lab/peers/rapier/Cargo.toml > lab/src/experiment/rapier.csv`.

use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::Drive;
use gaitcam::dynamics::contact::{self, Limits, Phase};
use gaitcam::dynamics::recover;
use gaitcam::dynamics::Surface;
use gaitcam::law::Law;

use rapier2d_f64::prelude::*;
use std::f64::consts::TAU;
use std::time::Instant;

const RADIUS: f64 = 0.03;
const ECCENTRICITY: f64 = 0.01;
const SPEED: f64 = 35.0;
const G: f64 = 9.81;
const HALF: f64 = 0.005;

/// Number of angles at which the heights of gaitcam are compared.
const GRID: usize = 1440;
/// Number of runs for the median.
const REPEATS: usize = 5;

fn main() {
    println!("method,size,wall_s_per_turn,rms_height_error_m,largest_height_error_m");
    let land = landing();
    for points in [90, 180, 360, 720, 1440] {
        events(points, land);
    }
    for steps in [360, 1440, 5760, 23_040, 92_160] {
        stepped(steps, land);
    }
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn show(method: &str, size: &str, wall: f64, errors: &[f64]) {
    let largest = errors.iter().fold(0.0_f64, |m, e| m.max(e.abs()));
    let mean = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
    println!(
        "{method},{size},{wall:.3e},{:.3e},{largest:.3e}",
        mean.sqrt()
    );
}

/// Runs gaitcam: smooth lift from the emitted points, then event to event until the motion repeats.
fn events(points: usize, land: f64) {
    let cam = Cam {
        law: Law::harmonic(0.0, &[(0.0, ECCENTRICITY)]),
        follower: Follower::FlatTranslating {
            base_radius: RADIUS,
        },
    };
    let drive = Drive::moving_axis(1.0, G, SPEED);
    let profile = cam.profile(points);
    let mut walls = Vec::new();
    let mut errors = Vec::new();
    for _ in 0..40 * REPEATS + 1 {
        let clock = Instant::now();
        let law = recover(&cam.follower, &profile).expect("a smooth cam").law;
        let surfaces = [Surface::new(law, &drive)];
        let run = contact::run(&surfaces, &drive, 0.0, &Limits::default());
        walls.push(clock.elapsed().as_secs_f64() / run.turns as f64);
        let (from, _) = run.window();
        errors = (0..GRID)
            .filter_map(|i| {
                let angle = from + TAU * (i as f64 + 0.5) / GRID as f64;
                let now = run
                    .stretches
                    .iter()
                    .find(|s| s.from <= angle && angle < s.to)?;
                let lift = match now.phase {
                    Phase::Contact { surface } => surfaces[surface].at(angle).s,
                    Phase::Flight(flight) => flight.at(angle).0,
                    Phase::Parted { .. } => return None,
                };
                Some(RADIUS + lift - exact(angle, land))
            })
            .collect();
    }
    show(
        "gaitcam",
        &format!("{points} points"),
        median(walls),
        &errors,
    );
}

/// Angle at which the flight of the closed form ends, by bisection.
fn landing() -> f64 {
    let leave = (G / (SPEED * SPEED * ECCENTRICITY)).asin();
    let (mut low, mut high) = (leave + 0.5, leave + 4.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if exact(middle, TAU) > RADIUS + ECCENTRICITY * middle.sin() {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Height of the plate in the steady cycle: contact, then a parabola.
fn exact(theta: f64, land: f64) -> f64 {
    let leave = (G / (SPEED * SPEED * ECCENTRICITY)).asin();
    let t = theta.rem_euclid(TAU);
    if t < leave || t > land {
        return RADIUS + ECCENTRICITY * t.sin();
    }
    let s = (t - leave) / SPEED;
    RADIUS + ECCENTRICITY * leave.sin() + SPEED * ECCENTRICITY * leave.cos() * s - 0.5 * G * s * s
}

fn stepped(steps: usize, land: f64) {
    let mut walls = Vec::new();
    let mut errors = Vec::new();
    for _ in 0..REPEATS {
        let (wall, found) = two_turns(steps, land);
        walls.push(wall);
        errors = found;
    }
    show(
        "\"rapier2d, exact circle\"",
        &format!("{steps} steps"),
        median(walls),
        &errors,
    );
}

/// Wall time of one turn, s, and the errors of the second turn, m. The first turn removes the influence of the start.
fn two_turns(steps: usize, land: f64) -> (f64, Vec<f64>) {
    let dt = TAU / SPEED / steps as f64;
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let cam = bodies.insert(
        RigidBodyBuilder::kinematic_position_based()
            .can_sleep(false)
            .build(),
    );
    bodies[cam].set_translation(vector![ECCENTRICITY, 0.0], true);
    let body = ColliderBuilder::ball(RADIUS)
        .friction(0.0)
        .restitution(0.0)
        .build();
    colliders.insert_with_parent(body, cam, &mut bodies);
    let plate = bodies.insert(
        RigidBodyBuilder::dynamic()
            .translation(vector![0.0, RADIUS + HALF])
            .linvel(vector![0.0, SPEED * ECCENTRICITY])
            .lock_rotations()
            .enabled_translations(false, true)
            .can_sleep(false)
            .build(),
    );
    let face = ColliderBuilder::cuboid(0.1, HALF)
        .friction(0.0)
        .restitution(0.0)
        .mass(1.0)
        .build();
    colliders.insert_with_parent(face, plate, &mut bodies);
    let parameters = IntegrationParameters {
        dt,
        length_unit: 0.01,
        ..IntegrationParameters::default()
    };
    let gravity = vector![0.0, -G];
    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut broad = DefaultBroadPhase::new();
    let mut narrow = NarrowPhase::new();
    let mut joints = ImpulseJointSet::new();
    let mut multibody = MultibodyJointSet::new();
    let mut ccd = CCDSolver::new();
    let clock = Instant::now();
    let mut errors = Vec::with_capacity(steps);
    for i in 1..=2 * steps {
        let theta = TAU * i as f64 / steps as f64;
        // The rotation of the ball has no influence, because there is no friction.
        bodies[cam]
            .set_next_kinematic_translation(ECCENTRICITY * vector![theta.cos(), theta.sin()]);
        pipeline.step(
            &gravity,
            &parameters,
            &mut islands,
            &mut broad,
            &mut narrow,
            &mut bodies,
            &mut colliders,
            &mut joints,
            &mut multibody,
            &mut ccd,
            None,
            &(),
            &(),
        );
        if i > steps {
            let height = bodies[plate].translation().y - HALF;
            errors.push(height - exact(theta, land));
        }
    }
    (clock.elapsed().as_secs_f64() / 2.0, errors)
}
