//! From a file to one cycle of force.

use std::path::Path;
use std::sync::Arc;

use crate::curve::ForceCurve;
use crate::cycle::cycle;
use crate::error::{Placed, Result};
use crate::interpretation::Interpretation;
use crate::read::{one_cycle, read};
use crate::recording::{Feet, ReadOptions};
use crate::stance::stances;

/// Reads one cycle of force from any file that [`read`](crate::read()) takes.
///
/// A text with the comment `# cycle` or `# critical points` is one cycle as given, regardless of `feet`; in other files stances are detected and
/// averaged into a stride.
///
/// # Errors
/// A file that cannot be read, or that contains no suitable movement.
pub fn force_curve(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
    feet: Feet,
) -> Result<ForceCurve> {
    if let Some(curve) = one_cycle(path, bytes, options)? {
        return Ok(curve);
    }
    let recording = read(path, bytes, options)?;
    let stances = stances(&recording);
    let mean = cycle(&recording, &stances, feet).map_err(|e| e.in_file(path))?;
    let file = path
        .file_name()
        .and_then(|n| n.to_str())
        .unwrap_or("recording");
    let understood = Interpretation::of(file, &recording, &stances, Some(&mean), feet);
    let mut curve = mean.curve;
    curve.name = format!("{file}, {}", mean.source);
    curve.recording = Some(Arc::new(understood));
    Ok(curve)
}
