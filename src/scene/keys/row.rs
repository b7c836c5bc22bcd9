//! One row of the key table.

use super::field::Access;
use super::kind::{Idle, Kind, Measure, Range, Relax};
use super::value::Value;
use crate::criterion::Direction;
use crate::error::Result;
use crate::scene::{LimitKind, Scene};
use crate::units::Dimension;

/// A key of the scene file, as one row of the key table.
///
/// ```
/// use gaitcam::scene::keys::{self, Value};
/// use gaitcam::{LimitKind, Scene};
///
/// let key = keys::find("limits.stroke").unwrap();
/// assert_eq!((key.section(), key.name(), key.limit), ("limits", "stroke", Some(LimitKind::Stroke)));
/// let mut scene = Scene::default();
/// key.set(&mut scene, 0, Value::Number(0.04))?;
/// assert_eq!((scene.limits[LimitKind::Stroke], key.number(&scene)), (Some(0.04), Some(0.04)));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Key {
    /// Dotted path of the key. A list entry has the letter N in place of its number: `law.segment.N.lift`.
    pub path: &'static str,
    /// Kind of value that the key accepts.
    pub kind: Kind,
    /// Permitted range of a numeric value, in SI units.
    pub range: Range,
    /// Default value as written in a scene file; empty if there is no default.
    pub default: &'static str,
    /// Limit that the key sets; `None` for other keys.
    pub limit: Option<LimitKind>,
    /// Direction in which the key may be relaxed; `None` if it may not be relaxed.
    pub relax: Option<Relax>,
    exists: fn(&Scene) -> bool,
    required: fn(&Scene) -> bool,
    idle: fn(&Scene) -> Option<Idle>,
    direct: bool,
    access: Access,
}

impl std::fmt::Debug for Key {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.path)
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Key) -> bool {
        self.path == other.path
    }
}

