//! The limit on the diameter over random designs, against dense points of the profile.

use gaitcam::LimitKind;
use gaitcam_lab::twins::Dice;
use gaitcam_test_support::{design, design_of};

const DESIGNS: usize = 500;
const POINTS: usize = 20_000;

/// Scene of a spline that reproduces a walking force with a random follower.
fn scene(dice: &mut Dice) -> String {
    let roller = |dice: &mut Dice| {
        let radius = dice.between(4.0, 12.0);
        format!("follower = \"roller-translating\"\nroller_radius = \"{radius} mm\"")
    };
    let follower = match dice.between(0.0, 6.0) as usize {
        0 => "follower = \"flat-translating\"".to_string(),
        1 => {
            let radius = dice.between(20.0, 60.0);
            format!("follower = \"flat-translating\"\nbase_radius = \"{radius} mm\"")
        }
        2 => roller(dice),
        3 => format!("{}\noffset = \"auto\"", roller(dice)),
        4 => {
            let (offset, radius) = (dice.between(-8.0, 8.0), dice.between(40.0, 90.0));
            format!(
                "{}\noffset = \"{offset} mm\"\nprime_radius = \"{radius} mm\"",
                roller(dice)
            )
        }
        _ => {
            let radius = dice.between(30.0, 90.0);
            format!("follower = \"mushroom-translating\"\narc_radius = \"{radius} mm\"")
        }
    };
    let frequency = dice.between(1.6, 2.3);
    let spans = dice.between(8.0, 20.0) as usize;
    format!(
        "[gait]\nmodel = \"young\"\nstep_frequency = \"{frequency} Hz\"\nbody_weight = \"700 N\"\n[cam]\n{follower}\n\
         [law]\nfamily = \"spline\"\nspans = {spans}\n[accuracy]\nrms = \"none\"\n[limits]\ncurvature = \"4 mm\"\n"
    )
}

/// No design whose limit on the diameter passes is larger than this limit. Prints how many designs pass and how many laws are certified.
#[test]
fn no_random_design_that_passes_is_larger_than_its_limit() {
    let mut dice = Dice(500);
    let (mut designed, mut passed, mut acceptable, mut certified) = (0, 0, 0, 0);
    for number in 0..DESIGNS {
        let text = scene(&mut dice);
        let natural = 2.0 * design_of(&text, &[]).cam.radii().unwrap()[1].value;
        let limit = natural * dice.between(0.75, 1.2);
        let Ok(design) = design(&text, &[&format!("limits.diameter={limit} m")]) else {
            continue;
        };
        designed += 1;
        let radius = |p: &gaitcam::cam::ProfilePoint| p.x.hypot(p.y);
        let largest = 2.0
            * design
                .cam
                .profile(POINTS)
                .iter()
                .map(radius)
                .fold(0.0, f64::max);
        let own = design.checks.iter().find(|c| c.name == LimitKind::Diameter);
        let own = own.expect("the limit is checked");
        assert!(
            (own.worst - largest).abs() < 1e-6 * largest,
            "{number}: {largest} {}\n{text}",
            own.worst
        );
        if own.pass {
            passed += 1;
            assert!(
                largest <= limit * (1.0 + 1e-8),
                "{number}: {largest} {limit}\n{text}"
            );
            acceptable += usize::from(design.checks.iter().all(|c| c.pass));
            certified += usize::from(design.solver.certified);
        }
    }
    println!(
        "{designed} designs, {passed} within the diameter, {acceptable} with all limits, {certified} certified"
    );
    assert!(designed >= 450, "{designed} designs");
    assert!(passed >= 300, "{passed} designs are within the limit");
}
