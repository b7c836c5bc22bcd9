//! Many and few spans: accurate proofs, and searches that do not end with the first few spans.

use gaitcam::criterion::Criterion;
use gaitcam::scene::{self, Minimise};
use gaitcam::synth::{Binding, Design, Tier, synthesise};
use gaitcam_test_support::{scene_of, young};

fn designed(changes: &[&str]) -> Design {
    let scene = scene_of(scene::DEFAULT, changes);
    let design = synthesise(&scene, Some(&young())).unwrap();
    design.relaxed()
}

/// Value that an infeasible design suggests for a key.
fn advised(design: &Design, key: &str) -> f64 {
    let told = design.relaxations.iter().find(|r| r.key == key);
    told.and_then(|r| r.to)
        .unwrap_or_else(|| panic!("{key}: {:?}", design.relaxations))
}

/// Nested spaces: more spans can only reduce the force error, and each proof states the distance to the optimum.
#[test]
fn limits_on_many_spans_are_proved_like_those_on_few() {
    let three = [
        "limits.stroke=48 mm",
        "limits.acceleration=3 m/s^2",
        "limits.jerk=90 m/s^3",
    ];
    // 80 % of the free law's acceleration is 3.96 m/s².
    let acceleration = ["limits.acceleration=3.96 m/s^2", "accuracy.rms=5 %"];
    let jerk = ["limits.jerk=56 m/s^3", "accuracy.rms=5 %"];
    for limits in [&three[..1], &three[..], &acceleration[..], &jerk[..]] {
        let mut before = f64::INFINITY;
        for spans in [32, 64, 128] {
            let given = format!("law.spans={spans}");
            let changes: Vec<&str> = [limits, &[&given, "law.family=spline"]].concat();
            let scene = scene_of(scene::DEFAULT, &changes);
            let design = synthesise(&scene, Some(&young())).unwrap();
            let proof = design.solver.certificate.unwrap();
            assert!(
                spans > 64 || design.solver.certified,
                "{changes:?}: {proof:?}"
            );
            assert!(proof.relative_gap < 1e-6, "{changes:?}: {proof:?}");
            let error = design.force.rms_error_n;
            assert!(error <= before * (1.0 + 1e-7), "{spans}: {error} {before}");
            before = error;
        }
    }
}

/// A fit without limits is the best law for any number of spans. Its proof does not depend on rounding.
#[test]
fn a_law_without_limits_is_proved_on_any_number_of_spans() {
    for degree in [3, 5, 7] {
        for spans in (8..=110).step_by(6) {
            let (given, degree) = (format!("law.spans={spans}"), format!("law.degree={degree}"));
            let plain = ["law.family=spline", "accuracy.rms=50 %"];
            let changes = [&plain[..], &[&given, &degree]].concat();
            let scene = scene_of(scene::DEFAULT, &changes);
            let design = synthesise(&scene, Some(&young())).unwrap();
            let proof = design.solver.certificate.unwrap();
            assert!(design.solver.certified, "{changes:?}: {proof:?}");
            assert!(proof.relative_gap < 1e-7, "{changes:?}: {proof:?}");
        }
    }
}

/// Active limits are reported where the law touches them, not on every span.
#[test]
fn many_spans_name_as_few_contacts_as_the_limits_have() {
    let limits = [
        "limits.stroke=46 mm",
        "limits.acceleration=3.96 m/s^2",
        "limits.jerk=56 m/s^3",
        "accuracy.rms=50 %",
        "law.family=spline",
        "law.spans=64",
    ];
    let design = synthesise(&scene_of(scene::DEFAULT, &limits), Some(&young())).unwrap();
    assert!(design.solver.certified);
    let largest = |b: &Binding| {
        let own = design.binding.iter().filter(|o| o.limit == b.limit);
        own.fold(0.0, |m: f64, o| m.max(o.multiplier))
    };
    let of_account = |b: &&Binding| b.multiplier > 1e-9 * largest(b);
    assert_eq!(
        design.binding.iter().filter(of_account).count(),
        design.binding.len()
    );
}

