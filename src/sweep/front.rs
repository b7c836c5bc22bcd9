//! Pareto front: the designs that no other design dominates.

use std::cmp::Ordering::Equal;

use super::table::results::{NUMBERS, Outcome};
use crate::cam::Verdict;
use crate::error::{Result, SweepError, nearest};
use crate::synth::Figure;

/// A design on the front.
///
/// ```
/// use gaitcam::sweep::Front;
///
/// let mut front = Front::default();
/// front.offer(7, &[1.0, 2.0], || vec!["a".to_string()]);
/// let point = front.best().unwrap();
/// assert_eq!((point.row, &point.values[..]), (7, &[1.0, 2.0][..]));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Number of the row that contains the design.
    pub row: u64,
    /// Costs of the design, one for each objective. A smaller cost is better.
    pub values: Vec<f64>,
    /// Cells of the row in the table, as text.
    pub cells: Vec<String>,
}

/// Pareto front of the designs that have been added.
///
/// ```
/// use gaitcam::sweep::Front;
///
/// // (2, 2) is dominated by (1, 1). Each of (0, 3) and (1, 1) is better in one cost.
/// let mut front = Front::default();
/// for (row, values) in [(0, [2.0, 2.0]), (1, [1.0, 1.0]), (2, [0.0, 3.0])] {
///     front.offer(row, &values, Vec::new);
/// }
/// let rows: Vec<u64> = front.sorted().iter().map(|point| point.row).collect();
/// assert_eq!(rows.len(), 2);
/// assert!(rows.contains(&1) && rows.contains(&2));
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Front {
    points: Vec<Point>,
}

/// Relative difference below which two costs count as equal.
const ROUNDING: f64 = 1e-9;

/// Whether no cost in `a` exceeds the cost in `b` for the same objective, up to rounding errors.
fn covers(a: &[f64], b: &[f64]) -> bool {
    let no_worse = |(x, y): (&f64, &f64)| x - y <= ROUNDING * x.abs().max(y.abs());
    a.iter().zip(b).all(no_worse)
}

impl Front {
    /// Adds a design to the front, unless a design on the front dominates or equals it. Designs that the new design dominates are removed.
    /// A design with a cost that is not finite is ignored. `cells` is called only if the design is added.
    pub fn offer(&mut self, row: u64, values: &[f64], cells: impl FnOnce() -> Vec<String>) {
        if values.iter().any(|v| !v.is_finite()) {
            return;
        }
        if let Some(i) = self.points.iter().position(|p| covers(&p.values, values)) {
            // This point is likely to dominate the next design too, so it is moved to the start of the list.
            self.points.swap(0, i);
            return;
        }
        self.points.retain(|p| !covers(values, &p.values));
        self.points.push(Point {
            row,
            values: values.to_vec(),
            cells: cells(),
        });
    }

    /// Designs on the front, in ascending order of the first cost.
    pub fn sorted(&self) -> Vec<&Point> {
        let mut out: Vec<&Point> = self.points.iter().collect();
        let order = |p: &&Point, q: &&Point| p.values.partial_cmp(&q.values);
        out.sort_by(|p, q| order(p, q).unwrap_or(Equal).then(p.row.cmp(&q.row)));
        out
    }

    /// Best compromise on the front. It is the design nearest to the ideal point. For this distance, each cost is scaled so that the
    /// minimum on the front is 0 and the maximum is 1. With a single objective, it is the design with the minimum cost. `None` for an empty
    /// front.
    pub fn best(&self) -> Option<&Point> {
        let range = |k: usize| {
            let values = self.points.iter().map(|p| p.values[k]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            (low, values.fold(f64::NEG_INFINITY, f64::max))
        };
        let count = self.points.first()?.values.len();
        let ranges: Vec<(f64, f64)> = (0..count).map(range).collect();
        let distance = |p: &Point| -> f64 {
            let terms = p.values.iter().zip(&ranges);
            let differing = terms.filter(|(_, (low, high))| high > low);
            differing
                .map(|(v, (low, high))| ((v - low) / (high - low)).powi(2))
                .sum()
        };
        self.points
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)).then(a.row.cmp(&b.row)))
    }
}

/// A column of a table that is minimised or maximised.
///
/// ```
/// use gaitcam::sweep::Objective;
///
/// let columns = ["row".to_string(), "stroke_m".to_string()];
/// let stroke = Objective::of("stroke", false, &columns)?;
/// assert_eq!((stroke.column, stroke.name.as_str()), (1, "stroke_m"));
/// assert_eq!(stroke.cost(0.04), 0.04);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Objective {
    /// Index of the column in the table.
    pub column: usize,
    /// Name of the column.
    pub name: String,
    /// Whether the column is maximised instead of minimised.
    pub maximised: bool,
}

/// Names of the default objectives. Both columns are minimised.
const USUAL: [&str; 2] = ["force_error", "prime_radius"];

impl Objective {
    /// Creates an objective for the column whose name is or begins with `name`.
    ///
    /// # Errors
    ///
    /// No column has this name. The error contains the most similar name.
    pub fn of(name: &str, maximised: bool, columns: &[String]) -> Result<Objective> {
        let column = objective(name, columns)?;
        Ok(Objective {
            column,
            name: columns[column].clone(),
            maximised,
        })
    }

    /// Names of the default objectives: force error and prime radius. Both are minimised.
    pub fn usual() -> Vec<String> {
        USUAL.map(str::to_string).to_vec()
    }