impl Key {
    /// First word of the path, which is the section of the scene file, such as `limits`; empty for keys outside sections.
    pub fn section(&self) -> &'static str {
        self.path.split_once('.').map_or("", |p| p.0)
    }

    /// Last word of the path, such as `stroke`.
    pub fn name(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |p| p.1)
    }

    /// Path of the list whose entries contain this key, such as `law.segment`; `None` outside lists.
    pub fn list(&self) -> Option<&'static str> {
        self.path.split_once(".N.").map(|p| p.0)
    }

    /// Path of the key in a list entry, as written by users. `index` starts at 0, but the number in the path starts at 1.
    pub fn path_at(&self, index: usize) -> String {
        self.path.replacen(".N.", &format!(".{}.", index + 1), 1)
    }

    /// Index of the list entry, from 0, if `path` denotes this key; 0 for keys outside lists. `None` if `path` denotes another key.
    pub fn index_in(&self, path: &str) -> Option<usize> {
        let Some((list, last)) = self.path.split_once(".N.") else {
            return (path == self.path).then_some(0);
        };
        let inside = path.strip_prefix(list)?.strip_prefix('.')?;
        let (number, name) = inside.split_once('.')?;
        match number {
            _ if name != last => None,
            "N" => Some(0),
            number => number.parse::<usize>().ok()?.checked_sub(1),
        }
    }

    /// Whether a scene may contain the key. For example, a follower on an arm has no offset.
    pub fn exists(&self, scene: &Scene) -> bool {
        (self.exists)(scene)
    }

    /// Whether a scene must contain the key.
    pub fn is_required(&self, scene: &Scene) -> bool {
        self.exists(scene) && (self.required)(scene)
    }

    /// Reason for which the key has no effect in a scene; `None` if it has an effect.
    pub fn idle(&self, scene: &Scene) -> Option<Idle> {
        (self.idle)(scene)
    }

    /// Value of the key in a scene; `None` if it is omitted or `"auto"`. `index` is the index of the list entry, from 0.
    pub fn get(&self, scene: &Scene, index: usize) -> Option<Value> {
        (self.access.get)(scene, index)
    }

    /// Sets the value of the key in a scene, without checking whether it is consistent with the other keys. `index` is the index of the list entry,
    /// from 0.
    ///
    /// # Errors
    ///
    /// A word is unknown.
    pub fn set(&self, scene: &mut Scene, index: usize, value: Value) -> Result<()> {
        (self.access.set)(scene, index, value)
    }

    /// Numeric value of the key in a scene, in SI units. In a list, it is the value of the first entry. `None` if there is no number.
    pub fn number(&self, scene: &Scene) -> Option<f64> {
        self.get(scene, 0).and_then(Value::number)
    }

    /// Sets a number in a scene, in SI units, without reading the scene again. It is used in sweeps. Returns `false` if the number cannot
    /// be set in this way. The scene must then be read again from its changed table.
    pub fn set_number(&self, scene: &mut Scene, index: usize, value: f64) -> bool {
        let there = self.get(scene, index).is_some() || self.list().is_none();
        self.direct
            && there
            && self.range.contains(value)
            && self.exists(scene)
            && self.set(scene, index, Value::Number(value)).is_ok()
    }

    /// Dimension of a numeric key, for each kind of follower; `None` for keys without unit.
    pub fn measure(&self) -> Option<Measure> {
        match self.kind {
            Kind::Number(measure) | Kind::NumberOrSeveral(measure) | Kind::NumberOr(measure, _) => {
                Some(measure)
            }
            _ => None,
        }
    }

    /// Dimension of a numeric key for the follower of a scene; `None` for keys without unit.
    pub fn dimension(&self, scene: &Scene) -> Option<Dimension> {
        self.measure().map(|m| m.of(scene.cam.measures()))
    }

    /// Words that the key accepts; empty if it accepts only other values.
    pub fn choices(&self) -> Vec<&'static str> {
        match self.kind {
            Kind::Choice(words) => words(),
            Kind::NumberOr(_, word) => vec![word],
            _ => Vec::new(),
        }
    }

    /// Example of a valid value, for messages.
    pub fn example(&self, scene: &Scene) -> String {
        match (self.dimension(scene), self.name()) {
            (_, "roller_radius") => "\"10 mm\"".to_string(),
            (_, "arc_radius") => "\"60 mm\"".to_string(),
            (_, "pivot_distance") => "\"80 mm\"".to_string(),
            (_, "arm") => "\"70 mm\"".to_string(),
            (_, "piston_radius") => "\"0.75 in\"".to_string(),
            _ if self.range == Range::Acute => "\"30 deg\"".to_string(),
            (Some(dimension), _) => dimension.example().to_string(),
            (None, _) => format!("\"{}\"", self.default),
        }
    }

    /// Creates a row that is valid in all scenes, without limit and relaxation.
    pub(super) const fn new(
        path: &'static str,
        kind: Kind,
        range: Range,
        default: &'static str,
        access: Access,
    ) -> Key {
        Key {
            path,
            kind,
            range,
            default,
            limit: None,
            relax: None,
            exists: |_| true,
            required: |_| false,
            idle: |_| None,
            direct: true,
            access,
        }
    }

    pub(super) const fn limit(mut self, kind: LimitKind) -> Key {
        self.limit = Some(kind);
        self.relax = Some(match kind.facts().direction {
            Direction::AtMost => Relax::Up,
            Direction::AtLeast => Relax::Down,
        });
        self
    }

    pub(super) const fn relax(mut self, relax: Relax) -> Key {
        self.relax = Some(relax);
        self
    }

    /// Restricts the key to some scenes. In other scenes, the key is an error.
    pub(super) const fn only(mut self, exists: fn(&Scene) -> bool) -> Key {
        self.exists = exists;
        self
    }

    /// Marks the key as required in every scene in which it is valid.
    pub(super) const fn required(mut self) -> Key {
        self.required = |_| true;
        self
    }

    /// Sets the function that returns the reason for which the key has no effect in a scene.
    pub(super) const fn idle_when(mut self, idle: fn(&Scene) -> Option<Idle>) -> Key {
        self.idle = idle;
        self
    }

    /// Marks a key whose number determines the meaning of other keys. After a change of the number, the scene must be read again.
    pub(super) const fn read_again(mut self) -> Key {
        self.direct = false;
        self
    }
}
