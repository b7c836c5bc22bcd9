//! Effects of limits on a design: active limits, gains from relaxing limits, conflicts.

use serde::{Serialize, Serializer};

use super::named::key_of;
use super::reason::{Reason, sentences};
use crate::cam::{Criterion, Measures, Unit};
use crate::error::NoDesignError;
use crate::synth::qp::Demand;
use crate::units::Dimension;
use crate::wording::{self, Language};

impl Infeasible {
    /// Names of the conflicting limits and conditions, as in `summary.json`.
    pub fn names(&self) -> Vec<String> {
        self.conflict.iter().map(|c| c.name()).collect()
    }

    /// Message on the conflict in the given language, with the suggested changes.
    pub fn sentence(&self, language: Language) -> String {
        sentences(&self.reasons, language)
    }

    /// The conflict as an error, for a scene without a law.
    pub(in crate::synth) fn no_law(&self) -> NoDesignError {
        let reason = serde_json::to_value(self.reasons.first()).unwrap_or_default();
        NoDesignError::NoLaw { reason }
    }

    /// Key of the scene for the conflicting conditions: `law.point`, `law.dwell`, or `law` if both kinds or neither are in conflict.
    pub(in crate::synth) fn key_of_demands(&self) -> &'static str {
        let named = |of: fn(&Demand) -> bool| {
            let of = |c: &Conflicting| matches!(c, Conflicting::Demand(d) if of(d));
            self.conflict.iter().any(of)
        };
        let points = named(|d| matches!(d, Demand::AtPoint { .. }));
        let dwells = named(|d| matches!(d, Demand::InDwell { .. }));
        match (points, dwells) {
            (true, false) => "law.point",
            (false, true) => "law.dwell",
            _ => "law",
        }
    }
}

/// Active limit of the law.
///
/// ```
/// use gaitcam::{LimitKind, scene};
/// use gaitcam::synth::synthesise;
///
/// // The target force requires a stroke above 40 mm, so the limit is active.
/// let scene = scene::built_in("footbridge")?.scene()?.with("limits.stroke", "40 mm")?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert!((design.cam.law.stroke() - 0.04).abs() < 1e-9);
/// assert!(design.binding.iter().any(|b| b.limit == LimitKind::Stroke && b.multiplier > 0.0));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Binding {
    /// Limit that is active.
    pub limit: Criterion,
    /// Multiplier: gain of the objective per unit by which the limit is relaxed, in SI units.
    pub multiplier: f64,
    /// Cam angle at which the limit is active, rad.
    #[serde(rename = "at_rad")]
    pub at: f64,
}

/// First-order gain from relaxing one limit by 1 %.
///
/// ```
/// use gaitcam::{LimitKind, scene};
/// use gaitcam::synth::synthesise;
///
/// // A stroke limit that is 1 % larger reduces the force error.
/// let scene = scene::built_in("footbridge")?.scene()?.with("limits.stroke", "40 mm")?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let easing = design.easing.iter().find(|e| e.limit == LimitKind::Stroke).unwrap();
/// assert!((easing.to / easing.from - 1.01).abs() < 1e-9);
/// assert!(easing.after < easing.before);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Easing {
    /// Limit, or given value of the scene, that is relaxed.
    pub limit: Criterion,
    /// Present value of the limit, in SI units.
    pub from: f64,
    /// Relaxed value of the limit, in SI units.
    pub to: f64,
    /// Quantity that the design minimises, to which the gain refers.
    pub objective: Minimised,
    /// Present value of this quantity, in SI units.
    pub before: f64,
    /// Value of this quantity with the relaxed limit, in SI units.
    pub after: f64,
}

/// Quantity that a design minimises.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Minimised {
    /// RMS force error of the law, N.
    RmsError,
    /// RMS force error with weighted phases, N.
    WeightedRmsError,
    /// Maximum force error, N.
    MaxError,
    /// Base radius for a flat face, otherwise prime radius, m.
    Radius,
    /// RMS of a derivative with respect to the cam angle, m/radᵏ.
    RmsDerivative(usize),
    /// Maximum absolute value of a derivative with respect to the cam angle, m/radᵏ.
    PeakDerivative(usize),
}

impl Minimised {
    /// Name of the quantity in `summary.json`.
    pub fn name(self) -> String {
        match self {
            Minimised::RmsError => "rms_error_n".to_string(),
            Minimised::WeightedRmsError => "weighted_rms_error_n".to_string(),
            Minimised::MaxError => "max_error_n".to_string(),
            Minimised::Radius => "radius_m".to_string(),
            Minimised::RmsDerivative(order) => format!("rms_derivative_{order}"),
            Minimised::PeakDerivative(order) => format!("peak_derivative_{order}"),
        }
    }
}

