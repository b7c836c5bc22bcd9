//! Title block of the drawing: material, roughness, tolerance, revision and date.

use gaitcam::cam::{Cam, Measures};
use gaitcam::sweep::{Part, Scatter, Spread, Tolerance};
use gaitcam::synth::Design;

use super::Title;
use super::layout::Layout;
use super::pen::{Pen, Stroke};
use crate::words::Labels;

/// Letter height of the values in the fields, mm per em.
const VALUE: f64 = 2.9;
const NAME: f64 = 1.9;
const HEAD: f64 = 4.6;
/// Height of the title field, which is the first field of the block, mm.
const FIRST: f64 = 10.0;
const FIELD: f64 = 8.0;

/// Default roughness Ra of the profile, m, which is usual for grinding.
const USUAL_ROUGHNESS: f64 = 0.8e-6;
/// Profile tolerances from which one is chosen, m, in decreasing order.
const OFFERED: [f64; 6] = [1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6];
/// Number of cams with random profile errors that are computed for each tolerance.
const MADE: u64 = 1000;
const SEED: u64 = 1;

/// A profile tolerance and its effect on the force.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scattered {
    /// Half width of the tolerance band, m.
    tolerance: f64,
    /// RMS force error that 95 % of the cams with random profile errors do not exceed, in per cent of the mean force.
    error: f64,
}

/// Profile tolerance and its effect on the force error; `None` without a target force.
///
/// The tolerance of the scene is used if there is one. Otherwise it is the largest tolerance in [`OFFERED`] for which 95 % of the cams satisfy e² −
/// e₀² ≤ (½ `allowed`)². Here e is the RMS force error of a cam with random profile errors, and e₀ is the RMS force error of the exact cam. Both
/// errors are fractions of the mean force. If no tolerance satisfies this condition, the smallest one is used.
fn making(design: &Design, allowed: f64) -> Option<Scattered> {
    let scatter = Scatter::new(design).ok()?;
    let of = |tolerance: f64| {
        let part = [Tolerance {
            part: Part::Profile,
            half_width: tolerance,
            relative: false,
        }];
        let errors: Vec<f64> = (0..MADE)
            .map(|i| scatter.sample(&part, i, MADE, SEED).force_rms_error_percent)
            .collect();
        let error = Spread::of(&errors, None).map_or(f64::NAN, |s| s.quantiles[2]);
        Scattered { tolerance, error }
    };
    if let Some(given) = design.problem.cam.making.tolerance {
        return Some(of(given));
    }
    let own = design.force.rms_error_percent_of_mean;
    let keeps = |m: &Scattered| m.error.powi(2) - own.powi(2) <= (50.0 * allowed).powi(2);
    let narrowest = OFFERED[OFFERED.len() - 1];
    let widest = OFFERED.into_iter().map(of).find(keeps);
    widest.or_else(|| Some(of(narrowest)))
}

/// Name and value of one field of the title block.
type Field = (String, String);

/// Draws the title block for one cam. Sheets are numbered from 1.
pub fn draw(
    pen: &mut Pen,
    (design, cam, name): (&Design, &Cam, Option<&str>),
    title: &Title,
    sheet: [usize; 2],
    layout: &Layout,
    words: &Labels,
) {
    let area = layout.title;
    let (left, right) = (area.left, area.right);
    pen.frame([left, area.bottom], [right, area.top], Stroke::Outline);
    let under = area.top - FIRST;
    pen.line(&[[left, under], [right, under]], Stroke::Thin);
    let head = match name {
        Some(which) => format!("{} – {}", design.problem.name, words.text(which)),
        None => design.problem.name.clone(),
    };
    pen.text_within(&head, [left + 2.0, under + 3.0], HEAD, right - left - 4.0);
    let wide = (right - left) / layout.blocks as f64;
    let fields = fields(design, cam, title, sheet, layout, words);
    for (i, (name, value)) in fields.iter().enumerate() {
        let (row, column) = (i / layout.blocks, i % layout.blocks);
        let x = left + wide * column as f64;
        let top = under - FIELD * row as f64;
        pen.text_within(name, [x + 1.5, top - 2.5], NAME, wide - 3.0);
        pen.text_within(value, [x + 1.5, top - 6.6], VALUE, wide - 3.0);
        pen.frame([x, top - FIELD], [x + wide, top], Stroke::Thin);
    }
}

