//! Rows of `[gait]`: the force that is wanted.

use std::path::PathBuf;

use super::kind::{Idle, Kind, Measure, Range};
use super::row::{Access, Key, entry, number, other, plain};
use super::value::Value;
use crate::force::{Feet, Kind as Movement, OpenQuestion};
use crate::scene::{Band, ForceScale, Gait, Phase, PhaseWeight, Scene, Source};
use crate::units::Dimension as D;

/// Largest weight of a phase: beyond it the mean square loses the other phases' digits.
const LARGEST_WEIGHT: f64 = 1e6;

fn gait(scene: &mut Scene) -> &mut Gait {
    scene.gait.get_or_insert_with(Gait::default)
}

/// Keys of load models change nothing over a recording.
fn of_models(scene: &Scene) -> Option<Idle> {
    let recording = scene.gait.as_ref().is_some_and(Gait::is_recording);
    recording.then_some(Idle::Recording)
}

/// Keys of recordings change nothing over a load model.
fn of_recordings(scene: &Scene) -> Option<Idle> {
    let model = scene.gait.as_ref().is_some_and(|g| !g.is_recording());
    model.then_some(Idle::Model)
}

/// Access to an optional number of the gait.
macro_rules! gait_number {
    ($field:ident) => {
        Access {
            get: |s, _| s.gait.as_ref()?.$field.map(Value::Number),
            set: |s, _, v| {
                gait(s).$field = v.number();
                Ok(())
            },
        }
    };
}

/// Access to an optional text of the gait.
macro_rules! gait_text {
    ($field:ident) => {
        Access {
            get: |s, _| s.gait.as_ref()?.$field.clone().map(Value::Text),
            set: |s, _, v| {
                gait(s).$field = Some(v.text());
                Ok(())
            },
        }
    };
}

/// Access to a number of one weighted phase.
macro_rules! weight {
    ($field:ident) => {
        Access {
            get: |s, i| {
                let weight: &PhaseWeight = s.gait.as_ref()?.weights.get(i)?;
                Some(Value::Number(weight.$field))
            },
            set: |s, i, v| {
                entry(&mut gait(s).weights, i).$field = v.number().unwrap_or(0.0);
                Ok(())
            },
        }
    };
}

