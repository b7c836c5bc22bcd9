//! Means of cycles and of stances at equal phases.

use std::f64::consts::FRAC_PI_2;

use crate::curve::SAMPLES;
use crate::recording::{Channel, Recording};
use crate::stance::Stance;
use crate::statistics::mean;

/// Maximum time before heel strike and after toe-off, s, in which the force of a foot is above zero but below the contact threshold.
const TAIL_S: f64 = 0.06;
/// Fraction of a stance by which a mean stance extends beyond both ends, to include the force below the threshold.
pub(super) const MARGIN: f64 = 0.12;

/// Fraction of a stride at each end that is blended with the adjacent strides.
pub(crate) const BLEND: f64 = 0.04;

/// Force, N, at a position in samples, by linear interpolation.
pub(super) fn at(force: &[f64], place: f64) -> f64 {
    // The conversion uses i64, because the processor has no instruction that converts to unsigned numbers.
    let i = (place.max(0.0) as i64 as usize).min(force.len().saturating_sub(2));
    let (Some(&a), Some(&b)) = (force.get(i), force.get(i + 1)) else {
        return force.first().copied().unwrap_or(0.0);
    };
    let x = (place - i as f64).clamp(0.0, 1.0);
    a + x * (b - a)
}

/// Maximum duration of a stance, in strides. In walking, a stance is shorter than a stride.
const MOST_TURNS: usize = 5;

/// Running mean and running sum of squared deviations at each phase (Welford's method), so that cycles need not be stored.
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

    /// Mean at each phase, and for two or more cycles the standard deviation.
    pub fn finish(self) -> (Vec<f64>, Option<Vec<f64>>) {
        let degrees = self.count - 1.0;
        let spread =
            (degrees > 0.0).then(|| self.squares.iter().map(|s| (s / degrees).sqrt()).collect());
        (self.mean, spread)
    }
}

/// Start and end of a contact, s, including the force below the threshold on both sides, down to the unloaded level.
///
/// The threshold detects the contact, but the small force before and after it is part of the gait.
pub(super) fn whole_span(channel: &Channel, rate_hz: f64, start_s: f64, end_s: f64) -> (f64, f64) {
    let force = &channel.force_n;
    let last = force.len().saturating_sub(1);
    if !channel.rows.is_empty() {
        return (start_s, end_s);
    }
    let most = (TAIL_S * rate_hz) as usize;
    let floor = 2.0 * channel.noise_n;
    let goes_on = |inner: usize, outer: usize| force[inner] > floor && force[outer] < force[inner];
    let mut first = ((start_s * rate_hz).floor() as usize).min(last);
    let mut steps = 0;
    while first > 0 && steps < most && goes_on(first, first - 1) {
        first -= 1;
        steps += 1;
    }
    let mut end = ((end_s * rate_hz).ceil() as usize).min(last);
    steps = 0;
    while end < last && steps < most && goes_on(end, end + 1) {
        end += 1;
        steps += 1;
    }
    (
        (first as f64 / rate_hz).min(start_s),
        (end as f64 / rate_hz).max(end_s),
    )
}

/// Fills `row` with one cycle of a force that need not be exactly periodic.
///
/// Within `half_s` of its ends, the cycle is blended with the force one cycle later or earlier. The row is then continuous at its ends, and
/// every sample of the force has the same weight.
pub(crate) fn periodic(
    row: &mut [f64],
    start_s: f64,
    length_s: f64,
    half_s: f64,
    force: impl Fn(f64) -> f64,
) {
    let step = length_s / row.len() as f64;
    let weight = |inside: f64| 0.5 * (1.0 + libm::sin(FRAC_PI_2 * inside / half_s));
    for (i, x) in row.iter_mut().enumerate() {
        let since = i as f64 * step;
        let t = start_s + since;
        let left = length_s - since;
        *x = if since < half_s {
            let w = weight(since);
            w * force(t) + (1.0 - w) * force(t + length_s)
        } else if left < half_s {
            let w = weight(left);
            w * force(t) + (1.0 - w) * force(t - length_s)
        } else {
            force(t)
        };
    }
}

/// Mean of several stances at equal phases of the stance.
pub(super) struct MeanStance {
    pub count: usize,
    pub duration_s: f64,
    pub impulse_ns: f64,
    /// Force, N, at equal time steps. The samples begin before heel strike and end after toe-off, in both cases by the fraction `margin` of
    /// a stance.
    pub force: Vec<f64>,
    pub margin: f64,
    pub spread: Option<Vec<f64>>,
}

/// Mean mass of the stances, kg; `None` if a stance has no mass.
pub(super) fn mean_mass(stances: &[&Stance]) -> Option<f64> {
    let masses: Option<Vec<f64>> = stances.iter().map(|s| s.mass_kg).collect();
    masses.map(|m| mean(&m))
}

