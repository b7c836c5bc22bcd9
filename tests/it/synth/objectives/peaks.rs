//! Minimum peaks that were once slow, unproved or rejected. Each is certified, and no law with fewer spans in the same space is better.

use gaitcam::synth::Design;

fn design(text: &str) -> Design {
    gaitcam_test_support::design(text, &[] as &[&str]).unwrap()
}

/// Scene of a law through points with a follower that presses by its mass only.
fn light(speed: f64, law: &str, limits: &str, points: &[(f64, f64, bool)]) -> String {
    let mut out = format!(
        "name = \"peak\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"{speed} rad/s\"\nmass = \"2 kg\"\n[cam]\nfollower = \"flat-translating\"\n[limits]\n{limits}\n[law]\nfamily = \"spline\"\n{law}\n"
    );
    for (angle, lift, level) in points {
        let rest = if *level {
            "velocity = \"0 mm/rad\"\n"
        } else {
            ""
        };
        out += &format!("[[law.point]]\nangle = \"{angle} deg\"\nlift = \"{lift} mm\"\n{rest}");
    }
    out
}

const DWELL: &str = "[[law.dwell]]\nfrom = \"280 deg\"\nto = \"360 deg\"\nlift = \"0 mm\"\n";

/// Scene with `spans` spans.
fn with_spans(text: &str, spans: usize) -> String {
    text.replace("SPANS", &spans.to_string())
}

fn peak(design: &Design, order: usize) -> f64 {
    let (low, high) = design.cam.derivative_extremes(order);
    high.value.max(-low.value)
}

/// Scenes, the order of the derivative whose peak is minimised, and the numbers of spans.
fn scenes() -> [(String, usize, [usize; 4]); 3] {
    let points = [
        (75.0, 24.459, false),
        (185.0, 23.616, false),
        (250.0, 16.293, true),
    ];
    let jerk = light(
        5.578,
        "degree = 7\nspans = SPANS\nminimise = \"peak-jerk\"",
        "acceleration = \"22.2733 m/s^2\"",
        &points,
    ) + DWELL;
    let steep = [
        (0.0, 0.0, false),
        (40.0, 16.921, false),
        (70.0, 8.723, false),
        (90.0, 21.753, false),
    ];
    let acceleration = light(
        2.467,
        "degree = 5\nspans = SPANS\nminimise = \"peak-acceleration\"",
        "face_width = \"59.98 mm\"",
        &steep,
    );
    let range = [(0.0, 0.0, false), (35.0, 14.08, true)];
    let stroke = light(
        9.154,
        "degree = 7\nspans = SPANS\nminimise = \"peak-jerk\"",
        "stroke = \"24.526 mm\"\nacceleration = \"28.7226 m/s^2\"",
        &range,
    );
    [
        (jerk, 3, [25, 50, 100, 200]),
        (acceleration, 2, [25, 50, 100, 200]),
        (stroke, 3, [8, 16, 32, 64]),
    ]
}

#[test]
fn least_peaks_are_certified_on_four_to_two_hundred_spans_and_finer_splines_lower_them() {
    for (text, order, spans) in scenes() {
        // Twice the spans contain every law of the half.
        let mut before = f64::INFINITY;
        for spans in spans {
            let design = design(&with_spans(&text, spans));
            if design.infeasible.is_some() {
                assert_eq!(
                    before,
                    f64::INFINITY,
                    "{spans}: refused, and half of it was not"
                );
                continue;
            }
            assert!(
                design.solver.certified,
                "{order} {spans}: {:?}",
                design.solver
            );
            let own = peak(&design, order);
            assert!(
                own <= before * (1.0 + 1e-6),
                "{order} {spans}: {own} {before}"
            );
            before = own;
        }
        assert!(before < f64::INFINITY);
    }
}