pub static ROWS: &[Key] = &[
    other(
        "gait.file",
        Kind::Text,
        Access {
            get: |s, _| match &s.gait.as_ref()?.source {
                Source::File(path) => Some(Value::Text(path.to_string_lossy().into_owned())),
                Source::Model(_) => None,
            },
            set: |s, _, v| {
                gait(s).source = Source::File(PathBuf::from(v.text()));
                Ok(())
            },
        },
    ),
    other(
        "gait.model",
        Kind::Text,
        Access {
            get: |s, _| match &s.gait.as_ref()?.source {
                Source::Model(name) => Some(Value::Text(name.clone())),
                Source::File(_) => None,
            },
            set: |s, _, v| {
                gait(s).source = Source::Model(v.text());
                Ok(())
            },
        },
    ),
    plain(
        "gait.step_frequency",
        D::Frequency,
        Range::Positive,
        gait_number!(step_frequency),
    )
    .idle_when(of_models),
    plain(
        "gait.body_weight",
        D::Force,
        Range::Positive,
        gait_number!(body_weight),
    )
    .idle_when(of_models),
    other("gait.time", Kind::Text, gait_text!(time)).idle_when(of_recordings),
    other(
        "gait.force",
        Kind::Texts,
        Access {
            get: |s, _| {
                let force = &s.gait.as_ref()?.force;
                (!force.is_empty()).then(|| Value::Texts(force.clone()))
            },
            set: |s, _, v| {
                if let Value::Texts(list) = v {
                    gait(s).force = list;
                }
                Ok(())
            },
        },
    )
    .idle_when(of_recordings),
    other("gait.unit", Kind::Text, gait_text!(unit)).idle_when(of_recordings),
    plain(
        "gait.rate",
        D::Frequency,
        Range::Positive,
        gait_number!(rate),
    )
    .idle_when(of_recordings),
    plain("gait.mass", D::Mass, Range::Positive, gait_number!(mass)).idle_when(of_recordings),
    plain(
        "gait.period",
        D::Time,
        Range::Positive,
        gait_number!(period),
    )
    .idle_when(of_recordings),
    plain(
        "gait.span",
        D::Angle,
        Range::Between(0.0, std::f64::consts::TAU),
        gait_number!(span),
    )
    .idle_when(of_recordings),
    other(
        "gait.kind",
        Kind::Choice(|| Movement::ALL.map(Movement::name).to_vec()),
        Access {
            get: |s, _| Some(Value::Text(s.gait.as_ref()?.kind?.name().to_string())),
            set: |s, _, v| {
                gait(s).kind = Some(v.text().parse()?);
                Ok(())
            },
        },
    )
    .idle_when(of_recordings),
    other(
        "gait.accept",
        Kind::Text,
        Access {
            get: |s, _| {
                let accept = &s.gait.as_ref()?.accept;
                let names: Vec<&str> = accept.iter().map(|d| d.name()).collect();
                (!names.is_empty()).then(|| Value::Text(names.join(", ")))
            },
            set: |s, _, v| {
                gait(s).accept = OpenQuestion::list(&v.text())?;
                Ok(())
            },
        },
    )
    .idle_when(of_recordings),
    other(
        "gait.feet",
        Kind::Choice(|| Feet::ALL.map(Feet::name).to_vec()),
        Access {
            get: |s, _| Some(Value::Text(s.gait.as_ref()?.feet.name().to_string())),
            set: |s, _, v| {
                gait(s).feet = v.text().parse()?;
                Ok(())
            },
        },
    )
    .default("both"),
    other(
        "gait.scale",
        Kind::Choice(|| ForceScale::ALL.map(ForceScale::name).to_vec()),
        Access {
            get: |s, _| Some(Value::Text(s.gait.as_ref()?.scale.name().to_string())),
            set: |s, _, v| {
                let word = v.text();
                let known = ForceScale::ALL.into_iter().find(|k| k.name() == word);
                gait(s).scale = known.unwrap_or_default();
                Ok(())
            },
        },
    )
    .default("none"),
    super::row::key(
        "gait.band",
        Kind::NumberOr(Measure::same(D::Force), "spread"),
        Range::Positive,
        Access {
            get: |s, _| {
                Some(match s.gait.as_ref()?.band? {
                    Band::Spread => Value::Text("spread".to_string()),
                    Band::Width(newtons) => Value::Number(newtons),
                })
            },
            set: |s, _, v| {
                gait(s).band = Some(v.number().map_or(Band::Spread, Band::Width));
                Ok(())
            },
        },
    ),
    super::row::key(
        "gait.phase",
        Kind::NumberOr(Measure::same(D::Angle), "free"),
        Range::Any,
        Access {
            get: |s, _| {
                Some(match s.gait.as_ref()?.phase {
                    Phase::Free => Value::Text("free".to_string()),
                    Phase::At(angle) => Value::Number(angle),
                })
            },
            set: |s, _, v| {
                gait(s).phase = v.number().map_or(Phase::Free, Phase::At);
                Ok(())
            },
        },
    )
    .default("0 deg"),
    number(
        "gait.weight.N.from",
        Measure::same(D::Angle),
        Range::Any,
        weight!(from),
    )
    .default("")
    .required(),
    number(
        "gait.weight.N.to",
        Measure::same(D::Angle),
        Range::Any,
        weight!(to),
    )
    .default("")
    .required(),
    number(
        "gait.weight.N.weight",
        Measure::same(D::Ratio),
        Range::Between(0.0, LARGEST_WEIGHT),
        weight!(weight),
    )
    .default("")
    .required(),
];
