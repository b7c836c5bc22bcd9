//! `cutter.nc`, run by a machine that knows nothing of its writer: what the cutter leaves is the cam.

use std::f64::consts::TAU;

use gaitcam::cam::Follower;
use gaitcam::law::Law;
use gaitcam::synth::Design;
use gaitcam_output::gcode;

use crate::designs::{footbridge, heel_tester};

/// One cut: a line or an arc, mm, with its feed.
#[derive(Debug, Clone, Copy)]
struct Cut {
    from: [f64; 2],
    to: [f64; 2],
    /// Centre, and angle turned through, positive counter-clockwise.
    arc: Option<([f64; 2], f64)>,
    feed: f64,
}

/// Runs a program of G0, G1, G2 and G3 in the plane; comments and words it does not know are refused.
fn run(program: &str) -> Vec<Cut> {
    let mut cuts = Vec::new();
    let (mut at, mut feed) = ([0.0, 0.0], 0.0);
    for line in program.lines() {
        let line = line.split('(').next().unwrap().trim();
        let mut word = std::collections::BTreeMap::new();
        for w in line.split_whitespace().filter(|w| *w != "%") {
            let (letter, value) = w.split_at(1);
            word.insert(
                letter.to_string() + if letter == "G" { value } else { "" },
                value,
            );
        }
        let value = |letter: &str| word.get(letter).map(|v| v.parse::<f64>().unwrap());
        feed = value("F").unwrap_or(feed);
        let to = [value("X").unwrap_or(at[0]), value("Y").unwrap_or(at[1])];
        let centre = || [at[0] + value("I").unwrap(), at[1] + value("J").unwrap()];
        let angle = |c: [f64; 2], p: [f64; 2]| (p[1] - c[1]).atan2(p[0] - c[0]);
        let arc = if word.contains_key("G2") {
            let c = centre();
            Some((c, -(angle(c, at) - angle(c, to)).rem_euclid(TAU)))
        } else if word.contains_key("G3") {
            let c = centre();
            Some((c, (angle(c, to) - angle(c, at)).rem_euclid(TAU)))
        } else {
            None
        };
        if arc.is_some() || word.contains_key("G1") {
            cuts.push(Cut {
                from: at,
                to,
                arc,
                feed,
            });
        }
        at = to;
    }
    cuts
}

impl Cut {
    /// Distance of a point from this part of the path.
    fn distance(&self, p: [f64; 2]) -> f64 {
        let to = |q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        let ends = to(self.from).min(to(self.to));
        let Some((c, turned)) = self.arc else {
            let d = [self.to[0] - self.from[0], self.to[1] - self.from[1]];
            let along = d[0] * (p[0] - self.from[0]) + d[1] * (p[1] - self.from[1]);
            let part = along / (d[0] * d[0] + d[1] * d[1]);
            let foot = [self.from[0] + part * d[0], self.from[1] + part * d[1]];
            return if (0.0..=1.0).contains(&part) {
                to(foot)
            } else {
                ends
            };
        };
        let start = (self.from[1] - c[1]).atan2(self.from[0] - c[0]);
        let place = (p[1] - c[1]).atan2(p[0] - c[0]);
        let passed = (turned.signum() * (place - start)).rem_euclid(TAU);
        if passed <= turned.abs() {
            (to(c) - self.radius()).abs()
        } else {
            ends
        }
    }

    fn radius(&self) -> f64 {
        let (c, _) = self.arc.unwrap();
        (self.from[0] - c[0]).hypot(self.from[1] - c[1])
    }
}

/// Deepest gouge and highest ridge that the program leaves on the true profile, mm.
fn swept(design: &Design, cuts: &[Cut], tool: f64) -> [f64; 2] {
    let mut out = [0.0_f64; 2];
    for p in design.cam.profile(5000) {
        let p = [1e3 * p.x, 1e3 * p.y];
        let near = cuts
            .iter()
            .map(|c| c.distance(p))
            .fold(f64::INFINITY, f64::min);
        out = [out[0].max(tool - near), out[1].max(near - tool)];
    }
    out
}

/// A cycloid-like cam under a roller with hollow flanks.
fn hollow() -> Design {
    let mut design = heel_tester();
    design.cam.law = Law::harmonic(0.02, &[(0.0, 0.0), (0.0, 0.0), (0.012, 0.0)]);
    design.cam.follower = Follower::RollerTranslating {
        prime_radius: 0.05,
        offset: 0.0,
        roller_radius: 0.01,
    };
    design
}

#[test]
fn the_swept_cutter_leaves_the_cam_to_a_micrometre() {
    let concave = hollow().cam.curvature().concave.map(|c| -c.value);
    assert!(concave.is_some_and(|r| r > 0.006), "{concave:?}");
    for (design, tool) in [
        (footbridge(), 0.006),
        (heel_tester(), 0.003),
        (hollow(), 0.005),
    ] {
        let program = gcode::program(&design, tool).unwrap().unwrap();
        let cuts = run(&program);
        assert!(cuts.len() > 10, "{}", design.name);
        for pair in cuts.windows(2) {
            assert_eq!(pair[0].to, pair[1].from);
        }
        // Both leads are tangential: without them the path is closed.
        let n = cuts.len();
        let ends = [cuts[1].from, cuts[n - 2].to];
        assert!((ends[0][0] - ends[1][0]).hypot(ends[0][1] - ends[1][1]) < 2e-4);
        let [gouged, left] = swept(&design, &cuts, 1e3 * tool);
        assert!(
            gouged < 1e-3 && left < 1e-3,
            "{}: {gouged} {left}",
            design.name
        );
        // A wider cutter on this path would gouge: the sweep is able to see it.
        let [gouged, _] = swept(&design, &cuts, 1e3 * tool + 0.01);
        assert!(gouged > 0.009);
    }
}

#[test]
fn the_contact_moves_with_one_feed() {
    let tool = 5.0;
    let program = gcode::program(&hollow(), 1e-3 * tool).unwrap().unwrap();
    let cuts = run(&program);
    let (mut convex, mut concave) = (0, 0);
    for cut in &cuts[1..cuts.len() - 1] {
        let Some((_, turned)) = cut.arc else { continue };
        let path = cut.radius();
        // Clockwise arcs run around the cam, others through its hollows.
        let profile = if turned < 0.0 {
            path - tool
        } else {
            path + tool
        };
        let feed = cut.feed * profile / path;
        // Written anew at 1 %, in whole mm/min.
        assert!((feed / 200.0 - 1.0).abs() < 0.02, "{cut:?}: {feed}");
        if turned < 0.0 {
            convex += 1
        } else {
            concave += 1
        }
    }
    assert!(convex > 5 && concave > 5, "{convex} {concave}");
}

#[test]
fn a_cutter_wider_than_a_hollow_has_no_program() {
    let design = hollow();
    let radius = -design.cam.curvature().concave.unwrap().value;
    assert_eq!(gcode::program(&design, 1.05 * radius).unwrap(), None);
    assert!(gcode::program(&design, 0.0).is_err());
}
