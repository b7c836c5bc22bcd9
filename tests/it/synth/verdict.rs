//! Every row of the table of verdicts (docs/verdict.md) on both sides of its bound. Codes are compared, not texts.

use gaitcam::Problem;
use gaitcam::cam::{Continuity, Verdict};
use gaitcam::dynamics::{Model, simulate};
use gaitcam::force::ForceCurve;
use gaitcam::problem::Note;
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use gaitcam_test_support::{scene_of, young};

/// Design of a programme of two rises and a dwell with a follower.
fn programme(motion: &str, cam: &str, changes: &[&str]) -> Design {
    let lift = if cam.contains("oscillating") {
        "10 deg"
    } else {
        "10 mm"
    };
    let text = format!(
        "name = \"x\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\n[law]\nfamily = \"program\"\n\
         [[law.segment]]\nmotion = \"{motion}\"\nlift = \"{lift}\"\nangle = \"120 deg\"\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\"\n\
         [[law.segment]]\nmotion = \"{motion}\"\nlift = \"-{lift}\"\nangle = \"120 deg\"\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\"\n[cam]\n{cam}\n"
    );
    synthesise(&scene_of(&text, changes), None).unwrap()
}

fn walking(changes: &[&str]) -> Design {
    let target = young();
    synthesise(&scene_of(scene::DEFAULT, changes), Some(&target)).unwrap()
}

fn codes(design: &Design) -> Vec<String> {
    design.reasons.iter().map(|r| r.code()).collect()
}

fn has(design: &Design, code: &str) -> bool {
    codes(design).iter().any(|c| c == code)
}

fn judged(design: &Design, verdict: Verdict, code: &str) {
    assert_eq!(design.verdict, verdict, "{:?}", design.reasons);
    assert!(has(design, code), "{code}: {:?}", design.reasons);
}

const FLAT: &str = "follower = \"flat-translating\"\nbase_radius = \"60 mm\"";
const ROLLER: &str = "follower = \"roller-translating\"\nroller_radius = \"5 mm\"\noffset = \"0\"\nbase_radius = \"60 mm\"";
const ARM: &str = "follower = \"roller-oscillating\"\nroller_radius = \"8 mm\"\nbase_radius = \"60 mm\"\n\
                   pivot_distance = \"130 mm\"\narm = \"100 mm\"";
const BARREL: &str =
    "follower = \"barrel\"\nroller_radius = \"4 mm\"\ndepth = \"6 mm\"\nbase_radius = \"40 mm\"";

#[test]
fn continuity_makes_three_classes() {
    for cam in [FLAT, ROLLER, ARM, BARREL] {
        let smooth = programme("3-4-5", cam, &[]);
        judged(&smooth, Verdict::Acceptable, "reason-all-hold");
        judged(
            &programme("parabolic", cam, &[]),
            Verdict::NotForHighSpeed,
            "reason-acceleration-jumps",
        );
        let continuity = Continuity::of(&smooth.cam);
        assert_eq!(
            [continuity.s, continuity.v, continuity.a, continuity.j],
            [true, true, true, false]
        );
        let higher = Continuity::of(&programme("4-5-6-7", cam, &[]).cam);
        assert!(higher.j);
    }
}

#[test]
fn a_jump_makes_the_next_derivative_infinite_and_no_limit_on_it_holds() {
    let jerky = programme("parabolic", FLAT, &["limits.jerk=1e9 m/s^3"]);
    judged(&jerky, Verdict::Unacceptable, "reason-limit-unbounded");
    // No larger limit is advised.
    let no_advice = |r: &String| !r.contains("relax") && !r.contains("not-the-limits");
    assert!(codes(&jerky).iter().all(no_advice), "{:?}", codes(&jerky));
    let jerk = jerky
        .checks
        .iter()
        .find(|c| c.name.name() == "jerk")
        .unwrap();
    assert!(jerk.worst == f64::INFINITY && !jerk.pass);
    let (low, high) = jerky.cam.derivative_extremes(3);
    assert_eq!((low.value, high.value), (f64::NEG_INFINITY, f64::INFINITY));
    assert!(jerky.cam.derivative_extremes(2).1.value.is_finite());
    // The jerk of 3-4-5 jumps, and is finite.
    let finite = programme("3-4-5", FLAT, &["limits.jerk=1e9 m/s^3"]);
    judged(&finite, Verdict::Acceptable, "reason-all-hold");
    assert!(gaitcam::synth::Figures::of(&jerky).peaks[2].is_infinite());
}

