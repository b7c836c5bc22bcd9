//! Access from a key of a scene file to its field in a [`Scene`], with one implementation for each type of field.

use super::value::Value;
use crate::cam::{FollowerKind, Hardness, Stock};
use crate::drive::DriveKind;
use crate::error::{Result, SceneError};
use crate::force::{Feet, Kind as Movement, OpenQuestion};
use crate::law::Rise;
use crate::scene::{
    Adjust, Band, ErrorMeasure, Family, ForceScale, KeywaySpec, Minimise, Phase, Robust, Scene,
    ShaftSpeed,
};
use crate::wording::nearest_in_languages;

/// Functions that read and set the value of a key. Their second argument is the index of a list entry, from 0.
#[derive(Clone, Copy)]
pub struct Access {
    pub get: fn(&Scene, usize) -> Option<Value>,
    pub set: fn(&mut Scene, usize, Value) -> Result<()>,
}

/// Creates the access to a field of the scene. `part?` is an optional part, and `list[N]` is an entry of a list. A missing part or entry is created
/// when a value is set.
macro_rules! field {
    ($($field:ident).+) => {
        Access {
            get: |s, _| s.$($field).+.value(),
            set: |s, _, v| s.$($field).+.assign(v),
        }
    };
    ($part:ident ? . $field:ident) => {
        Access {
            get: |s, _| s.$part.as_ref()?.$field.value(),
            set: |s, _, v| s.$part.get_or_insert_default().$field.assign(v),
        }
    };
    ($outer:ident . $part:ident ? . $field:ident) => {
        Access {
            get: |s, _| s.$outer.$part.as_ref()?.$field.value(),
            set: |s, _, v| s.$outer.$part.get_or_insert_default().$field.assign(v),
        }
    };
    ($outer:ident . $list:ident [N] . $field:ident) => {
        Access {
            get: |s, i| s.$outer.$list.get(i)?.$field.value(),
            set: |s, i, v| entry(&mut s.$outer.$list, i).$field.assign(v),
        }
    };
    ($part:ident ? . $list:ident [N] . $field:ident) => {
        Access {
            get: |s, i| s.$part.as_ref()?.$list.get(i)?.$field.value(),
            set: |s, i, v| entry(&mut s.$part.get_or_insert_default().$list, i).$field.assign(v),
        }
    };
}
pub(super) use field;

/// The entry of a list with the given index. Missing entries are created with default values.
pub(super) fn entry<T: Default + Clone>(list: &mut Vec<T>, index: usize) -> &mut T {
    if list.len() <= index {
        list.resize(index + 1, T::default());
    }
    &mut list[index]
}

/// Type of a field that a key can set.
pub(super) trait Field {
    /// Value of the field in a scene file; `None` if the file omits the key.
    fn value(&self) -> Option<Value>;

    /// Sets the field from a value of the scene file.
    ///
    /// # Errors
    ///
    /// A word is unknown.
    fn assign(&mut self, value: Value) -> Result<()>;
}

/// Implements [`Field`] for types, from an expression that reads the field and one that sets it.
macro_rules! impl_field {
    ($($type:ty: |$field:ident| $get:expr, |$value:ident| $set:expr;)+) => {$(
        impl Field for $type {
            fn value(&self) -> Option<Value> {
                let $field = self;
                $get
            }

            fn assign(&mut self, $value: Value) -> Result<()> {
                *self = $set;
                Ok(())
            }
        }
    )+};
}

