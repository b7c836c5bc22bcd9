//! Unit of lengths in files for manufacturing.

/// Unit of lengths in DXF files, drawings and programs.
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

    /// Symbol of the unit: `mm` or `in`.
    pub fn name(self) -> &'static str {
        match self {
            Units::Millimetres => "mm",
            Units::Inches => "in",
        }
    }

    /// Text of a length, given in m, without its unit. `decimals` applies to millimetres. In inches, the text has one more decimal.
    pub fn number(self, length: f64, decimals: usize) -> String {
        let decimals = decimals + usize::from(self == Units::Inches);
        format!("{:.decimals$}", self.per_metre() * length)
    }
}
