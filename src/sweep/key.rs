//! Scene keys that a sweep varies: which have a unit, and how a number reaches the scene without text.

use std::f64::consts::FRAC_PI_2;

use toml::{Table, Value};

use crate::error::{Error, Result};
use crate::scene::{self, Scene, Source};
use crate::units::Dimension;

/// Numbers that a key takes; anything else is left to the scene's own reader to refuse.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Allowed {
    Any,
    Positive,
    NotNegative,
    /// An angle in (0, 90°).
    Acute,
}

/// A key whose value is a quantity.
#[derive(Debug)]
struct Quantity {
    name: &'static str,
    dimension: Dimension,
    /// The SI unit as scenes write it.
    unit: &'static str,
    /// The same at the end of a column's name.
    suffix: &'static str,
    allowed: Allowed,
    /// Sets it in a scene that is already read; `None` where other keys decide what it means.
    set: Option<fn(&mut Scene, f64)>,
}

const fn quantity(
    name: &'static str,
    dimension: Dimension,
    unit: &'static str,
    suffix: &'static str,
    allowed: Allowed,
    set: Option<fn(&mut Scene, f64)>,
) -> Quantity {
    Quantity {
        name,
        dimension,
        unit,
        suffix,
        allowed,
        set,
    }
}

use Allowed::{Acute, Any, NotNegative, Positive};
use Dimension as D;

/// Every key with a unit. Two entries of one name are tried in turn: an oscillating follower's stroke is
/// an angle.
const QUANTITIES: &[Quantity] = &[
    quantity(
        "gait.step_frequency",
        D::Frequency,
        "Hz",
        "_hz",
        Positive,
        Some(step_frequency),
    ),
    quantity(
        "gait.body_weight",
        D::Force,
        "N",
        "_n",
        Positive,
        Some(body_weight),
    ),
    quantity("gait.rate", D::Frequency, "Hz", "_hz", Positive, None),
    quantity("gait.mass", D::Mass, "kg", "_kg", Positive, None),
    quantity(
        "drive.mass",
        D::Mass,
        "kg",
        "_kg",
        Positive,
        Some(|s, x| s.drive.mass = Some(x)),
    ),
    quantity(
        "drive.speed",
        D::AngularSpeed,
        "rad/s",
        "_rad_per_s",
        Positive,
        Some(|s, x| s.drive.speed = Some(x)),
    ),
    quantity(
        "drive.gravity",
        D::Acceleration,
        "m/s^2",
        "_m_per_s2",
        Positive,
        Some(|s, x| s.drive.gravity = x),
    ),
    quantity(
        "drive.pressure_per_volume",
        D::PressurePerVolume,
        "Pa/m^3",
        "_pa_per_m3",
        Positive,
        Some(|s, x| s.drive.pressure_per_volume = x),
    ),
    quantity(
        "drive.piston_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.drive.piston_radius = x),
    ),
    quantity(
        "drive.spring_rate",
        D::SpringRate,
        "N/m",
        "_n_per_m",
        NotNegative,
        Some(|s, x| s.drive.spring_rate = x),
    ),
    quantity(
        "drive.preload",
        D::Force,
        "N",
        "_n",
        Any,
        Some(|s, x| s.drive.preload = x),
    ),
    quantity(
        "drive.damping",
        D::Damping,
        "N s/m",
        "_n_s_per_m",
        NotNegative,
        Some(|s, x| s.drive.damping = x),
    ),
    quantity(
        "cam.base_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.base_radius = Some(x)),
    ),
    quantity(
        "cam.prime_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.prime_radius = Some(x)),
    ),
    quantity(
        "cam.offset",
        D::Length,
        "m",
        "_m",
        Any,
        Some(|s, x| s.cam.offset = Some(x)),
    ),
    quantity(
        "cam.roller_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.roller_radius = x),
    ),
    quantity(
        "cam.bore",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.bore = Some(x)),
    ),
    quantity(
        "cam.thickness",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.thickness = x),
    ),
    quantity("cam.pivot_distance", D::Length, "m", "_m", Positive, None),
    quantity("cam.arm", D::Length, "m", "_m", Positive, None),
    quantity("cam.face_offset", D::Length, "m", "_m", Any, None),
    quantity(
        "limits.stroke",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.limits.stroke = Some(x)),
    ),
    quantity(
        "limits.stroke",
        D::Angle,
        "rad",
        "_rad",
        Positive,
        Some(|s, x| s.limits.stroke = Some(x)),
    ),
    quantity(
        "limits.velocity",
        D::Speed,
        "m/s",
        "_m_per_s",
        Positive,
        Some(|s, x| s.limits.velocity = Some(x)),
    ),
    quantity(
        "limits.acceleration",
        D::Acceleration,
        "m/s^2",
        "_m_per_s2",
        Positive,
        Some(|s, x| s.limits.acceleration = Some(x)),
    ),
    quantity(
        "limits.jerk",
        D::Jerk,
        "m/s^3",
        "_m_per_s3",
        Positive,
        Some(|s, x| s.limits.jerk = Some(x)),
    ),
    quantity(
        "limits.pressure_angle",
        D::Angle,
        "rad",
        "_rad",
        Acute,
        None,
    ),
    quantity(
        "limits.pressure_angle_rise",
        D::Angle,
        "rad",
        "_rad",
        Acute,
        Some(|s, x| s.limits.pressure_angle_rise = Some(x)),
    ),
    quantity(
        "limits.pressure_angle_fall",
        D::Angle,
        "rad",
        "_rad",
        Acute,
        Some(|s, x| s.limits.pressure_angle_fall = Some(x)),
    ),
    quantity(
        "limits.curvature",
        D::Length,
        "m",
        "_m",
        NotNegative,
        Some(|s, x| s.limits.curvature = Some(x)),
    ),
    quantity(
        "limits.force_min",
        D::Force,
        "N",
        "_n",
        Any,
        Some(|s, x| s.limits.force_min = Some(x)),
    ),
    quantity(
        "limits.force_max",
        D::Force,
        "N",
        "_n",
        Any,
        Some(|s, x| s.limits.force_max = Some(x)),
    ),
    quantity(
        "limits.face_width",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.limits.face_width = Some(x)),
    ),
    quantity(
        "accuracy.rms",
        D::Ratio,
        "",
        "",
        Positive,
        Some(|s, x| s.rms = Some(x)),
    ),
];

