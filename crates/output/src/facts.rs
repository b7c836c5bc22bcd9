//! Facts about a design for the console, the report and the page. Each fact has a name and a formatted value.

use crate::words::{self, Words};
use gaitcam::cam::{Measures, Unit};
use gaitcam::drive::DriveKind;
use gaitcam::dynamics::RepeatedForce;
use gaitcam::synth::{Design, Figure, Figures, OfWalker};
use gaitcam::wording::{Language, rounded};

/// Damping ratio of the vibration mode to which the sentence on resonance refers.
const SHOWN_DAMPING: f64 = 0.005;

/// Form in which the console shows a fact. The report shows every fact with name and value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Brief {
    /// The fact is not shown on the console.
    Not,
    /// The name and the value of the fact are shown on the console.
    Whole,
    /// Only the value of the fact is shown on the console.
    Value,
}

/// A fact about a design: name and formatted value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fact {
    /// Name of the fact in the language of the output.
    pub name: String,
    /// Value of the fact with its unit.
    pub value: String,
    /// Key of the fact: column name in the table of design quantities, or message key of the name.
    pub(crate) key: &'static str,
    brief: Brief,
}

/// Subject of a group of facts about a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Facts about the law of motion.
    Law,
    /// Facts about the drive, such as moved mass and speed.
    Drive,
    /// Facts about cam and follower.
    Cam,
    /// Facts about torque, power, lift-off and contact pressure.
    Machine,
}

impl Group {
    /// All groups, in the order of the console.
    pub const ALL: [Group; 4] = [Group::Law, Group::Drive, Group::Cam, Group::Machine];

    /// Identifier of the group, as in JSON keys.
    pub fn name(self) -> &'static str {
        match self {
            Group::Law => "law",
            Group::Drive => "drive",
            Group::Cam => "cam",
            Group::Machine => "machine",
        }
    }
}

/// Facts of a group; empty if the design has no such facts.
///
/// ```
/// use gaitcam_output::facts::{Group, facts};
/// use gaitcam_output::Language;
///
/// let scene = gaitcam::scene::built_in("footbridge")?.scene()?;
/// let design = gaitcam::synth::synthesise(&scene, scene.model_force()?.as_ref())?;
/// let cam = facts(&design, Group::Cam, Language::En);
/// assert!(cam.iter().any(|fact| fact.name == "base radius" && fact.value.ends_with(" mm")));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub fn facts(design: &Design, group: Group, language: Language) -> Vec<Fact> {
    let mut list = List {
        design,
        figures: Figures::of(design),
        words: words::words(language),
        facts: Vec::new(),
    };
    match group {
        Group::Law => list.law(),
        Group::Drive => list.drive(),
        Group::Cam => list.cam(),
        Group::Machine => list.machine(),
    }
    list.facts
}

