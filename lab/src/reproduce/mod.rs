//! The papers' numbers, computed again: stated, recomputed, and what the difference means.
//!
//! Nothing here is copied from a result: every recomputed value comes out of the library's own laws, cams
//! and drives at the moment of the call.

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

/// What a difference between a stated and a recomputed number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// Equal to the digits printed.
    Agrees,
    /// The last digits differ: rounded inputs, or cut digits.
    Rounding,
    /// The extreme of values at whole degrees, which misses the true one.
    Sampling,
    /// A printing or copying error: the source's own formulas give the other value.
    Misprint,
    /// No reading of the source gives the number.
    NotReproducible,
    /// A measurement, compared with the value of the curve fitted to it.
    Measured,
    /// The source does not give this number.
    NotStated,
}

impl Class {
    const ALL: [Class; 7] = [
        Class::Agrees,
        Class::Rounding,
        Class::Sampling,
        Class::Misprint,
        Class::NotReproducible,
        Class::Measured,
        Class::NotStated,
    ];

    fn meaning(self) -> &'static str {
        match self {
            Class::Agrees => "equal to the digits printed",
            Class::Rounding => "the last digits differ: rounded inputs or cut digits",
            Class::Sampling => "the source reads extremes off whole degrees",
            Class::Misprint => "the source's own formulas give the other value",
            Class::NotReproducible => "no reading of the source gives the number",
            Class::Measured => "a measurement, beside the value of the curve fitted to it",
            Class::NotStated => "computed here; the source is silent",
        }
    }

    /// The words of the report.
    pub fn name(self) -> &'static str {
        match self {
            Class::Agrees => "agrees",
            Class::Rounding => "rounding",
            Class::Sampling => "sampling at 1°",
            Class::Misprint => "misprint",
            Class::NotReproducible => "not reproducible",
            Class::Measured => "measured",
            Class::NotStated => "not stated",
        }
    }
}

/// What the papers print, one number a line.
const PAPERS: &str = include_str!("papers.txt");

/// One number of a paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The paper, with page or equation.
    pub source: &'static str,
    /// The quantity that the paper states.
    pub quantity: &'static str,
    /// Its unit; empty for a plain number.
    pub unit: &'static str,
    /// The number as printed; empty where the paper is silent.
    pub stated: &'static str,
    /// The number from this library.
    pub recomputed: f64,
    /// What the difference is.
    pub class: Class,
    /// Reason of a difference.
    pub reason: String,
}

impl Row {
    /// A line of the table with the number that this library gives.
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

    /// (recomputed − stated)/|stated|; `None` where nothing or zero is stated.
    pub fn relative(&self) -> Option<f64> {
        let stated: f64 = self.stated.parse().ok()?;
        let gap = (self.recomputed - stated) / stated.abs();
        gap.is_finite().then_some(gap)
    }
}

/// A recomputed number, with what its reason in the table leaves open.
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
    /// A number, and `detail` for its reason.
    fn with(recomputed: f64, detail: String) -> Self {
        Value { recomputed, detail }
    }
}

/// Every line of the table with its recomputed number.
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

/// Whether a value rounds to the digits printed.
fn same_digits(stated: &str, value: f64) -> bool {
    let Ok(number) = stated.parse::<f64>() else {
        return false;
    };
    let decimals = stated.split_once('.').map_or(0, |p| p.1.len());
    (value - number).abs() <= 0.5 * 10f64.powi(-(decimals as i32)) * (1.0 + 1e-9)
}

/// The whole reproduction: rows, the comparison of methods, and pictures.
pub struct Reproduction {
    /// Every number of the papers, stated and recomputed.
    pub rows: Vec<Row>,
    /// The four iterations of Campillo de Blas (2017) and the optimum.
    pub methods: Vec<Method>,
    /// Pictures with the names of their files, without ending.
    pub pictures: Vec<(&'static str, Picture)>,
}

/// Computes everything anew (about a second). Fails only on a fault of the library.
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

    /// The table as `reproduction.csv`.
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

    /// The report as `reproduction.md`.
    pub fn markdown(&self) -> String {
        let mut out = String::from(
            "# The papers' numbers, computed again\n\nWritten by `gaitcam-lab reproduce`; every recomputed number is a result of the library.\n\n",
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

/// A text, or a dash for none.
fn or_dash(text: &str) -> &str {
    if text.is_empty() { "—" } else { text }
}

/// The number with seven significant digits.
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

/// One strip of a picture.
fn strip(quantity: &str, curves: Vec<Vec<(f64, f64)>>) -> overlay::Strip {
    overlay::Strip {
        quantity: quantity.to_string(),
        curves,
    }
}