/// Averages stances. If every stance has a mass, the forces are averaged in body weights and scaled to the mean mass.
pub(super) fn mean_stance(recording: &Recording, stances: &[&Stance], margin: f64) -> MeanStance {
    let usual = mean_mass(stances);
    let mut mean = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    let (mut duration, mut impulse) = (0.0, 0.0);
    for s in stances {
        stance_row(recording, s, usual, margin, &mut row);
        mean.add(&row);
        let stance_s = s.end_s - s.start_s;
        duration += stance_s;
        let mean_n = row.iter().sum::<f64>() / (row.len() - 1) as f64;
        impulse += mean_n * stance_s * (1.0 + 2.0 * margin);
    }
    let n = stances.len();
    let (force, spread) = mean.finish();
    MeanStance {
        count: n,
        duration_s: duration / n as f64,
        impulse_ns: impulse / n as f64,
        force,
        margin,
        spread,
    }
}

/// Fills `row` with one stance at equal phases, scaled to the `usual` mass, kg. The row extends beyond both ends of the stance by the
/// fraction `margin` of the stance.
pub(super) fn stance_row(
    recording: &Recording,
    stance: &Stance,
    usual: Option<f64>,
    margin: f64,
    row: &mut [f64],
) {
    let scale = match (usual, stance.mass_kg) {
        (Some(u), Some(m)) => u / m,
        _ => 1.0,
    };
    let channel = &recording.channels[stance.channel];
    let rate = recording.rate_hz;
    let duration = stance.end_s - stance.start_s;
    let (from, to) = whole_span(channel, rate, stance.start_s, stance.end_s);
    let step = (1.0 + 2.0 * margin) * duration / (row.len() - 1) as f64;
    for (i, x) in row.iter_mut().enumerate() {
        let t = stance.start_s - margin * duration + i as f64 * step;
        // Rounding errors at the ends of the stance do not exclude a sample.
        let inside = t > from - 1e-9 * duration && t < to + 1e-9 * duration;
        *x = if inside {
            scale * at(&channel.force_n, t * rate)
        } else {
            0.0
        };
    }
}

/// Adds a mean stance to a stride with the duration `period`, s. The stance starts at the fraction `shift` of the stride.
pub(super) fn place(
    stance: &MeanStance,
    period: f64,
    shift: f64,
    force: &mut [f64],
    variance: &mut [f64],
) {
    let n = force.len() as f64;
    for i in 0..force.len() {
        // Times of the stance at the phase of this sample. A stance may extend beyond the end of the stride.
        let phase = (i as f64 / n - shift).rem_euclid(1.0);
        let reach = stance.margin * stance.duration_s;
        let mut t = (phase - 1.0) * period;
        let mut turns = 0;
        while t <= stance.duration_s + reach && turns < MOST_TURNS {
            if t >= -reach {
                let place = (t + reach) / (stance.duration_s + 2.0 * reach) * (SAMPLES - 1) as f64;
                force[i] += at(&stance.force, place);
                if let Some(s) = &stance.spread {
                    variance[i] += at(s, place).powi(2);
                }
            }
            t += period;
            turns += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spread_of_cycles_is_the_sample_deviation_at_each_phase() {
        let mut mean = Mean::new();
        for x in [1.0, 2.0, 6.0] {
            mean.add(&[x, -10.0 * x, 5.0]);
        }
        let (middle, spread) = mean.finish();
        let spread = spread.unwrap();
        for (k, (m, s)) in [(3.0, 7.0), (-30.0, 700.0), (5.0, 0.0_f64)]
            .into_iter()
            .enumerate()
        {
            assert!(
                (middle[k] - m).abs() < 1e-14 && (spread[k] - s.sqrt()).abs() < 1e-14,
                "{k}"
            );
        }
        let mut one = Mean::new();
        one.add(&[4.0]);
        assert_eq!(one.finish().1, None);
    }

    #[test]
    fn a_contact_reaches_down_to_its_noise_and_sixty_milliseconds_at_most() {
        // At 1 kHz, the force rises by 1 N per sample from 0.1 s and falls by 1 N per sample until 0.5 s. The noise is 2 N.
        let ramps = (0..600).map(|i: i32| f64::from((i - 100).min(500 - i).clamp(0, 150)));
        let mut channel = Channel {
            force_n: ramps.collect(),
            noise_n: 1.0,
            ..Channel::default()
        };
        let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs().max((a.1 - b.1).abs()) < 1e-12;
        assert!(near(
            whole_span(&channel, 1000.0, 0.12, 0.48),
            (0.102, 0.498)
        ));
        assert!(near(whole_span(&channel, 1000.0, 0.18, 0.42), (0.12, 0.48)));
        channel.rows.push(crate::recording::Row {
            from: 0,
            to: 600,
            mass_kg: None,
        });
        assert_eq!(whole_span(&channel, 1000.0, 0.18, 0.42), (0.18, 0.42));
    }
}
