//! The double harmonic of Campillo de Blas (2017) with a motor of varying speed: times at which the force exceeds the weight, and its maximum,
//! compared with the measurements of the thesis (theory §3).

use gaitcam::cam::Cam;
use gaitcam::drive::{Motor, TorqueLine};
use gaitcam::dynamics::{Model, Run, simulate};
use gaitcam::error::Result;

use super::motor;
use gaitcam_test_support::thesis;

/// Number of rows of a turn.
const ROWS: usize = 1440;
/// Inertia of shaft and cams, kg·m²: two discs of 35 mm and 100 g. With a tenth of it, the angles below change by less than 0.1°.
const INERTIA: f64 = 1e-4;
/// Position at which the force first falls to the weight in the measured turn, degrees of its time.
pub const MEASURED_END: f64 = 100.0;
/// Student's t for six degrees of freedom, 95 %, one-sided.
const STUDENT: f64 = 1.943;

/// Result of a turn. Angles are degrees of its time: 360° is the period, for any speed within it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Slope of the motor line at the camshaft, N·m·s.
    pub slope: f64,
    /// Range of the speed relative to its mean.
    pub ripple: f64,
    /// End of the first interval above the weight, degrees.
    pub first_end: f64,
    /// Start and end of the second interval above the weight, degrees.
    pub second: [f64; 2],
    /// Maximum force in each of the two intervals, N.
    pub largest: [f64; 2],
}

/// Turn with a motor line of this slope.
pub fn turn(cam: &Cam, slope: f64) -> Result<Turn> {
    let mut run = Run::new(cam.clone(), thesis::real(thesis::SPEED), ROWS);
    run.machine.motor = Some(Motor {
        line: TorqueLine::Slope(slope),
        nominal: None,
        inertia: INERTIA,
        friction: 0.0,
        gear: 1.0,
        efficiency: 1.0,
    });
    let out = simulate(&run, Model::Rigid)?;
    let weight = run.drive.rest_force;
    let degrees = |time: f64| (time * thesis::SPEED).to_degrees();
    let (mut crossings, mut largest) = (Vec::new(), [0.0_f64; 2]);
    for pair in out.rows.windows(2) {
        let [a, b] = [
            pair[0].contact_force - weight,
            pair[1].contact_force - weight,
        ];
        // In the dwell, the force equals the weight up to rounding, because the speed ripple has no effect on a circle. The threshold excludes these
        // crossings.
        if a * b < 0.0 && a.abs().max(b.abs()) > 1e-6 * weight {
            let part = a / (a - b);
            let time = pair[0].time + part * (pair[1].time - pair[0].time);
            crossings.push(degrees(time));
        }
        let half = usize::from(pair[0].theta > std::f64::consts::FRAC_PI_4 * 3.0);
        largest[half] = largest[half].max(pair[0].contact_force);
    }
    let at = |i: usize| crossings.get(i).copied().unwrap_or(f64::NAN);
    let dwell = out
        .rows
        .iter()
        .find(|r| r.theta >= 1.5 * std::f64::consts::PI);
    Ok(Turn {
        slope,
        ripple: out.shaft.map_or(0.0, |s| s.ripple),
        first_end: at(0),
        second: [at(1), dwell.map_or(f64::NAN, |r| degrees(r.time))],
        largest,
    })
}

/// Turn whose first interval is as long as the measured one.
pub fn as_measured(cam: &Cam) -> Result<Turn> {
    // A stiffer motor line shortens the interval.
    let (mut soft, mut stiff) = (0.02_f64, 1.0_f64);
    for _ in 0..40 {
        let middle = (soft * stiff).sqrt();
        match turn(cam, middle) {
            Ok(turn) if turn.first_end < MEASURED_END => stiff = middle,
            _ => soft = middle,
        }
    }
    turn(cam, stiff)
}

/// Maximum drag that the table of power and time allows, as the speed reduction of the motor (torque over slope), rad/s: ω = Ω p − T/k by least
/// squares, upper bound of 95 %.
pub fn largest_drag() -> f64 {
    let points =
        motor::MOTOR_TABLE.map(|(power, time)| (power, std::f64::consts::TAU * 11.1 / time));
    let n = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (mp, mw) = (mean(&|p| p.0), mean(&|p| p.1));
    let spread = n * mean(&|p| (p.0 - mp).powi(2));
    let rate = n * mean(&|p| (p.0 - mp) * (p.1 - mw)) / spread;
    let start = mw - rate * mp;
    let square = n * mean(&|p| (p.1 - rate * p.0 - start).powi(2)) / (n - 2.0);
    let error = (square * (1.0 / n + mp * mp / spread)).sqrt();
    STUDENT * error - start
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stiff_motor_gives_the_angles_of_constant_speed() {
        // The acceleration of the double harmonic is proportional to cos A − cos 2A. It changes its sign at two thirds of either flank.
        let cam = thesis::double_harmonic();
        let stiff = turn(&cam, 1e4).unwrap();
        for (got, exact) in [stiff.first_end, stiff.second[0], stiff.second[1]]
            .iter()
            .zip([90.0, 180.0, 270.0])
        {
            // Error of a profile with 1440 points.
            assert!((got - exact).abs() < 0.01, "{stiff:?}");
        }
    }
}
