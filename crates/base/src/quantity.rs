//! Dimensions of physical quantities, and values with a dimension.

use serde::Serialize;
use serde::ser::{SerializeStruct, Serializer};

/// Exponents of metre, kilogram, second and radian in a unit.
pub(crate) type Exponents = [i32; 4];

/// Dimension of a physical quantity.
///
/// ```
/// use gaitcam_base::units::{Dimension, parse};
///
/// assert_eq!(Dimension::SpringRate.si(), "N/m");
/// assert_eq!(parse("2 in", Dimension::Length)?, 0.0508);
/// assert!(parse("2 in", Dimension::Mass).is_err());
/// # Ok::<(), gaitcam_base::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
pub enum Dimension {
    /// A dimensionless number, written as a plain number or as a percentage.
    Ratio,
    /// A fraction that must be written with %, because a number without % would be ambiguous.
    Percent,
    Length,
    Angle,
    Time,
    Mass,
    Force,
    Frequency,
    AngularSpeed,
    Speed,
    Acceleration,
    Jerk,
    AngularAcceleration,
    AngularJerk,
    Pressure,
    PressurePerVolume,
    SpringRate,
    Damping,
    Torque,
    Power,
    /// Torque per angle (torsional stiffness), N·m/rad.
    AngularRate,
    /// Torque per speed of a shaft, N·m·s/rad.
    AngularDamping,
    /// Moment of inertia, kg·m².
    Inertia,
    /// Derivative of the lift with respect to the cam angle, of order 1 to 3, in m/rad, m/rad² or m/rad³.
    LengthPerAngle(u8),
    /// Derivative of the angle of an oscillating follower with respect to the cam angle, of order 1 to 3, in rad/rad, rad/rad² or rad/rad³.
    AnglePerAngle(u8),
}

impl Dimension {
    /// Exponents of metre, kilogram, second and radian; name of the SI unit; examples of valid values.
    fn row(self) -> (Exponents, &'static str, &'static str) {
        let power = |n: u8, units: [&'static str; 3]| units[usize::from(n.clamp(1, 3)) - 1];
        match self {
            Dimension::Ratio => ([0, 0, 0, 0], "", "0.05, \"5 %\""),
            Dimension::Percent => ([0, 0, 0, 0], "ratio", "\"0.5 %\""),
            Dimension::Length => ([1, 0, 0, 0], "m", "\"25 mm\", \"1 in\""),
            Dimension::Angle => ([0, 0, 0, 1], "rad", "\"90 deg\", \"1.57 rad\""),
            Dimension::Time => ([0, 0, 1, 0], "s", "\"0.5 s\", \"500 ms\""),
            Dimension::Mass => ([0, 1, 0, 0], "kg", "\"70 kg\", \"154 lb\""),
            Dimension::Force => ([1, 1, -2, 0], "N", "\"700 N\", \"157 lbf\""),
            Dimension::Frequency => ([0, 0, -1, 0], "Hz", "\"1.85 Hz\""),
            Dimension::AngularSpeed => ([0, 0, -1, 1], "rad/s", "\"111 rpm\", \"12.566 rad/s\""),
            Dimension::Speed => ([1, 0, -1, 0], "m/s", "\"1.4 m/s\""),
            Dimension::Acceleration => ([1, 0, -2, 0], "m/s^2", "\"40 m/s^2\""),
            Dimension::Jerk => ([1, 0, -3, 0], "m/s^3", "\"200 m/s^3\""),
            Dimension::AngularAcceleration => ([0, 0, -2, 1], "rad/s^2", "\"50 rad/s^2\""),
            Dimension::AngularJerk => ([0, 0, -3, 1], "rad/s^3", "\"900 rad/s^3\""),
            Dimension::Pressure => ([-1, 1, -2, 0], "Pa", "\"500 MPa\", \"60 psi\""),
            Dimension::PressurePerVolume => ([-4, 1, -2, 0], "Pa/m^3", "\"30 psi/in^3\""),
            Dimension::SpringRate => ([0, 1, -2, 0], "N/m", "\"5000 N/m\", \"30 lbf/in\""),
            Dimension::Damping => ([0, 1, -1, 0], "N s/m", "\"20 N s/m\""),
            Dimension::Torque => ([2, 1, -2, 0], "N m", "\"2 N m\""),
            Dimension::Power => ([2, 1, -3, 0], "W", "\"50 W\""),
            Dimension::AngularRate => ([2, 1, -2, -1], "N m/rad", "\"500 N m/rad\""),
            Dimension::AngularDamping => ([2, 1, -1, -1], "N m s/rad", "\"10 N m s/rad\""),
            Dimension::Inertia => ([2, 1, 0, 0], "kg m^2", "\"0.02 kg m^2\""),
            Dimension::LengthPerAngle(n) => (
                [1, 0, 0, -i32::from(n)],
                power(n, ["m/rad", "m/rad^2", "m/rad^3"]),
                "\"0.5 in/rad\"",
            ),
            Dimension::AnglePerAngle(n) => (
                [0, 0, 0, 1 - i32::from(n)],
                power(n, ["rad/rad", "rad/rad^2", "rad/rad^3"]),
                "\"0.1 rad/rad\"",
            ),
        }
    }

    /// Exponents of metre, kilogram, second and radian in the SI unit.
    pub(crate) fn exponents(self) -> Exponents {
        self.row().0
    }

    /// Name of the dimension in messages.
    pub(crate) fn name(self) -> String {
        <&str>::from(self).replace('-', " ")
    }

    /// Name of the SI unit, as written in scenes and tables.
    pub fn si(self) -> &'static str {
        self.row().1
    }

