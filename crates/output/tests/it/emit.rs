//! Every file that is handed over, opened by a reader that did not write it.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::io::{Cursor, Read};

use crate::designs::{footbridge, heel_tester, impossible};
use crate::drawing::{groups, read};
use calamine::{Data, Reader, Xlsx};
use gaitcam::cam::{Bore, Cam, Follower};
use gaitcam::law::Law;
use gaitcam::poly::PiecewisePoly;
use gaitcam::synth::Design;
use gaitcam_output::dxf::{Content, Options, Version};
use gaitcam_output::solid::{Mesh, Plate};
use gaitcam_output::{self, Language, Timing, biarc, cutter, solid};
use serde_json::Value;

const TIME: Timing = Timing {
    solve_s: 0.001,
    total_s: 0.1,
};

fn table(text: &str) -> (Vec<String>, Vec<Vec<Option<f64>>>) {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().unwrap().iter().map(String::from).collect();
    let rows = reader
        .records()
        .map(|r| r.unwrap().iter().map(|x| x.parse().ok()).collect())
        .collect();
    (head, rows)
}

#[test]
fn law_csv_has_the_promised_columns_and_reads_back_to_the_same_bits() {
    let s = footbridge();
    let (head, rows) = table(&gaitcam_output::csv::law(&s, 1440));
    let promised = "theta_rad,s_m,v_m_per_rad,a_m_per_rad2,j_m_per_rad3,force_n,target_n";
    assert_eq!(head.join(","), promised);
    assert_eq!(rows.len(), 1440);
    for (i, row) in rows.iter().enumerate() {
        let theta = TAU * i as f64 / 1440.0;
        let at = s.cam.law.svaj(theta);
        let expected = [theta, at.s, at.v, at.a, at.j, s.drive.force(at)];
        for (read, known) in row.iter().zip(expected) {
            assert_eq!(read.unwrap().to_bits(), known.to_bits());
        }
        let target = s.target.as_ref().unwrap();
        assert_eq!(row[6], Some(target.at(theta)));
        if i % 4 == 0 {
            // One of the curve's 360 samples, in closed form: Young's four harmonics as in the design.
            let factors = [(0.37, 0.0), (0.054, 0.7), (0.026, 1.9), (0.01, 2.4)];
            let waves: f64 = factors
                .iter()
                .zip(1..)
                .map(|((a, p), n)| a * (f64::from(n) * theta + p).sin())
                .sum();
            assert!((row[6].unwrap() - 700.0 * (1.0 + waves)).abs() < 1e-9);
        }
    }
    let mut classical = s;
    classical.target = None;
    let (_, rows) = table(&gaitcam_output::csv::law(&classical, 12));
    assert!(rows.iter().all(|r| r.len() == 7 && r[6].is_none()));
}

#[test]
fn profile_csv_holds_the_contact_at_each_angle() {
    for s in [footbridge(), heel_tester()] {
        let (head, rows) = table(&gaitcam_output::csv::profile(&s, 1440));
        let promised = "theta_rad,x_m,y_m,pitch_x_m,pitch_y_m,rho_m,pressure_angle_rad";
        assert_eq!(head.join(","), promised);
        for (row, p) in rows.iter().zip(s.cam.profile(1440)) {
            let known = [
                p.theta,
                p.x,
                p.y,
                p.pitch_x,
                p.pitch_y,
                p.rho,
                p.pressure_angle,
            ];
            let read: Vec<f64> = row.iter().map(|x| x.unwrap()).collect();
            assert_eq!(read, known);
        }
    }
}

