//! Tables: the law and the profile, one row per cam angle, full precision.

use std::fmt::Write;

use crate::pose::{angles, oscillates, target_at};
use gaitcam::cam::{ProfilePoint, Wall};
use gaitcam::synth::Design;

/// Columns of `law.csv` for a translating follower.
const LAW_METRES: &str = "theta_rad,s_m,v_m_per_rad,a_m_per_rad2,j_m_per_rad3,force_n,target_n";
/// Columns of `law.csv` for an oscillating follower.
const LAW_RADIANS: &str =
    "theta_rad,s_rad,v_rad_per_rad,a_rad_per_rad2,j_rad_per_rad3,force_n,target_n";
const PROFILE: &str = "theta_rad,x_m,y_m,pitch_x_m,pitch_y_m,rho_m,pressure_angle_rad";
/// Room for one number and its comma.
const WIDTH: usize = 24;

/// `law.csv`: lift, its derivatives by the cam angle, force and target at `points` equal steps.
///
/// The force is the one that is handed on: of a polydyne cam, that of the follower's end.
/// Numbers are the shortest that read back to the same 64 bits. `target_n` stays empty for a classical
/// programme, which has no target.
pub fn law(synthesis: &Design, points: usize) -> String {
    let cam = &synthesis.cam;
    let mut out = String::with_capacity((points + 1) * 7 * WIDTH);
    out.push_str(if oscillates(&cam.follower) {
        LAW_RADIANS
    } else {
        LAW_METRES
    });
    out.push('\n');
    for theta in angles(&cam.law, points) {
        let at = cam.law.svaj(theta);
        let force = synthesis.drive.force(synthesis.pressing().svaj(theta));
        numbers(&mut out, &[theta, at.s, at.v, at.a, at.j, force]);
        out.push(',');
        if let Some(target) = &synthesis.target {
            numbers(&mut out, &[target_at(target, &cam.law, theta)]);
        }
        out.push('\n');
    }
    out
}

/// `profile.csv`: contact point, pitch curve, curvature and pressure angle at `rows` equal steps.
///
/// Row i is the contact at its angle; the curve of a closed law closes on row 0. A flat spot of the
/// profile has `rho_m` = `inf`. Of a barrel it is the lower wall with the centre of the roller that
/// touches it, which a stud with two rollers holds below its own height.
pub fn profile(synthesis: &Design, rows: usize) -> String {
    let mut all = synthesis.cam.profile(rows);
    if let Some(groove) = &synthesis.groove {
        let up = groove.axis_offset(Wall::Lower);
        for row in &mut all {
            row.y += up;
            row.pitch_y += up;
        }
    }
    points(&all)
}

/// Any profile in the columns of `profile.csv`, as the second one of a conjugate pair.
pub fn points(rows: &[ProfilePoint]) -> String {
    let mut out = String::with_capacity((rows.len() + 1) * 7 * WIDTH);
    out.push_str(PROFILE);
    out.push('\n');
    for p in rows {
        let row = [
            p.theta,
            p.x,
            p.y,
            p.pitch_x,
            p.pitch_y,
            p.rho,
            p.pressure_angle,
        ];
        numbers(&mut out, &row);
        out.push('\n');
    }
    out
}

fn numbers(out: &mut String, row: &[f64]) {
    for (i, x) in row.iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        // Debug is the shortest form that reads back exactly; writing to a String cannot fail.
        let _ = write!(out, "{x:?}");
    }
}
