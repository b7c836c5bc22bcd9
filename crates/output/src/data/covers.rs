//! Tables on sets of cams for a population: errors for each number of cams, assignment of walkers to cams, and errors of cross-validation.

use gaitcam::cover::{Assigned, Cover, Fold};
use gaitcam::scene::ErrorMeasure;
use gaitcam::sweep::{Field, Records};

/// Names of the components of a force error in column names. The components are due to differences in weight, speed and shape.
pub const PARTS: [&str; 3] = ["weight", "speed", "shape"];

/// Table column with errors. The name of the column is `name` followed by the unit of the error measure.
fn column(name: &str, error: ErrorMeasure, values: impl Iterator<Item = f64>) -> Field {
    Field::numbers(&format!("{name}_{}", error.suffix()), values.collect())
}

/// Table column with whole numbers, such as the number of cams.
fn counts(name: &str, values: impl Iterator<Item = usize>) -> Field {
    Field::numbers(name, values.map(|count| count as f64).collect())
}

/// `cover.csv`: mean and maximum error for each number of cams, and the lower bound of the objective.
pub fn cover(covers: &[Cover], error: ErrorMeasure) -> Records {
    let all = || covers.iter();
    let fields = vec![
        counts("cams", all().map(|c| c.cams.len())),
        column("mean", error, all().map(|c| c.mean)),
        column("worst", error, all().map(|c| c.worst)),
        column("bound", error, all().map(|c| c.bound.unwrap_or(f64::NAN))),
    ];
    Records { fields }
}

/// `assignment.csv`: the cam assigned to each cycle, the RMS error with this cam, and the components of the error.
pub fn assignment(covers: &[Cover], error: ErrorMeasure) -> Records {
    let all = || {
        covers
            .iter()
            .flat_map(|c| c.each.iter().map(|a| (c.cams.len(), a)))
    };
    let mut fields = vec![
        counts("cams", all().map(|(cams, _)| cams)),
        Field::words("walker", all().map(|(_, a)| a.error.walker.as_str())),
        counts("cam", all().map(|(_, a)| a.cam + 1)),
        column(
            "rms_error",
            error,
            all().map(|(_, a)| a.error.measured(error)),
        ),
    ];
    for (k, part) in PARTS.iter().enumerate() {
        let share = |a: &Assigned| {
            let whole = a.error.rms_error_percent.max(f64::MIN_POSITIVE);
            a.parts_percent[k] * a.error.measured(error) / whole
        };
        fields.push(column(part, error, all().map(|(_, a)| share(a))));
    }
    Records { fields }
}

/// `folds.csv`: errors of cross-validation. Columns with `in` contain the errors of the walkers for whom the cams were designed. Columns
/// with `out` contain the errors of the other walkers.
pub fn folds(folds: &[Fold], error: ErrorMeasure) -> Records {
    let all = || folds.iter();
    let fields = vec![
        counts("cams", all().map(|f| f.cams)),
        counts("walkers", all().map(|f| f.walkers)),
        column("in_mean", error, all().map(|f| f.in_mean)),
        column("in_worst", error, all().map(|f| f.in_worst)),
        column("out_mean", error, all().map(|f| f.out_mean)),
        column("out_worst", error, all().map(|f| f.out_worst)),
    ];
    Records { fields }
}
