//! Programmes: a law put together from motions, segment after segment.

use super::{Joint, Law, Rise, Svaj, pieces::Pieces, rise::joining};
use crate::error::{Error, Result};
use std::f64::consts::{PI, TAU};

/// One motion of a programme.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// Shape of the motion.
    pub motion: Rise,
    /// How far the follower moves: positive rises, negative falls, 0 for a dwell; m (rad when oscillating).
    pub lift: f64,
    /// How long it takes: rad of cam angle, m of travel for a translating cam.
    pub angle: f64,
}

/// What a programme fills.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// Whole turns (several: a barrel cam); the law repeats after them.
    Turns(usize),
    /// A length of travel, m (translating cam); the law ends where it ends.
    Length(f64),
}

impl Extent {
    /// One turn.
    pub const TURN: Extent = Extent::Turns(1);

    fn length(self) -> f64 {
        match self {
            Extent::Turns(n) => TAU * n as f64,
            Extent::Length(l) => l,
        }
    }

    fn is_closed(self) -> bool {
        !matches!(self, Extent::Length(_))
    }

    /// A length of the programme in the user's words.
    fn words(self, x: f64) -> String {
        match self {
            Extent::Length(_) => format!("{:.6} mm", 1e3 * x),
            _ => format!("{:.6}°", x.to_degrees()),
        }
    }
}

/// Segment lengths may miss the whole by this share of it, as rounded degrees do; they are then stretched.
const ROUNDING: f64 = 1e-6;
/// Jumps below this share of the largest value of their derivative are rounding.
const JUMP: f64 = 1e-9;

/// The law of a programme that starts at lift 0 at θ = 0, every joint without a jump of lift or velocity.
///
/// Fails, naming the segment, when lengths do not fill the extent, the lift does not return or leaves the
/// base circle downwards, a motion cannot join its neighbour, or two general polynomials are neighbours.
/// Jumps of acceleration pass (CAM-DAS: not for high speed); [`Law::joints`] lists them.
pub fn program(segments: &[Segment], extent: Extent) -> Result<Law> {
    let draft = draft(segments, extent)?;
    check_joints(&draft, segments, extent)?;
    check_base_circle(&draft, segments, extent)?;
    Ok(draft.law)
}

/// As [`program`], but lets jumps of lift and velocity and falls below the base circle pass: for showing
/// what is wrong with a law.
pub fn assemble(segments: &[Segment], extent: Extent) -> Result<Law> {
    Ok(draft(segments, extent)?.law)
}

/// The law of a constant-breadth (flat faces) or constant-diameter (rollers) cam: `half` describes the
/// first half turn, from lift 0 to the full lift L; the second half is L − s(θ − π), so that
/// s(θ) + s(θ + π) = L everywhere and two parallel faces 2·Rb + L apart both touch.
pub fn constant_breadth(half: &[Segment]) -> Result<Law> {
    let total: f64 = half.iter().map(|s| s.angle).sum();
    if (total - PI).abs() > ROUNDING * PI {
        return Err(Error::new(format!(
            "the half turn of a constant-breadth cam covers {:.6}°",
            total.to_degrees()
        ))
        .help("its segments must add to 180°; the other half follows from the breadth"));
    }
    if let Some(i) = half
        .iter()
        .position(|s| s.motion.general_degree().is_some())
    {
        return Err(Error::new(format!(
            "segment {} of the half turn is a general polynomial, whose neighbour is not yet known",
            i + 1
        ))
        .help("use 3-4-5 or 4-5-6-7"));
    }
    let first = assemble(half, Extent::Length(total))?;
    let lift: f64 = half.iter().map(|s| s.lift).sum();
    let (low, high) = first.extremes(0);
    let slack = JUMP * lift.abs();
    if lift <= 0.0 || low.value < -slack || high.value > lift + slack {
        return Err(Error::new(format!(
            "the half turn of a constant-breadth cam must lead from 0 to its largest lift, but it leads to {lift:.6} between {:.6} and {:.6} m",
            low.value, high.value
        ))
        .help("let the lift stay between 0 and the lift at 180°"));
    }
    let mut pieces = Pieces::starting_at(0.0);
    pieces.push_shape(&first, PI, 0.0, 1.0, false);
    pieces.push_shape(&first, PI, lift, -1.0, false);
    pieces.end_exactly_at(TAU);
    let law = finished(pieces, true)?;
    let mirrored = half.iter().map(|s| Segment {
        lift: -s.lift,
        ..s.clone()
    });
    let segments: Vec<Segment> = half.iter().cloned().chain(mirrored).collect();
    let ends = ends_of(&segments, TAU / (2.0 * total));
    let draft = Draft { law, ends };
    check_joints(&draft, &segments, Extent::TURN)?;
    Ok(draft.law)
}

