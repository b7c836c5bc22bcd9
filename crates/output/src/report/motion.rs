//! Data of the animation, with one value per step. Lengths are in mm, forces in N and angles in degrees.

use serde::Serialize;

use super::Running;
use crate::pose::{Pose, pose, turned};
use gaitcam::cam::{Cam, Follower, Unit};
use gaitcam::dynamics::Row;
use gaitcam::law::Svaj;
use gaitcam::synth::Design;

const MM: f64 = 1000.0;
/// Number of steps per turn. The script interpolates linearly between the steps.
pub const STEPS: usize = 480;
/// Maximum number of turns that are shown. If the period of the simulated motion is longer, only this number is shown.
const MOST_TURNS: usize = 4;

/// Data for the script. Each list has one value per step and an additional value at the end of the motion.
#[derive(Default, Serialize)]
pub struct Motion {
    /// First angle of the cam in the displayed unit.
    start: f64,
    /// Angle of one turn, or length of the travel, in the displayed unit.
    length: f64,
    turns: usize,
    /// Duration of one turn, or of the travel, s.
    period: f64,
    /// Travel of an unrolled cam, mm per displayed unit of its angle or travel; 0 for a rotating cam.
    slide: f64,
    /// Whether the cam moves in the direction of negative angles.
    back: bool,
    angle_unit: String,
    length_unit: &'static str,
    unit: &'static str,
    force_unit: &'static str,
    /// Numbers of decimals of force and torque.
    digits: [usize; 2],
    s: Vec<Option<f64>>,
    f: Vec<Option<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    readings: Option<Readings>,
    cx: Vec<Option<f64>>,
    cy: Vec<Option<f64>>,
    /// Direction of the force on the follower, in degrees from +x.
    push: Vec<Option<f64>>,
    px: Vec<Option<f64>>,
    py: Vec<Option<f64>>,
    pa: Vec<Option<f64>>,
    qx: Vec<Option<f64>>,
    qy: Vec<Option<f64>>,
    qa: Vec<Option<f64>>,
}

/// Values that are displayed next to the drawing. They do not influence the positions of the moving parts.
#[derive(Default, Serialize)]
struct Readings {
    torque: Vec<Option<f64>>,
    gap: Vec<Option<f64>>,
    rho: Vec<Option<f64>>,
    phi: Vec<Option<f64>>,
}

/// Unit of θ on the page: factor that converts the SI unit to the displayed unit, and name as it is written after a number. For a
/// translating cam, it is a unit of length.
pub fn angle_unit(cam: &Cam) -> (f64, String) {
    let unit = cam.follower.measures().angle();
    (unit.factor, unit.after(""))
}

/// Travel of an unrolled cam, mm per rad (or m) of θ; 0 for a rotating cam.
pub fn slide(cam: &Cam) -> f64 {
    match cam.follower {
        Follower::TranslatingCam { .. } => MM,
        Follower::Barrel { radius, .. } => MM * radius,
        _ => 0.0,
    }
}

/// Number of decimals with which a value of magnitude `most` has four significant digits.
fn decimals(most: f64) -> usize {
    if most > 0.0 && most.is_finite() {
        (3 - libm::log10(most).floor() as i32).clamp(0, 6) as usize
    } else {
        1
    }
}

/// A value rounded to four decimals (0.1 µm for a value in mm); non-finite numbers become null.
fn rounded(x: f64) -> Option<f64> {
    to(x, 1e4)
}

/// `x` rounded to a multiple of 1/`places`; non-finite numbers become null.
fn to(x: f64, places: f64) -> Option<f64> {
    x.is_finite().then(|| (x * places).round() / places)
}

/// State of a simulation at the cam angle `theta`, rad, interpolated linearly between two rows. If there is a gap in one of the rows,
/// force and torque are taken from the nearer row. The force at landing then does not appear during the flight.
fn row_at(rows: &[Row], theta: f64, step: f64) -> Row {
    let n = rows.len();
    let x = (theta - rows[0].theta) / step;
    let (i, u) = (x.floor().rem_euclid(n as f64) as usize % n, x - x.floor());
    let (a, b) = (rows[i], rows[(i + 1) % n]);
    let flying = a.gap > 0.0 || b.gap > 0.0;
    let mix = |p: f64, q: f64| {
        if flying && u < 0.5 {
            p
        } else if flying {
            q
        } else {
            p + u * (q - p)
        }
    };
    Row {
        contact_force: mix(a.contact_force, b.contact_force),
        torque: mix(a.torque, b.torque),
        lift: a.lift + u * (b.lift - a.lift),
        gap: a.gap + u * (b.gap - a.gap),
        ..a
    }
}

/// Position, m, and direction, degrees, of the part of the follower that touches the cam. The position is the foot of the face or the
/// centre of the roller.
pub fn placed(cam: &Cam, theta: f64) -> ([f64; 2], f64) {
    match pose(cam, theta) {
        Pose::Face { at, angle } => (at, angle.to_degrees()),
        Pose::Roller { centre, .. } => {
            let angle = cam.follower.pivot().map_or(0.0, |p| {
                libm::atan2(p[1] - centre[1], p[0] - centre[0]).to_degrees()
            });
            (centre, angle)
        }
    }
}

