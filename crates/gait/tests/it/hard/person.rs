//! Forces of people with known mass, stride and movement.

use std::f64::consts::PI;

use super::dice::Dice;
use gaitcam_gait::Kind;
use gaitcam_gait::units::G;

/// Contact of one foot: start, duration and factor of the force.
#[derive(Debug, Clone, Copy)]
pub struct Step {
    pub at: f64,
    pub lasts: f64,
    pub factor: f64,
    pub left: bool,
}

/// A person with a known movement.
#[derive(Debug, Clone)]
pub struct Person {
    pub kind: Kind,
    pub mass: f64,
    /// Correct durations of a stride: the mean for each speed.
    pub strides: Vec<f64>,
    pub seconds: f64,
    /// Contacts in order of time; empty for movements without steps.
    pub steps: Vec<Step>,
    shape: Shape,
}

#[derive(Debug, Clone)]
enum Shape {
    /// Two peaks: weights of sin πx, sin 2πx and sin 3πx.
    Humps([f64; 3]),
    /// One sharp peak with an impact at its start; `impact` is its fraction.
    Hump { impact: f64 },
    /// Total force in body weights at given times.
    Total(Vec<(f64, f64)>, Sway),
}

/// Slow movement of a standing person: fraction of the weight, and frequency.
#[derive(Debug, Clone, Copy)]
struct Sway {
    part: f64,
    hertz: f64,
}

impl Person {
    /// Force of a contact at a time since its start, N.
    pub fn foot(&self, step: &Step, t: f64) -> f64 {
        let x = (t - step.at) / step.lasts;
        if !(0.0..1.0).contains(&x) {
            return 0.0;
        }
        step.factor
            * match &self.shape {
                Shape::Humps([a, b, c]) => {
                    a * (PI * x).sin() + b * (2.0 * PI * x).sin() + c * (3.0 * PI * x).sin()
                }
                Shape::Hump { impact } => {
                    (PI * x).sin() + impact * (-((x - 0.12) / 0.05).powi(2)).exp()
                }
                Shape::Total(..) => 0.0,
            }
    }

    /// Impulse of a contact, N s.
    pub fn impulse(&self, step: &Step) -> f64 {
        let n = 400;
        let at = |i: i32| step.at + step.lasts * (f64::from(i) + 0.5) / f64::from(n);
        let mean = (0..n).map(|i| self.foot(step, at(i))).sum::<f64>() / f64::from(n);
        mean * step.lasts
    }

    /// Force of the contacts that satisfy `on`, N.
    pub fn feet(&self, t: f64, on: impl Fn(usize, &Step) -> bool) -> f64 {
        // Steps stand in order of time; few reach over any moment.
        let past = self.steps.partition_point(|s| s.at <= t);
        let near = self.steps[..past].iter().enumerate().rev().take(8);
        near.filter(|(i, s)| on(*i, s))
            .map(|(_, s)| self.foot(s, t))
            .sum()
    }

    /// Total force of both feet, N.
    pub fn total(&self, t: f64) -> f64 {
        let Shape::Total(points, sway) = &self.shape else {
            return self.feet(t, |_, _| true);
        };
        let after = points.partition_point(|p| p.0 <= t);
        let level = match (after.checked_sub(1).map(|i| points[i]), points.get(after)) {
            (Some(a), Some(b)) => {
                let x = (t - a.0) / (b.0 - a.0);
                // Level at both ends, as muscles move a body.
                a.1 + (b.1 - a.1) * 0.5 * (1.0 - (PI * x).cos())
            }
            (Some(a), None) => a.1,
            (None, Some(b)) => b.1,
            (None, None) => 0.0,
        };
        let moved = 1.0 + sway.part * (2.0 * PI * sway.hertz * t).sin();
        self.mass * G * (level * if level > 0.3 { moved } else { 1.0 }).max(0.0)
    }
}

impl Person {
    /// Scales the contacts of each speed so that the impulse of both feet over a stride is M g T.
    fn carry_the_weight(&mut self, speeds: &[(f64, f64, f64)]) {
        let unit = Step {
            at: 0.0,
            lasts: 1.0,
            factor: 1.0,
            left: true,
        };
        let area = (0..400)
            .map(|i| self.foot(&unit, (f64::from(i) + 0.5) / 400.0))
            .sum::<f64>()
            / 400.0;
        let mut from = 0.0;
        for &(stride, duty, lasts) in speeds {
            let own = (self.steps.iter_mut()).filter(|s| s.at >= from && s.at < from + lasts);
            for s in own {
                s.factor *= self.mass * G / (2.0 * duty * area);
                s.factor *= stride * duty / s.lasts;
            }
            from += lasts;
        }
    }
}

