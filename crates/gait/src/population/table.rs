//! Table of a population, with one cycle per row.
//!
//! The columns are `walker,speed_m_per_s,mass_kg,period_s,f_000,…,f_100`. The `f` columns contain the force, N, at equal steps of the
//! cycle. The last value repeats the first one. `speed_m_per_s`, `mass_kg` and the additional column `weight` (statistical weight) may be
//! missing or empty.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;

use super::Walker;
use crate::curve::ForceCurve;
use crate::error::{ForceError, Placed, Result};
use gaitcam_base::text::{cell_text, cells, quoted, text_cell};

/// Minimum number of steps per cycle in a written table.
const STEPS: usize = 100;

/// Indices of the columns of a table of walkers.
struct Columns {
    walker: usize,
    period: usize,
    speed: Option<usize>,
    mass: Option<usize>,
    weight: Option<usize>,
    /// Indices of the force columns, in the order of the phase.
    force: Vec<usize>,
    names: Vec<String>,
}

/// Whether a file is a table of walkers, according to the names of its columns.
pub fn is_table(bytes: &[u8]) -> bool {
    let head = bytes.split(|b| *b == b'\n').find(|l| !l.starts_with(b"#"));
    let head = String::from_utf8_lossy(head.unwrap_or_default()).to_lowercase();
    let names: Vec<&str> = head.split([',', ';', '\t']).map(str::trim).collect();
    names.contains(&"walker") && names.iter().any(|n| n.starts_with("f_"))
}

/// Row of a table of walkers.
///
/// ```
/// use gaitcam_gait::population_rows;
///
/// let table = "walker,period_s,f_0,f_1,f_2,f_3,f_4,f_5,f_6,f_7,f_8\nA,0.5,1,2,3,4,5,4,3,2,1\nB,soon,1,2,3,4,5,4,3,2,1\n";
/// let rows = population_rows("w.csv".as_ref(), table.as_bytes())?;
/// assert_eq!((rows[1].name.as_str(), rows[1].line), ("B", 3));
/// assert!(rows[0].walker.is_ok() && rows[1].walker.is_err());
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct WalkerRow {
    /// Name of the walker in the table.
    pub name: String,
    /// Line of the walker in the file, counted from 1.
    pub line: usize,
    /// Cycle of the walker in this row.
    ///
    /// # Errors
    ///
    /// A value is not a number, or the forces do not form a cycle; the error contains the line.
    pub walker: Result<Walker>,
}

/// Reads a table of walkers in which every row must contain a cycle.
///
/// # Errors
///
/// The error of the first row without a cycle, or an error of [`read_rows`].
pub fn read_table(path: &Path, bytes: &[u8]) -> Result<Vec<Walker>> {
    let rows = read_rows(path, bytes)?;
    rows.into_iter().map(|row| row.walker).collect()
}

/// Reads a table of walkers row by row.
///
/// # Errors
///
/// A column is missing, or the table has no rows.
pub fn read_rows(path: &Path, bytes: &[u8]) -> Result<Vec<WalkerRow>> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = (1..).zip(text.lines());
    let mut head = (&mut lines).filter(|(_, l)| !l.starts_with('#') && !l.trim().is_empty());
    let (line, names) = head.next().unwrap_or((1, ""));
    let separator = [';', '\t', ','].into_iter().find(|s| names.contains(*s));
    let separator = separator.unwrap_or(',');
    let columns = columns(names, separator).map_err(|e| e.at_line(path, line))?;
    let mut out = Vec::new();
    for (line, row) in lines.filter(|(_, l)| !l.trim().is_empty() && !l.starts_with('#')) {
        let cells = cells(row, separator);
        let cells: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
        let walker = walker(&columns, &cells, separator == ';');
        out.push(WalkerRow {
            name: cell_text(cells.get(columns.walker).copied().unwrap_or_default()).to_string(),
            line,
            walker: walker.map_err(|e| e.at_line(path, line)),
        });
    }
    if out.is_empty() {
        return Err(ForceError::NoWalkers.in_file(path));
    }
    Ok(out)
}

