//! The outline to be cut, in DXF: comparison of its vertices and arcs with the exact profile.

use std::collections::HashMap;

use gaitcam::cam::{Bore, Cam, Follower};
use gaitcam::law::Law;
use gaitcam_cad::Units;
use gaitcam_cad::biarc;
use gaitcam_cad::dxf::{Content, Curves, Options, Version};

use crate::drawing::{groups, read};
use gaitcam_test_support::designs::{footbridge, heel_tester};

#[test]
fn dxf_is_the_closed_profile_in_true_millimetres_in_every_dialect() {
    let s = heel_tester();
    for version in [Version::R12, Version::R2000] {
        let options = Options {
            units: Units::Millimetres,
            points: 1440,
            version,
            bore: Some(Bore::plain(0.02)),
            content: Content::All,
        };
        let bytes = gaitcam_cad::dxf::drawing(&s, options);
        let drawing = read(&bytes);
        let (vertices, closed) = drawing.outline("CUT_PROFILE");
        assert!(closed && vertices.len() == 1440);
        for (v, p) in vertices.iter().zip(s.cam.profile(1440)) {
            assert!((v[0] - 1000.0 * p.x).abs() < 1e-9 && (v[1] - 1000.0 * p.y).abs() < 1e-9);
        }
        assert_eq!(drawing.outline("REF_PITCH_CURVE").0.len(), 1440);
        let radii: HashMap<String, f64> = drawing.circles.iter().cloned().collect();
        // Rp 3 in, roller 1 in, bore 20 mm.
        assert!((radii["REF_PRIME_CIRCLE"] - 76.2).abs() < 1e-9);
        assert!((radii["REF_BASE_CIRCLE"] - 50.8).abs() < 1e-9);
        assert!((radii["CUT_BORE"] - 10.0).abs() < 1e-9);
        assert_eq!(drawing.header["$INSUNITS"][1], (70, "4".to_string()));
    }
}

#[test]
fn r12_drawings_hold_nothing_that_r12_does_not_know() {
    let bytes = gaitcam_cad::dxf::profile(
        &heel_tester(),
        360,
        Content::All,
        Curves::Arcs,
        Units::Millimetres,
    );
    let drawing = read(&bytes);
    let arcs = drawing.outline("CUT_PROFILE").0.len();
    let all = groups(&bytes);
    let pairs: Vec<(i32, &str)> = all.iter().map(|(c, v)| (*c, v.as_str())).collect();
    assert_eq!(pairs.last(), Some(&(0, "EOF")));
    assert!(pairs.contains(&(1, "AC1009")));
    // No subclass markers and no lightweight polylines before R13.
    assert!(pairs.iter().all(|p| p.0 != 100 && p.1 != "LWPOLYLINE"));
    let count = |name: &str| pairs.iter().filter(|p| **p == (0, name)).count();
    // The profile in arcs, the pitch curve of 360 vertices, the arrow of the rotation.
    assert_eq!((count("POLYLINE"), count("SEQEND")), (3, 3));
    assert_eq!(count("VERTEX"), 360 + arcs + 2);
}

/// Points along the arcs of a polyline, mm.
fn walk(vertices: &[[f64; 3]], per_arc: usize) -> Vec<[f64; 2]> {
    let n = vertices.len();
    let mut out = Vec::new();
    for i in 0..n {
        let (a, b) = (vertices[i], vertices[(i + 1) % n]);
        let half = 2.0 * a[2].atan();
        let (cx, cy) = (b[0] - a[0], b[1] - a[1]);
        for k in 0..per_arc {
            // On an arc of angle 4·atan(bulge) a point at share u sees the ends under fixed angles.
            let u = k as f64 / per_arc as f64;
            let (long, turn) = if half == 0.0 {
                (u, 0.0)
            } else {
                ((u * half).sin() / half.sin(), (u - 1.0) * half)
            };
            let (sin, cos) = turn.sin_cos();
            out.push([
                a[0] + long * (cx * cos - cy * sin),
                a[1] + long * (cx * sin + cy * cos),
            ]);
        }
    }
    out
}

#[test]
fn the_plain_drawing_is_within_a_tenth_of_a_micrometre_with_fewer_vertices_than_chords_need() {
    for s in [footbridge(), heel_tester()] {
        let bytes =
            gaitcam_cad::dxf::profile(&s, 1440, Content::All, Curves::Arcs, Units::Millimetres);
        let drawing = read(&bytes);
        let (vertices, closed) = drawing.outline("CUT_PROFILE");
        assert!(closed && vertices.len() < 720, "{}", vertices.len());
        // Points of the true profile against the drawing, walked so finely that its chords are within 5 nm.
        let drawn = walk(&vertices, 400);
        let worst = (s.cam.profile(501).iter())
            .map(|p| {
                let d = |i: usize| {
                    let (a, b) = (drawn[i], drawn[(i + 1) % drawn.len()]);
                    let (ux, uy) = (b[0] - a[0], b[1] - a[1]);
                    let (wx, wy) = (1000.0 * p.x - a[0], 1000.0 * p.y - a[1]);
                    let t = ((wx * ux + wy * uy) / (ux * ux + uy * uy)).clamp(0.0, 1.0);
                    (wx - t * ux).hypot(wy - t * uy)
                };
                (0..drawn.len()).map(d).fold(f64::INFINITY, f64::min)
            })
            .fold(0.0, f64::max);
        assert!(worst <= 1e-4 + 5e-6, "{worst} mm");
    }
}

