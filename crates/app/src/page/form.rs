//! Contents of the form for one scene: text, placeholder and slider of each field.

use std::collections::BTreeMap;

use serde::Serialize;
use toml::{Table, Value};

use gaitcam::cam::Unit;
use gaitcam::scene::Scene;
use gaitcam::scene::keys::{KEYS, Key, Kind, Range};
use gaitcam::synth::{Design, FIGURES, Figure, Figures};
use gaitcam::units::{Dimension, parse};

/// Contents of one field of the form.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Field {
    /// Text of the value in the scene file. It is empty if the scene omits the key.
    pub text: String,
    /// Text that an empty field shows: the value in the design, or the default.
    pub placeholder: String,
    /// Value of the design for a key that the scene omits or sets to `auto`. `None` for other keys.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub taken: Option<String>,
    /// Whether the key has an effect in this scene.
    pub acts: bool,
    /// Slider of the field; `None` for a key without a suitable range.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slider: Option<Slider>,
}

/// Range and position of a slider, in the unit of its field.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Slider {
    /// Lower end of the slider, in `unit`.
    pub from: f64,
    /// Upper end of the slider, in `unit`.
    pub to: f64,
    /// Step of the slider, in `unit`.
    pub step: f64,
    /// Position of the slider, in `unit`.
    pub at: f64,
    /// Unit after the number in a scene file, including the space before it. It is empty for a count.
    pub unit: String,
}

/// Form fields of all keys that exist in the scene, by key. The keys of list entries contain the numbers of the entries.
pub fn fields(table: &Table, scene: &Scene, design: Option<&Design>) -> BTreeMap<String, Field> {
    let figures = design.map(Figures::of);
    let several = design
        .and_then(|d| d.population.as_ref())
        .filter(|p| p.cycles > 1);
    let mut out = BTreeMap::new();
    for key in KEYS.iter().filter(|k| k.exists(scene)) {
        let count = key.list().map_or(1, |list| length(table, list));
        for index in 0..count {
            let path = key.path_at(index);
            let text = typed(table, &path);
            let in_design = match several.filter(|_| key.path == "accuracy.rms") {
                // For several walkers, the limit applies to the objective over all walkers, which the design minimises.
                Some(all) => Some(all.objective_percent / 100.0),
                None => value_in_design(key.path, scene, figures.as_ref()),
            };
            let slider = slider(key, scene, index, &text, in_design);
            let placeholder = match in_design.zip(key.dimension(scene)) {
                Some((value, dimension)) if text.is_empty() || text == "auto" => {
                    shown(value, dimension)
                }
                _ => key.default.to_string(),
            };
            let accepted = design.and_then(|d| d.problem.accuracy);
            let taken = match key.path {
                "accuracy.rms" => accepted,
                _ => in_design,
            };
            let taken = taken
                .filter(|_| text.is_empty() || text == "auto")
                .zip(key.dimension(scene));
            let taken = taken.map(|(value, dimension)| shown(value, dimension));
            let acts = key.idle(scene).is_none();
            out.insert(
                path,
                Field {
                    text,
                    placeholder,
                    taken,
                    acts,
                    slider,
                },
            );
        }
    }
    out
}

fn at<'t>(table: &'t Table, path: &str) -> Option<&'t Value> {
    let (first, rest) = path
        .split_once('.')
        .map_or((path, None), |(f, r)| (f, Some(r)));
    let value = table.get(first)?;
    match (value, rest) {
        (value, None) => Some(value),
        (Value::Table(inner), Some(rest)) => at(inner, rest),
        (Value::Array(list), Some(rest)) => {
            let (number, rest) = rest.split_once('.')?;
            let entry = list.get(number.parse::<usize>().ok()?.checked_sub(1)?)?;
            at(entry.as_table()?, rest)
        }
        _ => None,
    }
}

