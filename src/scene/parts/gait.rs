//! `[gait]`: the target force.

use std::path::PathBuf;

use super::harmonic::Harmonic;
use super::{Adjust, StepFrequencies};
use crate::error::{Error, Placed, Result};
use crate::force::{self, Feet, ForceCurve, FourierForce, Kind, OpenQuestion, ReadOptions, Walker};

/// Body weight, N, for which the load models were published.
const MODEL_WEIGHT: f64 = 700.0;

/// Source of the target force.
///
/// ```
/// use gaitcam::scene::{Gait, Source};
///
/// assert_eq!(Gait::model("young").source, Source::Model("young".to_string()));
/// assert_eq!(Gait::file("walk.csv").source, Source::File("walk.csv".into()));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A recording, or a file with one cycle. A relative path is searched first in the folder of the scene, then in the working directory.
    File(PathBuf),
    /// A published load model, given by its name.
    Model(String),
    /// Load factors given in the scene, for the harmonics 1, 2, … of the step frequency.
    Harmonics(Vec<Harmonic>),
}

impl Default for Source {
    /// A recording without a path: the caller provides the force together with the scene.
    fn default() -> Source {
        Source::File(PathBuf::new())
    }
}

/// Target force of a scene, and options for reading it.
///
/// ```
/// use gaitcam::scene::Gait;
///
/// let gait = Gait { step_frequency: Some(1.85), ..Gait::model("young") };
/// let force = gait.model_force()?.unwrap();
/// assert!((force.mean_n() - 700.0).abs() < 1e-9);
/// assert!((force.period_s - 1.0 / 1.85).abs() < 1e-15);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Gait {
    /// Source of the target force: a recording, a load model or load factors.
    pub source: Source,
    /// Number of steps per second for a load model, Hz; `None`: the usual frequency of the model.
    pub step_frequency: Option<f64>,
    /// Step frequencies of several walkers for a load model, in place of a single one.
    pub step_frequencies: Option<StepFrequencies>,
    /// Further files or folders with recordings of walkers.
    pub more_files: Vec<PathBuf>,
    /// Walkers that are excluded, given by file or by name.
    pub leave_out: Vec<String>,
    /// Quantities of the machine that are adjusted for each of several walkers; `None`: mass and speed, if the scene does not prescribe them.
    pub adjust: Option<Adjust>,
    /// Weight of the walker for a load model, N; `None`: 700 N.
    pub body_weight: Option<f64>,
    /// Name of the time column of a recording; `None`: the column is recognised.
    pub time: Option<String>,
    /// Names of the force columns of a recording; empty: the columns are recognised.
    pub force: Vec<String>,
    /// Unit of the force columns of a recording, as written.
    pub unit: Option<String>,
    /// Sampling rate of a recording, Hz.
    pub rate: Option<f64>,
    /// Mass of the walker of a recording, kg.
    pub mass: Option<f64>,
    /// Kind of movement in a recording; `None`: recognised from the recording.
    pub kind: Option<Kind>,
    /// Open questions about a recording that the user has accepted.
    pub accept: Vec<OpenQuestion>,
    /// Feet whose force is used.
    pub feet: Feet,
    /// Duration of the cycle, s, for a file that contains exactly one cycle. Stances are then not detected.
    pub period: Option<f64>,
    /// Angle of the turn that the file covers, rad. The force is zero in the rest of the turn.
    pub span: Option<f64>,
    /// RMS noise of the samples of a recording, N; `None`: estimated from samples of unloaded plates.
    pub noise: Option<f64>,
    /// Scaling of the target force to the mass on a moving axis.
    pub scale: ForceScale,
    /// Band about the target in which the force must be; `None`: no band, and the force error is minimised by default.
    pub band: Option<Band>,
    /// Ranges of the cycle in which the force error has another weight.
    pub weights: Vec<PhaseWeight>,
    /// Phase of the force cycle at cam angle 0.
    pub phase: Phase,
}

impl Gait {
    /// Target force from a recording, with default options.
    pub fn file(path: impl Into<PathBuf>) -> Gait {
        Gait::of(Source::File(path.into()))
    }

    /// Target force from a published load model, at its usual step frequency.
    pub fn model(name: &str) -> Gait {
        Gait::of(Source::Model(name.to_string()))
    }

    /// Target force that the caller provides together with the scene.
    #[must_use]
    pub fn given() -> Gait {
        Gait::default()
    }

    fn of(source: Source) -> Gait {
        Gait {
            source,
            ..Gait::default()
        }
    }

    /// Weight of the walker for a load model, N.
    pub fn model_weight(&self) -> f64 {
        self.body_weight.unwrap_or(MODEL_WEIGHT)
    }

