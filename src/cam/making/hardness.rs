//! Hardness of the cam's surface, and the allowable contact pressure.

use std::fmt;

use serde::Serialize;

/// Conversion table of Rockwell C, Vickers and Brinell hardness (tungsten carbide ball) of hardened steel, ASTM E140 table 1.
const CONVERSION: [[f64; 3]; 12] = [
    [20.0, 238.0, 226.0],
    [25.0, 266.0, 253.0],
    [30.0, 302.0, 286.0],
    [35.0, 345.0, 327.0],
    [40.0, 392.0, 371.0],
    [45.0, 446.0, 421.0],
    [50.0, 513.0, 481.0],
    [55.0, 595.0, 560.0],
    [58.0, 653.0, 615.0],
    [60.0, 697.0, 654.0],
    [62.0, 746.0, 688.0],
    [64.0, 800.0, 722.0],
];
/// Minimum hardness, HB, for which the formula of the allowable pressure is valid.
const SOFTEST: f64 = 100.0;

/// Scales of hardness that a scene accepts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr, strum::EnumString)]
#[serde(rename_all = "kebab-case")]
#[strum(ascii_case_insensitive)]
pub enum HardnessScale {
    /// Vickers hardness, in HV.
    #[strum(serialize = "HV")]
    Vickers,
    /// Rockwell C hardness, HRC.
    #[strum(serialize = "HRC")]
    RockwellC,
    /// Brinell hardness, HB, with a ball of tungsten carbide.
    #[strum(serialize = "HB")]
    Brinell,
}

impl HardnessScale {
    /// Symbol of the hardness scale.
    pub fn symbol(self) -> &'static str {
        self.into()
    }

    /// Column of the scale in the conversion table.
    fn column(self) -> usize {
        match self {
            HardnessScale::RockwellC => 0,
            HardnessScale::Vickers => 1,
            HardnessScale::Brinell => 2,
        }
    }
}

/// Hardness of a surface: value and scale.
///
/// ```
/// use gaitcam::cam::Hardness;
///
/// let hardness = Hardness::parse("58 HRC").ok_or("no hardness")?;
/// assert_eq!(hardness.brinell(), 615.0);
/// assert_eq!(hardness.allowable_pressure(), 2.76e6 * 615.0 - 70e6);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Hardness {
    /// Numeric value of the hardness on its scale.
    pub value: f64,
    /// Hardness scale of the value.
    pub scale: HardnessScale,
}

impl Hardness {
    /// Reads a text such as `58 HRC`, `650 HV` or `240 HB`; `None` for other texts, and outside 20 … 64 HRC, 105 … 800 HV, 100 … 722 HB.
    pub fn parse(text: &str) -> Option<Hardness> {
        let text = text.trim();
        let end = text.find(|c: char| c.is_ascii_alphabetic())?;
        let value: f64 = text[..end].trim().parse().ok()?;
        let scale: HardnessScale = text[end..].trim().parse().ok()?;
        let hardness = Hardness { value, scale };
        let column = scale.column();
        let hardest = CONVERSION[CONVERSION.len() - 1][column];
        let softest = match scale {
            HardnessScale::RockwellC => CONVERSION[0][column],
            _ => SOFTEST * CONVERSION[0][column] / CONVERSION[0][2],
        };
        (softest..=hardest).contains(&value).then_some(hardness)
    }

    /// Converts the hardness to HB. The conversion is linear between the rows of the table, and proportional below its first row.
    pub fn brinell(self) -> f64 {
        let column = self.scale.column();
        let first = CONVERSION[0];
        if self.value <= first[column] {
            return self.value * first[2] / first[column];
        }
        let above = CONVERSION.iter().position(|row| self.value <= row[column]);
        let above = above.unwrap_or(CONVERSION.len() - 1);
        let (a, b) = (CONVERSION[above - 1], CONVERSION[above]);
        let part = (self.value - a[column]) / (b[column] - a[column]);
        a[2] + part * (b[2] - a[2])
    }

    /// Allowable contact pressure of hardened steel for 10⁸ cycles, Pa: 2.76 HB − 70 MPa (theory §10).
    pub fn allowable_pressure(self) -> f64 {
        2.76e6 * self.brinell() - 70e6
    }
}

impl fmt::Display for Hardness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.value, self.scale.symbol())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hardness_is_read_with_its_scale_and_converted_by_the_table() {
        let brinell = |text: &str| Hardness::parse(text).map(Hardness::brinell);
        assert_eq!(brinell("650 hv").map(f64::round), Some(612.0));
        assert_eq!(brinell("50HRC"), Some(481.0));
        assert_eq!(brinell("240 HB"), Some(240.0));
        for wrong in ["58", "HRC 58", "19 HRC", "70 HRC", "58 HRB", "-3 HV", ""] {
            assert_eq!(brinell(wrong), None, "{wrong}");
        }
    }
}
