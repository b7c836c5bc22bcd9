//! Access to keys that do not correspond to a single field of the scene.

use std::path::PathBuf;

use super::field::{Access, Field};
use super::value::{Value, written};
use crate::cam::{StatedMaterial, Stock};
use crate::scene::{Harmonic, LimitKind, Limits, Source};
use crate::units::Dimension;
use crate::wording::called_in_spanish;

/// Word that switches off a default bound.
pub(super) const NONE: &str = "none";

/// Access to `gait.file`. Setting a recording replaces a load model.
pub(super) const FILE: Access = Access {
    get: |s, _| {
        let gait = s.gait.as_ref()?;
        let path = match &gait.source {
            Source::File(path) => path,
            Source::Model(_) | Source::Harmonics(_) => return None,
        };
        let all = std::iter::once(path).chain(&gait.more_files);
        let texts = all.map(|path| path.to_string_lossy().into_owned());
        Some(Value::Texts(texts.collect()))
    },
    set: |s, _, v| {
        let gait = s.gait.get_or_insert_default();
        let texts = match v {
            Value::Text(one) => vec![one],
            several => several.texts(),
        };
        let mut paths = texts.into_iter().map(PathBuf::from);
        gait.source = Source::File(paths.next().unwrap_or_default());
        gait.more_files = paths.collect();
        Ok(())
    },
};

/// Access to `gait.step_frequency`, which is one frequency or the frequencies of several walkers.
pub(super) const STEP_FREQUENCY: Access = Access {
    get: |s, _| {
        let gait = s.gait.as_ref()?;
        match gait.step_frequencies {
            Some(several) => Some(Value::Text(several.to_string())),
            None => gait.step_frequency.map(Value::Number),
        }
    },
    set: |s, _, v| {
        let gait = s.gait.get_or_insert_default();
        (gait.step_frequency, gait.step_frequencies) = match v {
            Value::Text(text) => (None, Some(text.parse()?)),
            one => (one.number(), None),
        };
        Ok(())
    },
};

/// Access to `gait.model`. Setting a load model replaces a recording.
pub(super) const MODEL: Access = Access {
    get: |s, _| match &s.gait.as_ref()?.source {
        Source::Model(name) => Some(Value::Text(name.clone())),
        Source::File(_) | Source::Harmonics(_) => None,
    },
    set: |s, _, v| {
        s.gait.get_or_insert_default().source = Source::Model(v.text());
        Ok(())
    },
};

/// Access to `gait.harmonics`. Setting load factors replaces a recording or a load model.
pub(super) const HARMONICS: Access = Access {
    get: |s, _| match &s.gait.as_ref()?.source {
        Source::Harmonics(list) => Some(Value::Texts(list.iter().map(written_harmonic).collect())),
        Source::File(_) | Source::Model(_) => None,
    },
    set: |s, _, v| {
        let list = Harmonic::list(&v.texts())?;
        s.gait.get_or_insert_default().source = Source::Harmonics(list);
        Ok(())
    },
};

/// Access to `machine.learned_force`: mean and harmonics of a force, N.
pub(super) const LEARNED_FORCE: Access = Access {
    get: |s, _| {
        let list = &s.machine.learned_force;
        let written = |h: &Harmonic| match h.phase {
            0.0 => format!("{} N", h.factor),
            phase => format!("{} N at {}", h.factor, written(phase, Dimension::Angle)),
        };
        (!list.is_empty()).then(|| Value::Texts(list.iter().map(written).collect()))
    },
    set: |s, _, v| {
        s.machine.learned_force = Harmonic::forces(&v.texts())?;
        Ok(())
    },
};

fn written_harmonic(harmonic: &Harmonic) -> String {
    match harmonic.phase {
        0.0 => harmonic.factor.to_string(),
        phase => format!(
            "{} at {}",
            harmonic.factor,
            written(phase, Dimension::Angle)
        ),
    }
}

/// Access to `cam.offset`. The default is 0. With "auto", the design determines the offset.
pub(super) const OFFSET: Access = Access {
    get: |s, _| {
        let offset = s.cam.offset.map(Value::Number);
        offset.or_else(|| Some(Value::Text("auto".to_string())))
    },
    set: |s, _, v| {
        s.cam.offset = v.number();
        Ok(())
    },
};

