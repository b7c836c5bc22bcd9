//! A varied key with its values. The values are a range of numbers or a list.

use std::sync::Arc;

use toml::Table;

use super::key::{Key, starts_a_number};
use crate::error::{Placed, Result, SweepError};

/// The values of a varied key.
///
/// ```
/// use gaitcam::sweep::{Axis, Values};
///
/// let axis = Axis::parse("limits.stroke=40 mm:60 mm:5", false)?;
/// let unit = "m".to_string();
/// assert_eq!(axis.values, Values::Range { first: 0.04, last: 0.06, count: Some(5), unit });
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// A list of words, whole numbers or paths, each stored as text.
    Words(Vec<Arc<str>>),
    /// A list of numbers in SI units.
    Numbers(Vec<f64>),
    /// Equally spaced numbers from a first to a last value, both included.
    Range {
        /// First value of the range.
        first: f64,
        /// Last value of the range.
        last: f64,
        /// Number of values; `None` for a range from which values are sampled.
        count: Option<u64>,
        /// Unit of the values. For a key with a known dimension, it is the SI unit. Otherwise, it is the unit in the text of the range. It
        /// is empty for whole numbers, and the values are then rounded.
        unit: String,
    },
}

/// One value of a varied key.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisValue {
    /// A number in SI units.
    Number(f64),
    /// A word, whole number or path, as in the plan.
    Words(Arc<str>),
}

/// A varied key with its values.
///
/// ```
/// use gaitcam::sweep::Axis;
///
/// let axis = Axis::parse("law.family=spline,harmonic", false)?;
/// assert_eq!((axis.key.name(), axis.count()), ("law.family", Some(2)));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The varied key.
    pub key: Key,
    /// The values of the key.
    pub values: Values,
}

impl AxisValue {
    /// Sets the value of a key in the table of a scene.
    pub(super) fn write(&self, key: &Key, table: &mut Table) -> Result<()> {
        match self {
            AxisValue::Number(x) => key.write_number(table, *x),
            AxisValue::Words(w) => key.write_words(table, w),
        }
    }
}

impl Axis {
    /// Parses `KEY=START:STOP:COUNT` or `KEY=A,B,C`. If `sampled` is true, the form of a range is `KEY=START:STOP`.
    ///
    /// # Errors
    ///
    /// The `=` is missing, the list is empty, or a number does not have the unit of the key. The count of a range is missing, zero or
    /// invalid, or it is given although `sampled` is true.
    pub fn parse(text: &str, sampled: bool) -> Result<Axis> {
        let Some((name, values)) = text.split_once('=') else {
            return Err(SweepError::NoAssignment {
                typed: text.to_string(),
            }
            .into());
        };
        let (name, values) = (name.trim(), values.trim());
        let parts: Vec<&str> = values.split(':').map(str::trim).collect();
        if matches!(parts.len(), 2 | 3) && parts[..2].iter().all(|t| starts_a_number(t)) {
            return range(name, &parts, sampled);
        }
        Axis::list(name, parts_of(values).into_iter().map(str::trim))
    }

    /// Creates an axis from a list of values.
    ///
    /// # Errors
    ///
    /// The list or a value is empty, or a number does not have the unit of the key.
    pub fn list<'a>(name: &str, values: impl Iterator<Item = &'a str>) -> Result<Axis> {
        let values: Vec<&str> = values.collect();
        if values.is_empty() || values.contains(&"") {
            return Err(SweepError::NoValues.at_key(name));
        }
        Ok(match Key::quantity(name, &values)? {
            Some((key, numbers)) => Axis {
                key,
                values: Values::Numbers(numbers),
            },
            None => Axis {
                key: Key::words(name),
                values: Values::Words(values.into_iter().map(Arc::from).collect()),
            },
        })
    }

    /// Number of values; `None` for a range from which values are sampled.
    pub fn count(&self) -> Option<u64> {
        match &self.values {
            Values::Words(list) => Some(list.len() as u64),
            Values::Numbers(list) => Some(list.len() as u64),
            Values::Range { count, .. } => *count,
        }
    }

    /// Value with the index `i`, from 0, of a list or of a range with a count.
    pub fn value(&self, i: u64) -> AxisValue {
        match &self.values {
            Values::Words(list) => AxisValue::Words(list[i as usize].clone()),
            Values::Numbers(list) => AxisValue::Number(list[i as usize]),
            Values::Range { count, .. } => {
                let steps = count.unwrap_or(1).saturating_sub(1).max(1);
                self.between(i as f64, steps as f64)
            }
        }
    }

    /// Sets the key to its first value in the table of a scene.
    ///
    /// # Errors
    ///
    /// The section that contains the key has a single value in the scene, and no keys.
    pub fn begin(&self, table: &mut Table) -> Result<()> {
        self.sampled(0.0).write(&self.key, table)
    }

    /// Value at the fraction u ∈ [0, 1] of the axis. It is a number between the first and the last value of a range, or an element of a
    /// list.
    pub fn sampled(&self, u: f64) -> AxisValue {
        match &self.values {
            Values::Words(list) => AxisValue::Words(list[pick(u, list.len())].clone()),
            Values::Numbers(list) => AxisValue::Number(list[pick(u, list.len())]),
            Values::Range { .. } => self.between(u, 1.0),
        }
    }

    /// Value after `part` of `whole` equal steps from the first to the last value. The first and the last value are exact.
    fn between(&self, part: f64, whole: f64) -> AxisValue {
        let Values::Range {
            first, last, unit, ..
        } = &self.values
        else {
            return self.value(0);
        };
        let x = ((whole - part) * first + part * last) / whole;
        if self.key.is_number() {
            return AxisValue::Number(x);
        }
        AxisValue::Words(if unit.is_empty() {
            Arc::from(format!("{}", x.round()))
        } else {
            Arc::from(format!("{x} {unit}"))
        })
    }

    /// Values of the axis as text, for the comparison of plans.
    pub fn text(&self) -> String {
        match &self.values {
            Values::Words(list) => list.join(","),
            Values::Numbers(list) => {
                let unit = self.key.unit();
                let all: Vec<String> = list.iter().map(|x| format!("{x} {unit}")).collect();
                all.join(",")
            }
            Values::Range {
                first,
                last,
                count,
                unit,
            } => {
                let count = count.map_or(String::new(), |c| format!(":{c}"));
                format!("{first} {unit}:{last} {unit}{count}")
            }
        }
    }
}