    /// Examples of valid values, for messages.
    pub fn example(self) -> &'static str {
        self.row().2
    }
}

/// A value in SI units with its dimension, used in results and messages.
///
/// It serialises as `{"value": 0.0136, "unit": "m"}`. A value that is not finite serialises as `"inf"`, `"-inf"` or `"nan"`. In messages it
/// is displayed in its common unit, here 13.6 mm.
///
/// ```
/// use gaitcam_base::units::{Dimension, Quantity};
///
/// let stroke = Quantity::length(0.0136);
/// assert_eq!(stroke.dimension, Dimension::Length);
/// assert_eq!(serde_json::to_string(&stroke).unwrap(), r#"{"value":0.0136,"unit":"m"}"#);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Value in SI units (radians for angles).
    pub value: f64,
    /// Dimension of the quantity.
    pub dimension: Dimension,
}

impl Quantity {
    /// A quantity from a value in SI units and its dimension.
    pub fn new(value: f64, dimension: Dimension) -> Quantity {
        Quantity { value, dimension }
    }

    /// A length from a value in m.
    pub fn length(value: f64) -> Quantity {
        Quantity::new(value, Dimension::Length)
    }

    /// An angle from a value in rad.
    pub fn angle(value: f64) -> Quantity {
        Quantity::new(value, Dimension::Angle)
    }

    /// A force from a value in N.
    pub fn force(value: f64) -> Quantity {
        Quantity::new(value, Dimension::Force)
    }

    /// A time from a value in s.
    pub fn time(value: f64) -> Quantity {
        Quantity::new(value, Dimension::Time)
    }

    /// A quantity from a fraction. It is displayed as a percentage: 0.05 is 5 %.
    pub fn share(value: f64) -> Quantity {
        Quantity::new(value, Dimension::Percent)
    }
}

impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Quantity", 2)?;
        if self.value.is_finite() {
            out.serialize_field("value", &self.value)?;
        } else if self.value.is_nan() {
            out.serialize_field("value", "nan")?;
        } else {
            let sign = if self.value > 0.0 { "inf" } else { "-inf" };
            out.serialize_field("value", sign)?;
        }
        out.serialize_field("unit", self.dimension.si())?;
        out.end()
    }
}