impl Serialize for Minimised {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

/// Member of an irreducible infeasible set.
///
/// ```
/// use gaitcam::synth::{Conflicting, Infeasible};
/// use gaitcam::LimitKind;
/// use gaitcam::criterion::Criterion;
///
/// let member = Conflicting::Limit(Criterion::Limit(LimitKind::Stroke));
/// assert_eq!(member.name(), "stroke");
/// let why = Infeasible { conflict: vec![member], relaxations: Vec::new(), reasons: Vec::new() };
/// assert_eq!(why.names(), ["stroke"]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Conflicting {
    /// A limit of the scene.
    Limit(Criterion),
    /// A condition on the law.
    Demand(Demand),
}

impl Conflicting {
    /// Name of the member in `summary.json`.
    pub fn name(self) -> String {
        match self {
            Conflicting::Limit(limit) => limit.name().to_string(),
            Conflicting::Demand(demand) => demand.name(),
        }
    }

    /// Name of the member in messages.
    pub fn sentence(self, language: Language) -> String {
        match self {
            Conflicting::Limit(limit) => wording::catalogue(language).name(limit.name()),
            Conflicting::Demand(demand) => wording::sentence(language, "demand", &demand),
        }
    }
}

impl Easing {
    /// Name of the minimised quantity in messages, its displayed unit, and the factor from SI units to this unit.
    pub fn in_words(&self, measures: Measures, language: Language) -> (String, &'static str, f64) {
        let unit = match self.objective {
            Minimised::RmsError | Minimised::WeightedRmsError | Minimised::MaxError => {
                measures.force()
            }
            Minimised::Radius => Unit::of(Dimension::Length),
            Minimised::RmsDerivative(order) | Minimised::PeakDerivative(order) => {
                measures.lift(order)
            }
        };
        let name = wording::catalogue(language).name(&self.objective.name());
        (name, unit.name, unit.factor)
    }
}

/// Reason why no cam satisfies the scene: conflict and suggested changes.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // A rise and fall by h = 20 mm within the duration T of a turn requires an acceleration of at least 16 h/T² (theory §1).
/// let scene = scene::built_in("camdas_03_flat")?.scene()?;
/// assert!(synthesise(&scene, None)?.infeasible.is_none());
/// let jerk = "limits.jerk=1 m/s^3";
/// let mut table = scene::built_in("footbridge")?.toml.parse().unwrap();
/// scene::set(&mut table, "law.point=[{ angle = \"0 deg\", lift = \"0 mm\" }, { angle = \"180 deg\", lift = \"20 mm\" }]")?;
/// scene::set(&mut table, &format!("limits.acceleration={} m/s^2", 0.9 * 16.0 * 0.02 * 1.85 * 1.85))?;
/// let scene = scene::read(&table)?;
/// let why = synthesise(&scene, scene.model_force()?.as_ref())?.infeasible.unwrap();
/// assert!(why.names().contains(&"acceleration".to_string()), "{jerk}: {:?}", why.names());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Infeasible {
    /// Limits or conditions that are infeasible together.
    pub conflict: Vec<Conflicting>,
    /// Sufficient change of each conflicting limit. It starts as the minimum change for which the other limits of the program are feasible.
    /// `relaxed` replaces it by a change with which the complete design passes.
    pub relaxations: Vec<Relaxation>,
    /// The conflict as reasons, with suggested changes.
    pub reasons: Vec<Reason>,
}

/// Change of one limit that is sufficient while all other limits are unchanged.
///
/// ```
/// use gaitcam::synth::synthesise;
/// use gaitcam::{LimitKind, scene};
///
/// // With a stroke of 30 mm, the force error exceeds 0.5 %. The suggested change is a sufficient stroke.
/// let scene = scene::built_in("footbridge")?.scene()?.with("limits.stroke", "30 mm")?;
/// let force = scene.model_force()?;
/// let design = synthesise(&scene, force.as_ref())?.relaxed();
/// let stroke = design.relaxations.iter().find(|r| r.limit == LimitKind::Stroke).unwrap();
/// assert_eq!((stroke.key, stroke.from), ("limits.stroke", 0.03));
/// assert!(stroke.to.unwrap() > 0.03 && stroke.to.unwrap() < 0.05);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Relaxation {
    /// Limit that is changed.
    pub limit: Criterion,
    /// Key of the limit, as used with `--set`.
    pub key: &'static str,
    /// Present value of the limit, in SI units.
    pub from: f64,
    /// Sufficient value, in SI units; `None` if no value of this limit alone is sufficient.
    pub to: Option<f64>,
}

impl Relaxation {
    /// Whether the change permits a larger force error.
    pub fn is_goal(&self) -> bool {
        matches!(
            self.limit,
            Criterion::Accuracy | Criterion::RmsError | Criterion::Band
        )
    }

    pub(in crate::synth) fn of(limit: Criterion, from: f64, to: Option<f64>) -> Relaxation {
        let key = key_of(limit);
        Relaxation {
            limit,
            key,
            from,
            to,
        }
    }
}
