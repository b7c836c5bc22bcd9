//! Output for several recordings: a table of all recordings, and their joint mean.

use super::places::Places;
use super::{Read, held_against, of_files, together, write_cycle, write_picture};
use crate::console::exit_code::{BAD_INPUT, BUILT};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use gaitcam::error::{ForceError, Result};
use gaitcam::force::{JointMean, LeftOut, OpenQuestion, Trial, joint_mean};
use gaitcam_output::gait::{TrialRow, trials_json, trials_table};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

use gaitcam_output as output;

/// Prints the table of the recordings with their joint mean, and writes the requested cycles. `is_named` returns whether the user named a
/// recording. Recordings that were found in a folder are skipped if they contain no cycle.
pub fn describe(
    reads: Vec<Read>,
    places: &Places,
    accept: &[OpenQuestion],
    as_json: bool,
    is_named: &dyn Fn(&Read) -> bool,
    against: Option<&Path>,
) -> Result<u8> {
    let against = against
        .map(|folder| held_against(folder, &reads))
        .transpose()?;
    let open: Vec<Vec<OpenQuestion>> = reads.iter().map(|r| open(r, accept)).collect();
    let trials: Vec<Trial> = reads
        .iter()
        .zip(&open)
        .filter_map(|(read, open)| Some((read.cycle.as_ref()?, open)))
        .map(|(cycle, open)| Trial { cycle, open })
        .collect();
    let joint = if trials.is_empty() {
        let trials = reads.len();
        Err(ForceError::NoJointMean { trials }.into())
    } else {
        joint_mean(&trials)
    };
    let left_out = reasons(&reads, &joint, &open);
    let names = short_names(&reads);
    let rows: Vec<TrialRow> = reads
        .iter()
        .zip(&names)
        .zip(&left_out)
        .map(|((read, name), left_out)| TrialRow {
            name,
            understood: read.understood.as_ref(),
            curve: read.curve(),
            fault: read.fault.as_ref(),
            left_out: left_out.as_ref(),
        })
        .collect();
    let mean = joint.as_ref().ok();
    if as_json {
        let objects = reads.iter().map(object).collect();
        let mut object = trials_json(&rows, objects, mean);
        if let Some((_, value)) = against {
            object["against"] = value;
        }
        print_json(&object);
    } else {
        print(trials_table(&rows, mean, language::current()).trim_end());
        if let Some((text, _)) = against {
            print(&text);
        }
    }
    for (read, place) in reads.iter().zip(&places.each) {
        read.write(place)?;
    }
    if let (Some(mean), Some(place)) = (mean, &places.joint) {
        let used = names.iter().zip(&left_out).filter(|(_, out)| out.is_none());
        let used: Vec<&str> = used.map(|(name, _)| name.as_str()).collect();
        let from = of_files("gait-joint-mean-of", &used.join(", "));
        write_cycle(place, &mean.curve, None, &[&from])?;
        let picture = output::recording::joint_mean(mean, &used, language::current());
        write_picture(place, &picture)?;
    }
    let named = reads.iter().filter(|r| is_named(r));
    let faults = named.filter_map(|r| r.fault.as_ref());
    let mut code = BUILT;
    for fault in faults.chain(joint.as_ref().err()) {
        report(fault.sentence(language::current()));
        code = BAD_INPUT;
    }
    Ok(code)
}

/// JSON data of one recording, with the paths of its files.
fn object(read: &Read) -> Value {
    let mut object = read.object.clone();
    object["file"] = json!(read.shown());
    object
}

/// Names of the recordings: the paths of their files, relative to the common folder of all recordings.
fn short_names(reads: &[Read]) -> Vec<String> {
    let paths = reads.iter().flat_map(|read| &read.paths);
    let mut parents = paths.map(|path| path.parent().map(Path::to_path_buf));
    let mut shared: PathBuf = parents.next().flatten().unwrap_or_default();
    for parent in parents.map(Option::unwrap_or_default) {
        while !parent.starts_with(&shared) && shared.pop() {}
    }
    let short = |path: &Path| {
        let name = path.strip_prefix(&shared).unwrap_or(path);
        name.display().to_string()
    };
    let names = reads.iter().map(|read| together(&read.paths, short));
    names.collect()
}

/// Open questions about a recording that the user has not accepted on the command line.
fn open(read: &Read, accept: &[OpenQuestion]) -> Vec<OpenQuestion> {
    let doubts = read.understood.iter().flat_map(|u| u.doubts());
    doubts.filter(|d| !accept.contains(d)).collect()
}

/// Reason why each recording is excluded from the joint mean; `None` if it is included.
fn reasons(
    reads: &[Read],
    joint: &Result<JointMean>,
    open: &[Vec<OpenQuestion>],
) -> Vec<Option<LeftOut>> {
    let mut of_trials = joint.iter().flat_map(|j| j.left_out.clone());
    let of = |(read, open): (&Read, &Vec<OpenQuestion>)| {
        if read.given.is_some() {
            return Some(LeftOut::MeanAlready);
        }
        if read.cycle.is_none() {
            return Some(LeftOut::NoCycle);
        }
        let questions = open.clone();
        of_trials
            .next()
            .unwrap_or((!questions.is_empty()).then_some(LeftOut::Open { questions }))
    };
    reads.iter().zip(open).map(of).collect()
}
