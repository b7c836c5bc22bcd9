//! Numbers as people write them.

use crate::wording::Language;

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

/// A text whose numbers have the decimal sign of a language. What only looks like a number, `0.1.0` or `walk_1.5`, stays.
pub fn in_language(text: &str, language: Language) -> String {
    if language == Language::En || !text.contains('.') {
        return text.to_string();
    }
    let letters: Vec<char> = text.chars().collect();
    let is_sign = |i: usize| letters[i] == '.' && is_decimal(&letters, i);
    (0..letters.len())
        .map(|i| if is_sign(i) { ',' } else { letters[i] })
        .collect()
}

/// Whether the point at `i` stands in a number of its own.
fn is_decimal(letters: &[char], i: usize) -> bool {
    let digit = |k: usize| letters.get(k).is_some_and(char::is_ascii_digit);
    if i == 0 || !digit(i - 1) || !digit(i + 1) {
        return false;
    }
    let start = (0..i).rev().find(|&k| !digit(k));
    let end = (i + 1..letters.len()).find(|&k| !digit(k));
    let of_word = |c: char| c.is_alphanumeric() || c == '_';
    let begins = start.is_none_or(|k| match letters[k] {
        '.' => false,
        // A name such as walk-1.5; a minus sign has no letter before it.
        '-' => k == 0 || !of_word(letters[k - 1]),
        c => !of_word(c),
    });
    let ends = end.is_none_or(|k| match letters[k] {
        '.' => !digit(k + 1),
        'e' => letters
            .get(k + 1)
            .is_some_and(|c| "+-0123456789".contains(*c)),
        c => !of_word(c),
    });
    begins && ends
}

/// A page whose visible numbers have the decimal sign of a language; scripts, styles and code stay as they are.
pub fn page_in_language(page: String, language: Language) -> String {
    if language == Language::En {
        return page;
    }
    let mut out = String::with_capacity(page.len());
    let mut rest = page.as_str();
    while let Some(open) = rest.find('<') {
        out += &in_language(&rest[..open], language);
        rest = &rest[open..];
        let literal = ["script", "style", "code", "pre"].into_iter().find(|name| {
            rest[1..]
                .strip_prefix(name)
                .is_some_and(|r| r.starts_with(['>', ' ']))
        });
        let end = match literal {
            Some(name) => rest.find(&format!("</{name}>")),
            None => rest.find('>').map(|at| at + 1),
        };
        let (tag, after) = rest.split_at(end.unwrap_or(rest.len()).max(1));
        out += tag;
        rest = after;
    }
    out + &in_language(rest, language)
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
    use super::*;

    #[test]
    fn numbers_get_the_sign_of_the_language_and_names_keep_their_points() {
        let said = |text: &str| in_language(text, Language::Es);
        assert_eq!(said("3.46 N, −0.5° (1.2e-6)."), "3,46 N, −0,5° (1,2e-6).");
        for name in [
            "gaitcam 0.1.0",
            "walk_1.5",
            "walk-1.5",
            "law.segment.1.angle",
            "1.x",
            "v1.5",
        ] {
            assert_eq!(said(name), name);
        }
        assert_eq!(in_language("3.46 N", Language::En), "3.46 N");
        let page =
            "<p title=\"1.5\">1.5 mm</p><script>x = 1.5 < 2.5</script><b>2.5</b>".to_string();
        assert_eq!(
            page_in_language(page, Language::Es),
            "<p title=\"1.5\">1,5 mm</p><script>x = 1.5 < 2.5</script><b>2,5</b>"
        );
    }

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
