//! `profile.dxf`: the cam for CAD, at true scale in millimetres or inches, each curve on its own layer.

mod file;

use self::file::{Drawing, Shape};
use super::outline::{Arrow, marks, zero_mark};
use super::{Units, biarc, spline};
use gaitcam::cam::Bore;
use gaitcam::synth::Design;
use gaitcam::synth::Edge;

const MM: f64 = 1000.0;

/// Layers with their AutoCAD colour indices; a drawing contains those it uses. Edges to cut are on `CUT_*`.
const LAYERS: [(&str, u8); 13] = [
    ("CUT_PROFILE", 7),
    ("CUT_UPPER_WALL", 4),
    ("CUT_SECOND_PROFILE", 4),
    ("CUT_BORE", 5),
    ("REF_PITCH_CURVE", 30),
    ("REF_SECOND_PITCH_CURVE", 40),
    ("REF_BASE_CIRCLE", 3),
    ("REF_PRIME_CIRCLE", 6),
    ("REF_CENTRE", 1),
    ("REF_FOOT", 1),
    ("REF_SEAM", 1),
    (ZERO, 1),
    (ROTATION, 1),
];
/// Layer of the mark that shows where θ = 0 meets the follower.
const ZERO: &str = "REF_THETA_ZERO";
/// Layer of the arrow that shows how the cam turns.
const ROTATION: &str = "REF_ROTATION";

/// Oldest program version that must read the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// Heavy polylines: every program reads it. Its header has no unit, so millimetres are declared in the later dialects' variable, which readers
    /// look for in R12 as well.
    R12,
    /// Lightweight polylines, millimetres declared in the header; splines.
    R2000,
}

/// Which layers a drawing has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Content {
    /// Edges to cut on layers `CUT_*`, everything else on layers `REF_*`.
    #[default]
    All,
    /// Layers `CUT_*` alone: for machines that cut every line.
    CutOnly,
}

/// Entities that represent the edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Curves {
    /// Polylines of circular arcs, which every machine reads.
    #[default]
    Arcs,
    /// Cubic B-splines, C² as the profile is: for CAD.
    Splines,
}

/// Options of the drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Number of vertices of the polylines.
    pub points: usize,
    /// Dialect of the file.
    pub version: Version,
    /// The hole for the shaft, if any.
    pub bore: Option<Bore>,
    /// Layers of the drawing.
    pub content: Content,
    /// Unit of lengths in the file.
    pub units: Units,
}

/// Largest distance of the default drawing from the profile, m: a hundredth of the grinding error.
pub const FAITHFUL: f64 = 1e-7;

/// Largest distance of splines from the edges at the points compared, m: between them at most [`FAITHFUL`].
const SPLINES: f64 = 5e-8;

/// The drawing for manufacturing: the profile in arcs within [`FAITHFUL`] (R12) or in splines (R2000), and the bore of the scene. A profile that
/// neither can follow, and the pitch curve, are polylines of `points` vertices at equal steps of the cam angle.
pub fn profile(
    synthesis: &Design,
    points: usize,
    content: Content,
    curves: Curves,
    units: Units,
) -> Vec<u8> {
    let options = Options {
        points,
        version: Version::R12,
        bore: synthesis.problem.cam.hole(),
        content,
        units,
    };
    let drawn = match curves {
        Curves::Arcs => arcs(synthesis, FAITHFUL, options).map(|drawn| drawn.bytes),
        Curves::Splines => splines(synthesis, options),
    };
    drawn.unwrap_or_else(|| drawing(synthesis, options))
}

/// Every edge that is cut (a disc's profile, both cams of a pair, both walls of an unrolled groove) as
/// chords, with pitch curve, base and prime circle, bore and centre mark.
pub fn drawing(synthesis: &Design, options: Options) -> Vec<u8> {
    let mut sheet = Sheet::new(options);
    for edge in Edge::all(synthesis) {
        let points = edge.points(options.points);
        let vertices: Vec<[f64; 3]> = points.iter().map(|e| chord(e.p)).collect();
        sheet.polyline(edge.layer, &vertices, edge.is_closed());
    }
    sheet.construction(synthesis);
    sheet.drawing.bytes()
}

/// A vertex in mm at the start of a chord (bulge 0).
fn chord([x, y]: [f64; 2]) -> [f64; 3] {
    [MM * x, MM * y, 0.0]
}

/// Vertices of arcs in mm.
fn millimetres(vertices: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mm = |&[x, y, bulge]: &[f64; 3]| [MM * x, MM * y, bulge];
    vertices.iter().map(mm).collect()
}

/// A profile drawn in arcs.
#[derive(Debug, Clone, PartialEq)]
pub struct ArcDrawing {
    /// Bytes of the file.
    pub bytes: Vec<u8>,
    /// Number of arcs in the file.
    pub arcs: usize,
    /// Largest distance between the true edges and the arcs, m.
    pub deviation: f64,
}

/// As [`drawing`], with the edges as polylines of circular arcs (bulges) within `tolerance` m of the
/// true ones; `options.points` counts for the pitch curve only. `None` where no arcs can follow one
/// ([`biarc::fit`]).
pub fn arcs(synthesis: &Design, tolerance: f64, options: Options) -> Option<ArcDrawing> {
    let mut sheet = Sheet::new(options);
    let (mut arcs, mut deviation) = (0, 0.0_f64);
    for edge in Edge::all(synthesis) {
        let fit = biarc::along(&edge, tolerance)?;
        let vertices = millimetres(&fit.vertices);
        sheet.polyline(edge.layer, &vertices, fit.closed);
        arcs += vertices.len() - usize::from(!fit.closed);
        deviation = deviation.max(fit.deviation);
    }
    sheet.construction(synthesis);
    Some(ArcDrawing {
        bytes: sheet.drawing.bytes(),
        arcs,
        deviation,
    })
}

