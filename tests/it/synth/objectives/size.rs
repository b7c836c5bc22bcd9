//! Size of a cam if the scene does not give it, compared with closed forms, and the remarks on it.

use gaitcam::criterion::LimitKind;
use gaitcam::error::Error;
use gaitcam::problem::Note;
use gaitcam::synth::{Design, Reason, synthesise};
use gaitcam_test_support::near;

/// Programme of rise, dwell, fall and dwell with these angles, 10 mm high.
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
    // An eccentric's smallest flat-faced cam has no base circle at all, and no shaft is thicker than none.
    let eccentric = [1, 3].map(|i| format!("law.segment.{i}.motion=simple-harmonic"));
    let changes = ["drive.spring_rate=2000 N/mm", &eccentric[0], &eccentric[1]];
    let design = programme([170.0, 10.0, 170.0, 10.0], FLAT, &changes).unwrap();
    near(design.cam.follower.base_radius(), 0.0, 0.0);
    let thin = design
        .notes
        .iter()
        .any(|n| matches!(n, Note::ThinShaft { .. }));
    assert!(!thin);
}

#[test]
fn the_size_that_a_sharp_cam_needs_lets_the_pivot_lie_within_the_profile_where_it_may() {
    let of = |base: f64| {
        let arm = "follower = \"roller-oscillating\"\nroller_radius = \"5 mm\"\npivot_distance = \"50 mm\"\n\
                   arm = \"60 mm\"\npivot_beside = true";
        let base = format!("cam.base_radius={base} m");
        let lifts = ["law.segment.1.lift=20 deg", "law.segment.3.lift=-20 deg"];
        let drive = ["drive.spring_rate=5 N m/rad", "limits.curvature=40 mm"];
        programme(EVEN, arm, &[&lifts[..], &drive, &[&base]].concat()).unwrap()
    };
    let needed = of(0.02).reasons.into_iter().find_map(|r| match r {
        Reason::BaseRadiusWorks { radius } => Some(radius.value),
        _ => None,
    });
    let needed = needed.unwrap();
    let keeps = |base: f64| {
        let design = of(base);
        let mut checks = design.checks.iter();
        let check = checks.find(|c| c.name == LimitKind::Curvature);
        check.unwrap().pass
    };
    // There the profile goes around the pivot.
    assert!(of(needed).cam.curvature().convex.value > 0.0 && needed > 0.045);
    assert!(keeps(needed * (1.0 + 1e-6)) && !keeps(needed * (1.0 - 1e-6)));
}

/// A cam is impossible if its bore is larger than the limit on the size. The reported size is that of the limit.
#[test]
fn a_bore_beyond_the_limit_on_the_size_leaves_the_law_and_is_reported() {
    let of = |bore: &str| {
        let text = format!(
            "name = \"x\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\nspring_rate = \"5 N/mm\"\n\
             [law]\nfamily = \"spline\"\nminimise = \"size\"\nspans = 12\n\
             [[law.point]]\nangle = \"0 deg\"\nlift = \"0\"\n[[law.point]]\nangle = \"180 deg\"\nlift = \"5 mm\"\n\
             [cam]\nfollower = \"flat-translating\"\n{bore}[limits]\nprime_radius = \"15 mm\"\n"
        );
        synthesise(
            &gaitcam_test_support::scene(&text, &[] as &[&str]).unwrap(),
            None,
        )
        .unwrap()
    };
    let (held, free) = (of("bore = \"40 mm\"\n"), of(""));
    assert!(free.infeasible.is_none() && free.solver.certified);
    // The program holds the limit and not the hole, so its law is proved; the checks see the cam about the hole.
    assert!(held.solver.certified, "{:?}", held.solver);
    near(held.cam.follower.prime_radius(), 0.021, 1e-9);
    let fails: Vec<&str> = (held.checks.iter().filter(|c| !c.pass))
        .map(|c| c.name.name())
        .collect();
    assert_eq!(fails, ["prime_radius"]);
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

#[test]
fn a_given_size_is_no_habit() {
    let notes = |changes: &[&str]| {
        let design = programme(EVEN, ROLLER, changes).unwrap();
        let steepest = design.cam.pressure_angle_extremes().1.value;
        let habit = |n: &Note| matches!(n, Note::UsualPressureAngle { .. });
        (steepest.to_degrees(), design.notes.iter().any(habit))
    };
    let (open, habit) = notes(&[]);
    near(open, 30.0, 1e-6);
    assert!(habit);
    let (given, habit) = notes(&["cam.prime_radius=8 mm"]);
    assert!(given > 31.0 && !habit, "{given}");
}

#[test]
fn a_roller_runs_around_the_hub_of_a_wide_hole() {
    for motion in ["roller", "knife"] {
        let cam = format!("follower = \"{motion}-translating\"\nbore = \"60 mm\"\noffset = \"0\"");
        let roller = ["cam.roller_radius=5 mm"];
        let changes = if motion == "roller" { &roller[..] } else { &[] };
        let design = programme(EVEN, &cam, changes).unwrap();
        near(design.cam.follower.base_radius(), 0.045, 1e-12);
    }
}
