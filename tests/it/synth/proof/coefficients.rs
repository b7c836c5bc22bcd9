//! The coefficients of a design describe its law. They are evaluated by the recursion of the textbooks.

use std::f64::consts::TAU;

use gaitcam::scene;
use gaitcam::synth::{Design, Functions};

fn designed(changes: &[&str], more: &str) -> Design {
    let text = format!("{}\n{more}", scene::DEFAULT);
    gaitcam_test_support::design(&text, changes).unwrap()
}

/// B-spline of degree p that begins at knot i, by the recursion of Cox and de Boor.
fn b_spline(knot: &dyn Fn(usize) -> f64, i: usize, p: usize, x: f64) -> f64 {
    if p == 0 {
        return f64::from(u8::from(knot(i) <= x && x < knot(i + 1)));
    }
    let part = |from: f64, to: f64, at: f64, next: usize| {
        let width = to - from;
        if width > 0.0 {
            at / width * b_spline(knot, next, p - 1, x)
        } else {
            0.0
        }
    };
    let [a, b, c, d] = [i, i + p, i + 1, i + p + 1].map(knot);
    part(a, b, x - a, i) + part(c, d, d - x, i + 1)
}

fn lift(design: &Design, theta: f64) -> f64 {
    let c = &design.coefficients;
    match &design.functions {
        Functions::BSpline { knots } => {
            let n = knots.len();
            let knot = |i: usize| knots[i % n] + TAU * (i / n) as f64;
            // θ and θ + 2π: a function that runs over the end of the turn is met once more behind it.
            let terms = (0..n).map(|i| {
                let once = b_spline(&knot, i, design.degree, theta);
                c[i] * (once + b_spline(&knot, i, design.degree, theta + TAU))
            });
            terms.sum()
        }
        Functions::Fourier => {
            let pairs = c[1..].chunks_exact(2).zip(1..);
            let waves = pairs.map(|(ab, n)| {
                let (sin, cos) = (f64::from(n) * theta).sin_cos();
                ab[0] * cos + ab[1] * sin
            });
            c[0] + waves.sum::<f64>()
        }
        other => panic!("{other:?} is not asked for here"),
    }
}

/// All methods: closed form, harmonics with a limit, least squares, limits, a given base circle, size as a variable, a dwell.
#[test]
fn coefficients_evaluate_to_the_law_in_every_tier() {
    let open = "accuracy.rms=none";
    let spline = "law.family=spline";
    let cases: [&[&str]; 7] = [
        &[open],
        &[open, "law.family=harmonic", "limits.acceleration=3 m/s^2"],
        &[open, spline, "law.spans=12"],
        &[open, spline, "law.spans=17", "limits.jerk=40 m/s^3"],
        &[open, spline, "law.spans=16", "limits.stroke=40 mm"],
        &[
            open,
            spline,
            "law.spans=12",
            "cam.base_radius=30 mm",
            "limits.curvature=70 mm",
        ],
        &[open, spline, "law.spans=12", "limits.prime_radius=50 mm"],
    ];
    let dwelling = [open, spline, "law.spans=12"];
    let with_dwell = "[[law.dwell]]\nfrom = \"20 deg\"\nto = \"60 deg\"\n";
    let all = cases.into_iter().map(|case| (case, ""));
    for (case, more) in all.chain([(&dwelling[..], with_dwell)]) {
        let design = designed(case, more);
        let law = &design.cam.law;
        for k in 0..200 {
            let theta = TAU * (f64::from(k) + 0.37) / 200.0;
            let (own, told) = (law.svaj(theta).s, lift(&design, theta));
            assert!(
                (own - told).abs() < 1e-12 * law.stroke(),
                "{case:?} at {theta}: {told} for {own}"
            );
        }
    }
}
