//! Quantities with units: `"3 in"` becomes 0.0762 m.
//!
//! A quantity is a number, an optional space, and a unit expression of factors joined by `*`, space, `/` and `^`. Examples are
//! `"30 psi/in^3"`, `"40 m/s^2"` and `"2 N m"`. The number may have a decimal comma or be a fraction: `"2,5 mm"`, `"3/8 in"`,
//! `"1 3/8 in"`, `"1-3/8 in"`. Angle is a separate dimension, so degrees are rejected where metres are expected. Results are in SI
//! units and radians.

use crate::error::{Error, Result, UnitsError, nearest};
use crate::quantity::Exponents;
pub use crate::quantity::{Dimension, Quantity};

/// Standard gravity as used in the source papers, m/s² (Campillo de Blas 2017, eq. 22).
pub const G: f64 = 9.81;

/// Units: name, factor to the SI unit, and exponents of metre, kilogram, second and radian. [`parse`] describes how the dimension
/// determines the meaning of pound.
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
    ("us", 1e-6, [0, 0, 1, 0]),
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
    ("rps", std::f64::consts::TAU, [0, 0, -1, 1]),
    ("Pa", 1.0, [-1, 1, -2, 0]),
    ("kPa", 1e3, [-1, 1, -2, 0]),
    ("MPa", 1e6, [-1, 1, -2, 0]),
    ("GPa", 1e9, [-1, 1, -2, 0]),
    ("bar", 1e5, [-1, 1, -2, 0]),
    ("psi", LBF / (0.0254 * 0.0254), [-1, 1, -2, 0]),
    ("J", 1.0, [2, 1, -2, 0]),
    ("Nm", 1.0, [2, 1, -2, 0]),
    ("W", 1.0, [2, 1, -3, 0]),
    ("kW", 1e3, [2, 1, -3, 0]),
    ("%", 0.01, [0, 0, 0, 0]),
    // An explicit ratio, for fractions that must not be confused with percentages.
    ("ratio", 1.0, [0, 0, 0, 0]),
];

/// One pound-force (lbf) in newtons.
pub const LBF: f64 = 4.448_221_615_260_5;
/// One pound (mass) in kilograms.
const LB: f64 = 0.453_592_37;

/// Parses a quantity of the given dimension. The result is in SI units and radians.
///
/// `"0"` needs no unit, because zero is equal in every unit. A [`Dimension::Ratio`] needs no unit either. Any other number without a unit
/// is rejected. `lb` is a mass where a mass is expected, otherwise a force. `inf` and magnitudes above 1e30 are rejected, so products of a
/// few values are finite.
///
/// # Errors
///
/// The text is not a quantity or has another dimension; the magnitude is above 1e30.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64> {
    let text = text.trim();
    let example = || dimension.example().to_string();
    let no_number = || UnitsError::NoNumber {
        text: text.to_string(),
        example: example(),
    };
    if let Some(plain) = without_groups(text) {
        let text = text.to_string();
        return Err(UnitsError::Grouped { text, plain }.into());
    }
    let (value, unit) = leading_number(text).ok_or_else(no_number)?;
    let unit = unit.trim();
    if unit.is_empty() {
        let text = text.to_string();
        // Rounding to twelve digits removes the rounding error of the product.
        let percent = (value * 1e14).round() / 1e12;
        return match dimension {
            Dimension::Ratio => in_range(value, text),
            _ if value == 0.0 => Ok(0.0),
            Dimension::Percent => Err(UnitsError::BareShare { text, percent }.into()),
            _ => Err(UnitsError::NoUnit {
                text,
                example: example(),
            }
            .into()),
        };
    }
    let (factor, exponents) = unit_factor(unit, dimension)?;
    if exponents != dimension.exponents() {
        let (text, unit) = (text.to_string(), unit.to_string());
        let (dimension, example) = (dimension.name(), example());
        return Err(UnitsError::WrongDimension {
            text,
            unit,
            dimension,
            example,
        }
        .into());
    }
    in_range(value * factor, text)
}

/// Maximum magnitude of a value in SI units. Products of a few such values are finite.
const MOST: f64 = 1e30;

