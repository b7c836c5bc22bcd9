//! Console lines about the shaft, the walkers and the floor of a design.

use gaitcam::scene::{ErrorMeasure, Robust};
use gaitcam::synth::Design;
use gaitcam::wording::walker;
use gaitcam_output::simulation;
use serde_json::json;

use super::summary::{filled, row};
use crate::console::language;
use crate::console::words::{self, number};

/// Lines about the shaft: its speed under the motor, the force error over time, and the error with different machine parameters.
pub(super) fn shaft(design: &Design) -> Vec<String> {
    let Some(on_shaft) = &design.shaft else {
        return Vec::new();
    };
    let s = &on_shaft.shaft;
    let mut out = vec![filled(
        "shaft",
        "synth-shaft",
        json!({"low": number(s.min), "high": number(s.max), "ripple": number(100.0 * s.ripple),
                "noload": number(s.no_load_speed), "rms": number(s.motor_torque_rms_n_m),
                "most": number(s.motor_torque_max_n_m)}),
    )];
    if let Some((own, before)) = on_shaft.force_time.zip(on_shaft.at_constant_speed) {
        let percent = [own, before].map(|e| number(e.rms_error_percent_of_mean));
        out.push(filled(
            "",
            "synth-shaft-error",
            json!({"own": percent[0], "before": percent[1], "rounds": on_shaft.rounds}),
        ));
    }
    let differs = design.sensitivity().into_iter().map(|s| {
        let percent = s.percent.map(|p| p.map_or("—".to_string(), number));
        let [less, more] = percent;
        words::fill(
            "synth-shaft-differs",
            &json!({"key": s.key, "less": less, "more": more}),
        )
    });
    let differs: Vec<String> = differs.collect();
    if on_shaft.force_time.is_some() {
        out.push(filled(
            "",
            "synth-shaft-sensitivity",
            json!({"list": differs.join(", ")}),
        ));
    }
    out
}

/// Line about the force errors of the walkers; `None` without a population.
pub(super) fn population(design: &Design) -> Option<String> {
    let p = design.population.as_ref()?;
    let (id, [mean, worst, cvar]) = match design.problem.law.error {
        ErrorMeasure::Relative => (
            "synth-walkers",
            [p.mean_percent, p.worst_percent, p.cvar_percent],
        ),
        ErrorMeasure::Absolute => ("synth-walkers-n", [p.mean_n, p.worst_n, p.cvar_n]),
    };
    let tail = match design.problem.law.robust {
        Robust::Tail(part) if part != 0.9 => number(100.0 * (1.0 - part)),
        Robust::Tail(_) | Robust::Mean | Robust::Worst => "tenth".to_string(),
    };
    Some(filled(
        "walkers",
        id,
        json!({"count": p.walkers, "mean": number(mean), "worst": number(worst), "who": walker(language::current(), &p.worst_walker),
            "cvar": number(cvar), "tail": tail}),
    ))
}

/// Line about the acceleration of the floor under shaker and walkers, and its comfort class; `None` without a floor.
pub(super) fn floor(design: &Design) -> Option<String> {
    let motion = design.floor.as_ref()?;
    Some(row(
        "floor",
        &simulation::floor(motion, language::current()),
    ))
}