/// Access to `cam.material`. The text is a known material, in English or Spanish, or a designation of a steel. An empty text means that no material
/// is given.
pub(super) const MATERIAL: Access = Access {
    get: |s, _| s.cam.making.material.clone().map(Value::Text),
    set: |s, _, v| {
        let typed = v.text();
        let names: Vec<&'static str> = Stock::ALL.iter().map(|stock| stock.name()).collect();
        let spanish = || called_in_spanish(&typed, &names).and_then(Stock::named);
        s.cam.making.stated = StatedMaterial {
            stock: Stock::named(&typed).or_else(spanish),
            ..StatedMaterial::default()
        };
        s.cam.making.material = Some(typed).filter(|text| !text.trim().is_empty());
        Ok(())
    },
};

/// Access to `cam.follower_material`. Setting a known material removes constants given earlier.
pub(super) const FOLLOWER_MATERIAL: Access = Access {
    get: |s, _| s.cam.follower_material.stock.value(),
    set: |s, _, v| {
        s.cam.follower_material = StatedMaterial::default();
        s.cam.follower_material.stock.assign(v)
    },
};

/// Access to one material constant of the cam or the follower. Setting a constant removes the name of the material.
macro_rules! constant {
    (material . $field:ident) => {
        Access {
            get: |s, _| s.cam.making.stated.$field.value(),
            set: |s, _, v| {
                s.cam.making.material = None;
                s.cam.making.stated.stock = None;
                s.cam.making.stated.$field.assign(v)
            },
        }
    };
    (follower_material . $field:ident) => {
        Access {
            get: |s, _| s.cam.follower_material.$field.value(),
            set: |s, _, v| {
                s.cam.follower_material.stock = None;
                s.cam.follower_material.$field.assign(v)
            },
        }
    };
}

/// Access to `limits.force_min`. The word "none" also switches off the default bound.
pub(super) const FORCE_MIN: Access = Access {
    get: |s, _| {
        bound(
            s.limits.unjudged.contact_force,
            s.limits[LimitKind::ForceMin],
        )
    },
    set: |s, _, v| {
        s.limits.unjudged.contact_force = is_none(&v);
        s.limits[LimitKind::ForceMin] = v.number();
        Ok(())
    },
};

/// Access to `limits.hertz_pressure`. The word "none" also switches off the default bound.
pub(super) const HERTZ_PRESSURE: Access = Access {
    get: |s, _| {
        bound(
            s.limits.unjudged.contact_pressure,
            s.limits[LimitKind::HertzPressure],
        )
    },
    set: |s, _, v| {
        s.limits.unjudged.contact_pressure = is_none(&v);
        s.limits[LimitKind::HertzPressure] = v.number();
        Ok(())
    },
};

/// Access to `accuracy.rms`. The word "none" also switches off the default bound.
pub(super) const ACCURACY: Access = Access {
    get: |s, _| bound(s.limits.unjudged.accuracy, s.rms),
    set: |s, _, v| {
        s.limits.unjudged.accuracy = is_none(&v);
        s.rms = v.number();
        Ok(())
    },
};

/// Access to `limits.pressure_angle`, which is one bound for rise and fall.
pub(super) const PRESSURE_ANGLE: Access = Access {
    get: |s, _| bound(s.limits.unjudged.pressure_angle, both_sides(&s.limits)),
    set: |s, _, v| {
        s.limits.unjudged.pressure_angle = is_none(&v);
        s.limits.set(LimitKind::PressureAngle, v.number());
        Ok(())
    },
};

fn bound(is_off: bool, value: Option<f64>) -> Option<Value> {
    let off = is_off.then(|| Value::Text(NONE.to_string()));
    off.or_else(|| value.map(Value::Number))
}

fn is_none(value: &Value) -> bool {
    matches!(value, Value::Text(word) if word == NONE)
}

/// Bound of the pressure angle, rad, if it is equal on rise and fall; otherwise `None`.
pub(super) fn both_sides(limits: &Limits) -> Option<f64> {
    let [rise, fall] = limits.pressure_angles();
    rise.filter(|_| rise == fall)
}

/// Access to the bound of the pressure angle on rise or fall. The value is `None` if both bounds are equal.
macro_rules! one_side {
    ($kind:ident) => {
        Access {
            get: |s, _| match both_sides(&s.limits) {
                None => s.limits[LimitKind::$kind].value(),
                Some(_) => None,
            },
            set: |s, _, v| s.limits[LimitKind::$kind].assign(v),
        }
    };
}

/// Creates the row of a limit from its path, its kind, and the range of its number. The word "none" is also accepted.
macro_rules! limit {
    ($path:literal, $kind:ident, $takes:expr) => {
        row(
            $path,
            $takes.or(NONE),
            "",
            Access {
                get: |s, _| s.limits[LimitKind::$kind].value(),
                set: |s, _, v| s.limits[LimitKind::$kind].assign(v),
            },
        )
        .limit(LimitKind::$kind)
    };
}

pub(super) use {constant, limit, one_side};
