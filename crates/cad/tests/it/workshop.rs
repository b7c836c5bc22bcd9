//! Files for the workshop in addition to the outline: solids, splines, drawings.

use std::collections::HashMap;

use gaitcam::cam::Follower;
use gaitcam::law::Law;
use gaitcam::synth::Design;
use gaitcam::wording::Language;
use gaitcam_cad::Units;
use gaitcam_cad::drawing::Title;
use gaitcam_cad::{drawing, dxf, solid, step};

use gaitcam_test_support::designed;

use crate::drawing::groups;
use crate::sheets::sheets;
use gaitcam_test_support::designs::{footbridge, heel_tester, with_bore, with_cam};

/// A disc with a small eccentricity, a keyway and a mark.
fn furnished() -> Design {
    let mut design = with_cam(with_bore(heel_tester(), 0.02, true), |cam| {
        cam.mark = true;
    });
    design.cam.law = Law::harmonic(0.0015, &[(0.0, 0.0015), (0.0, 0.0005)]);
    design.cam.follower = Follower::RollerTranslating {
        prime_radius: 0.07,
        offset: 0.0,
        roller_radius: 0.01,
    };
    design
}

/// Number of uses of each edge of a STEP file, along its direction and against it.
fn uses(text: &str) -> HashMap<&str, [usize; 2]> {
    let mut out: HashMap<&str, [usize; 2]> = HashMap::new();
    for line in text.lines().filter(|line| line.contains("=ORIENTED_EDGE(")) {
        let edge = line
            .split(['#', ','])
            .find(|part| part.chars().all(|c| c.is_ascii_digit()) && !part.is_empty());
        let along = usize::from(line.contains(",.T.)"));
        out.entry(edge.unwrap()).or_default()[along] += 1;
    }
    out
}

#[test]
fn every_edge_of_a_solid_bounds_two_faces_in_opposite_senses() {
    let slide = designed("translating_cam");
    let pair = designed("camdas_07_conjugate_roller");
    for design in [footbridge(), furnished(), pair, slide] {
        let text = String::from_utf8(step::solid(&design).unwrap()).unwrap();
        let edges = text
            .lines()
            .filter(|line| line.contains("=EDGE_CURVE("))
            .count();
        let uses = uses(&text);
        assert_eq!(uses.len(), edges, "{}", design.problem.name);
        assert!(
            uses.values().all(|n| *n == [1, 1]),
            "{}",
            design.problem.name
        );
    }
}

#[test]
fn a_barrel_has_neither_solid_nor_sheet() {
    let barrel = designed("thesis_barrel");
    assert!(step::solid(&barrel).is_err());
    assert!(drawing::pdf(&barrel, &TITLE, Language::En).is_none());
}

#[test]
fn the_mesh_with_a_keyway_is_closed() {
    let design = furnished();
    let plate = solid::Plate {
        thickness: design.problem.cam.thickness,
        bore: design.problem.cam.hole(),
        points: 2880,
    };
    let bored = solid::plate(&design, plate).unwrap();
    let mut edges: HashMap<(usize, usize), usize> = HashMap::new();
    for t in &bored.triangles {
        for k in 0..3 {
            *edges.entry((t[k], t[(k + 1) % 3])).or_default() += 1;
        }
    }
    assert!(
        edges
            .iter()
            .all(|((a, b), n)| *n == 1 && edges.contains_key(&(*b, *a)))
    );
}

/// Splines of a DXF file of degree 3: knots and control points.
fn splines(bytes: &[u8]) -> Vec<(Vec<f64>, Vec<[f64; 2]>)> {
    let all = groups(bytes);
    let starts: Vec<usize> = (0..all.len()).filter(|&i| all[i].0 == 0).collect();
    let objects = starts.windows(2).map(|w| &all[w[0]..w[1]]);
    objects
        .filter(|object| object[0].1 == "SPLINE")
        .map(|object| {
            let of = |code: i32| -> Vec<f64> {
                let own = object.iter().filter(|g| g.0 == code);
                own.map(|g| g.1.parse().unwrap()).collect()
            };
            let points: Vec<[f64; 2]> = of(10)
                .into_iter()
                .zip(of(20))
                .map(|(x, y)| [x, y])
                .collect();
            assert_eq!(of(71), [3.0]);
            assert_eq!(of(72), [of(40).len() as f64]);
            assert_eq!(of(73), [points.len() as f64]);
            assert_eq!(of(40).len(), points.len() + 4);
            (of(40), points)
        })
        .collect()
}

