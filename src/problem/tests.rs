//! Tests that the variants of a problem agree with their names.

use std::f64::consts::TAU;

use super::{Extra, Note, Problem, Size};
use crate::cam::{Criterion, LimitKind};
use crate::poly::PiecewisePoly;
use crate::scene::{Minimise, Scene, built_in};

fn scene(changes: &[(&str, &str)]) -> Scene {
    let scene = built_in("footbridge").unwrap().scene().unwrap();
    let with = |s: Scene, (key, value): &(&str, &str)| s.with(key, value).unwrap();
    changes.iter().fold(scene, with)
}

fn problem(changes: &[(&str, &str)]) -> Problem {
    let scene = scene(changes);
    Problem::resolve(&scene, scene.model_force().unwrap().as_ref()).unwrap()
}

#[test]
fn a_changed_number_is_read_back_and_the_first_problem_keeps_its_own() {
    let first = problem(&[("limits.stroke", "60 mm"), ("cam.bore", "12 mm")]);
    let numbers = [
        Criterion::Limit(LimitKind::Stroke),
        Criterion::Accuracy,
        Criterion::Bore,
        Criterion::BaseRadius,
    ];
    for criterion in numbers {
        let before = first.value(criterion);
        assert_eq!(first.with(criterion, 0.0123).value(criterion), Some(0.0123));
        assert_eq!(first.value(criterion), before);
    }
}

#[test]
fn a_turn_at_a_phase_begins_there_in_the_cycle() {
    let first = problem(&[("gait.band", "20 N")]);
    let turned = first.at_phase(1.2);
    let at = |p: &Problem, x: f64| p.target.as_ref().unwrap().curve().at(x.rem_euclid(TAU));
    let low = |p: &Problem, x: f64| p.band.as_ref().unwrap()[0].at(x.rem_euclid(TAU));
    for x in [0.0, 0.7, 3.0, 6.0] {
        assert!((at(&turned, x) - at(&first, x + 1.2)).abs() < 0.05);
        assert!((low(&turned, x) - at(&turned, x) + 20.0).abs() < 0.05);
    }
    assert_eq!((first.phase, turned.phase), (0.0, 1.2));
}

#[test]
fn without_limits_nothing_is_judged_but_the_force_is_followed() {
    let first = problem(&[("limits.stroke", "60 mm"), ("accuracy.rms", "1 %")]);
    let open = first.without_limits();
    assert!(first.allowed_error().is_some() && open.allowed_error().is_none());
    assert_eq!(open.limits[LimitKind::Stroke], None);
    assert_eq!(open.objective(), Minimise::ForceError);
    assert_eq!(open.target_mean(), first.target_mean());
}

#[test]
fn of_several_walkers_the_error_of_the_mean_is_not_judged() {
    let several = problem(&[
        ("gait.step_frequency", "1.6 Hz:2 Hz:3"),
        ("accuracy.rms", "1 %"),
    ]);
    assert!(several.allowed_error().is_some() && several.judged_error().is_none());
    let mean = several.of_mean();
    assert!(mean.walkers.is_none() && mean.allowed_error().is_none());
    let one = problem(&[("accuracy.rms", "1 %")]);
    assert_eq!(one.of_mean().judged_error(), one.judged_error());
    assert!(one.judged_error().is_some());
}

#[test]
fn what_the_machine_adds_leaves_the_target_and_the_band_that_are_shown() {
    let first = problem(&[("gait.band", "20 N")]);
    let ten = PiecewisePoly::new(vec![0.0, TAU], 0, vec![10.0]);
    let even: Vec<f64> = (0..360).map(|i| f64::from(i).to_radians()).collect();
    let moved = first.on_shaft(&even, Extra::of_force(ten));
    let shown = |p: &Problem| p.target_at_cam().unwrap().at(2.0);
    assert_eq!(shown(&moved), shown(&first));
    let band = |p: &Problem| p.band_in_time().unwrap()[1].at(2.0);
    assert_eq!(band(&moved), band(&first));
    let sought = moved.target.as_ref().unwrap().curve().at(2.0);
    assert!((sought - shown(&first) + 10.0).abs() < 1e-3);
}

