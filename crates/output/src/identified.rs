//! Text on the machine parameters that were identified from logs.

use gaitcam::identify::{Identified, Parameter};
use gaitcam::scene::{Scene, keys};
use gaitcam::units::Dimension;
use gaitcam::wording::{Language, number, quantity};

use crate::words;

/// Formats a value of an identified parameter as text with its unit.
fn shown(scene: &Scene, parameter: &Parameter, value: f64, language: Language) -> String {
    let unit = match parameter.key {
        "log.scale" => "",
        "log.delay" => Dimension::Time.si(),
        "guide.damping" => Dimension::Damping.si(),
        key => keys::find(key)
            .and_then(|k| k.dimension(scene))
            .map_or(Dimension::Force.si(), Dimension::si),
    };
    quantity(language, value, unit).trim_end().to_string()
}

/// Note that the log contains no cam angle; `None` if the log contains the angle.
pub fn no_angle(found: &Identified, language: Language) -> Option<String> {
    (!found.has_angle).then(|| words::words(language).text("identify-no-angle"))
}

/// Lines that describe an identification: noise and residual, each parameter with its confidence interval, and the parameters that the
/// logs do not identify. If such parameters exist, a further run that would identify them is suggested.
pub fn lines(scene: &Scene, found: &Identified, language: Language) -> Vec<String> {
    let words = words::words(language);
    let number = |x: f64| number(language, x);
    let speed = |x: f64| quantity(language, x, Dimension::AngularSpeed.si());
    let head = [
        ("name", &*scene.name),
        ("cycles", &found.cycles.to_string()),
        ("speed", &speed(found.speed_rad_per_s)),
        ("noise", &number(found.noise_rms_n)),
        ("repeats", &number(found.repeatable_rms_n)),
    ];
    let mut lines = vec![words.fill("identify-head", &head)];
    if found.logs.len() > 1 {
        lines.extend(found.logs.iter().map(|log| {
            let data = [
                ("name", &*log.name),
                ("cycles", &log.cycles.to_string()),
                ("speed", &speed(log.speed_rad_per_s)),
                ("noise", &number(log.noise_rms_n)),
                ("repeats", &number(log.repeatable_rms_n)),
            ];
            words.fill("identify-head", &data)
        }));
        lines[0] = words.fill("identify-logs", &head);
    }
    for p in &found.parameters {
        let shown = |x: f64| shown(scene, p, x, language);
        let end = |x: Option<f64>, open: &str| x.map_or(open.to_string(), shown);
        let key = if p.identifiable {
            "identify-known"
        } else {
            "identify-unknown"
        };
        let data = [
            ("key", &*format!("{:<26}", p.key)),
            ("value", &shown(p.value)),
            ("low", &end(p.low, "−∞")),
            ("high", &end(p.high, "∞")),
        ];
        lines.push(words.fill(key, &data));
    }
    lines.push(words.text("identify-scale"));
    lines.extend(no_angle(found, language));
    if let Some(run) = &found.next_run {
        let data = [
            ("value", &*speed(run.speed_rad_per_s)),
            ("times", &number(run.relative_speed)),
            ("keys", &run.identifies.join(", ")),
        ];
        lines.push(words.fill("identify-next", &data));
    }
    lines
}
