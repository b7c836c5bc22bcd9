//! Writing and reading of numbers in structured text (IEC 61131-3).

/// Shortest literal that is read back as the same number. It contains a decimal point, which real literals require. A number that single precision
/// represents exactly is written with the digits of single precision.
pub fn literal(x: f64) -> String {
    let single = x as f32;
    let text = match f64::from(single) == x {
        true => format!("{single:?}"),
        false => format!("{x:?}"),
    };
    match text.split_once('e') {
        Some((digits, power)) if !digits.contains('.') => format!("{digits}.0E{power}"),
        Some((digits, power)) => format!("{digits}E{power}"),
        None => text,
    }
}

/// Values assigned to the N `names` in a text, in the form `name := value`. Item i of the result contains the i-th value of every name. `None` if
/// the names do not have equally many values, or if a value is not a number.
pub fn assigned<const N: usize>(text: &str, names: [&str; N]) -> Option<Vec<[f64; N]>> {
    let mut columns: [Vec<f64>; N] = std::array::from_fn(|_| Vec::new());
    for (column, name) in columns.iter_mut().zip(names) {
        for (at, _) in text.match_indices(name) {
            let Some(rest) = text[at + name.len()..].strip_prefix(" := ") else {
                continue;
            };
            let end = rest.find([',', ')', ';']).unwrap_or(rest.len());
            column.push(rest[..end].parse().ok()?);
        }
    }
    let n = columns[0].len();
    let is_whole = columns.iter().all(|c| c.len() == n);
    is_whole.then(|| {
        (0..n)
            .map(|i| std::array::from_fn(|k| columns[k][i]))
            .collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_have_a_point_and_read_back_as_the_same_number() {
        for x in [
            0.0,
            1.0,
            -360.0,
            1e-7,
            -2.5e-12,
            49.248_511,
            1e21,
            f64::from(0.1f32),
        ] {
            let text = literal(x);
            assert!(text.contains('.'), "{text}");
            assert_eq!(text.parse::<f64>().unwrap() as f32, x as f32, "{text}");
            if f64::from(x as f32) != x {
                assert_eq!(text.parse::<f64>().unwrap(), x, "{text}");
            }
        }
    }
}
