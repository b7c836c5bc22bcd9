//! The report is one page with its figures and its motion.

use gaitcam_output::Language;
use serde_json::Value;

use crate::TIME;
use gaitcam_test_support::designs::{footbridge, heel_tester, impossible};
use gaitcam_test_support::readers::elements;

#[test]
fn report_is_one_file_that_asks_nothing_of_the_network() {
    for s in [footbridge(), heel_tester()] {
        let html = gaitcam_output::report::html(&s, TIME, Language::En);
        let stroke_mm = 1000.0 * s.cam.law.stroke();
        let all = elements(&html);
        // Animation, force, law, cam, curvature.
        assert_eq!(all.iter().filter(|e| *e == "svg").count(), 5);
        let asks = html.replace("http://www.w3.org/2000/svg", "");
        for word in ["http:", "https:", "src=", "href=", "@import", "url("] {
            assert!(!asks.contains(word), "{word}");
        }
        for word in ["Checks", "Active limits", "Solution", "<main>"] {
            assert!(html.contains(word), "{word}");
        }
        // The walker's own variation stands beside the error where it is known.
        assert_eq!(
            html.contains("Step-to-step"),
            s.target().unwrap().spread_n.is_some()
        );
        let data = html.split("id=\"motion\">").nth(1).unwrap();
        let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
        let lift = data["s"].as_array().unwrap();
        let stroke = lift.iter().map(|x| x.as_f64().unwrap()).fold(0.0, f64::max);
        assert!((stroke - stroke_mm).abs() < 0.01);
    }
}

#[test]
fn the_report_of_an_impossible_cam_says_why_and_shows_none() {
    let html = gaitcam_output::report::html(&impossible(), TIME, Language::En);
    let all = elements(&html);
    assert!(!all.contains(&"svg".to_string()) && !all.contains(&"script".to_string()));
    assert!(html.contains("footbridge &lt;stroke &amp; limit&gt;"));
    assert!(html.contains("Conflicting limits"));
    assert!(html.contains("from 30 mm to <strong>48."));
}

#[test]
fn the_report_of_a_run_moves_the_follower_as_it_ran() {
    use gaitcam::drive::Drive;
    use gaitcam::dynamics::{Machine, Model, Run, simulate};
    use gaitcam_output::report::{Running, html_of_run};
    // Far above lift-off: the follower flies for a part of every turn.
    let own = footbridge();
    let drive = Drive {
        speed: 2.2 * own.problem.drive.speed,
        ..own.problem.drive
    };
    let target = own.target().cloned();
    let s = own.moved_to(drive, target);
    let run = Run {
        profile: s.cam.profile(720),
        cam: s.cam.clone(),
        drive: s.problem.drive,
        target: None,
        machine: Machine {
            restitution: 0.3,
            ..Machine::default()
        },
    };
    let outcome = simulate(&run, Model::Contact).unwrap();
    assert!(outcome.contact_lost);
    let running = Running {
        outcome: &outcome,
        second_cam: None,
    };
    let html = html_of_run(&s, TIME, &running, Language::En);
    let all = elements(&html);
    // The run in motion and its diagrams beside force, law, cam, curvature.
    assert_eq!(all.iter().filter(|e| *e == "svg").count(), 6);
    assert!(html.contains("Simulation") && html.contains("Impacts"));
    assert!(!html.contains("NaN"));
    let data = html.split("id=\"motion\">").nth(1).unwrap();
    let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
    let turns = data["turns"].as_u64().unwrap() as usize;
    assert_eq!(turns, outcome.period_turns.min(4));
    let list = |list: &Value| list.as_array().unwrap().clone();
    let gap = list(&data["readings"]["gap"]);
    let (contact, force) = (list(&data["cx"]), list(&data["f"]));
    assert_eq!(gap.len(), 480 * turns + 1);
    let flying = gap.iter().filter(|g| g.as_f64().unwrap() > 1e-3).count();
    assert!(flying > 20);
    for ((g, c), f) in gap.iter().zip(&contact).zip(&force) {
        // In the air there is no contact point, and no force but within a row of take-off or landing.
        assert_eq!(c.is_null(), g.as_f64().unwrap() > 0.0 || c.is_null());
        if g.as_f64().unwrap() > 0.5 {
            assert_eq!(f.as_f64().unwrap(), 0.0);
        }
    }
    // Steps and rows coincide here: 1.5 rows to a step, so every second step is a row.
    for k in 0..240 {
        let row = &outcome.rows[3 * k];
        let shown = force[2 * k].as_f64().unwrap();
        if row.gap == 0.0 {
            assert!((shown - row.contact_force).abs() < 1e-6, "{k}");
        }
    }
}

#[test]
fn load_factors_have_whole_harmonics_and_no_phase_where_they_are_zero() {
    let html = gaitcam_output::report::html(&footbridge(), TIME, Language::Es);
    let table = html.split("Factores de carga dinámica").nth(1).unwrap();
    let table = table.split("</table>").next().unwrap();
    assert!(
        table.contains(">1<") && table.contains("0,3700 ∠ 0,0°"),
        "{table}"
    );
    assert!(
        table.contains(">0,0000<") && !table.contains("e−"),
        "{table}"
    );
    assert!(!table.contains("−180,0°"));
    let heel = gaitcam_output::report::html(&heel_tester(), TIME, Language::Es);
    assert!(
        heel.contains("rigidez de la columna de fluido") && !heel.contains("rigidez del muelle")
    );
    assert!(!heel.contains("frecuencia de paso"));
}

#[test]
fn parts_for_other_pages_have_the_decimal_sign_of_the_language() {
    let design = footbridge();
    let figures = gaitcam_output::report::parts::figures(&design, Language::Es);
    assert!(figures.iter().any(|f| f.value.contains(',')));
    for figure in &figures {
        let text = format!("{} {}", figure.value, figure.more);
        assert!(!text.contains('.'), "{text}");
    }
    let checks = gaitcam_output::report::parts::checks(&design, Language::Es);
    assert!(checks.iter().any(|check| check.place.contains(',')));
    assert!(checks.iter().all(|check| !check.place.contains('.')));
}
