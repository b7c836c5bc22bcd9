//! Steps of the sequence for laws of two numbers, s = a cos θ + b sin θ, with a roller on its line of motion.
//!
//! With A² = a² + b² and w = D² + A² + 2D·s, the curvature of the pitch curve is 3/(2√w) − (D² − A²)/(2 w^{3/2}). It is maximum at w = D² − A², where
//! its radius is √(D² − A²). A radius of ρ therefore permits A² ≤ D² − ρ². The clearance h/w is minimum at w³ = ρ²(D² − A²)², where it is 3/2 (((D² −
//! A²)/ρ²)^{1/3} − 1).

use super::linearised::{NEARLY, Room, linearised, restricted};
use super::start::shrunk;
use super::steps::*;
use super::trial::{ROOM, blend, solved};
use super::*;
use crate::cam::{Criterion, LimitKind};
use crate::halt::Halt;
use crate::law::Law;
use crate::poly::SplineSpace;
use crate::synth::limits::{Profile, ProfileSize};
use crate::synth::qp::{
    Basis, Demand, Equality, Limit, OFFSET, Quadratic, RADIUS, RISE, Row, Values, apply, sizes,
};
use std::f64::consts::{PI, TAU};

/// Height D, m.
const RISE_HEIGHT: f64 = 0.05;
const RHO: f64 = 0.04;
const GREATEST: f64 = 0.03;
/// Amplitude A of the law with the minimum objective, m.
const DRAWN: f64 = 0.045;
const PHASE: f64 = 0.7;

/// Number of spans. Coefficients that follow a cosine give a cosine law, except for waves that are 47 times as short and have an amplitude of 2e-12.
const SPANS: usize = 48;
const DEGREE: usize = 6;

/// Half the squared distance from a law of two numbers: Σ (xᵢ − tᵢ)²/N · (A/A of the coefficients)². The recurrence of a cosine, xᵢ₋₁ − 2 cos(2π/N)
/// xᵢ + xᵢ₊₁ = 0, leaves two free numbers.
fn program(to: f64) -> Program {
    let space = SplineSpace::periodic_uniform(DEGREE, SPANS, TAU);
    let basis = Basis::Spline {
        space,
        closed: true,
    };
    let mut objective = Quadratic::zero(&basis);
    let unit = 2.0 / SPANS as f64 * height().powi(2);
    for (i, number) in law(to).into_iter().enumerate() {
        objective.hessian.add(i, i, unit);
        objective.gradient[i] = -unit * number;
    }
    objective.constant = 0.5 * to * to;
    let middle = -2.0 * (TAU / SPANS as f64).cos();
    let recurrence = |i: usize| Equality {
        name: Demand::OnBaseCircle,
        entries: vec![(i, 1.0), (i + 1, middle), (i + 2, 1.0)],
        value: 0.0,
    };
    let equalities = (0..SPANS - 2).map(recurrence).collect();
    let mut program = Program::new(basis, objective, equalities, 0.01);
    sizes::declare(&mut program);
    program
}

/// Ratio of the amplitude A of a law and the amplitude of its coefficients.
fn height() -> f64 {
    let half = PI / SPANS as f64;
    (half.sin() / half).powi(DEGREE as i32 + 1)
}

/// The program with a cost on D.
fn priced(to: f64, price: f64) -> Program {
    let mut program = program(to);
    program.cost[RISE] = price;
    program
}

/// Coefficients of a law with an amplitude.
fn law(amplitude: f64) -> Vec<f64> {
    let at = |i: usize| TAU * i as f64 / SPANS as f64 - PHASE;
    (0..SPANS)
        .map(|i| amplitude / height() * at(i).cos())
        .collect()
}

fn solution(amplitude: f64, rise: f64) -> Solution {
    let mut extra = Values::NONE;
    extra[RISE] = rise;
    Solution {
        x: law(amplitude),
        extra,
        active: Vec::new(),
        used_rows: false,
        iterations: 0,
        rounds: 0,
        violation: 0.0,
    }
}

fn limits(rise: f64) -> NonconvexLimits {
    let size = ProfileSize {
        rise,
        rho: RHO,
        ..ProfileSize::default()
    };
    NonconvexLimits {
        diameter: None,
        profile: Some(Profile::Roller(size)),
        loads: None,
    }
}

fn at_size(program: &Program) -> AtSize {
    AtSize::new(limits(RISE_HEIGHT), program)
}

/// Minimum h/w of a law.
fn clearance(amplitude: f64, rise: f64) -> f64 {
    let square = (rise * rise - amplitude * amplitude) / (RHO * RHO);
    1.5 * (square.cbrt() - 1.0)
}

