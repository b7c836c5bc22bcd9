//! A law for the speed that the motor gives the shaft.
//!
//! The design at constant speed is a motion in time. Run by the motor it fixes power and so ω(θ); told by that clock, the
//! same motion in time is another law, whose force differs from the target by what the design left only. With ω(θ) known the
//! force is linear in the law ([`crate::problem`]), the program is solved again, and so on: each round multiplies the change
//! by about the ripple (theory §10).

use std::f64::consts::TAU;

use serde::Serialize;

use crate::cam::Follower;
use crate::drive::{Drive, Motor};
use crate::dynamics::rigid::touch::{rubs, touch};
use crate::dynamics::shaft::{Load, Motion, Node, error_in_time, periodic};
use crate::dynamics::{InTime, Shaft};
use crate::error::{DynamicsError, Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::law::{Law, Svaj};
use crate::problem::Problem;
use crate::scene::{Family, ShaftSpeed};
use crate::synth::design::Design;
use crate::synth::{Search, at_constant_speed};
use crate::units::Quantity;

/// Equal angles of the clock.
const ROWS: usize = 240;
/// Equal angles of the target.
const SAMPLES: usize = 720;
/// Rounds of designs at most.
const ROUNDS: usize = 8;
/// Rounds of the clock alone, before the first design, and the relative change of speed at which they end.
const CLOCK_ROUNDS: usize = 12;
const SAME_CLOCK: f64 = 1e-5;
/// Change of the target, part of its mean, at which the design is final.
const SETTLED: f64 = 1e-4;
/// Part by which inertia, torque line and friction may differ from what is given.
const DEVIATION: f64 = 0.1;

/// The design on its shaft.
///
/// ```
/// use gaitcam::{scene, synthesise};
///
/// // A wheel of 0.5 kg m² and a motor that loses 10 N·m per rad/s: the speed ripples by a quarter.
/// let mut table = scene::built_in("footbridge")?.scene()?.to_table();
/// scene::set(&mut table, "machine.motor.slope=10 N m s/rad")?;
/// scene::set(&mut table, "machine.inertia=0.5 kg m^2")?;
/// let scene = scene::read(&table)?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let on_shaft = design.shaft.as_ref().unwrap();
/// assert!((on_shaft.shaft.ripple - 0.25).abs() < 0.01);
/// assert!(on_shaft.force_time.unwrap().rms_error_percent_of_mean < 0.5);
/// assert!(on_shaft.at_constant_speed.unwrap().rms_error_percent_of_mean > 6.0);
/// // With 10 % more inertia the same cam still presses to 1 % of the weight.
/// let [less, more] = on_shaft.sensitivity[0].percent;
/// assert!(less.unwrap() < 1.0 && more.unwrap() < 1.0);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct OnShaft {
    /// Motion of the shaft.
    pub shaft: Shaft,
    /// Force error over time.
    pub force_time: Option<InTime>,
    /// The same of the law for constant speed under this motor.
    pub at_constant_speed: Option<InTime>,
    /// Programs solved beside the one at constant speed.
    pub rounds: usize,
    /// Factor between the last two changes of the target from round to round; `None` of fewer than two changes.
    pub contraction: Option<f64>,
    /// Force error over time, percent of the mean, where the machine differs by ±10 %, its supply set again.
    pub sensitivity: Vec<Sensitivity>,
    /// Speed at equal cam angles, rad/s.
    #[serde(skip)]
    pub speed: Vec<f64>,
    /// Time there since cam angle 0, s.
    #[serde(skip)]
    pub time: Vec<f64>,
    /// The target over time.
    #[serde(skip)]
    pub target: Option<ForceCurve>,
}

/// Force error of the cam on another machine.
///
/// ```
/// use gaitcam::synth::Sensitivity;
///
/// // It does not turn with 10 % less of the inertia.
/// let wheel = Sensitivity { key: "machine.inertia", percent: [None, Some(0.4)] };
/// assert_eq!(serde_json::to_value(&wheel).unwrap()["percent"][1], 0.4);
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct Sensitivity {
    /// Key of what differs.
    pub key: &'static str,
    /// Force error with 10 % less and 10 % more, percent of the mean.
    pub percent: [Option<f64>; 2],
}

