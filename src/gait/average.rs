//! Means on phase: of cycles, and of stances on their own phase.

use super::models::SAMPLES;
use super::recording::Recording;
use super::stance::Stance;

/// Force at a place between samples, by a straight line.
pub(super) fn at(force: &[f64], place: f64) -> f64 {
    let i = (place.max(0.0) as usize).min(force.len().saturating_sub(2));
    let (Some(&a), Some(&b)) = (force.get(i), force.get(i + 1)) else {
        return force.first().copied().unwrap_or(0.0);
    };
    let x = (place - i as f64).clamp(0.0, 1.0);
    a + x * (b - a)
}

/// Strides that one stance may reach over; in walking it is less than one.
const MOST_TURNS: usize = 4;

/// Running mean and sum of squared deviations per phase (Welford), so that no cycle is kept.
pub(super) struct Mean {
    count: f64,
    mean: Vec<f64>,
    squares: Vec<f64>,
}

impl Mean {
    pub fn new() -> Self {
        Mean {
            count: 0.0,
            mean: vec![0.0; SAMPLES],
            squares: vec![0.0; SAMPLES],
        }
    }

    pub fn add(&mut self, row: &[f64]) {
        self.count += 1.0;
        for ((m, s), x) in self.mean.iter_mut().zip(&mut self.squares).zip(row) {
            let d = x - *m;
            *m += d / self.count;
            *s += d * (x - *m);
        }
    }

    /// Mean and, of two or more, standard deviation.
    pub fn finish(self) -> (Vec<f64>, Option<Vec<f64>>) {
        let degrees = self.count - 1.0;
        let spread =
            (degrees > 0.0).then(|| self.squares.iter().map(|s| (s / degrees).sqrt()).collect());
        (self.mean, spread)
    }
}

/// The mean stance of some stances on its own phase.
pub(super) struct MeanStance {
    pub count: usize,
    pub duration_s: f64,
    pub impulse_ns: f64,
    pub force: Vec<f64>,
    pub spread: Option<Vec<f64>>,
}

/// Averages stances; where each has its own mass, in body weights, then scaled to the mean mass.
pub(super) fn mean_stance(recording: &Recording, stances: &[&Stance]) -> MeanStance {
    let masses: Option<Vec<f64>> = stances.iter().map(|s| s.mass_kg).collect();
    let usual = masses
        .as_ref()
        .map(|m| m.iter().sum::<f64>() / m.len() as f64);
    let mut mean = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    let (mut duration, mut impulse) = (0.0, 0.0);
    for s in stances {
        let scale = stance_row(recording, s, usual, &mut row);
        mean.add(&row);
        duration += s.end_s - s.start_s;
        impulse += scale * s.impulse_ns;
    }
    let n = stances.len();
    let (force, spread) = mean.finish();
    MeanStance {
        count: n,
        duration_s: duration / n as f64,
        impulse_ns: impulse / n as f64,
        force,
        spread,
    }
}

/// Fills `row` with one stance at equal phases, scaled to the `usual` mass; the scale.
pub(super) fn stance_row(
    recording: &Recording,
    stance: &Stance,
    usual: Option<f64>,
    row: &mut [f64],
) -> f64 {
    let scale = match (usual, stance.mass_kg) {
        (Some(u), Some(m)) => u / m,
        _ => 1.0,
    };
    let force = &recording.channels[stance.channel].force_n;
    let step = (stance.end_s - stance.start_s) / (row.len() - 1) as f64;
    for (i, x) in row.iter_mut().enumerate() {
        *x = scale
            * at(
                force,
                (stance.start_s + i as f64 * step) * recording.rate_hz,
            );
    }
    scale
}

/// Adds a stance to a stride of `period` s, starting at phase `shift`.
pub(super) fn place(
    stance: &MeanStance,
    period: f64,
    shift: f64,
    force: &mut [f64],
    variance: &mut [f64],
) {
    let n = force.len() as f64;
    for i in 0..force.len() {
        // Phases of the stride at which this sample falls into the stance: a stance may reach past the wrap.
        let phase = (i as f64 / n - shift).rem_euclid(1.0);
        let mut t = phase * period;
        let mut turns = 0;
        while t <= stance.duration_s && turns < MOST_TURNS {
            let place = t / stance.duration_s * (SAMPLES - 1) as f64;
            force[i] += at(&stance.force, place);
            if let Some(s) = &stance.spread {
                variance[i] += at(s, place).powi(2);
            }
            t += period;
            turns += 1;
        }
    }
}