/// Every objective has a numerical proof, with few and many spans, and also without a force.
#[test]
fn every_objective_has_a_proof_in_numbers_on_few_spans_and_on_many() {
    for (name, _) in Minimise::NAMES {
        for spans in [36, 60, 120] {
            let (given, what) = (format!("law.spans={spans}"), format!("law.minimise={name}"));
            let changes = ["law.family=spline", "limits.stroke=47 mm", &given, &what];
            let scene = scene_of(scene::DEFAULT, &changes);
            let design = synthesise(&scene, Some(&young())).unwrap();
            let proof = design.solver.certificate.unwrap();
            let numbers = [
                proof.duality_gap,
                proof.relative_gap,
                proof.global_gap.unwrap(),
                proof.size,
                proof.stationarity,
                proof.violation,
            ];
            assert!(
                numbers.iter().all(|n| n.is_finite()),
                "{changes:?}: {proof:?}"
            );
            assert!(proof.stationarity < 1e-6, "{changes:?}: {proof:?}");
        }
    }
}

/// The suggested accuracy is that of the best number of spans, not of the first few.
#[test]
fn an_accuracy_is_advised_that_more_spans_reach() {
    for stroke in [35, 40, 44] {
        let limit = format!("limits.stroke={stroke} mm");
        let fine = designed(&[&limit, "law.family=spline", "law.spans=48"]);
        let best = fine.force.rms_error_percent_of_mean / 100.0;
        let design = designed(&[&limit, "law.family=spline"]);
        let told = advised(&design, "accuracy.rms");
        assert!(told < 1.01 * best, "{stroke}: {told} {best}");
    }
}

/// The suggested torque is at least as large as the torque that some number of spans reaches with the accuracy.
#[test]
fn a_torque_is_advised_that_more_spans_keep() {
    let design = designed(&["law.family=spline", "limits.torque=14 N m"]);
    let told = advised(&design, "limits.torque");
    let at = |spans: usize, torque: f64| {
        let given = format!("law.spans={spans}");
        let limit = format!("limits.torque={torque} N m");
        designed(&["law.family=spline", &given, &limit])
    };
    let passes = |d: &Design| d.verdict != gaitcam::cam::Verdict::Unacceptable;
    for spans in [8, 16] {
        assert!(!passes(&at(spans, 0.98 * told)), "{spans}: {told}");
    }
}

/// Minimum peaks whose optimum is at its bound over arcs, with dwells and points. The first two once caused a panic, the others "no law".
#[test]
fn least_peaks_under_dwells_and_points_have_a_law() {
    let head = |minimise: &str, law: &[String]| {
        format!(
            "name = \"peaks\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"80 rpm\"\nmass = \"2 kg\"\n\
             [cam]\nfollower = \"flat-translating\"\nbase_radius = \"60 mm\"\n\
             [law]\nfamily = \"spline\"\nminimise = \"{minimise}\"\n{}",
            law.concat()
        )
    };
    let dwell = |from: f64, to: f64, lift: f64| {
        format!("[[law.dwell]]\nfrom = \"{from} deg\"\nto = \"{to} deg\"\nlift = \"{lift} mm\"\n")
    };
    let point = |angle: f64, lift: f64, rest: &str| {
        format!("[[law.point]]\nangle = \"{angle} deg\"\nlift = \"{lift} mm\"\n{rest}")
    };
    let at_rest = "velocity = \"0 mm/rad\"\n";
    let scenes = [
        head(
            "peak-snap",
            &[dwell(0.0, 50.0, 0.0), dwell(170.0, 235.0, 15.0)],
        ),
        head(
            "peak-snap",
            &[dwell(10.0, 75.0, 0.0), dwell(190.0, 260.0, 24.0)],
        ),
        head(
            "peak-jerk\"\nspans = \"48",
            &[point(270.0, 20.0, at_rest), dwell(330.0, 360.0, 0.0)],
        ),
        head(
            "peak-jerk\"\ndegree = \"7\"\nspans = \"64",
            &[
                point(0.0, 0.0, ""),
                point(40.0, 13.0, at_rest),
                "[limits]\nstroke = \"22 mm\"\nacceleration = \"25 m/s^2\"\n".to_string(),
            ],
        ),
        head(
            "peak-acceleration\"\nspans = \"200",
            &[
                point(0.0, 0.0, ""),
                point(45.0, 16.0, ""),
                point(75.0, 9.0, ""),
                point(95.0, 21.0, ""),
                "[limits]\nface_width = \"60 mm\"\n".to_string(),
            ],
        ),
    ];
    for text in scenes {
        let scene = scene_of(&text, &[]);
        let design = synthesise(&scene, None).unwrap();
        assert!(design.infeasible.is_none(), "{text}: {:?}", design.reasons);
        let proof = design.solver.certificate.unwrap();
        assert!(proof.violation < 1e-8, "{text}: {proof:?}");
    }
}

