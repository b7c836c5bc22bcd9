//! Output units of the quantities of a design. Lifts are lengths, or angles for an arm. The position of the cam is an angle or a length.
//! The load is a force or a moment.

use crate::units::Dimension;
use crate::wording::{Language, degrees, fixed, number, people};

/// Unit in which a quantity is displayed.
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
    /// Factor from the SI unit to this unit.
    pub factor: f64,
    /// Name of the unit; empty for a plain number.
    pub name: &'static str,
}

const fn unit(factor: f64, name: &'static str) -> Unit {
    Unit { factor, name }
}

const DEGREES: Unit = unit(180.0 / std::f64::consts::PI, "°");

impl Unit {
    /// Output unit of a dimension.
    pub fn of(dimension: Dimension) -> Unit {
        Unit::of_si(dimension.si())
    }

    /// Output unit of lengths: millimetres, or the unit set by [`display_lengths_in`](gaitcam_base::wording::display_lengths_in).
    pub fn length() -> Unit {
        Unit::of_si("m")
    }

    fn of_si(si: &'static str) -> Unit {
        let (name, factor) = people(si);
        Unit { factor, name }
    }

    /// Formats an SI quantity as text in this unit.
    ///
    /// ```
    /// use gaitcam::cam::Measures;
    /// use gaitcam::wording::Language;
    ///
    /// let lift = Measures::Translating.lift(0);
    /// assert_eq!(lift.shown(0.012_345_6, Language::Es), "12,35 mm");
    /// ```
    pub fn shown(self, value: f64, language: Language) -> String {
        self.after(&number(language, self.factor * value))
    }

    /// Appends this unit to the text of a number, after a space unless the unit is the degree sign.
    pub fn after(self, number: &str) -> String {
        match self.name {
            "" => number.to_string(),
            "°" => format!("{number}°"),
            name => format!("{number} {name}"),
        }
    }
}

/// Kind of motion of follower and cam. It determines the units of a design.
///
/// ```
/// use gaitcam::cam::Measures;
///
/// // The lift of an arm is an angle. The lift of a translating follower is a length.
/// assert_eq!(Measures::Oscillating.lift(0).name, "°");
/// assert_eq!(Measures::Translating.lift(0).after("12.5"), "12.5 mm");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measures {
    /// A translating follower on a rotating cam: lift in m, position in rad.
    Translating,
    /// An oscillating follower on a rotating cam: lift in rad, position in rad, moments instead of forces.
    Oscillating,
    /// A translating cam: lift in m, position in m of travel.
    Straight,
}

impl Measures {
    fn swings(self) -> bool {
        self == Measures::Oscillating
    }

    fn is_straight(self) -> bool {
        self == Measures::Straight
    }

    /// Unit of the lift (order 0) or of its derivative of order 1 to 4 with respect to the cam angle (or travel).
    pub fn lift(self, order: usize) -> Unit {
        let order = order.min(4);
        match self {
            Measures::Translating => {
                Unit::of_si(["m", "m/rad", "m/rad^2", "m/rad^3", "m/rad^4"][order])
            }
            Measures::Oscillating => unit(
                DEGREES.factor,
                ["°", "°/rad", "°/rad²", "°/rad³", "°/rad⁴"][order],
            ),
            Measures::Straight => Unit::of_si(["m", "m/m", "m/m^2", "m/m^3", "m/m^4"][order]),
        }
    }

    /// Unit of a time derivative of the lift, order 1 to 3.
    pub fn by_time(self, order: usize) -> Unit {
        let order = order.clamp(1, 3) - 1;
        if self.swings() {
            unit(1.0, ["rad/s", "rad/s²", "rad/s³"][order])
        } else {
            Unit::of_si(["m/s", "m/s^2", "m/s^3"][order])
        }
    }

    /// Unit of the cam angle or travel.
    pub fn angle(self) -> Unit {
        if self.is_straight() {
            Unit::length()
        } else {
            DEGREES
        }
    }

    /// Name of the cam angle or travel, for an axis.
    pub fn angle_words(self) -> &'static str {
        if self.is_straight() {
            "travel of the cam x, mm"
        } else {
            "cam angle θ, degrees"
        }
    }

    /// Formats a position on the cam with one decimal: "12.3°", "34.2 mm".
    pub fn place(self, at: f64, language: Language) -> String {
        match self {
            Measures::Straight => {
                let unit = Unit::length();
                unit.after(&fixed(language, unit.factor * at, 1))
            }
            Measures::Translating | Measures::Oscillating => degrees(language, at),
        }
    }

    /// Unit of the cam speed.
    pub fn speed(self) -> Unit {
        if self.is_straight() {
            Unit::of_si("m/s")
        } else {
            unit(1.0, "rad/s")
        }
    }

    /// Formats the cam speed as text, for a rotating cam also in revolutions per minute.
    pub fn speed_words(self, speed: f64, language: Language) -> String {
        let own = self.speed().shown(speed, language);
        if self.is_straight() {
            return own;
        }
        let rpm = number(language, speed * 30.0 / std::f64::consts::PI);
        format!("{own} ({rpm} rpm)")
    }

    /// Unit of the drive's output: a force, or the moment on an arm.
    pub fn force(self) -> Unit {
        unit(1.0, if self.swings() { "N·m" } else { "N" })
    }

    /// Name of the force in messages.
    pub fn force_words(self) -> &'static str {
        if self.swings() { "moment" } else { "force" }
    }

    /// Unit of the moved mass, or of the moment of inertia of an arm.
    pub fn mass(self) -> Unit {
        unit(1.0, if self.swings() { "kg·m²" } else { "kg" })
    }

    /// Unit of the spring rate: force per lift, or for an arm moment per angle.
    pub fn spring_rate(self) -> Unit {
        if self.swings() {
            unit(1.0, "N·m/rad")
        } else {
            unit(1e-3, "N/mm")
        }
    }

    /// Unit of the damping coefficient: force per velocity, or for an arm moment per angular velocity.
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
        let english = Language::En;
        assert_eq!(Measures::Straight.place(0.16, english), "160.0 mm");
        assert_eq!(Measures::Oscillating.place(-0.0, english), "0.0°");
        assert_eq!(Measures::Translating.place(-0.5, Language::Es), "−28,6°");
        assert_eq!(Measures::Straight.speed_words(0.5, english), "0.5 m/s");
        let turning = Measures::Translating.speed_words(12.5664, Language::Es);
        assert_eq!(turning, "12,57 rad/s (120 rpm)");
    }
}
