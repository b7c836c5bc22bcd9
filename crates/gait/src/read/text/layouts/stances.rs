//! Tables with one stance per row, as in the GaitRec and Gutenberg databases.
//!
//! A row contains identifiers, then the samples `F_V_RAW_1 … F_V_RAW_n`, then empty fields. There is no time column. The masses are in a
//! separate table of subjects.

use std::collections::HashMap;
use std::path::Path;

use crate::error::{Placed, ReadError, Result};
use crate::quantity::{hertz, seconds};
use crate::read::columns::{Role, foot, is_other, role, words};
use crate::read::keys;
use crate::read::number::{trim, value};
use crate::read::text::delimited::{Fields, Lines, TextFile, detect, plain, text};
use crate::read::text::header::Table;
use crate::recording::{
    Channel, ClockSource, ForceUnit, Format, MassSource, Note, Recording, Row, UnitSource,
};
use crate::statistics::mean;
use crate::units::G;

/// Minimum number of numbered columns of a table of stances.
const FEWEST_SAMPLES: usize = 40;

/// Usual sampling rates of force plates, Hz. The number of samples of a stance determines which rate is assumed.
const RATES: [f64; 6] = [50.0, 100.0, 250.0, 500.0, 1000.0, 2000.0];

/// Typical duration of a stance in level walking, s. The durations of measured stances are 0.43 to 0.81 s.
const USUAL_STANCE_S: f64 = 0.65;

/// Whether the names of the columns are numbered samples of a vertical force: the same words followed by 1, 2, 3 …
///
/// If there is a time column, the result is `false`, because the numbers then denote sensors and a row is one instant.
pub(super) fn are_in(names: &[String]) -> bool {
    names.len() > FEWEST_SAMPLES
        && numbered(names).is_some_and(|first| {
            let timed = names[..first].iter().any(|n| role(n) == Role::Time);
            let vertical = !is_other(&words(&names[first]));
            !timed && vertical && names.len() - first >= FEWEST_SAMPLES
        })
}

/// Index of the first of the consecutively numbered columns; `None` if the columns are not numbered.
fn numbered(names: &[String]) -> Option<usize> {
    let parts = |n: &str| {
        let digits = n.len() - n.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let (stem, number) = n.split_at(n.len() - digits);
        number.parse::<usize>().ok().map(|k| (stem.to_string(), k))
    };
    let (stem, count) = parts(names.last()?)?;
    let first = names.len().checked_sub(count)?;
    let runs = names[first..]
        .iter()
        .enumerate()
        .all(|(i, n)| parts(n) == Some((stem.clone(), i + 1)));
    runs.then_some(first)
}

/// Name of the table of subjects that belongs to a table of stances, for example `GRF_metadata.csv` for `GRF_F_V_RAW_left.csv`. `None` for
/// other names.
pub fn metadata_name(path: &Path) -> Option<std::path::PathBuf> {
    let name = path.file_name()?.to_str()?;
    let cut = name.find("_F_V_").or_else(|| name.find("_f_v_"))?;
    Some(path.with_file_name(format!("{}_metadata.csv", &name[..cut])))
}

/// Reads the stances of a table.
pub(super) fn read(file: &TextFile, table: &Table, head: &[String]) -> Result<Recording> {
    let (path, options) = (file.path, file.options);
    let (mut force, rows) = stances(file, table)?;
    if rows.is_empty() {
        return Err(ReadError::NoStanceRow.at_line(path, table.start.line));
    }
    let mut notes = vec![Note::StancePerRow { rows: rows.len() }];
    let (unit, unit_from) = scale(file, &mut force, &rows, &mut notes)?;
    let keys = keys::read(head, file.delimiters.comma);
    let (rate_hz, clock) = match (options.rate_hz, keys.rate_hz) {
        (Some(rate), _) => (rate, ClockSource::User),
        (None, Some(rate)) => (rate, ClockSource::Header),
        (None, None) => (likely_rate(&rows, &mut notes), ClockSource::GuessedRate),
    };
    let mean = mean_mass(&rows, &mut notes).map(|m| (m, MassSource::Subjects));
    let mass = options.mass_kg.map(|m| (m, MassSource::User)).or(mean);
    let name = path
        .file_stem()
        .and_then(|s| s.to_str())
        .unwrap_or("stances")
        .to_string();
    Ok(Recording {
        format: Format::StanceTable,
        insole: false,
        rate_hz,
        start_s: 0.0,
        clock,
        unit,
        unit_from,
        kind: options.kind,
        duration_s: (force.len() - 1) as f64 / rate_hz,
        mass_kg: mass.map(|m| m.0),
        mass_from: mass.map(|m| m.1),
        channels: vec![Channel {
            foot: foot(&words(&name)),
            name,
            force_n: force,
            rows,
            ..Channel::default()
        }],
        strikes: Vec::new(),
        heels: None,
        gaps_s: Vec::new(),
        notes,
    })
}

