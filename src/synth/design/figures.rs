//! Figures (characteristic values) of a design, such as stroke, force error and size. All lists of figures are derived from one table.

use super::Design;
use super::machine::MachineReport;
use crate::cam::{Follower, Measures, Unit};
use crate::criterion::{Direction, LimitKind as Limit};
use crate::synth::report::force::ForceReport;
use crate::wording::{DIGITS, Language, people, rounded, sentence};

/// Characteristic values of one design, in SI units.
///
/// ```
/// use gaitcam::synth::Figures;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let figures = Figures::of(&design);
/// assert_eq!(figures.stroke, design.cam.law.stroke());
/// assert!((figures.mass - 700.0 / 9.81).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// Comparison of achieved force and target force, N. For a follower on an arm, the forces act at the lever.
    pub force: ForceReport,
    /// Mass that the cam moves, kg (for an arm the moment of inertia, kg·m²).
    pub mass: f64,
    /// Speed of the shaft, rad/s.
    pub speed: f64,
    /// Maximum lift minus minimum lift, m (rad for an arm).
    pub stroke: f64,
    /// Maximum |velocity|, |acceleration| and |jerk| with respect to time, in m/s, m/s² and m/s³. For an arm, the units are rad/s, rad/s²
    /// and rad/s³.
    pub peaks: [f64; 3],
    /// Radius of the base circle, m.
    pub base_radius: f64,
    /// Radius of the prime circle, m.
    pub prime_radius: f64,
    /// Minimum and maximum radius of the profile about the centre of the shaft, m; `None` for unrolled profiles.
    pub radii: Option<[f64; 2]>,
    /// Offset of the follower, m.
    pub offset: f64,
    /// Minimum radius of curvature of the convex parts of the profile, m.
    pub smallest_convex_radius: f64,
    /// Maximum |pressure angle|, rad.
    pub largest_pressure_angle: f64,
    /// Required length of the flat face, m; `None` without a flat face.
    pub face_width: Option<f64>,
    /// Torque, power, lift-off speed and contact pressure.
    pub machine: MachineReport,
    /// Speed ripple of a motor-driven shaft, relative to the mean speed; `None` at constant speed.
    pub shaft_ripple: Option<f64>,
    /// Maximum and RMS acceleration of a floor, m/s²; `None` for a rigid floor.
    pub floor: Option<[f64; 2]>,
    /// Maximum force error over several walkers, % of the mean force of the walker.
    pub worst_walker_percent: Option<f64>,
}

impl Figures {
    /// Computes all figures of a design.
    pub fn of(design: &Design) -> Figures {
        let (cam, speed) = (&design.cam, design.problem.drive.speed);
        let (follower, (low, high)) = (&cam.follower, design.pressure_angle_extremes());
        Figures {
            force: design.force.newtons(&design.problem.drive),
            mass: design.problem.drive.mass,
            speed,
            stroke: cam.law.stroke(),
            peaks: [1, 2, 3].map(|order| {
                let (low, high) = cam.derivative_extremes(order);
                high.value.max(-low.value) * speed.powi(order as i32)
            }),
            base_radius: follower.base_radius(),
            prime_radius: follower.prime_radius(),
            radii: cam.radii().map(|ends| ends.map(|end| end.value)),
            offset: follower.offset(),
            smallest_convex_radius: cam.curvature().convex.value,
            // The sum makes −0 positive on every platform.
            largest_pressure_angle: high.value.max(-low.value) + 0.0,
            face_width: cam.face_width(),
            machine: design.machine(),
            shaft_ripple: design.shaft.as_ref().map(|on| on.shaft.ripple),
            floor: (design.floor.as_ref())
                .map(|f| [f.acceleration_peak_m_per_s2, f.acceleration_rms_m_per_s2]),
            worst_walker_percent: design.population.as_ref().map(|p| p.worst_percent),
        }
    }
}

/// Definition of a figure: names, unit, value, and related keys of the scene.
///
/// ```
/// use gaitcam::synth::{Figure, Figures};
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let stroke = Figure::of_column("stroke_m").unwrap();
/// assert_eq!(stroke.value(&Figures::of(&design)), design.cam.law.stroke());
/// assert_eq!(stroke.unit, "m");
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Name of the column in the tables of sweeps.
    pub column: &'static str,
    /// SI unit of the figure.
    pub unit: &'static str,
    /// Maximum number of displayed significant digits.
    pub digits: usize,
    /// Table of `summary.json` that contains the figure; empty if no table contains it.
    pub section: &'static str,
    /// Key of the figure in this table of `summary.json`. It is also the column name in the file of a trade-off front.
    pub key: &'static str,
    /// Limit of the scene that applies to the figure; `None` without such a limit.
    pub limit: Option<Limit>,
    /// Name of the figure in a trade-off with the force error; `None` if the figure has no trade-off.
    pub trade: Option<&'static str>,
    /// Key of the scene for which this figure is the computed value if the scene contains `auto`; `None` for other figures.
    pub settles: Option<&'static str>,
    value: fn(&Figures) -> f64,
    /// Function for the displayed unit, if this unit depends on the kind of follower or cam.
    measured: Option<fn(Measures) -> Unit>,
}