/// A law with the angles at which its segments end.
struct Draft {
    law: Law,
    ends: Vec<f64>,
}

impl Draft {
    /// Number (from 1) of the segment that starts at `at`.
    fn starting(&self, at: f64) -> Option<usize> {
        let near = |x: f64| (x - at).abs() <= 1e-9;
        if near(0.0) {
            return Some(1);
        }
        self.ends.iter().position(|&e| near(e)).map(|i| i + 2)
    }

    /// Number (from 1) of the segment that holds `at`.
    fn holding(&self, at: f64) -> usize {
        self.ends
            .partition_point(|&e| e < at - 1e-9)
            .min(self.ends.len() - 1)
            + 1
    }
}

fn ends_of(segments: &[Segment], stretch: f64) -> Vec<f64> {
    segments
        .iter()
        .scan(0.0, |sum, s| {
            *sum += s.angle * stretch;
            Some(*sum)
        })
        .collect()
}

fn finished(pieces: Pieces, closed: bool) -> Result<Law> {
    pieces
        .finish(closed)
        .ok_or_else(|| Error::new("a programme needs at least one segment"))
}

fn draft(segments: &[Segment], extent: Extent) -> Result<Draft> {
    let total = check_lengths(segments, extent)?;
    let stretch = extent.length() / total;
    check_general(segments, extent)?;
    let shapes: Vec<Option<Law>> = segments
        .iter()
        .map(|s| {
            if s.motion.general_degree().is_some() {
                Ok(None)
            } else {
                s.motion.law().map(Some)
            }
        })
        .collect::<Result<_>>()?;
    let mut pieces = Pieces::starting_at(0.0);
    let mut height = 0.0;
    let n = segments.len();
    for (i, s) in segments.iter().enumerate() {
        let width = s.angle * stretch;
        match (&shapes[i], s.motion.general_degree()) {
            (Some(shape), _) => {
                let mirrored = s.lift < 0.0 && s.motion.mirrors();
                pieces.push_shape(shape, width, height, s.lift, mirrored);
            }
            (None, degree) => {
                let neighbour = |k: Option<usize>, at_end: bool| match k {
                    Some(k) => end_of(
                        &segments[k],
                        shapes[k].as_ref(),
                        segments[k].angle * stretch,
                        at_end,
                    ),
                    None => Svaj::default(),
                };
                let (before, after) = if extent.is_closed() {
                    (Some((i + n - 1) % n), Some((i + 1) % n))
                } else {
                    (i.checked_sub(1), (i + 1 < n).then_some(i + 1))
                };
                let mut start = neighbour(before, true);
                let mut end = neighbour(after, false);
                start.s = height;
                end.s = height + s.lift;
                let poly = joining(degree.unwrap_or(5), start, end, width)?;
                let shape = Law::from_poly(poly, false);
                pieces.push_shape(&shape, width, 0.0, 1.0, false);
            }
        }
        height += s.lift;
    }
    pieces.end_exactly_at(extent.length());
    Ok(Draft {
        law: finished(pieces, extent.is_closed())?,
        ends: ends_of(segments, stretch),
    })
}

/// v, a and j of a segment at its end (or start), by cam angle.
fn end_of(segment: &Segment, shape: Option<&Law>, width: f64, at_end: bool) -> Svaj {
    let Some(shape) = shape else {
        return Svaj::default();
    };
    let mut pieces = Pieces::starting_at(0.0);
    let mirrored = segment.lift < 0.0 && segment.motion.mirrors();
    pieces.push_shape(shape, width, 0.0, segment.lift, mirrored);
    let Some(law) = pieces.finish(false) else {
        return Svaj::default();
    };
    if at_end {
        law.svaj_on(law.poly().pieces() - 1, 1.0)
    } else {
        law.svaj_on(0, 0.0)
    }
}

fn check_lengths(segments: &[Segment], extent: Extent) -> Result<f64> {
    if segments.is_empty() {
        return Err(Error::new("a programme needs at least one segment"));
    }
    let length = extent.length();
    if !(length.is_finite() && length > 0.0) {
        return Err(Error::new(format!(
            "a programme cannot fill an extent of {length}"
        )));
    }
    for (i, s) in segments.iter().enumerate() {
        let name = name(segments, i);
        if !s.lift.is_finite() || !s.angle.is_finite() {
            return Err(Error::new(format!("{name} is not given in finite numbers")));
        }
        if s.angle <= 0.0 {
            return Err(
                Error::new(format!("{name} covers {}", extent.words(s.angle)))
                    .help("every segment covers more than nothing; leave it out instead"),
            );
        }
        if s.motion == Rise::Dwell && s.lift != 0.0 {
            return Err(Error::new(format!("{name} has a lift of {} m", s.lift))
                .help("a dwell does not move: choose a motion or set the lift to 0"));
        }
    }
    let total: f64 = segments.iter().map(|s| s.angle).sum();
    let missing = length - total;
    if missing.abs() > ROUNDING * length {
        let (words, way) = if missing > 0.0 {
            (extent.words(missing), "are missing")
        } else {
            (extent.words(-missing), "are too many")
        };
        return Err(Error::new(format!(
            "the segments cover {} in place of {}: {words} {way}",
            extent.words(total),
            extent.words(length)
        ))
        .help("add a dwell or change the length of a segment"));
    }
    Ok(total)
}

