//! Residual vibration in dwells compared with a time integration of the follower.

use gaitcam::criterion::LimitKind;
use gaitcam::error::SceneError;
use gaitcam::law::Law;
use gaitcam::scene::Scene;
use gaitcam::synth::Design;
use std::f64::consts::TAU;

/// Fixed axis with a compliant follower.
#[derive(Debug, Clone, Copy)]
struct Machine {
    /// Speed of the cam, rad/s.
    speed: f64,
    mass: f64,
    /// Return spring, and damper parallel to it.
    spring: f64,
    damping: f64,
    /// Natural frequency of the train, Hz, and its damping ratio.
    hertz: f64,
    ratio: f64,
}

impl Machine {
    /// Machine by its number: with and without return spring, natural frequencies of 4 to 14 times the shaft frequency.
    fn numbered(i: usize) -> Machine {
        let part = |k: usize| ((i * k) % 17) as f64 / 17.0;
        let speed = 10.0 + 20.0 * part(3);
        let hertz = (4.0 + 10.0 * part(5)) * speed / TAU;
        let train = (TAU * hertz).powi(2);
        let spring = if i.is_multiple_of(4) {
            0.0
        } else {
            1.5 * part(7) * train
        };
        let damping = if i.is_multiple_of(3) {
            0.0
        } else {
            0.05 * train.sqrt() * part(11)
        };
        Machine {
            speed,
            mass: 1.0,
            spring,
            damping,
            hertz,
            ratio: 0.03 + 0.1 * part(13),
        }
    }

    fn scene(&self, second: bool, limit: Option<f64>) -> String {
        let Machine {
            speed,
            mass,
            spring,
            damping,
            hertz,
            ratio,
        } = self;
        let other = if second {
            "[[law.dwell]]\nfrom = \"100 deg\"\nto = \"150 deg\"\nlift = \"12 mm\"\n"
        } else {
            "[[law.point]]\nangle = \"120 deg\"\nlift = \"15 mm\"\n"
        };
        let limits = limit.map_or(String::new(), |r| {
            format!("[limits]\nresidual = \"{r} m\"\n")
        });
        format!(
            "name = \"r\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"{speed} rad/s\"\nmass = \"{mass} kg\"\nspring_rate = \"{spring} N/m\"\ndamping = \"{damping} N s/m\"\npreload = \"400 N\"\n[machine]\nnatural_frequency = \"{hertz} Hz\"\ndamping_ratio = {ratio}\n[law]\nfamily = \"spline\"\nspans = 24\nminimise = \"jerk\"\n[[law.dwell]]\nfrom = \"240 deg\"\nto = \"360 deg\"\nlift = \"0 mm\"\n{other}[cam]\nfollower = \"flat-translating\"\nbase_radius = \"200 mm\"\n{limits}"
        )
    }

    /// Maximum amplitude at the start of a dwell, and maximum deviation from the static deflection in it, by the Runge-Kutta method over enough turns
    /// for the damping.
    fn swing(&self, law: &Law, rests: &[(f64, f64)]) -> [f64; 2] {
        let train = self.mass * (TAU * self.hertz).powi(2);
        let (k, c) = (
            train + self.spring,
            self.damping + 2.0 * self.ratio * (train * self.mass).sqrt(),
        );
        let force = |theta: f64| {
            let at = law.svaj(theta.rem_euclid(TAU));
            let w = self.speed;
            400.0 + self.spring * at.s + self.damping * w * at.v + self.mass * w * w * at.a
        };
        let steps = 21_600_usize;
        let h = TAU / steps as f64;
        let w = self.speed;
        let rate = |theta: f64, [x, v]: [f64; 2]| {
            [v / w, -(force(theta) + c * v + k * x) / (self.mass * w)]
        };
        let mut z = [-force(0.0) / k, 0.0];
        let fading = c / (2.0 * self.mass * w) * TAU;
        let turns = (30.0 / fading).ceil() as usize + 1;
        let mut out = [0.0_f64; 2];
        let inside = |t: f64| rests.iter().any(|r| t > r.0 - 0.5 * h && t < r.1);
        for turn in 0..turns {
            for i in 0..steps {
                let t = h * i as f64;
                if turn + 1 == turns && inside(t) {
                    let away = z[0] + force(t) / k;
                    out[1] = out[1].max(away.abs());
                    if rests.iter().any(|r| (t - r.0).abs() < 0.5 * h) {
                        out[0] = out[0].max(away.hypot(z[1] / (k / self.mass).sqrt()));
                    }
                }
                // The law's pieces end at angles that steps do not know: none of the force's values jumps there.
                let add = |z: [f64; 2], d: [f64; 2], f: f64| [z[0] + f * d[0], z[1] + f * d[1]];
                let a = rate(t, z);
                let b = rate(t + 0.5 * h, add(z, a, 0.5 * h));
                let c = rate(t + 0.5 * h, add(z, b, 0.5 * h));
                let d = rate(t + h, add(z, c, h));
                for j in 0..2 {
                    z[j] += h / 6.0 * (a[j] + 2.0 * b[j] + 2.0 * c[j] + d[j]);
                }
            }
        }
        out
    }
}

