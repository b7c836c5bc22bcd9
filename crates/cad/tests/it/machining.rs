//! `cutter.nc`, executed by an independent interpreter: the remaining material is the cam.

use std::f64::consts::TAU;

use gaitcam::cam::{Follower, Wall};
use gaitcam::law::Law;
use gaitcam::synth::Design;
use gaitcam_cad::Units;
use gaitcam_cad::gcode::{self, Milling};

use gaitcam_test_support::designed;

use gaitcam_test_support::designs::{footbridge, heel_tester, with_bore, with_cam};

/// A cut along a line or an arc, mm, with its feed.
#[derive(Debug, Clone, Copy)]
struct Cut {
    from: [f64; 2],
    to: [f64; 2],
    /// Centre of the arc, and its angle, positive counter-clockwise.
    arc: Option<([f64; 2], f64)>,
    feed: f64,
}

/// Executes a program of G0, G1, G2 and G3 in the plane. Comments and unknown words are rejected.
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

/// Maximum depth of gouges and maximum height of ridges of the program on the exact profile, mm.
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

/// A cam similar to a cycloid with a roller and concave flanks.
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
        let program = &gcode::milling(&design, &Milling::of(tool)).unwrap()[0];
        let cuts = run(program);
        assert!(cuts.len() > 10, "{}", design.problem.name);
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
            design.problem.name
        );
        // A wider cutter on this path would gouge: the sweep is able to see it.
        let [gouged, _] = swept(&design, &cuts, 1e3 * tool + 0.01);
        assert!(gouged > 0.009);
    }
}

#[test]
fn the_bore_is_milled_before_the_outside_where_the_cutter_has_room() {
    for (bore, is_keyed) in [(0.012, false), (0.03, true)] {
        let design = with_bore(footbridge(), bore, is_keyed);
        let program = &gcode::milling(&design, &Milling::of(0.004)).unwrap()[0];
        assert_eq!(program.contains("KEYWAY IS NOT MILLED"), is_keyed);
        let cuts = run(program);
        // The contact on the bore moves with the feed of the profile.
        let path = 500.0 * bore - 4.0;
        let around = |c: &&Cut| c.arc.is_some() && (c.radius() - path).abs() < 1e-3;
        let feeds: Vec<f64> = (cuts[..4].iter().filter(around))
            .map(|c| c.feed * 500.0 * bore / path)
            .collect();
        assert_eq!(feeds.len(), 2);
        assert!(
            feeds.iter().all(|f| (f / 200.0 - 1.0).abs() < 0.02),
            "{feeds:?}"
        );
        for i in 0..360 {
            let (sin, cos) = f64::from(i).to_radians().sin_cos();
            let rim = [500.0 * bore * cos, 500.0 * bore * sin];
            let near = cuts.iter().map(|c| c.distance(rim));
            let left = near.fold(f64::INFINITY, f64::min) - 4.0;
            assert!(left.abs() < 1e-3, "{bore} at {i}: {left}");
        }
    }
    let wide =
        &gcode::milling(&with_bore(footbridge(), 0.03, true), &Milling::of(0.016)).unwrap()[0];
    assert!(wide.contains("BORE IS NOT MILLED") && !wide.contains("BORE, TOOL"));
}

#[test]
fn the_contact_moves_with_one_feed() {
    let tool = 5.0;
    let program = &gcode::milling(&hollow(), &Milling::of(1e-3 * tool)).unwrap()[0];
    let cuts = run(program);
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
    assert!(gcode::milling(&design, &Milling::of(1.05 * radius)).is_err());
    assert!(gcode::milling(&design, &Milling::of(0.95 * radius)).is_ok());
    assert!(gcode::milling(&design, &Milling::of(0.0)).is_err());
    assert!(gcode::wire(&design, f64::NAN, Units::Millimetres).is_err());
}

#[test]
fn both_cams_of_a_pair_are_left_by_their_programs() {
    let design = designed("camdas_07_conjugate_roller");
    let tool = 4.0;
    let programs = gcode::milling(&design, &Milling::of(1e-3 * tool)).unwrap();
    assert_eq!(programs.len(), 2);
    let cuts = run(&programs[1]);
    let pair = design.conjugate.as_ref().unwrap();
    for p in pair.second.profile(3000) {
        // As it stands on the shaft: turned by half a turn.
        let p = [-1e3 * p.x, -1e3 * p.y];
        let near = cuts
            .iter()
            .map(|c| c.distance(p))
            .fold(f64::INFINITY, f64::min);
        assert!((near - tool).abs() < 1e-3, "{p:?}: {near}");
    }
}

