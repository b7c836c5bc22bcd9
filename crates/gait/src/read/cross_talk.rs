//! Cross-talk: a small share of the force on one plate that also appears in the readings of another plate.
//!
//! While a plate is unloaded, its readings depend on the force on the other plate: reading = level + share · force. The level and the share
//! are determined by least squares, and the share of the force is subtracted.

use crate::quantity::share;
use crate::recording::{Channel, Note};
use crate::statistics::{ends, mean_and_deviation};

/// Fraction of the maximum force below which a plate is unloaded, and time, s, that is omitted before and after each contact.
const UNLOADED: (f64, f64) = (0.15, 0.06);
/// Range of shares that count as cross-talk.
const SHARES: std::ops::RangeInclusive<f64> = 0.012..=0.15;
/// Minimum fraction of the variance of the readings that the cross-talk explains.
const EXPLAINED: f64 = 0.3;
const SHORTEST_S: f64 = 0.5;
/// Minimum standard deviation of the force on the other plate, as a fraction of its maximum. In single support, the force varies by about
/// this value.
const VARIES: f64 = 0.03;
/// Maximum number of plates for which all pairs are examined.
const MOST_PLATES: usize = 12;
const MOST_READINGS: usize = 1 << 15;

/// Share of the force on plate `of` in the readings of another plate, and the unloaded level of that other plate.
struct Share {
    of: usize,
    share: f64,
    level_n: f64,
    readings: usize,
}

/// Subtracts cross-talk from the channels, and adds a note for each subtracted share.
pub(super) fn remove(channels: &mut [Channel], rate_hz: f64, notes: &mut Vec<Note>) {
    let live: Vec<usize> = (0..channels.len())
        .filter(|&i| channels[i].idle.is_none())
        .collect();
    if live.len() < 2 || live.len() > MOST_PLATES {
        return;
    }
    let unloaded: Vec<Vec<bool>> = channels.iter().map(|c| unloaded(c, rate_hz)).collect();
    let shares = |i: usize| -> Vec<Share> {
        let others = live.iter().filter(|j| **j != i);
        others
            .filter_map(|&j| found(channels, &unloaded, [i, j], rate_hz))
            .collect()
    };
    let all: Vec<Vec<Share>> = (0..channels.len())
        .map(|i| {
            if live.contains(&i) {
                shares(i)
            } else {
                Vec::new()
            }
        })
        .collect();
    if all.iter().all(Vec::is_empty) {
        return;
    }
    let mut clean: Vec<Vec<f64>> = channels.iter().map(|c| c.force_n.clone()).collect();
    // The force on the other plate may also contain cross-talk. The second iteration uses the corrected force.
    for _ in 0..2 {
        let before = clean.clone();
        for (i, shares) in all.iter().enumerate() {
            let Some(widest) = shares.iter().max_by_key(|s| s.readings) else {
                continue;
            };
            for (k, x) in clean[i].iter_mut().enumerate() {
                let of = |s: &Share| s.share * before[s.of].get(k).copied().unwrap_or(0.0);
                *x = channels[i].force_n[k] - widest.level_n - shares.iter().map(of).sum::<f64>();
            }
        }
    }
    for (i, shares) in all.iter().enumerate() {
        let Some(widest) = shares.iter().max_by_key(|s| s.readings) else {
            continue;
        };
        let quiet = clean[i]
            .iter()
            .zip(&unloaded[i])
            .filter(|(_, quiet)| **quiet);
        let quiet: Vec<f64> = quiet.map(|(x, _)| *x).collect();
        let column = channels[i].name.clone();
        notes.retain(|n| !matches!(n, Note::UnloadedDiffers { column: c, .. } if *c == column));
        notes.extend(shares.iter().map(|s| Note::CrossTalkRemoved {
            column: column.clone(),
            of: channels[s.of].name.clone(),
            share: share(s.share),
        }));
        channels[i].force_n = std::mem::take(&mut clean[i]);
        channels[i].baseline_n += widest.level_n;
        channels[i].noise_n = mean_and_deviation(&quiet).1;
    }
}