/// Design with a follower of 1 kg on a soft spring with this preload.
fn loaded(cam: &str, preload: &str) -> Design {
    let preload = format!("drive.preload={preload}");
    let changes = ["drive.mass=1 kg", "drive.spring_rate=100 N/m", &preload];
    programme("3-4-5", cam, &changes)
}

#[test]
fn a_follower_held_by_force_is_never_pulled() {
    judged(
        &loaded(FLAT, "20 N"),
        Verdict::Acceptable,
        "reason-all-hold",
    );
    for cam in [FLAT, ROLLER] {
        judged(
            &loaded(cam, "0.1 N"),
            Verdict::Unacceptable,
            "reason-contact-lost",
        );
    }
    let arm = |preload: &str| {
        let rest = format!("drive.preload={preload}");
        programme("3-4-5", ARM, &["drive.inertia=0.01 kg m^2", &rest])
    };
    judged(&arm("5 N m"), Verdict::Acceptable, "reason-all-hold");
    judged(
        &arm("0.01 N m"),
        Verdict::Unacceptable,
        "reason-contact-lost",
    );
}

#[test]
fn a_form_closed_follower_may_be_pulled() {
    judged(
        &loaded(BARREL, "0.1 N"),
        Verdict::Acceptable,
        "reason-all-hold",
    );
    let pair = programme(
        "3-4-5",
        &format!("{ROLLER}\n[cam.conjugate]\ndistance = \"160 mm\""),
        &["drive.mass=1 kg"],
    );
    judged(&pair, Verdict::Acceptable, "reason-all-hold");
}

#[test]
fn the_least_force_is_zero_where_a_force_holds_the_follower_and_no_other_is_written() {
    // A spring that touches 0 in the rest loses nothing; a motion alone has no force.
    judged(
        &programme("3-4-5", FLAT, &["drive.spring_rate=1000 N/m"]),
        Verdict::Acceptable,
        "reason-all-hold",
    );
    // A written bound takes the place of 0, and "none" switches it off, visibly.
    let changes = ["drive.mass=1 kg", "limits.force_min=-100 N"];
    judged(
        &programme("3-4-5", FLAT, &changes),
        Verdict::Acceptable,
        "reason-all-hold",
    );
    // No limit is to blame where nothing presses; where a spring does, the smallest force reached is suggested.
    let pressed = programme("3-4-5", FLAT, &["drive.mass=1 kg", "limits.force_min=1 N"]);
    judged(&pressed, Verdict::Unacceptable, "reason-nothing-presses");
    assert!(pressed.relaxed().relaxations.is_empty());
    let sprung = programme(
        "3-4-5",
        FLAT,
        &["drive.spring_rate=1000 N/m", "limits.force_min=1 N"],
    );
    assert_eq!(sprung.relaxed().relaxations[0].to, Some(0.0));
    let off = programme("3-4-5", FLAT, &["drive.mass=1 kg", "limits.force_min=none"]);
    judged(&off, Verdict::Acceptable, "reason-all-hold");
    let note = Note::NotJudged {
        key: "limits.force_min",
    };
    assert!(off.notes.contains(&note));
}

#[test]
fn a_moving_axis_is_held_by_its_weight() {
    let text = "name = \"x\"\n[drive]\nkind = \"moving-axis\"\nmass = \"1 kg\"\nspeed = \"30 rad/s\"\n[law]\nfamily = \"program\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"10 mm\"\nangle = \"180 deg\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-10 mm\"\nangle = \"180 deg\"\n\
        [cam]\nfollower = \"flat-translating\"\nbase_radius = \"30 mm\"\n";
    // ω² < g/|a|max with a = 2πh/β².
    let edge = (9.80665 / (std::f64::consts::TAU * 0.01 / std::f64::consts::PI.powi(2))).sqrt();
    let at = |w: f64| {
        let speed = format!("drive.speed={w} rad/s");
        synthesise(&scene_of(text, &[&speed]), None).unwrap()
    };
    judged(&at(0.999 * edge), Verdict::Acceptable, "reason-all-hold");
    let fast = at(1.001 * edge);
    judged(
        &fast,
        Verdict::Unacceptable,
        "reason-lifts-off-as-prescribed",
    );
}

