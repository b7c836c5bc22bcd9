//! Numbers as people write them.

/// Appends `x` rounded to at most `decimals` decimals (12 or fewer), without trailing zeros and without −0.
///
/// Drawings hold tens of thousands of coordinates; this takes a tenth of the time of `format!`.
pub fn append(out: &mut String, x: f64, decimals: u32) {
    let scale = 10u64.pow(decimals);
    let scaled = (x * scale as f64).round();
    if scaled.is_nan() || scaled.abs() >= 9e15 {
        out.push_str(&format!("{x}"));
        return;
    }
    append_decimal(out, scaled as i64, decimals);
}

/// Appends `units` ÷ 10^`decimals`, without trailing zeros.
pub fn append_decimal(out: &mut String, units: i64, decimals: u32) {
    if units < 0 {
        out.push('-');
    }
    let (mut rest, mut left) = (units.unsigned_abs(), decimals);
    while left > 0 && rest.is_multiple_of(10) {
        rest /= 10;
        left -= 1;
    }
    let mut digits = [b'0'; 24];
    let mut at = digits.len();
    while rest > 0 || left > 0 || at == digits.len() || digits[at] == b'.' {
        at -= 1;
        digits[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if left > 0 {
            left -= 1;
            if left == 0 {
                at -= 1;
                digits[at] = b'.';
            }
        }
    }
    out.extend(digits[at..].iter().map(|&d| char::from(d)));
}

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

/// A length given in m, in mm; what is below a picometre is rounding.
pub fn millimetres(x: f64, digits: i32) -> String {
    let x = if x.abs() < 1e-12 { 0.0 } else { x };
    format!("{} mm", number(1000.0 * x, digits))
}

/// Degrees to one decimal, in [0, 360] for one turn.
pub fn degrees(theta: f64) -> String {
    // Adding zero turns −0 into 0.
    let tenths = (10.0 * theta.to_degrees()).round() + 0.0;
    format!("{:.1}°", tenths / 10.0).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::append;

    #[test]
    fn appended_numbers_read_back_and_are_as_short_as_can_be() {
        let shown = |x: f64, decimals: u32| {
            let mut out = String::new();
            append(&mut out, x, decimals);
            out
        };
        for (x, decimals, text) in [
            (0.0, 6, "0"),
            (-0.0, 6, "0"),
            (-1e-9, 6, "0"),
            (0.05, 2, "0.05"),
            (-0.5, 2, "-0.5"),
            (100.0, 2, "100"),
            (1234.5678, 2, "1234.57"),
            (-76.2, 6, "-76.2"),
            (10.0, 0, "10"),
        ] {
            assert_eq!(shown(x, decimals), text);
        }
    }
}