#[test]
fn against_another_force_the_limits_stay() {
    let first = problem(&[("limits.stroke", "60 mm")]);
    let drive = crate::drive::Drive {
        speed: 5.0,
        ..first.drive
    };
    let other = first.target_at_cam().unwrap().scaled(2.0);
    let moved = first.against(drive, Some(other));
    assert_eq!(moved.drive.speed, 5.0);
    assert_eq!(moved.limits[LimitKind::Stroke], Some(0.06));
    let mean = |p: &Problem| p.target_in_time().unwrap().mean_n();
    assert!((mean(&moved) / mean(&first) - 2.0).abs() < 1e-12);
    assert!(first.against(drive, None).target_in_time().is_none());
}

#[test]
fn a_size_is_given_sought_or_follows_the_law() {
    let size = |changes: &[(&str, &str)]| problem(changes).size();
    assert_eq!(size(&[]), Size::AfterLaw);
    let given = size(&[("cam.base_radius", "30 mm")]);
    assert!(matches!(given, Size::Given { base, .. } if base == 0.03));
    assert_eq!(size(&[("law.minimise", "size")]), Size::Sought);
    assert_eq!(size(&[("limits.prime_radius", "50 mm")]), Size::Sought);
}

/// Table of a motion of 12 mm over 90°, with lifts rounded to `decimals` decimals.
fn rounded(motion: &crate::law::Rise, step: u32, decimals: i32) -> crate::law::Rise {
    let law = motion.law().unwrap();
    let unit = 10.0_f64.powi(decimals);
    let row = |degrees: u32| {
        let lift = 12.0 * law.svaj(f64::from(degrees) / 90.0).s;
        (f64::from(degrees), (lift * unit).round() / unit)
    };
    let rows: Vec<(f64, f64)> = (0..=90 / step).map(|k| row(k * step)).collect();
    crate::law::Rise::table("table", &rows, true).unwrap()
}

#[test]
fn a_note_says_where_rounded_rows_make_the_acceleration() {
    use crate::law::Rise;
    use crate::scene::{LawSpec, SegmentSpec};
    let scene = built_in("camdas_03_flat").unwrap().scene().unwrap();
    for motion in [Rise::Cycloidal, Rise::Poly345, Rise::Poly4567] {
        for (step, decimals) in [1, 2, 5]
            .into_iter()
            .flat_map(|s| [2, 3, 4, 9].map(|d| (s, d)))
        {
            let table = rounded(&motion, step, decimals);
            let own = motion.factors().unwrap().ca;
            let excess = table.factors().unwrap().ca / own - 1.0;
            let case = format!("{} {step}° {decimals}: {excess}", motion.name());
            // The additional acceleration due to rounding is below its bound.
            assert!(
                excess <= table.rounded_acceleration() / own + 0.02,
                "{case}"
            );
            let turn = std::f64::consts::TAU;
            let segments = vec![
                SegmentSpec::new(table, 0.012, 0.25 * turn),
                SegmentSpec::new(Rise::Cycloidal, -0.012, 0.75 * turn),
            ];
            let law = LawSpec::program(segments);
            let problem = Problem::resolve(
                &crate::Scene {
                    law,
                    ..scene.clone()
                },
                None,
            )
            .unwrap();
            let noted = problem
                .notes()
                .iter()
                .any(|n| matches!(n, Note::RoundedTable { .. }));
            assert!(noted || excess < 0.12, "{case}");
            assert!(!noted || decimals < 9, "{case}");
        }
    }
}

#[test]
fn programmes_without_a_table_have_no_note_on_rounding() {
    for name in ["thesis_iteration_4", "camdas_09_eight_motions"] {
        let scene = crate::scene::built_in(name).unwrap().scene().unwrap();
        let force = scene.model_force().unwrap();
        let notes = Problem::resolve(&scene, force.as_ref()).unwrap().notes();
        let is_of_a_table = |n: &Note| matches!(n, Note::RoundedTable { .. });
        assert!(!notes.iter().any(is_of_a_table), "{name}: {notes:?}");
    }
}