#[test]
fn the_pressure_angle_has_two_bounds_for_every_follower_that_has_one() {
    // The largest angle falls as the cam grows: sizes from both sides of both bounds.
    for (cam, key, usual) in [
        (ROLLER, "cam.base_radius", 30.0_f64),
        (ARM, "cam.base_radius", 35.0),
        (BARREL, "cam.base_radius", 30.0),
    ] {
        let mut seen = [false; 3];
        for mm in 5..80 {
            let text = format!("{key}={mm} mm");
            let lift = if cam == ROLLER || cam == BARREL {
                "30 mm"
            } else {
                "25 deg"
            };
            let (up, down) = (
                format!("law.segment.1.lift={lift}"),
                format!("law.segment.3.lift=-{lift}"),
            );
            let scene = std::panic::catch_unwind(|| programme("3-4-5", cam, &[&text, &up, &down]));
            let Ok(design) = scene else { continue };
            let (low, high) = design.pressure_angle_extremes();
            let angle = high.value.max(-low.value).to_degrees();
            let class = usize::from(angle > usual) + usize::from(angle > 45.0);
            seen[class] = true;
            assert_eq!(
                has(&design, "reason-large-pressure-angle"),
                class == 1,
                "{angle}"
            );
            assert_eq!(has(&design, "reason-pressure-angle"), class == 2, "{angle}");
            let written = programme(
                "3-4-5",
                cam,
                &[&text, &up, &down, "limits.pressure_angle=none"],
            );
            assert!(!codes(&written).iter().any(|c| c.contains("pressure-angle")));
        }
        assert_eq!(&seen[..2], &[true; 2], "{key} of {usual}: {seen:?}");
    }
    // A written limit takes the place of both bounds; a flat face has none.
    let wide = [
        "cam.base_radius=5 mm",
        "limits.pressure_angle=89 deg",
        "limits.curvature=0",
    ];
    let wide = programme("3-4-5", ROLLER, &wide);
    assert!(!codes(&wide).iter().any(|c| c.contains("pressure-angle")));
    let flat = programme("3-4-5", FLAT, &[]);
    assert!(!flat.checks.iter().any(|c| c.name.is_pressure_angle()));
}

#[test]
fn undercut_is_unacceptable_and_a_cusp_is_for_slow_machines() {
    let size = |mm: f64| {
        let radius = format!("cam.base_radius={mm} mm");
        programme("3-4-5", FLAT, &[&radius])
    };
    let sized = programme("3-4-5", "follower = \"flat-translating\"", &[]);
    let least = 1e3 * sized.cam.follower.base_radius();
    judged(&sized, Verdict::NotForHighSpeed, "reason-cusp");
    judged(&size(1.01 * least), Verdict::Acceptable, "reason-all-hold");
    judged(
        &size(0.99 * least),
        Verdict::Unacceptable,
        "reason-undercut",
    );
    // A limit of 0 allows the cusp and is told it; a radius above 0 and below its limit is no undercut.
    let pointed = programme(
        "3-4-5",
        "follower = \"flat-translating\"",
        &["limits.curvature=0"],
    );
    judged(&pointed, Verdict::NotForHighSpeed, "reason-cusp");
    let radius = format!("cam.base_radius={} mm", 1.01 * least);
    let sharp = programme("3-4-5", FLAT, &[&radius, "limits.curvature=10 mm"]);
    judged(&sharp, Verdict::Unacceptable, "reason-too-sharp");
    assert!(!has(&sharp, "reason-undercut") && !has(&sharp, "reason-cusp"));
}

#[test]
fn on_an_undercut_profile_the_contact_pressure_is_infinite() {
    let sized = programme("3-4-5", "follower = \"flat-translating\"", &[]);
    let undercut = format!(
        "cam.base_radius={} mm",
        990.0 * sized.cam.follower.base_radius()
    );
    let cam = programme(
        "3-4-5",
        FLAT,
        &[
            &undercut,
            "drive.kind=moving-axis",
            "drive.mass=1 kg",
            "cam.thickness=10 mm",
            "limits.hertz_pressure=500 MPa",
        ],
    );
    judged(&cam, Verdict::Unacceptable, "reason-pressure-unbounded");
    assert!(has(&cam, "reason-undercut") && !has(&cam, "reason-limit-unbounded"));
}