/// Checks that the magnitude of a value in SI units is at most 1e30, so that products of a few such values do not overflow. `text` is the
/// input, which the error contains.
///
/// # Errors
///
/// The magnitude is above 1e30, or the value is not a number.
pub fn in_range(value: f64, text: impl ToString) -> Result<f64> {
    if value.abs() <= MOST {
        return Ok(value);
    }
    let text = text.to_string();
    Err(UnitsError::OutOfRange { text }.into())
}

/// Number at the start of a text, such as `2,5` or `1 3/8`, and the remaining text.
fn leading_number(text: &str) -> Option<(f64, &str)> {
    let (number, rest) = split_number(text);
    let value: f64 = number.replace(',', ".").parse().ok()?;
    if let Some(share) = quotient(value, rest) {
        return Some(share);
    }
    let whole = !number.is_empty()
        && number
            .bytes()
            .all(|b| b.is_ascii_digit() || b"+-".contains(&b));
    let joined = rest.strip_prefix([' ', '-']);
    let (upper, after) = split_number(joined.unwrap_or(rest).trim_start());
    let mixed = (whole && joined.is_some()).then(|| quotient(upper.parse().ok()?, after));
    Some(match mixed.flatten() {
        Some((share, after)) if upper.as_bytes()[0].is_ascii_digit() => {
            let share = if number.starts_with('-') {
                -share
            } else {
                share
            };
            (value + share, after)
        }
        _ => (value, rest),
    })
}

/// `value` divided by the number after a slash at the start of `rest`, and the remaining text. `None` unless a slash and a positive number
/// follow.
fn quotient(value: f64, rest: &str) -> Option<(f64, &str)> {
    let (number, after) = split_number(rest.trim_start().strip_prefix('/')?.trim_start());
    let divisor: f64 = number.replace(',', ".").parse().ok()?;
    (divisor > 0.0).then(|| (value / divisor, after))
}

/// Text without thousands separators, for example `1234.5 mm` for `1.234,5 mm` and for `1,234.5 mm`. `None` if the text contains no
/// thousands separators.
fn without_groups(text: &str) -> Option<String> {
    let mark = |c: char| c == '.' || c == ',';
    let end = text.find(|c: char| !(c.is_ascii_digit() || mark(c) || "+-".contains(c)));
    let (number, rest) = text.split_at(end.unwrap_or(text.len()));
    let first = number.find(mark)?;
    let last = number.rfind(mark).filter(|last| *last > first)?;
    let decimal = number[first..=first] != number[last..=last];
    let (whole, part) = number.split_at(if decimal { last } else { number.len() });
    let mut groups = whole[first + 1..].split(mark);
    let plain = whole.replace(mark, "") + &part.replace(',', ".");
    groups.all(|g| g.len() == 3).then(|| plain + rest)
}

