//! Maximum Hertz pressure between cam and follower: p² = N κ E*/(π L), with normal force N, relative curvature κ, contact modulus E* and contact
//! length L (theory §10).

use std::f64::consts::PI;

use super::finished::GEOMETRY;
use crate::cam::{BarrelGroove, Cam, Follower, Wall};
use crate::drive::Drive;
use crate::dynamics::rigid::touch::touch;
use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly, bernstein, stand_in};
use crate::problem::{Problem, sum};

/// Maximum number of iterations for the maximum of F/ρ, the quotient of contact force and radius of curvature. Usually three or four
/// iterations are sufficient.
const ROUNDS: usize = 40;
/// Relative increase of the quotient F/ρ below which the iteration has converged.
const SETTLED: f64 = 1e-14;

/// Data for the Hertz pressure: force, law that determines the force, and dimensions of the contact.
#[derive(Debug, Clone, Copy)]
pub struct Press<'a> {
    /// Drive, which relates lift and force.
    pub drive: &'a Drive,
    /// Thickness of the plate, m.
    pub thickness: f64,
    /// Contact modulus of cam and follower, Pa.
    pub modulus: f64,
    /// Law that determines the force.
    pub law: &'a Law,
    /// Force added by a varying speed or a floor, N; `None` for a rigid machine at constant speed.
    pub extra: Option<&'a PiecewisePoly>,
}

impl<'a> Press<'a> {
    /// Data of a problem. `law` determines the force.
    pub fn of(problem: &'a Problem, law: &'a Law) -> Self {
        Press {
            drive: &problem.drive,
            thickness: problem.cam.thickness,
            modulus: problem.cam.contact_modulus(),
            law,
            extra: problem.on_shaft.as_ref().map(|shaft| &shaft.extra.force),
        }
    }

    /// Contact force as a function of the angle, N.
    fn force_curve(&self) -> PiecewisePoly {
        let own = self.drive.force_curve(self.law);
        self.extra
            .map_or_else(|| own.clone(), |extra| sum(&own, extra))
    }

    /// Maximum pressure over all contacts, Pa. For a conjugate pair, the second cam is included at the angles where it is loaded. For a
    /// groove, both walls are included, at floor and rim. `None` if a profile is undercut.
    pub fn worst(
        &self,
        cam: &Cam,
        second: Option<&Cam>,
        groove: Option<&BarrelGroove>,
    ) -> Option<Extreme> {
        if let Some(groove) = groove {
            return self.in_groove(cam, groove);
        }
        let first = on_profile(cam, || self.on(cam))?;
        let Some(second) = second.filter(|_| self.pulls()) else {
            return Some(first);
        };
        let bears = || self.square_root(second, -1.0, &contact(second));
        Some(higher(first, on_profile(second, bears)?))
    }

    /// Maximum pressure on a cam where the force is positive, Pa; infinite for a knife edge.
    pub fn on(&self, cam: &Cam) -> Extreme {
        let follower = &cam.follower;
        if !follower.is_flat() && follower.roller_radius() == 0.0 {
            // The contact of a knife edge has no width, so its pressure is infinite.
            return Extreme {
                at: cam.law.extent().0,
                value: f64::INFINITY,
            };
        }
        match *follower {
            Follower::FlatTranslating { base_radius } => self.under_flat_face(cam, base_radius),
            _ => self.square_root(cam, 1.0, &contact(cam)),
        }
    }

    /// Whether the force is negative anywhere.
    fn pulls(&self) -> bool {
        match self.extra {
            None => self.drive.force_extremes(self.law).0.value < 0.0,
            Some(_) => self.force_curve().extremes().0.value < 0.0,
        }
    }

    fn factor(&self) -> f64 {
        self.modulus / (PI * self.thickness)
    }

