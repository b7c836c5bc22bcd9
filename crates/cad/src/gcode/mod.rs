//! Programs for machine tools (ISO 6983). Milling programs cut the outside of a cam, or the groove of a barrel on a rotary axis. Wire-cutting
//! programs cut the bore and the outside of a cam.

mod groove;
mod outside;
mod wire;

use gaitcam::cam::Bore;
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

use self::outside::Lead;
use super::{Units, cutter};
use gaitcam::synth::Edge;

const MM: f64 = 1000.0;
/// Feed of the contact point along the profile, mm/min, for 0.05 mm per tooth, two teeth and 2000 rpm. Operators adjust the feed with the override.
const FEED: f64 = 200.0;
/// Spindle speed for which the feed is chosen, 1/min.
const SPINDLE: f64 = 2000.0;
/// Axial feed of the cutter, as a fraction of [`FEED`].
const PLUNGE: f64 = 0.25;
/// Height above the plate for rapid motion, m.
const CLEAR: f64 = 0.005;
/// Remaining thickness, as a fraction of the depth of a pass, up to which no additional pass is made.
const REST: f64 = 1e-6;
/// Maximum number of passes through a plate. A larger number means that the given depth is wrong.
const MOST_PASSES: f64 = 1000.0;
/// Maximum acceleration of the machine table on a curved path, mm/s².
const ACCELERATION: f64 = 500.0;
/// Minimum relative change of the feed for which a new feed is written.
const NEW_FEED: f64 = 0.01;

/// Options of the milling program: cutter, depth of a pass and unit.
///
/// ```
/// use gaitcam_cad::{Units, gcode::Milling};
///
/// let cut = Milling { pass: Some(0.002), ..Milling::of(0.003) };
/// assert_eq!((cut.tool, cut.units), (0.003, Units::Millimetres));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Milling {
    /// Radius of the cutter, m.
    pub tool: f64,
    /// Depth of one pass, m. If `None`, the operator sets the depth and the spindle speed.
    pub pass: Option<f64>,
    /// Unit of lengths in the program.
    pub units: Units,
}

impl Milling {
    /// Options for a cutter of radius `tool` (m), in millimetres, with the depth set by the operator.
    pub fn of(tool: f64) -> Milling {
        Milling {
            tool,
            pass: None,
            units: Units::Millimetres,
        }
    }
}

/// Line or arc of a path; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Move {
    to: [f64; 2],
    /// Centre of the arc, and whether the arc is counter-clockwise; `None` for a line.
    arc: Option<([f64; 2], bool)>,
    /// Feed of the cutter centre, mm/min.
    feed: f64,
}

impl Move {
    fn line(to: [f64; 2]) -> Move {
        Move {
            to,
            arc: None,
            feed: FEED,
        }
    }

    fn arc(to: [f64; 2], centre: [f64; 2], counter_clockwise: bool) -> Move {
        Move {
            to,
            arc: Some((centre, counter_clockwise)),
            feed: FEED,
        }
    }
}

/// Feed of the cutter's centre, mm/min, on an arc of radius `path` m. The contact point, on the radius `profile` m, moves at [`FEED`], or more
/// slowly where the acceleration would exceed [`ACCELERATION`].
fn feed_on(path: f64, profile: f64) -> f64 {
    let most = 60.0 * (ACCELERATION * MM * path).sqrt();
    (FEED * path / profile).min(most)
}

/// Path of the cutter's centre, m: a start point and consecutive moves.
struct Path {
    start: [f64; 2],
    moves: Vec<Move>,
}

/// Programs for a milling cutter: one for the bore and the outside of each cam, or one for the groove of a barrel. In a groove, the cutter must
/// have the radius of the roller.
///
/// # Errors
///
/// - The radius of the cutter is not positive.
/// - A pass is below a thousandth of the thickness.
/// - Arcs cannot approximate the profile (undercut, jumps of the velocity).
/// - The cutter does not fit into a concave part.
/// - The radius of the cutter for a groove differs from the radius of the roller.
pub fn milling(design: &Design, cut: &Milling) -> Result<Vec<String>> {
    let tool = cutter::positive(cut.tool)?;
    let least = design.problem.cam.thickness / MOST_PASSES;
    if let Some(pass) = cut
        .pass
        .filter(|p| !(p.is_finite() && *p > 0.0 && *p >= least))
    {
        let pass = Quantity::length(pass);
        let least = Quantity::length(least);
        return Err(WriteError::DepthOfPass { pass, least }.into());
    }
    if let Some(groove) = &design.groove {
        return Ok(vec![groove::program(groove, &design.problem.name, cut)?]);
    }
    let program = |edge: &Edge| {
        let path = outside::path(edge, tool, Lead::Arcs).ok_or(WriteError::NoCutterPath)?;
        let mut out = Program::new(design, cut.units);
        out.note(&format!(
            "CENTRE PATH, RADIUS OF CUTTER {}, NO COMPENSATION",
            out.named(tool)
        ));
        let feed = out.feed(FEED);
        out.note(&format!(
            "FEED {feed} AT THE PROFILE, CLIMB MILLING, SPINDLE CLOCKWISE"
        ));
        if let Some(pass) = cut.pass {
            let depth = out.named(pass);
            out.note(&format!("Z0 ON TOP OF THE PLATE, PASSES OF {depth}"));
        }
        out.begin_plane(design);
        if cut.pass.is_some() {
            let clear = out.length(CLEAR);
            out.line(&format!("G0 Z{clear}\nS{SPINDLE:.0} M3"));
        }
        bore(&mut out, design, cut);
        out.passes(&path, "TOOL TO DEPTH", cut.pass);
        out.end(if cut.pass.is_some() {
            "M5"
        } else {
            "M0 (TOOL CLEAR)"
        });
        Ok(out.finished())
    };
    Edge::all(design).iter().map(program).collect()
}

