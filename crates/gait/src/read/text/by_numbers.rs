//! Columns of a table without names: the time and the vertical forces are determined from the numbers.

use crate::recording::Foot;
use crate::statistics::sample;

/// Number of evenly distributed rows from which the columns are classified.
const SAMPLE: usize = 4096;

/// Maximum number of unnamed columns of plates: twelve plates with six values each. More columns are pressure sensors.
const MOST_VALUES: usize = 72;

/// Feet of the two force columns (left, right), if the table has the columns of insoles. These are the time, two sets with the same number
/// of sensors, and the sum of each set. Otherwise `None`.
///
/// The insole recordings of PhysioNet have this layout, with the left foot first.
pub(super) fn insole_sides(
    forces: &[usize],
    width: usize,
    time: Option<usize>,
) -> Option<[Foot; 2]> {
    let sensors = width.checked_sub(3)?;
    let is_layout = time == Some(0)
        && sensors >= 6
        && sensors.is_multiple_of(2)
        && forces == [width - 2, width - 1];
    is_layout.then_some([Foot::Left, Foot::Right])
}

/// Index of the time column. The first column is the time if at least 95 % of its steps do not decrease and at least 10 % increase.
pub(super) fn time_column(columns: &[Vec<f64>]) -> Option<usize> {
    let several = columns.len() >= 2;
    let t = columns.first().filter(|t| several && t.len() >= 2)?;
    let steps = t.len() - 1;
    let count = |holds: fn(&[f64]) -> bool| t.windows(2).filter(|w| holds(w)).count();
    let rises = 100 * count(|w| w[1] >= w[0]) >= 95 * steps;
    (rises && 10 * count(|w| w[1] > w[0]) >= steps).then_some(0)
}

/// Whether the times increase by exactly one from row to row.
pub(super) fn counts_samples(times: &[f64]) -> bool {
    times.windows(2).all(|w| w[1] - w[0] == 1.0)
}

/// Columns that contain a vertical force. The first rule that applies is used:
///
/// 1. Columns that are the sum of a block of other columns (sums of the sensors of insoles).
/// 2. If the number of columns is a multiple of six (Fx Fy Fz Mx My Mz of each plate), the force component with the maximum load, for each
///    plate.
/// 3. Columns whose readings have one sign in more than 90 % of the sum of magnitudes. Their maximum must exceed two fifths of the overall
///    maximum.
pub(super) fn force_columns(columns: &[Vec<f64>], time: Option<usize>) -> Vec<usize> {
    let data: Vec<usize> = (0..columns.len()).filter(|&i| Some(i) != time).collect();
    if data.len() > MOST_VALUES {
        return Vec::new();
    }
    let totals = totals(columns, &data);
    if !totals.is_empty() {
        return totals;
    }
    let reach = |i: usize| {
        let values = sample(&columns[i], SAMPLE);
        values.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
    };
    if data.len() >= 6 && data.len().is_multiple_of(6) {
        let plates: Vec<&[usize]> = data.chunks(6).collect();
        let load = |k: usize| plates.iter().map(|p| reach(p[k])).sum::<f64>();
        let vertical = (0..3)
            .max_by(|&a, &b| load(a).total_cmp(&load(b)))
            .unwrap_or(2);
        return plates.iter().map(|p| p[vertical]).collect();
    }
    let one_sided = |i: usize| {
        let (mut up, mut down) = (0.0, 0.0);
        for x in sample(&columns[i], SAMPLE) {
            if x > 0.0 {
                up += x;
            } else {
                down -= x;
            }
        }
        up.max(down) > 0.9 * (up + down)
    };
    let pushing: Vec<usize> = data.into_iter().filter(|&i| one_sided(i)).collect();
    let most = pushing.iter().map(|&i| reach(i)).fold(0.0, f64::max);
    pushing
        .into_iter()
        .filter(|&i| most > 0.0 && reach(i) > 0.4 * most)
        .collect()
}

