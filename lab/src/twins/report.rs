//! Report reports/twins.md: force errors of corrected cams, and coverage of the intervals, for many twins.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use rayon::prelude::*;

use super::{Case, Class};
use crate::fault;
use gaitcam::error::Result;
use gaitcam::identify::Parameter;
use gaitcam_output::Language;
use gaitcam_output::overlay::{Strip, diagrams_over};

/// Numbers of the twins whose cams are corrected twice. The method was developed with other numbers, and these were evaluated only once.
pub const CUTS: std::ops::Range<u64> = 3000..3050;
/// Number of machines per class whose parameters are identified.
pub const INTERVALS: u64 = 200;
/// Required errors after one and two corrected cams, percent of the weight.
const ASKED: [f64; 2] = [1.0, 0.5];

/// Identified parameter with its true value.
pub type Estimate = (Parameter, f64);

/// Errors of a twin before and after corrected cams, percent of the weight.
///
/// # Errors
///
/// A log that is rejected.
pub fn errors(number: u64) -> Result<Vec<f64>> {
    Ok(Case::new(Class::Whole, number)?.cuts(2)?.0)
}

/// Parameters of a twin.
///
/// # Errors
///
/// A log that is rejected.
pub fn parameters(class: Class, number: u64) -> Result<Vec<Estimate>> {
    Case::new(class, number)?.parameters()
}

/// Measures and writes the report in about ten minutes of processor time.
///
/// # Errors
///
/// Logs that are rejected; files that cannot be written.
pub fn run(out: &Path) -> Result<()> {
    let cut: Result<Vec<_>> = CUTS.into_par_iter().map(errors).collect();
    let classes = [Class::Model, Class::TwoHarmonics, Class::Whole];
    let all: Vec<(Class, u64)> = classes
        .into_iter()
        .flat_map(|class| (0..INTERVALS).map(move |i| (class, i)))
        .collect();
    let found: Result<Vec<_>> = all
        .into_par_iter()
        .map(|(class, i)| Ok((class, parameters(class, i)?)))
        .collect();
    write(out, &cut?, &found?)
}