/// The smallest cam with a roller on 120 spans is the result of a sequence of convex programs, and is no larger than on 40 spans.
#[test]
fn a_sequence_on_120_spans_ends_at_the_cam_of_40() {
    let radius = |spans: usize| {
        let given = format!("law.spans={spans}");
        let roller = "follower = \"roller-translating\"\nroller_radius = \"10 mm\"";
        let flat = "follower = \"flat-translating\"\nbase_radius = \"20 mm\"";
        let text = super::refusal::relaxations::HUMP.replace(flat, roller);
        let limits = [
            "law.minimise=size",
            "limits.curvature=5 mm",
            "limits.acceleration=2 m/s^2",
        ];
        let scene = scene_of(&text, &[&limits[..], &[&given]].concat());
        let design = synthesise(&scene, None).unwrap();
        assert!(design.infeasible.is_none(), "{spans}: {:?}", design.reasons);
        assert_eq!(design.solver.tier, Tier::Scp, "{spans}");
        design.cam.follower.prime_radius()
    };
    let (few, many) = (radius(40), radius(120));
    assert!(many <= few * (1.0 + 1e-6), "{many} {few}");
}

#[test]
fn more_than_400_spans_are_refused_with_the_reason() {
    let error = gaitcam_test_support::scene(scene::DEFAULT, &["law.spans=401"]).unwrap_err();
    let said = error.to_string();
    assert!(said.contains("400") && said.contains("optimum"), "{said}");
}

/// The law follows a noisy force of one cycle to its noise. Without noise, many spans are used, and the design states the reason.
#[test]
fn noise_is_part_of_the_accuracy_and_many_spans_have_a_reason() {
    let mut force = young();
    let mut state = 7_u64;
    let mut uniform = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    // Uniform numbers of a deviation of 8 N.
    let half = 8.0 * 3.0_f64.sqrt();
    for f in &mut force.force_n {
        *f += half * (2.0 * uniform() - 1.0);
    }
    let scene = scene_of(scene::DEFAULT, &["law.family=spline", "accuracy.rms=auto"]);
    let designed = |noise_n: f64| {
        force.noise_n = Some(noise_n);
        synthesise(&scene, Some(&force)).unwrap()
    };
    let [known, unknown] = [8.0, 0.0].map(designed);
    let has = |design: &Design, code: &str| {
        let notes = design.notes.iter().map(|n| format!("{n:?}"));
        notes.filter(|n| n.starts_with(code)).count()
    };
    assert!(
        known.coefficients.len() < 60,
        "{}",
        known.coefficients.len()
    );
    assert_eq!(
        (has(&known, "SensorNoise"), has(&known, "ManySpans")),
        (1, 0)
    );
    assert!(
        unknown.coefficients.len() > 100,
        "{}",
        unknown.coefficients.len()
    );
    assert_eq!(
        (has(&unknown, "SensorNoise"), has(&unknown, "ManySpans")),
        (0, 1)
    );
    let error = known.checks.iter().find(|c| c.name == Criterion::RmsError);
    assert!(error.unwrap().pass, "{error:?}");
}