/// Mean mass of the subjects, kg. A note gives the number of stances without a mass.
fn mean_mass(rows: &[Row], notes: &mut Vec<Note>) -> Option<f64> {
    let masses: Vec<f64> = rows.iter().filter_map(|r| r.mass_kg).collect();
    if masses.len() < rows.len() {
        notes.push(Note::MassesMissing {
            known: masses.len(),
            rows: rows.len(),
        });
    }
    (!masses.is_empty()).then(|| mean(&masses))
}

/// Concatenated samples of all stances, and the range of samples of each stance.
fn stances(file: &TextFile, table: &Table) -> Result<(Vec<f64>, Vec<Row>)> {
    let (delimiters, options) = (file.delimiters, file.options);
    let first = numbered(&table.names).unwrap_or(0);
    let masses = options.metadata.as_deref().map(masses).unwrap_or_default();
    let mut force = Vec::with_capacity(file.bytes.len() / 4);
    let mut rows = Vec::new();
    for (at, line) in Lines::from(file.bytes, table.start) {
        let mut fields = Fields::new(line, delimiters);
        let subject = fields.next().map(|f| text(trim(f))).unwrap_or_default();
        let from = force.len();
        for f in fields.skip(first.saturating_sub(1)) {
            let x = value(f, delimiters.comma);
            if x.is_finite() {
                force.push(x);
            } else if trim(f).is_empty() {
                break;
            } else {
                let sample = force.len() - from + 1;
                let text = text(trim(f));
                return Err(ReadError::StanceSample { sample, text }.at_line(file.path, at.line));
            }
        }
        if force.len() > from {
            rows.push(Row {
                from,
                to: force.len(),
                mass_kg: options.mass_kg.or_else(|| masses.get(&subject).copied()),
            });
        }
    }
    force.shrink_to_fit();
    Ok((force, rows))
}

/// Converts samples to newtons, with positive values for load.
fn scale(
    file: &TextFile,
    force: &mut [f64],
    rows: &[Row],
    notes: &mut Vec<Note>,
) -> Result<(ForceUnit, UnitSource)> {
    let top = force
        .iter()
        .fold(0.0, |m: f64, x| if x.abs() > m.abs() { *x } else { m });
    let sign = if top < 0.0 { -1.0 } else { 1.0 };
    let unit = file.options.unit.unwrap_or(if top.abs() < 6.0 {
        ForceUnit::BodyWeight
    } else {
        ForceUnit::Newton
    });
    if file.options.unit.is_none() && unit == ForceUnit::BodyWeight {
        let peak = top.abs();
        notes.push(Note::UnitGuessed { peak, unit });
    }
    for (i, row) in rows.iter().enumerate() {
        let factor = unit.newtons(row.mass_kg).ok_or_else(|| {
            let (unit, row) = (unit.name(), i + 1);
            ReadError::RowMassMissing { unit, row }.in_file(file.path)
        })?;
        for x in &mut force[row.from..row.to] {
            *x *= sign * factor;
        }
    }
    let from = match file.options.unit {
        Some(_) => UnitSource::User,
        None => UnitSource::Guessed,
    };
    Ok((unit, from))
}

/// Sampling rate, Hz, from `RATES`, at which the duration of the median stance is nearest to `USUAL_STANCE_S`.
fn likely_rate(rows: &[Row], notes: &mut Vec<Note>) -> f64 {
    let mut lengths: Vec<usize> = rows.iter().map(|r| r.to - r.from).collect();
    lengths.sort_unstable();
    let samples = lengths[lengths.len() / 2];
    let middle = samples as f64;
    let off = |rate: &f64| libm::log(middle / rate / USUAL_STANCE_S).abs();
    let rate = RATES
        .into_iter()
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .unwrap_or(1000.0);
    if lengths.first() == lengths.last() {
        notes.push(Note::DurationsLost {
            samples,
            assumed: seconds(middle / rate),
        });
    } else {
        notes.push(Note::RateGuessed {
            rate: hertz(rate),
            stance: seconds(middle / rate),
        });
    }
    rate
}

