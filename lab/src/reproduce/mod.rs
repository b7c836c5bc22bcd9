//! Numbers of the source papers: stated and recomputed values, and the meaning of the difference.
//!
//! No result is copied. Every recomputed value is computed from laws, cams and drives of the library when the function is called.

mod barrel;
mod camdas;
mod heel;
mod methods;
mod thesis;
mod write;

pub use methods::{Method, methods};
pub use write::write;

use std::fmt::Write;

use gaitcam::error::Result;
use gaitcam_output::overlay;
use gaitcam_output::picture::Picture;

/// Kind of a difference between a stated and a recomputed number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// Equal to all printed digits.
    Agrees,
    /// The last digits differ, because of rounded inputs or truncated digits.
    Rounding,
    /// The source states the extreme of values at whole degrees, which differs from the true extreme.
    Sampling,
    /// The formulas of the source lead to the other value: an error of printing or copying, in the source or in its conversion to text.
    Discrepancy,
    /// No interpretation of the source leads to the number.
    NotReproducible,
    /// A measured value, compared with the fitted curve.
    Measured,
    /// The source does not state this number.
    NotStated,
}

impl Class {
    const ALL: [Class; 7] = [
        Class::Agrees,
        Class::Rounding,
        Class::Sampling,
        Class::Discrepancy,
        Class::NotReproducible,
        Class::Measured,
        Class::NotStated,
    ];

    fn meaning(self) -> &'static str {
        match self {
            Class::Agrees => "equal to the digits printed",
            Class::Rounding => "the last digits differ: rounded inputs or cut digits",
            Class::Sampling => "the source reads extremes off whole degrees",
            Class::Discrepancy => "the source's own formulas give the other value",
            Class::NotReproducible => "no reading of the source gives the number",
            Class::Measured => "a measurement, beside the value of the curve fitted to it",
            Class::NotStated => "computed here; the source is silent",
        }
    }

    /// Name of the class in the report.
    pub fn name(self) -> &'static str {
        match self {
            Class::Agrees => "agrees",
            Class::Rounding => "rounding",
            Class::Sampling => "sampling at 1°",
            Class::Discrepancy => "discrepancy",
            Class::NotReproducible => "not reproducible",
            Class::Measured => "measured",
            Class::NotStated => "not stated",
        }
    }
}

/// Numbers that the papers state, one per line.
const PAPERS: &str = include_str!("papers.txt");

/// A number of a paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Source of the number: the paper, with page or equation.
    pub source: &'static str,
    /// The quantity that the paper states.
    pub quantity: &'static str,
    /// Unit of the quantity; empty for a dimensionless number.
    pub unit: &'static str,
    /// Number as printed; empty if the paper does not state it.
    pub stated: &'static str,
    /// Number computed with this library.
    pub recomputed: f64,
    /// Meaning of the difference between the two numbers.
    pub class: Class,
    /// Reason of the difference, as text.
    pub reason: String,
}

impl Row {
    /// Row from a line of the table and the number computed with this library.
    fn of(source: &'static str, line: &'static str, value: Value) -> Option<Row> {
        let mut fields = line.split('|').map(str::trim);
        let mut field = || fields.next().unwrap_or_default();
        let [quantity, unit, stated, class, reason] = std::array::from_fn(|_| field());
        let stands = match class {
            "sampling at 1°" => (value.detail.parse()).is_ok_and(|x| same_digits(stated, x)),
            "agrees" => false,
            _ => true,
        };
        let (class, reason) = match Class::ALL.into_iter().find(|c| c.name() == class)? {
            _ if same_digits(stated, value.recomputed) => (Class::Agrees, ""),
            class if stands => (class, reason),
            _ => (Class::NotReproducible, reason),
        };
        Some(Row {
            source,
            quantity,
            unit,
            stated,
            recomputed: value.recomputed,
            class,
            reason: reason.replace("{}", &value.detail),
        })
    }

    /// Relative difference (recomputed − stated)/|stated|; `None` if no number or zero is stated.
    pub fn relative(&self) -> Option<f64> {
        let stated: f64 = self.stated.parse().ok()?;
        let gap = (self.recomputed - stated) / stated.abs();
        gap.is_finite().then_some(gap)
    }
}

/// Recomputed number, with a text that completes its reason in the table.
struct Value {
    recomputed: f64,
    detail: String,
}

impl From<f64> for Value {
    fn from(recomputed: f64) -> Self {
        let detail = String::new();
        Value { recomputed, detail }
    }
}

impl Value {
    /// Number with `detail` for its reason.
    fn with(recomputed: f64, detail: String) -> Self {
        Value { recomputed, detail }
    }
}