#[test]
fn a_cam_sized_by_the_usual_pressure_angle_is_good_for_any_machine() {
    let open = "follower = \"roller-translating\"\nroller_radius = \"5 mm\"\noffset = \"0\"";
    let sized = programme("3-4-5", open, &[]);
    let angles = sized.checks.iter().filter(|c| c.name.is_pressure_angle());
    let worst = angles.map(|c| c.worst).fold(0.0, f64::max);
    assert!((worst - 30_f64.to_radians()).abs() < 1e-9, "{worst}");
    judged(&sized, Verdict::Acceptable, "reason-all-hold");
}

#[test]
fn a_force_is_met_to_half_a_percent_where_nothing_else_is_asked() {
    let fixed = ["law.spans=16", "limits.stroke=35 mm", "accuracy.rms=auto"];
    let coarse = walking(&fixed);
    let percent = coarse.force.rms_error_percent_of_mean;
    assert!(percent > 0.5);
    judged(&coarse, Verdict::Unacceptable, "reason-force-error");
    let fine = walking(&["law.spans=48", "accuracy.rms=auto"]);
    judged(&fine, Verdict::Acceptable, "reason-all-hold");
    let accepting = |share: f64| {
        let text = format!("accuracy.rms={} %", share * percent);
        walking(&["law.spans=16", "limits.stroke=35 mm", &text])
    };
    judged(&accepting(1.001), Verdict::Acceptable, "reason-all-hold");
    judged(
        &accepting(0.999),
        Verdict::Unacceptable,
        "reason-force-error",
    );
    let off = walking(&["law.spans=16", "limits.stroke=35 mm", "accuracy.rms=none"]);
    judged(&off, Verdict::Acceptable, "reason-all-hold");
    assert!(off.notes.contains(&Note::NotJudged {
        key: "accuracy.rms"
    }));
}

#[test]
fn the_spread_of_a_recording_is_accuracy_enough() {
    let text = ["law.spans=16", "limits.stroke=35 mm", "accuracy.rms=auto"];
    let coarse = walking(&text).force.rms_error_n;
    for (part, verdict) in [(1.01, Verdict::Acceptable), (0.99, Verdict::Unacceptable)] {
        let mut target = young();
        target.spread_n = Some(vec![part * coarse; target.force_n.len()]);
        let design = synthesise(&scene_of(scene::DEFAULT, &text), Some(&target)).unwrap();
        assert_eq!(design.verdict, verdict, "{:?}", design.reasons);
    }
}

#[test]
fn a_mean_force_that_is_not_the_weight_comes_first_with_its_cure() {
    let target = young();
    for (mass, first) in [("80 kg", true), ("71.5 kg", true), ("71.38 kg", false)] {
        let text = format!("drive.mass={mass}");
        let scene = scene_of(scene::DEFAULT, &[&text]);
        let design = synthesise(&scene, Some(&target)).unwrap();
        let design = design.relaxed();
        assert_eq!(
            codes(&design)[0] == "reason-mean-force",
            first,
            "{mass}: {:?}",
            design.reasons
        );
        assert_eq!(design.verdict == Verdict::Unacceptable, first);
        assert!(design.relaxations.is_empty());
    }
    let scaled = walking(&["drive.mass=80 kg", "gait.scale=to-mass"]);
    judged(&scaled, Verdict::Acceptable, "reason-all-hold");
}

#[test]
fn a_limit_that_is_broken_is_unacceptable_and_all_reasons_are_told() {
    let stroke = walking(&["law.spans=16"]).cam.law.stroke();
    let limited = |part: f64| {
        let text = format!("limits.stroke={} mm", 1e3 * part * stroke);
        programme("3-4-5", FLAT, &[&text])
    };
    let own = programme("3-4-5", FLAT, &[]).cam.law.stroke() / stroke;
    judged(
        &limited(1.001 * own),
        Verdict::Acceptable,
        "reason-all-hold",
    );
    judged(
        &limited(0.999 * own),
        Verdict::Unacceptable,
        "reason-limit-broken",
    );
    let all = programme(
        "parabolic",
        ROLLER,
        &[
            "limits.stroke=1 mm",
            "drive.mass=1 kg",
            "limits.pressure_angle=1 deg",
        ],
    );
    let expected = [
        "reason-contact-lost",
        "reason-pressure-angle",
        "reason-limit-broken",
        "reason-acceleration-jumps",
    ];
    assert_eq!(codes(&all), expected);
}