/// Splits "1.85e-3mm" into "1.85e-3" and "mm". An `e` is an exponent only before a digit. A comma is a decimal mark only between digits,
/// and only if it is the first decimal mark in the number.
fn split_number(text: &str) -> (&str, &str) {
    let b = text.as_bytes();
    let digit = |i: usize| b.get(i).is_some_and(u8::is_ascii_digit);
    let mut i = 0;
    if matches!(b.first(), Some(b'+' | b'-')) {
        i = 1;
    }
    let start = i;
    while digit(i)
        || b.get(i) == Some(&b'.')
        || (b.get(i) == Some(&b',')
            && i > start
            && digit(i + 1)
            && !b[start..i].iter().any(|c| b".,".contains(c)))
    {
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
    // Revolutions per minute, as written in drawings and on nameplates.
    let per_minute = matches!(expression, "1/min" | "min^-1" | "min⁻¹");
    let expression = match dimension {
        Dimension::AngularSpeed if per_minute => "rpm",
        _ => expression,
    };
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
                let factor = || word.to_string();
                let power = power.ok_or_else(|| UnitsError::Exponent { factor: factor() })?;
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
    if matches!(unit, "lb" | "lbs" | "pound" | "pounds" | "libra" | "libras") {
        return Some(match dimension {
            Dimension::Mass | Dimension::Inertia => (LB, [0, 1, 0, 0]),
            _ => (LBF, [1, 1, -2, 0]),
        });
    }
    let unit = match unit {
        "\"" | "″" | "inch" | "inches" | "pulgada" | "pulgadas" => "in",
        "'" | "′" | "foot" | "feet" | "pie" | "pies" => "ft",
        "r" | "revs" | "turns" | "revolutions" | "vuelta" | "vueltas" => "rev",
        "degree" | "degrees" | "grado" | "grados" => "deg",
        "sec" | "secs" | "seconds" | "segundo" | "segundos" => "s",
        "RPM" => "rpm",
        _ => unit,
    };
    UNITS
        .iter()
        .find(|(n, ..)| *n == unit)
        .map(|&(_, f, e)| (f, e))
}

fn unknown_unit(unit: &str, dimension: Dimension) -> Error {
    let fits = |u: &&(&'static str, f64, Exponents)| u.2 == dimension.exponents();
    let shouted = |u: &&(&'static str, f64, Exponents)| u.0.eq_ignore_ascii_case(unit);
    // If the unit is itself a number, no similar unit is suggested.
    let worded = !unit.starts_with(|c: char| c.is_ascii_digit());
    // Order of preference: equal letters and dimension, similar letters and equal dimension, equal letters, similar letters.
    let meant = (UNITS.iter().filter(fits).find(shouted).map(|u| u.0))
        .or_else(|| nearest(unit, UNITS.iter().filter(fits).map(|u| u.0)))
        .or_else(|| UNITS.iter().find(shouted).map(|u| u.0))
        .or_else(|| nearest(unit, UNITS.iter().map(|u| u.0)))
        .filter(|_| worded);
    // If a unit is followed by a digit, the caret is probably missing: `in3` instead of `in^3`.
    let base = unit.trim_end_matches(|c: char| c.is_ascii_digit());
    let power = (base.len() < unit.len() && lookup(base, dimension).is_some())
        .then(|| format!("{base}^{}", &unit[base.len()..]));
    let nearest = power.or_else(|| meant.map(str::to_string));
    let unit = unit.to_string();
    UnitsError::UnknownUnit { unit, nearest }.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_written_without_marks() {
        for (text, plain) in [
            ("1.234,5 mm", "1234.5 mm"),
            ("1,234.5 mm", "1234.5 mm"),
            ("-1.234.567 mm", "-1234567 mm"),
            ("12.345.678,25mm", "12345678.25mm"),
        ] {
            let refused = parse(text, Dimension::Length).unwrap_err();
            let (text, plain) = (text.to_string(), plain.to_string());
            assert_eq!(refused.fault(), Some(&UnitsError::Grouped { text, plain }));
        }
        for text in ["1,5 mm", "1.5 mm", "1234.5 mm", "1 3/8 in", "1,234 mm"] {
            assert!(parse(text, Dimension::Length).is_ok(), "{text}");
        }
    }

    #[test]
    fn values_whose_products_overflow_are_refused() {
        for text in ["1e300", "-1e31", "1e400"] {
            let refused = parse(text, Dimension::Ratio).unwrap_err();
            let text = text.to_string();
            assert_eq!(refused.fault(), Some(&UnitsError::OutOfRange { text }));
        }
        assert!(parse("1e28 km", Dimension::Length).is_err());
        for text in ["0", "-1e30", "1e-120", "1e27"] {
            assert!(parse(text, Dimension::Ratio).is_ok(), "{text}");
        }
        assert_eq!(parse("0 mm", Dimension::Length).unwrap(), 0.0);
    }

    #[test]
    fn compound_units_reduce_to_si() {
        let close = |text, dimension, expected: f64| {
            let got = parse(text, dimension).unwrap();
            assert!((got / expected - 1.0).abs() < 1e-12, "{text}: {got}");
        };
        close("3 in", Dimension::Length, 0.0762);
        for speed in [
            "120 1/min",
            "120 min^-1",
            "120min⁻¹",
            "2 rps",
            "2 rev/s",
            "120 RPM",
        ] {
            close(speed, Dimension::AngularSpeed, 2.0 * std::f64::consts::TAU);
        }
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
    fn numbers_and_units_are_read_as_people_type_them() {
        let inch = 0.0254;
        let turn = std::f64::consts::TAU / 60.0;
        for (text, dimension, expected) in [
            ("2,5 bar", Dimension::Pressure, 2.5e5),
            ("0,4 s", Dimension::Time, 0.4),
            ("-7,5rad/s", Dimension::AngularSpeed, -7.5),
            ("1,5e-3 m", Dimension::Length, 1.5e-3),
            ("3/8 in", Dimension::Length, 0.375 * inch),
            ("3/8\"", Dimension::Length, 0.375 * inch),
            ("1 3/8\"", Dimension::Length, 1.375 * inch),
            ("1-3/8 in", Dimension::Length, 1.375 * inch),
            ("-1 1/2 in", Dimension::Length, -1.5 * inch),
            ("1 / 4 inch", Dimension::Length, 0.25 * inch),
            ("2 inches", Dimension::Length, 2.0 * inch),
            ("100 RPM", Dimension::AngularSpeed, 100.0 * turn),
            ("100 r/min", Dimension::AngularSpeed, 100.0 * turn),
            ("100 rev/min", Dimension::AngularSpeed, 100.0 * turn),
            ("1/3", Dimension::Ratio, 1.0 / 3.0),
            ("1 /s", Dimension::Frequency, 1.0),
        ] {
            let got = parse(text, dimension);
            let near = got
                .as_ref()
                .is_ok_and(|x| (x / expected - 1.0).abs() < 1e-12);
            assert!(near, "{text}: {got:?}");
        }
        // Texts that may be lists or have thousands separators, and divisions by zero, are rejected.
        for text in [
            "1,000.5 mm",
            "1.000,5 mm",
            "1,2,3 mm",
            "1, 2 mm",
            ",5 mm",
            "1/0 in",
            "1 2 mm",
        ] {
            assert!(parse(text, Dimension::Length).is_err(), "{text}");
        }
    }

    #[test]
    fn bare_numbers_wrong_kinds_and_unknown_units_are_refused_with_advice() {
        let message = |t, d| parse(t, d).unwrap_err().to_string();
        assert!(message("3", Dimension::Length).contains("has no unit"));
        assert!(message("3 deg", Dimension::Length).contains("not a unit of length"));
        assert!(message("3 nm", Dimension::Length).contains("did you mean"));
        assert!(!message("4 0 mm", Dimension::Length).contains("did you mean"));
        assert!(message("abc", Dimension::Length).contains("does not start with a number"));
        assert!(message("1e999 mm", Dimension::Length).contains("exceeds 1e30"));
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
            ("5 mpa", Dimension::Pressure, "\"MPa\""),
            ("1 KG", Dimension::Mass, "\"kg\""),
        ] {
            let words = message(text, dimension);
            assert!(words.contains(meant), "{words}");
        }
    }

    #[test]
    fn units_in_words_of_both_languages_are_read_and_a_missing_power_sign_is_found() {
        for (text, dimension, value) in [
            ("90 grados", Dimension::Angle, std::f64::consts::FRAC_PI_2),
            ("1 degree", Dimension::Angle, std::f64::consts::PI / 180.0),
            ("2 pulgadas", Dimension::Length, 0.0508),
            ("800 pounds", Dimension::Force, 800.0 * LBF),
            ("0,5 vueltas", Dimension::Angle, std::f64::consts::PI),
        ] {
            let read = parse(text, dimension).unwrap();
            assert!((read / value - 1.0).abs() < 1e-12, "{text}: {read}");
        }
        let refused = parse("30 psi/in3", Dimension::PressurePerVolume).unwrap_err();
        let (unit, nearest) = ("in3".to_string(), Some("in^3".to_string()));
        let fault = UnitsError::UnknownUnit { unit, nearest };
        assert_eq!(refused.fault(), Some(&fault));
    }
}