fn check_general(segments: &[Segment], extent: Extent) -> Result<()> {
    let n = segments.len();
    for i in 0..n {
        let next = (i + 1) % n;
        if next == 0 && !extent.is_closed() {
            break;
        }
        let general = |k: usize| segments[k].motion.general_degree().is_some();
        if general(i) && general(next) {
            let (first, second) = (name(segments, i), name(segments, next));
            return Err(Error::new(format!(
                "{first} is a general polynomial beside another, {second}: neither knows what to join"
            ))
            .help("give one of them a motion of its own, or join the two into one"));
        }
    }
    Ok(())
}

fn check_joints(draft: &Draft, segments: &[Segment], extent: Extent) -> Result<()> {
    let (lift, velocity) = (draft.law.bound(0), draft.law.bound(1));
    for joint in draft.law.joints() {
        let Some(second) = draft.starting(joint.at) else {
            continue;
        };
        let n = segments.len();
        let (before, after) = ((second + n - 2) % n, second - 1);
        let pair = || {
            format!(
                "{} cannot join {}",
                name(segments, before),
                name(segments, after)
            )
        };
        let at = || extent.words(joint.at);
        if joint.jump.s.abs() > JUMP * lift {
            return Err(Error::new(format!(
                "{} at {}: the lift jumps by {:.6e} m",
                pair(),
                at(),
                joint.jump.s
            ))
            .help("the lifts of all segments must add to 0"));
        }
        if joint.jump.v.abs() > JUMP * velocity {
            return Err(Error::new(format!(
                "{} at {}: the velocity jumps by {:.6e} m per unit of cam travel (from {:.6e} to {:.6e})",
                pair(),
                at(),
                joint.jump.v,
                draft.before(&joint).v,
                draft.after(&joint).v
            ))
            .help(mend(draft, segments, &joint, before, after, extent)));
        }
    }
    Ok(())
}

impl Draft {
    fn after(&self, joint: &Joint) -> Svaj {
        self.law.svaj(joint.at)
    }

    fn before(&self, joint: &Joint) -> Svaj {
        let after = self.after(joint);
        Svaj {
            s: after.s - joint.jump.s,
            v: after.v - joint.jump.v,
            a: after.a - joint.jump.a,
            j: after.j - joint.jump.j,
        }
    }
}

/// What would make two segments meet in velocity.
fn mend(
    draft: &Draft,
    segments: &[Segment],
    joint: &Joint,
    before: usize,
    after: usize,
    extent: Extent,
) -> String {
    let (vb, va) = (draft.before(joint).v, draft.after(joint).v);
    if vb * va > 0.0 {
        // A motion's end velocity is inverse to its length.
        let other = segments[after].angle * va / vb;
        return format!(
            "let {} cover {}, or put a polynomial-5 between them",
            name(segments, after),
            extent.words(other)
        );
    }
    let moving = if va == 0.0 { before } else { after };
    format!(
        "{} does not rest there: put a half motion (semicycloidal) or a polynomial-5 between them",
        name(segments, moving)
    )
}

fn check_base_circle(draft: &Draft, segments: &[Segment], extent: Extent) -> Result<()> {
    let (low, high) = draft.law.extremes(0);
    if low.value >= -JUMP * (high.value - low.value) {
        return Ok(());
    }
    // The first dip is the one to blame; later segments may only stay down there.
    let depth = draft.law.combination([-1.0, 0.0, 0.0, 0.0], 0.0);
    let first = depth
        .peaks_above(
            JUMP * (high.value - low.value),
            f64::NEG_INFINITY,
            f64::INFINITY,
        )
        .first()
        .copied();
    let (at, by) = first.map_or((low.at, -low.value), |peak| (peak.at, peak.value));
    let i = draft.holding(at) - 1;
    Err(Error::new(format!(
        "{} leads {:.6} mm below the base circle, at {}",
        name(segments, i),
        1e3 * by,
        extent.words(at)
    ))
    .help("begin the programme where the follower stands lowest, or raise the segments before it"))
}

fn name(segments: &[Segment], i: usize) -> String {
    format!("segment {} ({})", i + 1, segments[i].motion.name())
}
