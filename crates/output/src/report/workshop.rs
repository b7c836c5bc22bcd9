//! Section of the report for the manufacturer: concave radii and wall thickness.

use gaitcam::cam::Bore;
use gaitcam::synth::Design;

use super::heading;
use super::tables::{Rows, table};
use crate::words::Words;

/// Wall thickness between the bore and the profile below which the report warns, m.
const LEAST_WALL: f64 = 0.003;

/// Writes the section for the manufacturer. It is omitted for a cam that does not rotate.
pub fn section(out: &mut String, design: &Design, words: &Words) {
    if design.cam.follower.is_unrolled() {
        return;
    }
    heading(out, &words.text("report-workshop"));
    table(out, words, "report-cutting", &cutting(design, words));
}

fn cutting(design: &Design, words: &Words) -> Rows {
    let cam = &design.cam;
    let hollow = cam.curvature().concave.map(|c| -c.value);
    let cutter = match hollow {
        Some(radius) => words.fill("report-cutter-fits", &[("radius", &words.length(radius))]),
        None => words.text("report-any-cutter"),
    };
    let mut rows = vec![(words.text("report-largest-cutter"), cutter)];
    let roller = cam.follower.roller_radius();
    if let Some(radius) = hollow.filter(|_| roller > 0.0) {
        let ratio = words.number(radius / roller);
        rows.push((
            words.text("report-hollow-and-roller"),
            words.fill("report-times-roller", &[("ratio", &ratio)]),
        ));
    }
    if let Some(bore) = design.problem.cam.hole() {
        let wall = least_wall(design, &bore);
        let thick = words.length(wall);
        let least = words.length(LEAST_WALL);
        let arguments = [("wall", thick.as_str()), ("least", &least)];
        let key = if wall < LEAST_WALL {
            "report-wall-thin"
        } else {
            "report-wall-enough"
        };
        rows.push((words.text("report-wall"), words.fill(key, &arguments)));
    }
    rows
}

/// Minimum wall thickness between bore and profile, m, measured radially.
fn least_wall(design: &Design, bore: &Bore) -> f64 {
    let profile = design.cam.profile(7200);
    let walls = profile
        .iter()
        .map(|p| libm::hypot(p.x, p.y) - bore.edge(libm::atan2(p.y, p.x)));
    walls.fold(f64::INFINITY, f64::min)
}
