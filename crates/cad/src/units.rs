//! Unit of lengths in files for the workshop.

/// Unit of lengths in drawings and programs.
///
/// ```
/// use gaitcam_cad::Units;
///
/// assert_eq!((Units::Inches.per_metre() * 0.0254, Units::Inches.name()), (1.0, "in"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Units {
    /// Lengths are written in millimetres.
    #[default]
    Millimetres,
    /// Lengths are written in inches of 25.4 mm.
    Inches,
}

impl Units {
    /// Number of units per metre.
    pub fn per_metre(self) -> f64 {
        match self {
            Units::Millimetres => 1e3,
            Units::Inches => 1.0 / 0.0254,
        }
    }

    /// Symbol of the unit after a number.
    pub fn name(self) -> &'static str {
        match self {
            Units::Millimetres => "mm",
            Units::Inches => "in",
        }
    }

    /// A length in m as a number with a given number of decimals of a millimetre, and one more for inches.
    pub fn number(self, length: f64, decimals: usize) -> String {
        let decimals = decimals + usize::from(self == Units::Inches);
        format!("{:.decimals$}", self.per_metre() * length)
    }
}