impl_field! {
    f64: |x| Some(Value::Number(*x)), |v| v.number().unwrap_or_default();
    Option<f64>: |x| x.map(Value::Number), |v| v.number();
    usize: |n| Some(Value::Count(*n)), |v| v.count().unwrap_or(1);
    Option<usize>: |n| n.map(Value::Count), |v| v.count();
    bool: |flag| Some(Value::Flag(*flag)), |v| v == Value::Flag(true);
    String: |text| Some(Value::Text(text.clone())), |v| v.text();
    Option<String>: |text| text.clone().map(Value::Text), |v| Some(v.text());
    Vec<String>: |list| (!list.is_empty()).then(|| Value::Texts(list.clone())), |v| v.texts();
    Vec<OpenQuestion>: |list| names(list), |v| OpenQuestion::list(&v.text())?;
    Rise: |rise| Some(Value::Text(rise.written())), |v| Rise::from_name(&v.text())?;
    Option<Hardness>: |hardness| hardness.map(|h| Value::Text(h.to_string())), |v| Some(hardness(v.text())?);
    Option<KeywaySpec>: |spec| spec.map(|s| match s {
        KeywaySpec::Auto => Value::Text("auto".to_string()),
        KeywaySpec::Width(width) => Value::Number(width),
    }), |v| Some(v.number().map_or(KeywaySpec::Auto, KeywaySpec::Width));
    Robust: |robust| (*robust != Robust::Mean).then(|| Value::Text(robust.to_string())), |v| v.text().parse()?;
    Option<Adjust>: |adjust| adjust.map(|a| Value::Texts(a.words())), |v| adjusted(&v.texts())?;
    Option<Band>: |band| band.map(|b| match b {
        Band::Spread => Value::Text("spread".to_string()),
        Band::Width(newtons) => Value::Number(newtons),
    }), |v| Some(v.number().map_or(Band::Spread, Band::Width));
    Phase: |phase| Some(match phase {
        Phase::Free => Value::Text("free".to_string()),
        Phase::At(angle) => Value::Number(*angle),
    }), |v| v.number().map_or(Phase::Free, Phase::At);
}

fn adjusted(words: &[String]) -> Result<Option<Adjust>> {
    match words {
        [auto] if auto == "auto" => Ok(None),
        words => Adjust::of(words).map(Some),
    }
}

fn names(questions: &[OpenQuestion]) -> Option<Value> {
    let names: Vec<&str> = questions.iter().map(|q| q.name()).collect();
    (!names.is_empty()).then(|| Value::Text(names.join(", ")))
}

fn hardness(typed: String) -> Result<Hardness> {
    Hardness::parse(&typed).ok_or_else(|| SceneError::NotHardness { typed }.into())
}

/// A closed set of values, each written as a word in a scene.
pub(super) trait Words: Copy + PartialEq + 'static {
    fn words() -> Vec<(&'static str, Self)>;
}

macro_rules! impl_words {
    ($($type:ty: $words:expr;)+) => {$(
        impl Words for $type {
            fn words() -> Vec<(&'static str, $type)> {
                $words
            }
        }
    )+};
}

fn named_all<T: Copy>(all: &[T], name: fn(T) -> &'static str) -> Vec<(&'static str, T)> {
    all.iter().map(|&value| (name(value), value)).collect()
}

impl_words! {
    DriveKind: named_all(DriveKind::ALL, DriveKind::name);
    FollowerKind: named_all(FollowerKind::ALL, FollowerKind::name);
    Stock: named_all(Stock::ALL, Stock::name);
    Movement: named_all(Movement::ALL, Movement::name);
    Feet: named_all(&Feet::ALL, Feet::name);
    ForceScale: named_all(ForceScale::ALL, ForceScale::name);
    Family: named_all(Family::ALL, Family::name);
    ErrorMeasure: named_all(&ErrorMeasure::ALL, ErrorMeasure::name);
    ShaftSpeed: named_all(ShaftSpeed::ALL, ShaftSpeed::name);
    Minimise: Minimise::NAMES.to_vec();
}

impl<T: Words> Field for T {
    fn value(&self) -> Option<Value> {
        let word = T::words().into_iter().find(|w| w.1 == *self)?.0;
        Some(Value::Text(word.to_string()))
    }

    fn assign(&mut self, value: Value) -> Result<()> {
        *self = named(&value.text())?;
        Ok(())
    }
}

impl<T: Words> Field for Option<T> {
    fn value(&self) -> Option<Value> {
        self.as_ref()?.value()
    }

    fn assign(&mut self, value: Value) -> Result<()> {
        *self = Some(named(&value.text())?);
        Ok(())
    }
}

fn named<T: Words>(word: &str) -> Result<T> {
    let words = T::words();
    match words.iter().find(|w| w.0 == word) {
        Some((_, value)) => Ok(*value),
        None => Err(unknown_word(word, &words.iter().map(|w| w.0).collect::<Vec<_>>()).into()),
    }
}

/// Error for a word that is not in a closed set. It suggests the nearest word.
pub(super) fn unknown_word(word: &str, known: &[&'static str]) -> SceneError {
    SceneError::UnknownWord {
        word: word.to_string(),
        nearest: nearest_in_languages(word, known).map(str::to_string),
        known: known.join(", "),
    }
}
