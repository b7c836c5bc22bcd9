//! Output of a cycle as a CSV file.

use std::fmt::Write as _;

use super::ForceCurve;

impl ForceCurve {
    /// The cycle as CSV text, which [`one_cycle`](crate::one_cycle) reads back as the same cycle.
    ///
    /// `comments` become comment lines. A line break inside a comment starts another comment line.
    pub fn to_csv(&self, comments: &[&str]) -> String {
        let mut out = String::with_capacity(48 * self.force_n.len());
        // Writing to a String does not fail.
        let _ = write_csv(&mut out, self, comments);
        out
    }
}

fn write_csv(out: &mut String, curve: &ForceCurve, comments: &[&str]) -> std::fmt::Result {
    write_head(out, curve, comments)?;
    let step = curve.period_s / curve.force_n.len() as f64;
    let spread = curve.spread_n.as_deref();
    let column = spread.map_or("", |_| ",spread_n");
    writeln!(out, "time_s,force_n{column}")?;
    for (i, f) in curve.force_n.iter().enumerate() {
        write!(out, "{},{f}", i as f64 * step)?;
        if let Some(spread) = spread {
            write!(out, ",{}", spread[i])?;
        }
        out.push('\n');
    }
    Ok(())
}

/// Writes the comment lines at the start of a text. They contain the mark `# cycle`, the properties of the cycle, and the comments of the
/// caller.
pub(super) fn write_head(
    out: &mut String,
    curve: &ForceCurve,
    comments: &[&str],
) -> std::fmt::Result {
    writeln!(out, "# cycle, period_s = {}", curve.period_s)?;
    if let Some(m) = curve.mass_kg {
        writeln!(out, "# mass_kg = {m}")?;
    }
    if let Some(noise) = curve.noise_n {
        writeln!(out, "# noise_n = {noise}")?;
    }
    for line in comments.iter().flat_map(|c| c.lines()) {
        writeln!(out, "# {line}")?;
    }
    Ok(())
}
