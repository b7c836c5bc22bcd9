//! Harmonics of a force, for `gait.harmonics` and `machine.learned_force`.

use crate::error::SceneError;
use crate::units::{Dimension, parse};

/// Harmonic i of a force: a sin(2π i f t + p). The amplitude is a, the phase is p, and f is the frequency of the first harmonic.
///
/// ```
/// use gaitcam::scene::Harmonic;
///
/// let list = Harmonic::list(&["0.4".to_string(), "10 % at -90 deg".to_string()])?;
/// assert_eq!(list[0], Harmonic { factor: 0.4, phase: 0.0 });
/// assert_eq!(list[1], Harmonic { factor: 0.1, phase: -std::f64::consts::FRAC_PI_2 });
/// # Ok::<(), gaitcam::error::SceneError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Amplitude: a load factor as a fraction of the weight, or for `machine.learned_force` a force, N.
    pub factor: f64,
    /// Phase added to the sine, rad.
    pub phase: f64,
}

impl Harmonic {
    /// Maximum number of harmonics. The samples of a cycle resolve many more.
    pub const MOST: usize = 50;

    /// Reads the harmonics 1, 2, … from texts such as "0.1 at -90 deg". A text may contain several harmonics, separated by commas.
    ///
    /// # Errors
    ///
    /// A text is not a factor with an optional phase; there are too many harmonics; all factors are zero.
    pub fn list(texts: &[String]) -> Result<Vec<Harmonic>, SceneError> {
        let mut list = Vec::new();
        for text in texts.iter().flat_map(|text| text.split(',')) {
            let typed = text.trim().to_string();
            list.push(Harmonic::read(&typed).ok_or(SceneError::NotHarmonic { typed })?);
        }
        if list.iter().all(|h| h.factor == 0.0) || list.len() > Harmonic::MOST {
            let (given, most) = (list.len(), Harmonic::MOST);
            return Err(SceneError::Harmonics { given, most });
        }
        Ok(list)
    }

    /// Reads the mean and the harmonics 1, 2, … of a force over the cam angle, N, from texts such as "3.2 N at -90 deg".
    ///
    /// # Errors
    ///
    /// A text is not a force with an optional phase; there are too many forces.
    pub fn forces(texts: &[String]) -> Result<Vec<Harmonic>, SceneError> {
        let (given, most) = (texts.len(), Harmonic::MOST);
        if given > most {
            return Err(SceneError::LearnedForces { given, most });
        }
        let force = |text: &String| {
            let typed = text.trim().to_string();
            let read = Harmonic::of(&typed, Dimension::Force);
            read.ok_or(SceneError::NotLearnedForce { typed })
        };
        texts.iter().map(force).collect()
    }

    fn read(text: &str) -> Option<Harmonic> {
        Harmonic::of(text, Dimension::Ratio).filter(|h| h.factor >= 0.0)
    }

    fn of(text: &str, dimension: Dimension) -> Option<Harmonic> {
        let (factor, phase) = match text.split_once(" at ") {
            Some((factor, phase)) => (factor, parse(phase.trim(), Dimension::Angle).ok()?),
            None => (text, 0.0),
        };
        let factor = parse(factor.trim(), dimension).ok()?;
        let sound = factor.is_finite() && phase.is_finite();
        sound.then_some(Harmonic { factor, phase })
    }
}
