//! Meanings of the columns of a table, recognised from the column names.
//!
//! Names are split into words. Examples of names are `ground_force_l_vy`, `FP1.ForY`, `F1Z`, `Platte 1 Fz [N]` and `left total force[N]`.
//! They contain words for the force, its component, and the plate or foot, in different orders.

use super::vocabulary::{
    CYCLE, FRAME, LEFT, OTHER, PERCENT, PHASE, RIGHT, SIDE, STANCE, STRONG_FORCE, TIME, VERTICAL,
    VERTICAL_FORCE, WEAK_FORCE, WEAK_TIME, WHOLE, is,
};
use crate::recording::{Axis, Foot};

/// Meaning of a column of a table.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Role {
    Time,
    /// Phase of a cycle, or of a stance.
    Phase {
        of_stance: bool,
    },
    /// Counter of the samples or frames.
    Frame,
    Force {
        axis: Axis,
        foot: Option<Foot>,
    },
    Other,
}

/// Words of a name in lower case, without a unit in brackets. For example, `ForY1` gives `for`, `y` and `1`.
pub(super) fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut word = String::new();
    let mut depth = 0usize;
    let letters: Vec<char> = name.chars().collect();
    for (i, &c) in letters.iter().enumerate() {
        match c {
            '[' | '(' => depth += 1,
            ']' | ')' => depth = depth.saturating_sub(1),
            _ => (),
        }
        let before = i.checked_sub(1).map(|j| letters[j]);
        let after = letters.get(i + 1);
        let turn = before.is_some_and(|b| {
            b.is_numeric() != c.is_numeric()
                || b.is_lowercase() && c.is_uppercase()
                || b.is_uppercase() && c.is_uppercase() && after.is_some_and(|a| a.is_lowercase())
        });
        if (turn || !c.is_alphanumeric()) && !word.is_empty() {
            words.push(std::mem::take(&mut word));
        }
        if depth == 0 && c.is_alphanumeric() {
            word.extend(c.to_lowercase());
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

/// Texts in the brackets of a name: `N` and `left` for `Fz [N] (left)`.
pub(super) fn bracketed(name: &str) -> impl Iterator<Item = &str> {
    let opened = name.split(['[', '(']).skip(1);
    opened.filter_map(|rest| Some(rest[..rest.find([']', ')'])?].trim()))
}

/// Meaning of a column, recognised from its name.
pub(super) fn role(name: &str) -> Role {
    let words = words(name);
    let has = |list: &str| words.iter().any(|w| is(w, list));
    let is_sub_frame = words.iter().any(|w| w.starts_with("sub")) && has(FRAME);
    if is_sub_frame || is_other(&words) {
        return Role::Other;
    }
    if let Some(axis) = force_axis(&words) {
        return Role::Force {
            axis,
            foot: foot(&words),
        };
    }
    let first_is = |list: &str| words.first().is_some_and(|w| is(w, list));
    if first_is(WEAK_TIME) || has(TIME) {
        return Role::Time;
    }
    // A leading `%` of a header line is removed as a comment mark, so the name `% of gait cycle` may arrive without it.
    let is_bare = words
        .iter()
        .all(|w| is(w, "of") || is(w, CYCLE) || is(w, STANCE) || is(w, PERCENT));
    let is_percent = name.contains('%') || has(PERCENT) || is_bare;
    if has(PHASE) || is_percent && (has(CYCLE) || has(STANCE) || is_bare) {
        let of_stance = has(STANCE);
        return Role::Phase { of_stance };
    }
    if first_is(FRAME) || name.trim() == "#" {
        return Role::Frame;
    }
    Role::Other
}

/// Whether the words show that the column is not a vertical force.
pub(super) fn is_other(words: &[String]) -> bool {
    words.iter().any(|w| is(w, OTHER))
}

/// Whether a word only specifies the foot, plate or direction of a force column.
pub(super) fn is_of_channel(word: &str) -> bool {
    let lists = [
        LEFT,
        RIGHT,
        SIDE,
        VERTICAL,
        VERTICAL_FORCE,
        WHOLE,
        STRONG_FORCE,
        WEAK_FORCE,
    ];
    let number = word.chars().all(|c| c.is_ascii_digit());
    number || axis_letter(word).is_some() || lists.iter().any(|list| is(word, list))
}

/// Whether the name of a column denotes a vertical, total or normal force.
pub(super) fn says_vertical(name: &str) -> bool {
    let lists = [VERTICAL, VERTICAL_FORCE, WHOLE];
    let says = |w: &String| lists.iter().any(|list| is(w, list));
    words(name).iter().any(says)
}

/// Foot (left or right) that the words of a name denote; `None` if the words denote neither foot or both.
pub(super) fn foot(words: &[String]) -> Option<Foot> {
    let has = |list: &str| words.iter().any(|w| is(w, list));
    match (has(LEFT), has(RIGHT)) {
        (true, false) => Some(Foot::Left),
        (false, true) => Some(Foot::Right),
        _ => None,
    }
}

fn axis_letter(word: &str) -> Option<Axis> {
    match word {
        "x" | "fx" | "lfx" | "rfx" | "vx" | "forcex" | "grfx" => Some(Axis::X),
        "y" | "fy" | "lfy" | "rfy" | "vy" | "forcey" | "grfy" => Some(Axis::Y),
        "z" | "fz" | "lfz" | "rfz" | "vz" | "forcez" | "grfz" => Some(Axis::Z),
        _ => None,
    }
}

/// Component of the force, if the words denote a force; `None` otherwise.
fn force_axis(words: &[String]) -> Option<Axis> {
    let has = |list: &str| words.iter().any(|w| is(w, list));
    let is_force = |w: &String| is(w, STRONG_FORCE) || is(w, WEAK_FORCE);
    let is_side = |w: &String| is(w, LEFT) || is(w, RIGHT);
    let named = words.iter().any(is_force);
    if has(VERTICAL_FORCE) || named && has(VERTICAL) {
        return Some(Axis::Vertical);
    }
    let axis = words.iter().rev().find_map(|w| Some((w, axis_letter(w)?)));
    if let Some((word, axis)) = axis {
        // `HFx` denotes a marker, `LFz` a foot. A separate letter before the component must therefore denote a side.
        let before = words.iter().rev().skip_while(|w| *w != word).nth(1);
        let marker = before.is_some_and(|b| {
            let lone = b.chars().count() == 1 && !b.starts_with(|c: char| c.is_ascii_digit());
            lone && !is_side(b) && !is_force(b) && !is(b, VERTICAL)
        });
        if marker {
            return None;
        }
        let whole = word.len() > 1 && !word.starts_with('v');
        return (whole || named).then_some(axis);
    }
    // `f1_3` is the third component of force 1.
    if let [f, _, component] = words
        && is_force(f)
        && let Some(place) = ["1", "2", "3"].iter().position(|c| c == component)
    {
        return Some([Axis::X, Axis::Y, Axis::Z][place]);
    }
    let bare = |w: &String| is_force(w) || is_side(w) || w == "n" || w.parse::<u8>().is_ok();
    let force = has(STRONG_FORCE) || named && words.iter().all(bare);
    let side = words.len() == 1 && is(&words[0], SIDE);
    (force || side).then_some(Axis::Vertical)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(name: &str) -> (Axis, Option<Foot>) {
        match role(name) {
            Role::Force { axis, foot } => (axis, foot),
            other => panic!("{name}: {other:?}"),
        }
    }

    #[test]
    fn force_columns_of_every_house_are_recognised() {
        use Axis::{Vertical, X, Y, Z};
        let cases: &[(&str, Axis, Option<Foot>)] = &[
            ("ground_force_vy", Y, None),
            ("1_ground_force_vy", Y, None),
            ("l_ground_force_vy", Y, Some(Foot::Left)),
            ("ground_force_r_vx", X, Some(Foot::Right)),
            ("f1_3", Z, None),
            ("FY7", Y, None),
            ("F1Z", Z, None),
            ("Platte 1 Fz", Z, None),
            ("FP1.ForY", Y, None),
            ("Force_Z", Z, None),
            ("LFz", Z, Some(Foot::Left)),
            ("RFZ", Z, Some(Foot::Right)),
            ("Left Fz (N)", Z, Some(Foot::Left)),
            ("walk.c3d FP1 FORCE ORIGINAL Z", Z, None),
            ("LGroundReactionForce Z", Z, Some(Foot::Left)),
            ("left total force[N]", Vertical, Some(Foot::Left)),
            ("vGRF_right", Vertical, Some(Foot::Right)),
            ("vertical force", Vertical, None),
            ("force_n", Vertical, None),
            ("Kraft links [N]", Vertical, Some(Foot::Left)),
            ("force", Vertical, None),
        ];
        for (name, axis, foot) in cases {
            assert_eq!(force(name), (*axis, *foot), "{name}");
        }
    }

    #[test]
    fn markers_moments_and_pressures_are_not_forces() {
        for name in [
            "FHx",
            "HFx",
            "FMx",
            "LMx",
            "CAx",
            "COPx",
            "Mz",
            "MX1",
            "ground_force_px",
            "ground_force_l_px",
            "ground_torque_x",
            "p1_1",
            "m1_3",
            "X1",
            "left pressure 1[N/cm²]",
            "left acceleration X[g]",
            "AMTI - CoP Cx",
            "FP1.MomX",
            "Ax",
            "|Ft|",
            "LNormalisedGRF Z",
        ] {
            assert_eq!(role(name), Role::Other, "{name}");
        }
    }

    #[test]
    fn time_and_frame_columns_are_recognised() {
        for name in ["time", "Zeit", "Time [s]", "abs time (s)", "t", "TimeStamp"] {
            assert_eq!(role(name), Role::Time, "{name}");
        }
        for (name, of_stance) in [
            ("% of gait cycle", false),
            ("Gait cycle (%)", false),
            ("percent_stride", false),
            ("of gait cycle", false),
            ("percent", false),
            ("GC [%]", false),
            ("stance", true),
            ("phase", false),
            ("% stance phase", true),
            ("Ciclo de marcha [%]", false),
        ] {
            assert_eq!(role(name), Role::Phase { of_stance }, "{name}");
        }
        assert_eq!(role("Frame"), Role::Frame);
        assert_eq!(role("Sub Frame"), Role::Other);
        assert_eq!(role("#Sample"), Role::Frame);
        assert_eq!(bracketed("time [ms]").next(), Some("ms"));
        assert!(bracketed("Fz (left) [N] (2").eq(["left", "N"]));
    }
}
