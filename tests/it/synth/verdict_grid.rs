//! Rows of the table of verdicts that depend on the follower (docs/verdict.md), on both sides of their bounds: translating followers, arms,
//! form-closed pairs and barrels.

use gaitcam::cam::Verdict;
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};

const FLAT: &str = "follower = \"flat-translating\"";
const ROLLER: &str = "follower = \"roller-translating\"\nroller_radius = \"5 mm\"";
const KNIFE: &str = "follower = \"knife-translating\"";
const MUSHROOM: &str = "follower = \"mushroom-translating\"\narc_radius = \"12 mm\"";
const ARM: &str = "follower = \"roller-oscillating\"\nroller_radius = \"8 mm\"\npivot_distance = \"130 mm\"\narm = \"100 mm\"";
const KNIFE_ARM: &str =
    "follower = \"knife-oscillating\"\npivot_distance = \"130 mm\"\narm = \"100 mm\"";
const MUSHROOM_ARM: &str = "follower = \"mushroom-oscillating\"\narc_radius = \"12 mm\"\npivot_distance = \"130 mm\"\narm = \"100 mm\"";
const BARREL: &str = "follower = \"barrel\"\nroller_radius = \"4 mm\"\ndepth = \"6 mm\"";
const PAIR: &str = "follower = \"roller-translating\"\nroller_radius = \"5 mm\"\n[cam.conjugate]\ndistance = \"180 mm\"";

fn swings(cam: &str) -> bool {
    cam.contains("oscillating")
}

/// Lift in the unit of the follower: 1 mm of a slide corresponds to 1° of an arm.
fn lift(cam: &str, size: f64) -> String {
    let unit = if swings(cam) { "deg" } else { "mm" };
    format!("{size} {unit}")
}

/// Design of a scene without force, with the given cam on a base circle of `base_mm` mm.
fn design(law: &str, cam: &str, base_mm: f64, changes: &[&str]) -> Option<Design> {
    let (first, pair) = cam.split_once("\n[").unwrap_or((cam, ""));
    let pair = if pair.is_empty() {
        String::new()
    } else {
        format!("[{pair}")
    };
    let text = format!(
        "name = \"x\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\n[law]\n{law}\n[cam]\n{first}\nbase_radius = \"{base_mm} mm\"\n{pair}\n"
    );
    let scene = gaitcam_test_support::scene(&text, changes).unwrap();
    synthesise(&scene, None).ok()
}

/// Programme of rise, dwell, return, dwell.
fn programme(motion: &str, cam: &str, size: f64) -> String {
    let up = lift(cam, size);
    format!(
        "family = \"program\"\n\
         [[law.segment]]\nmotion = \"{motion}\"\nlift = \"{up}\"\nangle = \"120 deg\"\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\"\n\
         [[law.segment]]\nmotion = \"{motion}\"\nlift = \"-{up}\"\nangle = \"120 deg\"\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\""
    )
}

fn has(design: &Design, code: &str) -> bool {
    design.reasons.iter().any(|r| r.code() == code)
}

#[test]
fn a_velocity_that_jumps_is_unacceptable_for_every_follower_and_a_joined_one_is_not() {
    for cam in [FLAT, ROLLER, MUSHROOM, ARM, PAIR, BARREL] {
        let (bottom, top) = (lift(cam, 0.0), lift(cam, 8.0));
        let points = |velocity: &str| {
            [(0, &bottom), (150, &top), (360, &bottom)]
                .map(|(angle, lift)| {
                    format!("[[law.point]]\nangle = \"{angle} deg\"\nlift = \"{lift}\"\n{velocity}")
                })
                .join("\n")
        };
        let law = |velocity: &str| format!("family = \"polynomial\"\n{}", points(velocity));
        let broken = design(&law(""), cam, 60.0, &[]).unwrap();
        assert_eq!(broken.verdict, Verdict::Unacceptable, "{cam}");
        assert!(
            has(&broken, "reason-velocity-jumps"),
            "{cam}: {:?}",
            broken.reasons
        );
        assert!(broken.cam.derivative_extremes(2).1.value.is_infinite());
        let joined = law("velocity = \"0\"\nacceleration = \"0\"");
        let joined = design(&joined, cam, 60.0, &[]).unwrap();
        assert_eq!(
            joined.verdict,
            Verdict::Acceptable,
            "{cam}: {:?}",
            joined.reasons
        );
    }
}