/// Positions of a program for a rotary axis: X, mm, and A, rad, with the time of each line, min.
fn stations(program: &str) -> Vec<[f64; 3]> {
    let mut at = [0.0; 3];
    let mut out = Vec::new();
    for line in program
        .lines()
        .filter(|line| line.starts_with("G0 ") || line.starts_with("G1 "))
    {
        for word in line.split_whitespace().skip(1) {
            let value: f64 = word[1..].parse().unwrap();
            match &word[..1] {
                "X" => at[0] = value,
                "A" => at[1] = value.to_radians(),
                "F" => at[2] = 1.0 / value,
                other => panic!("{other}"),
            }
        }
        out.push(at);
    }
    out
}

/// Minimum distance, mm, between a point of the barrel and the axis of the cutter on the path; only lines nearer than `far` are considered.
///
/// The barrel turns by A; the axis of the cutter is the x axis of the barrel at the height X.
fn distance_from_axis(path: &[[f64; 3]], p: [f64; 3], far: f64) -> f64 {
    let off = |x: f64, a: f64| {
        let (sin, cos) = a.sin_cos();
        let along = cos * p[0] - sin * p[1];
        let aside = sin * p[0] + cos * p[1];
        if along > 0.0 {
            aside.hypot(p[2] - x)
        } else {
            f64::INFINITY
        }
    };
    let mut least = f64::INFINITY;
    for pair in path.windows(2) {
        let at = |u: f64| {
            off(
                pair[0][0] + u * (pair[1][0] - pair[0][0]),
                pair[0][1] + u * (pair[1][1] - pair[0][1]),
            )
        };
        // Far lines cannot touch: a line is at most 5 degrees long.
        if at(0.5) > far {
            continue;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if at(a) < at(b) { high = b } else { low = a }
        }
        least = least.min(at(0.5 * (low + high)));
    }
    least
}

#[test]
fn the_swept_cutter_leaves_the_groove_of_a_barrel_to_a_micrometre() {
    let design = designed("thesis_barrel");
    let groove = design.groove.as_ref().unwrap();
    let tool = 5.25;
    let program = &gcode::milling(&design, &Milling::of(1e-3 * tool)).unwrap()[0];
    let path = stations(program);
    let (floor, surface) = groove.depth();
    let (mut gouged, mut left) = (0.0_f64, 0.0_f64);
    for i in 0..400 {
        let theta = 2.0 * TAU * (f64::from(i) + 0.37) / 400.0;
        for radius in [floor, 0.5 * (floor + surface), surface] {
            for wall in [Wall::Lower, Wall::Upper] {
                let p = groove.wall_point(theta, radius, wall).map(|x| 1e3 * x);
                // Where the groove crosses itself, both ways round, the other turn takes the wall away.
                let near = distance_from_axis(&path, p, 2.0 * tool);
                let crossed = (theta.rem_euclid(TAU) - 0.5 * TAU).abs() < 0.9;
                if !crossed {
                    gouged = gouged.max(tool - near);
                }
                left = left.max(near - tool);
            }
        }
    }
    assert!(gouged < 1e-3 && left < 1e-3, "{gouged} {left}");
    // The feed along the surface is never above what is stated, nor needlessly below.
    let fastest = path.windows(2).skip(1).map(|pair| {
        let turned = 30.0 * (pair[1][1] - pair[0][1]);
        turned.hypot(pair[1][0] - pair[0][0]) / pair[1][2]
    });
    let fastest = fastest.fold(0.0, f64::max);
    assert!((199.0..201.0).contains(&fastest), "{fastest}");
    // Another cutter leaves another groove.
    assert!(gcode::milling(&design, &Milling::of(5e-3)).is_err());
}