fn fields(
    design: &Design,
    cam: &Cam,
    title: &Title,
    [sheet, sheets]: [usize; 2],
    layout: &Layout,
    words: &Labels,
) -> Vec<Field> {
    let field = |key: &str, value: String| (words.text(key), value);
    let unit = words.units().name();
    let long = |x: f64| format!("{} {unit}", words.length(x, 3));
    let blank = || "–".to_string();
    let curvature = cam.curvature();
    let concave = curvature.concave.map_or_else(blank, |c| long(-c.value));
    let roller = cam.follower.roller_radius();
    let contact = match cam.face_width() {
        Some(width) => field("drawing-face", long(width)),
        None => field("drawing-roller", format!("Ø {}", long(2.0 * roller))),
    };
    let speed = match cam.follower.measures() {
        Measures::Straight => format!("{} m/s", words.number(design.problem.drive.speed.abs())),
        Measures::Translating | Measures::Oscillating => {
            let rpm = design.problem.drive.speed * 30.0 / std::f64::consts::PI;
            format!("{} rpm", words.number(rpm.abs()))
        }
    };
    let made = &design.problem.cam.making;
    let steel = || words.text("drawing-steel");
    let mut material = made.material.clone().unwrap_or_else(steel);
    if let Some(hardness) = made.hardness {
        material = format!("{material}, {hardness}");
    }
    let roughness = made.roughness.unwrap_or(USUAL_ROUGHNESS);
    let roughness = format!("Ra {} (Ra 3.2)", short(1e6 * roughness));
    let (tolerance, error) = accuracy(design, title, words);
    let program = concat!("gaitcam ", env!("CARGO_PKG_VERSION")).to_string();
    vec![
        field("drawing-material", material),
        field("drawing-roughness", words.decimal(roughness)),
        field("drawing-tolerance", tolerance),
        field("drawing-force-error", error),
        field("drawing-follower", words.name(cam.follower.kind().name())),
        contact,
        field("drawing-convex", long(curvature.convex.value)),
        field("drawing-concave", concave),
        field("drawing-speed", words.decimal(speed)),
        field(
            "drawing-scale",
            format!("{}  ({})", layout.scale.text(), layout.name),
        ),
        field(
            "drawing-revision",
            title.revision.map_or_else(blank, |r| format!("{r:08x}")),
        ),
        field("drawing-date", title.date.map_or_else(blank, civil_date)),
        field("drawing-sheet", format!("{sheet} / {sheets}")),
        field(
            "drawing-units",
            words.fill("drawing-lengths", &[("unit", unit)]),
        ),
        field("drawing-program", program),
    ]
}

/// Profile tolerance and the force error that results from it, as text.
fn accuracy(design: &Design, title: &Title, words: &Labels) -> (String, String) {
    let making = making(design, title.accuracy);
    let error = match &making {
        Some(m) => {
            let error = words.number(m.error);
            let own = words.number(design.force.rms_error_percent_of_mean);
            let arguments = [("error", error.as_str()), ("own", &own)];
            words.decimal(words.fill("drawing-force", &arguments))
        }
        None => words.text("drawing-no-force"),
    };
    let tolerance = making.map_or(design.problem.cam.making.tolerance, |m| Some(m.tolerance));
    let units = words.units();
    let within = |t: f64| format!("± {} {}", short(units.per_metre() * t), units.name());
    let tolerance = tolerance.map_or("–".to_string(), within);
    (words.decimal(tolerance), error)
}

/// Text of a number with six decimals, without trailing zeros.
fn short(x: f64) -> String {
    format!("{}", (1e6 * x).round() / 1e6)
}

/// Date `days` after 1970-01-01 in the Gregorian calendar, such as 2026-01-31.
fn civil_date(days: u64) -> String {
    let leap = |y: u64| y.is_multiple_of(4) && (!y.is_multiple_of(100) || y.is_multiple_of(400));
    let (mut year, mut left) = (1970, days);
    while left >= 365 + u64::from(leap(year)) {
        left -= 365 + u64::from(leap(year));
        year += 1;
    }
    let february = 28 + u64::from(leap(year));
    let months = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while left >= months[month] {
        left -= months[month];
        month += 1;
    }
    format!("{year}-{:02}-{:02}", month + 1, left + 1)
}

#[cfg(test)]
mod tests {
    use super::civil_date;

    #[test]
    fn days_are_dates_of_the_gregorian_calendar() {
        // Days since 1970-01-01 of known dates, including leap years and turns of centuries.
        for (days, date) in [
            (0, "1970-01-01"),
            (59, "1970-03-01"),
            (11_016, "2000-02-29"),
            (20_454, "2026-01-01"),
            (47_541, "2100-03-01"),
        ] {
            assert_eq!(civil_date(days), date);
        }
    }
}
