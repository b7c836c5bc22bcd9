//! Path of the centre of a milling cutter, and the places where the cutter damages the cam (gouges).

use std::fmt::Write;

use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

/// Minimum depth that counts as a gouge, m. Rounding errors of the profile are smaller.
const TOUCH: f64 = 1e-9;

/// Position of the cutter's centre at one cam angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutterPoint {
    /// Cam angle of the profile point that is cut, rad.
    pub theta: f64,
    /// x coordinate of the cutter's centre, cam frame, m.
    pub x: f64,
    /// y coordinate of the cutter's centre, cam frame, m.
    pub y: f64,
}

/// Damage to the profile by the cutter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gouge {
    /// The radius of the cutter exceeds the minimum concave radius of the profile.
    Hollow {
        /// Cam angle at the minimum concave radius, rad.
        at: f64,
        /// Minimum concave radius of curvature, m. A larger cutter does not fit.
        radius: f64,
    },
    /// While the cutter cuts one point, it penetrates the profile at another point.
    Elsewhere {
        /// Cam angle of the point that is cut, rad.
        at: f64,
        /// Cam angle of the damaged point of the profile, rad.
        damaged: f64,
        /// Depth by which the cutter penetrates the profile, m.
        depth: f64,
    },
    /// The profile is undercut, so no cutter can produce it.
    Undercut {
        /// Cam angle at the minimum convex radius, where the profile is undercut most, rad.
        at: f64,
    },
}

/// Path of the cutter's centre, with the damage that the cutter causes.
#[derive(Debug, Clone, PartialEq)]
pub struct CutterPath {
    /// Positions of the cutter's centre. The last one equals the first one if the law is closed.
    pub points: Vec<CutterPoint>,
    /// Damage by the cutter; empty if the cutter does not damage the cam.
    pub gouges: Vec<Gouge>,
}

/// Path of a cutter of radius `tool` (m) around the outside of the cam.
///
/// The path is the parallel curve of the profile at the distance `tool`, along the exact normals, at `points` equal steps of the cam angle.
/// Damage in concave parts is detected from the exact curvature. Without such damage, damage at other places is detected at the `points` of
/// the profile.
///
/// # Errors
///
/// The radius of the tool is not positive.
pub fn path(synthesis: &Design, tool: f64, points: usize) -> Result<CutterPath> {
    let tool = positive(tool)?;
    let cam = &synthesis.cam;
    let rows = cam.profile(points);
    let path: Vec<CutterPoint> = rows
        .iter()
        .map(|p| {
            let [nx, ny] = synthesis.cam.normal(p);
            CutterPoint {
                theta: p.theta,
                x: p.x + tool * nx,
                y: p.y + tool * ny,
            }
        })
        .collect();
    let mut gouges = Vec::new();
    let curvature = cam.curvature();
    if curvature.undercut {
        gouges.push(Gouge::Undercut {
            at: curvature.convex.at,
        });
    }
    if let Some(hollow) = curvature.concave.filter(|c| -c.value < tool) {
        gouges.push(Gouge::Hollow {
            at: hollow.at,
            radius: -hollow.value,
        });
    }
    let profile: Vec<[f64; 2]> = rows.iter().map(|p| [p.x, p.y]).collect();
    if gouges.is_empty()
        && let Some((i, k, depth)) = deepest(&path, &profile, tool)
    {
        gouges.push(Gouge::Elsewhere {
            at: path[i].theta,
            damaged: path[k].theta,
            depth,
        });
    }
    Ok(CutterPath {
        points: path,
        gouges,
    })
}

/// Checks that the radius of a cutter is positive.
pub(crate) fn positive(radius: f64) -> Result<f64> {
    if radius.is_finite() && radius > 0.0 {
        return Ok(radius);
    }
    Err(WriteError::CutterRadius {
        radius: Quantity::length(radius),
    }
    .into())
}

/// Deepest penetration of the cutter into the profile. Returns the index of the point that is cut, the index of the damaged point, and the
/// depth in m. `None` if the cutter does not damage the profile.
fn deepest(path: &[CutterPoint], profile: &[[f64; 2]], tool: f64) -> Option<(usize, usize, f64)> {
    let mut worst: Option<(usize, usize, f64)> = None;
    for (i, c) in path.iter().enumerate() {
        for (k, p) in profile.iter().enumerate() {
            let (dx, dy) = (p[0] - c.x, p[1] - c.y);
            if dx.abs() >= tool || dy.abs() >= tool {
                continue;
            }
            let depth = tool - libm::hypot(dx, dy);
            if depth > TOUCH && worst.is_none_or(|w| depth > w.2) {
                worst = Some((i, k, depth));
            }
        }
    }
    worst
}

/// The path as CSV with the columns `theta_rad,x_m,y_m`, in full precision.
pub fn csv(path: &CutterPath) -> String {
    let mut out = String::from("theta_rad,x_m,y_m\n");
    for p in &path.points {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "{:?},{:?},{:?}", p.theta, p.x, p.y);
    }
    out
}
