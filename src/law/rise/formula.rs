//! Formulas of the motions in the catalogue, for display.

use super::Rise;

impl Rise {
    /// Formula of the motion: s(x), or a(x) if the acceleration is defined piece by piece.
    ///
    /// ```
    /// use gaitcam::law::Rise;
    ///
    /// assert_eq!(Rise::Cycloidal.formula(), "s = x − sin(2πx)/(2π)");
    /// ```
    pub fn formula(&self) -> &'static str {
        match self {
            Rise::Dwell => "s = 0",
            Rise::ConstantVelocity => "s = x",
            Rise::Parabolic => "s = 2x² | x ≤ ½; 1 − 2(1 − x)²",
            Rise::Cubic => "s = 3x² − 2x³",
            Rise::Eccentric { ratio } if ratio.is_finite() => {
                "s = ½(1 − cos(πx)) + ½(√(k² − sin²(πx)) − k)"
            }
            Rise::SimpleHarmonic | Rise::Eccentric { .. } => "s = ½(1 − cos(πx))",
            Rise::DoubleHarmonic => "s = ½((1 − cos(πx)) − ¼(1 − cos(2πx)))",
            Rise::Cycloidal => "s = x − sin(2πx)/(2π)",
            Rise::SemiharmonicStart => "s = 1 − cos(½πx)",
            Rise::SemiharmonicEnd => "s = sin(½πx)",
            Rise::SemicycloidalStart => "s = x − sin(πx)/π",
            Rise::SemicycloidalEnd => "s = x + sin(πx)/π",
            Rise::ModifiedTrapezoid => {
                "a = Ca sin(4πx) | x ≤ ⅛; Ca | x ≤ ⅜; Ca cos(4π(x − ⅜)) | x ≤ ⅝; −Ca | x ≤ ⅞; −Ca cos(4π(x − ⅞))"
            }
            Rise::ModifiedSine => {
                "a = Ca sin(4πx) | x ≤ ⅛; Ca cos(4π(x − ⅛)/3) | x ≤ ⅞; −Ca cos(4π(x − ⅞))"
            }
            Rise::Scca { .. } => {
                "a = Ca sin(4πx) | x ≤ ⅛; Ca | x ≤ ¼; Ca cos(2π(x − ¼)) | x ≤ ¾; −Ca | x ≤ ⅞; −Ca cos(4π(x − ⅞))"
            }
            Rise::Poly345 | Rise::Polynomial { degree: 5 } => "s = 10x³ − 15x⁴ + 6x⁵",
            Rise::Poly4567 | Rise::Polynomial { .. } => "s = 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷",
            Rise::Poly56789 => "s = 126x⁵ − 420x⁶ + 540x⁷ − 315x⁸ + 70x⁹",
            Rise::BerzakD => "s = 12.1x³ − 25.5x⁴ + 24.9x⁵ − 14.7x⁶ + 4.2x⁷",
            Rise::Gutman13 => "s = x − 15sin(2πx)/(32π) − sin(6πx)/(96π)",
            Rise::Freudenstein13 => "s = x − 27/(56π)(sin(2πx) + sin(6πx)/54)",
            Rise::Freudenstein13AtRest => "s = x − 27/(56π)(sin(2πx) + sin(6πx)/81)",
            Rise::Freudenstein135 => {
                "s = x − 1125/(2384π)(sin(2πx) + sin(6πx)/54 + sin(10πx)/1250)"
            }
            Rise::User { .. } => "s(x)",
        }
    }
}