/// a and b in the frame of the law with the minimum objective.
fn numbers(x: &[f64]) -> [f64; 2] {
    let at = |i: usize| TAU * i as f64 / SPANS as f64 - PHASE;
    let part = |f: fn(f64) -> f64| -> f64 {
        let sum: f64 = (0..SPANS).map(|i| x[i] * f(at(i))).sum();
        2.0 / SPANS as f64 * height() * sum
    };
    [part(f64::cos), part(f64::sin)]
}

fn amplitude(solution: &Solution) -> f64 {
    let [a, b] = numbers(&solution.x);
    a.hypot(b)
}

fn near(value: f64, truth: f64, part: f64) {
    assert!(
        (value - truth).abs() <= part * truth.abs(),
        "{value} {truth}"
    );
}

#[test]
fn clearances_of_one_wave_are_those_of_its_sharpest_place() {
    let program = program(DRAWN);
    for amplitude in [0.01, 0.02, 0.03, 0.04, DRAWN] {
        let clear = at_size(&program).clear(&program, &solution(amplitude, 0.0));
        let truth = clearance(amplitude, RISE_HEIGHT);
        assert!(clear.len() == 1 && (clear[0] - truth).abs() < 1e-7);
    }
}

/// The limit depends only on A, by rotation of the cam. Its rows at a law that touches it are therefore tangents of a circle.
#[test]
fn rows_at_a_contact_are_tangents_of_the_circle_of_laws() {
    let program = program(DRAWN);
    let at = solution(GREATEST, 0.0);
    let rows = linearised(&program, &at, &at_size(&program), &Room::above(0.0));
    let touching = |row: &&Row| row.bound - apply(&row.entries, &at.x) < 1e-6 * row.scale;
    let touching: Vec<_> = rows.iter().filter(touching).collect();
    // Both sides of the follower's line have a sharpest place.
    assert!(touching.len() >= 2, "{}", touching.len());
    // A quarter of a turn later.
    let across: Vec<f64> = (0..SPANS)
        .map(|i| at.x[(i + SPANS - SPANS / 4) % SPANS])
        .collect();
    for row in touching {
        assert_eq!(row.name, Criterion::from(LimitKind::Curvature));
        let outward = apply(&row.entries, &at.x);
        assert!(apply(&row.entries, &across).abs() < 1e-4 * outward);
        near(row.bound, outward, 1e-6);
    }
}

/// h is of first order in the numbers of the law: linearised rows at a neighbouring law differ from the limit by the square of the distance.
#[test]
fn rows_miss_the_limit_by_the_square_of_a_step() {
    let program = program(DRAWN);
    let sizes = at_size(&program);
    let from = solution(0.02, 0.0);
    let rows = linearised(&program, &from, &sizes, &Room::above(0.0));
    let missed = |part: f64| {
        let law = Law::of(&program.basis, &solution(0.02 + 0.01 * part, 0.0).x);
        let x = solution(0.02 + 0.01 * part, 0.0).x;
        let each = rows.iter().map(|row| {
            let at = law.svaj_on(row.peak.piece, row.peak.u);
            let true_h = sizes.of(&from).slacks(at, row.peak.at)[0].h;
            let row_h = row.bound - apply(&row.entries, &x);
            (true_h - row_h - 2.0 * ROOM * row.scale).abs()
        });
        each.fold(0.0, f64::max)
    };
    near(missed(0.01) / missed(0.001), 100.0, 0.05);
}

#[test]
fn a_limit_that_is_missed_gets_twice_the_room_and_others_none() {
    let program = program(DRAWN);
    let at = solution(0.02, 0.0);
    let bound = |room: &Room| linearised(&program, &at, &at_size(&program), room)[0].bound;
    let plain = bound(&Room::above(0.0));
    let scale = linearised(&program, &at, &at_size(&program), &Room::above(0.0))[0].scale;
    for (clear, room) in [(-1e-5, 2e-5), (1e-5, 0.0), (-NEARLY, 0.0)] {
        let mut wider = Room::above(0.0);
        wider.widen(&[clear]);
        let lost = (plain - bound(&wider)) / scale;
        assert!((lost - room).abs() < 2.1 * ROOM, "{clear}: {lost}");
    }
}

/// The rows of the restriction with X ≥ 4ρ/3 are sufficient: for D = 0.1, a law that satisfies them has A² ≤ D² − ρ².
#[test]
fn the_restriction_leaves_only_laws_that_keep_the_curvature() {
    let rise = 0.1;
    let program = program(rise);
    let mut next = program.clone();
    let size = limits(rise).size();
    next.fixed = restricted(&program, &solution(0.0, 0.0), size);
    let found = solved(&next).unwrap();
    assert!(amplitude(&found) < (rise * rise - RHO * RHO).sqrt());
    assert!(amplitude(&found) > 0.01);
}

