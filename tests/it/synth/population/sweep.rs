//! Sweeps over scenes with several walkers.

use gaitcam::force::{ForceCurve, Walker};
use gaitcam::halt::Halt;
use gaitcam::scene;
use gaitcam::sweep::{Plan, Sampling, Subject, Sweep};

use gaitcam_test_support::Memory;

use super::{force, people, with};

#[test]
fn rows_of_a_sweep_over_a_table_of_walkers_are_their_designs_and_a_walker_in_kilonewtons_is_named()
{
    let people = people(6, 4, 0.5);
    let all: Vec<Walker> = people.iter().map(|p| p.0.clone()).collect();
    let table = |walkers: &[Walker]| gaitcam::force::population_csv(walkers).into_bytes();
    let sweep = |bytes: Vec<u8>| {
        let mut table = scene::built_in("footbridge").unwrap().toml.parse().unwrap();
        for change in ["gait.file=walkers.csv", "law.robust=worst", "law.spans=12"] {
            scene::set(&mut table, change).unwrap();
        }
        let plan = Plan::of(table, &["limits.stroke=30 mm:50 mm:3"], Sampling::Grid).unwrap();
        let files = Memory::from([("walkers.csv", bytes)]);
        Sweep::new(Subject::Designs(plan), |_| &files).unwrap()
    };
    let run = |sweep: &Sweep| {
        sweep
            .run(0..3, 1, &Halt::never, &|| false)
            .unwrap()
            .unwrap()
    };
    let records = run(&sweep(table(&all)));
    let strokes = records.numbers("stroke_m").unwrap();
    for (row, stroke) in [30, 40, 50].into_iter().enumerate() {
        let limit = format!("{stroke} mm");
        let scene = with(&[
            ("law.spans", "12"),
            ("law.robust", "worst"),
            ("limits.stroke", &limit),
        ]);
        let design = scene.design_for(&force(&people)).unwrap();
        assert!((strokes[row] / design.cam.law.stroke() - 1.0).abs() < 1e-6);
    }
    let mut mixed = all;
    mixed[2].curve = mixed[2]
        .curve
        .with_forces(mixed[2].curve.force_n.iter().map(|f| f / 1000.0).collect());
    let records = run(&sweep(table(&mixed)));
    let error = records.words("error").unwrap().at(0).unwrap().to_string();
    assert!(error.contains("W002") && error.contains("unit"), "{error}");
}

/// Rows over a folder, a list and a table. Each equals the design of its walkers, in one run and in shares.
#[test]
fn a_sweep_carries_what_folders_and_lists_of_walkers_hold() {
    let people = people(6, 4, 0.5);
    let all: Vec<Walker> = people.iter().map(|p| p.0.clone()).collect();
    let table = |walkers: &[Walker]| gaitcam::force::population_csv(walkers).into_bytes();
    let mut scene = scene::built_in("footbridge").unwrap().toml.parse().unwrap();
    for change in ["law.robust=worst", "law.spans=12", "gait.file=nowhere.csv"] {
        scene::set(&mut scene, change).unwrap();
    }
    let values = "gait.file=people/, [\"a.csv\", 'b.csv'], a.csv, [\"people\", \"b.csv\"]";
    let plan = Plan::of(scene, &[values], Sampling::Grid).unwrap();
    let files = Memory::from([
        ("people/x.csv", table(&all[..1])),
        ("people/in/y.csv", table(&all[1..3])),
        ("a.csv", table(&all[3..5])),
        ("b.csv", table(&all[5..])),
    ]);
    let sweep = Sweep::new(Subject::Designs(plan), |_| &files).unwrap();
    let again = Sweep::with_files(sweep.subject.clone(), sweep.files().clone()).unwrap();
    let run = |sweep: &Sweep| {
        let records = sweep.run(0..4, 1, &Halt::never, &|| false).unwrap();
        records.unwrap().numbers("stroke_m").unwrap().to_vec()
    };
    let strokes = run(&sweep);
    assert_eq!(run(&again), strokes);
    let groups = [&[0, 1, 2][..], &[3, 4, 5], &[3, 4], &[0, 1, 2, 5]];
    for (stroke, group) in strokes.into_iter().zip(groups) {
        let own = group.iter().map(|i| all[*i].clone()).collect();
        let design = with(&[("law.spans", "12"), ("law.robust", "worst")])
            .design_for(&ForceCurve::of_walkers(own).unwrap())
            .unwrap();
        assert!(
            (stroke / design.cam.law.stroke() - 1.0).abs() < 1e-6,
            "{group:?}"
        );
    }
}