/// Divides the text of a list at its commas. Commas within brackets are ignored. Within brackets, quotes enclose text that may contain
/// brackets.
fn parts_of(values: &str) -> Vec<&str> {
    let (mut out, mut begin) = (Vec::new(), 0);
    let (mut depth, mut quote) = (0_usize, None);
    for (at, c) in values.char_indices() {
        match (c, quote) {
            (_, Some(open)) if c == open => quote = None,
            (_, Some(_)) => {}
            ('"' | '\'', None) if depth > 0 => quote = Some(c),
            ('[', None) => depth += 1,
            (']', None) => depth = depth.saturating_sub(1),
            (',', None) if depth == 0 => {
                out.push(&values[begin..at]);
                begin = at + 1;
            }
            _ => {}
        }
    }
    out.push(&values[begin..]);
    out
}

fn pick(u: f64, length: usize) -> usize {
    ((u * length as f64) as usize).min(length - 1)
}

fn range(name: &str, parts: &[&str], sampled: bool) -> Result<Axis> {
    let count = count(parts.get(2).copied(), sampled).map_err(|e| e.at_key(name))?;
    let (key, first, last, unit) = match Key::quantity(name, &parts[..2])? {
        Some((key, ends)) => {
            let unit = key.unit().to_string();
            (key, ends[0], ends[1], unit)
        }
        None => {
            let (first, unit) = number_and_unit(parts[0]).map_err(|e| e.at_key(name))?;
            let (last, other) = number_and_unit(parts[1]).map_err(|e| e.at_key(name))?;
            if unit != other {
                let (first, last) = (unit.to_string(), other.to_string());
                return Err(SweepError::DifferentUnits { first, last }.at_key(name));
            }
            (Key::words(name), first, last, unit.to_string())
        }
    };
    let values = Values::Range {
        first,
        last,
        count,
        unit,
    };
    Ok(Axis { key, values })
}

/// Parses the number of values of a range; `None` for a range from which values are sampled.
fn count(typed: Option<&str>, sampled: bool) -> std::result::Result<Option<u64>, SweepError> {
    match (typed, sampled) {
        (Some(_), true) => Err(SweepError::SampledCount),
        (None, false) => Err(SweepError::NoCount),
        (None, true) => Ok(None),
        (Some(text), false) => match text.parse() {
            Ok(0) => Err(SweepError::NoValues),
            Ok(count) => Ok(Some(count)),
            Err(_) => {
                let typed = text.to_string();
                Err(SweepError::NotCount { typed })
            }
        },
    }
}

fn number_and_unit(text: &str) -> std::result::Result<(f64, &str), SweepError> {
    let split = (1..=text.len())
        .rev()
        .filter(|&i| text.is_char_boundary(i))
        .find_map(|i| Some((text[..i].trim().parse::<f64>().ok()?, text[i..].trim())));
    split.filter(|(x, _)| x.is_finite()).ok_or_else(|| {
        let typed = text.to_string();
        SweepError::NotNumber { typed }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_run_from_end_to_end_in_si() {
        let axis = Axis::parse("limits.stroke=20 mm:0.06 m:5", false).unwrap();
        assert_eq!(axis.count(), Some(5));
        assert_eq!(axis.value(0), AxisValue::Number(0.02));
        assert_eq!(axis.value(4), AxisValue::Number(0.06));
        assert_eq!(axis.key.column(), "limits.stroke_m");
        let axis = Axis::parse("law.spans=8:32:4", false).unwrap();
        assert_eq!(axis.value(1), AxisValue::Words("16".into()));
    }

    #[test]
    fn a_value_may_be_a_list_itself() {
        let typed = r#"gait.file=[ "a, b.csv", 'c].csv' ], people/ ,d.csv"#;
        let axis = Axis::parse(typed, false).unwrap();
        let value = |i| match axis.value(i) {
            AxisValue::Words(words) => words.to_string(),
            AxisValue::Number(_) => panic!(),
        };
        assert_eq!(axis.count(), Some(3));
        assert_eq!(value(0), r#"[ "a, b.csv", 'c].csv' ]"#);
        assert_eq!((value(1).as_str(), value(2).as_str()), ("people/", "d.csv"));
    }

    #[test]
    fn bad_axes_have_their_codes() {
        for (text, code) in [
            ("limits.stroke", "sweep-no-assignment"),
            ("limits.stroke=20:60:5", "units-no-unit"),
            ("limits.stroke=20 mm:60 mm:0", "sweep-no-values"),
            ("law.family=", "sweep-no-values"),
            ("law.family=spline,", "sweep-no-values"),
            ("limits.stroke=20 mm:60 mm", "sweep-no-count"),
            ("limits.stroke=20 mm:60 mm:many", "sweep-not-count"),
        ] {
            let fault = Axis::parse(text, false).unwrap_err();
            assert_eq!(fault.code(), code, "{text}");
        }
    }
}