/// Writes the commands that mill the bore without its keyway. If the cutter is too wide for the bore, only a note is written, and the bore must be
/// drilled.
fn bore(out: &mut Program, design: &Design, cut: &Milling) {
    let Some(bore) = design.problem.cam.hole() else {
        return;
    };
    if bore.keyway.is_some() {
        out.note("THE KEYWAY IS NOT MILLED, A CUTTER ROUNDS ITS CORNERS. BROACH IT OR USE A WIRE");
    }
    let Some(mut hole) = wire::hole(&Bore::plain(bore.diameter), cut.tool) else {
        out.note("THE BORE IS NOT MILLED, CUTTER TOO WIDE");
        return;
    };
    let feed = feed_on(bore.radius() - cut.tool, bore.radius());
    hole.moves.iter_mut().for_each(|step| step.feed = feed);
    out.passes(&hole, "BORE, TOOL TO DEPTH", cut.pass);
    if cut.pass.is_none() {
        out.line("M0 (TOOL CLEAR)");
    }
}

/// Program for wire cutting. The centre of the wire moves at the distance `radius` m from the edge. This distance is half the wire diameter
/// plus the spark gap.
///
/// The program cuts the bore with its keyway, then the outside. For a conjugate pair, it cuts the first cam.
///
/// # Errors
///
/// - The radius is not positive.
/// - The cam is a barrel.
/// - Arcs cannot approximate the profile, or the wire does not fit into a concave part.
/// - The wire is too thick for the bore or its keyway.
pub fn wire(design: &Design, radius: f64, units: Units) -> Result<String> {
    let radius = cutter::positive(radius)?;
    if design.groove.is_some() {
        return Err(WriteError::NoCutterPath.into());
    }
    let outside = outside::path(&Edge::of(&design.cam), radius, Lead::Lines);
    let outside = outside.ok_or(WriteError::NoCutterPath)?;
    let mut out = Program::new(design, units);
    let size = out.named(radius);
    out.note(&format!(
        "WIRE AND GAP {size}, NO COMPENSATION, FEED BY THE GENERATOR"
    ));
    out.begin_plane(design);
    if let Some(bore) = design.problem.cam.hole() {
        let hole = wire::hole(&bore, radius).ok_or(WriteError::WireTooThick {
            radius: Quantity::length(radius),
        })?;
        if bore.keyway.is_some() {
            out.note(&format!("CORNERS OF THE KEYWAY KEEP A RADIUS OF {size}"));
        }
        out.passes(&hole, "THREAD THE WIRE, START HOLE", None);
        out.line("M0 (CUT THE WIRE)");
    }
    out.passes(&outside, "THREAD THE WIRE, START HOLE OR EDGE", None);
    out.end("M0 (CUT THE WIRE)");
    Ok(out.finished())
}

/// Text of a program, extended line by line.
struct Program {
    text: String,
    units: Units,
    thickness: f64,
}

impl Program {
    fn new(design: &Design, units: Units) -> Program {
        Program {
            text: format!("%\n({})\n", comment(&design.problem.name)),
            units,
            thickness: design.problem.cam.thickness,
        }
    }

    /// Writes a line of the program without any change.
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn note(&mut self, note: &str) {
        self.line(&format!("({note})"));
    }

    /// Text of a length, given in m, in the unit of the program.
    fn length(&self, x: f64) -> String {
        self.units.number(x, DECIMALS)
    }

    /// Text of a length, given in m, in the unit of the program and followed by this unit.
    fn named(&self, x: f64) -> String {
        named(self.units, x)
    }

