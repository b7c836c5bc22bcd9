//! Texts that contain exactly one cycle: samples at equal or unequal time steps, or the critical points of a curve.
//!
//! Such a text has a comment line `# cycle` or `# critical points`. Another comment gives the period, for example `period_s = 0.5`. The
//! table below the comments has a time column and a force column, and optionally a column with the spread of the force.

use std::f64::consts::TAU;
use std::path::Path;

use super::critical_points::{critical, through};
use super::cycle_samples::{newtons, of_phase, one_force, samples};
use super::keys;
use super::mat::{self, Mat};
use super::text::{Lines, LongTable, Position, TextFile, next_table, no_force, plain, text};
use super::timebase::polyline;
use crate::curve::{ForceCurve, SAMPLES};
use crate::error::{Error, ForceError, Placed, ReadError, Result};
use crate::quantity::seconds;
use crate::recording::{Note, ReadOptions};

/// Number of lines at the start of a text that are searched for the comment that marks a cycle.
const HEAD: usize = 40;

/// Content of a marked text: samples of a cycle, or critical points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Cycle,
    CriticalPoints,
}

/// Comments at the start of a text.
fn comments(bytes: &[u8]) -> Vec<String> {
    let lines = Lines::new(bytes).take(HEAD);
    let marked = lines.filter(|(_, l)| l.first() == Some(&b'#'));
    let text = |l: &[u8]| text(l).trim_start_matches('#').trim().to_string();
    marked.map(|(_, l)| text(l)).collect()
}

/// Whether a file is a text marked as one cycle.
pub fn is_marked(bytes: &[u8]) -> bool {
    comments(&plain(bytes)).iter().any(|c| kind(c).is_some())
}

/// Reads a text marked as one cycle. If a period or a span is given, any table is read, including a MAT file. `None` for other files.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Option<ForceCurve>> {
    let is_mat = mat::is_level_5(bytes);
    let text_bytes = (!is_mat).then(|| plain(bytes));
    let bytes = text_bytes.as_deref().unwrap_or(bytes);
    let comments = comments(bytes);
    let asked = options.period_s.is_some() || options.span_rad.is_some();
    let said = comments.iter().find_map(|c| kind(c));
    let Some(kind) = said.or(asked.then_some(Kind::Cycle)) else {
        return Ok(None);
    };
    let file = &TextFile::new(path, bytes, options);
    let long = LongTable::of(path, bytes, options);
    let (table, (mut samples, time_unit), cycles) = match &long {
        Some(long) => {
            let (samples, cycles) = long.mean()?;
            (long.table().clone(), (samples, None), cycles)
        }
        None if is_mat => {
            let Mat { table, samples, .. } = mat::table(path, bytes, options)?;
            let samples = one_force(file, &table, samples)?;
            (table, samples, 1)
        }
        None => {
            let table =
                next_table(bytes, file.delimiters, Position::START).ok_or_else(|| match said {
                    Some(_) => ReadError::CycleWithoutTable.in_file(path),
                    None => no_force(file, &[]),
                })?;
            let samples = samples(file, &table)?;
            (table, samples, 1)
        }
    };
    let keys = keys::read(&comments, file.delimiters.comma);
    let mass_kg = options.mass_kg.or(keys.mass_kg);
    let factor = newtons(file, &table, &samples, mass_kg)?;
    for x in samples.forces.iter_mut().flat_map(|f| &mut f.values) {
        *x *= factor;
    }
    let mut columns = samples.forces.into_iter().map(|f| f.values);
    let (force, spread) = (columns.next().unwrap_or_default(), columns.next());
    let mut times = samples.times.unwrap_or_default();
    for time in &mut times {
        *time *= time_unit.unwrap_or(1.0);
    }
    let said = comments.iter().find_map(|c| period(c));
    let period = options.period_s.or(said);
    let mut clock = None;
    if let Some(column) = samples.phase {
        times = of_phase(column, times, period, options).map_err(|e| e.in_file(path))?;
    } else if kind == Kind::Cycle && asked {
        clock = time_unit.and_then(|_| other_clock(&times, options));
        times = stretched(times, options);
    }
    let name = path.file_name().and_then(|n| n.to_str());
    let name = name.unwrap_or("cycle");
    let name = &match cycles {
        1 => name.to_string(),
        _ => format!("{name}, {cycles} cycles"),
    };
    let place = |e: Error| e.in_file(path);
    let mut curve = match kind {
        Kind::CriticalPoints => critical(name, &times, &force, period),
        Kind::Cycle => match options.span_rad {
            Some(span) => spanned(name, &times, &force, span / TAU, period),
            None => sampled(name, &times, &force, period),
        },
    }
    .map_err(place)?;
    if let (Kind::Cycle, Some(spread)) = (kind, spread) {
        let spread = sampled(name, &times, &spread, period).map_err(place)?;
        curve.spread_n = Some(spread.force_n);
    }
    curve.mass_kg = mass_kg;
    curve.notes.extend(samples.notes);
    curve.noise_n = options.noise_n.or(keys.noise_n);
    curve.steps = keys.steps;
    let open = |question| Note::LeftOpen { question };
    curve.notes.extend(keys.open.into_iter().map(open));
    let differs = |clock| Note::ClockDiffers {
        clock: seconds(clock),
        period: seconds(curve.period_s),
    };
    curve.notes.extend(clock.map(differs));
    Ok(Some(curve))
}