impl Problem {
    /// The motor that turns the shaft of the design, where there is one.
    fn motor(&self) -> Option<Motor> {
        let is_run = self.on_shaft.is_none() && !self.law.polydyne;
        self.machine.motor().filter(|_| is_run)
    }
}

/// The design for the speed that the motor gives, from the one at constant speed; that one where there is no motor, no
/// force, or no law.
///
/// # Errors
/// The shaft stops; the rounds do not contract; a limit that has no form at varying speed.
pub fn designed(first: Design, search: &Search) -> Result<Design> {
    let problem = first.problem.clone();
    let Some(motor) = problem.motor().filter(|_| first.infeasible.is_none()) else {
        return Ok(first);
    };
    let run = Runner::new(&first, &motor)?;
    let clock = run.of_law(&first.cam.law, None)?;
    let at_constant_speed = run.error(&first.cam.law, &clock);
    let fixed = problem.law.shaft == ShaftSpeed::Constant
        || matches!(problem.law.family, Family::Program | Family::Polynomial);
    let mut last = Last {
        design: first,
        clock,
        rounds: 0,
        contraction: None,
    };
    if !fixed && problem.target.is_some() {
        refuse_unknown(&problem)?;
        last = rounds(last, &run, &problem, search)?;
    }
    let Last {
        mut design,
        clock,
        rounds,
        contraction,
    } = last;
    let law = design.cam.law.clone();
    let (load, _) = run.load_of_law(&law);
    let supply = clock.check_supply(&load, &motor);
    supply.map_err(|e| e.at_key("machine.motor"))?;
    let lowest = law.extremes(0).0.at;
    let on_shaft = design.problem.on_shaft.clone();
    if let Some(target) = on_shaft.map(|shaft| shaft.target.clone()) {
        let at = |i: usize| (design.force_at(angle(i)), 1.0 / clock.speed[i]);
        let [force, time] = (0..ROWS)
            .map(at)
            .fold([0.0, 0.0], |[sum, all], (force, time)| {
                [sum + force * time, all + time]
            });
        (design.force.mean_n, design.force.target_mean_n) = (force / time, problem.target_mean());
        design.target = Some(target);
        design.band = problem.band.clone();
    }
    design.shaft = Some(OnShaft {
        shaft: clock.report(&load, &motor, lowest),
        force_time: run.error(&law, &clock),
        at_constant_speed,
        rounds,
        contraction,
        sensitivity: run.sensitivity(&law, &clock),
        speed: clock.speed,
        time: clock.time,
        target: problem.target.as_ref().map(|t| (*t.curve).clone()),
    });
    Ok(design)
}

/// The last design with the shaft under it.
struct Last {
    design: Design,
    clock: Motion,
    rounds: usize,
    contraction: Option<f64>,
}

/// Designs for the clock of the design before until the target stays.
fn rounds(first: Last, run: &Runner, problem: &Problem, search: &Search) -> Result<Last> {
    let mut last = first;
    let law = last.design.cam.law.clone();
    let mut clocks: Clocks = (None, run.settled(&law, last.clock.clone())?);
    let mean = problem.target_mean();
    let sampled = |at: &Problem| -> Vec<f64> {
        let curve = at.target.as_ref().map(|t| &t.curve);
        let angles = (0..SAMPLES).map(|i| TAU * i as f64 / SAMPLES as f64);
        curve.map_or(Vec::new(), |curve| angles.map(|x| curve.at(x)).collect())
    };
    let (mut target, mut change): (_, Option<f64>) = (sampled(problem), None);
    for round in 1..=ROUNDS {
        let at = run.corrected(problem, &last.design.cam.law, &clocks);
        let next = sampled(&at);
        let square = next.iter().zip(&target).map(|(a, b)| (a - b).powi(2));
        let now = (square.sum::<f64>() / SAMPLES as f64).sqrt();
        last.contraction = change.map(|before| now / before).filter(|x| x.is_finite());
        if now <= SETTLED * mean {
            return Ok(last);
        }
        if round > 3 && change.is_some_and(|before| now >= before) {
            break;
        }
        (target, change) = (next, Some(now));
        // What is kept belongs to the target of the round before.
        let fresh = Search {
            cache: Default::default(),
            ..search.clone()
        };
        last.design = at_constant_speed(&at, &fresh)?;
        last.rounds = round;
        if last.design.infeasible.is_some() {
            return Ok(last);
        }
        last.clock = run.of_law(&last.design.cam.law, Some(&clocks.1))?;
        clocks = (Some(clocks.1), last.clock.clone());
    }
    let contraction = last.contraction.unwrap_or(1.0);
    let ripple = Quantity::share(last.clock.ripple());
    Err(SynthError::ShaftDiverges {
        ripple,
        contraction,
    }
    .at_key("machine.inertia"))
}

