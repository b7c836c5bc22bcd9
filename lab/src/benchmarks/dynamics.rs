//! Simulation of the follower: rigid, flexible, and with contact.

use std::hint::black_box;

use gaitcam::dynamics::Surface;
use gaitcam::dynamics::contact::{self, Limits};
use gaitcam::dynamics::flexible::{self, Train};
use gaitcam::dynamics::{FollowerContact, recover};
use gaitcam_test_support::thesis;

use super::table::Report;
use crate::timing::times;

pub(crate) fn dynamics(report: &mut Report) {
    let cam = thesis::double_harmonic();
    let emitted = recover(&cam.follower, &cam.profile(1440)).expect("a curve");
    let drive = thesis::real(thesis::SPEED);
    let torques = || -> Vec<f64> {
        let nodes = black_box(&emitted.nodes);
        let forces: Vec<f64> = nodes.iter().map(|at| drive.force(*at)).collect();
        FollowerContact::of(&cam.follower).torques(0.1, nodes, &forces)
    };
    let seconds = times(torques);
    report.time("dynamics", "rigid, cycle of 1440 points", 5e-6, seconds);
    let train = Train::from_frequency(&drive, 30.0, 0.05).expect("a fine train");
    let seconds = times(|| flexible::steady(black_box(&emitted.law), &drive, &train));
    report.time(
        "dynamics",
        "flexible, exact, from emitted lift to steady state",
        200e-6,
        seconds,
    );
    let fast = thesis::real(27.0);
    let surfaces = [Surface::new(emitted.law, &fast)];
    let bounce = 0.5;
    let seconds = times(|| contact::run(&surfaces, &fast, bounce, &Limits::default()));
    report.time("dynamics", "contact, about thirty impacts", 2e-3, seconds);
}
