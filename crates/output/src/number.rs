//! Numbers as people write them.

/// `x` to `digits` significant digits, without exponent in the usual range, with a true minus sign.
pub fn number(x: f64, digits: i32) -> String {
    if !x.is_finite() {
        return match x {
            f64::INFINITY => "∞".into(),
            f64::NEG_INFINITY => "−∞".into(),
            _ => "—".into(),
        };
    }
    if x == 0.0 {
        return "0".into();
    }
    let power = x.abs().log10().floor() as i32;
    let text = if (-5..9).contains(&power) {
        let decimals = (digits - 1 - power).max(0) as usize;
        let text = format!("{x:.decimals$}");
        if text.trim_start_matches(['-', '0', '.']).is_empty() {
            "0".into()
        } else {
            text
        }
    } else {
        format!("{x:.*e}", (digits - 1).max(0) as usize)
    };
    text.replace('-', "−")
}

/// "low … high"; an end that is zero but for rounding is called so.
pub fn range(low: f64, high: f64, digits: i32) -> String {
    let noise = 1e-9 * (high - low).abs();
    let [low, high] = [low, high].map(|x| number(if x.abs() < noise { 0.0 } else { x }, digits));
    format!("{low} … {high}")
}

/// Degrees to one decimal, in [0, 360] for one turn.
pub fn degrees(theta: f64) -> String {
    format!("{:.1}°", theta.to_degrees() + 0.0).replace('-', "−")
}
