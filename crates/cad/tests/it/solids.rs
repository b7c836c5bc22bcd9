//! Solids in STL and 3MF are closed, have outward normals and the correct volume.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::io::{Cursor, Read};

use gaitcam::cam::{Bore, Follower};
use gaitcam::synth::Design;
use gaitcam_cad::solid::{self, Mesh, Plate};

use gaitcam_test_support::designs::{footbridge, heel_tester};
use gaitcam_test_support::readers::{attribute, elements};

/// Volume by the divergence theorem, after checking that every directed edge occurs once, and its opposite once.
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
