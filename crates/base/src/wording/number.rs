//! Numbers and quantities as text for users.

use std::sync::OnceLock;

use super::Language;

/// Unit in which lengths are displayed.
///
/// ```standalone_crate
/// use gaitcam_base::wording::{Language, LengthUnit, display_lengths_in, quantity};
///
/// display_lengths_in(LengthUnit::Inch);
/// assert_eq!(quantity(Language::En, 0.0254, "m"), "1 in");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthUnit {
    /// Lengths are displayed in millimetres. This is the default.
    Millimetre,
    /// Lengths are displayed in inches. Units that contain a length are also converted, for example to in/s.
    Inch,
}

static LENGTH_UNIT: OnceLock<LengthUnit> = OnceLock::new();

/// Sets the unit of displayed lengths for the whole process. A second call has no effect.
pub fn display_lengths_in(unit: LengthUnit) {
    let _ = LENGTH_UNIT.set(unit);
}

fn in_inches() -> bool {
    LENGTH_UNIT.get() == Some(&LengthUnit::Inch)
}

/// SI unit, displayed unit, and the factor from the SI unit to the displayed unit.
const SHOWN: &[(&str, &str, f64)] = &[
    ("m", "mm", 1e3),
    ("rad", "°", 180.0 / std::f64::consts::PI),
    ("ratio", "%", 100.0),
    ("m/s^2", "m/s²", 1.0),
    ("m/s^3", "m/s³", 1.0),
    ("rad/s^2", "rad/s²", 1.0),
    ("rad/s^3", "rad/s³", 1.0),
    ("Pa", "MPa", 1e-6),
    ("Pa/m^3", "Pa/m³", 1.0),
    ("N s/m", "N·s/m", 1.0),
    ("N m", "N·m", 1.0),
    ("N m/rad", "N·m/rad", 1.0),
    ("kg m^2", "kg·m²", 1.0),
    ("m/rad", "mm/rad", 1e3),
    ("m/rad^2", "mm/rad²", 1e3),
    ("m/rad^3", "mm/rad³", 1e3),
    ("m/rad^4", "mm/rad⁴", 1e3),
    ("m/m", "mm/mm", 1.0),
    ("m/m^2", "mm/mm²", 1e-3),
    ("m/m^3", "mm/mm³", 1e-6),
    ("m/m^4", "mm/mm⁴", 1e-9),
    ("rad/rad^2", "rad/rad²", 1.0),
    ("rad/rad^3", "rad/rad³", 1.0),
];

/// Number of inches in a metre.
const INCHES: f64 = 1.0 / 0.0254;

/// Displayed units, as in [`SHOWN`], of quantities that contain a length. They apply if lengths are displayed in inches.
const SHOWN_IN_INCHES: &[(&str, &str, f64)] = &[
    ("m", "in", INCHES),
    ("m/s", "in/s", INCHES),
    ("m/s^2", "in/s²", INCHES),
    ("m/s^3", "in/s³", INCHES),
    ("m/rad", "in/rad", INCHES),
    ("m/rad^2", "in/rad²", INCHES),
    ("m/rad^3", "in/rad³", INCHES),
    ("m/rad^4", "in/rad⁴", INCHES),
    ("m/m", "in/in", 1.0),
    ("m/m^2", "in/in²", 1.0 / INCHES),
    ("m/m^3", "in/in³", 1.0 / (INCHES * INCHES)),
    ("m/m^4", "in/in⁴", 1.0 / (INCHES * INCHES * INCHES)),
];

/// Maximum number of significant digits for display.
pub const DIGITS: usize = 4;
/// Number of significant digits of values in errors and suggested changes, because users enter these values again.
pub(super) const EXACT: usize = 6;

/// A number for display with at most four significant digits and no trailing zeros. `−0` becomes 0, and the Spanish text has a decimal
/// comma.
///
/// ```
/// use gaitcam_base::wording::{Language, number};
/// assert_eq!(number(Language::En, 13.636), "13.64");
/// assert_eq!(number(Language::Es, -0.5), "−0,5");
/// assert_eq!(number(Language::En, 3.2e-9), "3.2e−9");
/// assert_eq!(number(Language::En, f64::INFINITY), "∞");
/// ```
pub fn number(language: Language, value: f64) -> String {
    rounded(language, value, DIGITS)
}

/// A number formatted as by [`number`], with a given maximum number of significant digits.
///
/// ```
/// use gaitcam_base::wording::{Language, rounded};
/// assert_eq!(rounded(Language::Es, 3.4632, 3), "3,46");
/// ```
pub fn rounded(language: Language, value: f64, digits: usize) -> String {
    to_digits(language, value, digits).replace('-', "−")
}

