//! The drawings hold every edge that is cut, and no line that is none.

use std::f64::consts::PI;
use std::path::Path;

use dxf::entities::EntityType;
use gaitcam::cam::Wall;
use gaitcam::synth::{Synthesis, synthesise};

fn designed(scene: &str) -> Synthesis {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("scenes")
        .join(scene);
    let text = std::fs::read_to_string(path).unwrap();
    let scene = gaitcam::scene::read(&text.parse().unwrap()).unwrap();
    synthesise(&scene, None).unwrap()
}

struct Drawn {
    /// Layer, vertices (x, y, bulge), whether closed.
    curves: Vec<(String, Vec<[f64; 3]>, bool)>,
    circles: Vec<(String, f64)>,
    header: dxf::Header,
    text: String,
}

fn drawn(s: &Synthesis) -> Drawn {
    let bytes = gaitcam_output::dxf::profile(s, 720);
    let drawing = dxf::Drawing::load(&mut bytes.as_slice()).unwrap();
    let mut out = Drawn {
        curves: Vec::new(),
        circles: Vec::new(),
        header: drawing.header.clone(),
        text: String::from_utf8(bytes).unwrap(),
    };
    for e in drawing.entities() {
        let layer = e.common.layer.clone();
        match &e.specific {
            EntityType::Polyline(p) => out.curves.push((
                layer,
                p.vertices()
                    .map(|v| [v.location.x, v.location.y, v.bulge])
                    .collect(),
                p.is_closed(),
            )),
            EntityType::Circle(c) => out.circles.push((layer, c.radius)),
            _ => {}
        }
    }
    out
}

impl Drawn {
    fn curve(&self, layer: &str) -> (&[[f64; 3]], bool) {
        let all: Vec<_> = self.curves.iter().filter(|c| c.0 == layer).collect();
        assert_eq!(all.len(), 1, "{layer} is drawn {} times", all.len());
        (&all[0].1, all[0].2)
    }
}

/// The data of an SVG's path.
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
    let s = designed("thesis_barrel.toml");
    let d = drawn(&s);
    // Two turns on R 30 mm.
    let length = 4.0 * PI * 30.0;
    for layer in ["PROFILE", "UPPER_WALL", "PITCH_CURVE"] {
        let (v, closed) = d.curve(layer);
        let (first, last) = (v[0], v[v.len() - 1]);
        assert!(!closed, "{layer} closes");
        assert!(
            first[0].abs() < 1e-9 && (last[0] - length).abs() < 1e-9,
            "{layer}: {last:?}"
        );
        // The law closes: both ends are at one height.
        assert!((first[1] - last[1]).abs() < 1e-9);
    }
    assert_eq!(d.circles, [], "nothing is round in an unrolled drawing");
    // Vertices of the arcs lie on the walls as the groove itself has them.
    let groove = s.groove.as_ref().unwrap();
    for (layer, wall) in [("PROFILE", Wall::Lower), ("UPPER_WALL", Wall::Upper)] {
        let exact: Vec<[f64; 2]> = (0..=40_000)
            .map(|i| {
                let [delta, z] =
                    groove.wall_unrolled(4.0 * PI * f64::from(i) / 40_000.0, 0.03, wall);
                [30.0 * delta, 1e3 * z]
            })
            .collect();
        for v in d.curve(layer).0 {
            let near = exact
                .iter()
                .map(|q| (q[0] - v[0]).hypot(q[1] - v[1]))
                .fold(f64::INFINITY, f64::min);
            // Half a step of the exact wall.
            assert!(near < 0.006, "{layer}: {v:?} is {near} mm off");
        }
    }
    // At rest in height the rollers of 5.25 mm stand 0.25 mm off their stud to either side.
    assert!((d.curve("PROFILE").0[0][1] + 5.5).abs() < 1e-9);
    assert!((d.curve("UPPER_WALL").0[0][1] - 5.5).abs() < 1e-9);

    let svg = gaitcam_output::svg::profile(&s, 720);
    for id in ["profile", "upper-wall", "pitch-curve"] {
        let d = path(&svg, id);
        assert!(!d.ends_with('Z'), "{id} closes");
        let last = d.rsplit('L').next().unwrap();
        let x: f64 = last.split(' ').next().unwrap().parse().unwrap();
        assert!((x - length).abs() < 1e-6, "{id} ends at {x}");
    }
    assert!(!svg.contains("<circle"));
    // The table has the same wall as the drawing.
    let table = gaitcam_output::csv::profile(&s, 720);
    let first: Vec<f64> = table
        .lines()
        .nth(1)
        .unwrap()
        .split(',')
        .map(|x| x.parse().unwrap())
        .collect();
    assert!((first[2] + 5.5e-3).abs() < 1e-12 && (first[4] + 0.25e-3).abs() < 1e-12);
}

