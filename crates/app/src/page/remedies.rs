//! Corrections for an error or an open question: the keys to be changed, with a value if the error contains one.

use serde::Serialize;

use gaitcam::error::{DynamicsError, Error, ForceError, Place, ReadError, SceneError};
use gaitcam::scene::{Scene, keys};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

/// Maximum number of columns that are suggested as force columns.
const MOST: usize = 12;

/// Suggested change of a key, or a key that needs a value from the user.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Remedy {
    /// Dotted key of the scene that the correction changes.
    pub key: String,
    /// Suggested value as written in a scene file; `None` if the user has to enter the value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
}

fn to(key: &str, value: &str) -> Remedy {
    let (key, value) = (key.to_string(), Some(value.to_string()));
    Remedy { key, value }
}

fn give(key: &str) -> Remedy {
    let (key, value) = (key.to_string(), None);
    Remedy { key, value }
}

fn gives(keys: &[&str]) -> Vec<Remedy> {
    keys.iter().map(|key| give(key)).collect()
}

fn columns(all: &[String]) -> Vec<Remedy> {
    let offered = all.iter().filter(|c| !c.trim().is_empty()).take(MOST);
    offered.map(|column| to("gait.force", column)).collect()
}

/// Corrections for an error, sorted by decreasing likelihood. The list is empty if no correction is known.
pub fn of(error: &Error) -> Vec<Remedy> {
    if let Some(fault) = error.fault() {
        return of_reading(fault);
    }
    if let Some(fault) = error.fault() {
        return of_force(fault);
    }
    let key = match &error.place {
        Place::Key(key) => key.as_str(),
        _ => "",
    };
    if let Some(fault) = error.fault() {
        return of_scene(fault, key);
    }
    match error.fault() {
        Some(DynamicsError::Stalls { needed, .. }) => written("machine.inertia", needed),
        Some(DynamicsError::NoLoadSpeed { needed, .. }) => {
            written("machine.motor.no_load_speed", needed)
        }
        Some(DynamicsError::NoTrain) => gives(&["machine.natural_frequency", "machine.stiffness"]),
        Some(DynamicsError::FrequencyWithoutMass { fluid: true }) => gives(&["machine.stiffness"]),
        _ => Vec::new(),
    }
}

/// Correction that sets a key to the quantity `needed`.
fn written(path: &str, needed: &Quantity) -> Vec<Remedy> {
    let dimension = keys::find(path).and_then(|key| key.dimension(&Scene::default()));
    let value = keys::Value::Number(needed.value).to_toml(dimension);
    vec![to(path, value.as_str().unwrap_or_default())]
}

fn of_reading(fault: &ReadError) -> Vec<Remedy> {
    use ReadError as R;
    match fault {
        R::NoForceColumn { columns: all } | R::LongForces { columns: all } => columns(all),
        R::CycleForces { columns: all } => columns(all),
        R::MatWithoutForce { arrays } => columns(arrays),
        R::MisspeltColumn { near, .. } => vec![to("gait.force", near), give("gait.time")],
        R::NoColumn { columns: all, .. } => {
            let mut out = columns(all);
            out.push(give("gait.time"));
            out
        }
        R::RateNotPositive { .. } | R::NoFrameRate => gives(&["gait.rate"]),
        R::MassNotPositive { .. } | R::MassMissing { .. } | R::RowMassMissing { .. } => {
            gives(&["gait.mass"])
        }
        R::ManyForces { .. } | R::NoChannel { .. } | R::NoPlate { .. } => gives(&["gait.force"]),
        R::PlateUncalibrated { .. } | R::PlateTypeUnknown { .. } => gives(&["gait.force"]),
        R::NamelessColumns | R::NoColumnNumber { .. } | R::ForceIsTime => {
            gives(&["gait.force", "gait.time"])
        }
        R::LongTable { .. } => gives(&["gait.period", "gait.mass"]),
        R::NoForceUnit { .. } => gives(&["gait.unit"]),
        R::NoRate | R::TimeStandsStill { .. } => gives(&["gait.time", "gait.rate"]),
        R::CountsWithoutMass => gives(&["gait.mass", "gait.unit"]),
        R::PhaseWithoutPeriod { .. } | R::CyclePeriodMissing | R::CycleTooLong { .. } => {
            gives(&["gait.period"])
        }
        R::PhaseOfStance { .. } | R::CycleInC3d => gives(&["gait.period", "gait.span"]),
        _ => Vec::new(),
    }
}

