//! The motor: how much torque, how even the turning, and the power–speed line of Campillo de Blas (2017).

use super::linear::Linear;
use crate::error::{Error, Result};
use crate::poly::PiecewisePoly;
use nalgebra::{Matrix4, Vector4};
use std::f64::consts::TAU;

/// What the camshaft asks of its motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// Mean torque over a turn, N·m.
    pub mean: f64,
    /// Root mean square torque, N·m: what heats the motor.
    pub rms: f64,
    /// Largest torque of either sign, N·m.
    pub peak: f64,
    /// Mean power, W.
    pub power: f64,
}

/// A motor whose torque falls with speed along a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motor {
    /// Torque at standstill, N·m.
    pub stall_torque: f64,
    /// Speed without load, rad/s.
    pub free_speed: f64,
}

/// How evenly a motor with a flywheel turns the cam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ripple {
    /// Mean speed, rad/s, where the line meets the mean torque.
    pub speed: f64,
    /// Largest less smallest speed over the mean.
    pub unevenness: f64,
}

/// Mean, RMS and peak of a torque curve (N·m over one turn) at `speed` rad/s; exact.
pub fn demand(torque: &PiecewisePoly, speed: f64) -> Demand {
    let length = torque.breaks()[torque.pieces()] - torque.breaks()[0];
    let (low, high) = torque.extremes();
    let mean = torque.integral() / length;
    Demand {
        mean,
        rms: (torque.integral_of_square() / length).sqrt(),
        peak: high.value.max(-low.value),
        power: mean * speed,
    }
}

/// Speed ripple of a motor that drives a torque curve through a flywheel of `inertia` kg·m².
///
/// J ω̄ dω/dθ = −(stall/free)·(ω − ω̄) − (T − T̄), solved exactly; the torque is taken as that of the mean
/// speed, so the answer is good to the square of the unevenness. Fails when the line cannot carry the
/// mean torque or the inertia is not positive.
pub fn ripple(torque: &PiecewisePoly, motor: &Motor, inertia: f64) -> Result<Ripple> {
    let length = torque.breaks()[torque.pieces()] - torque.breaks()[0];
    let mean = torque.integral() / length;
    let speed = motor.free_speed * (1.0 - mean / motor.stall_torque);
    if !(speed > 0.0 && inertia > 0.0 && motor.stall_torque > 0.0) {
        return Err(Error::new(format!(
            "the motor cannot turn the cam: it asks {mean:.4} N·m on average, the line gives {:.4} N·m at standstill",
            motor.stall_torque
        ))
        .help("take a stronger motor, and a positive inertia"));
    }
    let mut rates = -Matrix4::identity();
    rates[(0, 0)] = -motor.stall_torque / (motor.free_speed * inertia * speed);
    let linear = Linear {
        rates,
        inputs: vec![Vector4::new(-1.0 / (inertia * speed), 0.0, 0.0, 0.0)],
    };
    let surplus = PiecewisePoly::combine(&[(1.0, torque)], -mean);
    let states = linear
        .periodic(&[&surplus], |_| Vector4::zeros())
        .ok_or_else(|| {
            Error::new("the flywheel is too large for its motor to have a steady speed")
        })?;
    let (low, high) = states
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| {
            (l.min(z[0]), h.max(z[0]))
        });
    Ripple {
        speed,
        unevenness: (high - low) / speed,
    }
    .finite()
}

impl Ripple {
    fn finite(self) -> Result<Self> {
        if self.unevenness.is_finite() {
            return Ok(self);
        }
        Err(Error::new("the speed ripple is not finite"))
    }
}

