//! Tables of the law and the profile, with one row per cam angle. Numbers have full precision.

use crate::pose::{angles, target_at};
use gaitcam::cam::{ProfilePoint, Wall};
use gaitcam::force::Walk;
use gaitcam::sweep::{Field, Records};
use gaitcam::synth::Design;

/// Columns of `law.csv`, in order.
const LAW: [&str; 9] = [
    "theta_rad",
    "s_m",
    "v_m_per_rad",
    "a_m_per_rad2",
    "j_m_per_rad3",
    "force_n",
    "target_n",
    "time_s",
    "speed_rad_per_s",
];
/// Columns with a lift or its derivatives, each with two names. The second name is used for an oscillating follower, whose lift is an
/// angle.
const ANGLES: [(&str, &str); 6] = [
    ("s_m", "s_rad"),
    ("v_m_per_rad", "v_rad_per_rad"),
    ("a_m_per_rad2", "a_rad_per_rad2"),
    ("j_m_per_rad3", "j_rad_per_rad3"),
    ("lift_m", "lift_rad"),
    ("gap_m", "gap_rad"),
];
const PROFILE: [&str; 7] = [
    "theta_rad",
    "x_m",
    "y_m",
    "pitch_x_m",
    "pitch_y_m",
    "rho_m",
    "pressure_angle_rad",
];
/// Columns of `walkers.csv` after the column with the walker's name.
const WALKERS: [&str; 5] = [
    "mass_kg",
    "speed_rad_per_s",
    "phase_rad",
    "rms_error_percent",
    "rms_error_n",
];
/// A table of numbers: name and values of each column.
pub type Columns = Vec<(&'static str, Vec<f64>)>;

/// Number of bytes reserved for one number and its comma.
const WIDTH: usize = 24;

/// `floor.csv`: acceleration of the floor as a function of the step frequency, for the required force and for the force of the designed
/// cam. `None` without a floor.
pub fn floor(design: &Design) -> Option<String> {
    design.floor.as_ref()?;
    let rows = design.resonance().into_iter().map(|p| {
        let m = p.motion;
        let [peak, rms, of_cam] = [
            m.acceleration_peak_m_per_s2,
            m.acceleration_rms_m_per_s2,
            p.of_cam.acceleration_peak_m_per_s2,
        ];
        format!(
            "{:.6},{peak},{rms},{},{of_cam}\n",
            p.step_frequency,
            m.comfort.hivoss()
        )
    });
    let names = "step_frequency_hz,acceleration_peak_m_per_s2,acceleration_rms_m_per_s2,comfort,cam_acceleration_peak_m_per_s2\n";
    Some([names.to_string()].into_iter().chain(rows).collect())
}

/// `strides.csv`: the consecutive recorded strides with which the cam is compared, at equal time steps. The comparison repeats this
/// sequence of strides periodically. `None` without such strides.
pub fn strides(design: &Design) -> Option<String> {
    design.repeated().map(|(walk, _)| strides_of(&walk))
}

/// Force of consecutive strides as a function of time, as CSV.
pub fn strides_of(walk: &Walk) -> String {
    let force = walk.force_n();
    let step = walk.duration_s / force.len() as f64;
    let time = (0..force.len()).map(|i| step * i as f64).collect();
    text(&vec![("time_s", time), ("force_n", force)])
}

/// `walkers.csv`: force error of each cycle of a population; `None` without a population.
pub fn walkers(design: &Design) -> Option<Records> {
    let each = &design.population.as_ref()?.each;
    let numbers = columns(
        WALKERS,
        each.iter().map(|w| {
            let (percent, newtons) = (w.rms_error_percent, w.rms_error_n);
            [w.mass_kg, w.speed_rad_per_s, w.phase_rad, percent, newtons]
        }),
    );
    let mut fields = vec![Field::words(
        "walker",
        each.iter().map(|w| w.walker.as_str()),
    )];
    fields.extend(numbers.into_iter().map(|(n, x)| Field::numbers(n, x)));
    Some(Records { fields })
}

/// `law.csv`: lift, derivatives of the lift with respect to the cam angle, force and target at `points` equally spaced cam angles.
///
/// The force is the output force; for a polydyne cam it is the force of the follower end. Numbers have the minimum number of digits for
/// which they are read back exactly. `target_n` is empty for a programme of classical laws, because it has no target.
pub fn law(synthesis: &Design, points: usize) -> String {
    text(&law_columns(synthesis, points))
}

/// Columns of `law.csv`. For an arm, the force is the moment divided by the length of the lever. Without a target, the target column is
/// NaN.
pub fn law_columns(synthesis: &Design, points: usize) -> Columns {
    let cam = &synthesis.cam;
    let names = named(LAW, cam.follower.is_oscillating());
    let drive = &synthesis.problem.drive;
    let rows = angles(&cam.law, points).map(|theta| {
        let at = cam.law.svaj(theta);
        let force = synthesis.force_at(theta);
        let target = synthesis.target();
        let target = target.map_or(f64::NAN, |t| target_at(t, &cam.law, theta));
        let [force, target] = [force, target].map(|f| drive.newtons(f));
        let (speed, time) = synthesis.speed_and_time(theta);
        [theta, at.s, at.v, at.a, at.j, force, target, time, speed]
    });
    columns(names, rows)
}

/// `profile.csv`: contact point, pitch curve, radius of curvature and pressure angle at `rows` equally spaced cam angles.
///
/// Each row contains the contact at one cam angle. For a closed law, the curve continues from the last row to the first row. At a flat
/// point of the profile, `rho_m` is `inf`. For a barrel cam, the table contains the lower wall of the groove and the centre of the roller
/// on this wall. If the follower has two rollers, this centre is below the centre of the stud.
pub fn profile(synthesis: &Design, rows: usize) -> String {
    text(&profile_columns(synthesis, rows))
}

/// Columns of `profile.csv`, with values at `rows` equally spaced cam angles.
pub fn profile_columns(synthesis: &Design, rows: usize) -> Columns {
    let mut all = synthesis.cam.profile(rows);
    if let Some(groove) = &synthesis.groove {
        let up = groove.axis_offset(Wall::Lower);
        for row in &mut all {
            row.y += up;
            row.pitch_y += up;
        }
    }
    points_columns(&all)
}

/// Profile points as CSV with the columns of `profile.csv`. This function also writes the second cam of a conjugate pair.
pub fn points(rows: &[ProfilePoint]) -> String {
    text(&points_columns(rows))
}

fn points_columns(rows: &[ProfilePoint]) -> Columns {
    let rows = rows.iter().map(|p| {
        [
            p.theta,
            p.x,
            p.y,
            p.pitch_x,
            p.pitch_y,
            p.rho,
            p.pressure_angle,
        ]
    });
    columns(PROFILE, rows)
}

/// Names of columns. For an oscillating follower (`swings`), names of lengths are replaced by [names of angles](ANGLES).
pub(crate) fn named<const N: usize>(names: [&'static str; N], swings: bool) -> [&'static str; N] {
    names.map(|name| {
        let angle = ANGLES.iter().find(|a| a.0 == name && swings);
        angle.map_or(name, |a| a.1)
    })
}

pub(crate) fn columns<const N: usize>(
    names: [&'static str; N],
    rows: impl Iterator<Item = [f64; N]>,
) -> Columns {
    let mut out: Columns = names.into_iter().map(|name| (name, Vec::new())).collect();
    for row in rows {
        for (column, x) in out.iter_mut().zip(row) {
            column.1.push(x);
        }
    }
    out
}

/// CSV text with a header and one line per row. Numbers have the shortest form that is read back exactly; NaN is an empty cell.
pub fn text(columns: &Columns) -> String {
    let rows = columns.first().map_or(0, |c| c.1.len());
    let mut out = String::with_capacity((rows + 1) * columns.len() * WIDTH);
    for (i, (name, _)) in columns.iter().enumerate() {
        out.push_str(if i > 0 { "," } else { "" });
        out.push_str(name);
    }
    out.push('\n');
    let mut digits = zmij::Buffer::new();
    for row in 0..rows {
        for (i, (_, values)) in columns.iter().enumerate() {
            out.push_str(if i > 0 { "," } else { "" });
            let x = values[row];
            if x.is_finite() && x.abs() >= 1e16 {
                // The shortest format would add a plus sign to the exponent here.
                out.push_str(&format!("{x:?}"));
            } else if !x.is_nan() {
                out.push_str(digits.format(x));
            }
        }
        out.push('\n');
    }
    out
}
