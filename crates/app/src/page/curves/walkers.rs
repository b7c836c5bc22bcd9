//! Curves of the walkers of a population in the force diagram.

use gaitcam::synth::Design;
use gaitcam_output::curve;

use super::{Line, Sample, line_of};

/// Envelope of the target forces of all walkers, and the target force of the walker with the maximum error.
///
/// The target force of each walker is converted linearly to the scale of the displayed force. Where the displayed force equals the converted target
/// force, the walker has no force error.
pub fn lines(design: &Design, samples: &[Sample]) -> Vec<Line> {
    let Some((all, report)) = design
        .problem
        .walkers
        .as_deref()
        .zip(design.population.as_ref())
    else {
        return Vec::new();
    };
    let rest = design.problem.drive.rest_force;
    let wanted = |i: usize, theta: f64| {
        let walker = &all.each[i];
        let later = report.each[i].phase_rad - design.problem.phase;
        let force = curve::target_at(&walker.target, &design.cam.law, theta + later);
        rest + (force - walker.drive.rest_force) / walker.factor
    };
    let edge = |better: fn(f64, f64) -> f64| {
        move |s: &Sample| {
            let each = (0..all.each.len()).map(|i| wanted(i, s.theta));
            each.reduce(better).unwrap_or(f64::NAN)
        }
    };
    vec![
        line_of("low", samples, edge(f64::min)),
        line_of("high", samples, edge(f64::max)),
        line_of("worst", samples, |s| wanted(report.worst, s.theta)),
    ]
}

#[cfg(test)]
mod tests {
    use crate::page::curves::{Colour, Curves, curves};
    use gaitcam::scene;

    /// Mean square of the difference of two lines by the trapezoidal rule, at the angles of the page.
    fn mean_square(curves: &Curves, a: &str, b: &str) -> f64 {
        let line = |role: &str| {
            &curves.panels[0]
                .lines
                .iter()
                .find(|l| l.role == role)
                .unwrap()
                .y
        };
        let (a, b) = (line(a), line(b));
        let at = |i: usize| (a[i].unwrap() - b[i].unwrap()).powi(2);
        let theta = |i: usize| curves.theta[i].unwrap();
        let steps = 1..curves.theta.len();
        let sum: f64 = steps
            .map(|i| 0.5 * (at(i) + at(i - 1)) * (theta(i) - theta(i - 1)))
            .sum();
        sum / curves.length
    }

    #[test]
    fn the_force_of_the_cam_is_as_far_from_that_of_the_worst_walker_as_his_error_says() {
        let scene = scene::built_in("footbridge").unwrap().scene().unwrap();
        let scene = scene
            .with("gait.step_frequency", "1.4 Hz:2.4 Hz:6")
            .unwrap();
        let design = scene.with("law.robust", "worst").unwrap().design().unwrap();
        let curves = curves(&design, Colour::None);
        let report = design.population.as_ref().unwrap();
        let all = design.problem.walkers.as_ref().unwrap();
        let worst = all
            .each
            .iter()
            .find(|w| w.name == report.worst_walker)
            .unwrap();
        let distance = mean_square(&curves, "main", "worst").sqrt();
        let percent = 100.0 * distance * worst.factor / worst.unit;
        assert!(
            (percent / report.worst_percent - 1.0).abs() < 0.01,
            "{percent} {}",
            report.worst_percent
        );
        // The lines of all walkers are within the band.
        let line = |role: &str| {
            &curves.panels[0]
                .lines
                .iter()
                .find(|l| l.role == role)
                .unwrap()
                .y
        };
        let inside =
            |i: usize| line("low")[i] <= line("worst")[i] && line("worst")[i] <= line("high")[i];
        assert!((0..curves.theta.len()).all(inside));
    }
}