/// One line with the facts of a group for the console; `None` if the console shows none of them.
pub fn line(design: &Design, group: Group, language: Language) -> Option<String> {
    let facts = facts(design, group, language);
    let part = |fact: &Fact| match fact.brief {
        Brief::Not => None,
        Brief::Whole => Some(format!("{} {}", fact.name, fact.value)),
        Brief::Value => Some(fact.value.clone()),
    };
    let parts: Vec<String> = facts.iter().filter_map(part).collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// Name of a design quantity in the language of `words`. `column` is its column name. The name can depend on the follower of the design.
pub(crate) fn label(design: &Design, column: &str, words: &Words) -> String {
    let label = |f: &Figure| f.label_on(&design.cam.follower, words.language());
    Figure::of_column(column).map_or(String::new(), label)
}

/// Sentence with the ratio of two peak responses of a lightly damped mode: the response to this cam at constant speed, divided by the
/// response to the recorded walk. `None` if fewer than eight strides are recorded.
pub fn resonance(design: &Design, language: Language) -> Option<String> {
    let walker = design.walker()?;
    let at = walker
        .resonance
        .iter()
        .find(|r| r.damping_ratio == SHOWN_DAMPING)?;
    let words = words::words(language);
    let (damping, ratio) = (
        words.number(100.0 * at.damping_ratio),
        words.fixed(at.ratio, 2),
    );
    let (strides, needed) = (
        walker.strides.to_string(),
        RepeatedForce::strides_for(at.damping_ratio).to_string(),
    );
    let key = match at.resolved {
        true => "resonance-severity",
        false => "resonance-severity-few",
    };
    let arguments = [
        ("damping", &*damping),
        ("ratio", &ratio),
        ("strides", &strides),
        ("needed", &needed),
    ];
    Some(words.fill(key, &arguments))
}

/// Column names and rows of the table that compares the responses at resonance to the recorded walk and to the cam.
pub fn at_resonance(walker: &OfWalker, language: Language) -> ([String; 4], Vec<[String; 4]>) {
    let words = words::words(language);
    let columns = [
        "report-resonance-damping",
        "report-resonance-recorded",
        "report-resonance-cam",
        "report-resonance-ratio",
    ];
    let rows = walker.resonance.iter().map(|at| {
        let damping = format!("{} %", words.number(100.0 * at.damping_ratio));
        let [recorded, cam] = [at.recorded, at.mean_stride].map(|x| words.number(x));
        let ratio = words.fixed(at.ratio, 2);
        let ratio = match at.resolved {
            true => ratio,
            false => format!("≥ {ratio}"),
        };
        [damping, recorded, cam, ratio]
    });
    (columns.map(|name| words.text(name)), rows.collect())
}

/// Force in a design as text with its unit. `column` is the design quantity that determines the number of digits. If the follower
/// oscillates, the value is a moment.
pub fn force(design: &Design, column: &str, value: f64, language: Language) -> String {
    let unit = design.cam.follower.measures().force();
    let digits = |f: &Figure| f.digits;
    let digits = Figure::of_column(column).map_or(gaitcam::wording::DIGITS, digits);
    unit.after(&rounded(language, unit.factor * value, digits))
}

/// RMS force error as a percentage of the mean force, as text without a unit.
pub fn error_percent(design: &Design, language: Language) -> String {
    let figure = Figure::of_column("force_rms_error_percent");
    let digits = figure.map_or(gaitcam::wording::DIGITS, |f| f.digits);
    rounded(language, design.force.rms_error_percent_of_mean, digits)
}

struct List<'a> {
    design: &'a Design,
    figures: Figures,
    words: Words,
    facts: Vec<Fact>,
}