    /// Maximum pressure on a cam, Pa: the square root of the maximum p². The contact force is `sign` times the force of the law. `bearing`
    /// computes normal force and relative curvature from the motion of the cam and the contact force.
    fn square_root(
        &self,
        cam: &Cam,
        sign: f64,
        bearing: &dyn Fn(Svaj, f64) -> (f64, f64),
    ) -> Extreme {
        let factor = self.factor();
        let own = cam.law.breaks();
        let alike = self.law.breaks() == own;
        // The added force is smooth only between its own breaks, so these breaks are included.
        let cut = self
            .extra
            .map(|extra| cam.law.poly().cut_at(extra.breaks()));
        let breaks = cut.as_ref().map_or(own, |cut| cut.breaks());
        let square = stand_in(breaks, 1e-12, |i, x| {
            let middle = 0.5 * (breaks[i] + breaks[i + 1]);
            let i = if cut.is_none() {
                i
            } else {
                own.partition_point(|b| *b <= middle) - 1
            };
            let u = (x - own[i]) / (own[i + 1] - own[i]);
            let pressing = if alike {
                self.law.svaj_on(i, u)
            } else {
                self.law.svaj(x)
            };
            let extra = self.extra.map_or(0.0, |extra| extra.eval(x));
            let force = sign * (self.drive.force(pressing) + extra);
            let (normal, curvature) = bearing(cam.law.svaj_on(i, u), force);
            factor * normal * curvature
        })
        .extremes()
        .1;
        root(square)
    }

    /// Maximum pressure under a flat face, Pa, by Dinkelbach's method for the maximum of F/ρ. The radius of curvature ρ = Rb + s + a is
    /// linear in the law. At the maximum of F − λρ, the quotient F/ρ is at least λ. This quotient is the next λ, until λ converges.
    fn under_flat_face(&self, cam: &Cam, base_radius: f64) -> Extreme {
        let force = self.force_curve();
        let radius = cam.law.combination([1.0, 0.0, 1.0, 0.0], base_radius);
        let radius = radius.cut_at(force.breaks());
        let force = force.cut_at(radius.breaks());
        let degree = force.degree().max(radius.degree());
        let alike = |p: PiecewisePoly| p.map(degree, |b, _| b.to_vec());
        let (force, radius) = (alike(force), alike(radius));
        let (mut at, mut most) = highest_at_ends(&force, &radius);
        let mut left: Vec<usize> = (0..force.pieces()).collect();
        for _ in 0..ROUNDS {
            let next = most_gained(&force, &radius, most, &mut left).unwrap_or(at);
            let higher = quotient(&force, &radius, next);
            if higher <= most * (1.0 + SETTLED) {
                break;
            }
            (at, most) = (next, higher);
        }
        root(Extreme {
            at,
            value: self.factor() * most,
        })
    }

    /// Maximum pressure on the walls of a groove, Pa, at its floor and its rim. Each wall is included at the angles where its roller is
    /// loaded. `None` if a wall is undercut.
    fn in_groove(&self, cam: &Cam, groove: &BarrelGroove) -> Option<Extreme> {
        let (floor, rim) = groove.depth();
        let walls = [(Wall::Lower, 1.0), (Wall::Upper, -1.0)];
        let count = if self.pulls() { 2 } else { 1 };
        let mut worst: Option<Extreme> = None;
        for (wall, sign) in &walls[..count] {
            for radius in [floor, rim] {
                if groove.smallest_bulge(radius, *wall).value <= 0.0 {
                    return None;
                }
                let here = self.square_root(cam, *sign, &|at, force| {
                    groove_contact(groove, radius, *wall, at, force)
                });
                worst = Some(worst.map_or(here, |w| higher(w, here)));
            }
        }
        worst
    }
}

/// Maximum pressure on a profile. `None` if the profile is undercut, and infinite if it has a cusp. Otherwise `pressure` computes it.
fn on_profile(cam: &Cam, pressure: impl FnOnce() -> Extreme) -> Option<Extreme> {
    let convex = cam.curvature().convex;
    if convex.value <= 0.0 {
        return None;
    }
    if convex.value <= GEOMETRY * cam.follower.prime_radius() {
        return Some(convex.map(|_| f64::INFINITY));
    }
    Some(pressure())
}