/// Writes the report and its picture.
fn write(out: &Path, errors: &[Vec<f64>], found: &[(Class, Vec<Estimate>)]) -> Result<()> {
    let mut sorted: Vec<Vec<f64>> = (0..3)
        .map(|cut| errors.iter().map(|e| e[cut]).collect())
        .collect();
    sorted
        .iter_mut()
        .for_each(|list| list.sort_by(f64::total_cmp));
    let count = errors.len();
    let below = |cut: usize| sorted[cut].iter().filter(|e| **e <= ASKED[cut - 1]).count();
    let mut page = String::from(
        "# Twins: identified and cut anew\n\nThe parameters of these simulated machines are hidden from `gaitcam identify` and `gaitcam recut`. The machines are integrated in time with a different method (`lab/src/twins`). Two thirds of them have a mass of 71 kg on the cam, at 1.85 steps per second. One third has a mass of 2 kg with a spring. Masses, springs, dampers and preloads differ from the scene by up to 3 %, 3 %, 30 % and 2 %. Each log has 15 to 40 cycles at 500 to 2000 samples per second, with noise of 1 to 5 N; 70 % contain the cam angle. The whole machine has a contact of 4 to 22 MN/m, Coulomb, viscous and Stribeck friction (1 to 9 N, \
         5 to 40 N s/m), a motor whose speed ripples, play (up to 5 µm of lift), a lag of 0.2 to 2 ms, a delay of up to 2 ms, every \
         second a floor of 10 to 60 t at 5 to 15 Hz, and two harmonics of 2 to 8 N of unknown origin.\n\n\
         ## Force error\n\nThe method was fixed before the 50 machines of this table were generated. The error is the RMS over time of the difference between true and target force, at the best phase, in percent of the weight. For a mass on the cam the mean is excluded, because no cam can change it.\n\n\
         | iterations | median | 90 % quantile | maximum | below the target |\n|---|---|---|---|---|\n",
    );
    for (cut, list) in sorted.iter().enumerate() {
        let asked = match cut {
            0 => String::from("–"),
            cut => format!(
                "{} of {count} below {} % (target: 45)",
                below(cut),
                ASKED[cut - 1]
            ),
        };
        let (median, most, last) = (list[count / 2], list[count * 9 / 10 - 1], list[count - 1]);
        line(
            &mut page,
            &format!("| {cut} | {median:.2} | {most:.2} | {last:.2} | {asked} |"),
        );
    }
    line(
        &mut page,
        "\n![Force errors before and after each iteration, sorted](twins.svg)\n\n## Intervals\n",
    );
    line(
        &mut page,
        "The table gives the share of true values inside their 95 % intervals (target: 93 to 97 %), for all parameters and for identified parameters. An interval with an open end contains all values beyond. Stribeck friction and sensor lag are compared with the closest parameters of the model: the Coulomb force, and lag plus delay.\n",
    );
    line(
        &mut page,
        "| machine | twins | inside | identified | of these inside |\n|---|---|---|---|---|",
    );
    let share = |part: usize, all: usize| match all {
        0 => String::from("–"),
        all => format!("{:.1} % of {all}", 100.0 * part as f64 / all as f64),
    };
    for class in [Class::Model, Class::TwoHarmonics, Class::Whole] {
        let own: Vec<&Estimate> = of(found, class).collect();
        let held = own.iter().filter(|f| holds(f)).count();
        let told: Vec<&&Estimate> = own.iter().filter(|f| f.0.identifiable).collect();
        let told_held = told.iter().filter(|f| holds(f)).count();
        let twins = found.iter().filter(|f| f.0 == class).count();
        let row = [
            share(held, own.len()),
            share(told.len(), own.len()),
            share(told_held, told.len()),
        ];
        line(
            &mut page,
            &format!("| {} | {twins} | {} |", name(class), row.join(" | ")),
        );
    }
    line(
        &mut page,
        "\n| parameter | of the model: inside, identified | whole: inside, identified |\n|---|---|---|",
    );
    let mut keys = BTreeMap::new();
    for class in [Class::Model, Class::Whole] {
        for (p, truth) in of(found, class) {
            let counts: &mut [[usize; 3]; 2] = keys.entry(p.key).or_default();
            let own = &mut counts[usize::from(class == Class::Whole)];
            own[0] += 1;
            own[1] += usize::from(holds(&(*p, *truth)));
            own[2] += usize::from(p.identifiable);
        }
    }
    for (key, counts) in keys {
        let both = counts.map(|[all, held, told]| format!("{held} of {all}, {told}"));
        line(
            &mut page,
            &format!("| `{key}` | {} | {} |", both[0], both[1]),
        );
    }
    let curve = |list: &Vec<f64>| -> Vec<(f64, f64)> {
        list.iter()
            .enumerate()
            .map(|(i, e)| (i as f64 + 1.0, *e))
            .collect()
    };
    let rows = [Strip {
        quantity: "% of the weight".into(),
        curves: sorted.iter().map(curve).collect(),
    }];
    let names = ["first cam", "corrected once", "corrected twice"].map(String::from);
    let picture = diagrams_over(
        "machines, sorted by their error",
        &format!("{count} simulated machines"),
        "force error",
        &names,
        &rows,
        Language::En,
    );
    let put = |name: &str, text: &str| {
        std::fs::write(out.join(name), text).map_err(|e| fault(format!("{name}: {e}")))
    };
    put("twins.md", &page)?;
    put("twins.svg", &picture.svg())
}

fn line(page: &mut String, text: &str) {
    let _ = writeln!(page, "{text}");
}

fn of(found: &[(Class, Vec<Estimate>)], class: Class) -> impl Iterator<Item = &Estimate> {
    found
        .iter()
        .filter(move |f| f.0 == class)
        .flat_map(|f| &f.1)
}

fn holds((p, truth): &Estimate) -> bool {
    p.low.is_none_or(|low| low <= *truth) && p.high.is_none_or(|high| *truth <= high)
}

fn name(class: Class) -> &'static str {
    match class {
        Class::Model => "of the model: rigid, friction, delay",
        Class::TwoHarmonics => "the same with a force in two harmonics",
        Class::Whole => "whole",
    }
}