/// The keys of summary.json that other programs rely on.
const CONTRACT: &str = r#"{"name": "", "outcome": "built|infeasible", "verdict": "acceptable|not-for-high-speed|unacceptable",
 "force": {"rms_error_n": 0, "max_error_n": 0, "rms_error_percent_of_mean": 0, "target_mean_n": 0, "mean_n": 0, "min_n": 0, "max_n": 0},
 "drive": {"kind": "", "mass_kg": 0, "speed_rad_per_s": 0},
 "law": {"family": "", "pieces": 0, "degree": 0, "coefficients": [], "stroke_m": 0, "v_max_m_per_rad": 0, "v_min_m_per_rad": 0,
         "a_max_m_per_rad2": 0, "a_min_m_per_rad2": 0, "j_max_m_per_rad3": 0, "j_min_m_per_rad3": 0},
 "cam": {"follower": "", "base_radius_m": 0, "prime_radius_m": 0, "offset_m": 0, "rho_min_m": 0, "rho_min_at_rad": 0,
         "pressure_angle_max_rad": 0, "pressure_angle_min_rad": 0, "face_width_m": 0},
 "checks": [{"name": "", "worst": 0, "limit": 0, "at_rad": 0, "pass": true}],
 "binding": [{"limit": "", "multiplier": 0, "at_rad": 0}],
 "solver": {"tier": "spectral|equality|qp|socp|scp", "status": "", "iterations": 0, "solve_s": 0, "certified": true},
 "time": {"total_s": 0}}"#;

/// Every key of `pattern` is in `value` with the same kind; what is more is returned.
fn extra_keys(pattern: &Value, value: &Value, path: &str) -> Vec<String> {
    match (pattern, value) {
        (Value::Object(p), Value::Object(v)) => {
            for key in p.keys() {
                assert!(v.contains_key(key), "{path}.{key} is missing");
            }
            v.iter()
                .flat_map(|(key, value)| match p.get(key) {
                    Some(pattern) => extra_keys(pattern, value, &format!("{path}.{key}")),
                    None => vec![format!("{path}.{key}")],
                })
                .collect()
        }
        (Value::Array(p), Value::Array(v)) => match p.first() {
            Some(pattern) => v
                .iter()
                .flat_map(|v| extra_keys(pattern, v, path))
                .collect(),
            None => Vec::new(),
        },
        (p, v) => {
            let same = std::mem::discriminant(p) == std::mem::discriminant(v);
            assert!(same || v.is_null(), "{path} is {v}");
            Vec::new()
        }
    }
}

#[test]
fn summary_json_has_every_key_of_the_contract() {
    let contract: Value = serde_json::from_str(CONTRACT).unwrap();
    // What is said beyond the contract.
    let always = [
        ".continuity",
        ".cam_das",
        ".machine",
        ".verdict_text",
        ".reason",
        ".reasons",
        ".easing",
        ".remarks",
        ".out_of_time",
        ".load_factors",
        ".law.phase_rad",
        ".law.functions",
        ".solver.certificate",
    ];
    for (s, more) in [
        (footbridge(), None),
        (heel_tester(), None),
        (impossible(), Some(".infeasible")),
    ] {
        let text = gaitcam_output::json::summary(&s, TIME).to_string();
        let read: Value = serde_json::from_str(&text).unwrap();
        let mut found = extra_keys(&contract, &read, "");
        found.retain(|key| !always.contains(&key.as_str()));
        assert_eq!(found, Vec::from_iter(more));
    }
    let read = gaitcam_output::json::summary(&footbridge(), TIME);
    assert_eq!(read["outcome"], "built");
    assert_eq!(read["solver"]["solve_s"], 0.001);
    assert_eq!(read["cam"]["follower"], "flat-translating");
    let stroke = read["law"]["stroke_m"].as_f64().unwrap();
    assert!((stroke - footbridge().cam.law.stroke()).abs() < 1e-15);
    assert!(gaitcam_output::json::summary(&heel_tester(), TIME)["cam"]["face_width_m"].is_null());
}

#[test]
fn an_infeasible_summary_names_the_conflict_and_writes_no_nan() {
    let read = gaitcam_output::json::summary(&impossible(), TIME);
    assert_eq!(read["outcome"], "infeasible");
    assert_eq!(read["infeasible"]["conflict"][0], "stroke");
    assert_eq!(read["infeasible"]["relaxations"][0]["to"], 0.0483);
    assert!(read["infeasible"]["relaxations"][1]["to"].is_null());
    assert!(read["force"]["rms_error_n"].is_null());
    assert!(!read.to_string().contains("NaN"));
}

