//! Compliant Hunt–Crossley contact with exactly the given restitution.
//!
//! f = K δⁿ (1 + χ δ̇/v₀). Separation of the variables in the phase plane shows that the final speed is e·v₀ if χ(1 + e) = ln[(1 + χ)/(1 − χe)]
//! (theory §10), for all K, n, m and v₀.

/// Number of steps for the time of a compression to the largest depth at the initial speed.
const STEPS_PER_COMPRESSION: f64 = 300.0;
/// Number of compression times after which a contact that has not opened is at rest.
const LONGEST: f64 = 40.0;

/// Hunt–Crossley contact of stiffness K (N/mⁿ) and exponent n.
struct Compliant {
    /// Stiffness K, N/mⁿ.
    stiffness: f64,
    /// Exponent n: 1.5 for a Hertzian point contact, 1 for a linear spring.
    exponent: f64,
    /// Restitution e of an unloaded impact, in (0, 1].
    restitution: f64,
}

impl Compliant {
    /// Speed of a mass (kg) after an impact at `speed` (m/s), m/s; 0 if the contact does not open.
    fn rebound(&self, mass: f64, speed: f64) -> f64 {
        let (n, chi) = (self.exponent, exact_chi(self.restitution));
        let energy = (n + 1.0) * mass * speed * speed;
        let deepest = (energy / (2.0 * self.stiffness)).powf(1.0 / (n + 1.0));
        let time = deepest / speed;
        let step = time / STEPS_PER_COMPRESSION;
        let rate = |d: f64, v: f64| {
            let d = d.max(0.0);
            let elastic = if n == 1.5 { d * d.sqrt() } else { d.powf(n) };
            // A damper in a contact cannot pull.
            -(self.stiffness * elastic * (1.0 + chi * v / speed)).max(0.0) / mass
        };
        let (mut d, mut v, mut t) = (0.0, speed, 0.0);
        while t < LONGEST * time {
            let half = 0.5 * step;
            let (k1d, k1v) = (v, rate(d, v));
            let (k2d, k2v) = (v + half * k1v, rate(d + half * k1d, v + half * k1v));
            let (k3d, k3v) = (v + half * k2v, rate(d + half * k2d, v + half * k2v));
            let (k4d, k4v) = (v + step * k3v, rate(d + step * k3d, v + step * k3v));
            let next_d = d + step / 6.0 * (k1d + 2.0 * (k2d + k3d) + k4d);
            let next_v = v + step / 6.0 * (k1v + 2.0 * (k2v + k3v) + k4v);
            if next_d <= 0.0 && next_v < 0.0 {
                // The force is zero here, so the last part of the step is free motion.
                return -(v + d / (d - next_d) * (next_v - v));
            }
            (d, v) = (next_d, next_v);
            t += step;
        }
        0.0
    }
}

/// Damping factor χ for which a Hunt–Crossley impact has exactly the restitution `e`, for e in (0, 1].
///
/// It is the unique root of ln[(1 + χ)/(1 − χe)] − χ(1 + e) in (0, 1/e). Source: theory §10.
fn exact_chi(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    // With t = χe in (0, 1): near 0 the function is −χ²(1 − e²)/2, and at 1 it tends to infinity.
    let f = |t: f64| (t / e).ln_1p() - (-t).ln_1p() - t * (1.0 + e) / e;
    let (mut low, mut high) = (1e-9 * (1.0 - e), 1.0);
    for _ in 0..200 {
        let t = 0.5 * (low + high);
        if t <= low || t >= high {
            break;
        }
        if f(t) < 0.0 { low = t } else { high = t }
    }
    0.5 * (low + high) / e
}

/// Restitution of a Hunt–Crossley impact with factor χ ≥ 0, from the same equation solved for e.
fn returned_restitution(chi: f64) -> f64 {
    if chi <= 0.0 {
        return 1.0;
    }
    // For e in (0, 1/χ) the function increases from ln(1 + χ) − χ < 0.
    let f = |e: f64| chi.ln_1p() - (-chi * e).ln_1p() - chi * (1.0 + e);
    let (mut low, mut high) = (0.0, (1.0 / chi).min(1.0));
    for _ in 0..200 {
        let e = 0.5 * (low + high);
        if e <= low || e >= high {
            break;
        }
        if f(e) < 0.0 { low = e } else { high = e }
    }
    0.5 * (low + high)
}

#[test]
fn exact_chi_for_one_half_is_1_432751() {
    assert!(
        (exact_chi(0.5) - 1.432751).abs() < 5e-7,
        "{}",
        exact_chi(0.5)
    );
}

#[test]
fn common_damping_formulas_miss_the_restitution_asked_for() {
    // For e = 0.5: Hunt–Crossley 3(1 − e)/2, Lankarani–Nikravesh 3(1 − e²)/4, Flores 8(1 − e)/(5e).
    for (chi, stated) in [(0.75, 0.663), (0.5625, 0.725), (1.6, 0.470)] {
        assert!((returned_restitution(chi) - stated).abs() < 5e-4);
    }
}

#[test]
fn chi_and_restitution_are_inverse_over_the_whole_range() {
    for e in [1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999] {
        let back = returned_restitution(exact_chi(e));
        assert!((back - e).abs() < 1e-9, "{e} {back}");
    }
    assert_eq!(returned_restitution(exact_chi(1.0)), 1.0);
}

#[test]
fn an_integrated_impact_returns_the_prescribed_restitution_to_1e_6() {
    for exponent in [1.0, 1.5, 2.0] {
        for e in [0.1, 0.3, 0.5, 0.8, 1.0] {
            for stiffness in [1e6, 1e10] {
                let contact = Compliant {
                    stiffness,
                    exponent,
                    restitution: e,
                };
                let rebound = contact.rebound(1.3, 0.2);
                assert!((rebound / 0.2 - e).abs() < 1e-6, "{exponent} {e} {rebound}");
            }
        }
    }
}