/// Columns that are, in nearly every row, the sum of at least three adjacent columns before them.
fn totals(columns: &[Vec<f64>], data: &[usize]) -> Vec<usize> {
    let samples = columns.first().map_or(0, Vec::len);
    if data.len() < 4 || data.len() > 64 || samples == 0 {
        return Vec::new();
    }
    // About a hundred evenly distributed rows are sufficient.
    let rows: Vec<usize> = (0..samples).step_by(samples / 100 + 1).collect();
    let is_sum = |total: usize, block: &[usize]| {
        let agrees = |&&r: &&usize| {
            let sum: f64 = block.iter().map(|&i| columns[i][r]).sum();
            (sum - columns[total][r]).abs() <= 0.5 + 0.005 * sum.abs()
        };
        let loaded = rows
            .iter()
            .filter(|&&r| columns[total][r].abs() > 50.0)
            .count();
        5 * loaded > rows.len() && 100 * rows.iter().filter(agrees).count() >= 95 * rows.len()
    };
    let mut found = Vec::new();
    for (k, &total) in data.iter().enumerate() {
        let blocks = (0..k).flat_map(|a| (a + 3..=k).map(move |b| (a, b)));
        if blocks
            .map(|(a, b)| &data[a..b])
            .any(|block| is_sum(total, block))
        {
            found.push(total);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stance(i: usize, shift: usize) -> f64 {
        let t = ((i + shift) % 100) as f64 / 60.0;
        if t < 1.0 {
            800.0 * (std::f64::consts::PI * t).sin()
        } else {
            0.0
        }
    }

    #[test]
    fn the_third_of_six_the_totals_and_the_one_sided_are_found() {
        let t: Vec<f64> = (0..400).map(|i| 0.01 * i as f64).collect();
        let z: Vec<f64> = (0..400).map(|i| -stance(i, 0)).collect();
        let s: Vec<f64> = (0..400).map(|i| 150.0 * (i as f64 * 0.1).sin()).collect();
        let m: Vec<f64> = z.iter().map(|f| 900.0 * f).collect();
        let plate = vec![
            t.clone(),
            s.clone(),
            s.clone(),
            z.clone(),
            m.clone(),
            m.clone(),
            m,
        ];
        assert_eq!(time_column(&plate), Some(0));
        assert_eq!(force_columns(&plate, Some(0)), [3]);
        let three = vec![t.clone(), s.clone(), s, z.clone()];
        assert_eq!(force_columns(&three, Some(0)), [3]);
        let part = |k: f64| z.iter().map(|f| k * f).collect::<Vec<f64>>();
        let insole = vec![t, part(0.2), part(0.3), part(0.5), z.clone()];
        assert_eq!(force_columns(&insole, Some(0)), [4]);
        assert_eq!(time_column(&[z.clone(), z]), None);
    }

    #[test]
    fn a_time_falls_in_hardly_any_row_and_does_not_stand() {
        let of = |at: fn(usize) -> usize| {
            let t: Vec<f64> = (0..101).map(|i| at(i) as f64).collect();
            time_column(&[t.clone(), t]).is_some()
        };
        assert!(of(|i| i) && of(|i| i / 10) && !of(|i| i / 11) && !of(|i| 101 - i));
        // One row in twenty falls, and one in sixteen.
        assert!(of(|i| 2 * i - 3 * usize::from(i % 20 == 19)));
        assert!(!of(|i| 2 * i - 3 * usize::from(i % 16 == 15)));
    }

    #[test]
    fn a_first_column_that_grows_by_one_counts_samples() {
        let of = |step: f64| counts_samples(&[0.0, step, 2.0 * step]);
        assert!(of(1.0) && !of(0.5) && !of(2.0));
    }

    #[test]
    fn a_total_is_looked_for_among_four_to_sixty_four_columns() {
        let z: Vec<f64> = (0..400).map(|i| -stance(i, 0)).collect();
        for (parts, found) in [(2, false), (3, true), (63, true), (64, false)] {
            let part: Vec<f64> = z.iter().map(|f| f / parts as f64).collect();
            let mut columns = vec![part; parts];
            columns.push(z.clone());
            let all: Vec<usize> = (0..=parts).collect();
            assert_eq!(totals(&columns, &all) == [parts], found, "{parts}");
        }
    }
}
