//! Motor that drives the cam: torque against speed, and the inertia and friction of its shaft.

/// Torque of a motor as a decreasing function of the camshaft speed. The supply determines the no-load speed.
///
/// ```
/// use gaitcam::drive::TorqueLine;
///
/// let curve = TorqueLine::Curve(vec![[0.0, 60.0], [10.0, 20.0], [12.0, -4.0]]);
/// assert!((curve.no_load_speed().unwrap() - (10.0 + 20.0 / 12.0)).abs() < 1e-12);
/// assert_eq!(TorqueLine::Slope(10.0).no_load_speed(), None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum TorqueLine {
    /// Decrease of torque with speed, N·m·s/rad: T = slope·(ω₀ − ω).
    Slope(f64),
    /// Torque at standstill, N·m: T = stall·(1 − ω/ω₀).
    Stall(f64),
    /// Table of speed, rad/s, and torque, N·m, decreasing and linearly extrapolated. The supply shifts the curve along the speed axis until the
    /// torque is zero at ω₀.
    Curve(Vec<[f64; 2]>),
}

/// A motor, its flywheel and its friction, referred to the camshaft.
///
/// ```
/// use gaitcam::drive::{Motor, TorqueLine};
///
/// // A line that loses 10 N·m per rad/s, run at 12 rad/s under a no-load speed of 13 rad/s.
/// let motor = Motor { line: TorqueLine::Slope(10.0), nominal: None, inertia: 0.5, friction: 1.0, gear: 1.0, efficiency: 1.0 };
/// assert_eq!(motor.torque(12.0, 13.0)[0], 10.0);
/// assert_eq!(motor.torque(12.0, 13.0)[1..], [-10.0, 10.0]);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Motor {
    /// Torque against speed at the camshaft, including gear losses.
    pub line: TorqueLine,
    /// No-load speed of the motor at its maximum supply, rad/s; `None` for an adjustable supply.
    pub nominal: Option<f64>,
    /// Moment of inertia of all rotating parts, referred to the camshaft, kg·m².
    pub inertia: f64,
    /// Friction torque of the bearings, N·m.
    pub friction: f64,
    /// Turns of the motor per turn of the cam.
    pub gear: f64,
    /// Efficiency of the gear, 0 … 1.
    pub efficiency: f64,
}

impl TorqueLine {
    /// Speed at which the torque of a tabulated curve is zero, rad/s. `None` for `Slope` and `Stall`, which do not contain a no-load speed.
    pub fn no_load_speed(&self) -> Option<f64> {
        match self {
            TorqueLine::Slope(_) | TorqueLine::Stall(_) => None,
            TorqueLine::Curve(rows) => Some(no_load_speed(rows)),
        }
    }
}

impl Motor {
    /// Whether all data of the motor are finite and not negative, and gear ratio and efficiency are positive.
    pub(crate) fn is_sound(&self) -> bool {
        let numbers = [self.inertia, self.friction, self.gear, self.efficiency];
        let is_positive = self.gear > 0.0 && self.efficiency > 0.0;
        numbers.iter().all(|x| x.is_finite() && *x >= 0.0) && is_positive
    }

    /// Torque at the camshaft, N·m, at a given speed and no-load speed, rad/s, with its derivatives with respect to the two speeds.
    pub fn torque(&self, speed: f64, no_load: f64) -> [f64; 3] {
        match &self.line {
            TorqueLine::Slope(k) => [k * (no_load - speed), -k, *k],
            TorqueLine::Stall(most) => [
                most * (1.0 - speed / no_load),
                -most / no_load,
                most * speed / (no_load * no_load),
            ],
            TorqueLine::Curve(rows) => {
                let own = no_load_speed(rows);
                let (torque, slope) = on(rows, speed - no_load + own);
                [torque, slope, -slope]
            }
        }
    }

    /// No-load speed, rad/s, for which the motor has the torque `torque`, N·m, at the camshaft speed `speed`, rad/s.
    pub fn no_load_for(&self, speed: f64, torque: f64) -> f64 {
        match &self.line {
            TorqueLine::Slope(k) => speed + torque / k,
            TorqueLine::Stall(most) => speed / (1.0 - torque / most).max(0.05),
            TorqueLine::Curve(rows) => {
                let i = rows
                    .partition_point(|r| r[1] > torque)
                    .clamp(1, rows.len() - 1);
                let [a, b] = [rows[i - 1], rows[i]];
                let at = a[0] + (torque - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
                speed + no_load_speed(rows) - at
            }
        }
    }

    /// The motor with its torque multiplied by a factor.
    #[must_use]
    pub fn with_torque(&self, part: f64) -> Motor {
        let line = match &self.line {
            TorqueLine::Slope(k) => TorqueLine::Slope(part * k),
            TorqueLine::Stall(most) => TorqueLine::Stall(part * most),
            TorqueLine::Curve(rows) => {
                TorqueLine::Curve(rows.iter().map(|[w, t]| [*w, part * t]).collect())
            }
        };
        Motor {
            line,
            ..self.clone()
        }
    }

    /// Torque at the motor shaft, N·m, for a torque at the camshaft.
    pub fn own_torque(&self, at_cam: f64) -> f64 {
        at_cam / (self.gear * self.efficiency)
    }
}

/// Speed at which the torque of a decreasing curve is zero, rad/s.
fn no_load_speed(rows: &[[f64; 2]]) -> f64 {
    let i = rows
        .partition_point(|r| r[1] > 0.0)
        .clamp(1, rows.len() - 1);
    let [a, b] = [rows[i - 1], rows[i]];
    a[0] - a[1] * (b[0] - a[0]) / (b[1] - a[1])
}

/// Torque, N·m, and its slope, N·m·s/rad, of a curve at a speed, rad/s.
fn on(rows: &[[f64; 2]], speed: f64) -> (f64, f64) {
    let i = rows
        .partition_point(|r| r[0] <= speed)
        .clamp(1, rows.len() - 1);
    let [a, b] = [rows[i - 1], rows[i]];
    let slope = (b[1] - a[1]) / (b[0] - a[0]);
    (a[1] + slope * (speed - a[0]), slope)
}