/// Mass of each subject, kg, in a table of subjects. The key is the text of the first column.
fn masses(bytes: &[u8]) -> HashMap<String, f64> {
    let bytes = &*plain(bytes);
    let delimiters = detect(bytes);
    // The first column contains names. The header is therefore the first line and is not detected from the numbers below it.
    let mut lines = Lines::new(bytes);
    let header = lines.next().map_or(&b""[..], |(_, line)| line);
    let names = Fields::new(header, delimiters).map(|f| text(trim(f)).to_lowercase());
    let names: Vec<String> = names.collect();
    let find = |wanted: &[&str]| {
        let named = |n: &String| wanted.iter().any(|w| n.contains(w));
        names.iter().position(named)
    };
    let mass = find(&["body_mass", "mass"]);
    let weight = find(&["body_weight", "weight"]);
    let mut found = HashMap::new();
    for (_, line) in lines {
        let fields: Vec<&[u8]> = Fields::new(line, delimiters).take(256).collect();
        let at = |i: Option<usize>| {
            let x = value(fields.get(i?)?, delimiters.comma);
            x.is_finite().then_some(x)
        };
        // A column of weight may contain newtons or kilograms. Values above 200 are interpreted as newtons, because walkers of 200 N or 200
        // kg are rare.
        let weighed = at(weight).map(|w| if w > 200.0 { w / G } else { w });
        if let (Some(id), Some(kg)) = (fields.first(), at(mass).or(weighed))
            && (3.0..=400.0).contains(&kg)
        {
            found.insert(text(trim(id)), kg);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::{Foot, ReadOptions};

    #[test]
    fn rows_are_stances_with_the_mass_of_their_subject() {
        let names: Vec<String> = (1..=50).map(|i| format!("F_V_RAW_{i}")).collect();
        let stance = |n: usize| -> String { (1..=n).map(|i| format!(",{}", i * 10)).collect() };
        let t = format!(
            "SUBJECT_ID,SESSION_ID,{}\nA,1{}{}\nB,1{}\n",
            names.join(","),
            stance(48),
            ",".repeat(2),
            stance(50)
        );
        let options = ReadOptions {
            metadata: Some(b"SUBJECT_ID,BODY_WEIGHT\nA,294.3\nB,60\n".to_vec()),
            ..ReadOptions::default()
        };
        let r = crate::read::text::read(Path::new("X_F_V_RAW_left.csv"), t.as_bytes(), &options)
            .unwrap();
        let c = &r.channels[0];
        assert_eq!(c.foot, Some(Foot::Left));
        let rows: Vec<_> = c
            .rows
            .iter()
            .map(|r| (r.to - r.from, r.mass_kg.unwrap().round()))
            .collect();
        assert_eq!(rows, [(48, 30.0), (50, 60.0)]);
    }

    #[test]
    fn the_table_of_subjects_is_known_by_name() {
        let name = metadata_name(Path::new("d/GRF_F_V_RAW_left.csv"));
        assert_eq!(name, Some(std::path::PathBuf::from("d/GRF_metadata.csv")));
        assert_eq!(metadata_name(Path::new("walk.csv")), None);
    }

    #[test]
    fn stances_in_body_weights_come_out_in_newtons_of_their_subjects() {
        let names: Vec<String> = (1..=50).map(|i| format!("F_V_PRO_{i}")).collect();
        let stance =
            |n: usize| -> String { (1..=n).map(|i| format!(",-{}", 0.02 * i as f64)).collect() };
        let table = format!(
            "SUBJECT_ID,SESSION_ID,{}\nA,1{}\nB,1{}\n",
            names.join(","),
            stance(50),
            stance(40)
        );
        let with = |subjects: &[u8]| {
            let options = ReadOptions {
                metadata: Some(subjects.to_vec()),
                unit: Some(ForceUnit::BodyWeight),
                ..ReadOptions::default()
            };
            crate::read::text::read(Path::new("X_F_V_PRO_right.csv"), table.as_bytes(), &options)
        };
        let all = with(b"SUBJECT_ID,BODY_MASS\nA,30\nB,60\n").unwrap();
        let force = &all.channels[0].force_n;
        for (sample, newtons) in [(49, 30.0 * G), (89, 0.8 * 60.0 * G)] {
            assert!((force[sample] - newtons).abs() < 1e-9, "{}", force[sample]);
        }
        let missing = |r: &Recording| {
            let is = |n: &Note| matches!(n, Note::MassesMissing { .. });
            r.notes.iter().any(is)
        };
        assert!(all.mass_kg == Some(45.0) && !missing(&all));
        assert!(with(b"SUBJECT_ID,BODY_MASS\nA,30\n").is_err());
    }
}
