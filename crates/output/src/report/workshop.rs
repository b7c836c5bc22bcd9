//! The report's section for those who make the cam: hollows, walls, mass and balance.

use std::f64::consts::PI;

use gaitcam::cam::{Bore, Hole, LEAST_WALL, Making};
use gaitcam::synth::Design;

use super::heading;
use super::tables::{Rows, table};
use crate::words::Words;

/// Density of steel, kg/m³.
const STEEL: f64 = 7850.0;

/// The section; nothing for a cam that does not turn.
pub fn section(out: &mut String, design: &Design, words: &Words) {
    if design.cam.follower.is_unrolled() {
        return;
    }
    heading(out, &words.text("report-workshop"));
    out.push_str("<div class=\"columns\">\n");
    table(out, words, "report-cutting", &cutting(design, words));
    let balance = balance(design, words);
    if !balance.is_empty() {
        table(out, words, "report-balance", &balance);
    }
    out.push_str("</div>\n");
}

fn cutting(design: &Design, words: &Words) -> Rows {
    let cam = &design.cam;
    let hollow = cam.curvature().concave.map(|c| -c.value);
    let cutter = match hollow {
        Some(radius) => words.fill(
            "report-cutter-fits",
            &[("radius", &words.millimetres(radius))],
        ),
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
        let thick = words.millimetres(wall);
        let least = words.millimetres(LEAST_WALL);
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

/// Smallest distance along a ray from the edge of the bore to the profile, m.
fn least_wall(design: &Design, bore: &Bore) -> f64 {
    let profile = design.cam.profile(7200);
    let walls = profile
        .iter()
        .map(|p| p.x.hypot(p.y) - bore.edge(p.y.atan2(p.x)));
    walls.fold(f64::INFINITY, f64::min)
}

fn balance(design: &Design, words: &Words) -> Rows {
    let Some(body) = design.cam.body(design.problem.cam.hole()) else {
        return Vec::new();
    };
    let per_area = STEEL * design.problem.cam.thickness;
    let grams = |kilograms: f64| format!("{} g", words.number(1e3 * kilograms));
    let mut rows = vec![(words.text("report-cam-mass"), grams(per_area * body.area))];
    rows.push((words.text("report-centroid"), polar(body.centroid, words)));
    let unbalance = 1e6 * per_area * body.moment();
    rows.push((
        words.text("report-unbalance"),
        format!("{} g·mm", words.number(unbalance)),
    ));
    let push = per_area * body.moment() * design.problem.drive.speed * design.problem.drive.speed;
    rows.push((
        words.text("report-unbalance-force"),
        format!("{} N", words.number(push)),
    ));
    let making = Making {
        balance: true,
        ..design.problem.cam.making().clone()
    };
    let hole = match making.balance_hole(&design.cam, design.problem.cam.hole()) {
        Some(Hole { centre, diameter }) => {
            let (diameter, place) = (words.millimetres(diameter), polar(centre, words));
            words.fill(
                "report-hole-at",
                &[("diameter", &diameter), ("place", &place)],
            )
        }
        None => words.text("report-no-hole"),
    };
    rows.push((words.text("report-hole"), hole));
    rows
}

/// Distance from the centre and angle from the mark of θ = 0 clockwise, as the drawing has them.
fn polar([x, y]: [f64; 2], words: &Words) -> String {
    let angle = words.degrees(x.atan2(y).rem_euclid(2.0 * PI));
    format!("R {}, φ {angle}", words.millimetres(x.hypot(y)))
}
