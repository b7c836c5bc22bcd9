//! The drawings contain all edges to be cut and no other lines on their layers.

use std::f64::consts::PI;

use gaitcam::cam::{Bore, Wall};
use gaitcam::drive::Drive;
use gaitcam::synth::Design;
use gaitcam_cad::Units;
use gaitcam_cad::dxf::{Content, Curves};

use gaitcam_test_support::designed;
use gaitcam_test_support::readers::{attribute, elements};

use crate::drawing::{Drawing, read};
use gaitcam_test_support::designs::{footbridge, heel_tester, impossible, with_bore, with_cam};

fn drawn(s: &Design) -> Drawing {
    read(&gaitcam_cad::dxf::profile(
        s,
        720,
        Content::All,
        Curves::Arcs,
        Units::Millimetres,
    ))
}

/// Data of a path in an SVG.
fn path(svg: &str, id: &str) -> String {
    let at = svg.split(&format!("id=\"{id}\" d=\"")).nth(1);
    at.unwrap_or_else(|| panic!("no {id}"))
        .split('"')
        .next()
        .unwrap()
        .to_string()
}

#[test]
fn an_unrolled_barrel_shows_both_walls_open_from_end_to_end() {
    let s = designed("thesis_barrel");
    let d = drawn(&s);
    // Two turns on R 30 mm.
    let length = 4.0 * PI * 30.0;
    for layer in ["CUT_PROFILE", "CUT_UPPER_WALL", "REF_PITCH_CURVE"] {
        let (v, closed) = d.outline(layer);
        let (first, last) = (v[0], v[v.len() - 1]);
        assert!(!closed, "{layer} closes");
        assert!(
            first[0].abs() < 1e-9 && (last[0] - length).abs() < 1e-9,
            "{layer}: {last:?}"
        );
        // The law closes: both ends are at one height.
        assert!((first[1] - last[1]).abs() < 1e-9);
    }
    assert!(
        d.circles.is_empty(),
        "nothing is round in an unrolled drawing"
    );
    // Vertices of the arcs lie on the walls as the groove itself has them.
    let groove = s.groove.as_ref().unwrap();
    for (layer, wall, side) in [
        ("CUT_PROFILE", Wall::Lower, -1.0),
        ("CUT_UPPER_WALL", Wall::Upper, 1.0),
    ] {
        let exact: Vec<[f64; 2]> = (0..=40_000)
            .map(|i| {
                let theta = 4.0 * PI * f64::from(i) / 40_000.0;
                // z = s ± (e + R_f cos φ), δ = θ ∓ (R_f/R) sin φ (theory §4).
                let (sin, cos) = groove.pressure_angle(theta, 0.03).sin_cos();
                let rolling = side * groove.roller_radius();
                let z = groove.law().svaj(theta).s + groove.axis_offset(wall) + rolling * cos;
                [30.0 * theta - 1e3 * rolling * sin, 1e3 * z]
            })
            .collect();
        for v in d.outline(layer).0 {
            let near = exact
                .iter()
                .map(|q| (q[0] - v[0]).hypot(q[1] - v[1]))
                .fold(f64::INFINITY, f64::min);
            // Half a step of the exact wall.
            assert!(near < 0.006, "{layer}: {v:?} is {near} mm off");
        }
    }
    // At rest in height the rollers of 5.25 mm stand 0.25 mm off their stud to either side.
    assert!((d.outline("CUT_PROFILE").0[0][1] + 5.5).abs() < 1e-9);
    assert!((d.outline("CUT_UPPER_WALL").0[0][1] - 5.5).abs() < 1e-9);

    let svg = gaitcam_cad::svg::profile(&s, 720);
    for id in ["profile", "upper-wall", "pitch-curve"] {
        let d = path(&svg, id);
        assert!(!d.ends_with('Z'), "{id} closes");
        let last = d.rsplit('L').next().unwrap();
        let x: f64 = last.split(' ').next().unwrap().parse().unwrap();
        assert!((x - length).abs() < 1e-6, "{id} ends at {x}");
    }
    assert!(!svg.contains("<circle"));
}

#[test]
fn a_sliding_cam_has_a_foot_and_no_circles() {
    let s = designed("translating_cam");
    let d = drawn(&s);
    assert!(d.circles.is_empty());
    let (v, closed) = d.outline("CUT_PROFILE");
    assert!(!closed && (v[v.len() - 1][0] - 160.0).abs() < 1e-9);
    let svg = gaitcam_cad::svg::profile(&s, 720);
    assert!(!svg.contains("<circle") && !path(&svg, "profile").ends_with('Z'));
    assert_eq!(path(&svg, "foot"), "M0 0L160 0");
}

