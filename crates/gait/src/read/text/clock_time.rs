//! Times of day and dates in a field of a table.

use crate::read::number::{Field, field, trim};

/// Seconds of a clock time `[hh:]mm:ss.s`, with or without a date before it.
pub(super) fn clock(f: &[u8], comma: bool) -> Option<f64> {
    let f = trim(f);
    match dated(f, comma) {
        None => time_of_day(f, comma),
        some => some,
    }
}

/// Seconds of `2024-05-01T10:05:07.5Z` since the year began; a blank may replace the T, and the zone,
/// which is the same for all samples, is passed over.
fn dated(f: &[u8], comma: bool) -> Option<f64> {
    let number = |from: usize, to: usize| -> Option<f64> {
        let digits = std::str::from_utf8(f.get(from..to)?).ok()?;
        digits.parse::<u32>().ok().map(f64::from)
    };
    let parted = f.get(4) == Some(&b'-')
        && f.get(7) == Some(&b'-')
        && matches!(f.get(10), Some(b'T' | b't' | b' '));
    if !parted {
        return None;
    }
    let (year, month, day) = (number(0, 4)?, number(5, 7)?, number(8, 10)?);
    let rest = &f[11..];
    let zone = rest
        .iter()
        .position(|b| b"Zz+-".contains(b))
        .unwrap_or(rest.len());
    let seconds = time_of_day(rest[..zone].trim_ascii(), comma)?;
    // Days before each month; a leap day only matters to recordings over its midnight.
    let leap = year % 4.0 == 0.0 && (year % 100.0 != 0.0 || year % 400.0 == 0.0);
    let before = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334];
    let days = f64::from(*before.get((month as usize).checked_sub(1)?)?)
        + day
        + f64::from(u8::from(leap && month > 2.0));
    Some(86_400.0 * days + seconds)
}

fn time_of_day(f: &[u8], comma: bool) -> Option<f64> {
    let mut seconds = 0.0;
    let mut parts = 0;
    for part in trim(f).split(|&b| b == b':') {
        match field(part, comma) {
            Field::Number(x) if x >= 0.0 => seconds = 60.0 * seconds + x,
            _ => return None,
        }
        parts += 1;
    }
    (2..=3).contains(&parts).then_some(seconds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_before_the_clock_time_are_read() {
        let at = |t: &str| clock(t.as_bytes(), false);
        let step =
            at("2024-05-01T10:05:07.001Z").unwrap() - at("2024-05-01T10:05:07.000Z").unwrap();
        assert!((step - 0.001).abs() < 1e-8);
        // Over the end of a leap February.
        let night = at("2024-03-01 00:00:01").unwrap() - at("2024-02-29 23:59:59").unwrap();
        assert_eq!(night, 2.0);
        assert_eq!(at("2024-05-01T10:05:07+02:00"), at("2024-05-01T10:05:07"));
        assert_eq!(at("2024-13-01T10:05:07"), None);
        assert_eq!(at("2024-05-01"), None);
    }
}