impl Figure {
    const fn limited(mut self, kind: Limit) -> Figure {
        self.limit = Some(kind);
        self
    }

    const fn traded(mut self, name: &'static str) -> Figure {
        self.trade = Some(name);
        self
    }

    const fn settling(mut self, key: &'static str) -> Figure {
        self.settles = Some(key);
        self
    }

    const fn digits(mut self, digits: usize) -> Figure {
        self.digits = digits;
        self
    }

    const fn measured(mut self, unit: fn(Measures) -> Unit) -> Figure {
        self.measured = Some(unit);
        self
    }

    /// Name of the figure in messages, valid for every follower.
    ///
    /// ```
    /// use gaitcam::synth::Figure;
    /// use gaitcam::wording::Language;
    ///
    /// let stroke = Figure::of_column("stroke_m").unwrap();
    /// assert_eq!(stroke.label(Language::Es), "carrera");
    /// ```
    pub fn label(&self, language: Language) -> String {
        self.named_for("other", language)
    }

    /// Displayed name of the figure for this kind of follower.
    pub fn label_on(&self, follower: &Follower, language: Language) -> String {
        let movement = match (follower, follower.measures()) {
            (Follower::Barrel { .. }, _) => "barrel",
            (_, Measures::Straight) => "straight",
            (_, Measures::Oscillating) => "oscillating",
            (_, Measures::Translating) => "other",
        };
        self.named_for(movement, language)
    }

    fn named_for(&self, movement: &str, language: Language) -> String {
        let variant = self.column.replace('_', "-");
        let message = serde_json::json!({ variant: { "movement": movement } });
        sentence(language, "figure", &message)
    }

    /// Unit in which the figure is displayed.
    pub fn unit_on(&self, measures: Measures) -> Unit {
        let (name, factor) = people(self.unit);
        let usual = Unit { factor, name };
        self.measured.map_or(usual, |unit| unit(measures))
    }

    /// Formats a value, in SI units, in the displayed unit.
    ///
    /// ```
    /// use gaitcam::cam::Measures;
    /// use gaitcam::synth::Figure;
    /// use gaitcam::wording::Language;
    ///
    /// let stroke = Figure::of_column("stroke_m").unwrap();
    /// let shown = |measures| stroke.text(0.123_456, measures, Language::En);
    /// assert_eq!(shown(Measures::Translating), "123.5 mm");
    /// assert_eq!(shown(Measures::Oscillating), "7.074°");
    /// ```
    pub fn text(&self, value: f64, measures: Measures, language: Language) -> String {
        let unit = self.unit_on(measures);
        unit.after(&rounded(language, unit.factor * value, self.digits))
    }

    /// Value of the figure in SI units; NaN if the figure is not defined for the design.
    pub fn value(&self, figures: &Figures) -> f64 {
        (self.value)(figures)
    }

    /// Whether the value of the figure satisfies a limit.
    pub(in crate::synth) fn keeps(&self, figures: &Figures, limit: f64) -> bool {
        let direction = self
            .limit
            .map_or(Direction::AtMost, |kind| kind.facts().direction);
        direction.keeps(self.value(figures), limit)
    }

    /// The figure with this column name; `None` for an unknown name.
    pub fn of_column(column: &str) -> Option<&'static Figure> {
        FIGURES.iter().find(|f| f.column == column)
    }

    /// Names of the figures that can be combined with the force error in a trade-off.
    pub fn traded_names() -> impl Iterator<Item = &'static str> {
        FIGURES.iter().filter_map(|f| f.trade)
    }
}

