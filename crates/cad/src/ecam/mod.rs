//! Electronic cams: a law as a program text or table for a motion controller, and the error of the executed motion.
//!
//! Controllers interpolate between points with polynomials. Quintics that match lift, velocity and acceleration at both ends reproduce a law of
//! degree 5 exactly. A cubic spline through positions does not reproduce it exactly. Its acceleration error has two parts, where h is the distance
//! between the points. The interpolation error is proportional to h². The rounding error of the positions is divided by h². Above a certain number of
//! points, additional points therefore increase the error.
//!
//! Every file is read back and evaluated in the number type of its controller. The executed motion is compared with the law.

mod codesys;
mod csv;
mod literal;
mod replay;
mod rockwell;
mod segments;
mod table;
mod twincat;

use gaitcam::criterion::Criterion;
use gaitcam::drive::Drive;
use gaitcam::error::{Error, Placed, Result, WriteError};
use gaitcam::law::Law;
use gaitcam::poly::gauss_legendre;
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

use replay::Curve;
pub use table::{Node, Table};

/// Kind of motion controller, with the format of its files.
///
/// ```
/// use gaitcam_cad::ecam::{Dialect, Interpolation};
///
/// assert_eq!(Dialect::ALL.map(Dialect::name), ["codesys", "twincat", "segments", "rockwell", "csv"]);
/// assert_eq!(Dialect::Rockwell.carries().interpolation, Interpolation::CubicSpline);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dialect {
    /// CODESYS SoftMotion: structured text with an `MC_CAM_REF` of type XYVA.
    Codesys,
    /// TwinCAT: structured text with `MC_MotionFunctionPoint` and quintics between the points.
    Twincat,
    /// Table of polynomial segments with lift, velocity and acceleration at both ends (SEW, Siemens).
    Segments,
    /// Logix: structured text with a `CAM` array for `MCCP`, which interpolates with a cubic spline of given end slopes.
    Rockwell,
    /// Table of positions only, as CSV.
    Csv,
}

/// Interpolation of a controller between the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Quintic with given lift, velocity and acceleration at both ends.
    Quintic,
    /// Cubic spline through the given positions.
    CubicSpline,
}

/// Floating-point type of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Number {
    /// 32-bit floating point: `REAL`.
    Single,
    /// 64-bit floating point: `LREAL`.
    Double,
}

/// Interpolation, number type and maximum number of points of a dialect.
#[derive(Debug, Clone, Copy)]
pub struct Carries {
    /// Interpolation of the controller between the points.
    pub interpolation: Interpolation,
    /// Number type of the points and coefficients.
    pub number: Number,
    /// Maximum number of points of one cam in the controller.
    pub most: usize,
    write: fn(&Table) -> String,
    read: fn(&str) -> Option<Curve>,
}

impl Dialect {
    /// All supported dialects, in the order in which the help lists them.
    pub const ALL: [Dialect; 5] = [
        Dialect::Codesys,
        Dialect::Twincat,
        Dialect::Segments,
        Dialect::Rockwell,
        Dialect::Csv,
    ];

