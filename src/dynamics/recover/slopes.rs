//! Slopes of the C² cubic spline through given values, for equal steps (closed or open) or for any angles.

/// Slopes at the nodes of the C² cubic spline through equally spaced values.
pub fn spline_slopes(values: &[f64], step: f64, closed: bool) -> Vec<f64> {
    if closed {
        periodic_slopes(values, step)
    } else {
        let angles: Vec<f64> = (0..values.len()).map(|i| step * i as f64).collect();
        slopes_at(&angles, values)
    }
}

/// Slopes mᵢ at the nodes of the periodic C² cubic spline through equally spaced values yᵢ. They solve mᵢ₋₁ + 4mᵢ + mᵢ₊₁ = 3(yᵢ₊₁ −
/// yᵢ₋₁)/step. The method is elimination with one cyclic correction.
pub fn periodic_slopes(values: &[f64], step: f64) -> Vec<f64> {
    let n = values.len();
    let right = |i: usize| 3.0 * (values[(i + 1) % n] - values[(i + n - 1) % n]) / step;
    // Sherman–Morrison formula: the corner entries 1 are eliminated with u = (−4, 0 … 1), v = (1, 0 … −1/4).
    let mut ratio = vec![0.0; n];
    let mut x = vec![0.0; n];
    let mut z = vec![0.0; n];
    let (mut pivot, mut below) = (8.0, (0.0, 0.0));
    for i in 0..n {
        let (diagonal, corner) = match i {
            0 => (8.0, -4.0),
            _ if i + 1 == n => (4.25, 1.0),
            _ => (4.0, 0.0),
        };
        if i > 0 {
            ratio[i - 1] = 1.0 / pivot;
            pivot = diagonal - ratio[i - 1];
        }
        below = ((right(i) - below.0) / pivot, (corner - below.1) / pivot);
        (x[i], z[i]) = below;
    }
    for i in (0..n - 1).rev() {
        x[i] -= ratio[i] * x[i + 1];
        z[i] -= ratio[i] * z[i + 1];
    }
    let weight = |y: &[f64]| y[0] - 0.25 * y[n - 1];
    let factor = weight(&x) / (1.0 + weight(&z));
    x.iter().zip(&z).map(|(a, b)| a - factor * b).collect()
}

/// Number of neighbouring values that determine the slope at the first or last node.
const END_POINTS: usize = 5;

/// Slopes at increasing `x` of the C² cubic spline through `y`. Each end slope is the slope of the polynomial through the nearest five values. With
/// five values or fewer, all slopes belong to the polynomial through all values.
pub fn slopes_at(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    if n <= END_POINTS {
        return (0..n).map(|j| slope_of_polynomial(x, y, j)).collect();
    }
    let mut slopes = vec![0.0; n];
    slopes[0] = slope_of_polynomial(&x[..END_POINTS], &y[..END_POINTS], 0);
    slopes[n - 1] = slope_of_polynomial(&x[n - END_POINTS..], &y[n - END_POINTS..], END_POINTS - 1);
    // h₁ mᵢ₋₁ + 2(h₀ + h₁) mᵢ + h₀ mᵢ₊₁ = 3(h₁ d₀ + h₀ d₁). The widths before and after node i are h₀ and h₁, and the difference quotients
    // are d₀ and d₁.
    let mut ratio = vec![0.0; n];
    for i in 1..n - 1 {
        let (before, after) = (x[i] - x[i - 1], x[i + 1] - x[i]);
        let differences = [(y[i] - y[i - 1]) / before, (y[i + 1] - y[i]) / after];
        let mut right = 3.0 * (after * differences[0] + before * differences[1]);
        if i + 2 == n {
            right -= before * slopes[n - 1];
        }
        let pivot = 2.0 * (before + after) - after * ratio[i - 1];
        slopes[i] = (right - after * slopes[i - 1]) / pivot;
        ratio[i] = before / pivot;
    }
    for i in (1..n - 2).rev() {
        slopes[i] -= ratio[i] * slopes[i + 1];
    }
    slopes
}

/// Slope at x[j] of the polynomial through all values.
fn slope_of_polynomial(x: &[f64], y: &[f64], j: usize) -> f64 {
    let weight = |k: usize| -> f64 {
        let others = (0..x.len()).filter(|&i| i != k);
        others.map(|i| x[k] - x[i]).product()
    };
    let own = weight(j);
    (0..x.len())
        .filter(|&k| k != j)
        .map(|k| own / weight(k) / (x[j] - x[k]) * (y[k] - y[j]))
        .sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_met_exactly_at_uneven_angles() {
        let x = [0.0, 0.3, 1.0, 1.1, 2.0, 2.7, 3.0, 4.5];
        let y = x.map(|x: f64| 1.0 - 2.0 * x + 0.5 * x * x - 0.25 * x * x * x);
        for count in 2..=x.len() {
            let got = slopes_at(&x[..count], &y[..count]);
            for (x, got) in x.iter().zip(&got) {
                let exact = -2.0 + x - 0.75 * x * x;
                // Two or three values do not determine a cubic.
                assert!(
                    count < 4 || (got - exact).abs() < 1e-12,
                    "{count} {x} {got}"
                );
            }
        }
    }
}
