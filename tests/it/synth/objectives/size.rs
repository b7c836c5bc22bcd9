//! The size of a cam where the scene leaves it open, against its closed forms, and what is said about it.

use gaitcam::error::Error;
use gaitcam::problem::Note;
use gaitcam::synth::{Design, synthesise};
use gaitcam_test_support::near;

/// Rise, dwell, fall and dwell of these angles, 10 mm high.
fn programme(angles: [f64; 4], cam: &str, changes: &[&str]) -> Result<Design, Error> {
    let [rise, high, fall, low] = angles;
    let text = format!(
        "name = \"x\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\nspring_rate = \"5 N/mm\"\n\
         [law]\nfamily = \"program\"\n\
         [[law.segment]]\nmotion = \"3-4-5\"\nlift = \"10 mm\"\nangle = \"{rise} deg\"\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"{high} deg\"\n\
         [[law.segment]]\nmotion = \"3-4-5\"\nlift = \"-10 mm\"\nangle = \"{fall} deg\"\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"{low} deg\"\n[cam]\n{cam}\n"
    );
    synthesise(&gaitcam_test_support::scene(&text, changes)?, None)
}

const EVEN: [f64; 4] = [120.0, 60.0, 120.0, 60.0];
const FLAT: &str = "follower = \"flat-translating\"";
const ROLLER: &str = "follower = \"roller-translating\"\nroller_radius = \"5 mm\"\noffset = \"0\"";

#[test]
fn half_of_what_the_lift_leaves_of_a_constant_breadth_is_the_base_circle() {
    let of =
        |angles, breadth: f64| programme(angles, FLAT, &[&format!("cam.breadth={breadth} mm")]);
    let design = of(EVEN, 130.0).unwrap();
    near(design.cam.follower.base_radius(), 0.06, 1e-12);
    // A rise and a fall of other angles keep no breadth, and no cam is narrower than its lift.
    let code = |angles, breadth| of(angles, breadth).unwrap_err().code().to_string();
    assert_eq!(
        code([100.0, 80.0, 140.0, 40.0], 130.0),
        "synth-no-constant-breadth"
    );
    assert_eq!(code(EVEN, 9.0), "synth-breadth-too-small");
}

#[test]
fn a_thin_shaft_is_told_of_where_no_bore_is_given() {
    let thin = |changes: &[&str]| {
        let cam = format!("{FLAT}\nbase_radius = \"6 mm\"");
        let all = [
            &["drive.spring_rate=2000 N/mm", "limits.curvature=0"],
            changes,
        ]
        .concat();
        let notes = programme(EVEN, &cam, &all).unwrap().notes;
        notes.iter().any(|n| matches!(n, Note::ThinShaft { .. }))
    };
    assert!(thin(&[]) && !thin(&["cam.bore=4 mm"]));
}

#[test]
fn a_pressure_angle_that_is_asked_on_one_side_is_no_habit() {
    let habit = |changes: &[&str]| {
        let notes = programme(EVEN, ROLLER, changes).unwrap().notes;
        notes
            .iter()
            .any(|n| matches!(n, Note::UsualPressureAngle { .. }))
    };
    assert!(habit(&[]));
    assert!(!habit(&["limits.pressure_angle_rise=30 deg"]));
    assert!(!habit(&["limits.pressure_angle_fall=30 deg"]));
}

#[test]
fn a_roller_is_thinner_than_the_floor_of_its_groove() {
    // Lift and pressure angle ask for less than the roller does.
    let barrel = "follower = \"barrel\"\nroller_radius = \"40 mm\"\ndepth = \"6 mm\"";
    let design = programme(EVEN, barrel, &["limits.pressure_angle=80 deg"]).unwrap();
    let floor = design.cam.follower.base_radius() - 0.006;
    assert!(floor > 0.04 && floor < 0.0401, "{floor}");
}