    /// Name of the dialect on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Dialect::Codesys => "codesys",
            Dialect::Twincat => "twincat",
            Dialect::Segments => "segments",
            Dialect::Rockwell => "rockwell",
            Dialect::Csv => "csv",
        }
    }

    /// Makers and products that are accepted as names of the dialect on the command line.
    pub fn other_names(self) -> &'static [&'static str] {
        match self {
            Dialect::Codesys | Dialect::Csv => &[],
            Dialect::Twincat => &["beckhoff"],
            Dialect::Segments => &["siemens", "sew"],
            Dialect::Rockwell => &["logix"],
        }
    }

    /// Name of the file that is written for the dialect.
    pub const fn file(self) -> &'static str {
        match self {
            Dialect::Codesys => "ecam_codesys.st",
            Dialect::Twincat => "ecam_twincat.st",
            Dialect::Segments => "ecam_segments.csv",
            Dialect::Rockwell => "ecam_rockwell.st",
            Dialect::Csv => "ecam_csv.csv",
        }
    }

    /// Properties of the controller and of the file format.
    pub fn carries(self) -> Carries {
        use Interpolation::{CubicSpline, Quintic};
        use Number::{Double, Single};
        let row = |interpolation, number, most, write, read| Carries {
            interpolation,
            number,
            most,
            write,
            read,
        };
        match self {
            // The controller stores the number of elements as INT, so at most 32 767 points are possible.
            Dialect::Codesys => row(Quintic, Double, 32_767, codesys::write, codesys::read),
            Dialect::Twincat => row(Quintic, Double, MOST, twincat::write, twincat::read),
            Dialect::Segments => row(Quintic, Single, MOST, segments::write, segments::read),
            Dialect::Rockwell => row(CubicSpline, Single, MOST, rockwell::write, rockwell::read),
            Dialect::Csv => row(CubicSpline, Double, MOST, csv::write, csv::read),
        }
    }
}

/// Maximum number of points of a controller without a documented maximum.
const MOST: usize = 100_000;
/// Maximum number of points that is chosen automatically.
const MOST_CHOSEN: usize = 4096;
/// Minimum number of intervals that a user can request.
const FEWEST: usize = 4;
/// RMS force error added by the controller, as a fraction of the mean force, at which the automatic number of points is sufficient.
const EXACT: f64 = 1e-4;
/// Permitted RMS force error added by the controller, as a fraction of the mean force. It applies to designs without a limit of the RMS force error.
const ACCEPTED: f64 = 0.005;
/// Number of Gauss nodes that integrate the square of a difference of two quintics exactly.
const GAUSS: usize = 6;

/// File for a controller, and the error of the motion that the controller executes.
#[derive(Debug, Clone, PartialEq)]
pub struct ElectronicCam {
    /// Dialect in which the file is written.
    pub dialect: Dialect,
    /// Text of the file, a program or a table.
    pub text: String,
    /// Number of intervals between the points. It is one less than the number of points.
    pub intervals: usize,
    /// Error of the motion that the controller executes from this file.
    pub replayed: Replayed,
}

/// Error of the motion that a controller executes from a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Replayed {
    /// RMS difference, N, between the forces of the executed motion and of the law; `None` without a drive.
    pub added: Option<f64>,
    /// RMS force difference between the executed motion and the law, as a fraction of the mean target force. Without a target, it is a fraction of
    /// the maximum force. Without a drive, it is the RMS acceleration difference as a fraction of the maximum acceleration.
    pub share: f64,
    /// RMS difference, N, between the force of the executed motion and the target; `None` without a target.
    pub error: Option<f64>,
}

/// Electronic cam of a design, with the requested number of intervals per cycle. Without a request, the number is chosen so that the motion
/// reproduces the law.
///
/// # Errors
///
/// - The number of intervals is out of range.
/// - The added force error exceeds the permitted RMS error of the design. The message suggests a sufficient number, if there is one.
/// - The shaft speed of the design is not constant.
pub fn make(design: &Design, dialect: Dialect, intervals: Option<usize>) -> Result<ElectronicCam> {
    if design.shaft.is_some() {
        return Err(WriteError::EcamOfMotor.at_key("law.shaft"));
    }
    let most = dialect.carries().most - 1;
    let Some(asked) = intervals else {
        let best = fewest(design, dialect);
        return match accepted(design, &best) {
            true => Ok(best),
            false => Err(refusal(design, &best, None)),
        };
    };
    if !(FEWEST..=most).contains(&asked) {
        let least = FEWEST;
        return Err(WriteError::EcamIntervals { asked, least, most }.at_argument("--points"));
    }
    let (start, length) = design.cam.law.extent();
    let at = |i: usize| start + length * i as f64 / asked as f64;
    let made = executed(design, dialect, &(0..=asked).map(at).collect::<Vec<_>>());
    match accepted(design, &made) {
        true => Ok(made),
        false => Err(refusal(design, &made, Some(&fewest(design, dialect)))),
    }
}

