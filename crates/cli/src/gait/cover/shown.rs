//! Output of `gaitcam cover` for the user: table, picture and JSON.

use serde_json::{Value, json};

use crate::console::language;
use crate::console::table::{
    Side::{Left, Right},
    table,
};
use crate::console::words::{self, number};
use gaitcam::cover::{Assigned, Cover, Fold};
use gaitcam::scene::{ErrorMeasure, Robust};
use gaitcam::wording::walker;
use gaitcam_app::Input;
use gaitcam_output::Picture;
use gaitcam_output::cover::{CoverWords, Curve, cover as cover_picture};
use gaitcam_output::cover_tables::PARTS;

pub(super) fn object(cover: &Cover, error: ErrorMeasure) -> Value {
    let out = json!({"cams": cover.cams.len(), "assignment": cover.each});
    let values = [
        ("mean", Some(cover.mean)),
        ("worst", Some(cover.worst)),
        ("bound", cover.bound),
        ("objective", Some(cover.objective)),
    ];
    in_unit(out, &values, error)
}

pub(super) fn fold_object(fold: &Fold, error: ErrorMeasure) -> Value {
    let out = json!({"cams": fold.cams, "walkers": fold.walkers});
    let values = [
        ("in_mean", Some(fold.in_mean)),
        ("in_worst", Some(fold.in_worst)),
        ("out_mean", Some(fold.out_mean)),
        ("out_worst", Some(fold.out_worst)),
    ];
    in_unit(out, &values, error)
}

/// Returns the JSON object with the given errors added. The name of each error ends with the unit of the error measure.
fn in_unit(mut object: Value, values: &[(&str, Option<f64>)], error: ErrorMeasure) -> Value {
    for (name, value) in values {
        object[format!("{name}_{}", error.suffix())] = json!(value);
    }
    object
}

/// Name of the component (weight, speed or shape) with the largest part of a walker's force error.
pub fn reason(of: &Assigned) -> String {
    let largest =
        (0..PARTS.len()).max_by(|i, j| of.parts_percent[*i].total_cmp(&of.parts_percent[*j]));
    words::text(&format!("cover-{}", PARTS[largest.unwrap_or_default()]))
}

/// Table of the errors for each number of cams, with the name of the walker with the maximum error and the errors of cross-validation.
pub(super) fn text(input: &Input, covers: &[Cover], folds: &[Fold]) -> String {
    let mut rows = vec![
        [
            "cams",
            "mean",
            "worst",
            "objective",
            "bound",
            "others-mean",
            "others-worst",
            "who",
        ]
        .map(|c| words::text(&format!("cover-{c}")))
        .to_vec(),
    ];
    let error = input.scene.law.error;
    let shown = |x: Option<f64>| x.map_or("–".to_string(), number);
    for cover in covers {
        let worst = cover
            .each
            .iter()
            .max_by(|a, b| a.error.measured(error).total_cmp(&b.error.measured(error)));
        let most = folds.iter().rfind(|f| f.cams == cover.cams.len());
        rows.push(vec![
            cover.cams.len().to_string(),
            number(cover.mean),
            number(cover.worst),
            number(cover.objective),
            shown(cover.bound),
            shown(most.map(|f| f.out_mean)),
            shown(most.map(|f| f.out_worst)),
            worst.map_or(String::new(), |w| {
                format!(
                    "{} ({})",
                    walker(language::current(), &w.error.walker),
                    reason(w)
                )
            }),
        ]);
    }
    let of = match input.scene.law.robust {
        Robust::Worst => "cover-bound-worst",
        Robust::Mean => "cover-bound-mean",
        Robust::Tail(_) => "cover-bound-tail",
    };
    let walkers = covers.first().map_or(0, |c| c.each.len());
    let head = words::fill(
        &of_unit("cover-head", error),
        &json!({"name": input.scene.name, "cycles": walkers}),
    );
    let sides = [&[Right; 7][..], &[Left]].concat();
    format!("{head}\n{}\n{}", table(&rows, &sides), words::text(of))
}

/// Key of a message for an error measure. Messages for errors relative to the mean force have the key `message`. Messages for errors in
/// newtons have the key `message` followed by `-n`.
pub fn of_unit(message: &str, error: ErrorMeasure) -> String {
    match error {
        ErrorMeasure::Relative => message.to_string(),
        ErrorMeasure::Absolute => format!("{message}-n"),
    }
}

/// Picture of the error as a function of the number of cams, for the walkers of the design and for other walkers.
pub(super) fn picture(input: &Input, covers: &[Cover], folds: &[Fold]) -> Picture {
    let of = |value: fn(&Cover) -> Option<f64>| -> Vec<(f64, f64)> {
        let point = |c: &Cover| Some((c.cams.len() as f64, value(c)?));
        covers.iter().filter_map(point).collect()
    };
    let most = folds.iter().map(|f| f.walkers).max();
    let others = |value: fn(&Fold) -> f64| -> Vec<(f64, f64)> {
        let whole = folds.iter().filter(|f| Some(f.walkers) == most);
        whole.map(|f| (f.cams as f64, value(f))).collect()
    };
    let curve = |name: &str, points| Curve {
        name: words::text(&format!("cover-{name}")),
        points,
    };
    // The maximum error has a separate curve.
    let objective = match input.scene.law.robust {
        Robust::Worst => Vec::new(),
        Robust::Mean | Robust::Tail(_) => of(|c| Some(c.objective)),
    };
    let curves = [
        curve("bound", of(|c| c.bound)),
        curve("objective", objective),
        curve("others-mean", others(|f| f.out_mean)),
        curve("others-worst", others(|f| f.out_worst)),
        curve("mean", of(|c| Some(c.mean))),
        curve("worst", of(|c| Some(c.worst))),
    ];
    let [number, what] = ["number", "what"].map(|name| words::text(&format!("cover-{name}")));
    let error = words::text(&of_unit("cover-error", input.scene.law.error));
    let words = CoverWords {
        name: &input.scene.name,
        what: &what,
        error: &error,
        number: &number,
    };
    cover_picture(&words, &curves, language::current())
}
