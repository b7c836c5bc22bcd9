//! Quantities with units: `"3 in"` becomes 0.0762 m.
//!
//! A quantity is a number, a blank (optional) and a unit expression of factors joined by `*`, a blank,
//! `/` and `^`: `"30 psi/in^3"`, `"40 m/s^2"`, `"2 N m"`. Angles are a dimension of their own, so that
//! degrees cannot be given where metres are wanted. Everything is SI and radians inside.

use crate::error::{Error, Result, nearest};

/// Standard gravity as the source papers use it, m/s² (Campillo de Blas 2017, eq. 22).
pub const G: f64 = 9.81;

/// Exponents of metre, kilogram, second and radian.
type Exponents = [i32; 4];

/// What a number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the names are the documentation
pub enum Dimension {
    /// A plain number or a percentage.
    Ratio,
    /// A share of which a bare number would leave open whether it is a hundredth: it needs its %.
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
    /// Torsional stiffness, N·m/rad.
    AngularRate,
    /// Rotational inertia, kg·m².
    Inertia,
    /// Derivatives of lift by cam angle: m/rad, m/rad², m/rad³.
    LengthPerAngle(u8),
    /// Derivatives of an oscillating follower's angle by cam angle: rad/rad … rad/rad³.
    AnglePerAngle(u8),
}

impl Dimension {
    fn exponents(self) -> Exponents {
        match self {
            Dimension::Ratio | Dimension::Percent => [0, 0, 0, 0],
            Dimension::Length => [1, 0, 0, 0],
            Dimension::Angle => [0, 0, 0, 1],
            Dimension::Time => [0, 0, 1, 0],
            Dimension::Mass => [0, 1, 0, 0],
            Dimension::Force => [1, 1, -2, 0],
            Dimension::Frequency => [0, 0, -1, 0],
            Dimension::AngularSpeed => [0, 0, -1, 1],
            Dimension::Speed => [1, 0, -1, 0],
            Dimension::Acceleration => [1, 0, -2, 0],
            Dimension::Jerk => [1, 0, -3, 0],
            Dimension::AngularAcceleration => [0, 0, -2, 1],
            Dimension::AngularJerk => [0, 0, -3, 1],
            Dimension::Pressure => [-1, 1, -2, 0],
            Dimension::PressurePerVolume => [-4, 1, -2, 0],
            Dimension::SpringRate => [0, 1, -2, 0],
            Dimension::Damping => [0, 1, -1, 0],
            Dimension::Torque => [2, 1, -2, 0],
            Dimension::AngularRate => [2, 1, -2, -1],
            Dimension::Inertia => [2, 1, 0, 0],
            Dimension::LengthPerAngle(n) => [1, 0, 0, -i32::from(n)],
            Dimension::AnglePerAngle(n) => [0, 0, 0, 1 - i32::from(n)],
        }
    }

    /// An example of a right value, for messages.
    pub fn example(self) -> &'static str {
        match self {
            Dimension::Ratio | Dimension::Percent => "\"0.5 %\"",
            Dimension::Length => "\"25 mm\" or \"1 in\"",
            Dimension::Angle => "\"90 deg\" or \"1.57 rad\"",
            Dimension::Time => "\"0.5 s\" or \"500 ms\"",
            Dimension::Mass => "\"70 kg\" or \"154 lb\"",
            Dimension::Force => "\"700 N\" or \"157 lbf\"",
            Dimension::Frequency => "\"1.85 Hz\"",
            Dimension::AngularSpeed => "\"111 rpm\" or \"12.566 rad/s\"",
            Dimension::Speed => "\"1.4 m/s\"",
            Dimension::Acceleration => "\"40 m/s^2\"",
            Dimension::Jerk => "\"200 m/s^3\"",
            Dimension::AngularAcceleration => "\"50 rad/s^2\"",
            Dimension::AngularJerk => "\"900 rad/s^3\"",
            Dimension::Pressure => "\"500 MPa\" or \"60 psi\"",
            Dimension::PressurePerVolume => "\"30 psi/in^3\"",
            Dimension::SpringRate => "\"5000 N/m\" or \"30 lbf/in\"",
            Dimension::Damping => "\"20 N s/m\"",
            Dimension::Torque => "\"2 N m\"",
            Dimension::AngularRate => "\"500 N m/rad\"",
            Dimension::Inertia => "\"0.02 kg m^2\"",
            Dimension::LengthPerAngle(_) => "\"0.5 in/rad\"",
            Dimension::AnglePerAngle(_) => "\"0.1 rad/rad\"",
        }
    }
}