/// Cam with the smallest tried number of points for which the added error is at most [`EXACT`]. The number of intervals per span of the law
/// is doubled step by step. If no number is sufficient, the result is the cam with the smallest error.
fn fewest(design: &Design, dialect: Dialect) -> ElectronicCam {
    let breaks = design.cam.law.breaks();
    let mut best: Option<ElectronicCam> = None;
    let mut parts = 1;
    while parts == 1 || parts * (breaks.len() - 1) < MOST_CHOSEN {
        let mut angles: Vec<f64> = Vec::new();
        for pair in breaks.windows(2) {
            angles.extend(
                (0..parts).map(|k| pair[0] + (pair[1] - pair[0]) * k as f64 / parts as f64),
            );
        }
        angles.push(breaks[breaks.len() - 1]);
        if angles.len() > FEWEST {
            let made = executed(design, dialect, &angles);
            let (share, is_exact) = (made.replayed.share, made.replayed.share <= EXACT);
            if best.as_ref().is_none_or(|b| share < b.replayed.share) {
                best = Some(made);
            }
            if is_exact {
                break;
            }
        }
        parts *= 2;
    }
    best.unwrap_or_else(|| executed(design, dialect, breaks))
}

/// Writes the file with points at the given positions of the cam, rad (translating cam: m), reads it back and evaluates its error.
fn executed(design: &Design, dialect: Dialect, angles: &[f64]) -> ElectronicCam {
    let carries = dialect.carries();
    let table = Table::of(design, angles, carries.number);
    let text = (carries.write)(&table);
    let motion = (carries.read)(&text).map(|curve| replay::motion(&curve, &table, carries.number));
    ElectronicCam {
        dialect,
        text,
        intervals: angles.len() - 1,
        replayed: motion.map_or(Replayed::NOT_READ, |law| held_against(design, &law)),
    }
}

/// Maximum length of the name of a cam in a controller's program, characters.
const LONGEST_NAME: usize = 24;

impl ElectronicCam {
    /// The cam with `name` instead of `gaitcam` in the names of its variables, for a second cam in one project.
    ///
    /// # Errors
    ///
    /// The name is not an identifier of IEC 61131-3, or is longer than 24 characters.
    pub fn named(mut self, name: &str) -> Result<ElectronicCam> {
        let starts = name.starts_with(|c: char| c.is_ascii_alphabetic());
        let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let is_apart = !name.contains("__") && !name.ends_with('_');
        if !(starts && is_plain && is_apart && name.len() <= LONGEST_NAME) {
            let fault = WriteError::EcamName {
                name: name.to_string(),
                longest: LONGEST_NAME,
            };
            return Err(fault.at_argument("--name"));
        }
        self.text = self.text.replace("gaitcam_", &format!("{name}_"));
        Ok(self)
    }
}

impl Replayed {
    /// Infinite error, for a text that cannot be read back.
    const NOT_READ: Replayed = Replayed {
        added: None,
        share: f64::INFINITY,
        error: None,
    };
}

/// Compares the executed motion with the law and, if the design has a target force, with this force.
fn held_against(design: &Design, motion: &Law) -> Replayed {
    let law = &design.cam.law;
    let (start, length) = law.extent();
    let is_idle = design.is_idle();
    let drive = match is_idle {
        // Without a drive, a unit mass at unit speed is used, so the force equals the acceleration.
        true => Drive::fixed_axis(1.0, 0.0, 1.0),
        false => design.problem.drive,
    };
    let target = design.target_in_time().filter(|_| !is_idle);
    let rule = gauss_legendre(GAUSS);
    let (mut added, mut error) = (0.0, 0.0);
    for pair in merged(law.breaks(), motion.breaks(), length / PARTS).windows(2) {
        let width = pair[1] - pair[0];
        for &(u, weight) in &rule {
            let theta = pair[0] + u * width;
            let more = drive.force(motion.svaj(theta)) - drive.force(law.svaj(theta));
            added += weight * width * more * more;
            if let Some(target) = target {
                let miss = design.force_at(theta) + more - target.at(theta - start);
                error += weight * width * miss * miss;
            }
        }
    }
    let rms = |square: f64| (square / length).sqrt();
    let (low, high) = law.extremes(2);
    let unit = match is_idle {
        true => low.value.abs().max(high.value.abs()),
        false if target.is_some() => design.force.target_mean_n.abs(),
        false => {
            let (low, high) = drive.force_extremes(law);
            low.value.abs().max(high.value.abs())
        }
    };
    Replayed {
        added: (!is_idle).then(|| drive.newtons(rms(added))),
        share: rms(added) / unit.max(f64::MIN_POSITIVE),
        error: target.map(|_| drive.newtons(rms(error))),
    }
}