#[test]
fn least_peak_errors_of_the_force_are_certified_under_limits() {
    let gait = |model: &str, hertz: f64, more: &str| {
        format!(
            "name = \"peak\"\n[gait]\nmodel = \"{model}\"\nstep_frequency = \"{hertz} Hz\"\nbody_weight = \"700 N\"\nfeet = \"both\"\n{more}[cam]\nfollower = \"flat-translating\"\n"
        )
    };
    let axis = "scale = \"to-mass\"\n[drive]\nkind = \"moving-axis\"\nmass = \"2 kg\"\n";
    let oil = "[drive]\nkind = \"hydraulic\"\npressure_per_volume = \"0.04944 MPa/cm^3\"\npiston_radius = \"18.67 mm\"\n";
    let law = "[law]\nfamily = \"spline\"\nminimise = \"peak-force-error\"\n";
    for (scene, limits, size) in [
        (
            gait("young", 2.185, axis),
            "force_min = \"15.501 N\"",
            "degree = 7\nspans = 8",
        ),
        (
            gait("young-design", 1.597, axis),
            "stroke = \"24.155 mm\"",
            "degree = 6\nspans = 48",
        ),
        (
            gait("setra", 1.6, oil),
            "velocity = \"1.0547 m/s\"",
            "degree = 5\nspans = 12",
        ),
    ] {
        let design = design(&format!("{scene}[limits]\n{limits}\n{law}{size}\n"));
        assert!(design.solver.certified, "{limits}: {:?}", design.solver);
        // What is minimised is what is stated.
        let certificate = design.solver.certificate.unwrap();
        let apart = (certificate.size - design.force.max_error_n).abs();
        assert!(apart < 1e-6 * certificate.size, "{limits}: {certificate:?}");
    }
}

/// A lower force limit above the minimum of the target determines the largest error. No accuracy makes it smaller than the limit minus this minimum,
/// and an accuracy slightly below that of the minimum peak still reaches it.
#[test]
fn a_least_peak_that_another_limit_holds_up_is_found_at_every_accuracy() {
    let scene = |spans: usize, floor: f64, minimise: &str, rms: &str| {
        design(&format!(
            "name = \"held\"\n[gait]\nmodel = \"young\"\nstep_frequency = \"2.185 Hz\"\nbody_weight = \"700 N\"\nfeet = \"both\"\nscale = \"to-mass\"\n[drive]\nkind = \"moving-axis\"\nmass = \"2 kg\"\nspeed = \"auto\"\n[cam]\nfollower = \"flat-translating\"\nbase_radius = \"60 mm\"\n[limits]\nforce_min = \"{floor} N\"\n[accuracy]\nrms = \"{rms}\"\n[law]\nfamily = \"spline\"\ndegree = 7\nspans = {spans}\nminimise = \"{minimise}\"\n"
        ))
    };
    for (spans, floor) in [(8, 15.501), (12, 15.0), (16, 14.0), (32, 15.501)] {
        let error = |d: &Design| d.force.rms_error_n / d.force.target_mean_n;
        let free = scene(spans, floor, "peak-force-error", "none");
        let nearest = scene(spans, floor, "force-error", "none");
        let [least, _] = free.problem.target.as_ref().unwrap().range_n();
        let mut before = f64::INFINITY;
        for part in [0.02, 0.3, 0.7, 0.98] {
            let rms = error(&nearest) + part * (error(&free) - error(&nearest));
            let design = scene(
                spans,
                floor,
                "peak-force-error",
                &format!("{} %", 100.0 * rms),
            );
            assert!(
                design.solver.certified,
                "{spans} {part}: {:?}",
                design.solver
            );
            assert!(error(&design) <= rms * (1.0 + 1e-8), "{spans} {part}");
            let off = design.force.max_error_n - (floor - least);
            assert!(
                off > -1e-6 * floor && off < before + 1e-6 * floor,
                "{spans} {part}: {off}"
            );
            before = off;
        }
        assert!(before < 1e-6 * floor, "{spans}: {before}");
    }
}
