use super::*;
use crate::sweep::difference::{Difference, differences};

fn plan(vary: &[&str]) -> Plan {
    Plan::of(scene::DEFAULT.parse().unwrap(), vary, Sampling::Grid).unwrap()
}

#[test]
fn the_last_axis_runs_fastest_and_rows_follow_from_their_number() {
    let p = plan(&["law.family=spline,harmonic", "limits.stroke=10 mm:50 mm:5"]);
    assert_eq!(p.rows(), 10);
    let whole = p.batch(0, 10);
    let Column::Numbers(stroke) = &whole.columns[1] else {
        panic!()
    };
    let expected = [0.01, 0.02, 0.03, 0.04, 0.05, 0.01];
    assert!(
        stroke
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-16)
    );
    assert_eq!(stroke[4], 0.05);
    let part = p.batch(5, 2);
    let Column::Words(family) = &part.columns[0] else {
        panic!()
    };
    assert!(family.iter().all(|f| &**f == "harmonic"));
}

#[test]
fn keys_that_cannot_vary_are_named() {
    let fault = |v: &[&str]| plan(v).validate().unwrap_err().to_string();
    assert!(fault(&["name=a,b"]).contains("\"name\" cannot be varied"));
    for name in ["limits.torque,", "gait.phase,", "law.family,"] {
        assert!(fault(&["name=a,b"]).contains(name), "{name}");
    }
    assert!(fault(&["limits.strok=1 mm:2 mm:3"]).contains("did you mean \"stroke\"?"));
    assert!(fault(&["limits=a,b"]).contains("limits"));
    assert!(fault(&["limits.stroke=-1 mm:2 mm:3"]).contains("not positive"));
    assert!(fault(&["law.family=spline,splin"]).contains("did you mean \"spline\"?"));
    assert!(fault(&["law.degree=3,5", "law.degree=5,7"]).contains("twice"));
    // A key is permitted if only one of the varied kinds has it.
    plan(&[
        "drive.kind=moving-axis,fixed-axis",
        "drive.spring_rate=0 N/m:100 N/m:3",
    ])
    .validate()
    .unwrap();
}

#[test]
fn another_grid_is_described_by_what_differs() {
    let (a, b) = (
        plan(&["limits.stroke=1 mm:2 mm:3"]),
        plan(&["limits.stroke=1 mm:3 mm:3"]),
    );
    let lines = differences(&a.description(), &b.description());
    assert_eq!(
        lines,
        [Difference::Value {
            path: "vary limits.stroke".to_string(),
            old: Some("0.001 m:0.002 m:3".to_string()),
            new: Some("0.001 m:0.003 m:3".to_string()),
        }]
    );
    assert!(differences(&a.description(), &a.description()).is_empty());
}