/// Minimum number of quadrature intervals per cycle, so that the target is smooth enough within each interval.
const PARTS: f64 = 720.0;

/// Ends of the quadrature intervals for two functions with the breaks `a` and `b`. They are the breaks of both functions in increasing order, and
/// additional points so that no interval is longer than `most`. All values are positions of the cam, rad (translating cam: m).
fn merged(a: &[f64], b: &[f64], most: f64) -> Vec<f64> {
    let mut all = [a, b].concat();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let mut out = Vec::new();
    for pair in all.windows(2) {
        let n = ((pair[1] - pair[0]) / most).ceil().max(1.0);
        let at = |k: usize| pair[0] + (pair[1] - pair[0]) * k as f64 / n;
        out.extend((0..n as usize).map(at));
    }
    out.extend(all.last());
    out
}

/// Whether the motion reproduces the law within the permitted RMS force error.
fn accepted(design: &Design, made: &ElectronicCam) -> bool {
    made.replayed.share <= accepted_share(design)
}

fn accepted_share(design: &Design) -> f64 {
    let check = design.checks.iter().find(|c| c.name == Criterion::RmsError);
    let mean = design.force.target_mean_n.abs();
    check.map_or(ACCEPTED, |c| c.limit / mean.max(f64::MIN_POSITIVE))
}

fn refusal(design: &Design, made: &ElectronicCam, better: Option<&ElectronicCam>) -> Error {
    let (dialect, points) = (made.dialect.name().to_string(), made.intervals);
    let error = Quantity::share(made.replayed.share);
    let allowed = Quantity::share(accepted_share(design));
    match better.filter(|b| accepted(design, b)) {
        Some(better) => WriteError::EcamPoints {
            dialect,
            points,
            error,
            allowed,
            better: better.intervals,
            to: Quantity::share(better.replayed.share),
        }
        .at_argument("--points"),
        None => WriteError::EcamLaw {
            dialect,
            points,
            error,
            allowed,
        }
        .at_argument("--dialect"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::scene::built_in;

    /// The errors come from an independent integration. It rounds a table of positions to 1 µm and interpolates it by cubics. The errors
    /// are 4.5, 72 and 477 % of the weight for 360, 1440 and 3600 points.
    #[test]
    fn a_table_rounded_to_a_micrometre_is_worse_with_more_points() {
        let design = built_in("footbridge")
            .unwrap()
            .scene()
            .unwrap()
            .design()
            .unwrap();
        let share = |points: usize| {
            let angle = |i: usize| std::f64::consts::TAU * i as f64 / points as f64;
            let angles: Vec<f64> = (0..=points).map(angle).collect();
            let table = Table::of(&design, &angles, Number::Double);
            let rounded = |n: Node| [n.x, 1e-3 * (1e3 * n.y).round()];
            let points = table.nodes().map(rounded).collect();
            let curve = Curve::Points {
                points,
                slopes: None,
            };
            held_against(&design, &replay::motion(&curve, &table, Number::Double)).share
        };
        for (points, percent) in [(360, 4.5), (1440, 72.0), (3600, 477.0)] {
            let own = 100.0 * share(points);
            assert!(
                (own / percent - 1.0).abs() < 0.15,
                "{points}: {own} % for {percent} %"
            );
        }
    }
}