#[test]
fn dxf_is_the_closed_profile_in_true_millimetres_in_every_dialect() {
    let s = heel_tester();
    for version in [Version::R12, Version::R2000, Version::R2010] {
        let options = Options {
            points: 1440,
            version,
            bore: Some(Bore::plain(0.02)),
            content: Content::All,
        };
        let bytes = gaitcam_output::dxf::drawing(&s, options);
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
    let bytes = gaitcam_output::dxf::profile(&heel_tester(), 360, Content::All);
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
        let bytes = gaitcam_output::dxf::profile(&s, 1440, Content::All);
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
                points: 360,
                version: Version::R2000,
                bore: None,
                content: Content::All,
            };
            let arcs = gaitcam_output::dxf::arcs(&s, tolerance, options).unwrap();
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

/// Names of all elements if every tag is closed in order; comments and doctype are passed over.
fn elements(text: &str) -> Vec<String> {
    const VOID: [&str; 3] = ["meta", "input", "br"];
    let mut open: Vec<String> = Vec::new();
    let mut all = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        rest = &rest[start + 1..];
        let end = rest.find('>').expect("a tag is closed");
        let tag = &rest[..end];
        rest = &rest[end + 1..];
        if tag.starts_with('!') || tag.starts_with('?') {
            continue;
        }
        assert!(
            tag.matches('"').count().is_multiple_of(2),
            "quotes in <{tag}>"
        );
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "after {all:?}");
            continue;
        }
        let name = tag.split([' ', '\n', '/']).next().unwrap().to_string();
        all.push(name.clone());
        if name == "script" || name == "style" {
            let close = format!("</{name}>");
            let end = rest.find(&close).expect("script and style are closed");
            rest = &rest[end + close.len()..];
        } else if !tag.ends_with('/') && !VOID.contains(&name.as_str()) {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "left open: {open:?}");
    all
}

fn attribute(text: &str, name: &str) -> String {
    let start = text.find(&format!(" {name}=\"")).unwrap() + name.len() + 3;
    text[start..].split('"').next().unwrap().to_string()
}