/// Motion of a design for the animation: lift and force of the rigid machine or, if `running` is given, the simulated motion.
pub fn motion(synthesis: &Design, running: Option<&Running>) -> Motion {
    let cam = &synthesis.cam;
    let (start, length) = cam.law.extent();
    let lift = cam.follower.measures().lift(0);
    let (per, angle_unit) = angle_unit(cam);
    let lengths = Unit::length();
    let turns = running.map_or(1, |r| r.outcome.period_turns.clamp(1, MOST_TURNS));
    let later = running.and_then(|r| r.second_cam).map(|angle| Cam {
        law: cam.law.ahead(-angle),
        follower: cam.follower,
    });
    let mut out = Motion {
        start: per * start,
        length: per * length,
        turns,
        period: length / synthesis.problem.drive.speed.abs(),
        slide: slide(cam) / per,
        back: synthesis.problem.drive.speed < 0.0,
        angle_unit,
        length_unit: lengths.name,
        unit: lift.name,
        force_unit: cam.follower.measures().force().name,
        readings: Some(Readings::default()),
        ..Motion::default()
    };
    let (mut force, mut torque) = (0.0_f64, 0.0_f64);
    for i in 0..=STEPS * turns {
        let theta = start + length * i as f64 / STEPS as f64;
        // A closed law continues with its first turn. An open law is evaluated at its end.
        let within = if i % STEPS == 0 && i > 0 && !cam.law.is_closed() {
            start + length
        } else {
            start + length * (i % STEPS) as f64 / STEPS as f64
        };
        let higher = match &later {
            Some(second) if second.law.svaj(within).s > cam.law.svaj(within).s => second,
            _ => cam,
        };
        let at = higher.law.svaj(within);
        let row = match running {
            Some(r) if !r.outcome.rows.is_empty() => {
                let rows = &r.outcome.rows;
                let step = length * r.outcome.period_turns as f64 / rows.len() as f64;
                row_at(rows, theta, step)
            }
            _ => still(synthesis, within, at),
        };
        force = force.max(row.contact_force.abs());
        torque = torque.max(row.torque.abs());
        out.take(higher, within, at, &row, lift.factor);
        if let Some(pair) = &synthesis.conjugate {
            let ([x, y], angle) = placed(&pair.second, within);
            out.qx.push(rounded(-MM * x));
            out.qy.push(rounded(-MM * y));
            out.qa.push(rounded(angle + 180.0));
        }
    }
    out.digits = [decimals(force), decimals(torque)];
    out
}

/// State of the rigid machine at the cam angle `theta`, rad, in the form of a simulated state: contact force, torque and lift.
fn still(synthesis: &Design, theta: f64, at: Svaj) -> Row {
    let force = synthesis.force_at(theta);
    Row {
        contact_force: force,
        torque: force * at.v,
        lift: at.s,
        ..Row::default()
    }
}

impl Motion {
    /// Copy of the motion without the values that are displayed next to the drawing.
    pub fn without_readings(mut self) -> Motion {
        self.readings = None;
        self
    }

    fn take(&mut self, cam: &Cam, theta: f64, at: Svaj, row: &Row, factor: f64) {
        let p = cam.point(theta);
        let in_space = |p: [f64; 2]| match cam.follower.is_unrolled() {
            true => cam.into_space(theta, p),
            false => turned(p, theta),
        };
        let [cx, cy] = in_space([p.x, p.y]);
        let ([px, py], pa) = placed(cam, theta);
        let motion = cam.motion(theta);
        let flying = row.gap > 0.0;
        // A follower in contact has the lift of the law. After lift-off it has the simulated lift.
        let raised = if flying { row.lift - at.s } else { 0.0 };
        let (px, py, pa) = match cam.follower.pivot() {
            None => (px + raised * motion[0], py + raised * motion[1], pa),
            Some(pivot) => {
                let turn = -raised * pivot[0].signum();
                let [x, y] = turned([px - pivot[0], py - pivot[1]], turn);
                (x + pivot[0], y + pivot[1], pa + turn.to_degrees())
            }
        };
        // A flank with a radius above one hundred prime radii looks straight.
        let straight = p.rho.abs() > 100.0 * cam.follower.prime_radius();
        let touching = |x: f64| if flying { None } else { rounded(x) };
        self.s.push(rounded(factor * row.lift));
        self.f.push(to(row.contact_force, 1e7));
        if let Some(read) = &mut self.readings {
            read.torque.push(to(row.torque, 1e9));
            read.gap.push(rounded(factor * row.gap));
            let rho = if straight {
                None
            } else {
                touching(Unit::length().factor * p.rho)
            };
            read.rho.push(rho);
            read.phi.push(touching(p.pressure_angle.to_degrees()));
        }
        self.cx.push(touching(MM * cx));
        self.cy.push(touching(MM * cy));
        let lean = libm::atan2(motion[1], motion[0]) + p.pressure_angle;
        self.push.push(rounded(lean.to_degrees()));
        self.px.push(rounded(MM * px));
        self.py.push(rounded(MM * py));
        self.pa.push(rounded(pa));
    }
}
