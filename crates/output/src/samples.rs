//! Curves over the cam angle for pictures, and numbers as people write them.

use gaitcam::law::{Law, Svaj};
use gaitcam::synth::Synthesis;

/// Points per turn of a drawn curve: one per two pixels of a wide picture.
const PER_LAW: f64 = 540.0;

/// Angles (rad) with the motion there. Both sides of every break are sampled, so jumps show as jumps.
pub fn motion(law: &Law) -> Vec<(f64, Svaj)> {
    let breaks = law.breaks();
    let (_, length) = law.extent();
    let mut out = Vec::new();
    for (i, w) in breaks.windows(2).enumerate() {
        let steps = ((w[1] - w[0]) / length * PER_LAW).ceil().max(2.0) as usize;
        for k in 0..=steps {
            let u = k as f64 / steps as f64;
            out.push((w[0] + u * (w[1] - w[0]), law.svaj_on(i, u)));
        }
    }
    out
}

/// The unit lift is shown in: factor from SI, and its name.
pub fn lift_unit(synthesis: &Synthesis) -> (f64, &'static str) {
    let unit = synthesis.cam.follower.measures().lift(0);
    (unit.factor, unit.name)
}

/// `x` to `digits` significant digits, without exponent in the usual range, with a true minus sign.
pub fn number(x: f64, digits: i32) -> String {
    if !x.is_finite() {
        return match x {
            f64::INFINITY => "∞".into(),
            f64::NEG_INFINITY => "−∞".into(),
            _ => "—".into(),
        };
    }
    if x == 0.0 {
        return "0".into();
    }
    let power = x.abs().log10().floor() as i32;
    let text = if (-5..9).contains(&power) {
        let decimals = (digits - 1 - power).max(0) as usize;
        let text = format!("{x:.decimals$}");
        if text.trim_start_matches(['-', '0', '.']).is_empty() {
            "0".into()
        } else {
            text
        }
    } else {
        format!("{x:.*e}", (digits - 1).max(0) as usize)
    };
    text.replace('-', "−")
}

/// "low … high"; an end that is zero but for rounding is called so.
pub fn range(low: f64, high: f64, digits: i32) -> String {
    let noise = 1e-9 * (high - low).abs();
    let [low, high] = [low, high].map(|x| number(if x.abs() < noise { 0.0 } else { x }, digits));
    format!("{low} … {high}")
}

/// Degrees to one decimal, in [0, 360] for one turn.
pub fn degrees(theta: f64) -> String {
    format!("{:.1}°", theta.to_degrees() + 0.0).replace('-', "−")
}