#[test]
fn arcs_stay_within_the_tolerance_asked_and_join_smoothly() {
    for s in [footbridge(), heel_tester()] {
        let fine = s.cam.profile(20000);
        let mut before = usize::MAX;
        for tolerance in [1e-6, 1e-5, 1e-4] {
            let options = Options {
                units: Units::Millimetres,
                points: 360,
                version: Version::R2000,
                bore: None,
                content: Content::All,
            };
            let arcs = gaitcam_cad::dxf::arcs(&s, tolerance, options).unwrap();
            assert!(arcs.deviation <= tolerance);
            assert!(arcs.arcs <= before, "looser tolerance, fewer arcs");
            before = arcs.arcs;
            let drawing = read(&arcs.bytes);
            let (vertices, closed) = drawing.outline("CUT_PROFILE");
            assert!(closed && vertices.len() == arcs.arcs);
            let worst = walk(&vertices, 8)
                .iter()
                .map(|q| {
                    // Distance to the chords of the fine profile, whose sagitta is below 2 nm.
                    let d = |i: usize| {
                        let (p, r) = (&fine[i], &fine[(i + 1) % fine.len()]);
                        let (ux, uy) = (r.x - p.x, r.y - p.y);
                        let (wx, wy) = (q[0] / 1000.0 - p.x, q[1] / 1000.0 - p.y);
                        let t = ((wx * ux + wy * uy) / (ux * ux + uy * uy)).clamp(0.0, 1.0);
                        (wx - t * ux).hypot(wy - t * uy)
                    };
                    (0..fine.len()).map(d).fold(f64::INFINITY, f64::min)
                })
                .fold(0.0, f64::max);
            assert!(worst <= tolerance + 2e-9, "{worst} > {tolerance}");
            let n = vertices.len();
            for i in 0..n {
                // Chord directions turn by half of both arcs: tangents agree where they meet.
                let (a, b, c) = (vertices[i], vertices[(i + 1) % n], vertices[(i + 2) % n]);
                let (u, w) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
                let turn = (u[0] * w[1] - u[1] * w[0]).atan2(u[0] * w[0] + u[1] * w[1]);
                let arcs = 2.0 * (a[2].atan() + b[2].atan());
                assert!((turn - arcs).abs() < 1e-7, "kink of {} rad", turn - arcs);
            }
        }
    }
}

#[test]
fn a_round_cam_is_arcs_of_one_radius_and_an_undercut_one_is_refused() {
    // theory §5, Ejemplo10EX: flat face under simple harmonic motion of lift L is a circle, ρ = Rb + L/2.
    let (base_radius, lift) = (0.03, 0.02);
    let law = Law::harmonic(0.5 * lift, &[(-0.5 * lift, 0.0)]);
    let round = Cam {
        law,
        follower: Follower::FlatTranslating { base_radius },
    };
    let arcs = biarc::fit(&round, 1e-9).unwrap();
    assert!(arcs.deviation < 1e-15 && arcs.vertices.len() == 8);
    // Second harmonic strong enough that Rb + s + a < 0 somewhere.
    let sharp = Cam {
        law: Law::harmonic(0.02, &[(0.0, 0.0), (0.02, 0.0)]),
        follower: Follower::FlatTranslating { base_radius },
    };
    assert!(sharp.curvature().undercut);
    assert_eq!(biarc::fit(&sharp, 1e-4), None);
    assert_eq!(biarc::fit(&round, 0.0), None);
}

#[test]
fn a_drawing_in_inches_is_the_one_in_millimetres_over_25_4() {
    for curves in [Curves::Arcs, Curves::Splines, Curves::Lines] {
        let drawn = |units| {
            let bytes = gaitcam_cad::dxf::profile(&footbridge(), 360, Content::All, curves, units);
            (crate::drawing::groups(&bytes), bytes)
        };
        let ((mm, _), (inch, bytes)) = (drawn(Units::Millimetres), drawn(Units::Inches));
        let header = |name: &str| crate::drawing::read(&bytes).header[name][1].1.clone();
        assert_eq!(
            [header("$INSUNITS"), header("$MEASUREMENT")],
            ["1", "0"].map(String::from)
        );
        assert_eq!(mm.len(), inch.len());
        // Coordinates; knots and bulges have no unit.
        for ((code, a), (_, b)) in mm.iter().zip(&inch) {
            if matches!(code, 10 | 11 | 20 | 21) {
                let [a, b]: [f64; 2] = [a, b].map(|x| x.parse().unwrap());
                assert!((a - 25.4 * b).abs() < 1e-9, "{code}: {a} {b}");
            }
            if *code == 42 {
                assert_eq!(a, b);
            }
        }
    }
}

#[test]
fn lines_have_no_bulge_and_stay_within_their_distance() {
    for design in [heel_tester(), footbridge()] {
        let outline = |curves| {
            let bytes = gaitcam_cad::dxf::profile(
                &design,
                360,
                Content::CutOnly,
                curves,
                Units::Millimetres,
            );
            read(&bytes).outline("CUT_PROFILE")
        };
        let ((arcs, _), (lines, closed)) = (outline(Curves::Arcs), outline(Curves::Lines));
        assert!(closed && lines.iter().all(|v| v[2] == 0.0));
        assert!(lines.len() < 1000, "{}", lines.len());
        let distance = |p: [f64; 2]| {
            let sides = lines.iter().zip(lines.iter().cycle().skip(1));
            let each = sides.map(|(a, b)| {
                let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
                let square = along[0] * along[0] + along[1] * along[1];
                let part = ((along[0] * from[0] + along[1] * from[1]) / square).clamp(0.0, 1.0);
                (from[0] - part * along[0]).hypot(from[1] - part * along[1])
            });
            each.fold(f64::INFINITY, f64::min)
        };
        let worst = walk(&arcs, 20)
            .into_iter()
            .map(distance)
            .fold(0.0, f64::max);
        assert!(worst < 0.002 && worst > 0.001, "{worst} mm");
    }
}