/// All figures, in the order of the columns of a sweep. Each row contains the column name, the unit, the location in `summary.json`, the
/// function for the value, and related keys. The lift-off speed has no limit. A limit on the minimum force at the speed of the machine has
/// the same effect.
#[rustfmt::skip]
pub static FIGURES: [Figure; 31] = [
    figure("force_rms_error_n",         "N",     ["force",   "rms_error_n"],              |f| f.force.rms_error_n).digits(3),
    figure("force_rms_error_percent",   "%",     ["force",   "rms_error_percent_of_mean"], |f| f.force.rms_error_percent_of_mean).digits(3),
    figure("force_max_error_n",         "N",     ["force",   "max_error_n"],              |f| f.force.max_error_n).digits(3),
    figure("target_mean_n",             "N",     ["force",   "target_mean_n"],            |f| f.force.target_mean_n),
    figure("force_mean_n",              "N",     ["force",   "mean_n"],                   |f| f.force.mean_n),
    figure("force_min_n",               "N",     ["force",   "min_n"],                    |f| f.force.min_n).limited(Limit::ForceMin),
    figure("force_max_n",               "N",     ["force",   "max_n"],                    |f| f.force.max_n).limited(Limit::ForceMax),
    figure("mass_kg",                   "kg",    ["drive",   "mass_kg"],                  |f| f.mass).settling("drive.mass").measured(Measures::mass),
    figure("speed_rad_per_s",           "rad/s", ["drive",   "speed_rad_per_s"],          |f| f.speed).settling("drive.speed").measured(Measures::speed),
    figure("stroke_m",                  "m",     ["law",     "stroke_m"],                 |f| f.stroke).limited(Limit::Stroke).traded("stroke").measured(|m| m.lift(0)),
    figure("velocity_max_m_per_s",      "m/s",   ["",        "velocity_m_per_s"],         |f| f.peaks[0]).limited(Limit::Velocity).traded("velocity").measured(|m| m.by_time(1)),
    figure("acceleration_max_m_per_s2", "m/s^2", ["",        "acceleration_m_per_s2"],    |f| f.peaks[1]).limited(Limit::Acceleration).traded("acceleration").measured(|m| m.by_time(2)),
    figure("jerk_max_m_per_s3",         "m/s^3", ["",        "jerk_m_per_s3"],            |f| f.peaks[2]).limited(Limit::Jerk).traded("jerk").measured(|m| m.by_time(3)),
    figure("base_radius_m",             "m",     ["cam",     "base_radius_m"],            |f| f.base_radius).settling("cam.base_radius"),
    figure("prime_radius_m",            "m",     ["cam",     "prime_radius_m"],           |f| f.prime_radius).limited(Limit::PrimeRadius).traded("prime_radius").settling("cam.prime_radius"),
    figure("radius_min_m",              "m",     ["cam",     "radius_min_m"],             |f| known(f.radii.map(|ends| ends[0]))),
    figure("radius_max_m",              "m",     ["cam",     "radius_max_m"],             |f| known(f.radii.map(|ends| ends[1]))),
    figure("offset_m",                  "m",     ["cam",     "offset_m"],                 |f| f.offset).settling("cam.offset"),
    figure("rho_min_m",                 "m",     ["cam",     "rho_min_m"],                |f| f.smallest_convex_radius).limited(Limit::Curvature),
    figure("pressure_angle_max_rad",    "rad",   ["",        "pressure_angle_max_rad"],   |f| f.largest_pressure_angle).limited(Limit::PressureAngle),
    figure("face_width_m",              "m",     ["cam",     "face_width_m"],             |f| known(f.face_width)).limited(Limit::FaceWidth),
    figure("torque_max_n_m",            "N m",   ["machine", "torque_max_n_m"],           |f| known(f.machine.torque_max_n_m)).limited(Limit::Torque).traded("torque"),
    figure("torque_rms_n_m",            "N m",   ["machine", "torque_rms_n_m"],           |f| known(f.machine.torque_rms_n_m)),
    figure("power_max_w",               "W",     ["machine", "power_max_w"],              |f| known(f.machine.power_max_w)).limited(Limit::Power).traded("power"),
    figure("power_mean_w",              "W",     ["machine", "power_mean_w"],             |f| known(f.machine.power_mean_w)).limited(Limit::PowerMean),
    figure("liftoff_speed_rad_per_s",   "rad/s", ["machine", "liftoff_speed_rad_per_s"],  |f| known(f.machine.liftoff_speed_rad_per_s)).traded("liftoff_speed").measured(Measures::speed),
    figure("hertz_pressure_max_pa",     "Pa",    ["machine", "hertz_pressure_max_pa"],    |f| known(f.machine.hertz_pressure_max_pa)).limited(Limit::HertzPressure).traded("hertz_pressure"),
    figure("shaft_ripple",              "ratio", ["shaft",   "ripple"],                   |f| known(f.shaft_ripple)).digits(3),
    figure("floor_acceleration_peak_m_per_s2", "m/s^2", ["floor", "acceleration_peak_m_per_s2"], |f| known(f.floor.map(|ends| ends[0]))).digits(3),
    figure("floor_acceleration_rms_m_per_s2",  "m/s^2", ["floor", "acceleration_rms_m_per_s2"],  |f| known(f.floor.map(|ends| ends[1]))).digits(3),
    figure("worst_walker_percent",      "%",     ["population", "worst_percent"],         |f| known(f.worst_walker_percent)).digits(3),
];

const fn figure(
    column: &'static str,
    unit: &'static str,
    [section, key]: [&'static str; 2],
    value: fn(&Figures) -> f64,
) -> Figure {
    Figure {
        column,
        unit,
        digits: DIGITS,
        section,
        key,
        limit: None,
        trade: None,
        settles: None,
        value,
        measured: None,
    }
}

fn known(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}
