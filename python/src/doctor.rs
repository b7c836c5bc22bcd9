//! Diagnosis of a scene or a recording.

use std::path::PathBuf;

use gaitcam::synth::sentences;
use gaitcam::wording::{Language, catalogue};
use gaitcam_app::doctor::{self as examine, Finding, Mark};
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::convert;
use crate::error::{self, Raise};
use crate::interrupt;
use crate::scene::Scene;

/// Checks a scene or a recording as ``gaitcam doctor`` does, and returns all errors.
///
/// Parameters
/// ----------
/// given : Scene or path
///     A scene, a scene file (``.toml``, ``.json``), the name of a built-in scene, or a recording.
/// time_limit : float
///     Time limit of the search for the design, s.
/// lang : str
///     Language of the sentences, "en" or "es".
///
/// Returns
/// -------
/// list of dict
///     Errors, notes, open questions and the verdict. Each is a dictionary with ``mark`` ("good", "doubtful" or "bad"),
///     ``code``, ``key`` (key of the scene or ``None``), ``sentence`` and ``help`` (text or ``None``). The list is empty for a
///     valid recording without notes.
///
/// Raises
/// ------
/// InputError
///     The file cannot be read, or a scene file is not TOML.
#[pyfunction]
#[pyo3(signature = (given, *, time_limit = 60.0, lang = "en"))]
pub fn doctor<'py>(
    py: Python<'py>,
    given: &Bound<'py, PyAny>,
    time_limit: f64,
    lang: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let language = crate::asked::language(py, lang)?;
    let own = given.cast::<Scene>().ok().map(|s| s.get().input.clone());
    let path: PathBuf = match own {
        Some(_) => PathBuf::new(),
        None => given.extract()?,
    };
    let found = interrupt::run(py, time_limit, |search| {
        let (table, files) = match own {
            Some(input) => (input.table, input.files),
            None if examine::is_recording(&path) => return examine::recording_file(&path),
            None => gaitcam_app::scene::named(&path)?,
        };
        let (mut findings, input) = examine::scene("", table, files)?;
        if let Some(input) = input {
            findings.push(examine::design(&input, search)?);
        }
        Ok(findings)
    });
    let found = found?.raise(py)?;
    let rows: Vec<Value> = found.iter().filter_map(|f| row(f, language)).collect();
    convert::json(py, &Value::from(rows))
}

/// Dictionary of a finding; `None` for a valid part. The verdict of a design is always included.
fn row(finding: &Finding, language: Language) -> Option<Value> {
    let words = catalogue(language);
    let mark = match finding.mark() {
        Mark::Good => "good",
        Mark::Doubtful => "doubtful",
        Mark::Bad => "bad",
    };
    let (code, key, sentence, help) = match finding {
        Finding::Fault(fault) | Finding::NoCycle(fault) => {
            let key = error::key(&fault.place);
            (
                fault.code(),
                key,
                fault.sentence(language),
                fault.help(language),
            )
        }
        Finding::Note(note) => {
            let code = note.code().to_string();
            (code, None, words.sentence("note", note), None)
        }
        Finding::Open(question) => {
            let code = question.name().to_string();
            (code, None, words.sentence("open", question), None)
        }
        Finding::Design(design) => {
            let code = design.verdict.name().to_string();
            (code, None, sentences(&design.reasons, language), None)
        }
        Finding::Good(..) => return None,
    };
    Some(json!({"mark": mark, "code": code, "key": key, "sentence": sentence, "help": help}))
}
