//! Units of a design's quantities, for output: lifts are lengths or, of an arm, angles; a cam turns through
//! angles or slides along a length; forces or moments follow the lift.

use crate::units::Dimension;
use crate::wording::people;

/// A unit for output.
///
/// ```
/// use gaitcam::cam::Unit;
/// use gaitcam::units::Dimension;
///
/// let millimetre = Unit::of(Dimension::Length);
/// assert_eq!((millimetre.factor, millimetre.name), (1000.0, "mm"));
/// assert_eq!(millimetre.after("12.5"), "12.5 mm");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// From SI to this unit.
    pub factor: f64,
    /// Its name; empty for a plain number.
    pub name: &'static str,
}

const fn unit(factor: f64, name: &'static str) -> Unit {
    Unit { factor, name }
}

const MM: Unit = unit(1e3, "mm");
const DEGREES: Unit = unit(180.0 / std::f64::consts::PI, "°");

impl Unit {
    /// The unit for output of a dimension.
    pub fn of(dimension: Dimension) -> Unit {
        let (name, factor) = people(dimension.si());
        Unit { factor, name }
    }

    /// A number written in this unit, with the unit: degrees stand close to their number.
    pub fn after(self, number: &str) -> String {
        match self.name {
            "" => number.to_string(),
            "°" => format!("{number}°"),
            name => format!("{number} {name}"),
        }
    }
}

/// Kinds of motion of follower and cam, which fix the units.
///
/// ```
/// use gaitcam::cam::Measures;
///
/// // The lift of an arm is an angle, that of a slide a length.
/// assert_eq!(Measures::Oscillating.lift(0).name, "°");
/// assert_eq!(Measures::Translating.lift(0).after("12.5"), "12.5 mm");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measures {
    /// The follower slides on a cam that turns: m over rad.
    Translating,
    /// The follower swings on a cam that turns: rad over rad, moments in place of forces.
    Oscillating,
    /// The cam itself slides: m of lift over m of travel.
    Straight,
}

impl Measures {
    fn swings(self) -> bool {
        self == Measures::Oscillating
    }

    fn is_straight(self) -> bool {
        self == Measures::Straight
    }

    /// Lift and its derivatives by the cam's angle (or travel), up to order 4.
    pub fn lift(self, order: usize) -> Unit {
        let order = order.min(4);
        match self {
            Measures::Translating => unit(
                MM.factor,
                ["mm", "mm/rad", "mm/rad²", "mm/rad³", "mm/rad⁴"][order],
            ),
            Measures::Oscillating => unit(
                DEGREES.factor,
                ["°", "°/rad", "°/rad²", "°/rad³", "°/rad⁴"][order],
            ),
            Measures::Straight => unit(
                [1e3, 1.0, 1e-3, 1e-6, 1e-9][order],
                ["mm", "mm/mm", "mm/mm²", "mm/mm³", "mm/mm⁴"][order],
            ),
        }
    }

    /// Derivatives of the lift by time, order 1 to 3.
    pub fn by_time(self, order: usize) -> Unit {
        let names = if self.swings() {
            ["rad", "rad/s", "rad/s²", "rad/s³"]
        } else {
            ["m", "m/s", "m/s²", "m/s³"]
        };
        unit(1.0, names[order.min(3)])
    }

    /// The cam's angle, or its travel.
    pub fn angle(self) -> Unit {
        if self.is_straight() { MM } else { DEGREES }
    }

    /// The cam's angle in words, as an axis has it.
    pub fn angle_words(self) -> &'static str {
        if self.is_straight() {
            "travel of the cam x, mm"
        } else {
            "cam angle θ, degrees"
        }
    }

    /// Where on the cam: "at 12.34°", "at 34.2 mm".
    pub fn place(self, at: f64, decimals: usize) -> String {
        let unit = self.angle();
        // Adding zero turns −0 into 0.
        unit.after(&format!("{:.decimals$}", unit.factor * at + 0.0))
    }

    /// Speed of the cam.
    pub fn speed(self) -> Unit {
        unit(1.0, if self.is_straight() { "m/s" } else { "rad/s" })
    }

    /// The speed of the cam in words: as it is, and in turns per minute where it turns.
    pub fn speed_words(self, speed: f64, decimals: usize) -> String {
        let own = format!("{speed:.decimals$} {}", self.speed().name);
        if self.is_straight() {
            return own;
        }
        format!("{own} ({:.2} rpm)", speed * 30.0 / std::f64::consts::PI)
    }

    /// Output of the drive: a force, or the moment on an arm.
    pub fn force(self) -> Unit {
        unit(1.0, if self.swings() { "N·m" } else { "N" })
    }

    /// Its name.
    pub fn force_words(self) -> &'static str {
        if self.swings() { "moment" } else { "force" }
    }

    /// Moved mass, or an arm's moment of inertia.
    pub fn mass(self) -> Unit {
        unit(1.0, if self.swings() { "kg·m²" } else { "kg" })
    }

    /// Force per lift.
    pub fn spring_rate(self) -> Unit {
        if self.swings() {
            unit(1.0, "N·m/rad")
        } else {
            unit(1e-3, "N/mm")
        }
    }

    /// Force per speed of the lift.
    pub fn damping(self) -> Unit {
        let name = if self.swings() {
            "N·m·s/rad"
        } else {
            "N·s/m"
        };
        unit(1.0, name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_speeds_are_angles_or_of_a_slide_millimetres() {
        assert_eq!(Measures::Straight.place(0.16, 1), "160.0 mm");
        assert_eq!(Measures::Oscillating.place(-0.0, 1), "0.0°");
        assert_eq!(Measures::Straight.speed_words(0.5, 2), "0.50 m/s");
    }
}