#[test]
fn contact_lost_in_a_run_is_no_good_cam() {
    let design = programme("3-4-5", FLAT, &[]);
    let machine = scene_of(scene::DEFAULT, &[]).machine;
    let run = design.emitted(&machine, design.problem.drive).unwrap();
    let kept = simulate(&run, Model::Rigid).unwrap();
    assert_eq!(codes(&design.clone().judged_in(&kept)), ["reason-all-hold"]);
    let mut lost = kept;
    (lost.contact_lost, lost.lost_fraction) = (true, 0.1);
    let design = design.judged_in(&lost);
    judged(&design, Verdict::Unacceptable, "reason-contact-lost-in-run");
    assert_eq!(codes(&design).len(), 1);
}

#[test]
fn none_is_read_and_written_back() {
    let keys = ["limits.pressure_angle", "limits.force_min", "accuracy.rms"];
    for key in keys {
        let scene = scene_of(scene::DEFAULT, &[&format!("{key}=none")]);
        assert_eq!(scene.limits.unjudged.keys(), [key]);
        let again = scene::read(&scene.to_table()).unwrap();
        assert_eq!(again, scene);
        let notes = Problem::resolve(&scene, Some(&young())).unwrap().notes();
        assert!(notes.contains(&Note::NotJudged { key }));
    }
}

#[test]
fn a_preload_above_the_target_is_named_as_the_cause_of_the_force_error() {
    // Half a sine of 500 N and nothing: a spring with a preload of 20 N presses with 20 N at least.
    let force = |i: i32| (500.0 * (f64::from(i) * std::f64::consts::TAU / 200.0).sin()).max(0.0);
    let target = ForceCurve::from_samples("a push", 1.0, (0..200).map(force).collect()).unwrap();
    let pressed = |preload: &str| {
        let text = format!(
            "[gait]\nmodel = \"young\"\n[drive]\nkind = \"fixed-axis\"\nspring_rate = \"20 N/mm\"\n\
             preload = \"{preload}\"\n[cam]\n{ROLLER}"
        );
        let scene = gaitcam::scene::Scene {
            gait: Some(scene::Gait::given()),
            ..scene_of(&text, &[])
        };
        synthesise(&scene, Some(&target)).unwrap()
    };
    judged(
        &pressed("20 N"),
        Verdict::Unacceptable,
        "reason-preload-above-target",
    );
    assert!(!has(&pressed("20 N"), "reason-force-error"));
    for preload in ["0", "-20 N"] {
        assert!(
            !has(&pressed(preload), "reason-preload-above-target"),
            "{preload}"
        );
    }
}

#[test]
fn a_roller_larger_than_its_cam_is_noted() {
    let noted = |radius: &str| {
        let design = walking(&[
            "cam.follower=roller-translating",
            &format!("cam.roller_radius={radius}"),
        ]);
        (design.notes.iter()).any(|note| matches!(note, Note::LargeRoller { .. }))
    };
    assert!(noted("10 m"));
    assert!(!noted("10 mm"));
    // The arc of a mushroom follower may be as large as it likes: it does not roll.
    let mushroom = walking(&["cam.follower=mushroom-translating", "cam.arc_radius=10 m"]);
    assert!(!(mushroom.notes.iter()).any(|note| matches!(note, Note::LargeRoller { .. })));
}

/// A law without a stroke is on its base circle, up to rounding of the solver.
#[test]
fn a_wider_accuracy_keeps_a_law_that_needs_no_stroke() {
    let text = "name = \"still\"\n[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\nbody_weight = \"700 N\"\n\
        [drive]\nkind = \"fixed-axis\"\nmass = \"34.0260598325689 kg\"\nspring_rate = \"0.7434987753318931 N/mm\"\n\
        preload = \"0.4746198878647813 kN\"\n[law]\nfamily = \"spline\"\ndegree = 3\nminimise = \"peak-acceleration\"\n\
        [cam]\nfollower = \"flat-translating\"\nbore = \"12 mm\"\n";
    for rms in ["5 %", "20 %", "50 %", "100 %", "500 %"] {
        let scene = scene_of(text, &[&format!("accuracy.rms={rms}")]);
        let design = synthesise(&scene, Some(&young())).unwrap();
        assert_ne!(
            design.verdict,
            Verdict::Unacceptable,
            "{rms}: {:?}",
            design.reasons
        );
    }
}
