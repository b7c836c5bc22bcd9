//! Tables as CSV. Numbers have the shortest text from which the exact value can be read. Missing numbers are empty cells.

use std::fmt::Write;

use super::records::{Records, Values};
use super::results::TIME;
use super::text_cell;
use gaitcam_base::text::quoted;

impl Records {
    /// The whole table as CSV: a line with the names of the columns, then the rows.
    pub fn csv(&self) -> String {
        self.csv_header() + &self.csv_rows()
    }

    /// Names of the columns as one line of CSV.
    pub fn csv_header(&self) -> String {
        let names = self.fields.iter().map(|field| quoted(&field.name));
        names.collect::<Vec<_>>().join(",") + "\n"
    }

    /// The rows as lines of CSV. Computing times have four significant digits.
    pub fn csv_rows(&self) -> String {
        let mut out = String::with_capacity(self.len() * 20 * (self.fields.len() + 4));
        for row in 0..self.len() {
            for (i, field) in self.fields.iter().enumerate() {
                if i > 0 {
                    out.push(',');
                }
                // Writing to a String cannot fail.
                match &field.values {
                    Values::Rows(rows) => _ = write!(out, "{}", rows[row]),
                    Values::Numbers(x) if field.name == TIME => _ = write!(out, "{:.3e}", x[row]),
                    Values::Numbers(x) => number(&mut out, x[row]),
                    Values::Words(words) => {
                        out.push_str(&quoted(&text_cell(words.at(row).unwrap_or(""))));
                    }
                }
            }
            out.push('\n');
        }
        out
    }
}

/// Appends the shortest text from which the exact number can be read. The text has an exponent for magnitudes below 1e-5 and from 1e16 on.
/// NaN is empty.
fn number(out: &mut String, x: f64) {
    if x.is_nan() {
        return;
    }
    if x.is_finite() && x.abs() >= 1e16 {
        // The standard format has no plus sign in the exponent, unlike the format below.
        let _ = write!(out, "{x:e}");
        return;
    }
    let mut digits = zmij::Buffer::new();
    let text = digits.format(x);
    out.push_str(text.strip_suffix(".0").unwrap_or(text));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::Field;

    #[test]
    fn a_csv_reader_reads_the_cells_back() {
        let records = Records {
            fields: vec![
                Field::rows(9, 1),
                Field::words("error", ["a, \"b\""].into_iter()),
                Field::numbers("limits.stroke_m", vec![f64::NAN]),
                Field::numbers(TIME, vec![1.0 / 3.0]),
            ],
        };
        let text = records.csv_header() + &records.csv_rows();
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names: Vec<String> = reader
            .headers()
            .unwrap()
            .iter()
            .map(str::to_string)
            .collect();
        assert_eq!(names, ["row", "error", "limits.stroke_m", "time_s"]);
        let record = reader.records().next().unwrap().unwrap();
        let cells: Vec<&str> = record.iter().collect();
        assert_eq!(cells, ["9", "a, \"b\"", "", "3.333e-1"]);
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