    /// Text of a feed, given in mm/min, followed by its unit in the program.
    fn feed(&self, feed: f64) -> String {
        let unit = self.units.name().to_uppercase();
        format!("{} {unit}/MIN", written_feed(self.units, feed))
    }

    /// Writes the last header lines of a program for paths in the plane of the cam.
    fn begin_plane(&mut self, design: &Design) {
        self.note(if design.cam.follower.is_unrolled() {
            "ZERO AT THE FOOT BELOW THE START, +Y ALONG THE FOLLOWER"
        } else {
            "ZERO AT THE CENTRE OF THE CAM, +Y ALONG THE FOLLOWER AT THETA = 0"
        });
        let plane = code(self.units);
        self.line(&format!("G90 {plane} G17 G40 G94"));
    }

    /// Writes a path once per pass of depth `pass` (m). Without `pass`, it writes the path once, after a stop at which the operator sets the depth.
    fn passes(&mut self, path: &Path, task: &str, pass: Option<f64>) {
        let [x, y] = path.start.map(|v| self.length(v));
        let start = format!("G0 X{x} Y{y}");
        let Some(pass) = pass else {
            let plate = self.units.number(self.thickness, 3);
            let unit = self.units.name().to_uppercase();
            self.line(&format!("{start}\nM0 ({task}, PLATE {plate} {unit})"));
            return self.moves(path);
        };
        let plunge = written_feed(self.units, PLUNGE * FEED);
        let count = (self.thickness / pass - REST).ceil().max(1.0) as usize;
        for k in 1..=count {
            let depth = self.length(-(k as f64 * pass).min(self.thickness));
            self.line(&format!("{start}\nG1 Z{depth} F{plunge}"));
            self.moves(path);
            let clear = self.length(CLEAR);
            self.line(&format!("G0 Z{clear}"));
        }
    }

    fn moves(&mut self, path: &Path) {
        let mut at = path.start;
        let mut feed: f64 = 0.0;
        for step in &path.moves {
            let [x, y] = step.to.map(|v| self.length(v));
            let mut line = match step.arc {
                None => format!("G1 X{x} Y{y}"),
                Some((centre, counter_clockwise)) => {
                    let code = if counter_clockwise { "G3" } else { "G2" };
                    let [i, j] =
                        [0, 1].map(|k| self.length(centre[k] - rounded(self.units, at[k])));
                    format!("{code} X{x} Y{y} I{i} J{j}")
                }
            };
            if (step.feed - feed).abs() > NEW_FEED * feed {
                feed = step.feed;
                line += &format!(" F{}", written_feed(self.units, feed));
            }
            self.line(&line);
            at = step.to;
        }
    }

    fn end(&mut self, last: &str) {
        self.line(&format!("{last}\nM30\n%"));
    }

    fn finished(self) -> String {
        finished(self.text)
    }
}

/// Number of decimals of lengths in millimetres.
const DECIMALS: usize = 4;

/// Text of a length, given in m, in the unit of the program and followed by this unit.
fn named(units: Units, x: f64) -> String {
    let unit = units.name().to_uppercase();
    format!("{} {unit}", units.number(x, DECIMALS))
}

/// G-code that selects the unit.
fn code(units: Units) -> &'static str {
    match units {
        Units::Millimetres => "G21",
        Units::Inches => "G20",
    }
}

/// Text of a feed, given in mm/min, in the unit of the program per minute.
fn written_feed(units: Units, feed: f64) -> String {
    match units {
        Units::Millimetres => format!("{feed:.0}"),
        Units::Inches => format!("{:.2}", feed / 25.4),
    }
}

/// Removes the minus sign of zero coordinates (−0) from the text of a program, because some machines reject −0.
fn finished(text: String) -> String {
    let lines = text.lines().map(|line| {
        let words = line.split(' ').map(|word| match word.split_once('-') {
            Some((letter, number)) if number.bytes().all(|c| matches!(c, b'0' | b'.')) => {
                format!("{letter}{number}")
            }
            _ => word.to_string(),
        });
        words.collect::<Vec<_>>().join(" ") + "\n"
    });
    lines.collect()
}

/// Coordinate, m, rounded to the decimals of the program.
fn rounded(units: Units, x: f64) -> f64 {
    let step = match units {
        Units::Millimetres => 1e7,
        Units::Inches => 1e5 / 0.0254,
    };
    (x * step).round() / step
}

/// Name for a comment, cut to 40 characters. Characters that some controllers do not accept in comments are replaced by `_`.
fn comment(name: &str) -> String {
    let plain = |c: char| match c.to_ascii_uppercase() {
        c @ ('A'..='Z' | '0'..='9' | ' ' | '.' | '-' | '_') => c,
        _ => '_',
    };
    name.chars().map(plain).take(40).collect()
}