/// All lines of the table with their recomputed numbers.
fn rows() -> Result<Vec<Row>> {
    let values = [
        heel::values()?,
        thesis::values()?,
        barrel::values()?,
        camdas::values()?,
    ];
    let mut rows = Vec::new();
    let sections = PAPERS.split("\n# ").skip(1);
    for (section, values) in sections.zip(values) {
        let (source, lines) = section.split_once('\n').unwrap_or((section, ""));
        let lines: Vec<&str> = lines.lines().filter(|l| !l.is_empty()).collect();
        let count = values.len();
        let made = lines
            .iter()
            .zip(values)
            .map(|(line, value)| Row::of(source, line, value));
        let made: Option<Vec<Row>> = made.collect();
        match made {
            Some(made) if lines.len() == count => rows.extend(made),
            _ => return Err(crate::fault(format!("{source}: lines and values differ"))),
        }
    }
    Ok(rows)
}

/// Whether a value rounds to the printed digits.
fn same_digits(stated: &str, value: f64) -> bool {
    let Ok(number) = stated.parse::<f64>() else {
        return false;
    };
    let decimals = stated.split_once('.').map_or(0, |p| p.1.len());
    (value - number).abs() <= 0.5 * 10f64.powi(-(decimals as i32)) * (1.0 + 1e-9)
}

/// Complete reproduction: rows, comparison of methods, and pictures.
pub struct Reproduction {
    /// Stated and recomputed numbers of the papers.
    pub rows: Vec<Row>,
    /// The four iterations of Campillo de Blas (2017) and the optimum.
    pub methods: Vec<Method>,
    /// Pictures with their file names, without ending.
    pub pictures: Vec<(&'static str, Picture)>,
}

/// Computes all results (about a second).
///
/// # Errors
///
/// Only an error of the library.
pub fn reproduce() -> Result<Reproduction> {
    let methods = methods()?;
    let pictures = vec![
        ("reproduction_methods", methods::picture(&methods)),
        ("reproduction_heel_tester", heel::picture()?),
        ("reproduction_camdas_1", camdas::picture()?),
    ];
    Ok(Reproduction {
        rows: rows()?,
        methods,
        pictures,
    })
}

impl Reproduction {
    fn count(&self, class: Class) -> usize {
        self.rows.iter().filter(|r| r.class == class).count()
    }

    /// Table as `reproduction.csv`.
    pub fn csv(&self) -> String {
        let mut out = String::from(
            "source,quantity,unit,stated,recomputed,relative_difference,class,reason\n",
        );
        for row in &self.rows {
            let quoted = |t: &str| format!("\"{}\"", t.replace('"', "\"\""));
            let relative = row.relative().map_or(String::new(), |r| format!("{r:.3e}"));
            // Writing to a String cannot fail.
            let _ = writeln!(
                out,
                "{},{},{},{},{:?},{relative},{},{}",
                quoted(row.source),
                quoted(row.quantity),
                row.unit,
                row.stated,
                row.recomputed,
                row.class.name(),
                quoted(&row.reason)
            );
        }
        out
    }

    /// Report as `reproduction.md`.
    pub fn markdown(&self) -> String {
        let mut out = String::from(
            "# The papers' numbers, computed again\n\nWritten by `gaitcam-lab reproduce`; every recomputed number is a result of the library. Text conversions of the sources were read.\n\n",
        );
        out.push_str("| class | meaning | numbers |\n|---|---|---:|\n");
        for class in Class::ALL {
            let (name, meaning, count) = (class.name(), class.meaning(), self.count(class));
            let _ = writeln!(out, "| {name} | {meaning} | {count} |");
        }
        let mut source = "";
        for row in &self.rows {
            if row.source != source {
                source = row.source;
                let _ = writeln!(
                    out,
                    "\n## {source}\n\n| quantity | stated | recomputed | relative difference | class | reason |\n|---|---:|---:|---:|---|---|"
                );
            }
            let relative = row.relative().map(|r| format!("{r:+.1e}"));
            let relative = or_dash(relative.as_deref().unwrap_or_default());
            let stated = or_dash(row.stated);
            let comma = if row.unit.is_empty() { "" } else { ", " };
            let _ = writeln!(
                out,
                "| {}{comma}{} | {stated} | {} | {relative} | {} | {} |",
                row.quantity,
                row.unit,
                shown(row.recomputed),
                row.class.name(),
                row.reason
            );
        }
        methods::table(&mut out, &self.methods);
        out.push_str("\n## Pictures\n\n");
        for (name, _) in &self.pictures {
            let _ = writeln!(out, "![{name}]({name}.svg)\n");
        }
        out
    }
}

/// The text, or a dash if it is empty.
fn or_dash(text: &str) -> &str {
    if text.is_empty() { "—" } else { text }
}

/// Number with seven significant digits.
fn shown(x: f64) -> String {
    if !x.is_finite() {
        return "∞".to_string();
    }
    if x.abs() < 5e-10 {
        return "0".to_string();
    }
    let power = x.abs().log10().floor() as i32;
    format!("{x:.*}", (6 - power).clamp(0, 9) as usize)
}

/// One diagram of a picture.
fn strip(quantity: &str, curves: Vec<Vec<(f64, f64)>>) -> overlay::Strip {
    overlay::Strip {
        quantity: quantity.to_string(),
        curves,
    }
}
