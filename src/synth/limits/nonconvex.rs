//! All nonconvex limits of a problem: limits of the profile, and limits of shaft and contact.

use super::diameter::Diameter;
use super::loads::Loads;
use super::profile::Profile;
use super::slack::{ProfileSize, Slack};
use crate::cam::{Criterion, LimitKind};
use crate::law::{Law, Svaj};
use crate::poly::{PiecewisePoly, stand_ins_for_differences};
use crate::problem::Problem;

/// Relative enlargement of the cam at the end of a sequence of convex programs, so that the curvature limit is satisfied up to rounding
/// errors.
pub const ENLARGED: f64 = 4e-6;

/// All limits of a problem that are not convex in the law.
#[derive(Debug, Clone)]
pub struct NonconvexLimits {
    /// Nonconvex limits of the profile.
    pub profile: Option<Profile>,
    /// Nonconvex limit on the diameter.
    pub diameter: Option<Diameter>,
    /// Nonconvex limits of shaft and contact.
    pub loads: Option<Loads>,
}

impl NonconvexLimits {
    /// Limits that a convex program cannot express; `None` if there are none.
    pub fn of(problem: &Problem) -> Option<NonconvexLimits> {
        let profile = Profile::of(problem);
        let under_roller = matches!(profile, Some(Profile::Roller(_)));
        let loads = Loads::of(problem, under_roller);
        let diameter = Diameter::of(problem);
        let any = profile.is_some() || diameter.is_some() || loads.is_some();
        any.then_some(NonconvexLimits {
            profile,
            diameter,
            loads,
        })
    }

    /// Clearances h of all limits at a point of the law. A limit is satisfied if h ≥ 0.
    pub fn slacks(&self, at: Svaj, theta: f64) -> Vec<Slack> {
        let mut out = self.profile.map_or_else(Vec::new, |f| f.slacks(at));
        out.extend(self.diameter.map(|d| d.slack(at, self.size())));
        if let Some(loads) = &self.loads {
            loads.slacks(at, theta, self.size(), &mut out);
        }
        out
    }

    /// Size of the cam for the limits of the profile. Without such limits, all values are 0.
    pub fn size(&self) -> ProfileSize {
        self.profile.map(|f| f.size()).unwrap_or_default()
    }

    /// Names of all limits.
    pub fn names(&self) -> Vec<Criterion> {
        let mut out: Vec<Criterion> = Vec::new();
        for slack in self.slacks(Svaj::default(), 0.0) {
            if !out.contains(&slack.name) {
                out.push(slack.name);
            }
        }
        out
    }

    /// The limits whose names `kept` selects.
    pub fn only(&self, kept: impl Fn(Criterion) -> bool) -> Self {
        let left_out = |loads: Loads| {
            let named = loads.named().into_iter();
            named
                .filter(|l| !kept(l.0.into()))
                .fold(loads, |loads, (name, _)| loads.with(name, None))
        };
        NonconvexLimits {
            profile: self.profile.and_then(|p| p.only(&kept)),
            diameter: self.diameter.filter(|_| kept(LimitKind::Diameter.into())),
            loads: self.loads.clone().map(left_out),
        }
    }

    /// The limits for a cam of another size.
    pub fn at_size(&self, size: ProfileSize) -> Self {
        NonconvexLimits {
            profile: self.profile.map(|f| f.at_size(size)),
            diameter: self.diameter,
            loads: self.loads.clone(),
        }
    }
}

/// Relative clearances h/w as functions of the angle, where w is the scale of h. The list has one piecewise polynomial for each limit.
pub fn relative(law: &Law, limits: &NonconvexLimits) -> Vec<PiecewisePoly> {
    let own = law.breaks();
    let on_shaft = limits.loads.as_ref().and_then(|l| l.on_shaft.as_ref());
    // The force that a varying speed adds is smooth only between its own breaks, so these breaks are included.
    let extra = on_shaft.map(|shaft| law.poly().cut_at(shaft.extra.force.breaks()));
    let breaks = extra.as_ref().map_or(own, |cut| cut.breaks());
    let pieces: Vec<usize> = (breaks.windows(2))
        .map(|ends| own.partition_point(|b| *b <= 0.5 * (ends[0] + ends[1])) - 1)
        .collect();
    let place = |i: usize, x: f64| {
        let piece = pieces[i];
        law.svaj_on(piece, (x - own[piece]) / (own[piece + 1] - own[piece]))
    };
    let first = limits.slacks(place(0, breaks[0]), breaks[0]);
    let terms: Vec<f64> = first.iter().map(|s| (s.largest / s.w).abs()).collect();
    stand_ins_for_differences(breaks, 1e-11, &terms, |i, x| {
        let slacks = limits.slacks(place(i, x), x);
        slacks.iter().map(|s| s.h / s.w).collect()
    })
}

/// Minimum relative clearance h/w over the law, one value for each limit.
pub fn clearances(law: &Law, limits: &NonconvexLimits) -> Vec<f64> {
    let curves = relative(law, limits);
    curves.iter().map(|c| c.extremes().0.value).collect()
}

/// Minimum clearance h/w of the load limits over the law; ∞ without load limits.
pub fn loaded(law: &Law, limits: &NonconvexLimits) -> f64 {
    let names: Vec<Criterion> = limits
        .loads
        .iter()
        .flat_map(|l| l.named())
        .map(|n| n.0.into())
        .collect();
    let first = limits.slacks(law.svaj_on(0, 0.0), law.breaks()[0]);
    relative(law, limits)
        .iter()
        .zip(first)
        .filter(|(_, slack)| names.contains(&slack.name))
        .fold(f64::INFINITY, |m, (curve, _)| {
            m.min(curve.extremes().0.value)
        })
}
