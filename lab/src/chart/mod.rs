//! Speed against accuracy: tables and pictures of measured rows.
//!
//! This module measures nothing. The rows contain their times.

mod picture;
mod tables;

pub use picture::picture;
pub use tables::{csv, markdown, section};

/// Result of a method at one size.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Row {
    /// Name of the method.
    pub method: String,
    /// Size of the problem: "32 spans".
    pub size: String,
    /// Distance from the exact result, in the chart's unit. 0 is drawn at the lower edge of the chart.
    pub error: f64,
    /// Median time of one run, s.
    pub seconds: f64,
    /// First and third quartile of the time, s.
    pub quartiles: (f64, f64),
    /// Number of timed runs.
    pub runs: usize,
    /// Number of emitted points, if the chart shows points instead of time.
    pub points: Option<usize>,
    /// Whether this is the default method of gaitcam.
    pub default: bool,
    /// Remark for the tables.
    pub note: String,
}

/// Quantity on the horizontal axis.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Across {
    /// Time of one run.
    #[default]
    Time,
    /// Number of emitted points.
    Points,
    /// Number of spans of the law. The vertical axis is then the time, s, and there is no front.
    Spans,
}

/// Comparison of methods for one task.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chart {
    /// File name without ending: `speed_accuracy_a`.
    pub file: String,
    /// Title of the chart.
    pub title: String,
    /// Task with its sizes, as one sentence.
    pub task: String,
    /// Description of the error with its unit.
    pub error: String,
    /// Quantity on the horizontal axis.
    pub across: Across,
    /// Errors drawn as horizontal lines, with names.
    pub levels: Vec<(f64, String)>,
    /// Recommendation for users, as one sentence.
    pub advice: String,
    /// One row for each method and size.
    pub rows: Vec<Row>,
}

impl Row {
    /// The row marked as the default of gaitcam.
    #[must_use]
    pub fn by_default(self) -> Row {
        Row {
            default: true,
            ..self
        }
    }

    /// The row with a remark.
    #[must_use]
    pub fn noted(self, note: &str) -> Row {
        Row {
            note: note.to_string(),
            ..self
        }
    }

    /// Value of the row on the horizontal axis.
    pub fn across(&self, across: Across) -> f64 {
        match across {
            Across::Time => self.seconds,
            Across::Points | Across::Spans => self.points.unwrap_or(0) as f64,
        }
    }
}

impl Chart {
    /// Indices of the rows that no other row surpasses in time and error, cheapest first. Times within the quartiles of each other count as equal.
    pub fn front(&self) -> Vec<usize> {
        if self.across == Across::Spans {
            return Vec::new();
        }
        let cost = |r: &Row| r.across(self.across);
        let beats = |a: &Row, b: &Row| {
            let surely_cheaper = match self.across {
                Across::Time => a.quartiles.1 < b.quartiles.0,
                Across::Points | Across::Spans => cost(a) < cost(b),
            };
            let no_dearer = cost(a) <= cost(b);
            (surely_cheaper && a.error <= b.error) || (no_dearer && a.error < b.error)
        };
        let finite = |r: &Row| r.error.is_finite();
        let mut out: Vec<usize> = (0..self.rows.len())
            .filter(|&i| finite(&self.rows[i]))
            .filter(|&i| {
                let own = &self.rows[i];
                !(self.rows.iter()).any(|r| finite(r) && beats(r, own))
            })
            .collect();
        out.sort_by(|&i, &j| cost(&self.rows[i]).total_cmp(&cost(&self.rows[j])));
        out
    }

    /// Whether a row marked as the default is on the front; `None` for a chart without a front or a default.
    pub fn default_on_front(&self) -> Option<bool> {
        let front = self.front();
        let has = !front.is_empty() && self.rows.iter().any(|r| r.default);
        has.then(|| front.iter().any(|&i| self.rows[i].default))
    }

    /// Cheapest row that is not worse than a default outside the front, and its cost relative to the default.
    pub fn ahead_of_default(&self) -> Option<(&Row, f64)> {
        if self.default_on_front() != Some(false) {
            return None;
        }
        let cost = |r: &Row| r.across(self.across);
        let own = self.rows.iter().find(|r| r.default)?;
        let ahead = self
            .rows
            .iter()
            .filter(|r| r.error <= own.error && cost(r) < cost(own))
            .min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        Some((ahead, cost(ahead) / cost(own)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(method: &str, seconds: f64, error: f64) -> Row {
        Row {
            method: method.to_string(),
            size: "1".to_string(),
            error,
            seconds,
            quartiles: (seconds, seconds),
            runs: 5,
            points: None,
            default: method == "b",
            note: String::new(),
        }
    }

    fn chart() -> Chart {
        Chart {
            file: "x".to_string(),
            title: "x".to_string(),
            task: String::new(),
            error: "N".to_string(),
            across: Across::Time,
            levels: Vec::new(),
            advice: "take b".to_string(),
            rows: vec![
                row("a", 1e-6, 1e-2),
                row("b", 1e-5, 1e-4),
                row("c", 1e-4, 1e-3),
                row("d", 1e-3, 0.0),
                row("e", 1e-7, f64::NAN),
            ],
        }
    }

    #[test]
    fn the_front_leaves_out_what_is_slower_and_worse() {
        assert_eq!(chart().front(), [0, 1, 3]);
        assert_eq!(chart().default_on_front(), Some(true));
    }

    #[test]
    fn every_row_is_in_the_csv_and_every_method_in_the_picture() {
        let text = csv(&[chart()]);
        assert_eq!(text.lines().count(), 6);
        let svg = picture(&chart()).svg();
        for method in ["a", "b", "c", "d"] {
            assert!(svg.contains(&format!(">{method}<")), "{method}");
        }
        assert!(!svg.contains("NaN"));
        assert!(markdown(&[chart()], "test", "").contains("take b"));
    }
}
