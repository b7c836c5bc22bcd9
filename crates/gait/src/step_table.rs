//! Stances and strides of a recording as tables.

use crate::interpretation::{Contact, Interpretation, RecordedStride};
use crate::recording::Foot;
use crate::stance::Point;

/// Stance or stride as one row of a table.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, force_curve, steps_csv};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let understood = curve.recording.unwrap();
/// let rows = understood.stance_rows();
/// assert_eq!((rows.len(), rows[0].used, rows[0].why), (21, false, "cut-at-start"));
/// // The impulse of a stride is the weight times its duration.
/// let strides = understood.stride_rows();
/// let impulse_ns: f64 = strides.iter().filter_map(|s| s.impulse_ns).sum();
/// let duration_s: f64 = strides.iter().map(|s| s.end_s - s.start_s).sum();
/// assert!((impulse_ns / duration_s - 700.0).abs() < 7.0);
/// assert!(steps_csv(&rows).starts_with("column,foot,start_s,end_s,p1_n,valley_n,p2_n,impulse,used,why\n"));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepRow<'a> {
    /// Name of the column in the file; empty for a stride, because its force is from all columns.
    pub column: &'a str,
    /// Foot of the stance, or foot that begins the stride, if known.
    pub foot: Option<Foot>,
    /// Start of the stance or stride, as in the file, s.
    pub start_s: f64,
    /// End of the stance or stride, as in the file, s.
    pub end_s: f64,
    /// Loading peak, N.
    pub p1_n: Option<f64>,
    /// Minimum force between the two peaks, N.
    pub valley_n: Option<f64>,
    /// Push-off peak, N.
    pub p2_n: Option<f64>,
    /// Integral of the force over the stance or stride, N s.
    pub impulse_ns: Option<f64>,
    /// Whether the mean cycle contains the stance or stride.
    pub used: bool,
    /// Code of the reason for the exclusion; empty if the stance or stride is used.
    pub why: &'static str,
}

impl Interpretation {
    /// Rows of all contacts in order of time. A contact that is not a whole stance has no peaks.
    pub fn stance_rows(&self) -> Vec<StepRow<'_>> {
        let row = |c: &Contact| {
            let column = self.columns.get(c.column);
            StepRow {
                column: column.map_or("", |c| c.name.as_str()),
                foot: c.foot,
                start_s: c.from_s,
                end_s: c.to_s,
                impulse_ns: c.impulse_ns,
                used: c.rejected.is_none(),
                why: c.rejected.map_or("", Into::into),
                ..StepRow::of(c.landmarks)
            }
        };
        self.contacts.iter().map(row).collect()
    }

    /// Rows of all whole strides of both feet in order of time, with the peaks of the first stance.
    pub fn stride_rows(&self) -> Vec<StepRow<'static>> {
        let row = |s: &RecordedStride| StepRow {
            foot: s.foot,
            start_s: s.from_s,
            end_s: s.to_s,
            impulse_ns: Some(s.impulse_ns),
            used: s.rejected.is_none(),
            why: s.rejected.map_or("", Into::into),
            ..StepRow::of(s.landmarks)
        };
        self.strides.iter().map(row).collect()
    }
}

impl StepRow<'_> {
    fn of(landmarks: [Option<Point>; 3]) -> Self {
        let [p1_n, valley_n, p2_n] = landmarks.map(|p| p.map(|p| p.force_n));
        StepRow {
            column: "",
            foot: None,
            start_s: 0.0,
            end_s: 0.0,
            p1_n,
            valley_n,
            p2_n,
            impulse_ns: None,
            used: false,
            why: "",
        }
    }
}

/// The rows as CSV text: times in s, forces in N, impulses in N s. A missing value is an empty cell.
pub fn steps_csv(rows: &[StepRow<'_>]) -> String {
    let mut text = String::from("column,foot,start_s,end_s,p1_n,valley_n,p2_n,impulse,used,why\n");
    for row in rows {
        let column = match row.column {
            name if name.contains([',', '"', '\n']) => format!("\"{}\"", name.replace('"', "\"\"")),
            name => name.to_string(),
        };
        let foot = row.foot.map_or("", Foot::name);
        let [p1, valley, p2, impulse] = [row.p1_n, row.valley_n, row.p2_n, row.impulse_ns]
            .map(|x| x.map_or_else(String::new, |x| format!("{x:.3}")));
        let (start, end, used, why) = (row.start_s, row.end_s, row.used, row.why);
        text += &format!(
            "{column},{foot},{start:.6},{end:.6},{p1},{valley},{p2},{impulse},{used},{why}\n"
        );
    }
    text
}
