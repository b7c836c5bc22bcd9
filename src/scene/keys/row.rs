//! Row of the key table.

use super::field::Access;
use super::kind::{Idle, Kind, Measure, Range, Relax};
use super::value::Value;
use crate::criterion::Direction;
use crate::error::Result;
use crate::scene::{LimitKind, Scene};
use crate::units::Dimension;

/// A key of the scene file.
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
    /// Dotted path, with `N` for the number of a list entry: `law.segment.N.lift`.
    pub path: &'static str,
    /// Kind of the key's value.
    pub kind: Kind,
    /// Range of a numeric value.
    pub range: Range,
    /// Default value, as written in a scene file; empty without a default.
    pub default: &'static str,
    /// Limit that the key sets.
    pub limit: Option<LimitKind>,
    /// Direction in which the key may be relaxed; `None` if it may not.
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
    /// Section of the key in the scene file, such as `limits`.
    pub fn section(&self) -> &'static str {
        self.path.split_once('.').map_or("", |p| p.0)
    }

    /// Last word of the path.
    pub fn name(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |p| p.1)
    }

    /// List whose entries have this key, such as `law.segment`.
    pub fn list(&self) -> Option<&'static str> {
        self.path.split_once(".N.").map(|p| p.0)
    }

    /// Path with the number of an entry as users write it; `index` is counted from 0.
    pub fn path_at(&self, index: usize) -> String {
        self.path.replacen(".N.", &format!(".{}.", index + 1), 1)
    }

    /// Index of the entry (0 outside lists) if `path` refers to this key.
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

    /// Whether a scene may contain the key; for example, a follower on an arm has no offset.
    pub fn exists(&self, scene: &Scene) -> bool {
        (self.exists)(scene)
    }

    /// Whether a scene must contain the key.
    pub fn is_required(&self, scene: &Scene) -> bool {
        self.exists(scene) && (self.required)(scene)
    }

    /// Reason why the key has no effect in a scene; `None` if it has an effect.
    pub fn idle(&self, scene: &Scene) -> Option<Idle> {
        (self.idle)(scene)
    }

    /// Value of the key; `None` if it is omitted or `"auto"`.
    pub fn get(&self, scene: &Scene, index: usize) -> Option<Value> {
        (self.access.get)(scene, index)
    }

    /// Sets the value. The checks of the scene then test whether it is consistent with the other keys.
    ///
    /// # Errors
    ///
    /// A word is unknown.
    pub fn set(&self, scene: &mut Scene, index: usize, value: Value) -> Result<()> {
        (self.access.set)(scene, index, value)
    }

    /// Numeric value of the key in a scene.
    pub fn number(&self, scene: &Scene) -> Option<f64> {
        self.get(scene, 0).and_then(Value::number)
    }

    /// Sets a number without reading the scene again, for sweeps. Returns `false` if the scene has to be read again with the changed table.
    pub fn set_number(&self, scene: &mut Scene, index: usize, value: f64) -> bool {
        let there = self.get(scene, index).is_some() || self.list().is_none();
        self.direct
            && there
            && self.range.contains(value)
            && self.exists(scene)
            && self.set(scene, index, Value::Number(value)).is_ok()
    }

    /// Dimension of a numeric key; `None` for words and counts.
    pub fn measure(&self) -> Option<Measure> {
        match self.kind {
            Kind::Number(measure) | Kind::NumberOrSeveral(measure) | Kind::NumberOr(measure, _) => {
                Some(measure)
            }
            _ => None,
        }
    }

    /// Dimension of a numeric key in a scene.
    pub fn dimension(&self, scene: &Scene) -> Option<Dimension> {
        self.measure().map(|m| m.of(scene.cam.measures()))
    }

    /// Words that the key accepts.
    pub fn choices(&self) -> Vec<&'static str> {
        match self.kind {
            Kind::Choice(words) => words(),
            Kind::NumberOr(_, word) => vec![word],
            _ => Vec::new(),
        }
    }

    /// Valid value of the key, for messages.
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

    /// Creates a row without conditions.
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

    /// Restricts the key to some scenes. In other scenes the key is an error.
    pub(super) const fn only(mut self, exists: fn(&Scene) -> bool) -> Key {
        self.exists = exists;
        self
    }

    /// Marks a key that has no default.
    pub(super) const fn required(mut self) -> Key {
        self.required = |_| true;
        self
    }

    /// Marks scenes in which the key has no effect, with the reason.
    pub(super) const fn idle_when(mut self, idle: fn(&Scene) -> Option<Idle>) -> Key {
        self.idle = idle;
        self
    }

    /// Marks a key whose meaning depends on other keys. After a change of its number, the scene must be read again.
    pub(super) const fn read_again(mut self) -> Key {
        self.direct = false;
        self
    }
}