#[test]
fn both_cams_of_a_pair_are_drawn_as_they_stand_on_the_shaft() {
    for scene in ["camdas_07_conjugate_roller", "camdas_08_conjugate_flat"] {
        let s = designed(scene);
        let pair = s.conjugate.as_ref().unwrap();
        let fine = pair.second_profile(60_000);
        let (v, closed) = drawn(&s).outline("CUT_SECOND_PROFILE");
        assert!(closed && v.len() > 16);
        for v in v {
            let square = |[x, y]: [f64; 2]| x * x + y * y;
            let near = fine
                .iter()
                .map(|p| square([1e3 * p.x - v[0], 1e3 * p.y - v[1]]))
                .fold(f64::INFINITY, f64::min)
                .sqrt();
            assert!(near < 0.012, "{scene}: {v:?} is {near} mm off");
        }
        assert!(path(&gaitcam_cad::svg::profile(&s, 360), "second-profile").ends_with('Z'));
    }
}

#[test]
fn r12_declares_millimetres_and_the_extents_of_the_drawing() {
    let s = designed("camdas_01_roller");
    let d = drawn(&s);
    // 4 is millimetres in that variable.
    assert_eq!(d.header["$INSUNITS"][1], (70, "4".to_string()));
    let prime = 1e3 * s.cam.follower.prime_radius();
    let mut extent = [[-prime; 2], [prime; 2]];
    for p in s.cam.profile(20_000) {
        for (x, k) in [(p.x, 0), (p.y, 1), (p.pitch_x, 0), (p.pitch_y, 1)] {
            extent[0][k] = extent[0][k].min(1e3 * x);
            extent[1][k] = extent[1][k].max(1e3 * x);
        }
    }
    let (low, high) = (d.corner("$EXTMIN"), d.corner("$EXTMAX"));
    for (read, known) in [
        (low[0], extent[0][0]),
        (low[1], extent[0][1]),
        (high[0], extent[1][0]),
        (high[1], extent[1][1]),
    ] {
        // The pitch curve is drawn in chords of half a degree.
        assert!((read - known).abs() < 2e-3, "{read} for {known}");
    }
}

#[test]
fn what_is_cut_lies_on_its_own_layers_and_can_be_had_alone() {
    for mut s in [
        footbridge(),
        heel_tester(),
        designed("camdas_07_conjugate_roller"),
        designed("thesis_barrel"),
    ] {
        let scene = s.problem.name.clone();
        s = with_bore(s, 0.01, false);
        let all = drawn(&s);
        let cut = read(&gaitcam_cad::dxf::profile(
            &s,
            720,
            Content::CutOnly,
            Curves::Arcs,
            Units::Millimetres,
        ));
        assert!(cut.layers.iter().all(|l| l.starts_with("CUT_")), "{scene}");
        assert!(
            all.layers
                .iter()
                .all(|l| l.starts_with("CUT_") || l.starts_with("REF_"))
        );
        let of = |d: &Drawing| d.layers.iter().filter(|l| l.starts_with("CUT_")).count();
        assert!(of(&cut) > 0 && of(&cut) == of(&all), "{scene}");
        let round = !s.cam.follower.is_unrolled();
        for mark in ["REF_THETA_ZERO", "REF_ROTATION"] {
            assert_eq!(
                all.layers.iter().any(|l| l == mark),
                round,
                "{scene}: {mark}"
            );
        }
    }
}

#[test]
fn the_arrow_turns_as_the_machine_does() {
    for speed in [4.0, -4.0] {
        let own = footbridge();
        let drive = Drive {
            speed,
            ..own.problem.drive
        };
        let s = own.moved_to(drive, None);
        let (arc, _) = drawn(&s).outline("REF_ROTATION");
        let (a, b) = (arc[0], arc[1]);
        // Counter-clockwise as θ grows: the cross product of start and end has the sign of the speed.
        assert!((a[0] * b[1] - a[1] * b[0]) * speed > 0.0 && a[2] * speed > 0.0);
    }
}

/// Instances of a STEP file by their numbers.
fn instances(text: &str) -> std::collections::HashMap<usize, String> {
    let lines = text.lines().filter_map(|line| line.strip_prefix('#'));
    lines
        .filter_map(|line| {
            let (number, rest) = line.split_once('=')?;
            Some((number.parse().unwrap(), rest.to_string()))
        })
        .collect()
}

#[test]
fn a_step_file_refers_only_to_what_it_holds_and_closes_its_shell() {
    for mut s in [footbridge(), heel_tester()] {
        s = with_bore(s, 0.01, false);
        let bytes = gaitcam_cad::step::solid(&s).unwrap();
        assert_eq!(bytes, gaitcam_cad::step::solid(&s).unwrap());
        let text = String::from_utf8(bytes).unwrap();
        let all = instances(&text);
        for entity in all.values() {
            for reference in entity.split('#').skip(1) {
                let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
                assert!(all.contains_key(&digits.parse().unwrap()), "{entity}");
            }
        }
        // Every edge of a closed shell is used twice, once along and once against its sense.
        let uses = |sense: &str| -> Vec<String> {
            let mut edges: Vec<String> = (all.values())
                .filter(|e| e.starts_with("ORIENTED_EDGE") && e.contains(sense))
                .map(|e| {
                    e.split('#')
                        .nth(1)
                        .unwrap()
                        .split(',')
                        .next()
                        .unwrap()
                        .to_string()
                })
                .collect();
            edges.sort();
            edges
        };
        assert_eq!(uses(".T."), uses(".F."));
        let faces = all.values().filter(|e| e.starts_with("ADVANCED_FACE"));
        // Four walls, two half bores, below and above.
        assert_eq!(faces.count(), 8);
    }
}