/// Refuses limits that have no form at varying speed: on the jerk, the torque and the contact pressure.
fn refuse_unknown(problem: &Problem) -> Result<()> {
    use crate::cam::LimitKind::{HertzPressure, Jerk, Power, Torque, TorqueRate};
    let kinds = [Jerk, Torque, Power, TorqueRate, HertzPressure];
    match kinds
        .into_iter()
        .find(|kind| problem.limits[*kind].is_some())
    {
        None => Ok(()),
        Some(kind) => Err(SynthError::LimitOnShaft.at_key(&format!("limits.{}", kind.name()))),
    }
}

/// Runs laws of a design on its shaft.
struct Runner<'a> {
    follower: Follower,
    motor: &'a Motor,
    drive: Drive,
    target: Option<Vec<f64>>,
    friction: f64,
}

/// The clock of a shaft before and the one that runs now.
type Clocks = (Option<Motion>, Motion);

impl<'a> Runner<'a> {
    fn new(design: &Design, motor: &'a Motor) -> Result<Self> {
        let drive = design.drive;
        let law = &design.cam.law;
        if !law.is_closed() || law.extent() != (0.0, TAU) || drive.speed <= 0.0 {
            return Err(DynamicsError::MotorTurns.at_key("machine.motor"));
        }
        let target = design.problem.target.as_ref();
        let target = target.map(|t| (0..ROWS).map(|i| t.curve.at(angle(i))).collect());
        Ok(Runner {
            follower: design.cam.follower,
            friction: design.problem.machine.friction,
            motor,
            drive,
            target,
        })
    }

    fn arms(&self, at: Svaj) -> [f64; 2] {
        let mu = self.friction;
        match mu > 0.0 && rubs(&self.follower) {
            false => [at.v; 2],
            true => [1.0, -1.0].map(|f| f * touch(&self.follower, 1.0, mu, at, f).torque),
        }
    }

    /// The load of a motion over the turn, and at the equal angles.
    fn load(&self, breaks: &[f64], at: &dyn Fn(f64) -> Svaj) -> (Load, Vec<Node>) {
        let node = |x: f64| {
            let at = at(x);
            Node::new(&self.drive, at, self.arms(at))
        };
        let rows = (0..ROWS).map(|i| node(angle(i))).collect();
        (Load::of((0.0, TAU), breaks, ROWS, &node), rows)
    }

    fn load_of_law(&self, law: &Law) -> (Load, Vec<Node>) {
        self.load(law.breaks(), &|x| law.svaj(x))
    }

    /// The clock of a law.
    fn of_law(&self, law: &Law, near: Option<&Motion>) -> Result<Motion> {
        let (load, rows) = self.load_of_law(law);
        self.run(&load, &rows, near)
    }

    fn run(&self, load: &Load, rows: &[Node], near: Option<&Motion>) -> Result<Motion> {
        let run = periodic(load, rows, self.motor, self.drive.speed, near);
        run.map_err(|e| e.at_key("machine.motor"))
    }