/// Unit names, their factors to SI and their exponents. The pound alone is context-bound: see
/// [`parse`].
const UNITS: &[(&str, f64, Exponents)] = &[
    ("m", 1.0, [1, 0, 0, 0]),
    ("km", 1e3, [1, 0, 0, 0]),
    ("cm", 1e-2, [1, 0, 0, 0]),
    ("mm", 1e-3, [1, 0, 0, 0]),
    ("um", 1e-6, [1, 0, 0, 0]),
    ("µm", 1e-6, [1, 0, 0, 0]),
    ("in", 0.0254, [1, 0, 0, 0]),
    ("ft", 0.3048, [1, 0, 0, 0]),
    ("rad", 1.0, [0, 0, 0, 1]),
    ("deg", std::f64::consts::PI / 180.0, [0, 0, 0, 1]),
    ("°", std::f64::consts::PI / 180.0, [0, 0, 0, 1]),
    ("rev", std::f64::consts::TAU, [0, 0, 0, 1]),
    ("turn", std::f64::consts::TAU, [0, 0, 0, 1]),
    ("s", 1.0, [0, 0, 1, 0]),
    ("ms", 1e-3, [0, 0, 1, 0]),
    ("min", 60.0, [0, 0, 1, 0]),
    ("kg", 1.0, [0, 1, 0, 0]),
    ("g", 1e-3, [0, 1, 0, 0]),
    ("N", 1.0, [1, 1, -2, 0]),
    ("kN", 1e3, [1, 1, -2, 0]),
    ("mN", 1e-3, [1, 1, -2, 0]),
    ("lbf", LBF, [1, 1, -2, 0]),
    ("kgf", 9.806_65, [1, 1, -2, 0]),
    ("Hz", 1.0, [0, 0, -1, 0]),
    ("rpm", std::f64::consts::TAU / 60.0, [0, 0, -1, 1]),
    ("Pa", 1.0, [-1, 1, -2, 0]),
    ("kPa", 1e3, [-1, 1, -2, 0]),
    ("MPa", 1e6, [-1, 1, -2, 0]),
    ("GPa", 1e9, [-1, 1, -2, 0]),
    ("bar", 1e5, [-1, 1, -2, 0]),
    ("psi", LBF / (0.0254 * 0.0254), [-1, 1, -2, 0]),
    ("J", 1.0, [2, 1, -2, 0]),
    ("Nm", 1.0, [2, 1, -2, 0]),
    ("%", 0.01, [0, 0, 0, 0]),
    // A share that says it is none of hundred.
    ("ratio", 1.0, [0, 0, 0, 0]),
];

/// One pound-force in newtons.
pub const LBF: f64 = 4.448_221_615_260_5;
/// One pound (mass) in kilograms.
const LB: f64 = 0.453_592_37;

/// Reads a quantity of the given dimension; the result is in SI and radians.
///
/// `"0"` needs no unit (zero is zero in every unit) and a [`Dimension::Ratio`] needs none either;
/// any other bare number is refused. `lb` is a mass where a mass is expected and a force elsewhere.
/// `inf` is refused, as is anything that is not finite after conversion.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64> {
    let text = text.trim();
    let (number, unit) = split_number(text);
    let value: f64 = number.parse().map_err(|_| {
        Error::new(format!("\"{text}\" does not start with a number"))
            .help(format!("write for example {}", dimension.example()))
    })?;
    let unit = unit.trim();
    if unit.is_empty() {
        if value == 0.0 || dimension == Dimension::Ratio {
            return finite(value, text);
        }
        if dimension == Dimension::Percent {
            return Err(Error::new(format!("\"{text}\" has no unit")).help(format!(
                "write \"{text} %\", or \"{} %\" if the plain ratio is meant",
                // Twelve digits hide the rounding of the product.
                (value * 1e14).round() / 1e12
            )));
        }
        return Err(Error::new(format!("\"{text}\" has no unit"))
            .help(format!("write for example {}", dimension.example())));
    }
    let (factor, exponents) = unit_factor(unit, dimension)?;
    if exponents != dimension.exponents() {
        return Err(Error::new(format!(
            "\"{text}\" has a unit of another kind (\"{unit}\" is not a unit of {})",
            name(dimension)
        ))
        .help(format!("write for example {}", dimension.example())));
    }
    finite(value * factor, text)
}

fn finite(value: f64, text: &str) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::new(format!("\"{text}\" is not a finite number")))
    }
}

fn name(dimension: Dimension) -> String {
    format!("{dimension:?}")
        .chars()
        .flat_map(|c| {
            let gap = c.is_uppercase().then_some(' ');
            gap.into_iter().chain(c.to_lowercase())
        })
        .collect::<String>()
        .trim()
        .to_string()
}

/// Splits "1.85e-3mm" into "1.85e-3" and "mm"; an `e` counts as exponent only before a digit.
fn split_number(text: &str) -> (&str, &str) {
    let b = text.as_bytes();
    let digit = |i: usize| b.get(i).is_some_and(u8::is_ascii_digit);
    let mut i = 0;
    if matches!(b.first(), Some(b'+' | b'-')) {
        i = 1;
    }
    while digit(i) || b.get(i) == Some(&b'.') {
        i += 1;
    }
    if matches!(b.get(i), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(b.get(i + 1), Some(b'+' | b'-')));
        if digit(i + 1 + sign) {
            i += 1 + sign;
            while digit(i) {
                i += 1;
            }
        }
    }
    text.split_at(i)
}