#[test]
fn a_blend_is_on_the_line_and_its_cones_are_tight() {
    let mut program = program(DRAWN);
    program.cone(Criterion::BaseCircle, RADIUS, &[RISE, OFFSET]);
    let (mut from, mut to) = (solution(0.01, 2.0), solution(0.03, 4.0));
    (from.extra[OFFSET], to.extra[OFFSET]) = (5.0, 3.0);
    let half = blend(&from, &to, 0.5, &program);
    near(amplitude(&half), 0.02, 1e-12);
    assert_eq!(
        [half.extra[RISE], half.extra[OFFSET], half.extra[RADIUS]],
        [3.0, 4.0, 5.0]
    );
}

#[test]
fn sizes_are_those_of_the_solution_where_the_program_has_them() {
    let (given, sought) = (program(DRAWN), priced(DRAWN, 1.0));
    let other = solution(0.01, 0.07);
    assert_eq!(at_size(&given).of(&other).size().rise, RISE_HEIGHT);
    let free = at_size(&sought);
    assert_eq!(free.of(&other).size().rise, 0.07);
    assert!(free.free()[RISE] && !free.held().free()[RISE]);
    assert_eq!(free.held().of(&other).size().rise, 0.07);
    let mut with_offset = priced(DRAWN, 1.0);
    with_offset.cost[OFFSET] = 1.0;
    assert!(at_size(&with_offset).free()[OFFSET]);
    let mut held = Limit::on(Criterion::BaseCircle, [0.0; 5]).at_most(0.0);
    held.extra[OFFSET] = 1.0;
    with_offset.limits.push(held);
    assert!(!at_size(&with_offset).free()[OFFSET]);
}

#[test]
fn a_law_that_breaks_the_curvature_is_brought_to_keep_it() {
    let program = program(DRAWN);
    let sizes = at_size(&program);
    for start in [start::feasible, start::tightened] {
        let found = start(&program, &solution(DRAWN, 0.0), &sizes).unwrap();
        assert!(amplitude(&found) <= GREATEST);
    }
    // By small steps from outside: a start near the limit, not on it.
    let found = start::tightened(&program, &solution(DRAWN, 0.0), &sizes).unwrap();
    near(amplitude(&found), GREATEST, 0.01);
}

#[test]
fn a_law_that_keeps_everything_is_its_own_start() {
    let program = program(DRAWN);
    let at = solution(0.02, 0.0);
    let found = start::feasible(&program, &at, &at_size(&program)).unwrap();
    assert_eq!(found.x, at.x);
}

#[test]
fn a_step_is_halved_until_the_limit_holds() {
    let program = program(DRAWN);
    let (from, to) = (solution(0.0, 0.0), solution(DRAWN, 0.0));
    let sizes = at_size(&program);
    let (trial, room, part) = shortened(&program, &from, &to, &sizes, 0.0).unwrap();
    assert_eq!(part, 0.5);
    near(room, clearance(0.5 * DRAWN, RISE_HEIGHT), 1e-8);
    near(amplitude(&trial), 0.5 * DRAWN, 1e-12);
    // From 0 to half way the objective falls by ¾ of its value.
    let whole = 0.5 * DRAWN * DRAWN;
    assert!(shortened(&program, &from, &to, &sizes, 0.74 * whole).is_some());
    assert!(shortened(&program, &from, &to, &sizes, 0.76 * whole).is_none());
}

#[test]
fn a_correction_ends_on_the_limit() {
    let program = program(DRAWN);
    let (found, clear) = corrected(
        &program,
        &solution(1.05 * GREATEST, 0.0),
        &at_size(&program),
    )
    .unwrap();
    assert!((ROOM..1e-6).contains(&clear), "{clear}");
    near(amplitude(&found), GREATEST, 1e-6);
}

#[test]
fn a_step_promises_and_takes_a_gain() {
    let program = program(DRAWN);
    let from = solution(0.01, 0.0);
    let mut reach = f64::INFINITY;
    let Outcome::Taken(next, one) = step(&program, &from, &at_size(&program), &mut reach) else {
        panic!("no step is taken");
    };
    let merit = |a: f64| 0.5 * (a - DRAWN).powi(2);
    near(one.merit, merit(amplitude(&next)), 1e-7);
    assert!(one.merit < merit(0.01) && amplitude(&next) <= GREATEST);
    assert_eq!(one.prime_radius, RISE_HEIGHT);
    near(
        one.clearance,
        clearance(amplitude(&next), RISE_HEIGHT),
        1e-3,
    );
}