    /// The clock of the motion in time that a law makes at constant speed.
    fn settled(&self, law: &Law, first: Motion) -> Result<Motion> {
        let mut clocks: Clocks = (None, first);
        for _ in 0..CLOCK_ROUNDS {
            let (load, rows) = self.load(&[], &|x| told(law, &clocks, x));
            let next = self.run(&load, &rows, Some(&clocks.1))?;
            let pairs = next.speed.iter().zip(&clocks.1.speed);
            let change = pairs.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            clocks.1 = next;
            if change < SAME_CLOCK * self.drive.speed {
                break;
            }
        }
        Ok(clocks.1)
    }

    /// The problem for the clock that runs now; the law was designed for the one before.
    fn corrected(&self, problem: &Problem, law: &Law, clocks: &Clocks) -> Problem {
        let (clock, mean) = (&clocks.1, self.drive.speed);
        let angles = || (0..SAMPLES).map(|i| TAU * i as f64 / SAMPLES as f64);
        let mut extra: [Vec<f64>; 3] = Default::default();
        for x in angles() {
            let [_, rate, bend] = clock.phase(x);
            let w = mean / rate;
            let acceleration = -bend * w * w * w / mean;
            let at = told(law, clocks, x);
            let velocity = (w - mean) * at.v;
            let inertia = (w * w - mean * mean) * at.a + acceleration * at.v;
            let force = self.drive.damping * velocity + self.drive.mass * inertia;
            for (list, value) in extra.iter_mut().zip([force, velocity, inertia]) {
                list.push(value);
            }
        }
        let phases: Vec<f64> = angles().map(|x| clock.phase(x)[0]).collect();
        problem.on_shaft(&phases, &extra)
    }

    /// Force error over time of a law under its clock.
    fn error(&self, law: &Law, clock: &Motion) -> Option<InTime> {
        let nodes: Vec<Svaj> = (0..ROWS).map(|i| law.svaj(angle(i))).collect();
        let forces = clock.forces(&self.drive, &nodes);
        let period = TAU / self.drive.speed;
        let target = self.target.as_ref()?;
        Some(error_in_time(
            &forces,
            &clock.speed,
            &clock.time,
            period,
            target,
        ))
    }

    /// Force error of a law where the machine differs.
    fn sensitivity(&self, law: &Law, own: &Motion) -> Vec<Sensitivity> {
        let (load, rows) = self.load_of_law(law);
        let percent = |motor: Motor| {
            let clock = periodic(&load, &rows, &motor, self.drive.speed, Some(own)).ok()?;
            Some(self.error(law, &clock)?.rms_error_percent_of_mean)
        };
        let both = |key, changed: &dyn Fn(f64) -> Motor| Sensitivity {
            key,
            percent: [1.0 - DEVIATION, 1.0 + DEVIATION].map(|part| percent(changed(part))),
        };
        let free = Motor {
            nominal: None,
            ..self.motor.clone()
        };
        let inertia = |part: f64| Motor {
            inertia: part * free.inertia,
            ..free.clone()
        };
        let line = |part: f64| free.with_torque(part);
        let friction = |part: f64| Motor {
            friction: part * free.friction,
            ..free.clone()
        };
        let mut out = vec![
            both("machine.inertia", &inertia),
            both("machine.motor", &line),
        ];
        if free.friction > 0.0 {
            out.push(both("machine.friction_torque", &friction));
        }
        out
    }
}

/// Equal angles of the clock, rad.
fn angle(i: usize) -> f64 {
    TAU * i as f64 / ROWS as f64
}

/// The law that makes by the clock that runs now the motion in time that `law` makes by the clock before: s(ψ(x)) with
/// φ₀(ψ) = φ₁(x).
fn told(law: &Law, (before, now): &Clocks, x: f64) -> Svaj {
    let [phase, rate, bend] = now.phase(x);
    let (mut psi, mut first, mut second) = (phase, rate, bend);
    if let Some(before) = before {
        psi = x;
        let mut own = before.phase(psi);
        for _ in 0..4 {
            psi -= (own[0] - phase) / own[1];
            own = before.phase(psi);
        }
        first = rate / own[1];
        second = (bend - own[2] * first * first) / own[1];
    }
    let at = law.svaj(psi);
    Svaj {
        s: at.s,
        v: at.v * first,
        a: at.a * first * first + at.v * second,
        j: 0.0,
    }
}