    /// Options for reading the recording of the scene. `metadata` is the content of the table of subjects that belongs to a table of stances.
    ///
    /// # Errors
    ///
    /// A unit is unknown.
    pub fn read_options(&self, metadata: Option<Vec<u8>>) -> Result<ReadOptions> {
        let at = |e: Error| e.at_key("gait.unit");
        let unit = self.unit.as_deref().map(|u| u.parse().map_err(at));
        Ok(ReadOptions {
            time: self.time.clone(),
            force: self.force.clone(),
            unit: unit.transpose()?,
            rate_hz: self.rate,
            mass_kg: self.mass,
            kind: self.kind,
            period_s: self.period,
            span_rad: self.span,
            noise_n: self.noise,
            metadata,
        })
    }

    /// Force of the load model or of the load factors in the scene. `None` for a recording, which the caller reads.
    ///
    /// # Errors
    ///
    /// An unknown model; a frequency or weight outside its range.
    pub fn model_force(&self) -> Result<Option<ForceCurve>> {
        self.force_of_weight(self.model_weight())
    }

    /// Force of the load model for a walker with another weight, N. With several step frequencies, the force is the mean of one walker for each
    /// frequency.
    pub(crate) fn force_of_weight(&self, weight: f64) -> Result<Option<ForceCurve>> {
        let Some(several) = self.step_frequencies else {
            return self.of_step(self.step_frequency, weight);
        };
        let walker = |(frequency, counts): (f64, f64)| {
            let curve = self.of_step(Some(frequency), weight)?;
            let title = format!("{} Hz", (1e4 * frequency).round() / 1e4);
            Ok(curve.map(|curve| Walker {
                weight: counts,
                ..Walker::new(&title, curve)
            }))
        };
        let walkers: Result<Option<Vec<Walker>>> =
            several.points().into_iter().map(walker).collect();
        walkers?.map(ForceCurve::of_walkers).transpose()
    }

    /// Force of one walker at a step frequency, Hz; `None`: the usual frequency of the model.
    fn of_step(&self, frequency: Option<f64>, weight: f64) -> Result<Option<ForceCurve>> {
        if let Some(series) = self.series(frequency, weight)? {
            return Ok(Some(series.curve()));
        }
        let Source::Model(name) = &self.source else {
            return Ok(None);
        };
        let force = force::model(name, frequency, weight, self.feet);
        force.map(Some).map_err(|e| e.at_key("gait.model"))
    }

    /// Fourier series of the force of one walker at a step frequency, Hz. `None` if only samples of the force are available.
    ///
    /// # Errors
    ///
    /// The errors of [`Gait::model_force`].
    pub(crate) fn series(
        &self,
        frequency: Option<f64>,
        weight: f64,
    ) -> Result<Option<FourierForce>> {
        let feet = self.feet;
        match &self.source {
            Source::Model(name) => {
                force::series(name, frequency, weight, feet).map_err(|e| e.at_key("gait.model"))
            }
            Source::Harmonics(list) => {
                let force = force::of_harmonics(&pairs(list), frequency, weight, feet);
                force.map(Some).map_err(|e| e.at_key("gait.harmonics"))
            }
            Source::File(_) => Ok(None),
        }
    }

    /// Whether the source of the force is a recording.
    pub fn is_recording(&self) -> bool {
        matches!(self.source, Source::File(_))
    }
}

/// Amplitude factor and phase of each harmonic, in the form of the load models.
fn pairs(list: &[Harmonic]) -> Vec<(f64, f64)> {
    list.iter().map(|h| (h.factor, h.phase)).collect()
}

/// Scaling of the target force to the mass on a moving axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, strum::IntoStaticStr, strum::VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum ForceScale {
    /// The force is not scaled.
    #[default]
    None,
    /// The force is multiplied by a constant so that its mean is M·g, with the mass M on the moving axis.
    ToMass,
    /// A constant is added to the force so that its mean is M·g. Only the alternating part is then compared.
    Alternating,
}

impl ForceScale {
    /// All methods of scaling, in the order of the reference page.
    pub const ALL: &'static [ForceScale] = <ForceScale as strum::VariantArray>::VARIANTS;

    /// Name of the method in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Half width of a band about the target force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Band {
    /// The step-to-step standard deviation of the force.
    Spread,
    /// A constant half width, N.
    Width(f64),
}

impl Band {
    /// The band for the moment of the force at a lever, m. A constant half width is multiplied by the lever.
    pub(crate) fn at_lever(self, lever: f64) -> Band {
        match self {
            Band::Spread => Band::Spread,
            Band::Width(width) => Band::Width(lever * width),
        }
    }
}

/// A range of the cycle, with the weight of its squared force error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PhaseWeight {
    /// Phase at the start of the range, rad.
    pub from: f64,
    /// Phase at the end of the range, rad. If it is smaller than `from`, the range continues at the start of the cycle.
    pub to: f64,
    /// Weight of the squared force error in the range. Outside all ranges, the weight is 1.
    pub weight: f64,
}

/// Phase of the force cycle at cam angle 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Phase {
    /// A phase given in the scene, rad.
    At(f64),
    /// The phase with the minimum force error.
    Free,
}

impl Default for Phase {
    fn default() -> Phase {
        Phase::At(0.0)
    }
}
