//! Repetition of the experiment of Campillo de Blas (2017): ideal and real machine, lift-off, bounces, and the errors of its simulation. It makes the
//! text of reports/dynamics.md. All values are computed here except the times of [`peers`], which a benchmark measured.

mod flights;
mod give;
pub(crate) mod motor;
pub(crate) mod peers;
pub(crate) mod pictures;
pub(crate) mod ripple;
mod running;

use gaitcam::cam::Cam;
use gaitcam::drive::Drive;
use gaitcam::dynamics::Surface;
use gaitcam::dynamics::contact::{self, ContactRun, Limits};
use gaitcam::dynamics::recover;
use gaitcam::dynamics::{Machine, Run};
use gaitcam::error::Result;
use gaitcam_test_support::thesis;
use std::f64::consts::TAU;
use std::fmt::{Display, Write};

/// Number of points of an emitted profile in this report.
const POINTS: usize = 1440;

/// Text of reports/dynamics.md. It fails only if one of the two cams cannot be simulated.
pub fn report() -> Result<String> {
    let mut out = Page(String::from(
        "# The experiment of Campillo de Blas (2017), simulated\n\n\
         The experiment uses two cams, a mass of 1 kg and 111 rpm (11.624 rad/s). One cam is an eccentric of 30 mm radius with an eccentricity of 10 mm. The other is a double harmonic of 10 mm with a rise and a fall of 135° and a dwell of 90°. Every number below is computed from the emitted profile points. The law gives the independent reference.\n\n",
    ));
    running::steady_running(&mut out)?;
    running::convergence(&mut out)?;
    flights::lift_off(&mut out)?;
    flights::bounces(&mut out)?;
    give::vibration(&mut out)?;
    flights::two_cams(&mut out)?;
    give::motors(&mut out)?;
    peers::against_rapier(&mut out);
    Ok(out.0)
}

pub(crate) fn cams() -> [(&'static str, Cam, f64); 2] {
    [
        ("eccentric", thesis::eccentric(), 35.0),
        ("double harmonic", thesis::double_harmonic(), 27.0),
    ]
}

pub(crate) fn scene(cam: &Cam, drive: Drive) -> Run {
    Run {
        cam: cam.clone(),
        drive,
        profile: cam.profile(POINTS),
        target: None,
        machine: Machine::default(),
    }
}

fn run_points(cam: &Cam, n: usize, speed: f64, e: f64) -> Result<ContactRun> {
    let drive = thesis::real(speed);
    let law = recover(&cam.follower, &cam.profile(n))?.law;
    Ok(contact::run(
        &[Surface::new(law, &drive)],
        &drive,
        e,
        &Limits::default(),
    ))
}

/// Maximum force difference, N, between the emitted points and the law, over a grid that is not a multiple of the points.
pub(crate) fn worst_force_error(cam: &Cam, n: usize, speed: f64) -> Result<f64> {
    let drive = thesis::real(speed);
    let law = recover(&cam.follower, &cam.profile(n))?.law;
    let angles = (0..7201).map(|i| TAU * f64::from(i) / 7201.0);
    Ok(angles
        .map(|t| (drive.force(law.svaj(t)) - drive.force(cam.law.svaj(t))).abs())
        .fold(0.0, f64::max))
}

/// Text of a Markdown page while it is written.
struct Page(String);

impl Page {
    fn line(&mut self, text: impl Display) {
        let _ = writeln!(self.0, "{text}");
    }

    /// Adds the head of a table. The column names are separated by ` | `.
    fn table(&mut self, columns: &str) {
        self.line(format_args!("| {columns} |"));
        let rules = "---|".repeat(columns.split(" | ").count());
        self.line(format_args!("|{rules}"));
    }

    fn picture(&mut self, name: &str, what: &str) {
        self.line(format_args!("![{what}]({name}.png)\n"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_states_the_lift_off_speeds_and_landings() {
        let text = report().unwrap();
        for number in [
            "31.320920",
            "23.490690",
            "53.208127",
            "204.980906",
            "0.075683849",
            "198.033742",
            "68.4 %",
        ] {
            assert!(text.contains(number), "{number}\n{text}");
        }
        assert!(!text.contains("NaN"));
    }
}
