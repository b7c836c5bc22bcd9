//! Derivatives of the loads compared with differences, and the pressure compared with that of the contact.

use super::hertz_pressure::Pressure;
use super::loads::Loads;
use super::slack::{ProfileSize, Slack};
use crate::cam::{Follower, LimitKind};
use crate::drive::Drive;
use crate::dynamics::hertz::{STEEL, line, modulus};
use crate::dynamics::rigid::touch::touch;
use crate::law::Svaj;
use std::f64::consts::PI;

const THICK: f64 = 0.01;

fn loads() -> Loads {
    Loads {
        on_shaft: None,
        drive: Drive {
            spring_rate: 4000.0,
            damping: 30.0,
            rest_force: 200.0,
            ..Drive::moving_axis(3.0, 9.81, 20.0)
        },
        torque: Some(5.0),
        power: None,
        torque_rate: Some(9.0),
        pressure: Some(Pressure {
            spread: PI * THICK / modulus(STEEL, STEEL),
            roller: 0.01,
            most: 5e8,
        }),
    }
}

const SIZE: ProfileSize = ProfileSize {
    rise: 0.04,
    offset: 0.007,
    radius: 0.0,
    rho: 0.012,
};

fn place(i: u32) -> Svaj {
    let x = f64::from(i);
    Svaj {
        s: 0.01 * (1.0 + (1.3 * x).sin()),
        v: 0.01 * (0.7 * x).cos(),
        a: 0.01 * (0.3 * x + 1.0).sin(),
        j: 0.02 * (0.9 * x).cos(),
    }
}

fn slacks(at: Svaj, size: ProfileSize) -> Vec<Slack> {
    let mut out = Vec::new();
    loads().slacks(at, 0.0, size, &mut out);
    out
}

#[test]
fn derivatives_agree_with_differences() {
    let d = 1e-7;
    for i in 0..30 {
        let at = place(i);
        for (k, own) in slacks(at, SIZE).into_iter().enumerate() {
            let h = |at: Svaj, size: ProfileSize| slacks(at, size)[k].h;
            let moved = |f: &dyn Fn(f64) -> f64| (f(d) - f(-d)) / (2.0 * d);
            let found = [
                moved(&|x| h(Svaj { s: at.s + x, ..at }, SIZE)),
                moved(&|x| h(Svaj { v: at.v + x, ..at }, SIZE)),
                moved(&|x| h(Svaj { a: at.a + x, ..at }, SIZE)),
                moved(&|x| h(Svaj { j: at.j + x, ..at }, SIZE)),
                moved(&|x| {
                    h(
                        at,
                        ProfileSize {
                            rise: SIZE.rise + x,
                            ..SIZE
                        },
                    )
                }),
                moved(&|x| {
                    h(
                        at,
                        ProfileSize {
                            offset: SIZE.offset + x,
                            ..SIZE
                        },
                    )
                }),
            ];
            let stated = [
                own.by_lift,
                own.by_velocity,
                own.by_acceleration,
                own.by_jerk,
                own.by_rise,
                own.by_offset,
            ];
            let size = stated.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
            for (f, s) in found.iter().zip(stated) {
                assert!(
                    (f - s).abs() < 1e-6 * size,
                    "{} {found:?} {stated:?}",
                    own.name
                );
            }
        }
    }
}

/// h has the sign of the limit minus the pressure that is computed for the contact.
#[test]
fn the_pressure_is_the_contact_s_own() {
    let follower = Follower::RollerTranslating {
        prime_radius: SIZE.rise.hypot(SIZE.offset),
        offset: SIZE.offset,
        roller_radius: 0.01,
    };
    for i in 0..30 {
        let at = place(i);
        let force = loads().drive.force(at);
        let here = touch(&follower, 20.0, 0.0, at, force);
        let steel = modulus(STEEL, STEEL);
        let pressure = line(here.normal, THICK, here.curvature, steel).pressure;
        let at_limit = loads().with(LimitKind::HertzPressure, Some(pressure));
        let mut out = Vec::new();
        at_limit.slacks(at, 0.0, SIZE, &mut out);
        let slack = out.last().unwrap();
        assert!(
            slack.h.abs() < 1e-12 * slack.w,
            "{i}: {} {}",
            slack.h,
            slack.w
        );
    }
}