fn step_frequency(scene: &mut Scene, hz: f64) {
    if let Some(Source::Model {
        step_frequency_hz, ..
    }) = scene.gait.as_mut().map(|g| &mut g.source)
    {
        *step_frequency_hz = Some(hz);
    }
}

fn body_weight(scene: &mut Scene, newtons: f64) {
    if let Some(Source::Model { body_weight_n, .. }) = scene.gait.as_mut().map(|g| &mut g.source) {
        *body_weight_n = newtons;
    }
}

/// A scene key that varies: a quantity in SI, or words.
#[derive(Debug, Clone)]
pub struct Key {
    name: String,
    quantity: Option<&'static Quantity>,
}

impl PartialEq for Key {
    fn eq(&self, other: &Key) -> bool {
        self.column() == other.column()
    }
}

impl Key {
    /// A key whose values are words, counts or paths.
    pub fn words(name: &str) -> Key {
        Key {
            name: name.trim().to_string(),
            quantity: None,
        }
    }

    /// The quantity of that name in which `values` make sense, with the values in SI; `None` when the key
    /// has no unit or a value is a word such as `auto`.
    pub fn quantity(name: &str, values: &[&str]) -> Result<Option<(Key, Vec<f64>)>> {
        let name = name.trim();
        let mut fault = None;
        for quantity in QUANTITIES.iter().filter(|q| q.name == name) {
            let parsed: Result<Vec<f64>> = values
                .iter()
                .map(|v| crate::units::parse(v, quantity.dimension))
                .collect();
            match parsed {
                Ok(numbers) => {
                    let key = Key {
                        name: name.to_string(),
                        quantity: Some(quantity),
                    };
                    return Ok(Some((key, numbers)));
                }
                Err(e) => fault = fault.or(Some(e)),
            }
        }
        let words = values.iter().any(|v| v.trim() == "auto");
        match fault {
            Some(e) if !words => Err(Error::key(name, e.what).help(e.help)),
            _ => Ok(None),
        }
    }

    /// The key whose column has this name, for readers of tables.
    pub fn of_column(column: &str) -> Key {
        let quantity = QUANTITIES
            .iter()
            .find(|q| column.strip_suffix(q.suffix) == Some(q.name));
        match quantity {
            Some(q) => Key {
                name: q.name.to_string(),
                quantity: Some(q),
            },
            None => Key::words(column),
        }
    }

