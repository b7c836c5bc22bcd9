//! Output of a cycle as an OpenSim file of external loads.

use std::fmt::Write as _;

use super::ForceCurve;
use super::csv::write_head;
use crate::recording::Foot;

/// Endings of the column names of one external load: force, point of application, free torque.
const COLUMNS: [&str; 9] = [
    "_vx",
    "_vy",
    "_vz",
    "_px",
    "_py",
    "_pz",
    "_torque_x",
    "_torque_y",
    "_torque_z",
];
/// Index of the vertical force in `COLUMNS`. In OpenSim, the Y axis points upwards.
const VERTICAL: usize = 1;

impl ForceCurve {
    /// The cycle as `.mot` text in the layout of OpenSim's ExternalLoads, which [`one_cycle`](crate::one_cycle) reads back as the same
    /// cycle.
    ///
    /// The column of the vertical force is `ground_force_vy`. If `foot` is given, the name also contains the foot, as in
    /// `ground_force_l_vy`. The last row repeats the first one at the end of the period. The other components, the point of application and
    /// the torques are zero, because a curve does not contain them.
    pub fn to_mot(&self, foot: Option<Foot>, comments: &[&str]) -> String {
        let mut out = String::with_capacity(64 * self.force_n.len());
        // Writing to a String does not fail.
        let _ = write_mot(&mut out, self, foot, comments);
        out
    }
}

fn write_mot(
    out: &mut String,
    curve: &ForceCurve,
    foot: Option<Foot>,
    comments: &[&str],
) -> std::fmt::Result {
    let rows = curve.force_n.len() + 1;
    let side = match foot {
        Some(Foot::Left) => "_l",
        Some(Foot::Right) => "_r",
        None => "",
    };
    writeln!(
        out,
        "gaitcam\nversion=1\nnRows={rows}\nnColumns={}\ninDegrees=yes",
        COLUMNS.len() + 1
    )?;
    write_head(out, curve, comments)?;
    write!(out, "endheader\ntime")?;
    for column in COLUMNS {
        let (name, end) = match column.strip_prefix("_torque") {
            Some(end) => ("ground_torque", end),
            None => ("ground_force", column),
        };
        write!(out, "\t{name}{side}{end}")?;
    }
    out.push('\n');
    let step = curve.period_s / curve.force_n.len() as f64;
    for (i, force) in curve
        .force_n
        .iter()
        .chain(curve.force_n.first())
        .enumerate()
    {
        write!(out, "{}", i as f64 * step)?;
        for k in 0..COLUMNS.len() {
            match k {
                VERTICAL => write!(out, "\t{force}")?,
                _ => write!(out, "\t0")?,
            }
        }
        out.push('\n');
    }
    Ok(())
}
