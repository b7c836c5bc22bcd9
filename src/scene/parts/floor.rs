//! `[machine.floor]` and `[machine.walkers]`: the structure under the feet, and the walkers on it.

use std::f64::consts::TAU;

use gaitcam_base::random::Sequence;

use crate::dynamics::FloorMode;
use crate::units::{Dimension, parse};

/// Vibration mode of the structure under the feet.
///
/// ```
/// use gaitcam::scene;
///
/// let text = "machine.floor = { mass = \"40000 kg\", frequency = \"1.9 Hz\", damping = 0.005 }";
/// let scene = scene::read_keys(&text.parse()?)?;
/// assert_eq!((scene.machine.floor.mass, scene.machine.floor.ordinate), (Some(4e4), 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FloorSpec {
    /// Modal mass of the mode, kg.
    pub mass: Option<f64>,
    /// Natural frequency of the mode, Hz.
    pub frequency: Option<f64>,
    /// Damping ratio of the mode, relative to critical damping.
    pub damping: Option<f64>,
    /// Ordinate of the mode shape at the feet, in the normalisation to which the modal mass belongs; 1 by default.
    pub ordinate: f64,
}

impl Default for FloorSpec {
    fn default() -> FloorSpec {
        FloorSpec {
            mass: None,
            frequency: None,
            damping: None,
            ordinate: 1.0,
        }
    }
}

impl FloorSpec {
    pub(super) fn mode(&self, key: &'static str) -> Option<FloorMode> {
        Some(FloorMode {
            mass: self.mass?,
            frequency: self.frequency?,
            damping: self.damping?,
            ordinate: self.ordinate,
            key,
        })
    }

    pub(super) fn is_given(&self) -> bool {
        self.mass.is_some() || self.frequency.is_some() || self.damping.is_some()
    }
}

/// Number, phases and weights of the walkers on the structure.
///
/// ```
/// use gaitcam::scene;
///
/// let scene = scene::read_keys(&"machine.walkers.count = 3".parse()?)?;
/// assert!(scene.machine.walkers.phases.is_empty()); // drawn
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct WalkersSpec {
    /// Number of walkers. The shaker counts as the first walker.
    pub count: usize,
    /// Phases of the walkers, starting with the shaker. If the list is empty, the phases are random.
    pub phases: Vec<String>,
    /// Weights of the walkers, starting with the shaker. Only their ratios have an effect. If the list is empty, the weights are equal.
    pub weights: Vec<String>,
}

impl Default for WalkersSpec {
    fn default() -> WalkersSpec {
        WalkersSpec {
            count: 1,
            phases: Vec::new(),
            weights: Vec::new(),
        }
    }
}

impl WalkersSpec {
    /// Phases of the walkers, rad; `None` if the texts are invalid. Random phases are the same in every run.
    pub(super) fn angles(&self) -> Option<Vec<f64>> {
        if self.phases.is_empty() {
            let mut random = Sequence::new(0);
            let drawn = (1..self.count).map(|_| TAU * random.next_unit());
            return Some([0.0].into_iter().chain(drawn).collect());
        }
        self.listed(&self.phases, Dimension::Angle)
    }

    /// Weights of the walkers, relative to the shaker; `None` if the texts are invalid.
    pub(super) fn parts(&self) -> Option<Vec<f64>> {
        if self.weights.is_empty() {
            return Some(vec![1.0; self.count]);
        }
        let weights = self.listed(&self.weights, Dimension::Force)?;
        let sound = weights.iter().all(|w| w.is_finite() && *w > 0.0);
        sound.then(|| weights.iter().map(|w| w / weights[0]).collect())
    }

    /// Parses a list that must contain one quantity for each walker.
    fn listed(&self, texts: &[String], dimension: Dimension) -> Option<Vec<f64>> {
        let mut numbers = Vec::new();
        for text in texts.iter().flat_map(|text| text.split(',')) {
            numbers.push(parse(text.trim(), dimension).ok()?);
        }
        (numbers.len() == self.count).then_some(numbers)
    }
}