    /// The dotted name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether its values are numbers in SI.
    pub fn is_number(&self) -> bool {
        self.quantity.is_some()
    }

    /// SI unit as scenes write it; empty for words and ratios.
    pub fn unit(&self) -> &'static str {
        self.quantity.map_or("", |q| q.unit)
    }

    /// Name of its column: `limits.stroke_m`, `law.family`.
    pub fn column(&self) -> String {
        format!("{}{}", self.name, self.quantity.map_or("", |q| q.suffix))
    }

    /// Whether a number may go straight into a scene; otherwise the scene's reader decides.
    pub(super) fn takes(&self, value: f64) -> bool {
        let Some(q) = self.quantity.filter(|q| q.set.is_some()) else {
            return false;
        };
        value.is_finite()
            && match q.allowed {
                Any => true,
                Positive => value > 0.0,
                NotNegative => value >= 0.0,
                Acute => value > 0.0 && value < FRAC_PI_2,
            }
    }

    /// Sets the number in a scene that is already read.
    pub(super) fn set(&self, scene: &mut Scene, value: f64) {
        if let Some(set) = self.quantity.and_then(|q| q.set) {
            set(scene, value);
        }
    }

    /// Writes the number into a scene's table, in SI.
    pub fn write_number(&self, table: &mut Table, value: f64) -> Result<()> {
        scene::set(table, &format!("{}={value} {}", self.name, self.unit()))
    }

    /// Writes words into a scene's table. A recording takes the place of a model and the other way round.
    pub fn write_words(&self, table: &mut Table, words: &str) -> Result<()> {
        let replaced: &[&str] = match self.name.as_str() {
            "gait.file" => &["model", "step_frequency", "body_weight"],
            "gait.model" => &["file", "time", "force", "unit", "rate", "mass"],
            _ => return scene::set(table, &format!("{}={words}", self.name)),
        };
        let gait = table
            .entry("gait")
            .or_insert_with(|| Value::Table(Table::new()));
        let Some(gait) = gait.as_table_mut() else {
            return Err(Error::key("gait", "is a value, not a table"));
        };
        for key in replaced {
            gait.remove(*key);
        }
        let key = self.name.trim_start_matches("gait.");
        gait.insert(key.to_string(), Value::String(words.to_string()));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_reads_back_from_its_column_and_its_si_unit() {
        for q in QUANTITIES {
            let text = format!("0.25 {}", q.unit);
            let (key, values) = Key::quantity(q.name, &[&text]).unwrap().unwrap();
            assert_eq!(values, [0.25], "{}", q.name);
            assert_eq!(Key::of_column(&key.column()), key);
        }
    }

    #[test]
    fn setters_do_what_the_reader_does() {
        let mut base: Table = scene::DEFAULT.parse().unwrap();
        for q in QUANTITIES
            .iter()
            .filter(|q| q.dimension != D::Angle || q.name != "limits.stroke")
        {
            let Some(set) = q.set else { continue };
            let mut table = base.clone();
            if q.name.contains("spring_rate")
                || q.name.contains("preload")
                || q.name.contains("damping")
            {
                scene::set(&mut table, "drive.kind=fixed-axis").unwrap();
            }
            if q.name.contains("pressure_per") || q.name.contains("piston") {
                for change in [
                    "drive.kind=hydraulic",
                    "drive.pressure_per_volume=30 psi/in^3",
                    "drive.piston_radius=2 cm",
                ] {
                    scene::set(&mut table, change).unwrap();
                }
            }
            if q.name == "cam.roller_radius" {
                scene::set(&mut table, "cam.follower=roller-translating").unwrap();
                scene::set(&mut table, "cam.roller_radius=1 cm").unwrap();
            }
            let mut direct = scene::read(&table).unwrap();
            set(&mut direct, 0.3);
            let key = Key {
                name: q.name.to_string(),
                quantity: Some(q),
            };
            key.write_number(&mut table, 0.3).unwrap();
            assert_eq!(scene::read(&table).unwrap(), direct, "{}", q.name);
        }
        Key::words("gait.file")
            .write_words(&mut base, "walk.mot")
            .unwrap();
        assert!(scene::read(&base).is_ok());
    }
}