/// Power law t = c·xᵖ through (x, t) pairs by least squares on their logarithms: (c, p).
///
/// Fails on fewer than two points or values that are not positive.
pub fn power_law(table: &[(f64, f64)]) -> Result<(f64, f64)> {
    if table.len() < 2 || table.iter().any(|(x, t)| !(*x > 0.0 && *t > 0.0)) {
        return Err(Error::new(
            "a power law needs two or more pairs of positive numbers",
        ));
    }
    let n = table.len() as f64;
    let logs: Vec<(f64, f64)> = table.iter().map(|(x, t)| (x.ln(), t.ln())).collect();
    let mx = logs.iter().map(|p| p.0).sum::<f64>() / n;
    let mt = logs.iter().map(|p| p.1).sum::<f64>() / n;
    let xx: f64 = logs.iter().map(|p| (p.0 - mx).powi(2)).sum();
    let xt: f64 = logs.iter().map(|p| (p.0 - mx) * (p.1 - mt)).sum();
    if xx == 0.0 {
        return Err(Error::new("a power law needs two different powers"));
    }
    let p = xt / xx;
    Ok(((mt - p * mx).exp(), p))
}

/// Power (%) that turns 11.1 times in `seconds`, by a table such as that of theory §3.
pub fn power_for(table: &[(f64, f64)], seconds: f64) -> Result<f64> {
    let (c, p) = power_law(table)?;
    Ok((seconds / c).powf(1.0 / p))
}

/// Seconds for 11.1 turns at `speed` rad/s.
pub fn seconds_for(speed: f64) -> f64 {
    11.1 * TAU / speed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{rigid, thesis};

    #[test]
    fn the_thesis_table_fits_355_9_x_to_the_minus_0_9662() {
        // theory §3: least squares on logs of the table as printed → 68.4 % for 6 s.
        let (c, p) = power_law(&thesis::MOTOR_TABLE).unwrap();
        assert!(
            (c - 355.9).abs() < 0.05 && (p + 0.9662).abs() < 5e-5,
            "{c} {p}"
        );
        assert!((power_for(&thesis::MOTOR_TABLE, 6.0).unwrap() - 68.4).abs() < 0.05);
        assert!(
            power_law(&[(1.0, 1.0)]).is_err() && power_law(&[(1.0, 1.0), (2.0, -1.0)]).is_err()
        );
    }

    #[test]
    fn the_eccentric_asks_no_mean_torque_and_a_known_rms() {
        // T = M(g − ω²e sin θ) e cos θ: mean square = M²e²(g²/2 + ω⁴e²/8).
        let drive = thesis::real(thesis::SPEED);
        let torque = rigid::torque_curve(&thesis::eccentric().law, &drive, 0.0, 0.03).unwrap();
        let demand = demand(&torque, drive.speed);
        let w2 = thesis::SPEED.powi(2);
        let exact = 0.01 * (0.5 * 9.81_f64.powi(2) + (w2 * 0.01).powi(2) / 8.0).sqrt();
        assert!(demand.mean.abs() < 1e-15 && (demand.rms - exact).abs() < 1e-14);
    }

    #[test]
    fn ripple_of_one_harmonic_is_the_first_order_lag() {
        // T = A cos θ: amplitude A/√((b)² + (Jω)²), b = stall/free; unevenness 2·amplitude/ω.
        let torque =
            crate::law::Law::harmonic(0.5, &[(2.0, 0.0)]).combination([1.0, 0.0, 0.0, 0.0], 0.0);
        let torque = crate::poly::stand_in(
            &(0..=720)
                .map(|i| TAU * f64::from(i) / 720.0)
                .collect::<Vec<_>>(),
            1e-13,
            |_, x| torque.eval(x),
        );
        let motor = Motor {
            stall_torque: 5.0,
            free_speed: 20.0,
        };
        let ripple = ripple(&torque, &motor, 0.04).unwrap();
        assert!((ripple.speed - 18.0).abs() < 1e-12);
        let exact = 2.0 * 2.0 / (0.25_f64.powi(2) + (0.04_f64 * 18.0).powi(2)).sqrt() / 18.0;
        assert!(
            (ripple.unevenness / exact - 1.0).abs() < 1e-4,
            "{} {exact}",
            ripple.unevenness
        );
        let weak = Motor {
            stall_torque: 0.4,
            free_speed: 20.0,
        };
        assert!(super::ripple(&torque, &weak, 0.04).is_err());
    }
}
