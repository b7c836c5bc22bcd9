//! Paths of the heel markers in a C3D file.

use super::parameters::Parameters;
use super::storage::Analog;
use crate::recording::Foot;

/// Names of the heel marker in common marker sets, as letters and digits only (Davis et al. 1991: HEE; Cappozzo et al. 1995: FCC).
const HEEL: [&str; 8] = [
    "HEE",
    "HEEL",
    "CAL",
    "CALC",
    "CALCANEUS",
    "FCC",
    "FERSE",
    "TALON",
];
const SIDES: [(&str, Foot); 4] = [
    ("L", Foot::Left),
    ("LEFT", Foot::Left),
    ("R", Foot::Right),
    ("RIGHT", Foot::Right),
];

/// Paths of the left and the right heel; NaN for frames in which a marker was not visible. `None` if the file lacks one of the markers.
pub(super) fn heels(analog: &Analog, parameters: &Parameters) -> Option<[Vec<[f64; 3]>; 2]> {
    let mut labels = parameters.all_strings("POINT", "LABELS");
    labels.truncate(analog.points);
    let place = |foot: Foot| labels.iter().position(|label| heel(label) == Some(foot));
    let places = [place(Foot::Left)?, place(Foot::Right)?];
    let frames = analog.samples / analog.per_frame;
    let path = |marker: usize| {
        let at = |frame| analog.point(frame, marker).unwrap_or([f64::NAN; 3]);
        (0..frames).map(at).collect()
    };
    Some(places.map(path))
}

/// Foot to which a heel label belongs; `None` for other labels. Examples of heel labels are `LHEE`, `R_Heel`, `subject:LeftHeel` and
/// `Heel.R`.
fn heel(label: &str) -> Option<Foot> {
    let own = label.rsplit(':').next().unwrap_or(label);
    let name: String = own.chars().filter(char::is_ascii_alphanumeric).collect();
    let name = name.to_ascii_uppercase();
    if HEEL.contains(&name.as_str()) {
        return None;
    }
    let named = SIDES.iter().find(|(side, _)| {
        let rest = name.strip_prefix(side).into_iter();
        let mut rest = rest.chain(name.strip_suffix(side));
        rest.any(|rest| HEEL.contains(&rest))
    });
    named.map(|(_, foot)| *foot)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heels_of_every_marker_set_are_recognised_and_other_markers_are_not() {
        for label in [
            "LHEE",
            "LHEEL",
            "L_Heel",
            "walker 2:LHEE",
            "LeftHeel",
            "HeelL",
            "L.Cal",
            "LFCC",
        ] {
            assert_eq!(heel(label), Some(Foot::Left), "{label}");
        }
        for label in ["RHEE", "RCAL", "R_CALC", "heel_R", "Right Heel", "RFCC"] {
            assert_eq!(heel(label), Some(Foot::Right), "{label}");
        }
        for label in ["LTOE", "HEEL", "LHEEANGLE", "CAL", "LANK", "*12", ""] {
            assert_eq!(heel(label), None, "{label}");
        }
    }
}