/// A number that users may enter again: six significant digits, with an ASCII minus sign.
///
/// ```
/// use gaitcam_base::wording::{Language, exact};
/// assert_eq!(exact(Language::En, -13.6362), "-13.6362");
/// ```
pub fn exact(language: Language, value: f64) -> String {
    to_digits(language, value, EXACT)
}

/// Range "low … high" for display. A limit that is zero up to rounding errors is displayed as 0.
///
/// ```
/// use gaitcam_base::wording::{Language, range};
/// assert_eq!(range(Language::Es, -1e-14, 2.5), "0 … 2,5");
/// ```
pub fn range(language: Language, low: f64, high: f64) -> String {
    let noise = 1e-9 * (high - low).abs();
    let [low, high] = [low, high].map(|x| if x.abs() < noise { 0.0 } else { x });
    format!("{} … {}", number(language, low), number(language, high))
}

/// An angle in rad, displayed in degrees with one decimal.
///
/// ```
/// use gaitcam_base::wording::{Language, degrees};
/// assert_eq!(degrees(Language::Es, -0.5), "−28,6°");
/// ```
pub fn degrees(language: Language, theta: f64) -> String {
    let text = fixed(language, theta.to_degrees(), 1);
    format!("{text}°").replace('-', "−")
}

/// A number as text with a given maximum number of significant digits.
fn to_digits(language: Language, value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "—".to_string();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_string();
    }
    let size = value.abs();
    let text = if size != 0.0 && !(1e-4..1e9).contains(&size) {
        let text = format!("{value:.*e}", digits - 1);
        match text.split_once('e') {
            Some((mantissa, power)) => format!("{}e{power}", short(mantissa)),
            None => text,
        }
    } else {
        let lead = if size == 0.0 {
            0.0
        } else {
            libm::log10(size).floor()
        };
        let decimals = (digits as f64 - 1.0 - lead).max(0.0) as usize;
        short(&format!("{value:.decimals$}")).to_string()
    };
    localised(language, if text == "-0" { "0" } else { &text })
}

fn localised(language: Language, text: &str) -> String {
    match language {
        Language::En => text.to_string(),
        Language::Es => text.replace('.', ","),
    }
}

/// A number as text with a fixed number of decimals, for columns of a table.
///
/// ```
/// use gaitcam_base::wording::{Language, fixed};
/// assert_eq!(fixed(Language::Es, 1.05, 3), "1,050");
/// ```
pub fn fixed(language: Language, value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let zero = text.starts_with('-') && text.chars().all(|c| "-0.".contains(c));
    localised(language, if zero { &text[1..] } else { &text })
}

/// Name of a walker for display. The name of a walker from a load model is a step frequency. This frequency is displayed with the decimal
/// mark of the language.
///
/// ```
/// use gaitcam_base::wording::{Language, walker};
/// assert_eq!(walker(Language::Es, "2.4 Hz"), "2,4 Hz");
/// assert_eq!(walker(Language::Es, "trial 2.4"), "trial 2.4");
/// ```
pub fn walker(language: Language, name: &str) -> String {
    match name.strip_suffix(" Hz").map(str::parse::<f64>) {
        Some(Ok(_)) => localised(language, name),
        _ => name.to_string(),
    }
}

fn short(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

/// Displayed unit for an SI unit, and the factor by which a value in the SI unit is multiplied.
pub fn people(si: &str) -> (&str, f64) {
    let inches = if in_inches() { SHOWN_IN_INCHES } else { &[] };
    inches
        .iter()
        .chain(SHOWN)
        .find(|row| row.0 == si)
        .map_or((si, 1.0), |row| (row.1, row.2))
}

/// A quantity in SI units as text in its common unit: 0.0136 m is `13.6 mm`.
///
/// ```
/// use gaitcam_base::wording::{Language, quantity};
/// assert_eq!(quantity(Language::En, 0.0136, "m"), "13.6 mm");
/// assert_eq!(quantity(Language::En, 0.005, "ratio"), "0.5 %");
/// assert_eq!(quantity(Language::En, std::f64::consts::PI, "rad"), "180°");
/// ```
pub fn quantity(language: Language, value: f64, unit: &str) -> String {
    quantity_to_digits(language, value, unit, DIGITS).replace('-', "−")
}

/// A quantity formatted as by [`quantity`], with another number of significant digits.
pub(super) fn quantity_to_digits(
    language: Language,
    value: f64,
    unit: &str,
    digits: usize,
) -> String {
    let (shown, factor) = people(unit);
    let number = to_digits(language, factor * value, digits);
    match shown {
        "" => number,
        "°" => format!("{number}°"),
        _ => format!("{number} {shown}"),
    }
}