    fn sign(&self) -> f64 {
        if self.maximised { -1.0 } else { 1.0 }
    }

    /// Cost of a value of the column: the value itself, or its negative if the column is maximised.
    pub fn cost(&self, value: f64) -> f64 {
        self.sign() * value
    }

    /// Value of the column for a cost, in SI units.
    pub fn value(&self, cost: f64) -> f64 {
        self.sign() * cost
    }
}

/// Criterion for the designs that are added to a front.
///
/// ```
/// use gaitcam::sweep::Admission;
///
/// assert!(Admission::default().takes("built", "acceptable"));
/// assert!(!Admission::default().takes("built", "not-for-high-speed"));
/// assert!(Admission { low_speed: true, all: false }.takes("built", "not-for-high-speed"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Admission {
    /// Whether designs that are not suitable for high speed are included.
    pub low_speed: bool,
    /// Whether all designs are included, whatever their verdict is.
    pub all: bool,
}

impl Admission {
    /// Whether a row with this outcome and verdict is included.
    pub fn takes(self, outcome: &str, verdict: &str) -> bool {
        outcome == Outcome::Built.name()
            && (self.all
                || verdict == Verdict::Acceptable.name()
                || (verdict == Verdict::NotForHighSpeed.name() && self.low_speed))
    }

    /// Whether a row is excluded only because its design is not suitable for high speed.
    pub fn leaves_out(self, outcome: &str, verdict: &str) -> bool {
        let low_speed = Admission {
            low_speed: true,
            ..self
        };
        !self.takes(outcome, verdict) && low_speed.takes(outcome, verdict)
    }
}

/// Index of the column for an objective. `name` is the name of the column or its beginning, such as `jerk` for `jerk_max_m_per_s3`.
/// `force_error` is the RMS force error in percent.
///
/// # Errors
///
/// No column has this name. The error contains the most similar name.
pub fn objective(name: &str, columns: &[String]) -> Result<usize> {
    let name = match name.trim() {
        "force_error" => "force_rms_error_percent",
        other => other,
    };
    if let Some(i) = columns.iter().position(|c| c == name) {
        return Ok(i);
    }
    let begins = |c: &&String| {
        c.strip_prefix(name)
            .is_some_and(|rest| rest.starts_with('_'))
    };
    if let Some(i) = columns.iter().position(|c| begins(&c)) {
        return Ok(i);
    }
    let short = || ["force_error"].into_iter().chain(Figure::traded_names());
    Err(SweepError::NoColumn {
        typed: name.to_string(),
        nearest: nearest(name, short().chain(NUMBERS)).map(str::to_string),
        known: short().collect::<Vec<_>>().join(", "),
    }
    .into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn front(points: &[[f64; 2]]) -> Vec<u64> {
        let mut front = Front::default();
        for (i, p) in points.iter().enumerate() {
            front.offer(i as u64, p, Vec::new);
        }
        front.sorted().iter().map(|p| p.row).collect()
    }

    #[test]
    fn only_designs_that_nothing_beats_stay() {
        assert_eq!(
            front(&[[2.0, 2.0], [1.0, 3.0], [3.0, 1.0], [3.0, 3.0]]),
            [1, 0, 2]
        );
        assert_eq!(front(&[[2.0, 2.0], [1.0, 1.0]]), [1]);
        assert_eq!(front(&[[1.0, 1.0], [1.0, 1.0], [f64::NAN, 0.0]]), [0]);
        // A gain of the size of rounding errors does not keep a design on the front. A gain of 1e-6 does.
        let stroke = 0.043_734_862;
        assert_eq!(front(&[[stroke, 2.0], [stroke * (1.0 - 1e-15), 3.0]]), [0]);
        assert_eq!(
            front(&[[stroke, 2.0], [stroke * (1.0 - 1e-6), 3.0]]),
            [1, 0]
        );
    }

    #[test]
    fn the_front_is_that_of_comparing_every_pair() {
        let points: Vec<[f64; 2]> = (0..300_u64)
            .map(|i| [0, 1].map(|k| crate::sweep::Method::Latin.coordinate(i, 300, k, 3)))
            .collect();
        let beaten = |p: &[f64; 2]| {
            points
                .iter()
                .any(|q| q != p && q[0] <= p[0] && q[1] <= p[1])
        };
        let mut expected: Vec<u64> = (0..300).filter(|&i| !beaten(&points[i as usize])).collect();
        let mut found = front(&points);
        expected.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, expected);
    }

    #[test]
    fn the_best_compromise_is_the_knee() {
        let mut front = Front::default();
        for (i, p) in [[0.0, 10.0], [1.0, 1.0], [10.0, 0.0]].iter().enumerate() {
            front.offer(i as u64, p, Vec::new);
        }
        assert_eq!(front.best().map(|p| p.row), Some(1));
    }

    #[test]
    fn objectives_are_found_by_their_beginning() {
        let columns: Vec<String> = NUMBERS.iter().map(|s| (*s).to_string()).collect();
        assert_eq!(
            columns[objective("force_error", &columns).unwrap()],
            "force_rms_error_percent"
        );
        assert_eq!(
            columns[objective("jerk", &columns).unwrap()],
            "jerk_max_m_per_s3"
        );
        let fault = objective("jrk", &columns).unwrap_err().to_string();
        assert!(fault.contains("did you mean \"jerk\""), "{fault}");
    }
}