fn kind(comment: &str) -> Option<Kind> {
    let lower = comment.to_lowercase();
    if lower.starts_with("critical points") {
        return Some(Kind::CriticalPoints);
    }
    let rest = lower.strip_prefix("cycle")?;
    (rest.is_empty() || rest.starts_with([',', ' ', ':'])).then_some(Kind::Cycle)
}

/// Period from a comment such as `period_s = 0.5` or `period 0.5 s`.
fn period(comment: &str) -> Option<f64> {
    let lower = comment.to_lowercase();
    let rest = &lower[lower.find("period")? + "period".len()..];
    let rest = rest
        .trim_start_matches("_s")
        .trim_start_matches([' ', '=', ':']);
    keys::number(rest, false).filter(|period| *period > 0.0)
}

/// A cycle from samples. Samples at uniform times are unchanged. Other samples are resampled at equal phases.
pub(super) fn sampled(
    name: &str,
    times: &[f64],
    force: &[f64],
    period: Option<f64>,
) -> Result<ForceCurve> {
    let n = times.len();
    if n < 4 {
        return Err(ForceError::FewSamples { samples: n }.into());
    }
    let span = times[n - 1] - times[0];
    if span <= 0.0 {
        let at = seconds(times[0]);
        return Err(ReadError::TimeStandsStill { at }.into());
    }
    let step = span / (n - 1) as f64;
    let period = period.unwrap_or(span + step);
    if span > period * (1.0 + 1e-9) {
        let (span, period) = (seconds(span), seconds(period));
        return Err(ReadError::CycleTooLong { span, period }.into());
    }
    // The first sample may be repeated at the end.
    let closed = (span - period).abs() < 1e-6 * period;
    let count = if closed { n - 1 } else { n };
    let even = period / count as f64;
    let strays = times
        .iter()
        .enumerate()
        .any(|(i, t)| (t - times[0] - i as f64 * even).abs() > 0.01 * even);
    if !strays {
        return ForceCurve::from_samples(name, period, force[..count].to_vec());
    }
    let mut points: Vec<(f64, f64)> = times
        .iter()
        .zip(force)
        .map(|(t, f)| (t - times[0], *f))
        .collect();
    points.dedup_by(|b, a| b.0 <= a.0);
    through(name, points, period)
}

/// Duration of the samples, s, according to the times in a file, if it is inconsistent with the given period; otherwise `None`. If a span
/// is given, the duration is compared with this span of the period.
fn other_clock(times: &[f64], options: &ReadOptions) -> Option<f64> {
    let (Some(period), [first, .., last]) = (options.period_s, times) else {
        return None;
    };
    let covered = options.span_rad.map_or(period, |s| period * s / TAU);
    let (length, step) = (last - first, (last - first) / (times.len() - 1) as f64);
    // The last sample may close the cycle or be one step before its end.
    let fits = covered > length - step && covered < length + 2.0 * step;
    (!fits && length > 0.0).then_some(length)
}