fn length(table: &Table, list: &str) -> usize {
    at(table, list)
        .and_then(Value::as_array)
        .map_or(0, Vec::len)
}

/// Text of a value in its field, without quotation marks. It is empty if the scene omits the key.
pub fn typed(table: &Table, path: &str) -> String {
    match at(table, path) {
        None => String::new(),
        Some(Value::String(text)) => text.clone(),
        Some(Value::Array(list)) if list.iter().all(Value::is_str) && list.len() == 1 => {
            list[0].as_str().unwrap_or("").to_string()
        }
        Some(value) => value.to_string(),
    }
}

/// Value of a key in the design, SI units; `None` if it is unknown.
fn value_in_design(path: &str, scene: &Scene, figures: Option<&Figures>) -> Option<f64> {
    let figures = figures?;
    let value = match path {
        "gait.step_frequency" => {
            let own = scene.gait.as_ref()?.step_frequency;
            own.unwrap_or(figures.speed / std::f64::consts::PI)
        }
        "gait.body_weight" => scene.gait.as_ref()?.model_weight(),
        "accuracy.rms" => figures.force.rms_error_percent_of_mean / 100.0,
        _ => {
            let limit = path.strip_prefix("limits.");
            let of_path = |f: &&Figure| {
                f.settles == Some(path) || f.limit.is_some_and(|kind| limit == Some(kind.name()))
            };
            FIGURES.iter().find(of_path)?.value(figures)
        }
    };
    value.is_finite().then_some(value)
}

/// Text of a value, given in SI units, in the customary unit of scene files.
fn shown(value: f64, dimension: Dimension) -> String {
    let unit = Unit::of(dimension);
    let (number, name) = (short(value * unit.factor), unit.name);
    match name {
        "" => number,
        "°" => format!("{number} deg"),
        _ => format!("{number} {name}"),
    }
}

/// Text of a number with four significant digits, without trailing zeros.
fn short(value: f64) -> String {
    let text = format!("{value:.3e}");
    text.parse::<f64>().map_or(text, |x| format!("{}", x + 0.0))
}

fn slider(
    key: &Key,
    scene: &Scene,
    index: usize,
    text: &str,
    in_design: Option<f64>,
) -> Option<Slider> {
    if let Kind::Count(low, high) = key.kind {
        let at = text.parse::<f64>().ok()?;
        let most = (high as f64).min(round_above(1.3 * at).max(12.0));
        return Some(Slider {
            from: low as f64,
            to: most,
            step: 1.0,
            at,
            unit: String::new(),
        });
    }
    let dimension = key.dimension(scene)?;
    let value = key
        .get(scene, index)
        .and_then(gaitcam::scene::keys::Value::number);
    // An empty field shows the value of the design. A key without any value has no slider.
    let value = value.or(in_design)?;
    let unit = unit_of(text, dimension);
    let factor = parse(&format!("1{unit}"), dimension)
        .ok()
        .filter(|f| *f > 0.0)?;
    let at = value / factor;
    let (from, to) = match usual(key.path) {
        Some((low, high)) if (low..=high).contains(&value) => (low / factor, high / factor),
        _ => ends(key.range, dimension, at, factor)?,
    };
    let step = libm::pow(10_f64, libm::log10((to - from) / 300.0).floor());
    Some(Slider {
        from,
        to,
        step,
        at,
        unit,
    })
}

/// Customary range of a key in SI units, which is narrower than its permitted range; `None` for other keys.
fn usual(path: &str) -> Option<(f64, f64)> {
    match path {
        "gait.step_frequency" => Some((1.0, 3.0)),
        "machine.motor.efficiency" => Some((0.2, 1.0)),
        _ => None,
    }
}

