//! Motor: required torque, and the relation of power and speed of Campillo de Blas (2017).

use gaitcam::error::Result;
use gaitcam::poly::PiecewisePoly;
use std::f64::consts::TAU;

/// Motor power (%) and seconds for 11.1 turns, table 1.
pub const MOTOR_TABLE: [(f64, f64); 8] = [
    (10.0, 37.97),
    (20.0, 19.87),
    (30.0, 13.15),
    (40.0, 10.42),
    (50.0, 8.17),
    (60.0, 6.94),
    (70.0, 5.73),
    (80.0, 5.08),
];

/// Torque and power that the camshaft requires from its motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// Mean torque over a turn, N·m.
    pub mean: f64,
    /// Root mean square torque, N·m. It determines the heating of the motor.
    pub rms: f64,
    /// Maximum absolute torque, N·m.
    pub peak: f64,
    /// Mean power over a turn, W.
    pub power: f64,
}

/// Mean, RMS and peak of a torque curve (N·m over one turn) at `speed` rad/s, in closed form.
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

/// Power law t = c·xᵖ through (x, t) pairs by least squares on their logarithms: (c, p).
///
/// # Errors
///
/// Fewer than two points, or values that are not positive.
pub fn power_law(table: &[(f64, f64)]) -> Result<(f64, f64)> {
    if table.len() < 2 || table.iter().any(|(x, t)| !(*x > 0.0 && *t > 0.0)) {
        return Err(crate::fault(
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
        return Err(crate::fault("a power law needs two different powers"));
    }
    let p = xt / xx;
    Ok(((mt - p * mx).exp(), p))
}

/// Power in % for 11.1 turns in `seconds`, from a table such as that of the thesis (reports/reproduction.md).
pub fn power_for(table: &[(f64, f64)], seconds: f64) -> Result<f64> {
    let (c, p) = power_law(table)?;
    Ok((seconds / c).powf(1.0 / p))
}

/// Duration of 11.1 turns at `speed` rad/s, s.
pub fn seconds_for(speed: f64) -> f64 {
    11.1 * TAU / speed
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::dynamics::torque_curve;
    use gaitcam_test_support::thesis;

    #[test]
    fn the_thesis_table_fits_355_9_x_to_the_minus_0_9662() {
        // reports/reproduction.md: least squares on logs of the table as printed → 68.4 % for 6 s.
        let (c, p) = power_law(&MOTOR_TABLE).unwrap();
        assert!(
            (c - 355.9).abs() < 0.05 && (p + 0.9662).abs() < 5e-5,
            "{c} {p}"
        );
        assert!((power_for(&MOTOR_TABLE, 6.0).unwrap() - 68.4).abs() < 0.05);
        assert!(
            power_law(&[(1.0, 1.0)]).is_err() && power_law(&[(1.0, 1.0), (2.0, -1.0)]).is_err()
        );
    }

    #[test]
    fn the_eccentric_asks_no_mean_torque_and_a_known_rms() {
        // T = M(g − ω²e sin θ) e cos θ: mean square = M²e²(g²/2 + ω⁴e²/8).
        let drive = thesis::real(thesis::SPEED);
        let torque = torque_curve(&thesis::eccentric().law, &drive, 0.0, 0.03).unwrap();
        let demand = demand(&torque, drive.speed);
        let w2 = thesis::SPEED.powi(2);
        let exact = 0.01 * (0.5 * 9.81_f64.powi(2) + (w2 * 0.01).powi(2) / 8.0).sqrt();
        assert!(demand.mean.abs() < 1e-15 && (demand.rms - exact).abs() < 1e-14);
    }
}