/// Point of a spline by de Boor's algorithm.
fn de_boor(knots: &[f64], control: &[[f64; 2]], t: f64) -> [f64; 2] {
    let last = control.len() - 1;
    let k = (3..=last).rev().find(|&k| knots[k] <= t).unwrap();
    let mut d: Vec<[f64; 2]> = (0..4).map(|j| control[j + k - 3]).collect();
    for r in 1..4 {
        for j in (r..4).rev() {
            let (low, high) = (knots[j + k - 3], knots[j + 1 + k - r]);
            let a = (t - low) / (high - low);
            d[j] = [0, 1].map(|i| (1.0 - a) * d[j - 1][i] + a * d[j][i]);
        }
    }
    d[3]
}

#[test]
fn splines_of_a_drawing_follow_the_profile_to_a_tenth_of_a_micrometre() {
    for design in [footbridge(), furnished()] {
        let bytes = dxf::profile(
            &design,
            720,
            dxf::Content::All,
            dxf::Curves::Splines,
            Units::Millimetres,
        );
        let drawn = crate::drawing::read(&bytes);
        assert_eq!(drawn.header["$ACADVER"][1].1, "AC1015");
        let all = splines(&bytes);
        assert_eq!(all.len(), 1, "{}", design.problem.name);
        let (knots, control) = &all[0];
        let profile = design.cam.profile(400_000);
        let n = profile.len();
        for i in 0..2000 {
            let t = knots[knots.len() - 1] * (f64::from(i) + 0.31) / 2000.0;
            let p = de_boor(knots, control, t);
            let near = (0..n).step_by(100).min_by(|&a, &b| {
                let far = |k: usize| (1e3 * profile[k].x - p[0]).hypot(1e3 * profile[k].y - p[1]);
                far(a).total_cmp(&far(b))
            });
            let near = near.unwrap() + n;
            let off = (near - 150..near + 150).map(|k| {
                let (a, b) = (&profile[k % n], &profile[(k + 1) % n]);
                let (dx, dy) = (1e3 * (b.x - a.x), 1e3 * (b.y - a.y));
                let (px, py) = (p[0] - 1e3 * a.x, p[1] - 1e3 * a.y);
                let u = ((px * dx + py * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
                (px - u * dx).hypot(py - u * dy)
            });
            let off = off.fold(f64::INFINITY, f64::min);
            assert!(off < 1e-4, "{}: {off} mm at {p:?}", design.problem.name);
        }
    }
    let barrel = designed("thesis_barrel");
    let bytes = dxf::profile(
        &barrel,
        720,
        dxf::Content::All,
        dxf::Curves::Splines,
        Units::Millimetres,
    );
    assert!(splines(&bytes).len() >= 4);
}

const TITLE: Title = Title {
    revision: None,
    date: None,
    accuracy: 0.005,
    units: Units::Millimetres,
};

#[test]
fn material_and_tolerance_stand_on_the_sheet() {
    let design = with_cam(furnished(), |cam| {
        cam.making.material = Some("42CrMo4".to_string());
        cam.making.hardness = gaitcam::cam::Hardness::parse("55 HRC");
        cam.making.roughness = Some(4e-7);
        cam.making.tolerance = Some(1e-5);
    });
    let pdf = drawing::pdf(&design, &TITLE, Language::En).unwrap();
    let sheets = sheets(&pdf);
    let has = |text: &str| sheets[0].iter().any(|s| s.text.contains(text));
    for text in ["42CrMo4, 55 HRC", "Ra 0.4", "\u{b1} 0.01 mm"] {
        assert!(has(text), "{text}");
    }
    {
        for s in crate::sheets::sheets(&drawing::pdf(&design, &TITLE, Language::Es).unwrap())
            .iter()
            .flatten()
        {
            let mm = s.at.map(|x| x * 25.4 / 72.0);
            assert!(mm[0] > 20.0 && mm[0] < 410.0, "{}: {mm:?}", s.text);
            assert!(mm[1] > 10.0 && mm[1] < 287.0, "{}: {mm:?}", s.text);
        }
    }
}