fn unit_factor(expression: &str, dimension: Dimension) -> Result<(f64, Exponents)> {
    let mut factor = 1.0;
    let mut exponents = [0; 4];
    let mut sign = 1;
    let spaced = expression
        .replace('/', " / ")
        .replace(['*', '·'], " ")
        .replace('²', "^2")
        .replace('³', "^3");
    for word in spaced.split_whitespace() {
        if word == "/" {
            sign = -1;
            continue;
        }
        let (unit, power) = match word.split_once('^') {
            Some((unit, power)) => {
                let power = power.parse::<i32>().ok().filter(|p| (-6..=6).contains(p));
                let power = power.ok_or_else(|| {
                    Error::new(format!(
                        "\"{word}\" has an exponent that is not a small integer"
                    ))
                })?;
                (unit, power * sign)
            }
            None => (word, sign),
        };
        let (f, e) = lookup(unit, dimension).ok_or_else(|| unknown_unit(unit, dimension))?;
        factor *= f.powi(power);
        for (total, e) in exponents.iter_mut().zip(e) {
            *total += e * power;
        }
    }
    Ok((factor, exponents))
}

fn lookup(unit: &str, dimension: Dimension) -> Option<(f64, Exponents)> {
    if matches!(unit, "lb" | "lbs") {
        return Some(match dimension {
            Dimension::Mass | Dimension::Inertia => (LB, [0, 1, 0, 0]),
            _ => (LBF, [1, 1, -2, 0]),
        });
    }
    UNITS
        .iter()
        .find(|(n, ..)| *n == unit)
        .map(|&(_, f, e)| (f, e))
}

fn unknown_unit(unit: &str, dimension: Dimension) -> Error {
    let error = Error::new(format!("\"{unit}\" is not a unit known here"));
    let fits = |u: &&(&'static str, f64, Exponents)| u.2 == dimension.exponents();
    let shouted = |u: &&(&'static str, f64, Exponents)| u.0.eq_ignore_ascii_case(unit);
    // Of the right kind but for the case, then of the right kind, then anything.
    let meant = (UNITS.iter().filter(fits).find(shouted).map(|u| u.0))
        .or_else(|| nearest(unit, UNITS.iter().filter(fits).map(|u| u.0)))
        .or_else(|| UNITS.iter().find(shouted).map(|u| u.0))
        .or_else(|| nearest(unit, UNITS.iter().map(|u| u.0)));
    match meant {
        Some(n) => error.help(format!("did you mean \"{n}\"?")),
        None => {
            error.help("units are SI, in, ft, lb, lbf, psi, deg, rpm, Hz, bar and their products")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compound_units_reduce_to_si() {
        let close = |text, dimension, expected: f64| {
            let got = parse(text, dimension).unwrap();
            assert!((got / expected - 1.0).abs() < 1e-12, "{text}: {got}");
        };
        close("3 in", Dimension::Length, 0.0762);
        close(
            "111 rpm",
            Dimension::AngularSpeed,
            111.0 * std::f64::consts::PI / 30.0,
        );
        close("0.5 %", Dimension::Ratio, 0.005);
        close("40m/s^2", Dimension::Acceleration, 40.0);
        close("1e-3 km", Dimension::Length, 1.0);
        close("110.282 lb", Dimension::Force, 110.282 * LBF);
        close("10 lb", Dimension::Mass, 4.535_923_7);
        close("2 N·m", Dimension::Torque, 2.0);
        // theory §2: (30 psi/in³)·(π 0.75²)² in⁴ = 93.6841 lb/in.
        let area = std::f64::consts::PI * 0.75 * 0.75 * 0.0254 * 0.0254;
        let k = parse("30 psi/in^3", Dimension::PressurePerVolume).unwrap() * area * area;
        assert!((k / (LBF / 0.0254) - 93.6841).abs() < 5e-5, "{k}");
    }

    #[test]
    fn bare_numbers_wrong_kinds_and_unknown_units_are_refused_with_advice() {
        let message = |t, d| parse(t, d).unwrap_err().to_string();
        assert!(message("3", Dimension::Length).contains("has no unit"));
        assert!(message("3 deg", Dimension::Length).contains("not a unit of length"));
        assert!(message("3 nm", Dimension::Length).contains("did you mean"));
        assert!(message("abc", Dimension::Length).contains("does not start with a number"));
        assert!(message("1e999 mm", Dimension::Length).contains("not a finite"));
        assert_eq!(parse("0", Dimension::Length), Ok(0.0));
        let share = message("0.5", Dimension::Percent);
        assert!(
            share.contains("\"0.5 %\"") && share.contains("\"50 %\""),
            "{share}"
        );
        assert_eq!(parse("0.5 ratio", Dimension::Percent), Ok(0.5));
        assert_eq!(parse("50 Nm", Dimension::Torque), Ok(50.0));
        for (text, dimension, meant) in [
            ("60 MM", Dimension::Length, "\"mm\""),
            ("111 RPM", Dimension::AngularSpeed, "\"rpm\""),
            ("5 mpa", Dimension::Pressure, "\"MPa\""),
            ("1 KG", Dimension::Mass, "\"kg\""),
        ] {
            let words = message(text, dimension);
            assert!(words.contains(meant), "{words}");
        }
    }
}