/// Contacts at one speed after another: durations of strides, and fraction of each stride in which a foot is on the ground.
fn gait(
    dice: &mut Dice,
    kind: Kind,
    mass: f64,
    speeds: &[(f64, f64, f64)],
    shape: Shape,
    asymmetry: f64,
) -> Person {
    let mut steps: Vec<Step> = Vec::new();
    let mut strides = Vec::new();
    let wobble = 0.004;
    let mut at = 0.0;
    for &(stride, duty, lasts) in speeds {
        let end = at + lasts;
        let mut left = true;
        let first = at;
        let mut count = 0.0;
        while at < end {
            let own = stride * (1.0 + wobble * dice.normal());
            let half = if left {
                0.5 + asymmetry
            } else {
                0.5 - asymmetry
            };
            steps.push(Step {
                at,
                lasts: duty * stride * (1.0 + wobble * dice.normal()),
                factor: 1.0 + 0.015 * dice.normal(),
                left,
            });
            at += half * own;
            count += half;
            left = !left;
        }
        strides.push((at - first) / count);
    }
    let mut person = Person {
        kind,
        mass,
        strides,
        seconds: at,
        steps,
        shape,
    };
    person.carry_the_weight(speeds);
    person
}

/// Two peaks as in measurements: the valley is 0.55 to 0.9 of the peaks; either peak may be the higher one.
fn humps(dice: &mut Dice) -> Shape {
    Shape::Humps([1.0, dice.between(-0.06, 0.06), dice.between(0.12, 0.36)])
}

/// A person of 30 to 115 kg who walks at a constant speed.
pub fn walker(dice: &mut Dice, seconds: f64) -> Person {
    let stride = dice.between(0.92, 1.42);
    let duty = 0.615 + 0.12 * (stride - 1.1) + dice.between(-0.015, 0.015);
    let shape = humps(dice);
    let mass = dice.between(45.0, 110.0);
    let asymmetry = dice.between(-0.004, 0.004);
    gait(
        dice,
        Kind::Walking,
        mass,
        &[(stride, duty, seconds)],
        shape,
        asymmetry,
    )
}

/// A child of 14 to 30 kg.
pub fn child(dice: &mut Dice, seconds: f64) -> Person {
    let stride = dice.between(0.66, 0.95);
    let shape = humps(dice);
    let mass = dice.between(14.0, 30.0);
    gait(
        dice,
        Kind::Walking,
        mass,
        &[(stride, 0.6, seconds)],
        shape,
        0.0,
    )
}

/// A person with steps of 1.9 to 2.6 s.
pub fn slow_walker(dice: &mut Dice, seconds: f64) -> Person {
    let stride = dice.between(2.3, 3.4);
    let shape = Shape::Humps([1.0, 0.0, dice.between(0.2, 0.3)]);
    let mass = dice.between(50.0, 100.0);
    gait(
        dice,
        Kind::Walking,
        mass,
        &[(stride, 0.72, seconds)],
        shape,
        0.0,
    )
}

/// A limping person, whose steps have two durations.
pub fn limper(dice: &mut Dice, seconds: f64) -> Person {
    let stride = dice.between(1.05, 1.4);
    let shape = humps(dice);
    let mass = dice.between(50.0, 100.0);
    let asymmetry = dice.of(&[-1.0, 1.0]) * dice.between(0.02, 0.045);
    gait(
        dice,
        Kind::Walking,
        mass,
        &[(stride, 0.64, seconds)],
        shape,
        asymmetry,
    )
}

/// A person whose speed changes stepwise.
pub fn changing(dice: &mut Dice) -> Person {
    let shape = humps(dice);
    let mass = dice.between(50.0, 100.0);
    let (slow, fast) = (dice.between(1.35, 1.6), dice.between(0.92, 1.08));
    let mut parts = vec![
        (slow, 0.66, dice.between(8.0, 14.0)),
        (fast, 0.6, dice.between(8.0, 14.0)),
    ];
    if dice.chance(50.0) {
        parts.reverse();
    }
    gait(dice, Kind::Walking, mass, &parts, shape, 0.0)
}

/// A jogger or a sprinter.
pub fn runner(dice: &mut Dice, seconds: f64) -> Person {
    let (stride, duty) = if dice.chance(30.0) {
        (dice.between(0.42, 0.52), dice.between(0.24, 0.3))
    } else {
        (dice.between(0.62, 0.78), dice.between(0.3, 0.42))
    };
    let shape = Shape::Hump {
        impact: dice.between(0.0, 0.35),
    };
    let mass = dice.between(50.0, 95.0);
    gait(
        dice,
        Kind::Running,
        mass,
        &[(stride, duty, seconds)],
        shape,
        0.0,
    )
}