/// Lower and upper end of a slider with the position `at`, in the unit of the field. The ends follow the permitted range, or are rounded
/// numbers at least 30 % above a positive position. `None` if a slider is not possible.
fn ends(range: Range, dimension: Dimension, at: f64, factor: f64) -> Option<(f64, f64)> {
    let ends = match range {
        Range::Acute => (
            tidy(1_f64.to_radians() / factor),
            tidy(80_f64.to_radians() / factor),
        ),
        Range::Between(low, high)
            if high.is_finite() && high / factor < 100.0 * at.abs().max(0.01) =>
        {
            (tidy(low / factor), tidy(high / factor))
        }
        Range::Any if dimension == Dimension::Angle => {
            let half = tidy(std::f64::consts::PI / factor);
            (-half, half)
        }
        Range::Any if dimension == Dimension::Force && at > 0.0 => (0.0, round_above(1.3 * at)),
        Range::Any => {
            let size = match at {
                0.0 => round_above(0.05 / factor),
                _ => round_above(1.3 * at.abs()),
            };
            (-size, size)
        }
        Range::NotNegative if at == 0.0 => return None,
        _ if at > 0.0 => {
            let to = round_above(1.3 * at);
            let from = match range {
                Range::NotNegative => 0.0,
                _ => tidy(to / 50.0),
            };
            (from, to)
        }
        _ => return None,
    };
    Some(ends)
}

/// Smallest number that is 1, 2 or 5 times a power of ten and at least `x`.
fn round_above(x: f64) -> f64 {
    let power = libm::pow(10_f64, libm::log10(x).floor());
    let times = [1.0, 2.0, 5.0, 10.0].into_iter();
    let round = times.map(|t| t * power).find(|r| *r >= x * (1.0 - 1e-9));
    tidy(round.unwrap_or(10.0 * power))
}

/// Number rounded to four significant digits, so that a product with a unit factor has no digits from rounding errors.
fn tidy(x: f64) -> f64 {
    short(x).parse().unwrap_or(x)
}

/// Unit in the text of a quantity, or the customary unit for a text without a unit. A non-empty result begins with a space.
fn unit_of(text: &str, dimension: Dimension) -> String {
    let number = |c: char| c.is_ascii_digit() || "+-.".contains(c);
    let typed = text.trim().trim_start_matches(number).trim();
    if text.starts_with(number)
        && !typed.is_empty()
        && parse(&format!("1 {typed}"), dimension).is_ok()
    {
        return format!(" {typed}");
    }
    match Unit::of(dimension).name {
        "" => String::new(),
        "°" => " deg".to_string(),
        name => format!(" {name}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::scene::{built_in, read, set};

    /// With several walkers, the placeholder is the minimised objective over all walkers, not the error of their mean curve.
    #[test]
    fn an_accuracy_that_is_left_open_shows_the_error_that_would_be_judged() {
        for robust in ["mean", "worst", "cvar 0.5"] {
            let mut table = built_in("footbridge").unwrap().toml.parse().unwrap();
            set(&mut table, "gait.step_frequency=1.4 Hz:2.4 Hz:4").unwrap();
            set(&mut table, &format!("law.robust={robust}")).unwrap();
            set(&mut table, "accuracy.rms=auto").unwrap();
            let scene = read(&table).unwrap();
            let design = scene.design().unwrap();
            let each = &design.population.as_ref().unwrap().each;
            let mut squares: Vec<f64> = each.iter().map(|e| e.rms_error_percent.powi(2)).collect();
            squares.sort_by(|a, b| b.total_cmp(a));
            let counted = match robust {
                "mean" => 4,
                "worst" => 1,
                _ => 2,
            };
            let judged = (squares[..counted].iter().sum::<f64>() / counted as f64).sqrt();
            let field = &fields(&table, &scene, Some(&design))["accuracy.rms"];
            let shown: f64 = field
                .placeholder
                .trim_end_matches('%')
                .trim()
                .parse()
                .unwrap();
            assert!(
                (shown / judged - 1.0).abs() < 1e-3,
                "{robust}: {shown} {judged}"
            );
        }
    }
}