/// For each sample, whether the plate is certainly unloaded.
fn unloaded(channel: &Channel, rate_hz: f64) -> Vec<bool> {
    let force = &channel.force_n;
    let top = ends(force).map_or(0.0, |(_, top)| top);
    let reach = (UNLOADED.1 * rate_hz).ceil() as usize;
    let mut quiet = vec![true; force.len()];
    let mut from = 0;
    for i in (0..force.len()).filter(|&i| force[i] > UNLOADED.0 * top) {
        let to = (i + reach + 1).min(force.len());
        quiet[from.max(i.saturating_sub(reach))..to].fill(false);
        from = to;
    }
    quiet
}

/// Share of the force on plate `j` in the readings of plate `i`. It is determined from the samples at which all plates except `j` are
/// unloaded. `None` if the readings do not follow the force on `j`.
fn found(
    channels: &[Channel],
    unloaded: &[Vec<bool>],
    [i, j]: [usize; 2],
    rate_hz: f64,
) -> Option<Share> {
    let (own, other) = (&channels[i].force_n, &channels[j].force_n);
    let third = (0..channels.len()).filter(|k| ![i, j].contains(k) && channels[*k].idle.is_none());
    let third: Vec<usize> = third.collect();
    let alone = |k: &usize| unloaded[i][*k] && third.iter().all(|t| unloaded[*t][*k]);
    let step = own.len() / MOST_READINGS + 1;
    let places: Vec<usize> = (0..own.len().min(other.len()))
        .step_by(step)
        .filter(alone)
        .collect();
    let readings = places.len() * step;
    if (readings as f64) < SHORTEST_S * rate_hz || places.len() < 10 {
        return None;
    }
    let x: Vec<f64> = places.iter().map(|&k| other[k]).collect();
    let y: Vec<f64> = places.iter().map(|&k| own[k]).collect();
    let [(mean_x, spread_x), (mean_y, spread_y)] = [&x, &y].map(|v| mean_and_deviation(v));
    let top = ends(other).map_or(0.0, |(_, top)| top);
    let pairs = x.iter().zip(&y);
    let product = pairs.map(|(x, y)| (x - mean_x) * (y - mean_y)).sum::<f64>() / x.len() as f64;
    // The force of the other plate must vary sufficiently in these readings.
    if spread_x < VARIES * top || spread_y == 0.0 {
        return None;
    }
    let share = product / (spread_x * spread_x);
    let explained = (product / (spread_x * spread_y)).powi(2);
    let is_found = SHARES.contains(&share) && explained > EXPLAINED;
    is_found.then_some(Share {
        of: j,
        share,
        level_n: mean_y - share * mean_x,
        readings,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Stances of 0.6 s in strides of 1 s at 200 Hz, from a given time, with a peak of 800 N.
    fn foot(from_s: f64) -> Vec<f64> {
        let at = |i: i32| {
            let t = (f64::from(i) / 200.0 - from_s).rem_euclid(1.0) / 0.6;
            if t < 1.0 { 800.0 * (PI * t).sin() } else { 0.0 }
        };
        (0..2000).map(at).collect()
    }

    #[test]
    fn the_share_of_the_other_plate_is_subtracted_and_only_that() {
        let (left, right) = (foot(0.0), foot(0.5));
        for (a, b, levels) in [
            (0.06, 0.04, [0.0, 0.0]),
            (0.03, 0.0, [-7.0, 12.0]),
            (0.0, 0.0, [3.0, -3.0]),
        ] {
            let sum = |x: &[f64], y: &[f64], share: f64, level: f64| -> Vec<f64> {
                x.iter()
                    .zip(y)
                    .map(|(x, y)| x + share * y + level)
                    .collect()
            };
            let mixed = [
                sum(&left, &right, a, levels[0]),
                sum(&right, &left, b, levels[1]),
            ];
            let mut channels = mixed.map(|force_n| Channel {
                force_n,
                ..Channel::default()
            });
            let mut notes = Vec::new();
            remove(&mut channels, 200.0, &mut notes);
            assert_eq!(notes.len(), [a, b].iter().filter(|s| **s > 0.0).count());
            for (channel, (truth, (share, level))) in channels.iter().zip(
                [&left, &right]
                    .into_iter()
                    .zip([(a, levels[0]), (b, levels[1])]),
            ) {
                let left_in = if share > 0.0 { 0.0 } else { level };
                let off = channel
                    .force_n
                    .iter()
                    .zip(truth)
                    .map(|(x, y)| (x - y - left_in).abs());
                assert!(off.fold(0.0, f64::max) < 0.7, "{a} {b}");
            }
        }
    }
}
