//! Path of a cutter's centre, and concave parts that the cutter cannot reach.

use gaitcam_cad::cutter;

use gaitcam_test_support::designs::{footbridge, heel_tester};
use gaitcam_test_support::readers::table;

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