#[test]
fn no_step_is_taken_from_the_optimum_or_after_the_time() {
    let mut program = program(0.02);
    program.constant += 1e-4;
    let from = solution(0.02, 0.0);
    let sizes = at_size(&program);
    let ended = |program: &Program| match step(program, &from, &sizes, &mut f64::INFINITY.clone()) {
        Outcome::Finished(ended) => Some(ended),
        _ => None,
    };
    assert_eq!(ended(&program), Some(Ended::SmallGain));
    program.halt = Halt::when(|| true);
    assert_eq!(ended(&program), Some(Ended::OutOfTime));
}

#[test]
fn the_reach_bounds_how_much_a_size_shrinks() {
    let program = priced(DRAWN, 1.0);
    let near = within_reach(&program, &solution(0.0, 0.08), 0.25);
    let least = |rise: f64| near.limits[0].room(&solution(0.0, rise).extra);
    assert!(least(0.0601) > 0.0 && least(0.0599) < 0.0);
    assert!(
        within_reach(&program, &solution(0.0, 0.08), f64::INFINITY)
            .limits
            .is_empty()
    );
    assert!(reach_shrinks(&program, 0.5) && !reach_shrinks(&program, SHORTEST));
    assert!(!reach_shrinks(&super::tests::program(DRAWN), 0.5));
}

#[test]
fn the_sequence_ends_at_the_greatest_wave_that_the_roller_follows() {
    let program = program(DRAWN);
    let starts = [solution(DRAWN, 0.0)];
    let (found, steps, ended) = refine(&program, &starts, limits(RISE_HEIGHT), |_| false).unwrap();
    near(amplitude(&found), GREATEST, 1e-6);
    assert!(numbers(&found.x)[1].abs() < 1e-3 * GREATEST);
    assert!(!steps.is_empty() && ended == Ended::SmallGain);
    assert!(steps.windows(2).all(|two| two[1].merit < two[0].merit));
    assert!(steps.iter().all(|s| s.clearance >= ROOM));
}

#[test]
fn the_sequence_ends_where_a_law_is_good_enough() {
    let program = program(DRAWN);
    let starts = [solution(0.01, 0.0)];
    let enough = |s: &Solution| amplitude(s) > 0.005;
    let (found, steps, _) = refine(&program, &starts, limits(RISE_HEIGHT), enough).unwrap();
    assert!(steps.is_empty());
    near(amplitude(&found), 0.01, 1e-9);
}

/// p D + ½ (A − A₀)² with D² = A² + ρ² is minimum for p A/D = A₀ − A.
#[test]
fn the_sequence_weighs_size_against_law() {
    let price = (DRAWN - GREATEST) * RISE_HEIGHT / GREATEST;
    let program = priced(DRAWN, price);
    let starts = [solution(DRAWN, 0.12)];
    let (found, ..) = refine(&program, &starts, limits(0.0), |_| false).unwrap();
    near(amplitude(&found), GREATEST, 1e-3);
    near(found.extra[RISE], RISE_HEIGHT, 1e-3);
    let merit = price * RISE_HEIGHT + 0.5 * (DRAWN - GREATEST).powi(2);
    near(program.merit(&found), merit, 1e-5);
}

#[test]
fn a_cam_smaller_than_its_sharpest_radius_has_no_start() {
    let program = program(DRAWN);
    let starts = [solution(DRAWN, 0.0)];
    let small = limits(0.9 * RHO);
    assert!(refine(&program, &starts, small.clone(), |_| false).is_none());
    assert!(feasible(&program, &starts[0], small).is_none());
    assert!(feasible(&program, &starts[0], limits(RISE_HEIGHT)).is_some());
}

/// In the iterations to the smallest cam, A = 0 with D = ρ, a cam of permitted size is found.
#[test]
fn a_cam_that_is_too_large_is_shrunk_to_its_limit() {
    let mut program = priced(DRAWN, 1e-6);
    let mut most = Limit::on(Criterion::BaseCircle, [0.0; 5]).at_most(RISE_HEIGHT);
    most.extra[RISE] = 1.0;
    program.limits.push(most);
    let large = solution(DRAWN, 0.12);
    let found = shrunk(&program, &large, &at_size(&program)).unwrap();
    let rise = found.extra[RISE];
    assert!(rise <= RISE_HEIGHT * (1.0 + 1e-6));
    assert!(amplitude(&found).powi(2) <= rise * rise - RHO * RHO);
}
