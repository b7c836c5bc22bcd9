//! `profile.dxf`: the cam for CAD, at true scale in millimetres, each curve on its own layer.

use ::dxf::Drawing;
use ::dxf::entities::{Circle, Entity, EntityType, Line, LwPolyline, Polyline, Vertex};
use ::dxf::enums::{AcadVersion, DrawingUnits, Units};
use ::dxf::tables::Layer;
use ::dxf::{Color, LwPolylineVertex, Point};

use super::biarc;
use crate::synth::Synthesis;

const MM: f64 = 1000.0;
/// Half the length of the centre mark's strokes, mm.
const MARK: f64 = 3.0;

/// Layers with their AutoCAD colour indices.
const LAYERS: [(&str, u8); 6] = [
    ("PROFILE", 7),
    ("PITCH_CURVE", 30),
    ("BASE_CIRCLE", 3),
    ("PRIME_CIRCLE", 6),
    ("BORE", 5),
    ("CENTRE", 1),
];

/// Group 440 for "by value, fully opaque": the writer's own 0 is not a value of that group.
const OPAQUE: i32 = 0x0200_00ff;

/// The oldest program that must read the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// Heavy polylines, no units in the header: everything reads it.
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

/// The finished profile (closed for a closed law) with pitch curve, base and prime circle, bore and
/// centre mark.
pub fn drawing(synthesis: &Synthesis, options: Options) -> Vec<u8> {
    let cam = &synthesis.cam;
    let rows = cam.profile(options.points);
    let closed = cam.law.is_closed();
    let mut sheet = Sheet::new(options.version);
    let profile: Vec<[f64; 3]> = rows.iter().map(|p| [MM * p.x, MM * p.y, 0.0]).collect();
    sheet.polyline("PROFILE", &profile, closed);
    sheet.construction(synthesis, options);
    sheet.bytes()
}

/// A profile drawn in arcs.
#[derive(Debug, Clone, PartialEq)]
pub struct ArcDrawing {
    /// The file.
    pub bytes: Vec<u8>,
    /// Number of arcs.
    pub arcs: usize,
    /// Largest distance between the true profile and the arcs, m.
    pub deviation: f64,
}

/// As [`drawing`], with the profile as a polyline of circular arcs (bulges) within `tolerance` m of the
/// true profile; `options.points` counts for the pitch curve only. `None` where no arcs can follow it
/// ([`biarc::fit`]).
pub fn arcs(synthesis: &Synthesis, tolerance: f64, options: Options) -> Option<ArcDrawing> {
    let fit = biarc::fit(&synthesis.cam, tolerance)?;
    let mut sheet = Sheet::new(options.version);
    let vertices: Vec<[f64; 3]> = fit
        .vertices
        .iter()
        .map(|&[x, y, bulge]| [MM * x, MM * y, bulge])
        .collect();
    sheet.polyline("PROFILE", &vertices, fit.closed);
    sheet.construction(synthesis, options);
    Some(ArcDrawing {
        bytes: sheet.bytes(),
        arcs: vertices.len() - usize::from(!fit.closed),
        deviation: fit.deviation,
    })
}

/// A drawing under way.
struct Sheet {
    drawing: Drawing,
    version: Version,
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
        for (name, colour) in LAYERS {
            drawing.add_layer(Layer {
                name: name.to_string(),
                color: Color::from_index(colour),
                ..Default::default()
            });
        }
        Sheet { drawing, version }
    }

    fn add(&mut self, layer: &str, specific: EntityType) {
        let mut entity = Entity::new(specific);
        entity.common.layer = layer.to_string();
        entity.common.transparency = OPAQUE;
        self.drawing.add_entity(entity);
    }

    /// Vertices x, y (mm) and the bulge of the edge that follows: tan(¼ of its arc), 0 for a chord.
    fn polyline(&mut self, layer: &str, vertices: &[[f64; 3]], closed: bool) {
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

    /// Everything but the profile.
    fn construction(&mut self, synthesis: &Synthesis, options: Options) {
        let cam = &synthesis.cam;
        let (base, prime) = (cam.follower.base_radius(), cam.follower.prime_radius());
        if prime != base {
            let pitch: Vec<[f64; 3]> = cam
                .profile(options.points)
                .iter()
                .map(|p| [MM * p.pitch_x, MM * p.pitch_y, 0.0])
                .collect();
            self.polyline("PITCH_CURVE", &pitch, cam.law.is_closed());
            self.circle("PRIME_CIRCLE", MM * prime);
        }
        self.circle("BASE_CIRCLE", MM * base);
        if let Some(bore) = options.bore {
            self.circle("BORE", MM * bore / 2.0);
        }
        self.line("CENTRE", [-MARK, 0.0], [MARK, 0.0]);
        self.line("CENTRE", [0.0, -MARK], [0.0, MARK]);
    }

    fn circle(&mut self, layer: &str, radius: f64) {
        self.add(
            layer,
            EntityType::Circle(Circle::new(Point::origin(), radius)),
        );
    }

    fn line(&mut self, layer: &str, from: [f64; 2], to: [f64; 2]) {
        let [p, q] = [from, to].map(|[x, y]| Point::new(x, y, 0.0));
        self.add(layer, EntityType::Line(Line::new(p, q)));
    }

    fn bytes(&self) -> Vec<u8> {
        let mut out = Vec::new();
        // Writing to memory cannot fail, and every entity here exists in every dialect offered.
        if self.drawing.save(&mut out).is_err() {
            out.clear();
        }
        if self.version == Version::R12 {
            out = without_subclasses(&out);
        }
        out
    }
}

/// R12 knows no subclass markers (group 100), and strict readers stop at the ones the writer leaves.
fn without_subclasses(text: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(text.len());
    let mut lines = text.split_inclusive(|&b| b == b'\n');
    while let (Some(code), Some(value)) = (lines.next(), lines.next()) {
        if code.trim_ascii() != b"100" {
            out.extend_from_slice(code);
            out.extend_from_slice(value);
        }
    }
    out
}