/// Asserts the verdict for the largest pressure angle of a design and returns its class: 0 within the usual angle, 1 within 45°, 2 above. If one side
/// is too steep for any use, the other may be steep too.
fn judged_steep(built: &Design, usual: f64) -> usize {
    let second = built.conjugate.as_ref().map(|pair| &pair.second);
    let largest = std::iter::once(&built.cam).chain(second).map(|cam| {
        let (low, high) = cam.pressure_angle_extremes();
        high.value.max(-low.value).to_degrees()
    });
    let degrees = largest.fold(0.0, f64::max);
    let class = usize::from(degrees > usual) + usize::from(degrees > 45.0);
    let steep = has(built, "reason-large-pressure-angle");
    assert_eq!(has(built, "reason-pressure-angle"), class == 2, "{degrees}");
    assert!(steep == (class == 1) || class == 2, "{degrees}");
    let verdict = [
        Verdict::Acceptable,
        Verdict::NotForHighSpeed,
        Verdict::Unacceptable,
    ][class];
    assert!(
        built.verdict == verdict || built.reasons.len() > 1,
        "{degrees}: {:?}",
        built.reasons
    );
    class
}

#[test]
fn the_pressure_angle_has_its_bounds_under_every_follower_that_rolls_or_points() {
    for (cam, size, usual) in [
        (KNIFE, 30.0, 30.0),
        (MUSHROOM, 60.0, 30.0),
        (PAIR, 30.0, 30.0),
        (KNIFE_ARM, 30.0, 35.0),
        (MUSHROOM_ARM, 30.0, 35.0),
    ] {
        let law = programme("3-4-5", cam, size);
        let mut seen = [false; 3];
        for mm in 5..110 {
            if let Some(built) = design(&law, cam, f64::from(mm), &[]) {
                seen[judged_steep(&built, usual)] = true;
            }
        }
        assert_eq!(seen, [true; 3], "{cam}");
    }
    let slide = include_str!("../../../scenes/translating_cam.toml");
    let mut seen = [false; 3];
    for mm in 1..40 {
        let mut table: toml::Table = slide.parse().unwrap();
        for (segment, sign) in [(1, ""), (3, "-")] {
            let text = format!("law.segment.{segment}.lift={sign}{mm} mm");
            scene::set(&mut table, &text).unwrap();
        }
        if let Ok(built) = synthesise(&scene::read(&table).unwrap(), None) {
            seen[judged_steep(&built, 30.0)] = true;
        }
    }
    assert_eq!(seen, [true; 3]);
}

