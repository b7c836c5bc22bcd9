//! Materials of cam and follower: elastic constants and allowable contact pressure.

use serde::Serialize;

/// Maximum pressure of a line contact at which the material does not yield, as a multiple of the yield strength. The maximum shear stress
/// below the surface is 0.300 p₀, with the maximum pressure p₀. The material yields where it reaches half of the yield strength (Tresca;
/// Johnson 1985, Contact Mechanics, §6.1).
const FIRST_YIELD: f64 = 0.5 / 0.300;

/// Elastic constants of one body.
///
/// ```
/// use gaitcam::dynamics::hertz::{Material, STEEL, modulus};
///
/// // The reduced modulus of two equal bodies is E/(1 − ν²)/2, half of the value for a rigid second body.
/// let rigid = Material { young: f64::INFINITY, poisson: 0.0 };
/// assert!((modulus(STEEL, rigid) / modulus(STEEL, STEEL) - 2.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus of the body, Pa.
    pub young: f64,
    /// Poisson's ratio of the body.
    pub poisson: f64,
}

impl Material {
    /// Contribution (1 − ν²)/E of the body to the compliance 1/E* of a contact, 1/Pa.
    pub fn compliance(self) -> f64 {
        (1.0 - self.poisson * self.poisson) / self.young
    }
}

/// Steel, with Young's modulus 206.8 GPa and Poisson's ratio 0.3 (theory §10).
pub const STEEL: Material = Material {
    young: 206.8e9,
    poisson: 0.3,
};

/// Built-in materials. Their constants are typical values of the grade in brackets, quoted from memory of the named standards and data
/// sheets.
///
/// ```
/// use gaitcam::cam::Stock;
///
/// let pla = Stock::named("pla").unwrap();
/// assert_eq!(pla.material().young, 3.3e9);
/// // 50 MPa yield strength.
/// assert!((pla.allowable_pressure() / 83.3e6 - 1.0).abs() < 1e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[derive(strum::EnumString, strum::IntoStaticStr, strum::VariantNames, strum::VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Stock {
    /// Quenched and tempered steel (C45+QT, EN ISO 683-1).
    Steel,
    /// Ductile cast iron (EN-GJS-500-7, EN 1563).
    CastIron,
    /// Tin bronze (CuSn12-C, EN 1982).
    Bronze,
    /// Aluminium alloy (EN AW-6082 T6, EN 755-2).
    Aluminium,
    /// Acetal copolymer, at room temperature.
    Pom,
    /// Polyamide 66, conditioned at 50 % humidity.
    Pa66,
    /// Polylactide (PLA), 3D-printed without voids.
    Pla,
    /// Glycol-modified polyethylene terephthalate (PETG), 3D-printed without voids.
    Petg,
}

impl Stock {
    /// All built-in materials.
    pub const ALL: &'static [Stock] = <Stock as strum::VariantArray>::VARIANTS;

    /// Name of the material in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The built-in material with this name in a scene file; `None` for another name.
    pub fn named(name: &str) -> Option<Stock> {
        name.trim().to_ascii_lowercase().parse().ok()
    }

    /// Constants of the material: Young's modulus, Pa, Poisson's ratio, and yield strength, Pa.
    #[rustfmt::skip]
    fn constants(self) -> [f64; 3] {
        match self {
            Stock::Steel     => [STEEL.young, STEEL.poisson, 430e6],
            Stock::CastIron  => [169e9, 0.275, 320e6],
            Stock::Bronze    => [ 95e9, 0.34,  140e6],
            Stock::Aluminium => [ 70e9, 0.33,  250e6],
            Stock::Pom       => [2.8e9, 0.37,   65e6],
            Stock::Pa66      => [1.7e9, 0.40,   55e6],
            Stock::Pla       => [3.3e9, 0.36,   50e6],
            Stock::Petg      => [2.0e9, 0.38,   45e6],
        }
    }

    /// Young's modulus and Poisson's ratio of the material.
    pub fn material(self) -> Material {
        let [young, poisson, _] = self.constants();
        Material { young, poisson }
    }

    /// Contact pressure at which the material begins to yield below a line contact, Pa. In long operation, rolling fatigue requires a lower
    /// pressure.
    pub fn allowable_pressure(self) -> f64 {
        FIRST_YIELD * self.constants()[2]
    }
}

/// Material constants given in a scene. A missing elastic constant is that of the built-in material `stock`, or of steel without it.
///
/// ```
/// use gaitcam::cam::StatedMaterial;
///
/// let resin = StatedMaterial { young: Some(2.4e9), ..StatedMaterial::default() };
/// assert_eq!((resin.material().young, resin.material().poisson), (2.4e9, 0.3));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct StatedMaterial {
    /// The built-in material whose constants are used for values that are not stated; `None` for steel.
    pub stock: Option<Stock>,
    /// Stated Young's modulus, Pa.
    pub young: Option<f64>,
    /// Stated Poisson's ratio.
    pub poisson: Option<f64>,
    /// Stated allowable contact pressure, Pa.
    pub allowable_pressure: Option<f64>,
}

impl StatedMaterial {
    /// Young's modulus and Poisson's ratio. Values that are not stated are those of the built-in material, or of steel without it.
    pub fn material(&self) -> Material {
        let usual = self.stock.map_or(STEEL, Stock::material);
        Material {
            young: self.young.unwrap_or(usual.young),
            poisson: self.poisson.unwrap_or(usual.poisson),
        }
    }

    /// Allowable contact pressure, Pa. If it is not stated, it is that of the built-in material. `None` if there is no such material, or if
    /// its Young's modulus is replaced by a stated value.
    pub fn allowable_pressure(&self) -> Option<f64> {
        let usual = || self.stock.filter(|_| self.young.is_none());
        let usual = || usual().map(Stock::allowable_pressure);
        self.allowable_pressure.or_else(usual)
    }
}
