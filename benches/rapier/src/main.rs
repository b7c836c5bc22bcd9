//! The eccentric at 35 rad/s above lift-off, plastic landing, by rapier's time steps: error against wall
//! time, beside the closed form that the contact model of gaitcam meets to 1e-6°.
//!
//! A plate of 1 kg rides on a ball whose centre is carried round a circle: seen from the shaft block this
//! is the thesis's moving axis. `cargo run --release --manifest-path benches/rapier/Cargo.toml`.

use rapier2d_f64::prelude::*;
use std::f64::consts::TAU;
use std::time::Instant;

const RADIUS: f64 = 0.03;
const ECCENTRICITY: f64 = 0.01;
const SPEED: f64 = 35.0;
const G: f64 = 9.81;
const HALF: f64 = 0.005;

fn main() {
    println!("steps_per_turn,wall_s_per_turn,rms_height_error_m,largest_height_error_m");
    for steps in [360, 1440, 5760, 23_040, 92_160] {
        run(steps);
    }
}

/// Height of the plate's face in the steady cycle: contact, then the parabola.
fn exact(theta: f64) -> f64 {
    let leave = (G / (SPEED * SPEED * ECCENTRICITY)).asin();
    let land = 204.980_906_f64.to_radians();
    let t = theta.rem_euclid(TAU);
    if t < leave || t > land {
        return RADIUS + ECCENTRICITY * t.sin();
    }
    let s = (t - leave) / SPEED;
    RADIUS + ECCENTRICITY * leave.sin() + SPEED * ECCENTRICITY * leave.cos() * s - 0.5 * G * s * s
}

fn run(steps: usize) {
    let dt = TAU / SPEED / steps as f64;
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let cam = bodies.insert(
        RigidBodyBuilder::kinematic_position_based()
            .can_sleep(false)
            .build(),
    );
    let ball = ColliderBuilder::ball(RADIUS)
        .friction(0.0)
        .restitution(0.0)
        .build();
    bodies[cam].set_translation(vector![ECCENTRICITY, 0.0], true);
    colliders.insert_with_parent(ball, cam, &mut bodies);
    let plate = bodies.insert(
        RigidBodyBuilder::dynamic()
            .translation(vector![0.0, RADIUS + HALF])
            .linvel(vector![0.0, SPEED * ECCENTRICITY])
            .lock_rotations()
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
    let (mut largest, mut sum) = (0.0_f64, 0.0);
    // The first turn settles the start, the second is measured.
    for i in 1..=2 * steps {
        let angle = TAU * i as f64 / steps as f64;
        // The ball is moved about the origin; its own turning is without friction and of no account.
        let centre = vector![ECCENTRICITY * angle.cos(), ECCENTRICITY * angle.sin()];
        bodies[cam].set_next_kinematic_translation(centre);
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
        if i <= steps {
            continue;
        }
        let theta = TAU * i as f64 / steps as f64;
        let y = bodies[plate].translation().y - HALF;
        let error = y - exact(theta);
        largest = largest.max(error.abs());
        sum += error * error;
    }
    let wall = clock.elapsed().as_secs_f64() / 2.0;
    println!(
        "{steps},{wall:.3e},{:.3e},{largest:.3e}",
        (sum / steps as f64).sqrt()
    );
}
