//! Keys in the lines above a table: sampling rate, mass of the walker, announced number of rows.

use super::number::value;
use crate::recording::OpenQuestion;
use crate::units::G;

/// Values from the lines above a table.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Keys {
    pub rate_hz: Option<f64>,
    pub mass_kg: Option<f64>,
    /// Root mean square of the noise of the force, N.
    pub noise_n: Option<f64>,
    /// Number of rows announced in the header.
    pub rows: Option<usize>,
    /// Number of steps of a walker in the cycle.
    pub steps: Option<usize>,
    /// Open questions about the recording from which the mean cycle in the table was computed.
    pub open: Vec<OpenQuestion>,
}

/// Words (lower case) that denote a sampling rate.
const RATE: &str = "rate freq abtast hz frecuencia fréquence sampling";
/// Complete keys (lower case) that denote a sampling rate.
const RATES: [&str; 3] = ["fs", "sf", "fsample"];
/// Words (lower case) that show that a rate is not the sampling rate.
const NOT_SAMPLING: &str = "heart factor cutoff cut-off cut_off filter pass";
/// Words that denote a mass or weight.
const MASS: &str = "mass gewicht weight masse peso poids masa";

/// Reads the keys of header lines such as `SampleRate=450`, `Gewicht [kg];56,8`, `nRows=1501`.
///
/// In a Nexus export, the line below the line `Devices` contains only the rate.
pub(super) fn read(head: &[String], comma: bool) -> Keys {
    let mut keys = Keys::default();
    for (i, line) in head.iter().enumerate() {
        let lower = line.to_lowercase();
        let bare = trimmed(&lower);
        let above = i.checked_sub(1).map_or("", |j| trimmed(&head[j]));
        if let Some(x) = number(bare, comma)
            && above.eq_ignore_ascii_case("devices")
        {
            keys.rate_hz = Some(x);
            continue;
        }
        let Some((key, value)) = split(bare) else {
            continue;
        };
        if key == "open" {
            keys.open = OpenQuestion::list(value).unwrap_or_default();
        }
        let Some(x) = number(value, comma) else {
            continue;
        };
        let says = |words: &str| words.split(' ').any(|w| key.contains(w));
        if (says("per_frame perframe") || key.contains("per frame")) && x > 0.0 {
            // For example `SECONDS_PER_FRAME 0.01`, `time per frame [secs]: 0.01`.
            keys.rate_hz.get_or_insert(1.0 / x);
        } else if (says(RATE) || RATES.contains(&key)) && !says(NOT_SAMPLING) && x > 0.0 {
            keys.rate_hz.get_or_insert(x);
        } else if says(MASS) && x > 0.0 {
            keys.mass_kg = keys.mass_kg.or(mass(key, value, x));
        } else if key == "noise_n" && x >= 0.0 {
            keys.noise_n = Some(x);
        } else if key == "steps_per_turn" && x > 0.0 {
            keys.steps = Some(x as usize);
        } else if says("nrows datarows numberofsamples") {
            keys.rows = (x >= 0.0).then_some(x as usize);
        }
    }
    keys
}

fn trimmed(line: &str) -> &str {
    line.trim_matches(|c: char| c.is_whitespace() || ",;\"".contains(c))
}

/// Key and value of a line, separated by `=`, `:`, a field separator, or the last space.
fn split(line: &str) -> Option<(&str, &str)> {
    for mark in ["=", ":", "\t", ";", ","] {
        if let Some((key, value)) = line.split_once(mark) {
            return Some((key.trim(), trimmed(value)));
        }
    }
    line.rsplit_once(' ').map(|(k, v)| (k.trim(), v.trim()))
}

/// Number at the start of a value. A unit may follow the number.
pub(super) fn number(typed: &str, comma: bool) -> Option<f64> {
    let first = typed.split(['\t', ';', ' ']).next().unwrap_or("");
    let end = first
        .find(|c: char| !(c.is_ascii_digit() || "+-.,e".contains(c)))
        .unwrap_or(first.len());
    let digits = first[..end].trim_end_matches(['e', ',']);
    Some(value(digits.as_bytes(), comma)).filter(|x| x.is_finite())
}

/// Mass of a walker, kg, from a key for mass or weight; `None` if implausible.
pub(super) fn mass(key: &str, value: &str, x: f64) -> Option<f64> {
    let all = format!("{key} {value}").to_lowercase();
    let unit = |u: &str| {
        let marked = [format!("[{u}]"), format!("({u})"), format!("_{u}")];
        marked.iter().any(|m| all.contains(m)) || all.ends_with(&format!(" {u}"))
    };
    let kg = if unit("n") {
        x / G
    } else if unit("lb") || unit("lbs") {
        x * 0.453_592_37
    } else if unit("kg") || x < 200.0 {
        x
    } else {
        // A weight above 200 without a unit is in newtons.
        x / G
    };
    (3.0..=400.0).contains(&kg).then_some(kg)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(lines: &[&str], comma: bool) -> Keys {
        let head: Vec<String> = lines.iter().map(|l| (*l).to_string()).collect();
        read(&head, comma)
    }

    #[test]
    fn rates_masses_and_row_counts_are_found_in_every_style() {
        let k = of(
            &[
                "Abtastrate [Hz];1000",
                "Größe [cm];174,0",
                "Gewicht [kg];56,8",
            ],
            true,
        );
        assert_eq!((k.rate_hz, k.mass_kg), (Some(1000.0), Some(56.8)));
        let k = of(
            &[
                "[Force Data]",
                "SampleRate=450.000000",
                "NumberOfSamples=1092",
            ],
            false,
        );
        assert_eq!((k.rate_hz, k.rows), (Some(450.0), Some(1092)));
        assert_eq!(of(&["Devices", "1000,,,"], false).rate_hz, Some(1000.0));
        assert_eq!(
            of(&["Sampling rate (Hz):\t960"], false).rate_hz,
            Some(960.0)
        );
        assert_eq!(of(&["FREQUENCY\t1200"], false).rate_hz, Some(1200.0));
        assert_eq!(of(&["datarows 9009"], false).rows, Some(9009));
        assert_eq!(of(&["Body weight (N): 686.7"], false).mass_kg, Some(70.0));
        assert_eq!(of(&["SECONDS_PER_FRAME 0.005"], false).rate_hz, Some(200.0));
        assert_eq!(of(&["Mass: 0 kg"], false).mass_kg, None);
    }
}
