//! `profile.dxf`: outline of the cam for CAD, at true scale in millimetres or inches, with each kind of curve on its own layer.

mod file;

use self::file::{Drawing, Shape};
use super::outline::{Arrow, marks, zero_mark};
use super::{Units, biarc, spline};
use gaitcam::cam::Bore;
use gaitcam::synth::Design;
use gaitcam::synth::Edge;

const MM: f64 = 1000.0;

/// Layers with their AutoCAD colour indices. A drawing contains only the layers that it uses. Edges to be cut are on the layers `CUT_*`.
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
/// Layer of the mark of θ = 0.
const ZERO: &str = "REF_THETA_ZERO";
/// Layer of the arrow of rotation.
const ROTATION: &str = "REF_ROTATION";

/// Version of the DXF format, R12 or R2000.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// R12: polylines with separate vertex entities, which every program can read. The R12 header has no variable for the unit. The unit is
    /// therefore declared in the variable of later versions, which readers also use for R12.
    R12,
    /// R2000: lightweight polylines and splines, with the unit declared in the header.
    R2000,
}

/// Selection of the layers that a drawing contains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Content {
    /// Edges to be cut on layers `CUT_*`, all other lines on layers `REF_*`.
    #[default]
    All,
    /// Only the layers `CUT_*`, for machines that cut every line in the file.
    CutOnly,
}

/// Kind of curve that represents the edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Curves {
    /// Polylines of circular arcs, which every machine can read.
    #[default]
    Arcs,
    /// Cubic B-splines for CAD. They are C², like the profile.
    Splines,
    /// Polylines of chords within [`CHORDS`] of the edges, for readers that ignore arcs in polylines.
    Lines,
}

/// Options of a DXF drawing: vertices, version, bore, layers and unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Number of vertices of a polyline. The vertices are at equal steps of the cam angle.
    pub points: usize,
    /// Version of the DXF format, R12 or R2000.
    pub version: Version,
    /// Bore for the shaft; `None` for a cam without a bore.
    pub bore: Option<Bore>,
    /// Layers that the drawing contains.
    pub content: Content,
    /// Unit of lengths in the file.
    pub units: Units,
}

/// Maximum distance between arcs or splines and the exact profile, m. It is a hundredth of a typical grinding error.
pub const FAITHFUL: f64 = 1e-7;

/// Maximum distance between the chords of [`Curves::Lines`] and the exact profile, m.
pub const CHORDS: f64 = 2e-6;

/// Maximum distance between splines and edges, m, at the points where the distance is measured. Between these points it is at most [`FAITHFUL`].
const SPLINES: f64 = 5e-8;

/// Drawing for manufacturing, with the bore of the scene. The profile consists of arcs within [`FAITHFUL`], of chords within [`CHORDS`] (both R12),
/// or of splines (R2000).
///
/// If the requested kind of curve is not possible, the profile is a polyline of `points` vertices at equal steps of the cam angle. The pitch curve
/// is always such a polyline.
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
        Curves::Lines => lines(synthesis, options),
    };
    drawn.unwrap_or_else(|| drawing(synthesis, options))
}

/// Drawing of all edges to be cut, as polylines of chords between `options.points` vertices. The edges are the profile of a disc, both cams of a
/// pair, or both walls of an unrolled groove.
///
/// The drawing also contains the pitch curve, the base and prime circles, the bore and the centre mark.
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

/// Vertex in mm of a point in m, with a straight edge after it (bulge 0).
fn chord([x, y]: [f64; 2]) -> [f64; 3] {
    [MM * x, MM * y, 0.0]
}

/// Converts the coordinates of vertices from m to mm. The bulges are unchanged.
fn millimetres(vertices: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mm = |&[x, y, bulge]: &[f64; 3]| [MM * x, MM * y, bulge];
    vertices.iter().map(mm).collect()
}

/// Drawing with the edges as arcs, and its accuracy.
#[derive(Debug, Clone, PartialEq)]
pub struct ArcDrawing {
    /// Content of the DXF file.
    pub bytes: Vec<u8>,
    /// Number of arcs in the file.
    pub arcs: usize,
    /// Maximum distance between the exact edges and the arcs, m.
    pub deviation: f64,
}

/// Draws as [`drawing`] does, but with the edges as polylines of circular arcs (bulges) within `tolerance` m of the exact edges.
///
/// `options.points` applies only to the pitch curve. `None` if arcs cannot approximate an edge ([`biarc::fit`]).
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

/// Draws as [`drawing`] does, but with the edges as chords within [`CHORDS`] of the exact edges. `None` if arcs, from which the chords are
/// computed, cannot approximate an edge ([`biarc::fit`]).
fn lines(synthesis: &Design, options: Options) -> Option<Vec<u8>> {
    let mut sheet = Sheet::new(options);
    for edge in Edge::all(synthesis) {
        let fit = biarc::along(&edge, FAITHFUL)?;
        let vertices = millimetres(&fit.chords(CHORDS - FAITHFUL));
        sheet.polyline(edge.layer, &vertices, fit.closed);
    }
    sheet.construction(synthesis);
    Some(sheet.drawing.bytes())
}

/// Draws as [`drawing`] does, but with the edges as cubic B-splines within [`FAITHFUL`] of the exact edges, in version R2000. `None` if splines
/// cannot approximate an edge.
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

/// Drawing under construction, with its options.
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

    /// Adds a polyline. A vertex contains x, y (mm) and the bulge of the following edge. The bulge is the tangent of a quarter of the arc's
    /// angle, and 0 for a chord.
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

    /// Adds the bore and the reference lines: pitch curves, circles, marks and the arrow of rotation.
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
        let bulge = sense * libm::tan(0.25 * Arrow::ANGLE);
        self.polyline(ROTATION, &[[x, y, bulge], [u, v, 0.0]], false);
        for side in arrow.head {
            self.line(ROTATION, [arrow.ends[1], side]);
        }
    }
}
