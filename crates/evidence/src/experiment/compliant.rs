//! A compliant Hunt–Crossley contact that returns a prescribed restitution exactly.
//!
//! f = K δⁿ (1 + χ δ̇/v₀). Separating the variables in the phase plane, the speed returned is e·v₀ when
//! χ(1 + e) = ln[(1 + χ)/(1 − χe)] (theory §10), whatever K, n, m and v₀.

/// Steps over the time that a compression to the largest depth would take at the first speed.
const STEPS_PER_COMPRESSION: f64 = 300.0;
/// Compression times after which a contact that has not opened is at rest.
const LONGEST: f64 = 40.0;

/// Hunt–Crossley contact of stiffness K (N/mⁿ) and exponent n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compliant {
    /// K, N/mⁿ.
    pub stiffness: f64,
    /// n: 1.5 for a Hertzian point, 1 for a linear spring.
    pub exponent: f64,
    /// Restitution e of an unloaded impact, in (0, 1].
    pub restitution: f64,
}

/// What one impact does.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pulse {
    /// Speed at which the surfaces part, m/s; 0 when they stay together.
    pub rebound: f64,
    /// Largest force, N.
    pub peak_force: f64,
    /// Time in contact, s.
    pub duration: f64,
    /// Largest depth, m.
    pub depth: f64,
    /// Impulse handed over, N·s.
    pub impulse: f64,
}

impl Compliant {
    /// The impact of a mass (kg) at `speed` (m/s, positive) under a steady load (N, pressing positive).
    pub fn pulse(&self, mass: f64, speed: f64, load: f64) -> Pulse {
        let chi = exact_chi(self.restitution);
        compliant(mass, speed, load, self.stiffness, self.exponent, chi)
    }
}

/// The damping factor χ with which a Hunt–Crossley impact returns restitution `e` exactly, e in (0, 1].
///
/// Root of ln[(1 + χ)/(1 − χe)] − χ(1 + e) in (0, 1/e); unique there. Source: theory §10.
pub fn exact_chi(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    // In t = χe ∈ (0, 1): near 0 the function falls as −χ²(1 − e²)/2, at 1 it rises without bound.
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

/// The restitution that a Hunt–Crossley impact of factor χ ≥ 0 returns: the same equation solved for e.
pub fn returned_restitution(chi: f64) -> f64 {
    if chi <= 0.0 {
        return 1.0;
    }
    // In e ∈ (0, 1/χ): falls from ln(1+χ) − χ < 0 … the function below rises with e.
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

fn compliant(mass: f64, speed: f64, load: f64, stiffness: f64, exponent: f64, chi: f64) -> Pulse {
    let deepest =
        ((exponent + 1.0) * mass * speed * speed / (2.0 * stiffness)).powf(1.0 / (exponent + 1.0));
    // Under a load that outweighs the impact the time scale is the load's.
    let pressed = (load.max(0.0) / stiffness).powf(1.0 / exponent);
    let time = deepest / speed
        + (pressed * mass / load.max(f64::MIN_POSITIVE))
            .sqrt()
            .min(deepest / speed);
    let step = time / STEPS_PER_COMPRESSION;
    let force = |d: f64, v: f64| {
        let d = d.max(0.0);
        let elastic = if exponent == 1.5 {
            d * d.sqrt()
        } else {
            d.powf(exponent)
        };
        // A dashpot cannot pull.
        (stiffness * elastic * (1.0 + chi * v / speed)).max(0.0)
    };
    let rate = |d: f64, v: f64| (load - force(d, v)) / mass;
    let (mut d, mut v, mut t) = (0.0, speed, 0.0);
    let mut pulse = Pulse::default();
    while t < LONGEST * time {
        let (k1d, k1v) = (v, rate(d, v));
        let (k2d, k2v) = (
            v + 0.5 * step * k1v,
            rate(d + 0.5 * step * k1d, v + 0.5 * step * k1v),
        );
        let (k3d, k3v) = (
            v + 0.5 * step * k2v,
            rate(d + 0.5 * step * k2d, v + 0.5 * step * k2v),
        );
        let (k4d, k4v) = (v + step * k3v, rate(d + step * k3d, v + step * k3v));
        let next_d = d + step / 6.0 * (k1d + 2.0 * (k2d + k3d) + k4d);
        let next_v = v + step / 6.0 * (k1v + 2.0 * (k2v + k3v) + k4v);
        if next_d <= 0.0 && next_v < 0.0 {
            // The force has faded to nothing here: the last part of a step is free motion.
            let part = d / (d - next_d);
            v += part * (next_v - v);
            pulse.rebound = (-v).max(0.0);
            pulse.duration = t + part * step;
            pulse.impulse = mass * (speed - v) + load * pulse.duration;
            return pulse;
        }
        (d, v) = (next_d, next_v);
        t += step;
        pulse.peak_force = pulse.peak_force.max(force(d, v));
        pulse.depth = pulse.depth.max(d);
    }
    pulse.duration = t;
    pulse.impulse = mass * speed + load * t;
    pulse
}

#[cfg(test)]
mod tests {
    use super::*;

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
        // Hunt–Crossley 3(1 − e)/2, Lankarani–Nikravesh 3(1 − e²)/4, Flores 8(1 − e)/(5e), asked for e = 0.5.
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
                    let pulse = contact.pulse(1.3, 0.2, 0.0);
                    assert!(
                        (pulse.rebound / 0.2 - e).abs() < 1e-6,
                        "{exponent} {e} {}",
                        pulse.rebound
                    );
                    assert!((pulse.impulse - 1.3 * 0.2 * (1.0 + e)).abs() < 1e-6);
                }
            }
        }
    }

    #[test]
    fn an_elastic_linear_impact_is_half_a_sine() {
        let contact = Compliant {
            stiffness: 4e6,
            exponent: 1.0,
            restitution: 1.0,
        };
        let pulse = contact.pulse(1.0, 0.5, 0.0);
        assert!((pulse.peak_force - 0.5 * 2000.0).abs() < 0.1);
        assert!((pulse.duration - std::f64::consts::PI / 2000.0).abs() < 1e-8);
    }

    #[test]
    fn a_heavy_load_keeps_a_soft_touch_closed() {
        let contact = Compliant {
            stiffness: 1e6,
            exponent: 1.5,
            restitution: 0.3,
        };
        assert_eq!(contact.pulse(1.0, 1e-4, 50.0).rebound, 0.0);
    }
}
