//! Texts with the force on one plate of a trial. Qualisys writes one such file per plate.

use crate::error::Result;
use crate::read::columns::{foot, words};
use crate::read::text::delimited::{Lines, TextFile, plain, text};
use crate::read::text::samples::Samples;
use crate::recording::ForceUnit;

/// Properties of a file with one plate of a trial.
///
/// ```
/// use gaitcam_gait::plate_of;
///
/// let head = |plate: u8| {
///     format!("TIME_STAMP\t2015-10-06, 12:24:07\nFIRST_SAMPLE\t1\nFORCE_PLATE_NAME\tForce-plate {plate}\n")
/// };
/// let [one, two] = [1, 2].map(|k| plate_of(head(k).as_bytes()).unwrap());
/// assert!(one.trial == two.trial && one.plate != two.plate);
/// assert_eq!(plate_of(b"time,Fz\n0,700\n"), None);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlateFile {
    /// Data that all files of a trial share: time stamp, first sample, number of samples, rate.
    pub trial: Vec<String>,
    /// Name of the force plate.
    pub plate: String,
}

/// Keys whose values are equal in all files of a trial. The most distinctive key is the first.
const TRIAL: [&str; 4] = ["TIME_STAMP", "FIRST_SAMPLE", "NO_OF_SAMPLES", "FREQUENCY"];
const PLATE: &str = "FORCE_PLATE_NAME";
/// First key of the header of a plate file.
const FIRST: &[u8] = b"NO_OF_SAMPLES";
/// Maximum number of lines in the header of a plate file.
const HEAD: usize = 60;
/// Maximum number of bytes of the header of a plate file.
const HEAD_BYTES: usize = 1 << 14;

/// Properties of the plate file that begins with a given text; `None` for other texts.
pub fn plate_of(start: &[u8]) -> Option<PlateFile> {
    let bytes = plain(start);
    let lines = Lines::new(&bytes).take(HEAD).map(|(_, line)| text(line));
    of_head(&lines.collect::<Vec<_>>())
}

/// The files of all plates of one trial, concatenated for [`read`](crate::read()). `None` if the files do not belong to different plates of
/// one trial.
pub fn joined_plates(files: &[Vec<u8>]) -> Option<Vec<u8>> {
    let plates: Vec<PlateFile> = files.iter().map(|f| plate_of(f)).collect::<Option<_>>()?;
    let fits = |(i, plate): (usize, &PlateFile)| {
        plate.trial == plates[0].trial && plates[..i].iter().all(|p| p.plate != plate.plate)
    };
    let is_trial = plates.iter().enumerate().all(fits);
    let joined = files.join(&b'\n');
    (is_trial && parts(&joined).len() == files.len()).then_some(joined)
}

/// Parts of a concatenated text, one per plate. A text with a single plate is one part.
pub fn parts(bytes: &[u8]) -> Vec<&[u8]> {
    if plate_of(&bytes[..bytes.len().min(HEAD_BYTES)]).is_none() {
        return vec![bytes];
    }
    let lines = (bytes.iter().enumerate()).filter_map(|(i, b)| (*b == b'\n').then_some(i + 1));
    let begins = |i: &usize| bytes[*i..].starts_with(FIRST);
    let mut starts: Vec<usize> = [0].into_iter().chain(lines).filter(begins).collect();
    if starts.len() < 2 {
        return vec![bytes];
    }
    starts[0] = 0;
    let ends = starts[1..].iter().copied().chain([bytes.len()]);
    (starts.iter().zip(ends))
        .map(|(from, to)| &bytes[*from..to])
        .collect()
}

/// Adds the plate, the foot and the unit to all columns. The header contains no unit, and the forces are in newtons.
pub(super) fn complete(_: &TextFile, head: &[String], samples: &mut Samples) -> Result<()> {
    let plate = of_head(head).map(|file| file.plate);
    for force in &mut samples.forces {
        force.unit = force.unit.or(Some(ForceUnit::Newton));
        if let Some(plate) = &plate {
            force.foot = force.foot.or(foot(&words(plate)));
            force.name = format!("{plate} {}", force.name);
        }
    }
    Ok(())
}

/// Properties of the plate file with a given header; `None` if the header contains no time stamp or no name of a plate.
fn of_head(head: &[String]) -> Option<PlateFile> {
    let value = |key: &str| {
        let found = head.iter().find_map(|line| {
            let rest = line.trim().strip_prefix(key)?;
            rest.starts_with(['\t', ' ', ',', ';']).then_some(rest)
        })?;
        let value = found.trim_matches(['\t', ' ', ',', ';']);
        (!value.is_empty()).then(|| value.to_string())
    };
    value(TRIAL[0])?;
    Some(PlateFile {
        trial: TRIAL.map(|key| value(key).unwrap_or_default()).to_vec(),
        plate: value(PLATE)?,
    })
}
