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

/// One number of a paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Paper and place.
    pub source: &'static str,
    /// What is measured.
    pub quantity: String,
    /// Its unit; empty for a plain number.
    pub unit: &'static str,
    /// The number as printed; empty where the paper is silent.
    pub stated: String,
    /// The number from this library.
    pub recomputed: f64,
    /// What the difference is.
    pub class: Class,
    /// Why.
    pub reason: String,
}

impl Row {
    /// (recomputed − stated)/|stated|; `None` where nothing or zero is stated.
    pub fn relative(&self) -> Option<f64> {
        let stated: f64 = self.stated.parse().ok()?;
        let gap = (self.recomputed - stated) / stated.abs();
        gap.is_finite().then_some(gap)
    }
}

/// Rows of one source.
struct Rows {
    source: &'static str,
    list: Vec<Row>,
}

impl Rows {
    fn of(source: &'static str) -> Self {
        Rows {
            source,
            list: Vec::new(),
        }
    }

    /// A number that is misprinted for the `reason`.
    fn misprint(
        &mut self,
        quantity: &str,
        unit: &'static str,
        stated: &str,
        recomputed: f64,
        reason: &str,
    ) {
        let otherwise = (Class::Misprint, reason);
        self.add(quantity, unit, stated, recomputed, otherwise);
    }

    /// A number whose last printed digits may be cut or rounded.
    fn stated(&mut self, quantity: &str, unit: &'static str, stated: &str, recomputed: f64) {
        let reason = "the last printed digits are cut or rounded";
        let otherwise = (Class::Rounding, reason);
        self.add(quantity, unit, stated, recomputed, otherwise);
    }

    /// An extreme that its source read off whole degrees.
    fn sampled(
        &mut self,
        quantity: &str,
        unit: &'static str,
        stated: &str,
        at_degrees: f64,
        exact: f64,
    ) {
        let reason = format!("the extreme at whole degrees is {at_degrees:.4}");
        let class = if same_digits(stated, at_degrees) {
            Class::Sampling
        } else {
            Class::NotReproducible
        };
        self.add(quantity, unit, stated, exact, (class, &reason));
    }

    /// A number that the source does not give.
    fn silent(&mut self, quantity: &str, unit: &'static str, recomputed: f64, reason: &str) {
        self.add(quantity, unit, "", recomputed, (Class::NotStated, reason));
    }

    /// A number printed as `stated`: agrees if equal to its digits, otherwise what `otherwise` says.
    fn add(
        &mut self,
        quantity: &str,
        unit: &'static str,
        stated: &str,
        recomputed: f64,
        otherwise: (Class, &str),
    ) {
        let (class, reason) = if same_digits(stated, recomputed) {
            (Class::Agrees, "")
        } else {
            otherwise
        };
        self.list.push(Row {
            source: self.source,
            quantity: quantity.to_string(),
            unit,
            stated: stated.to_string(),
            recomputed,
            class,
            reason: reason.to_string(),
        });
    }
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
    /// Every number.
    pub rows: Vec<Row>,
    /// The four iterations of Campillo de Blas (2017) and the optimum.
    pub methods: Vec<Method>,
    /// Pictures with the names of their files, without ending.
    pub pictures: Vec<(&'static str, Picture)>,
}

/// Computes everything anew (about a second). Fails only on a fault of the library.
pub fn reproduce() -> Result<Reproduction> {
    let mut rows = heel::rows()?;
    rows.extend(thesis::rows()?);
    rows.extend(barrel::rows()?);
    rows.extend(camdas::rows()?);
    let methods = methods()?;
    let pictures = vec![
        ("reproduction_methods", methods::picture(&methods)),
        ("reproduction_heel_tester", heel::picture()?),
        ("reproduction_camdas_1", camdas::picture()?),
    ];
    Ok(Reproduction {
        rows,
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
                quoted(&row.quantity),
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
            "# The papers' numbers, computed again\n\nWritten by `gaitcam reproduce`; every recomputed number comes from the library, none is copied.\n\n",
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
            let relative = row
                .relative()
                .map_or("—".to_string(), |r| format!("{r:+.1e}"));
            let stated = if row.stated.is_empty() {
                "—"
            } else {
                &row.stated
            };
            let unit = if row.unit.is_empty() {
                String::new()
            } else {
                format!(", {}", row.unit)
            };
            let _ = writeln!(
                out,
                "| {}{unit} | {stated} | {} | {relative} | {} | {} |",
                row.quantity,
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

/// Seven significant digits.
fn shown(x: f64) -> String {
    if !x.is_finite() {
        return "∞".to_string();
    }
    if x.abs() < 5e-10 {
        return "0".to_string();
    }
    let power = if x == 0.0 {
        0
    } else {
        x.abs().log10().floor() as i32
    };
    format!("{x:.*}", (6 - power).clamp(0, 9) as usize)
}

/// One strip of a picture.
fn strip(quantity: &str, curves: Vec<Vec<(f64, f64)>>) -> overlay::Strip {
    overlay::Strip {
        quantity: quantity.to_string(),
        curves,
    }
}