fn columns(head: &str, separator: char) -> std::result::Result<Columns, ForceError> {
    let names: Vec<String> = (head.split(separator))
        .map(|n| n.trim().to_lowercase())
        .collect();
    let place = |name: &str| names.iter().position(|n| n == name);
    let needed =
        |column: &'static str| place(column).ok_or(ForceError::WalkerColumnMissing { column });
    let mut force: Vec<(u32, usize)> = names
        .iter()
        .enumerate()
        .filter_map(|(i, n)| Some((n.strip_prefix("f_")?.parse().ok()?, i)))
        .collect();
    force.sort_unstable();
    if force.len() < 9 {
        return Err(ForceError::WalkerColumnMissing { column: "f_000" });
    }
    Ok(Columns {
        walker: needed("walker")?,
        period: needed("period_s")?,
        speed: place("speed_m_per_s"),
        mass: place("mass_kg"),
        weight: place("weight"),
        force: force.into_iter().map(|f| f.1).collect(),
        names,
    })
}

fn walker(columns: &Columns, cells: &[&str], comma: bool) -> Result<Walker> {
    let cell = |place: usize| cells.get(place).copied().unwrap_or_default();
    let number = |place: usize| {
        let text = cell(place);
        let plain = if comma {
            text.replace(',', ".")
        } else {
            text.to_string()
        };
        let value: Option<f64> = plain.parse().ok().filter(|x: &f64| x.is_finite());
        value.ok_or_else(|| ForceError::WalkerValue {
            column: columns.names[place].clone(),
            value: text.to_string(),
        })
    };
    let given = |place: Option<usize>| {
        let place = place.filter(|p| !cell(*p).is_empty());
        place.map(number).transpose()
    };
    // The last sample repeats the first one, so it is omitted.
    let places = &columns.force[..columns.force.len() - 1];
    let force: std::result::Result<Vec<f64>, ForceError> =
        places.iter().map(|p| number(*p)).collect();
    let name = cell_text(cell(columns.walker));
    let mut curve = ForceCurve::from_samples(name, number(columns.period)?, force?)?;
    curve.mass_kg = given(columns.mass)?;
    let weight = given(columns.weight)?.unwrap_or(1.0);
    if weight <= 0.0 {
        let (column, value) = ("weight".to_string(), weight.to_string());
        return Err(ForceError::WalkerValue { column, value }.into());
    }
    Ok(Walker {
        weight,
        speed_m_per_s: given(columns.speed)?,
        ..Walker::new(name, curve)
    })
}

/// Table of walkers as CSV text. All rows have the same number of steps: the maximum number of samples of a cycle.
pub fn write_table(walkers: &[Walker]) -> String {
    let samples = walkers.iter().map(|w| w.curve.force_n.len());
    let steps = samples.fold(STEPS, usize::max);
    let is_weighed = walkers.iter().any(|w| w.weight != 1.0);
    let mut out = String::from("walker,speed_m_per_s,mass_kg,period_s");
    out.push_str(if is_weighed { ",weight" } else { "" });
    for step in 0..=steps {
        let _ = write!(out, ",f_{step:03}");
    }
    out.push('\n');
    let blank = |x: Option<f64>| x.map_or(String::new(), |x| x.to_string());
    for walker in walkers {
        let curve = &walker.curve;
        let name = walker.name.replace(['\n', '\r'], " ");
        let name = text_cell(&name);
        let name = quoted(&name);
        let (speed, mass) = (blank(walker.speed_m_per_s), blank(curve.mass_kg));
        let _ = write!(out, "{name},{speed},{mass},{}", curve.period_s);
        if is_weighed {
            let _ = write!(out, ",{}", walker.weight);
        }
        for step in 0..=steps {
            let force = match curve.force_n.get(step % steps) {
                Some(force) if curve.force_n.len() == steps => *force,
                _ => curve.at(TAU * (step % steps) as f64 / steps as f64),
            };
            let _ = write!(out, ",{force}");
        }
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_of_a_walker_is_a_formula_and_each_reads_back() {
        let names = [
            "=1+1", "+y", "-z", "@x", "'=a", "W 1", "12", "A, left", "\"B\"", "-1,\"x",
        ];
        let walker = |name: &&str| {
            let force = (0..64).map(|i| 700.0 + f64::from(i)).collect();
            Walker::new(name, ForceCurve::from_samples(name, 1.0, force).unwrap())
        };
        let table = write_table(&names.iter().map(walker).collect::<Vec<_>>());
        assert!(!table.contains("\n=") && !table.contains("\n+") && !table.contains("\n@"));
        let read = read_table(Path::new("w.csv"), table.as_bytes()).unwrap();
        let back: Vec<&str> = read.iter().map(|w| w.name.as_str()).collect();
        assert_eq!(back, names);
    }
}
