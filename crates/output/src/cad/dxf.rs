//! `profile.dxf`: the cam for CAD, at true scale in millimetres, each curve on its own layer.

use ::dxf::Drawing;
use ::dxf::entities::{Circle, Entity, EntityType, Line, LwPolyline, Polyline, Vertex};
use ::dxf::enums::{AcadVersion, DrawingUnits, Units};
use ::dxf::tables::Layer;
use ::dxf::{Color, LwPolylineVertex, Point};

use super::biarc;
use crate::cad::outline::{Edge, marks};
use gaitcam::synth::Synthesis;

const MM: f64 = 1000.0;

/// Layers with their AutoCAD colour indices; a drawing has those it uses.
const LAYERS: [(&str, u8); 11] = [
    ("PROFILE", 7),
    ("UPPER_WALL", 4),
    ("SECOND_PROFILE", 4),
    ("PITCH_CURVE", 30),
    ("SECOND_PITCH_CURVE", 40),
    ("BASE_CIRCLE", 3),
    ("PRIME_CIRCLE", 6),
    ("BORE", 5),
    ("CENTRE", 1),
    ("FOOT", 1),
    ("SEAM", 1),
];

/// Group 440 for "by value, fully opaque": the writer's own 0 is not a value of that group.
const OPAQUE: i32 = 0x0200_00ff;

/// The oldest program that must read the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// Heavy polylines: everything reads it. Its header has no place for units, so millimetres are declared
    /// in the later dialects' variable, which readers look for in R12 as well.
    R12,
    /// Lightweight polylines, millimetres declared in the header.
    R2000,
    /// As R2000, in the 2010 dialect.
    R2010,
}

/// How to draw the cam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Vertices of the polylines.
    pub points: usize,
    /// Dialect.
    pub version: Version,
    /// Diameter of the bore, m; none drawn where absent.
    pub bore: Option<f64>,
}

/// Largest distance of the plain hand-over from the true profile, m: a hundredth of what grinding leaves,
/// with fewer vertices than the chords of a tenfold error have.
pub const FAITHFUL: f64 = 1e-7;

/// The plain hand-over: R12, the profile in arcs that stay within [`FAITHFUL`] of it, the bore that the
/// scene gives. A profile that no arcs follow, and the pitch curve, are polylines of `points` vertices at
/// equal steps of the cam angle.
pub fn profile(synthesis: &Synthesis, points: usize) -> Vec<u8> {
    let options = Options {
        points,
        version: Version::R12,
        bore: synthesis.bore,
    };
    match arcs(synthesis, FAITHFUL, options) {
        Some(drawn) => drawn.bytes,
        None => drawing(synthesis, options),
    }
}

/// Every edge that is cut (a disc's profile, both cams of a pair, both walls of an unrolled groove) as
/// chords, with pitch curve, base and prime circle, bore and centre mark.
pub fn drawing(synthesis: &Synthesis, options: Options) -> Vec<u8> {
    let mut sheet = Sheet::new(options.version);
    for edge in Edge::all(synthesis) {
        let points = edge.points(options.points);
        let vertices: Vec<[f64; 3]> = points.iter().map(|e| chord(e.p)).collect();
        sheet.polyline(edge.layer, &vertices, edge.is_closed());
    }
    sheet.construction(synthesis, options);
    sheet.bytes()
}

/// A vertex in mm from which a chord goes on.
fn chord([x, y]: [f64; 2]) -> [f64; 3] {
    [MM * x, MM * y, 0.0]
}

/// A profile drawn in arcs.
#[derive(Debug, Clone, PartialEq)]
pub struct ArcDrawing {
    /// The file.
    pub bytes: Vec<u8>,
    /// Number of arcs.
    pub arcs: usize,
    /// Largest distance between the true edges and the arcs, m.
    pub deviation: f64,
}

/// As [`drawing`], with the edges as polylines of circular arcs (bulges) within `tolerance` m of the
/// true ones; `options.points` counts for the pitch curve only. `None` where no arcs can follow one
/// ([`biarc::fit`]).
pub fn arcs(synthesis: &Synthesis, tolerance: f64, options: Options) -> Option<ArcDrawing> {
    let mut sheet = Sheet::new(options.version);
    let (mut arcs, mut deviation) = (0, 0.0_f64);
    for edge in Edge::all(synthesis) {
        let fit = biarc::along(&edge, tolerance)?;
        let vertices: Vec<[f64; 3]> = fit
            .vertices
            .iter()
            .map(|&[x, y, bulge]| [MM * x, MM * y, bulge])
            .collect();
        sheet.polyline(edge.layer, &vertices, fit.closed);
        arcs += vertices.len() - usize::from(!fit.closed);
        deviation = deviation.max(fit.deviation);
    }
    sheet.construction(synthesis, options);
    Some(ArcDrawing {
        bytes: sheet.bytes(),
        arcs,
        deviation,
    })
}

/// A drawing under way.
struct Sheet {
    drawing: Drawing,
    version: Version,
    /// Left, bottom and right, top of what is drawn, mm.
    extent: [[f64; 2]; 2],
}