#[test]
fn a_keyway_and_a_dot_add_their_faces_and_a_pair_has_two_solids() {
    let mut s = footbridge();
    let faces = |s: &Design| {
        let text = String::from_utf8(gaitcam_cad::step::solid(s).unwrap()).unwrap();
        let all = instances(&text);
        let count = |name: &str| all.values().filter(|e| e.starts_with(name)).count();
        (count("ADVANCED_FACE"), count("MANIFOLD_SOLID_BREP"))
    };
    s = with_bore(s, 0.02, true);
    // Four walls, three sides of the keyway, two arcs of the bore, below and above; two walls of the dot and its floor.
    assert_eq!(faces(&s), (11, 1));
    s = with_cam(s, |cam| cam.mark = true);
    assert_eq!(faces(&s), (14, 1));
    assert_eq!(faces(&designed("camdas_07_conjugate_roller")).1, 2);
}

/// Area inside a closed polyline with bulges, in the square of its unit.
fn area(vertices: &[[f64; 3]]) -> f64 {
    let mut twice = 0.0;
    for (i, &[x, y, bulge]) in vertices.iter().enumerate() {
        let [u, v, _] = vertices[(i + 1) % vertices.len()];
        twice += x * v - u * y;
        if bulge != 0.0 {
            let angle = 4.0 * bulge.atan();
            let radius = (u - x).hypot(v - y) / (2.0 * (0.5 * angle).sin());
            twice += radius * radius * (angle - angle.sin());
        }
    }
    0.5 * twice
}

#[test]
fn the_keyway_is_cut_as_the_standard_has_it() {
    let mut s = footbridge();
    s = with_bore(s, 0.02, true);
    let bore = s.problem.cam.hole().unwrap();
    let (edge, closed) = drawn(&s).outline("CUT_BORE");
    assert!(closed);
    // DIN 6885-1, shaft of 20 mm: 6 mm wide, 2.8 mm deep in the hub: 22.8 mm over the bore.
    let top = edge.iter().map(|v| v[1]).fold(f64::MIN, f64::max);
    assert!((top - 12.8).abs() < 1e-9);
    let corners = edge
        .iter()
        .filter(|v| v[1] == top)
        .map(|v| v[0])
        .fold(0.0, f64::max);
    assert!((corners - 3.0).abs() < 1e-9);
    // 100 π + 6·2.8 and the sliver between chord and bore, by hand: r² asin(3/10) − 3·√91.
    let wanted = 100.0 * PI + 6.0 * (12.8 - 91.0_f64.sqrt())
        - (100.0 * 0.3_f64.asin() - 3.0 * 91.0_f64.sqrt());
    assert!(
        (area(&edge) - wanted).abs() < 1e-6,
        "{} {wanted}",
        area(&edge)
    );
    // The printed plate has the same hole, in chords.
    let plate = |bore| gaitcam_cad::solid::Plate {
        thickness: 0.01,
        bore,
        points: 1440,
    };
    let volume = |bore: Option<Bore>| {
        let mesh = gaitcam_cad::solid::plate(&s, plate(bore)).unwrap();
        let at = |i: usize| mesh.vertices[i];
        let six: f64 = (mesh.triangles.iter())
            .map(|&[a, b, c]| {
                let (a, b, c) = (at(a), at(b), at(c));
                a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            })
            .sum();
        six / 6.0
    };
    let taken = volume(None) - volume(Some(bore));
    assert!((taken / (10.0 * wanted) - 1.0).abs() < 1e-4, "{taken}");
}

#[test]
fn profile_svg_is_as_large_as_the_cam() {
    for s in [footbridge(), heel_tester(), impossible()] {
        let svg = gaitcam_cad::svg::profile(&s, 1440);
        let all = elements(&svg);
        assert_eq!(all[0], "svg");
        let width: f64 = attribute(&svg, "width")
            .strip_suffix("mm")
            .unwrap()
            .parse()
            .unwrap();
        let view: Vec<f64> = attribute(&svg, "viewBox")
            .split(' ')
            .map(|x| x.parse().unwrap())
            .collect();
        assert_eq!(width, view[2]);
        let rows = s.cam.profile(1440);
        let (left, right) = rows.iter().fold((0.0_f64, 0.0_f64), |(l, r), p| {
            (l.min(p.pitch_x), r.max(p.pitch_x))
        });
        let prime = s.cam.follower.prime_radius();
        let extent = 1000.0 * (right.max(prime) - left.min(-prime)) + 10.0;
        assert!((width - extent).abs() < 1e-3);
        let path = svg.split("id=\"profile\" d=\"").nth(1).unwrap();
        let path = path.split('"').next().unwrap();
        assert!(path.ends_with('Z') && path.matches('L').count() == 1439);
    }
}