#[test]
fn a_wire_cuts_hole_keyway_and_outside_from_its_start_holes() {
    let design = with_bore(hollow(), 0.02, true);
    let bore = design.problem.cam.hole().unwrap();
    let wire = 0.14;
    let program = gcode::wire(&design, 1e-3 * wire, Units::Millimetres).unwrap();
    let cuts = run(&program);
    let [gouged, left] = swept(&design, &cuts, wire);
    assert!(gouged < 1e-3 && left < 1e-3, "{gouged} {left}");
    // The hole, from its centre: every point of its edge, but the two corners that the wire cannot reach, is cut.
    let corner = [0.5 * 6.0, 10.0 + 2.8];
    for i in 0..5_000 {
        let a = TAU * f64::from(i) / 5_000.0;
        let r = 1e3 * bore.edge(a);
        let p = [r * a.cos(), r * a.sin()];
        let near = cuts
            .iter()
            .map(|c| c.distance(p))
            .fold(f64::INFINITY, f64::min);
        assert!(near > wire - 1e-3, "{p:?}: gouged, {near}");
        let in_corner = (p[0].abs() - corner[0]).hypot(p[1] - corner[1]) < 1.01 * wire;
        assert!(in_corner || near < wire + 1e-3, "{p:?}: left, {near}");
    }
    let first = cuts[0];
    assert_eq!(first.from, [0.0, 0.0]);
    // A wire wider than the keyway.
    assert!(gcode::wire(&design, 3.1e-3, Units::Millimetres).is_err());
}

#[test]
fn a_program_in_inches_leaves_the_same_cam() {
    let design = footbridge();
    let cut = Milling {
        units: Units::Inches,
        ..Milling::of(0.006)
    };
    let program = &gcode::milling(&design, &cut).unwrap()[0];
    assert!(program.contains("G20") && program.contains("RADIUS OF CUTTER 0.23622 IN"));
    assert!(program.contains("FEED 7.87 IN/MIN AT THE PROFILE, CLIMB MILLING"));
    let inch = |p: [f64; 2]| p.map(|x| 25.4 * x);
    let cuts = run(program).into_iter().map(|c| Cut {
        from: inch(c.from),
        to: inch(c.to),
        arc: c.arc.map(|(centre, angle)| (inch(centre), angle)),
        feed: c.feed,
    });
    let [gouged, left] = swept(&design, &cuts.collect::<Vec<_>>(), 6.0);
    assert!(gouged < 1e-3 && left < 1e-3, "{gouged} {left}");
    let wire = gcode::wire(&design, 1e-4, Units::Inches).unwrap();
    assert!(wire.contains("G90 G20"));
    let barrel = designed("thesis_barrel");
    let tool = barrel.groove.as_ref().unwrap().roller_radius();
    let cut = Milling { tool, ..cut };
    assert!(gcode::milling(&barrel, &cut).unwrap()[0].contains("G90 G20"));
}

#[test]
fn passes_reach_the_bottom_of_the_plate_and_each_runs_the_whole_path() {
    let thin = with_cam(footbridge(), |cam| cam.thickness = 0.01);
    let design = with_bore(thin, 0.014, false);
    let whole = Milling::of(0.003);
    let in_passes = |pass: f64| {
        let pass = Some(pass);
        gcode::milling(&design, &Milling { pass, ..whole })
    };
    let program = in_passes(0.003).unwrap().remove(0);
    let depths = |program: &str| -> Vec<f64> {
        let plunges = program.lines().filter(|l| l.starts_with("G1 Z"));
        plunges
            .map(|l| l[4..].split(' ').next().unwrap().parse().unwrap())
            .collect()
    };
    // Of the bore and of the outside.
    let each = [-3.0, -6.0, -9.0, -10.0];
    assert_eq!(depths(&program), [each, each].concat());
    assert_eq!(program.matches("S2000 M3").count(), 1);
    assert!(program.contains("M5\nM30") && !program.contains("M0"));
    // Every move in the plane is made at depth, and fast ones above the plate.
    let mut z = f64::INFINITY;
    for line in program.lines() {
        let code = |code: &str| line.starts_with(code);
        if let Some(to) = line.split(" Z").nth(1) {
            z = to.split(' ').next().unwrap().parse().unwrap();
        } else if code("G0 ") {
            assert!(z > 0.0, "{line}");
        } else if code("G1 ") || code("G2 ") || code("G3 ") {
            assert!(z < 0.0, "{line}");
        }
    }
    let moves = |program: &str| run(program).iter().filter(|c| c.arc.is_some()).count();
    let one = gcode::milling(&design, &whole).unwrap().remove(0);
    assert_eq!(moves(&program), 4 * moves(&one));
    // A depth that the plate is a multiple of takes no empty pass.
    assert_eq!(depths(&in_passes(0.005).unwrap()[0]).len(), 4);
    // A plate of 10 mm in a thousand passes, and no more.
    assert!(in_passes(1.001e-5).is_ok());
    let faulty = [0.0, -1e-3, 0.999e-5, 1e-12, f64::NAN];
    assert!(faulty.into_iter().all(|pass| in_passes(pass).is_err()));
}
