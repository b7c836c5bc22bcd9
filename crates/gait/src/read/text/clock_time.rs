//! Times of day in the fields of a table.

use crate::read::number::{Field, field, trim};

/// Seconds since midnight from a clock time `[hh:]mm:ss.s`, as in `10:05:07.5` and `2024-05-01T10:05:07.5Z`.
///
/// Dates are ignored. Time zones are also ignored, because all rows have the same time zone.
pub(super) fn clock(f: &[u8], comma: bool) -> Option<f64> {
    let f = trim(f);
    let dated = f.get(4) == Some(&b'-') && f.get(7) == Some(&b'-');
    if !dated {
        return time_of_day(f, comma);
    }
    let time = f.get(11..).filter(|_| b"Tt ".contains(&f[10]))?;
    let zone = time.iter().position(|b| b"Zz+-".contains(b));
    time_of_day(&time[..zone.unwrap_or(time.len())], comma)
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
        assert_eq!(at("2024-03-01 00:00:01"), Some(1.0));
        assert_eq!(at("2024-05-01T10:05:07+02:00"), at("2024-05-01T10:05:07"));
        for none in [
            "2024-05-01",
            "2024-05-01T",
            "2024-05-01x10:05:07",
            "2024-05-",
        ] {
            assert_eq!(at(none), None, "{none}");
        }
    }
}