/// Function that computes normal force, N, and relative curvature, 1/m, from the motion of a cam and the contact force.
fn contact(cam: &Cam) -> impl Fn(Svaj, f64) -> (f64, f64) {
    let follower = cam.follower;
    move |at, force| {
        let here = touch(&follower, 1.0, 0.0, at, force);
        (here.normal, here.curvature)
    }
}

/// Normal force, N, and relative curvature of roller and wall, 1/m, in a groove that is unrolled at `radius`, m.
fn groove_contact(
    groove: &BarrelGroove,
    radius: f64,
    wall: Wall,
    at: Svaj,
    force: f64,
) -> (f64, f64) {
    let slope = at.v / radius;
    let length = (1.0 + slope * slope).sqrt();
    // Curvature towards −z, where the lower wall is convex.
    let bend = -at.a / (radius * radius * length.powi(3));
    let bulge = match wall {
        Wall::Lower => bend,
        Wall::Upper => -bend,
    };
    let roller = groove.roller_radius();
    (force * length, 1.0 / (roller * (1.0 - roller * bulge)))
}

/// Maximum of F/ρ at the ends of the spans, with its position. The iteration starts from this value.
fn highest_at_ends(force: &PiecewisePoly, radius: &PiecewisePoly) -> (f64, f64) {
    let mut highest = (force.breaks()[0], f64::NEG_INFINITY);
    for (piece, ends) in force.breaks().windows(2).enumerate() {
        let (f, r) = (force.piece(piece), radius.piece(piece));
        let last = f.len() - 1;
        for (at, quotient) in [(ends[0], f[0] / r[0]), (ends[1], f[last] / r[last])] {
            if quotient > highest.1 {
                highest = (at, quotient);
            }
        }
    }
    highest
}

/// Position of the maximum of F − λρ on the spans in `left`, where λ is `quotient`; `None` if the maximum is not positive. Spans without a
/// positive value are removed from `left`, because F/ρ does not exceed λ there.
fn most_gained(
    force: &PiecewisePoly,
    radius: &PiecewisePoly,
    quotient: f64,
    left: &mut Vec<usize>,
) -> Option<f64> {
    let (mut highest, mut place) = (0.0, None);
    let mut gain = Vec::with_capacity(force.degree() + 1);
    left.retain(|&piece| {
        let both = force.piece(piece).iter().zip(radius.piece(piece));
        gain.clear();
        gain.extend(both.map(|(f, r)| f - quotient * r));
        let (start, end) = (force.breaks()[piece], force.breaks()[piece + 1]);
        bernstein::peaks_above(&gain, highest, |u, value| {
            if value > highest {
                highest = value;
                place = Some(start + u * (end - start));
            }
        });
        bernstein::hull(&gain).1 > 0.0
    });
    place
}

/// Value of F/ρ at a point. At a break between spans, it is the larger of the values on both sides.
fn quotient(force: &PiecewisePoly, radius: &PiecewisePoly, at: f64) -> f64 {
    let (i, u) = force.locate(at);
    let ends = |k: usize, u: f64| {
        let value = |p: &PiecewisePoly| bernstein::eval(p.piece(k), u);
        value(force) / value(radius)
    };
    let mut out = ends(i, u);
    let n = force.pieces();
    if u < 1e-9 {
        out = out.max(ends((i + n - 1) % n, 1.0));
    }
    if u > 1.0 - 1e-9 {
        out = out.max(ends((i + 1) % n, 0.0));
    }
    out
}

fn higher(a: Extreme, b: Extreme) -> Extreme {
    if b.value > a.value { b } else { a }
}

fn root(square: Extreme) -> Extreme {
    square.map(|value| value.max(0.0).sqrt())
}
