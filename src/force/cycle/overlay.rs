//! Stances laid over each other on phase, with their mean and its band, for a picture.

use super::average::{mean_within, stance_row};
use crate::force::recording::{Foot, Recording};
use crate::force::stance::Stances;

/// Stances on their own phase: sample `i` of `n` stands at the fraction i/(n − 1) of the stance.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Foot and force, N, of the stances shown.
    pub stances: Vec<(Option<Foot>, Vec<f64>)>,
    /// Number of stances in the mean.
    pub count: usize,
    /// Mean of all used stances, N.
    pub mean_n: Vec<f64>,
    /// Standard deviation from stance to stance, N, where there are two or more.
    pub spread_n: Option<Vec<f64>>,
    /// Mean duration of a stance, s.
    pub duration_s: f64,
}

/// Lays the used stances over each other; `None` where there is none.
///
/// At most `most` of them are returned, evenly spread over the recording; the mean is of all. Where stances have
/// masses of their own, forces are scaled to the mean mass.
pub fn overlay(recording: &Recording, stances: &Stances, most: usize) -> Option<Overlay> {
    if stances.used.is_empty() {
        return None;
    }
    let all: Vec<_> = stances.used.iter().collect();
    let mean = mean_within(recording, &all, 0.0);
    let masses: Option<Vec<f64>> = all.iter().map(|s| s.mass_kg).collect();
    let usual = masses.map(|m| m.iter().sum::<f64>() / m.len() as f64);
    let shown = all.iter().step_by(all.len().div_ceil(most.max(1)));
    let curves = shown.map(|s| {
        let mut row = vec![0.0; mean.force.len()];
        stance_row(recording, s, usual, 0.0, &mut row);
        (s.foot, row)
    });
    Some(Overlay {
        stances: curves.collect(),
        count: mean.count,
        mean_n: mean.force,
        spread_n: mean.spread,
        duration_s: mean.duration_s,
    })
}