fn of_force(fault: &ForceError) -> Vec<Remedy> {
    use ForceError as F;
    match fault {
        F::Running { .. } => vec![to("gait.kind", "running")],
        F::NotWalking { .. } => vec![to("gait.kind", "walking"), give("gait.period")],
        F::TotalOfBothFeet { .. } | F::BothFeetOnly { .. } => vec![to("gait.feet", "both")],
        F::NoStanceOfFoot { .. } | F::FeetNotNamed { .. } => {
            vec![to("gait.feet", "one"), to("gait.feet", "both")]
        }
        F::FrequencyMissing { .. } => vec![to("gait.step_frequency", "1.85 Hz")],
        F::FrequencyOutOfRange { .. } => gives(&["gait.step_frequency"]),
        F::MisspeltModel { near, .. } => vec![to("gait.model", near)],
        F::UnknownModel { .. } => gives(&["gait.model"]),
        F::UnknownUnit { .. } => gives(&["gait.unit"]),
        F::UnknownKind { .. } => gives(&["gait.kind"]),
        F::UnknownFeet { .. } => gives(&["gait.feet"]),
        F::UnknownDoubt { .. } => gives(&["gait.accept"]),
        F::ClockImplausible { .. } => gives(&["gait.rate"]),
        F::ForceTooLow { .. } => gives(&["gait.unit", "gait.mass"]),
        F::NoLiveChannel { .. } => gives(&["gait.force"]),
        F::NoContact { .. } => gives(&["gait.unit", "gait.force"]),
        F::NoStance { .. } | F::NoStanceFileCut { .. } => gives(&["gait.force", "gait.unit"]),
        _ => Vec::new(),
    }
}

/// Value in an example such as `mass = "70 kg"` or `70 kg`.
fn example(text: &str) -> Option<&str> {
    match text.split('"').nth(1) {
        Some(quoted) => Some(quoted),
        None => (!text.contains('=')).then_some(text),
    }
}

fn of_scene(fault: &SceneError, key: &str) -> Vec<Remedy> {
    use SceneError as S;
    match fault {
        S::NoSpeed => vec![to(key, "60 rpm")],
        S::NoMass => vec![to(key, "70 kg")],
        S::NeededByFollower { example: text, .. }
        | S::NeededByDrive { example: text, .. }
        | S::NeededInEntry { example: text }
        | S::FloorLacks { example: text } => example(text)
            .map(|value| to(key, value))
            .into_iter()
            .collect(),
        S::MotorLine => vec![to("machine.motor.slope", "10 N m s/rad")],
        S::MotorWithoutInertia => vec![to("machine.inertia", "0.5 kg m^2")],
        S::NoLoadWithoutStall => gives(&["machine.motor.stall_torque"]),
        S::ResidualWithoutFrequency => vec![to("machine.natural_frequency", "60 Hz")],
        S::PolydyneWithoutStiffness => {
            vec![
                to("machine.natural_frequency", "60 Hz"),
                to("machine.stiffness", "9 kN/m"),
            ]
        }
        S::KeywayWithoutBore => vec![to("cam.bore", "20 mm")],
        S::OnlySplines { .. } | S::PolydyneFamily { .. } => vec![to("law.family", "spline")],
        S::ArmOnMovingAxis => vec![to("drive.kind", "fixed-axis")],
        S::NoForceNamed | S::NoForceToFollow => vec![to("gait.model", "young"), give("gait.file")],
        S::UnknownWord {
            nearest: Some(word),
            ..
        } => vec![to(key, word)],
        _ => Vec::new(),
    }
    .into_iter()
    .filter(|remedy| keys::find(&remedy.key).is_some())
    .collect()
}

/// Suggested changes of keys that resolve the open questions about the recording of a design. The first changes accept the assumptions. The
/// other changes set the keys that answer the questions.
pub fn of_open_questions(design: &Design) -> Vec<Remedy> {
    let mut out: Vec<Remedy> = Vec::new();
    let accepted: Vec<&str> = (design.problem.open_questions.iter())
        .filter(|(question, _)| question.is_acceptable())
        .map(|(question, _)| question.name())
        .collect();
    out.extend(accepted.iter().map(|name| to("gait.accept", name)));
    let notes = design
        .problem
        .open_questions
        .iter()
        .flat_map(|(_, notes)| notes);
    for key in notes.flat_map(|note| note.settled_by()) {
        let remedy = give(key);
        if !out.contains(&remedy) {
            out.push(remedy);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::error::Placed;

    #[test]
    fn a_fault_offers_the_value_that_it_names() {
        let offered = |error: Error| of(&error);
        let running = ForceError::Running {
            duration: gaitcam::units::Quantity::time(2.0),
        };
        assert_eq!(offered(running.into()), [to("gait.kind", "running")]);
        let columns = vec!["x".to_string(), "y".to_string()];
        let none = ReadError::NoForceColumn { columns };
        assert_eq!(
            offered(none.into()),
            [to("gait.force", "x"), to("gait.force", "y")]
        );
        let mass = SceneError::NoMass.at_key("drive.mass");
        assert_eq!(offered(mass), [to("drive.mass", "70 kg")]);
    }

    #[test]
    fn every_remedy_has_a_key_of_the_scene() {
        let faults: [Error; 4] = [
            ReadError::NoRate.into(),
            ReadError::NamelessColumns.into(),
            SceneError::MotorWithoutInertia.at_key("machine.inertia"),
            SceneError::PolydyneWithoutStiffness.at_key("law.polydyne"),
        ];
        for remedy in faults.iter().flat_map(of) {
            assert!(keys::find(&remedy.key).is_some(), "{remedy:?}");
        }
    }
}
