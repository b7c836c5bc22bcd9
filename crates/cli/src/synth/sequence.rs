//! `synth --verbose`: the sequence of convex programs, step by step.

use gaitcam::synth::Synthesis;

use crate::language;

/// One line per step.
pub fn text(design: &Synthesis) -> String {
    let solver = &design.solver;
    if solver.steps.is_empty() {
        return "  sequence  none: one convex program or less was sufficient".to_string();
    }
    let mut out = vec![
        format!("  sequence  {} convex programs", solver.steps.len()),
        "  step   prime radius          objective   relative clearance   step length".to_string(),
    ];
    for (i, step) in solver.steps.iter().enumerate() {
        out.push(format!(
            "  {:>4} {:>11.6} mm {:>18.10e} {:>20.3e} {:>13.4}",
            i + 1,
            1e3 * step.prime_radius,
            step.merit,
            step.clearance,
            step.taken
        ));
    }
    if let Some(ended) = solver.ended() {
        out.push(format!(
            "  stopped: {}",
            ended.sentence(language::current())
        ));
    }
    out.join("\n")
}
