//! What `gaitcam gait` says of a recording.

use gaitcam::force::{Feet, Interpretation, ReadOptions, cycle, read, stances};
use gaitcam::wording::Language;
use gaitcam_output::gait::{json, table};

/// Two force plates, 10.5 s of walking.
const WALK: &[u8] = include_bytes!("../../../../data/recordings/made_walk.csv");

#[test]
fn json_has_the_promised_keys_and_the_table_the_same_numbers() {
    let r = read("walk.csv".as_ref(), WALK, &ReadOptions::default()).unwrap();
    let s = stances(&r);
    let c = cycle(&r, &s, Feet::Both).unwrap();
    let understood = Interpretation::of("walk.csv", &r, &s, Some(&c), Feet::Both);
    let v = json(&understood, &r, &s, Some(&c));
    for key in [
        "format",
        "rate_hz",
        "duration_s",
        "mass_kg",
        "channels",
        "stances",
        "cycle",
        "warnings",
        "kind",
        "period_s",
        "period_from",
        "mass_from",
        "contacts",
        "doubts",
    ] {
        assert!(v.get(key).is_some(), "{key}");
    }
    for key in ["name", "foot", "baseline_n", "stances", "rejected"] {
        assert!(v["channels"][0].get(key).is_some(), "{key}");
    }
    for key in [
        "foot",
        "start_s",
        "end_s",
        "p1_n",
        "p1_at",
        "valley_n",
        "valley_at",
        "p2_n",
        "p2_at",
    ] {
        assert!(v["stances"][0].get(key).is_some(), "{key}");
    }
    for key in ["from_s", "to_s", "reason"] {
        assert!(v["channels"][1]["rejected"][0].get(key).is_some(), "{key}");
    }
    assert_eq!(v["cycle"]["period_s"], c.curve.period_s);
    assert_eq!(v["cycle"]["mean_n"], c.curve.mean_n());
    assert_eq!(v["stances"].as_array().unwrap().len(), s.used.len());
    let t = table(&understood, &r, &s, Ok(&c), Language::En);
    for part in [
        "100.00 Hz",
        "Right Fz",
        &format!("{:.4} s", c.curve.period_s),
    ] {
        assert!(t.contains(part), "{part} is not in\n{t}");
    }
    let refused = Interpretation::of("walk.csv", &r, &s, None, Feet::Both);
    assert!(table(&refused, &r, &s, Err("none"), Language::En).ends_with(": none\n"));
}