#[test]
fn a_sliding_cam_has_a_foot_and_no_circles() {
    let s = designed("translating_cam.toml");
    let d = drawn(&s);
    assert_eq!(d.circles, []);
    let (v, closed) = d.curve("PROFILE");
    assert!(!closed && (v[v.len() - 1][0] - 160.0).abs() < 1e-9);
    let svg = gaitcam_output::svg::profile(&s, 720);
    assert!(!svg.contains("<circle") && !path(&svg, "profile").ends_with('Z'));
    assert_eq!(
        path(&svg, "foot"),
        "M0.000000 -0.000000L160.000000 -0.000000"
    );
}

#[test]
fn both_cams_of_a_pair_are_drawn_as_they_stand_on_the_shaft() {
    for scene in [
        "camdas_07_conjugate_roller.toml",
        "camdas_08_conjugate_flat.toml",
    ] {
        let s = designed(scene);
        let pair = s.conjugate.as_ref().unwrap();
        let fine = pair.second_profile(60_000);
        let (v, closed) = {
            let d = drawn(&s);
            let (v, closed) = d.curve("SECOND_PROFILE");
            (v.to_vec(), closed)
        };
        assert!(closed && v.len() > 16);
        for v in v {
            let near = fine
                .iter()
                .map(|p| (1e3 * p.x - v[0]).hypot(1e3 * p.y - v[1]))
                .fold(f64::INFINITY, f64::min);
            assert!(near < 0.012, "{scene}: {v:?} is {near} mm off");
        }
        assert!(path(&gaitcam_output::svg::profile(&s, 360), "second-profile").ends_with('Z'));
    }
}

#[test]
fn r12_declares_millimetres_and_the_extents_of_the_drawing() {
    let s = designed("camdas_01_roller.toml");
    let d = drawn(&s);
    let lines: Vec<&str> = d.text.lines().map(str::trim).collect();
    let at = lines.iter().position(|l| *l == "$INSUNITS").unwrap();
    // 4 is millimetres in that variable.
    assert_eq!(&lines[at + 1..at + 3], ["70", "4"]);
    let prime = 1e3 * s.cam.follower.prime_radius();
    let mut extent = [[-prime; 2], [prime; 2]];
    for p in s.cam.profile(20_000) {
        for (x, k) in [(p.x, 0), (p.y, 1), (p.pitch_x, 0), (p.pitch_y, 1)] {
            extent[0][k] = extent[0][k].min(1e3 * x);
            extent[1][k] = extent[1][k].max(1e3 * x);
        }
    }
    let (low, high) = (
        &d.header.minimum_drawing_extents,
        &d.header.maximum_drawing_extents,
    );
    for (read, known) in [
        (low.x, extent[0][0]),
        (low.y, extent[0][1]),
        (high.x, extent[1][0]),
        (high.y, extent[1][1]),
    ] {
        // The pitch curve is drawn in chords of half a degree.
        assert!((read - known).abs() < 2e-3, "{read} for {known}");
    }
}