/// A person without steps.
fn still(kind: Kind, mass: f64, points: Vec<(f64, f64)>, sway: Sway) -> Person {
    Person {
        kind,
        mass,
        strides: Vec::new(),
        seconds: points.last().map_or(0.0, |p| p.0),
        steps: Vec::new(),
        shape: Shape::Total(points, sway),
    }
}

fn sway(dice: &mut Dice) -> Sway {
    Sway {
        part: dice.between(0.004, 0.03),
        hertz: dice.between(0.2, 1.2),
    }
}

/// A person who stands.
pub fn stander(dice: &mut Dice) -> Person {
    let mass = dice.between(45.0, 110.0);
    let seconds = dice.between(5.0, 12.0);
    let sway = sway(dice);
    still(Kind::Standing, mass, vec![(0.0, 1.0), (seconds, 1.0)], sway)
}

/// A person who stands, jumps at least once, and lands.
pub fn jumper(dice: &mut Dice) -> Person {
    let mass = dice.between(45.0, 100.0);
    let mut points = vec![(0.0, 1.0)];
    let mut t = dice.between(1.2, 2.5);
    for _ in 0..dice.of(&[1, 1, 2, 3]) {
        let push = dice.between(1.9, 2.6);
        let air = dice.between(0.25, 0.5);
        points.extend([
            (t, 1.0),
            (t + 0.25, 0.45),
            (t + 0.55, push),
            (t + 0.68, 0.0),
        ]);
        t += 0.68 + air;
        points.extend([
            (t, 0.0),
            (t + 0.07, dice.between(2.8, 5.0)),
            (t + 0.3, 0.7),
            (t + 0.6, 1.0),
        ]);
        t += dice.between(1.2, 2.2);
    }
    points.push((t, 1.0));
    let sway = sway(dice);
    still(Kind::Jumping, mass, points, sway)
}

/// A person who hops on the spot, with alternating contact and flight.
pub fn hopper(dice: &mut Dice) -> Person {
    let mass = dice.between(45.0, 95.0);
    let (contact, air) = (dice.between(0.18, 0.42), dice.between(0.2, 0.45));
    // Impulse over a hop is M g T; the cosine ramps of `total` make a hump of mean one half.
    let top = 2.0 * (contact + air) / contact;
    let mut points = vec![(0.0, 0.0)];
    let mut t = 0.4;
    for _ in 0..14 {
        points.extend([(t, 0.0), (t + 0.5 * contact, top), (t + contact, 0.0)]);
        t += contact + air;
    }
    points.push((t + 0.4, 0.0));
    let none = Sway {
        part: 0.0,
        hertz: 1.0,
    };
    still(Kind::Jumping, mass, points, none)
}

/// A person who rises from a chair, and possibly sits down again.
pub fn riser(dice: &mut Dice) -> Person {
    let mass = dice.between(45.0, 110.0);
    let seat = dice.between(0.1, 0.3);
    let mut points = vec![(0.0, seat)];
    let mut t = dice.between(0.8, 2.0);
    for _ in 0..dice.of(&[1, 2, 3, 5]) {
        points.extend([
            (t, seat),
            (t + 0.5, dice.between(1.12, 1.35)),
            (t + 0.9, 0.85),
            (t + 1.3, 1.0),
        ]);
        t += 1.3 + dice.between(0.8, 2.0);
        points.push((t, 1.0));
        if dice.chance(70.0) {
            points.extend([(t + 0.5, 0.8), (t + 0.9, 1.15), (t + 1.4, seat)]);
            t += 1.4 + dice.between(0.6, 1.5);
        }
    }
    points.push((t, points[points.len() - 1].1));
    let sway = sway(dice);
    still(Kind::SitToStand, mass, points, sway)
}

/// A person who bends the knees repeatedly.
pub fn squatter(dice: &mut Dice) -> Person {
    let mass = dice.between(45.0, 100.0);
    let turn = dice.between(1.4, 3.0);
    let swing = dice.between(0.15, 0.5);
    let mut points = vec![(0.0, 1.0)];
    let mut t = 1.0;
    for _ in 0..8 {
        points.extend([(t, 1.0), (t + 0.25 * turn, 1.0 - swing)]);
        points.extend([(t + 0.6 * turn, 1.0 + swing), (t + 0.95 * turn, 1.0)]);
        t += turn;
    }
    points.push((t + 1.0, 1.0));
    let sway = sway(dice);
    still(Kind::Other, mass, points, sway)
}
