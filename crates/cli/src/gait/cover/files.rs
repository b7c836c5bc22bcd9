//! Files of a cover: the scene of each cam, the errors, the assignment of walkers, and the errors of other walkers.

use super::{CYCLES, PARTS};
use gaitcam::cover::{Assigned, Cover, Fold};
use gaitcam::error::Result;
use gaitcam::force::Walker;
use gaitcam::scene::{ErrorMeasure, Family, set_value};
use gaitcam::sweep::{Field, Records};
use gaitcam_app::design::scene_of_cover;
use gaitcam_app::{Input, ResultFolder};

/// The scene of each cam, without the walkers assigned to other cams.
pub(super) fn write_scenes(
    folder: &ResultFolder,
    input: &mut Input,
    cover: &Cover,
    walkers: &[Walker],
) -> Result<()> {
    let law = &cover.scene.law;
    for (cam, design) in cover.cams.iter().enumerate() {
        let objective = design.population.as_ref().map(|p| p.robust.clone());
        let mut table = input.whole.clone();
        let served = |w: &&Walker| {
            cover
                .each
                .iter()
                .any(|a| a.cam == cam && a.error.walker == w.name)
        };
        let mut out: Vec<String> = walkers
            .iter()
            .filter(|w| !served(w))
            .map(|w| w.name.clone())
            .collect();
        out.dedup();
        let name = format!("{}_{}_{}", input.scene.name, cover.cams.len(), cam + 1);
        let size = |of: Family, x: Option<usize>| {
            let x = x.filter(|_| law.family == of);
            x.map(|x| toml::Value::Integer(x as i64))
        };
        let values = [
            ("name", Some(name.into())),
            ("gait.file", Some(format!("../{CYCLES}").into())),
            ("gait.leave_out", Some(out.into())),
            ("law.robust", objective.map(Into::into)),
            ("law.family", Some(law.family.name().into())),
            ("law.spans", size(Family::Spline, law.spans)),
            ("law.harmonics", size(Family::Harmonic, law.harmonics)),
        ];
        for (key, value) in values {
            if let Some(value) = value {
                set_value(&mut table, key, value)?;
            }
        }
        let text = toml::to_string(&table).unwrap_or_default();
        folder.write(&scene_of_cover(cover.cams.len(), cam + 1), text.as_bytes())?;
    }
    Ok(())
}

/// A column of errors, with the unit in its name.
fn column(name: &str, error: ErrorMeasure, values: impl Iterator<Item = f64>) -> Field {
    Field::numbers(&format!("{name}_{}", error.suffix()), values.collect())
}

/// A column of counts.
fn counts(name: &str, values: impl Iterator<Item = usize>) -> Field {
    Field::numbers(name, values.map(|count| count as f64).collect())
}

pub(super) fn cover_csv(covers: &[Cover], error: ErrorMeasure) -> String {
    let all = || covers.iter();
    let fields = vec![
        counts("cams", all().map(|c| c.cams.len())),
        column("mean", error, all().map(|c| c.mean)),
        column("worst", error, all().map(|c| c.worst)),
        column("bound", error, all().map(|c| c.bound.unwrap_or(f64::NAN))),
    ];
    Records { fields }.csv()
}

pub(super) fn assignment_csv(covers: &[Cover], error: ErrorMeasure) -> String {
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
    Records { fields }.csv()
}

pub(super) fn folds_csv(folds: &[Fold], error: ErrorMeasure) -> String {
    let all = || folds.iter();
    let fields = vec![
        counts("cams", all().map(|f| f.cams)),
        counts("walkers", all().map(|f| f.walkers)),
        column("in_mean", error, all().map(|f| f.in_mean)),
        column("in_worst", error, all().map(|f| f.in_worst)),
        column("out_mean", error, all().map(|f| f.out_mean)),
        column("out_worst", error, all().map(|f| f.out_worst)),
    ];
    Records { fields }.csv()
}
