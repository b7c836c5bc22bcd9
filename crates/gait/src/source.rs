//! Conversion of a file to one cycle of force.

use std::path::Path;
use std::sync::Arc;

use crate::curve::ForceCurve;
use crate::cycle::{cycle, stance_in_span};
use crate::error::{Placed, Result};
use crate::interpretation::Interpretation;
use crate::read::{is_marked_cycle, marked_cycle, read};
use crate::recording::{Feet, ReadOptions};
use crate::stance::stances;

/// Reads a file that contains one cycle. This is a text marked as a cycle, such as from [`ForceCurve::to_csv`], or any table if a period or
/// a span is given. `None` for other files.
///
/// If a span is given and the file is a recording, the mean stance fills the span. `feet` selects the stances.
///
/// # Errors
///
/// A line is not a number; there are too few samples or several forces; a phase is given without a period.
pub fn one_cycle(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
    feet: Feet,
) -> Result<Option<ForceCurve>> {
    if let (Some(span), false) = (options.span_rad, is_marked_cycle(bytes)) {
        let raw = ReadOptions {
            period_s: None,
            span_rad: None,
            ..options.clone()
        };
        // If no stances are found, the table is read as one cycle that covers the span.
        if let Ok(recording) = read(path, bytes, &raw) {
            let found = stances(&recording);
            let file = name(path);
            let curve = stance_in_span(file, &recording, &found, span, options.period_s, feet);
            if let Some(mut curve) = curve.map_err(|e| e.in_file(path))? {
                curve.noise_n = options.noise_n.or(curve.noise_n);
                return Ok(Some(curve));
            }
        }
    }
    marked_cycle(path, bytes, options)
}

/// Name of a file for reports.
fn name(path: &Path) -> &str {
    path.file_name()
        .and_then(|n| n.to_str())
        .unwrap_or("recording")
}

/// Reads one cycle of force from any file that [`read`](crate::read()) accepts.
///
/// A text with the comment `# cycle` or `# critical points` is used as one cycle without change, regardless of `feet`. In other files,
/// stances are detected and averaged to a stride.
///
/// # Errors
///
/// The file cannot be read, or it contains no suitable movement.
pub fn force_curve(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
    feet: Feet,
) -> Result<ForceCurve> {
    if let Some(curve) = one_cycle(path, bytes, options, feet)? {
        return Ok(curve);
    }
    let recording = read(path, bytes, options)?;
    let stances = stances(&recording);
    let mean = cycle(&recording, &stances, feet).map_err(|e| e.in_file(path))?;
    let file = name(path);
    let understood = Interpretation::of(file, &recording, &stances, Some(&mean), feet);
    let mut curve = mean.curve;
    curve.noise_n = options.noise_n.or(curve.noise_n);
    curve.name = format!("{file}, {}", mean.source);
    curve.recording = Some(Arc::new(understood));
    Ok(curve)
}