/// Scales the times of a file of one cycle. The samples then fill the period, or the given span of the period.
fn stretched(times: Vec<f64>, options: &ReadOptions) -> Vec<f64> {
    let (Some(period), [first, .., last]) = (options.period_s, &times[..]) else {
        return times;
    };
    let covered = options.span_rad.map_or(period, |s| period * s / TAU);
    let step = (last - first) / (times.len() - 1) as f64;
    // The samples include both ends of the cycle if the times cover the whole period, or if a span is given.
    let holds_ends = options.span_rad.is_some() || ((last - first) / period - 1.0).abs() < 1e-6;
    let length = if holds_ends {
        last - first
    } else {
        last - first + step
    };
    let (first, factor) = (*first, covered / length);
    times.iter().map(|t| (t - first) * factor).collect()
}

/// A cycle with the given force in a fraction `share` of the turn and zero force in the rest of the turn.
fn spanned(
    name: &str,
    times: &[f64],
    force: &[f64],
    share: f64,
    period: Option<f64>,
) -> Result<ForceCurve> {
    let n = times.len();
    if n < 4 {
        return Err(ForceError::FewSamples { samples: n }.into());
    }
    let length = times[n - 1] - times[0];
    let period = period.unwrap_or(length / share);
    let since: Vec<f64> = times.iter().map(|t| t - times[0]).collect();
    let mut line = polyline(&since, force);
    let samples = (0..SAMPLES).map(|k| {
        let t = period * k as f64 / SAMPLES as f64;
        if t > length { 0.0 } else { line(t) }
    });
    ForceCurve::from_samples(name, period, samples.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::{CycleColumn, Place};

    fn curve(t: &str) -> Result<ForceCurve> {
        read(Path::new("c.csv"), t.as_bytes(), &ReadOptions::default()).map(|c| c.expect("a cycle"))
    }

    #[test]
    fn a_marked_cycle_is_taken_as_it_stands() {
        let c = curve("# cycle, period_s = 0.8\ntime_s,force_n,spread_n\n0,1,0.1\n0.2,2,0.2\n0.4,3,0.3\n0.6,4,0.4\n").unwrap();
        assert_eq!(
            (c.period_s, &c.force_n[..]),
            (0.8, &[1.0, 2.0, 3.0, 4.0][..])
        );
        assert_eq!(c.spread_n.unwrap(), [0.1, 0.2, 0.3, 0.4]);
        let closed = curve("# cycle\n# period 0.6 s\ntime_s,force_lbf\n0,1\n0.2,2\n0.4,3\n0.6,1\n");
        assert!(closed.is_err(), "three samples are too few");
    }

    #[test]
    fn the_unit_of_the_times_is_that_of_their_column() {
        for (column, step) in [
            ("time", 0.1),
            ("time_s", 0.1),
            ("time_ms", 100.0),
            ("t [ms]", 100.0),
            ("time (us)", 1e5),
        ] {
            let rows: String = (0..4)
                .map(|i| format!("{},{}\n", step * f64::from(i), 100 * i))
                .collect();
            let text = format!("# cycle\n{column},force_n\n{rows}");
            let open = |period_s| {
                let options = ReadOptions {
                    period_s,
                    ..ReadOptions::default()
                };
                read(Path::new("m.csv"), text.as_bytes(), &options)
                    .unwrap()
                    .unwrap()
            };
            assert!((open(None).period_s - 0.4).abs() < 1e-12, "{column}");
            assert!(open(Some(0.4)).notes.is_empty(), "{column}");
            assert!(!open(Some(10.0)).notes.is_empty(), "{column}");
        }
    }

    #[test]
    fn a_period_makes_any_file_one_cycle_and_a_span_leaves_the_rest_zero() {
        let text: String = (0..101)
            .map(|i| format!("{},{}\n", f64::from(i) * 0.01, -50.0 + f64::from(i)))
            .collect();
        let text = format!("time,force\n{text}");
        let open = |period_s, span_rad| {
            let options = ReadOptions {
                period_s,
                span_rad,
                ..ReadOptions::default()
            };
            let c = read(Path::new("m.csv"), text.as_bytes(), &options);
            c.unwrap().unwrap()
        };
        let whole = open(Some(0.5), None);
        assert_eq!((whole.period_s, whole.force_n.len()), (0.5, 101));
        assert_eq!(
            (whole.force_n[0], whole.force_n[100]),
            (-50.0, 50.0),
            "forces keep their sign"
        );
        let half = open(Some(2.0), Some(0.5 * TAU));
        let n = half.force_n.len();
        assert_eq!(half.period_s, 2.0);
        assert!((half.force_n[n / 4]).abs() < 1e-9 && half.force_n[3 * n / 4] == 0.0);
        // Times up to 1 s are scaled to the given period. A note is added if the period differs from 1 s by more than a sample.
        let is_noted = |period, span| !open(Some(period), span).notes.is_empty();
        for (period, noted) in [
            (0.5, true),
            (0.98, true),
            (0.995, false),
            (1.0, false),
            (1.01, false),
            (1.03, true),
            (10.0, true),
        ] {
            assert_eq!(is_noted(period, None), noted, "{period} s");
            assert_eq!(
                is_noted(2.0 * period, Some(0.5 * TAU)),
                noted,
                "half of {period} s"
            );
        }
        assert!(open(None, Some(0.25 * TAU)).notes.is_empty());
        // Without a period, the times are not scaled.
        assert!((open(None, Some(0.25 * TAU)).period_s - 4.0).abs() < 1e-9);
    }

    #[test]
    fn critical_points_are_met_level_and_without_overshoot() {
        let c = curve("# critical points, period_s = 0.5\ntime_s,force_n\n0,0\n0.125,100\n0.25,50\n0.375,80\n0.4375,0\n").unwrap();
        let n = c.force_n.len();
        for (k, f) in [
            (0, 0.0),
            (n / 4, 100.0),
            (n / 2, 50.0),
            (3 * n / 4, 80.0),
            (7 * n / 8, 0.0),
        ] {
            assert!((c.force_n[k] - f).abs() < 1e-9);
        }
        assert!(c.force_n.iter().all(|f| (-1e-9..=100.0 + 1e-9).contains(f)));
        assert!(c.force_n[7 * n / 8..].iter().all(|f| f.abs() < 1e-9));
    }

    #[test]
    fn a_faulty_cycle_is_refused_by_line() {
        let fault = |t: &str| {
            let e = curve(t).unwrap_err();
            let kind = e
                .fault::<ReadError>()
                .cloned()
                .expect("a fault of the file");
            match e.place {
                Place::Line(_, line) => (kind, Some(line)),
                _ => (kind, None),
            }
        };
        assert_eq!(
            fault("# cycle\ntime_s,force_n\n0,1\n1,nan\n2,3\n3,3\n"),
            (ReadError::CycleValue, Some(4))
        );
        let (time, after) = (1.0, 2.0);
        assert_eq!(
            fault("# cycle\ntime_s,force_n\n0,1\n2,2\n1,3\n3,3\n"),
            (ReadError::TimeBackwards { time, after }, Some(5))
        );
        assert!(matches!(
            fault("# cycle\ntime_s,height_m\n0,1\n2,2\n3,3\n").0,
            ReadError::CycleColumnMissing {
                column: CycleColumn::Force,
                ..
            }
        ));
        assert_eq!(
            fault("# critical points\ntime_s,force_n\n0,1\n2,2\n").0,
            ReadError::CyclePeriodMissing
        );
    }

    #[test]
    fn columns_without_names_are_given_by_number() {
        let row = |i| format!("{},7,{}\n", 0.05 * f64::from(i), 100 * i);
        let text: String = (0..20).map(row).collect();
        let open = |time: Option<&str>, force: &[&str]| {
            let options = ReadOptions {
                period_s: Some(1.0),
                time: time.map(str::to_string),
                force: force.iter().map(|f| f.to_string()).collect(),
                ..ReadOptions::default()
            };
            read(Path::new("m.csv"), text.as_bytes(), &options)
        };
        let curve = open(Some("1"), &["3"]).unwrap().unwrap();
        assert_eq!(curve.force_n[19], 1900.0);
        let fault = open(None, &[]).unwrap_err().fault().cloned();
        assert_eq!(fault, Some(ReadError::NamelessColumns));
    }

    #[test]
    fn files_without_the_mark_are_not_cycles() {
        assert_eq!(
            read(
                Path::new("a"),
                b"# cycles of a walk\ntime,fz\n0,1\n1,2\n",
                &ReadOptions::default()
            ),
            Ok(None)
        );
    }
}
