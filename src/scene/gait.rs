//! `[gait]`: the force that is wanted.

use std::path::PathBuf;

use super::table::Reader;
use super::{Band, Gait, Phase, PhaseWeight, Source};
use crate::error::{Error, Result};
use crate::force::Feet;
use crate::units::Dimension;

/// Weight of the walker that the load models were published for, N.
const MODEL_WEIGHT: f64 = 700.0;
/// Largest weight of a phase: beyond it the mean square loses the other phases' digits.
const LARGEST_WEIGHT: f64 = 1e6;

pub fn read(mut r: Reader) -> Result<Gait> {
    let file = r.text("file")?;
    let model = r.text("model")?;
    let feet = r.text("feet")?;
    let key = r.name("feet");
    let feet: Feet = feet
        .unwrap_or("both")
        .parse()
        .map_err(|e: Error| e.at(crate::error::Place::Key(key)))?;
    let to_mass = r
        .choice("scale", &[("none", false), ("to-mass", true)])?
        .unwrap_or(false);
    let step_frequency_hz = r.positive("step_frequency", Dimension::Frequency)?;
    let body_weight_n = r.positive("body_weight", Dimension::Force)?;
    let time = r.text("time")?.map(str::to_string);
    let force = r.texts("force")?;
    let unit = r.text("unit")?.map(str::to_string);
    let rate_hz = r.positive("rate", Dimension::Frequency)?;
    let mass_kg = r.positive("mass", Dimension::Mass)?;
    let source = match (file, model) {
        (Some(path), None) => Source::File {
            path: PathBuf::from(path),
            time,
            force,
            unit,
            rate_hz,
            mass_kg,
        },
        (None, Some(name)) => Source::Model {
            name: name.to_string(),
            step_frequency_hz,
            body_weight_n: body_weight_n.unwrap_or(MODEL_WEIGHT),
        },
        (Some(_), Some(_)) => {
            return Err(Error::key("gait", "says both file and model")
                .help("keep one: file = \"walk.mot\" or model = \"young\""));
        }
        (None, None) => {
            return Err(Error::key("gait.file", "no recording and no model is named").help(
                "give --set gait.file=walk.mot, or write file = \"walk.mot\" or model = \"young\"; \
                 leave [gait] out for a classical programme",
            ));
        }
    };
    let band = match r.text("band")? {
        Some("spread") => Some(Band::Spread),
        Some(_) => r.positive("band", Dimension::Force)?.map(Band::Width),
        None => None,
    };
    let phase = match r.text("phase")? {
        Some("free") => Phase::Free,
        _ => Phase::At(r.quantity("phase", Dimension::Angle)?.unwrap_or(0.0)),
    };
    let weights = weights(&mut r)?;
    r.finish()?;
    Ok(Gait {
        source,
        feet,
        to_mass,
        band,
        weights,
        phase,
    })
}

fn weights(r: &mut Reader) -> Result<Vec<PhaseWeight>> {
    let mut out = Vec::new();
    for mut w in r.tables("weight")? {
        let missing = |key: String| {
            Error::key(&key, "a weight needs it")
                .help("write from = \"0 deg\", to = \"60 deg\", weight = 4")
        };
        let (from_key, to_key, weight_key) = (w.name("from"), w.name("to"), w.name("weight"));
        let one = PhaseWeight {
            from: w
                .quantity("from", Dimension::Angle)?
                .ok_or_else(|| missing(from_key.clone()))?,
            to: w
                .quantity("to", Dimension::Angle)?
                .ok_or_else(|| missing(to_key))?,
            weight: w
                .not_negative("weight", Dimension::Ratio)?
                .ok_or_else(|| missing(weight_key.clone()))?,
        };
        if one.weight > LARGEST_WEIGHT {
            return Err(Error::key(
                &weight_key,
                format!("{} drowns the rest of the cycle", one.weight),
            )
            .help("weights from 0 to 1000000; 1 is what all else has"));
        }
        let inside = |x: f64| (-1e-9..=std::f64::consts::TAU + 1e-9).contains(&x);
        if !inside(one.from) || !inside(one.to) || one.from == one.to {
            return Err(Error::key(
                &from_key,
                format!(
                    "{:.3}° to {:.3}° is no range of one cycle",
                    one.from.to_degrees(),
                    one.to.to_degrees()
                ),
            )
            .help("phases run from 0 to 360 deg; a range over the end has to < from"));
        }
        out.push(one);
        w.finish()?;
    }
    let turn = std::f64::consts::TAU;
    let covered: f64 = (out.iter())
        .map(|w: &PhaseWeight| (w.to - w.from).rem_euclid(turn))
        .map(|length| if length < 1e-9 { turn } else { length })
        .sum();
    if covered >= turn - 1e-9 && out.iter().all(|w| w.weight == 0.0) {
        return Err(
            Error::key(&r.name("weight"), "no phase of the cycle counts")
                .help("give one range a weight above 0"),
        );
    }
    Ok(out)
}