impl List<'_> {
    fn put(&mut self, key: &'static str, value: String, brief: Brief) {
        let name = self.words.text(key);
        self.facts.push(Fact {
            name,
            value,
            key,
            brief,
        });
    }

    /// Adds a quantity that is not in the table of design quantities.
    fn quantity(&mut self, key: &'static str, unit: Unit, value: f64) {
        let value = unit.shown(value, self.words.language());
        self.put(key, value, Brief::Not);
    }

    /// Adds a design quantity as a fact, unless its value is undefined.
    fn figure(&mut self, column: &'static str, brief: Brief) {
        let Some(figure) = Figure::of_column(column) else {
            return;
        };
        let (value, measures) = (figure.value(&self.figures), self.measures());
        if value.is_nan() {
            return;
        }
        let language = self.words.language();
        let value = match column {
            "speed_rad_per_s" | "liftoff_speed_rad_per_s" => measures.speed_words(value, language),
            _ => figure.text(value, measures, language),
        };
        let name = label(self.design, column, &self.words);
        self.facts.push(Fact {
            name,
            value,
            key: column,
            brief,
        });
    }

    fn measures(&self) -> Measures {
        self.design.cam.follower.measures()
    }

    fn law(&mut self) {
        let (design, measures) = (self.design, self.measures());
        let law = &design.cam.law;
        self.put(
            "report-family",
            self.words.name(design.family.name()),
            Brief::Value,
        );
        // A harmonic law has no degree and no spans.
        if design.degree > 0 {
            self.put("report-degree", design.degree.to_string(), Brief::Whole);
            let pieces = law.poly().pieces();
            let brief = if pieces > 1 { Brief::Whole } else { Brief::Not };
            self.put("report-pieces", pieces.to_string(), brief);
        }
        self.figure("stroke_m", Brief::Whole);
        let names = [
            ["report-velocity", "report-velocity-time"],
            ["report-acceleration", "report-acceleration-time"],
            ["report-jerk", "report-jerk-time"],
        ];
        for (name, order) in names.into_iter().zip(1..) {
            let (low, high) = law.extremes(order);
            let rate = design.problem.drive.speed.powi(order as i32);
            let units = [(measures.lift(order), 1.0), (measures.by_time(order), rate)];
            for (name, (unit, rate)) in name.into_iter().zip(units) {
                let scale = unit.factor * rate;
                let ends = self.words.range(scale * low.value, scale * high.value);
                self.put(name, unit.after(&ends), Brief::Not);
            }
        }
    }

    fn drive(&mut self) {
        let (d, measures) = (&self.design.problem.drive, self.measures());
        self.put(
            "report-machine",
            self.words.name(d.kind.name()),
            Brief::Value,
        );
        if d.mass != 0.0 {
            self.figure("mass_kg", Brief::Whole);
        }
        self.figure("speed_rad_per_s", Brief::Whole);
        let (round, way) = match measures {
            Measures::Straight => ("report-one-pass", self.design.cam.law.extent().1),
            _ => ("report-one-turn", std::f64::consts::TAU),
        };
        let seconds = self.words.number(way / d.speed.abs());
        self.put(round, format!("{seconds} s"), Brief::Not);
        let at_rest = match measures {
            Measures::Oscillating => "report-moment-at-rest",
            _ => "report-force-at-rest",
        };
        self.quantity(at_rest, measures.force(), d.rest_force);
        if d.spring_rate != 0.0 {
            let name = match d.kind {
                DriveKind::Hydraulic => "report-column",
                _ => "report-spring",
            };
            self.quantity(name, measures.spring_rate(), d.spring_rate);
        }
        if d.damping != 0.0 {
            self.quantity("report-damping", measures.damping(), d.damping);
        }
    }

    fn cam(&mut self) {
        let cam = &self.design.cam;
        let (follower, curvature) = (&cam.follower, cam.curvature());
        let name = self.words.name(follower.name());
        self.put("report-follower", name, Brief::Value);
        self.figure("base_radius_m", Brief::Whole);
        if follower.roller_radius() > 0.0 {
            if !follower.is_unrolled() {
                self.figure("prime_radius_m", Brief::Whole);
            }
            let radius = self.words.length(follower.roller_radius());
            self.put("report-roller-radius", radius, Brief::Not);
            if follower.measures() == Measures::Translating && !follower.is_unrolled() {
                let brief = match follower.offset() {
                    0.0 => Brief::Not,
                    _ => Brief::Whole,
                };
                self.figure("offset_m", brief);
            }
        }
        if let Some([least, most]) = self.figures.radii {
            let unit = Unit::length();
            let least = self.words.number(unit.factor * least);
            let radii = format!("{least} … {}", self.words.length(most));
            self.put("report-profile-radii", radii, Brief::Whole);
        }
        self.figure("rho_min_m", Brief::Whole);
        let at = follower
            .measures()
            .place(curvature.convex.at, self.words.language());
        self.put("report-found-at", at, Brief::Not);
        if let Some(concave) = curvature.concave {
            let radius = self.words.length(-concave.value);
            self.put("report-concave-radius", radius, Brief::Not);
        }
        if cam.face_width().is_some() {
            self.figure("face_width_m", Brief::Not);
        } else {
            let (low, high) = self.design.pressure_angle_extremes();
            let [low, high] = [low, high].map(|end| self.words.degrees(end.value));
            self.put(
                "report-pressure-angle",
                format!("{low} … {high}"),
                Brief::Not,
            );
        }
    }

    /// Adds torque, power, lift-off speed and contact pressure, if they are defined.
    fn machine(&mut self) {
        self.figure("torque_max_n_m", Brief::Whole);
        self.figure("torque_rms_n_m", Brief::Whole);
        self.figure("power_max_w", Brief::Whole);
        // Without friction, the mean power is only a rounding error.
        let power = &mut self.figures.machine;
        if let Some((mean, most)) = power.power_mean_w.zip(power.power_max_w) {
            power.power_mean_w = Some(if mean.abs() < 1e-9 * most { 0.0 } else { mean });
        }
        self.figure("power_mean_w", Brief::Not);
        self.figure("liftoff_speed_rad_per_s", Brief::Whole);
        let pressure = self.figures.machine.hertz_pressure_max_pa;
        if pressure.is_some_and(f64::is_finite) {
            self.figure("hertz_pressure_max_pa", Brief::Whole);
        }
        let cam = &self.design.problem.cam;
        let Some(borne) = cam.allowable_pressure().filter(|_| !self.design.is_idle()) else {
            return;
        };
        // The allowable pressure of the materials is shown with the safety factor.
        let of_hardness = cam.making.hardness;
        let of_hardness = of_hardness.filter(|h| h.allowable_pressure() == borne);
        let margin = pressure.filter(|p| *p > 0.0);
        let margin = margin.map_or(f64::INFINITY, |p| borne / p);
        let arguments = [
            ("pressure", &*self.words.number(1e-6 * borne)),
            (
                "hardness",
                &of_hardness.map_or_else(String::new, |h| h.to_string()),
            ),
            ("margin", &self.words.number(margin)),
        ];
        let key = match of_hardness {
            Some(_) => "report-hertz-borne",
            None => "report-material-borne",
        };
        let value = self.words.fill(key, &arguments);
        self.put("report-hertz-allowable", value, Brief::Whole);
    }
}