impl Sheet {
    fn new(version: Version) -> Self {
        let mut drawing = Drawing::new();
        let header = &mut drawing.header;
        header.version = match version {
            Version::R12 => AcadVersion::R12,
            Version::R2000 => AcadVersion::R2000,
            Version::R2010 => AcadVersion::R2010,
        };
        // In R12's dimension styles the handle's group means something else.
        header.handles_enabled = version != Version::R12;
        header.drawing_units = DrawingUnits::Metric;
        header.default_drawing_units = Units::Millimeters;
        // The same design gives the same bytes: no clock, no random identity.
        header.creation_date = Default::default();
        header.creation_date_universal = Default::default();
        header.update_date = Default::default();
        header.update_date_universal = Default::default();
        header.fingerprint_guid = Default::default();
        header.version_guid = Default::default();
        Sheet {
            drawing,
            version,
            extent: [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]],
        }
    }

    fn hold(&mut self, p: [f64; 2]) {
        let [low, high] = &mut self.extent;
        for (k, x) in p.into_iter().enumerate() {
            low[k] = low[k].min(x);
            high[k] = high[k].max(x);
        }
    }

    fn add(&mut self, layer: &str, specific: EntityType) {
        if self.drawing.layers().all(|l| l.name != layer) {
            let colour = LAYERS.iter().find(|l| l.0 == layer).map_or(7, |l| l.1);
            self.drawing.add_layer(Layer {
                name: layer.to_string(),
                color: Color::from_index(colour),
                ..Default::default()
            });
        }
        let mut entity = Entity::new(specific);
        entity.common.layer = layer.to_string();
        entity.common.transparency = OPAQUE;
        self.drawing.add_entity(entity);
    }

    /// Vertices x, y (mm) and the bulge of the edge that follows: tan(¼ of its arc), 0 for a chord.
    fn polyline(&mut self, layer: &str, vertices: &[[f64; 3]], closed: bool) {
        for (i, &[x, y, bulge]) in vertices.iter().enumerate() {
            self.hold([x, y]);
            let [u, v, _] = vertices[(i + 1) % vertices.len()];
            for crest in biarc::crests([x, y], [u, v], bulge) {
                self.hold(crest);
            }
        }
        if self.version == Version::R12 {
            let mut polyline = Polyline::default();
            polyline.set_is_closed(closed);
            for &[x, y, bulge] in vertices {
                let mut vertex = Vertex::new(Point::new(x, y, 0.0));
                vertex.bulge = bulge;
                polyline.add_vertex(&mut self.drawing, vertex);
            }
            self.add(layer, EntityType::Polyline(polyline));
            return;
        }
        let mut polyline = LwPolyline {
            vertices: vertices
                .iter()
                .map(|&[x, y, bulge]| LwPolylineVertex {
                    x,
                    y,
                    bulge,
                    ..Default::default()
                })
                .collect(),
            ..Default::default()
        };
        polyline.set_is_closed(closed);
        self.add(layer, EntityType::LwPolyline(polyline));
    }

    /// Everything but the edges.
    fn construction(&mut self, synthesis: &Synthesis, options: Options) {
        let cam = &synthesis.cam;
        for edge in Edge::pitch_curves(synthesis) {
            let points = edge.points(options.points);
            let vertices: Vec<[f64; 3]> = points.iter().map(|e| chord(e.pitch)).collect();
            self.polyline(edge.layer, &vertices, edge.is_closed());
        }
        for (layer, [p, q]) in marks(synthesis) {
            self.line(layer, p.map(|x| MM * x), q.map(|x| MM * x));
        }
        if cam.follower.is_unrolled() {
            return;
        }
        let (base, prime) = (cam.follower.base_radius(), cam.follower.prime_radius());
        if prime != base {
            self.circle("PRIME_CIRCLE", MM * prime);
        }
        self.circle("BASE_CIRCLE", MM * base);
        if let Some(bore) = options.bore {
            self.circle("BORE", MM * bore / 2.0);
        }
    }

    fn circle(&mut self, layer: &str, radius: f64) {
        self.hold([-radius; 2]);
        self.hold([radius; 2]);
        self.add(
            layer,
            EntityType::Circle(Circle::new(Point::origin(), radius)),
        );
    }

    fn line(&mut self, layer: &str, from: [f64; 2], to: [f64; 2]) {
        self.hold(from);
        self.hold(to);
        let [p, q] = [from, to].map(|[x, y]| Point::new(x, y, 0.0));
        self.add(layer, EntityType::Line(Line::new(p, q)));
    }

    fn bytes(&mut self) -> Vec<u8> {
        let mut out = Vec::new();
        let [low, high] = self.extent.map(|[x, y]| Point::new(x, y, 0.0));
        self.drawing.header.minimum_drawing_extents = low;
        self.drawing.header.maximum_drawing_extents = high;
        // Writing to memory cannot fail, and every entity here exists in every dialect offered.
        if self.drawing.save(&mut out).is_err() {
            out.clear();
        }
        if self.version == Version::R12 {
            out = for_r12(&out);
        }
        out
    }
}

/// Millimetres, as a header variable.
const MILLIMETRES: &[u8] = b"  9\r\n$INSUNITS\r\n 70\r\n     4\r\n";

/// R12 knows no subclass markers (group 100), and strict readers stop at the ones the writer leaves; the
/// header's end takes the units that the writer keeps for later dialects.
fn for_r12(text: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(text.len() + MILLIMETRES.len());
    let mut lines = text.split_inclusive(|&b| b == b'\n');
    let mut header = true;
    while let (Some(code), Some(value)) = (lines.next(), lines.next()) {
        if header && value.trim_ascii() == b"ENDSEC" {
            out.extend_from_slice(MILLIMETRES);
            header = false;
        }
        if code.trim_ascii() != b"100" {
            out.extend_from_slice(code);
            out.extend_from_slice(value);
        }
    }
    out
}