/// As [`drawing`], with the edges as cubic B-splines within [`FAITHFUL`] of the true ones, in the dialect R2000.
/// `None` where no splines can follow one.
pub fn splines(synthesis: &Design, options: Options) -> Option<Vec<u8>> {
    let version = Version::R2000;
    let mut sheet = Sheet::new(Options { version, ..options });
    for edge in Edge::all(synthesis) {
        let reach: Vec<[f64; 2]> = (edge.points(options.points).iter())
            .map(|e| e.p.map(|x| MM * x))
            .collect();
        for spline in spline::along(&edge, SPLINES, 1)? {
            sheet.add(edge.layer, Shape::Spline(spline), &reach);
        }
    }
    sheet.construction(synthesis);
    Some(sheet.drawing.bytes())
}

/// A drawing during writing.
struct Sheet {
    drawing: Drawing,
    options: Options,
}

impl Sheet {
    fn new(options: Options) -> Self {
        Sheet {
            drawing: Drawing {
                version: options.version,
                units: options.units,
                layers: Vec::new(),
                shapes: Vec::new(),
                extent: [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]],
            },
            options,
        }
    }

    fn add(&mut self, layer: &'static str, shape: Shape, reach: &[[f64; 2]]) {
        let [low, high] = &mut self.drawing.extent;
        for p in reach {
            for k in 0..2 {
                low[k] = low[k].min(p[k]);
                high[k] = high[k].max(p[k]);
            }
        }
        if self.drawing.layers.iter().all(|l| l.0 != layer) {
            let known = LAYERS.iter().find(|l| l.0 == layer);
            self.drawing.layers.push(*known.unwrap_or(&(layer, 7)));
        }
        self.drawing.shapes.push((layer, shape));
    }

    /// Vertices x, y (mm) and the bulge of the edge that follows: tan(¼ of its arc), 0 for a chord.
    fn polyline(&mut self, layer: &'static str, vertices: &[[f64; 3]], closed: bool) {
        let mut reach = Vec::with_capacity(2 * vertices.len());
        for (i, &[x, y, bulge]) in vertices.iter().enumerate() {
            let [u, v, _] = vertices[(i + 1) % vertices.len()];
            reach.push([x, y]);
            reach.extend(biarc::crests([x, y], [u, v], bulge));
        }
        let vertices = vertices.to_vec();
        self.add(layer, Shape::Polyline { vertices, closed }, &reach);
    }

    /// Draws everything but the edges.
    fn construction(&mut self, synthesis: &Design) {
        let follower = &synthesis.cam.follower;
        let round = !follower.is_unrolled();
        if let Some(bore) = self.options.bore.filter(|_| round) {
            match bore.keyway {
                None => self.circle("CUT_BORE", MM * bore.radius()),
                Some(_) => self.polyline("CUT_BORE", &millimetres(&bore.outline()), true),
            }
        }
        if self.options.content == Content::CutOnly {
            return;
        }
        for edge in Edge::pitch_curves(synthesis) {
            let points = edge.points(self.options.points);
            let vertices: Vec<[f64; 3]> = points.iter().map(|e| chord(e.pitch)).collect();
            self.polyline(edge.layer, &vertices, edge.is_closed());
        }
        for (layer, ends) in marks(synthesis) {
            self.line(layer, ends.map(|p| p.map(|x| MM * x)));
        }
        if !round {
            return;
        }
        let (base, prime) = (MM * follower.base_radius(), MM * follower.prime_radius());
        if prime != base {
            self.circle("REF_PRIME_CIRCLE", prime);
        }
        self.circle("REF_BASE_CIRCLE", base);
        let bore = self.options.bore.map_or(0.0, |b| MM * b.reach());
        self.zero(zero_mark(base, bore), 0.08 * base);
        self.rotation(&Arrow::new(base, bore, synthesis.problem.drive.speed < 0.0));
    }

    fn circle(&mut self, layer: &'static str, radius: f64) {
        let reach = [[-radius; 2], [radius; 2]];
        self.add(layer, Shape::Circle { radius }, &reach);
    }

    fn line(&mut self, layer: &'static str, ends: [[f64; 2]; 2]) {
        self.add(layer, Shape::Line { ends }, &ends);
    }

    fn zero(&mut self, ends: [[f64; 2]; 2], height: f64) {
        self.line(ZERO, ends);
        let text = Shape::Text {
            at: [0.5 * height, ends[0][1]],
            height,
            text: "0%%d",
        };
        self.add(ZERO, text, &[]);
    }

    fn rotation(&mut self, arrow: &Arrow) {
        let [[x, y], [u, v]] = arrow.ends;
        let sense = if arrow.clockwise { -1.0 } else { 1.0 };
        let bulge = sense * (0.25 * Arrow::ANGLE).tan();
        self.polyline(ROTATION, &[[x, y, bulge], [u, v, 0.0]], false);
        for side in arrow.head {
            self.line(ROTATION, [arrow.ends[1], side]);
        }
    }
}
