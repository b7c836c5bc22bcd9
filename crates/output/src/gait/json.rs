//! JSON data of a recording.

use serde_json::{Map, Value, json};

use gaitcam::force::{
    Channel, Cycle, ForceCurve, Interpretation, Note, Point, RecordedStride, Recording, Stance,
    Stances, Walk, coded,
};
use gaitcam::units::G;

/// JSON data of a recording; `cycle` is null without a mean cycle.
///
/// `warnings` contains each note as a code with data, and `notes` contains the notes as sentences. The times of contacts are on the time
/// axis of the file.
pub fn json(
    understood: &Interpretation,
    recording: &Recording,
    stances: &Stances,
    cycle: Option<&Cycle>,
) -> Value {
    let r = recording;
    let channels = r.channels.iter().enumerate();
    let channels: Vec<Value> = channels.map(|(i, c)| channel(i, c, r, stances)).collect();
    let rows: Vec<Value> = stances.used.iter().map(|s| stance(s, r)).collect();
    let strides: Vec<Value> = understood.strides.iter().map(stride).collect();
    let mean = cycle.map(|c| {
        json!({
            "period_s": c.curve.period_s, "period_from": c.period.from,
            "mean_n": c.curve.mean_n(), "averaged": c.averaged,
            "how": c.source.to_string(), "source": coded(&c.source),
            "spread_rms_n": c.curve.spread_rms_n(), "repeatability_n": c.repeatability_n,
            "mean_of_weight": c.mean_of_weight, "mass_fits": c.mass_fits,
        })
    });
    let notes: Vec<String> = understood.warnings.iter().map(Note::to_string).collect();
    let mut out = understood.json();
    let more = json!({
        "format": r.format.to_string(), "rate_hz": r.rate_hz, "duration_s": r.duration_s,
        "notes": notes, "channels": channels, "stances": rows, "strides": strides, "cycle": mean,
        "variability": cycle.and_then(|c| c.curve.walk.as_ref()).map(Walk::variability),
    });
    if let (Value::Object(out), Value::Object(more)) = (&mut out, more) {
        out.extend(more);
    }
    out
}

fn channel(index: usize, c: &Channel, r: &Recording, stances: &Stances) -> Value {
    let used = stances.used.iter().filter(|s| s.channel == index).count();
    let rejected = stances.rejected.iter().filter(|x| x.channel == index);
    let rejected: Vec<Value> = rejected
        .map(|x| json!({"from_s": r.start_s + x.from_s, "to_s": r.start_s + x.to_s, "reason": x.reason}))
        .collect();
    json!({
        "name": c.name, "foot": c.foot, "baseline_n": c.baseline_n,
        "idle": c.idle.as_ref().map(coded), "stances": used, "rejected": rejected,
    })
}

fn stance(s: &Stance, r: &Recording) -> Value {
    let mut row = landmarks(s.landmarks());
    row.extend([
        ("foot".to_string(), json!(s.foot)),
        ("channel".to_string(), json!(s.channel)),
        ("start_s".to_string(), json!(r.start_s + s.start_s)),
        ("end_s".to_string(), json!(r.start_s + s.end_s)),
        ("impulse_n_s".to_string(), json!(s.impulse_ns)),
    ]);
    Value::Object(row)
}

fn stride(s: &RecordedStride) -> Value {
    let mut row = landmarks(s.landmarks);
    row.extend([
        ("foot".to_string(), json!(s.foot)),
        ("start_s".to_string(), json!(s.from_s)),
        ("end_s".to_string(), json!(s.to_s)),
        ("impulse_n_s".to_string(), json!(s.impulse_ns)),
        ("used".to_string(), json!(s.rejected.is_none())),
        ("reason".to_string(), json!(s.rejected)),
    ]);
    Value::Object(row)
}

/// Forces, N, and positions of loading peak, valley and push-off peak.
fn landmarks(points: [Option<Point>; 3]) -> Map<String, Value> {
    let names = ["p1", "valley", "p2"].into_iter().zip(points);
    let two = |(name, point): (&str, Option<Point>)| {
        [
            (format!("{name}_n"), json!(point.map(|p| p.force_n))),
            (format!("{name}_at"), json!(point.map(|p| p.at))),
        ]
    };
    names.flat_map(two).collect()
}

/// JSON data of a file that contains exactly one cycle. The keys are those of [`json()`].
pub fn cycle_json(curve: &ForceCurve) -> Value {
    let notes: Vec<String> = curve.notes.iter().map(Note::to_string).collect();
    json!({
        "format": "one cycle", "rate_hz": curve.force_n.len() as f64 / curve.period_s,
        "duration_s": curve.period_s, "mass_kg": curve.mass_kg, "mass_from": "file",
        "mass_low_kg": null, "mass_high_kg": null,
        "kind": null, "period_s": curve.period_s, "period_from": "file", "contacts": [], "doubts": [],
        "notes": notes, "warnings": [], "channels": [], "stances": [], "strides": [], "variability": null,
        "cycle": {
            "period_s": curve.period_s, "period_from": "file", "mean_n": curve.mean_n(), "averaged": 1,
            "source": {"code": "as-given", "data": {}}, "spread_rms_n": curve.spread_rms_n(),
            "repeatability_n": null,
            "mean_of_weight": curve.mass_kg.map(|m| curve.mean_n() / (m * G)),
        },
    })
}
