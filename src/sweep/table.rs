//! Rows as CSV: numbers in their shortest exact form, empty where there is none.

use std::fmt::Write;

use super::batch::{Batch, Column};
use super::key::Key;
use super::results::{NUMBERS, Results, TIME, WORDS};

/// Names of all columns: row, base scene (where there are several), varied keys, results, time.
pub fn header(keys: &[Key], several_scenes: bool) -> Vec<String> {
    let mut out = vec!["row".to_string()];
    if several_scenes {
        out.push("scene".to_string());
    }
    out.extend(keys.iter().map(Key::column));
    out.extend(NUMBERS.iter().chain(&WORDS).map(|s| (*s).to_string()));
    out.push(TIME.to_string());
    out
}

/// The head line.
pub fn csv_header(keys: &[Key], several_scenes: bool) -> String {
    let mut out = String::new();
    for (i, name) in header(keys, several_scenes).iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        quoted(&mut out, name);
    }
    out.push('\n');
    out
}

/// The rows `first …` as lines. `scenes` are the names of the base scenes where there are several.
pub fn csv_rows(first: u64, batch: &Batch, results: &Results, scenes: Option<&[String]>) -> String {
    let rows = results.len();
    let mut out = String::with_capacity(rows * 24 * (NUMBERS.len() + batch.columns.len() + 4));
    let words: Vec<Vec<&str>> = (0..WORDS.len()).map(|c| results.words(c)).collect();
    for row in 0..rows {
        // Writing to a String cannot fail.
        let _ = write!(out, "{}", first + row as u64);
        if let Some(names) = scenes {
            out.push(',');
            quoted(
                &mut out,
                names
                    .get(batch.scene[row] as usize)
                    .map_or("", String::as_str),
            );
        }
        for column in &batch.columns {
            out.push(',');
            match column {
                Column::Numbers(x) => number(&mut out, x[row]),
                Column::Words(x) => quoted(&mut out, &x[row]),
            }
        }
        for column in 0..NUMBERS.len() {
            out.push(',');
            number(&mut out, results.numbers(column)[row]);
        }
        for column in &words {
            out.push(',');
            quoted(&mut out, column[row]);
        }
        out.push(',');
        let _ = writeln!(out, "{:.3e}", results.times()[row]);
    }
    out
}

/// Endings of columns with the units they stand for.
const UNITS: [(&str, &str); 18] = [
    ("_m_per_s3", "m/s^3"),
    ("_m_per_s2", "m/s^2"),
    ("_pa_per_m3", "Pa/m^3"),
    ("_n_s_per_m", "N s/m"),
    ("_n_m_per_rad", "N m/rad"),
    ("_n_per_m", "N/m"),
    ("_rad_per_s", "rad/s"),
    ("_m_per_s", "m/s"),
    ("_percent", "%"),
    ("_n_m", "N m"),
    ("_pa", "Pa"),
    ("_hz", "Hz"),
    ("_kg", "kg"),
    ("_rad", "rad"),
    ("_n", "N"),
    ("_w", "W"),
    ("_m", "m"),
    ("_s", "s"),
];

fn unit_entry(column: &str) -> Option<(&'static str, &'static str)> {
    UNITS.into_iter().find(|u| column.ends_with(u.0))
}

/// Unit of a column from the end of its name; empty for words, counts and ratios.
pub fn unit_of(column: &str) -> &'static str {
    unit_entry(column).map_or("", |u| u.1)
}

/// A column's name for people: `limits.stroke, m`.
pub fn label(column: &str) -> String {
    let (ending, unit) = unit_entry(column).unwrap_or(("", ""));
    let name = column.strip_suffix(ending).unwrap_or(column);
    let name = name.replace('_', " ");
    if unit.is_empty() {
        return name;
    }
    format!("{name}, {}", unit.replace("^2", "²").replace("^3", "³"))
}

/// The shortest form that reads back to the same number, with an exponent below 1e-5 and from 1e16 on.
fn number(out: &mut String, x: f64) {
    if x.is_nan() {
        return;
    }
    if x.is_finite() && x.abs() >= 1e16 {
        // Without the sign that the exponent would get below.
        let _ = write!(out, "{x:e}");
        return;
    }
    let mut digits = zmij::Buffer::new();
    let text = digits.format(x);
    out.push_str(text.strip_suffix(".0").unwrap_or(text));
}

fn quoted(out: &mut String, text: &str) {
    let ends = |b: u8| matches!(b, b',' | b'"' | b'\n' | b'\r');
    if text.bytes().any(ends) {
        out.push('"');
        out.push_str(&text.replace('"', "\"\""));
        out.push('"');
    } else {
        out.push_str(text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::{Outcome, Row};

    #[test]
    fn lines_have_as_many_fields_as_the_header() {
        let keys = [Key::words("law.family")];
        let mut results = Results::with_capacity(1);
        results.push(Row::error("a, \"b\"".to_string()));
        let batch = Batch {
            scene: vec![0],
            columns: vec![Column::Words(vec!["spline".into()])],
        };
        let text =
            csv_header(&keys, true) + &csv_rows(9, &batch, &results, Some(&["x.toml".to_string()]));
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let error = reader.headers().unwrap().iter().position(|h| h == "error");
        let record = reader.records().next().unwrap().unwrap();
        assert_eq!(&record[0], "9");
        assert_eq!(&record[error.unwrap()], "a, \"b\"");
        let fields: Vec<&str> = record.iter().collect();
        let row = Row::of_fields(&fields);
        assert_eq!((row.outcome, &*row.error), (Outcome::Error, "a, \"b\""));
    }

    #[test]
    fn numbers_are_written_as_the_standard_library_writes_them() {
        let shown = |x: f64| {
            let mut out = String::new();
            number(&mut out, x);
            out
        };
        let scales = (-20..22).map(|power| 10f64.powi(power));
        let all =
            scales.flat_map(|scale| [1.0, 1.5, -2.75, 9.999_999_999_999_99].map(|x| x * scale));
        let special = [
            0.0,
            -0.0,
            f64::INFINITY,
            f64::NEG_INFINITY,
            1e-5,
            9.99e-6,
            1e16,
            5e-324,
        ];
        for x in all.chain(special) {
            let size = x.abs();
            let plain = size == 0.0 || (1e-5..1e16).contains(&size) || !x.is_finite();
            let expected = if plain {
                format!("{x}")
            } else {
                format!("{x:e}")
            };
            assert_eq!(shown(x), expected);
        }
        assert_eq!(shown(f64::NAN), "");
    }
}