fn rests(second: bool) -> Vec<(f64, f64)> {
    let degrees = |a: f64, b: f64| (a.to_radians(), b.to_radians());
    let last = degrees(240.0, 360.0);
    if second {
        vec![degrees(100.0, 150.0), last]
    } else {
        vec![last]
    }
}

fn residual(design: &Design) -> f64 {
    let own = design.checks.iter().find(|c| c.name == LimitKind::Residual);
    own.unwrap().worst
}

fn energy(law: &Law) -> f64 {
    let jerk = law.combination([0.0, 0.0, 0.0, 1.0], 0.0);
    jerk.integral_of_square()
}

#[test]
fn the_limit_on_residual_vibration_is_of_the_follower_that_vibrates() {
    let mut active = 0;
    for i in 0..12 {
        let machine = Machine::numbered(i);
        let second = i % 2 == 1;
        let made = |limit: f64| {
            let text = machine.scene(second, Some(limit));
            gaitcam_test_support::design(&text, &[] as &[&str]).unwrap()
        };
        let free = made(1.0);
        let swung = machine.swing(&free.cam.law, &rests(second));
        let left = residual(&free);
        assert!(
            (left - swung[0]).abs() < 1e-5 * left + 1e-9,
            "{i}: {left:e} {swung:?}"
        );
        assert!(swung[1] <= left * (1.0 + 1e-5) + 1e-9);
        let mut last = energy(&free.cam.law);
        for part in [0.3, 0.02, 1e-4] {
            let limit = part * left;
            let design = made(limit);
            assert!(design.solver.certified, "{i} {part}: {:?}", design.solver);
            let (left, swung) = (
                residual(&design),
                machine.swing(&design.cam.law, &rests(second)),
            );
            assert!(
                left <= limit * (1.0 + 1e-6),
                "{i} {part}: {left:e} {limit:e}"
            );
            assert!(
                (left - swung[0]).abs() < 1e-4 * left + 2e-9,
                "{i}: {left:e} {swung:?}"
            );
            // No more is given up than the limit asks for: it is reached, and a tighter one costs more.
            assert!(
                left > limit * (1.0 - 1e-6),
                "{i} {part}: {left:e} {limit:e}"
            );
            let own = energy(&design.cam.law);
            assert!(own >= last * (1.0 - 1e-9), "{i} {part}");
            last = own;
            active += 1;
        }
    }
    assert_eq!(active, 36);
}

#[test]
fn a_limit_on_vibration_without_a_dwell_is_said_to_have_no_effect() {
    let text = Machine::numbered(1).scene(false, Some(1e-6));
    let scene = gaitcam_test_support::scene(&text, &[] as &[&str]).unwrap();
    assert!(scene.notes().is_empty());
    let mut without: Scene = scene;
    without.law.dwells.clear();
    let [SceneError::NoEffect { key, why, .. }] = &without.notes()[..] else {
        panic!("{:?}", without.notes());
    };
    assert_eq!((key.as_str(), *why), ("limits.residual", "no-dwell"));
}