#[test]
fn profile_svg_is_as_large_as_the_cam() {
    for s in [footbridge(), heel_tester(), impossible()] {
        let svg = gaitcam_output::svg::profile(&s, 1440);
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

#[test]
fn pictures_are_whole_and_nothing_is_cut_off() {
    for s in [footbridge(), heel_tester()] {
        for picture in [
            gaitcam_output::plots::svaj(&s, Language::En),
            gaitcam_output::plots::force(&s, Language::En),
            gaitcam_output::plots::cam(&s, Language::En),
        ] {
            assert_eq!(elements(&picture.svg())[0], "svg");
            let bytes = picture.png();
            let mut reader = zune_png::PngDecoder::new(&bytes);
            let pixels = reader.decode_raw().unwrap();
            assert_eq!(reader.get_dimensions(), Some((1200, 800)));
            assert_eq!(pixels.len(), 3 * 1200 * 800);
            let blank = |x: usize, y: usize| pixels[3 * (1200 * y + x)..][..3] == [255; 3];
            // Ink in the middle, a blank edge all around.
            assert!((0..800).any(|y| (0..1200).any(|x| !blank(x, y))));
            for x in 0..1200 {
                assert!(
                    (0..5).all(|k| blank(x, k) && blank(x, 799 - k)),
                    "edge at x {x}"
                );
            }
            for y in 0..800 {
                assert!(
                    (0..5).all(|k| blank(k, y) && blank(1199 - k, y)),
                    "edge at y {y}"
                );
            }
        }
    }
}

#[test]
fn report_is_one_file_that_asks_nothing_of_the_network() {
    for s in [footbridge(), heel_tester()] {
        let html = gaitcam_output::report::html(&s, TIME, Language::En);
        let stroke_mm = 1000.0 * s.cam.law.stroke();
        let all = elements(&html);
        // Animation, force, law, cam, curvature.
        assert_eq!(all.iter().filter(|e| *e == "svg").count(), 5);
        let asks = html.replace("http://www.w3.org/2000/svg", "");
        for word in ["http:", "https:", "src=", "href=", "@import", "url("] {
            assert!(!asks.contains(word), "{word}");
        }
        for word in ["Checks", "Active limits", "Solution", "<main>"] {
            assert!(html.contains(word), "{word}");
        }
        // The walker's own variation stands beside the error where it is known.
        assert_eq!(
            html.contains("Step-to-step"),
            s.target.unwrap().spread_n.is_some()
        );
        let data = html.split("id=\"motion\">").nth(1).unwrap();
        let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
        let lift = data["s"].as_array().unwrap();
        let stroke = lift.iter().map(|x| x.as_f64().unwrap()).fold(0.0, f64::max);
        assert!((stroke - stroke_mm).abs() < 0.01);
    }
}

#[test]
fn the_report_of_an_impossible_cam_says_why_and_shows_none() {
    let html = gaitcam_output::report::html(&impossible(), TIME, Language::En);
    let all = elements(&html);
    assert!(!all.contains(&"svg".to_string()) && !all.contains(&"script".to_string()));
    assert!(html.contains("footbridge &lt;stroke &amp; limit&gt;"));
    assert!(html.contains("Conflicting limits"));
    assert!(html.contains("from 30.00 mm to <strong>48.30 mm</strong>"));
}

/// Every directed edge once, its opposite once; volume by the divergence theorem.
fn closed_volume(mesh: &Mesh) -> f64 {
    let mut edges: HashMap<(usize, usize), usize> = HashMap::new();
    let mut volume = 0.0;
    for t in &mesh.triangles {
        for k in 0..3 {
            *edges.entry((t[k], t[(k + 1) % 3])).or_default() += 1;
        }
        let [a, b, c] = t.map(|i| mesh.vertices[i]);
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    for (&(a, b), &count) in &edges {
        assert_eq!(count, 1);
        assert_eq!(edges.get(&(b, a)), Some(&1));
    }
    volume / 6.0
}

fn polygon_area(s: &Design, points: usize) -> f64 {
    let rows = s.cam.profile(points);
    let n = rows.len();
    let twice: f64 = (0..n)
        .map(|i| {
            let (p, q) = (&rows[i], &rows[(i + 1) % n]);
            p.x * q.y - p.y * q.x
        })
        .sum();
    0.5e6 * twice.abs()
}

#[test]
fn solids_are_watertight_and_hold_the_right_volume() {
    for s in [footbridge(), heel_tester()] {
        for bore in [None, Some(0.016_f64)] {
            let form = Plate {
                thickness: 0.012,
                bore: bore.map(Bore::plain),
                points: 1440,
            };
            // The bore polygon has a vertex per profile vertex; its area is that of the circle to 1e-4.
            let hole = bore.map_or(0.0, |d| PI * (500.0 * d) * (500.0 * d));
            let expected = 12.0 * (polygon_area(&s, 1440) - hole);
            let bytes = solid::stl(&s, form).unwrap();
            let read = stl_io::read_stl(&mut Cursor::new(&bytes)).unwrap();
            read.validate().unwrap();
            let mesh = Mesh {
                vertices: read.vertices.iter().map(|v| v.0.map(f64::from)).collect(),
                triangles: read.faces.iter().map(|f| f.vertices).collect(),
            };
            let volume = closed_volume(&mesh);
            assert!(
                (volume / expected - 1.0).abs() < 1e-5,
                "{volume} {expected}"
            );
            for face in &read.faces {
                let [a, b, c] = face.vertices.map(|i| mesh.vertices[i]);
                let (u, w) = (
                    [0, 1, 2].map(|k| b[k] - a[k]),
                    [0, 1, 2].map(|k| c[k] - a[k]),
                );
                let n = [
                    u[1] * w[2] - u[2] * w[1],
                    u[2] * w[0] - u[0] * w[2],
                    u[0] * w[1] - u[1] * w[0],
                ];
                let along: f64 = (0..3).map(|k| n[k] * f64::from(face.normal.0[k])).sum();
                assert!(along > 0.0);
            }
        }
    }
}

#[test]
fn the_3mf_package_holds_the_same_closed_mesh() {
    let s = heel_tester();
    let form = Plate {
        thickness: 0.01,
        bore: Some(Bore::plain(0.02)),
        points: 360,
    };
    let bytes = solid::threemf(&s, form).unwrap();
    let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut part = |name: &str| {
        let mut text = String::new();
        zip.by_name(name)
            .unwrap()
            .read_to_string(&mut text)
            .unwrap();
        text
    };
    assert!(part("[Content_Types].xml").contains("3dmanufacturing-3dmodel+xml"));
    assert!(part("_rels/.rels").contains("/3D/3dmodel.model"));
    let model = part("3D/3dmodel.model");
    elements(&model);
    assert!(model.contains("unit=\"millimeter\""));
    let numbers = |tag: &str, keys: [&str; 3]| -> Vec<[f64; 3]> {
        model
            .split(&format!("<{tag} "))
            .skip(1)
            .map(|t| keys.map(|k| attribute(&format!(" {t}"), k).parse().unwrap()))
            .collect()
    };
    let mesh = Mesh {
        vertices: numbers("vertex", ["x", "y", "z"]),
        triangles: numbers("triangle", ["v1", "v2", "v3"])
            .into_iter()
            .map(|t| t.map(|i| i as usize))
            .collect(),
    };
    assert_eq!(
        (mesh.vertices.len(), mesh.triangles.len()),
        (4 * 360, 8 * 360)
    );
    let hole = PI * 10.0 * 10.0;
    let expected = 10.0 * (polygon_area(&s, 360) - hole);
    assert!((closed_volume(&mesh) / expected - 1.0).abs() < 1e-4);
}

#[test]
fn a_plate_that_cannot_be_is_refused_with_the_reason() {
    let good = Plate {
        thickness: 0.01,
        bore: Some(Bore::plain(0.02)),
        points: 360,
    };
    let refuse = |s: &Design, form: Plate, word: &str| {
        let fault = solid::stl(s, form).unwrap_err().to_string();
        assert!(fault.contains(word), "{fault}");
    };
    let s = heel_tester();
    assert!(solid::stl(&s, good).is_ok());
    refuse(
        &s,
        Plate {
            thickness: 0.0,
            ..good
        },
        "thick",
    );
    refuse(
        &s,
        Plate {
            thickness: f64::NAN,
            ..good
        },
        "thick",
    );
    refuse(
        &s,
        Plate {
            bore: Some(Bore::plain(0.2)),
            ..good
        },
        "bore",
    );
    refuse(
        &s,
        Plate {
            bore: Some(Bore::plain(-0.01)),
            ..good
        },
        "bore",
    );
    refuse(&s, Plate { points: 2, ..good }, "points");
    let mut outside = footbridge();
    // Without a base circle the centre of rotation lies on the profile's edge.
    outside.cam.follower = Follower::FlatTranslating { base_radius: 0.0 };
    refuse(&outside, good, "ray");
}

#[test]
fn the_workbook_has_the_columns_of_cam_das() {
    for (s, flat) in [(footbridge(), true), (heel_tester(), false)] {
        let bytes = gaitcam_output::xlsx::workbook(&s, TIME, Language::En).unwrap();
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).unwrap();
        assert_eq!(book.sheet_names(), ["cam", "summary"]);
        let sheet = book.worksheet_range("cam").unwrap();
        let text = |row: u32, column: u32| sheet.get_value((row, column)).map(Data::to_string);
        // 004, "Exportar-Excel": A1 the kind, A2 the title, headings in row 10, 361 rows from row 11.
        let kind = if flat { "flat" } else { "roller" };
        assert!(text(0, 0).unwrap().contains(kind), "{:?}", text(0, 0));
        assert_eq!(text(1, 0).unwrap(), s.name);
        let verdict = s.verdict.name().replace("-", " ");
        let said = text(2, 0).unwrap().to_lowercase().replace("-", " ");
        assert!(said.starts_with(&verdict), "{said}");
        let heading = |letter: u8| text(9, u32::from(letter - b'A')).unwrap_or_default();
        assert!(heading(b'A').contains("°") && heading(b'F').contains("curvature"));
        let number = |row: u32, letter: u8| match sheet.get_value((row, u32::from(letter - b'A'))) {
            Some(Data::Float(x)) => *x,
            other => panic!("row {row}: {other:?}"),
        };
        for i in [0, 1, 90, 217, 360] {
            let theta = f64::from(i).to_radians();
            let (p, at) = (s.cam.point(theta), s.cam.law.svaj(theta));
            let row = 10 + i;
            assert_eq!(number(row, b'A'), f64::from(i));
            assert!((number(row, b'B') - 1000.0 * at.s).abs() < 1e-9);
            let speed = s.drive.speed;
            assert!((number(row, b'D') - 1000.0 * at.a * speed * speed).abs() < 1e-6);
            assert!((number(row, b'L') - 1000.0 * p.x).abs() < 1e-9);
            let (r, phi) = (number(row, b'I'), number(row, b'J').to_radians());
            assert!((r * phi.sin() - 1000.0 * p.y).abs() < 1e-9);
            if flat {
                assert!((number(row, b'H') - number(row, b'G') - 1000.0 * at.v).abs() < 1e-9);
            } else {
                assert!((number(row, b'G') - p.pressure_angle.to_degrees()).abs() < 1e-9);
                assert!((number(row, b'R') - 1000.0 * p.pitch_x).abs() < 1e-9);
            }
        }
        assert_eq!(sheet.end().unwrap().0, 370);
        assert_eq!(heading(b'S').is_empty(), flat);
        let summary = book.worksheet_range("summary").unwrap();
        let stroke = summary
            .rows()
            .find(|r| r[0] == Data::String("law.stroke_m".into()))
            .unwrap();
        assert_eq!(stroke[1], Data::Float(s.cam.law.stroke()));
    }
}

#[test]
fn a_cutter_as_large_as_the_roller_runs_along_the_pitch_curve() {
    let s = heel_tester();
    let path = cutter::path(&s, 0.0254, 720).unwrap();
    assert!(path.gouges.is_empty());
    for (c, p) in path.points.iter().zip(s.cam.profile(720)) {
        assert!((c.x - p.pitch_x).hypot(c.y - p.pitch_y) < 1e-15);
    }
    let (head, rows) = table(&cutter::csv(&path));
    assert_eq!(head, ["theta_rad", "x_m", "y_m"]);
    assert_eq!(rows[5][1], Some(path.points[5].x));
}

#[test]
fn a_cutter_wider_than_a_hollow_gouges() {
    // Concave flanks of the heel tester's cam (theory §2): tightest radius 273.1 mm.
    let s = heel_tester();
    let hollow = -s.cam.curvature().concave.unwrap().value;
    assert!(
        cutter::path(&s, 0.999 * hollow, 1440)
            .unwrap()
            .gouges
            .is_empty()
    );
    let wide = cutter::path(&s, 1.001 * hollow, 1440).unwrap();
    let [cutter::Gouge::Hollow { radius, .. }] = wide.gouges[..] else {
        panic!("{:?}", wide.gouges)
    };
    assert_eq!(radius, hollow);
    assert!(cutter::path(&s, -0.01, 1440).is_err());
    assert!(cutter::path(&s, f64::NAN, 1440).is_err());
    // A convex cam takes any cutter.
    assert!(
        cutter::path(&footbridge(), 1.0, 720)
            .unwrap()
            .gouges
            .is_empty()
    );
}

#[test]
fn the_same_design_gives_the_same_bytes() {
    let s = heel_tester();
    let form = Plate {
        thickness: 0.01,
        bore: Some(Bore::plain(0.02)),
        points: 360,
    };
    let files = || {
        [
            gaitcam_output::dxf::profile(&s, 360, Content::All),
            gaitcam_output::plots::cam(&s, Language::En).png(),
            gaitcam_output::report::html(&s, TIME, Language::En).into_bytes(),
            gaitcam_output::xlsx::workbook(&s, TIME, Language::En).unwrap(),
            solid::threemf(&s, form).unwrap(),
        ]
    };
    assert!(files() == files());
}

/// Designs at the edge of what there is: no lift at all, a knife edge, an open law, no target.
fn odd_ones() -> Vec<Design> {
    let mut still = footbridge();
    still.cam.law = Law::harmonic(0.0, &[]);
    let mut knife = heel_tester();
    knife.cam.follower = Follower::RollerTranslating {
        prime_radius: 0.06,
        offset: 0.01,
        roller_radius: 0.0,
    };
    knife.target = None;
    let mut open = footbridge();
    let rise = PiecewisePoly::new(vec![0.5, 2.0], 3, vec![0.0, 0.0, 0.01, 0.01]);
    open.cam.law = Law::from_poly(rise, false);
    open.name = String::new();
    vec![still, knife, open]
}

#[test]
fn odd_designs_are_handed_over_without_fault() {
    for s in odd_ones() {
        assert_eq!(table(&gaitcam_output::csv::law(&s, 100)).1.len(), 100);
        assert_eq!(table(&gaitcam_output::csv::profile(&s, 100)).1.len(), 100);
        let drawing = gaitcam_output::dxf::profile(&s, 100, Content::All);
        let drawing = read(&drawing);
        assert_eq!(drawing.outline("CUT_PROFILE").1, s.cam.law.is_closed());
        elements(&gaitcam_output::svg::profile(&s, 100));
        for picture in [
            gaitcam_output::plots::svaj(&s, Language::En),
            gaitcam_output::plots::force(&s, Language::En),
            gaitcam_output::plots::cam(&s, Language::En),
        ] {
            let svg = picture.svg();
            elements(&svg);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            assert!(picture.png().len() > 1000);
        }
        let html = gaitcam_output::report::html(&s, TIME, Language::En);
        elements(&html);
        assert!(!html.contains("NaN"));
        assert!(gaitcam_output::xlsx::workbook(&s, TIME, Language::En).is_ok());
        let form = Plate {
            thickness: 0.01,
            bore: Some(Bore::plain(0.01)),
            points: 100,
        };
        assert_eq!(solid::stl(&s, form).is_ok(), s.cam.law.is_closed());
        assert!(cutter::path(&s, 0.005, 100).is_ok());
        let arcs = biarc::fit(&s.cam, 1e-5).unwrap();
        assert_eq!(arcs.closed, s.cam.law.is_closed());
    }
}

#[test]
fn the_report_of_a_run_moves_the_follower_as_it_ran() {
    use gaitcam::dynamics::{Machine, Model, Run, simulate};
    use gaitcam_output::report::{Running, html_of_run};
    // Far above lift-off: the follower flies for a part of every turn.
    let mut s = footbridge();
    s.drive.speed *= 2.2;
    let run = Run {
        profile: s.cam.profile(720),
        cam: s.cam.clone(),
        drive: s.drive,
        target: None,
        machine: Machine {
            restitution: 0.3,
            ..Machine::default()
        },
    };
    let outcome = simulate(&run, Model::Contact).unwrap();
    assert!(outcome.contact_lost);
    let running = Running {
        outcome: &outcome,
        second_cam: None,
    };
    let html = html_of_run(&s, TIME, &running, Language::En);
    let all = elements(&html);
    // The run in motion and its diagrams beside force, law, cam, curvature.
    assert_eq!(all.iter().filter(|e| *e == "svg").count(), 6);
    assert!(html.contains("Simulation") && html.contains("Impacts"));
    assert!(!html.contains("NaN"));
    let data = html.split("id=\"motion\">").nth(1).unwrap();
    let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
    let turns = data["turns"].as_u64().unwrap() as usize;
    assert_eq!(turns, outcome.period_turns.min(4));
    let list = |name: &str| data[name].as_array().unwrap().clone();
    let (gap, contact, force) = (list("gap"), list("cx"), list("f"));
    assert_eq!(gap.len(), 480 * turns + 1);
    let flying = gap.iter().filter(|g| g.as_f64().unwrap() > 1e-3).count();
    assert!(flying > 20);
    for ((g, c), f) in gap.iter().zip(&contact).zip(&force) {
        // In the air there is no contact point, and no force but within a row of take-off or landing.
        assert_eq!(c.is_null(), g.as_f64().unwrap() > 0.0 || c.is_null());
        if g.as_f64().unwrap() > 0.5 {
            assert_eq!(f.as_f64().unwrap(), 0.0);
        }
    }
    // Steps and rows coincide here: 1.5 rows to a step, so every second step is a row.
    for k in 0..240 {
        let row = &outcome.rows[3 * k];
        let shown = force[2 * k].as_f64().unwrap();
        if row.gap == 0.0 {
            assert!((shown - row.contact_force).abs() < 1e-6, "{k}");
        }
    }
}