/// Smallest convex radius of curvature of all machined curves: both cams of a pair, both walls of a groove at its bottom.
fn sharpest(built: &Design) -> f64 {
    use gaitcam::cam::Wall;
    if let Some(groove) = &built.groove {
        let floor = groove.depth().0;
        let walls = [Wall::Upper, Wall::Lower].map(|wall| groove.smallest_bulge(floor, wall).value);
        return walls[0].min(walls[1]);
    }
    let second = built.conjugate.as_ref().map(|pair| &pair.second);
    let all = std::iter::once(&built.cam).chain(second);
    all.map(|cam| cam.curvature().convex.value)
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn a_profile_that_is_cut_away_is_unacceptable_under_every_follower() {
    for (cam, size) in [
        (ROLLER, 10.0),
        (MUSHROOM, 10.0),
        (ARM, 12.0),
        (PAIR, 10.0),
        (BARREL, 10.0),
    ] {
        let law = programme("3-4-5", cam, size)
            .replace("120 deg", "50 deg")
            .replace("60 deg", "130 deg");
        let roller = match cam {
            ARM => "cam.roller_radius=20 mm",
            ROLLER | PAIR => "cam.roller_radius=12 mm",
            _ => "cam.thickness=10 mm",
        };
        let off = ["limits.pressure_angle=none", roller];
        let mut seen = [0; 2];
        for mm in 6..90 {
            let Some(built) = design(&law, cam, f64::from(mm), &off) else {
                continue;
            };
            let undercut = sharpest(&built) < 0.0;
            seen[usize::from(undercut)] += 1;
            let told = [
                "reason-undercut",
                "reason-second-too-sharp",
                "reason-sharp-wall",
            ];
            let told = told.iter().any(|code| has(&built, code));
            assert_eq!(told, undercut, "{cam} {mm} mm: {:?}", built.reasons);
            if undercut {
                assert_eq!(built.verdict, Verdict::Unacceptable);
            }
        }
        assert!(seen[0] > 0 && seen[1] > 0, "{cam}: {seen:?}");
    }
}

#[test]
fn a_limit_holds_on_one_side_and_is_broken_on_the_other_for_every_follower() {
    for cam in [ROLLER, ARM, PAIR, BARREL] {
        let law = programme("3-4-5", cam, 8.0);
        let free = design(&law, cam, 60.0, &[]).unwrap();
        assert_eq!(
            free.verdict,
            Verdict::Acceptable,
            "{cam}: {:?}",
            free.reasons
        );
        let speed = free.problem.drive.speed;
        let (low, high) = free.cam.law.extremes(2);
        let most = high.value.max(-low.value) * speed * speed;
        let unit = if swings(cam) { "rad/s^2" } else { "m/s^2" };
        for (share, verdict) in [(1.001, Verdict::Acceptable), (0.999, Verdict::Unacceptable)] {
            let limit = format!("limits.acceleration={} {unit}", share * most);
            let limited = design(&law, cam, 60.0, &[&limit]).unwrap();
            assert_eq!(limited.verdict, verdict, "{cam}: {:?}", limited.reasons);
            assert_eq!(has(&limited, "reason-limit-broken"), share < 1.0);
        }
    }
}

#[test]
fn contact_is_judged_where_only_force_keeps_it() {
    for (cam, form_closed) in [
        (ROLLER, false),
        (MUSHROOM, false),
        (KNIFE, false),
        (ARM, false),
        (PAIR, true),
        (BARREL, true),
    ] {
        let law = programme("3-4-5", cam, 8.0);
        let mass = if swings(cam) {
            "drive.inertia=0.01 kg m^2"
        } else {
            "drive.mass=1 kg"
        };
        let rest = |newtons: f64| {
            let unit = if swings(cam) { "N m" } else { "N" };
            format!("drive.preload={newtons} {unit}")
        };
        let free = design(&law, cam, 60.0, &[mass]).unwrap();
        let pull = -free.force.min_n;
        assert!(pull > 0.0, "{cam}");
        assert_eq!(has(&free, "reason-contact-lost"), !form_closed, "{cam}");
        for (share, lost) in [(1.001, false), (0.999, true)] {
            let built = design(&law, cam, 60.0, &[mass, &rest(share * pull)]).unwrap();
            let lost = lost && !form_closed;
            assert_eq!(has(&built, "reason-contact-lost"), lost, "{cam} {share}");
            let bad = built.verdict == Verdict::Unacceptable;
            assert_eq!(bad, lost, "{cam} {share}: {:?}", built.reasons);
        }
    }
}

#[test]
fn an_acceleration_that_jumps_is_for_slow_machines_under_every_follower() {
    for cam in [FLAT, ROLLER, KNIFE, MUSHROOM, ARM, KNIFE_ARM, PAIR, BARREL] {
        let smooth = design(&programme("3-4-5", cam, 8.0), cam, 60.0, &[]).unwrap();
        assert_eq!(smooth.verdict, Verdict::Acceptable, "{cam}");
        let jerky = design(&programme("parabolic", cam, 8.0), cam, 60.0, &[]).unwrap();
        assert_eq!(jerky.verdict, Verdict::NotForHighSpeed, "{cam}");
        assert!(has(&jerky, "reason-acceleration-jumps"), "{cam}");
    }
}

#[test]
fn a_written_pressure_angle_takes_the_place_of_both_bounds() {
    for (cam, size) in [(ROLLER, 30.0), (ARM, 25.0), (PAIR, 30.0), (BARREL, 30.0)] {
        let law = programme("3-4-5", cam, size);
        // Small enough a cam for more than the usual angle, and for less than it.
        for base_mm in [30.0, 60.0, 100.0] {
            let Some(free) = design(&law, cam, base_mm, &["limits.pressure_angle=none"]) else {
                continue;
            };
            // Of the groove as well where there is one.
            let own = free.pressure_angle_extremes();
            let second = free.conjugate.as_ref().map(|pair| &pair.second);
            let second = second.map(|cam| cam.pressure_angle_extremes());
            let largest = std::iter::once(own)
                .chain(second)
                .map(|(low, high)| high.value.max(-low.value).to_degrees())
                .fold(0.0, f64::max);
            for (share, broken) in [(1.001, false), (0.999, true)] {
                let limit = format!("limits.pressure_angle={} deg", share * largest);
                let built = design(&law, cam, base_mm, &[&limit]).unwrap();
                assert_eq!(
                    has(&built, "reason-pressure-angle"),
                    broken,
                    "{cam} {base_mm}"
                );
                assert!(
                    !has(&built, "reason-large-pressure-angle"),
                    "{cam} {base_mm}"
                );
                let verdict = if broken {
                    Verdict::Unacceptable
                } else {
                    free.verdict
                };
                assert_eq!(
                    built.verdict, verdict,
                    "{cam} {base_mm}: {:?}",
                    built.reasons
                );
            }
        }
    }
}

#[test]
fn a_force_is_judged_by_its_error_and_its_mean_under_every_follower() {
    let target = gaitcam::force::model("young", Some(1.85), 700.0, gaitcam::force::Feet::Both);
    let target = target.unwrap();
    let walk = |changes: &[&str]| {
        let scene = gaitcam_test_support::scene(scene::DEFAULT, changes).unwrap();
        synthesise(&scene, Some(&target)).unwrap()
    };
    for follower in [
        &["cam.follower=flat-translating"][..],
        &["cam.follower=roller-translating", "cam.roller_radius=10 mm"],
        &["cam.follower=mushroom-translating", "cam.arc_radius=30 mm"],
        &[
            "cam.follower=roller-translating",
            "cam.roller_radius=10 mm",
            "cam.conjugate.distance=250 mm",
        ],
        &[
            "cam.follower=barrel",
            "cam.roller_radius=10 mm",
            "cam.depth=10 mm",
        ],
    ] {
        let with = |more: &[&str]| {
            let size = [
                "cam.base_radius=80 mm",
                "law.spans=16",
                "limits.stroke=35 mm",
            ];
            walk(&[follower, &size, more].concat())
        };
        let percent = with(&[]).force.rms_error_percent_of_mean;
        assert!(percent > 0.5);
        for (share, verdict) in [(1.001, Verdict::Acceptable), (0.999, Verdict::Unacceptable)] {
            let built = with(&[&format!("accuracy.rms={} %", share * percent)]);
            assert_eq!(built.verdict, verdict, "{follower:?}: {:?}", built.reasons);
            assert_eq!(has(&built, "reason-force-error"), share < 1.0);
        }
        for (mass, wrong) in [("71.5 kg", true), ("71.38 kg", false)] {
            let built = with(&["accuracy.rms=20 %", &format!("drive.mass={mass}")]);
            assert_eq!(
                has(&built, "reason-mean-force"),
                wrong,
                "{follower:?} {mass}"
            );
            assert_eq!(
                built.verdict == Verdict::Unacceptable,
                wrong,
                "{follower:?}"
            );
        }
    }
}
