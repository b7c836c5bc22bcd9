//! `cam.step`: the cam as an exact solid for CAD (ISO 10303-21, AP214).
//!
//! The profile is a periodic cubic B-spline through points at equal steps of the cam angle, C², refined until
//! it stays within [`FAITHFUL`] of the true one; the plate is its extrusion, the bore a cylinder. Lengths in mm.

use std::fmt::Write;

use super::outline::Edge;
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

const MM: f64 = 1000.0;
/// Largest distance of the spline from the true profile, m.
pub const FAITHFUL: f64 = 1e-7;
/// Spans of the first and of the finest spline that is tried.
const SPANS: [usize; 2] = [64, 16384];
/// Edges into which the profile is divided.
const EDGES: usize = 4;

/// The plate of `thickness` m with its bore.
///
/// # Errors
///
/// On a law that does not close, an undercut profile, a thickness that is not positive, and a profile that no
/// spline of so many spans follows.
pub fn plate(synthesis: &Design, thickness: f64) -> Result<Vec<u8>> {
    let cam = &synthesis.cam;
    if !(thickness.is_finite() && thickness > 0.0) {
        return Err(WriteError::PlateThickness {
            thickness: Quantity::length(thickness),
        }
        .into());
    }
    if !cam.law.is_closed() || cam.follower.is_unrolled() {
        return Err(WriteError::OpenProfile.into());
    }
    if cam.curvature().undercut {
        return Err(WriteError::UndercutProfile.into());
    }
    let edge = Edge::of(cam);
    let spline = Spline::within(&edge, FAITHFUL).ok_or(WriteError::TooSharp)?;
    let mut file = File::default();
    let bore = synthesis.bore.map(|b| 0.5 * MM * b);
    let shell = file.plate(&spline, MM * thickness, bore);
    Ok(file.finish(shell, &synthesis.name))
}

/// A closed uniform cubic B-spline, counter-clockwise, mm.
struct Spline {
    control: Vec<[f64; 2]>,
}

impl Spline {
    /// The coarsest spline that stays within `tolerance` m of the edge.
    fn within(edge: &Edge, tolerance: f64) -> Option<Self> {
        let mut spans = SPANS[0];
        while spans <= SPANS[1] {
            let spline = Spline::through(edge, spans);
            if spline.deviation(edge) <= MM * tolerance {
                return Some(spline);
            }
            spans *= 2;
        }
        None
    }

    /// Through `n` points at equal steps of the angle; the profile itself runs clockwise.
    fn through(edge: &Edge, n: usize) -> Self {
        let points: Vec<[f64; 2]> = (0..n)
            .map(|i| edge.at(angle(edge, n, i as f64)).p.map(|x| MM * x))
            .collect();
        let x = cyclic(points.iter().map(|p| p[0]).collect());
        let y = cyclic(points.iter().map(|p| p[1]).collect());
        Spline {
            control: x.into_iter().zip(y).map(|(x, y)| [x, y]).collect(),
        }
    }

    /// Control point `i`, counted round.
    fn at(&self, i: usize) -> [f64; 2] {
        self.control[i % self.control.len()]
    }

    /// Largest distance from the true edge along its normal, mm, at thirds of the spans.
    fn deviation(&self, edge: &Edge) -> f64 {
        let n = self.control.len();
        let mut worst = 0.0_f64;
        for i in 0..n {
            for u in [1.0 / 3.0, 0.5, 2.0 / 3.0] {
                let w: f64 = 1.0 - u;
                let weights = [
                    w * w * w,
                    3.0 * u * u * u - 6.0 * u * u + 4.0,
                    3.0 * w * w * w - 6.0 * w * w + 4.0,
                    u * u * u,
                ];
                let mut p = [0.0; 2];
                for (k, weight) in weights.into_iter().enumerate() {
                    let c = self.at(i + n - 1 + k);
                    p = [p[0] + weight * c[0] / 6.0, p[1] + weight * c[1] / 6.0];
                }
                let q = edge.at(angle(edge, n, i as f64 + u));
                let d = [p[0] - MM * q.p[0], p[1] - MM * q.p[1]];
                worst = worst.max((d[0] * q.t[1] - d[1] * q.t[0]).abs());
            }
        }
        worst
    }

    /// Spans `from` … `to` as a clamped B-spline of their own.
    fn part(&self, from: usize, to: usize) -> Vec<[f64; 2]> {
        let n = self.control.len();
        let mix = |all: &[(f64, usize)]| {
            let mut p = [0.0; 2];
            for &(weight, i) in all {
                let c = self.at(i);
                p = [p[0] + weight * c[0], p[1] + weight * c[1]];
            }
            p
        };
        let end = |i: usize| mix(&[(1.0 / 6.0, i + n - 1), (4.0 / 6.0, i), (1.0 / 6.0, i + 1)]);
        let mut out = vec![end(from), mix(&[(2.0 / 3.0, from), (1.0 / 3.0, from + 1)])];
        out.extend((from + 1..to).map(|i| self.at(i)));
        out.push(mix(&[(1.0 / 3.0, to + n - 1), (2.0 / 3.0, to)]));
        out.push(end(to));
        out
    }
}

/// Angle of place `i` of `n` against the profile's own sense.
fn angle(edge: &Edge, n: usize, i: f64) -> f64 {
    let breaks = edge.breaks();
    let (start, end) = (breaks[0], breaks[breaks.len() - 1]);
    end - (end - start) * i / n as f64
}

/// Solves (c₋ + 4c + c₊)/6 = p round a circle: Thomas' elimination with Sherman and Morrison's correction.
fn cyclic(points: Vec<f64>) -> Vec<f64> {
    let n = points.len();
    // The corners are taken out by adding their share to both end rows.
    let gamma = -4.0;
    let mut diagonal = vec![4.0; n];
    diagonal[0] -= gamma;
    diagonal[n - 1] -= 1.0 / gamma;
    let solve = |mut right: Vec<f64>| {
        let mut above = vec![0.0; n];
        let mut pivot = diagonal[0];
        right[0] /= pivot;
        for i in 1..n {
            above[i - 1] = 1.0 / pivot;
            pivot = diagonal[i] - above[i - 1];
            right[i] = (right[i] - right[i - 1]) / pivot;
        }
        for i in (0..n - 1).rev() {
            right[i] -= above[i] * right[i + 1];
        }
        right
    };
    let plain = solve(points.into_iter().map(|p| 6.0 * p).collect());
    let mut corner = vec![0.0; n];
    corner[0] = gamma;
    corner[n - 1] = 1.0;
    let corner = solve(corner);
    let share = (plain[0] + plain[n - 1] / gamma) / (1.0 + corner[0] + corner[n - 1] / gamma);
    plain
        .iter()
        .zip(&corner)
        .map(|(p, c)| p - share * c)
        .collect()
}

/// The instances of a file under way.
#[derive(Default)]
struct File {
    text: String,
    last: usize,
}

/// The instance of an edge of the solid.
type Rim = usize;

impl File {
    fn add(&mut self, entity: &str) -> usize {
        self.last += 1;
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "#{}={entity};", self.last);
        self.last
    }

    fn point(&mut self, p: [f64; 3]) -> usize {
        let [x, y, z] = p.map(real);
        self.add(&format!("CARTESIAN_POINT('',({x},{y},{z}))"))
    }

    fn direction(&mut self, d: [f64; 3]) -> usize {
        let [x, y, z] = d.map(real);
        self.add(&format!("DIRECTION('',({x},{y},{z}))"))
    }

    fn vertex(&mut self, p: [f64; 3]) -> usize {
        let point = self.point(p);
        self.add(&format!("VERTEX_POINT('',#{point})"))
    }

    /// Axes at height `z` with the given normal.
    fn axes(&mut self, z: f64, normal: f64) -> usize {
        let origin = self.point([0.0, 0.0, z]);
        let up = self.direction([0.0, 0.0, normal]);
        let right = self.direction([1.0, 0.0, 0.0]);
        self.add(&format!("AXIS2_PLACEMENT_3D('',#{origin},#{up},#{right})"))
    }

    fn edge(&mut self, from: usize, to: usize, curve: usize) -> Rim {
        self.add(&format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
    }

    fn upright(&mut self, at: [f64; 2], height: f64, from: usize, to: usize) -> Rim {
        let foot = self.point([at[0], at[1], 0.0]);
        let up = self.direction([0.0, 0.0, 1.0]);
        let vector = self.add(&format!("VECTOR('',#{up},{})", real(height)));
        let line = self.add(&format!("LINE('',#{foot},#{vector})"));
        self.edge(from, to, line)
    }

    /// A loop of edges, each taken along (`true`) or against its sense.
    fn ring(&mut self, edges: &[(Rim, bool)]) -> usize {
        let oriented: Vec<String> = edges
            .iter()
            .map(|(rim, along)| {
                let sense = if *along { ".T." } else { ".F." };
                let id = self.add(&format!("ORIENTED_EDGE('',*,*,#{rim},{sense})"));
                format!("#{id}")
            })
            .collect();
        self.add(&format!("EDGE_LOOP('',({}))", oriented.join(",")))
    }

    fn face(&mut self, surface: usize, outer: usize, inner: Option<usize>, along: bool) -> usize {
        let mut bounds = vec![self.add(&format!("FACE_OUTER_BOUND('',#{outer},.T.)"))];
        if let Some(inner) = inner {
            bounds.push(self.add(&format!("FACE_BOUND('',#{inner},.T.)")));
        }
        let bounds: Vec<String> = bounds.iter().map(|b| format!("#{b}")).collect();
        let sense = if along { ".T." } else { ".F." };
        self.add(&format!(
            "ADVANCED_FACE('',({}),#{surface},{sense})",
            bounds.join(",")
        ))
    }

    /// A clamped cubic B-spline at height `z`.
    fn curve(&mut self, control: &[[f64; 2]], z: f64) -> usize {
        let points: Vec<String> = control
            .iter()
            .map(|p| format!("#{}", self.point([p[0], p[1], z])))
            .collect();
        let spans = control.len() - 3;
        let mut counts = vec!["1"; spans + 1];
        (counts[0], counts[spans]) = ("4", "4");
        let knots: Vec<String> = (0..=spans).map(|k| format!("{k}.")).collect();
        self.add(&format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,({}),.UNSPECIFIED.,.F.,.F.,({}),({}),.UNSPECIFIED.)",
            points.join(","),
            counts.join(","),
            knots.join(",")
        ))
    }

    /// The plate's closed shell.
    fn plate(&mut self, spline: &Spline, height: f64, bore: Option<f64>) -> usize {
        let n = spline.control.len();
        let parts: Vec<Vec<[f64; 2]>> = (0..EDGES)
            .map(|k| spline.part(k * n / EDGES, (k + 1) * n / EDGES))
            .collect();
        let mut faces = Vec::new();
        let corners: Vec<[f64; 2]> = parts.iter().map(|p| p[0]).collect();
        let (low, high) = self.wall(&corners, height, &mut faces, |file, k, z| {
            file.curve(&parts[k], z)
        });
        let hole = bore.map(|radius| {
            // Two half circles, so that no edge meets itself.
            let corners = [[radius, 0.0], [-radius, 0.0]];
            let cylinder = {
                let axes = self.axes(0.0, 1.0);
                self.add(&format!("CYLINDRICAL_SURFACE('',#{axes},{})", real(radius)))
            };
            self.bore(&corners, height, cylinder, radius, &mut faces)
        });
        for (z, normal, rims) in [(0.0, -1.0, &low), (height, 1.0, &high)] {
            let axes = self.axes(z, normal);
            let plane = self.add(&format!("PLANE('',#{axes})"));
            let upper = normal > 0.0;
            let outer = self.round(rims, upper);
            let inner = hole.as_ref().map(|(low, high)| {
                let rims = if upper { high } else { low };
                self.round(rims, !upper)
            });
            faces.push(self.face(plane, outer, inner, true));
        }
        let faces: Vec<String> = faces.iter().map(|f| format!("#{f}")).collect();
        self.add(&format!("CLOSED_SHELL('',({}))", faces.join(",")))
    }

    /// A loop of edges that follow one another counter-clockwise, or the other way round.
    fn round(&mut self, rims: &[Rim], along: bool) -> usize {
        let mut edges: Vec<(Rim, bool)> = rims.iter().map(|r| (*r, along)).collect();
        if !along {
            edges.reverse();
        }
        self.ring(&edges)
    }

    /// The outer wall: faces between the lower and the upper edges, which are returned.
    fn wall(
        &mut self,
        corners: &[[f64; 2]],
        height: f64,
        faces: &mut Vec<usize>,
        curve: impl Fn(&mut Self, usize, f64) -> usize,
    ) -> (Vec<Rim>, Vec<Rim>) {
        let n = corners.len();
        let ends: Vec<[usize; 2]> = corners
            .iter()
            .map(|p| [0.0, height].map(|z| self.vertex([p[0], p[1], z])))
            .collect();
        let uprights: Vec<Rim> = (0..n)
            .map(|k| self.upright(corners[k], height, ends[k][0], ends[k][1]))
            .collect();
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for k in 0..n {
            let next = (k + 1) % n;
            let [below, above] = [0.0, height].map(|z| curve(self, k, z));
            low.push(self.edge(ends[k][0], ends[next][0], below));
            high.push(self.edge(ends[k][1], ends[next][1], above));
            let up = self.direction([0.0, 0.0, 1.0]);
            let vector = self.add(&format!("VECTOR('',#{up},{})", real(height)));
            let surface = self.add(&format!(
                "SURFACE_OF_LINEAR_EXTRUSION('',#{below},#{vector})"
            ));
            let ring = self.ring(&[
                (low[k], true),
                (uprights[next], true),
                (high[k], false),
                (uprights[k], false),
            ]);
            // Tangent × extrusion points outwards of a counter-clockwise profile.
            faces.push(self.face(surface, ring, None, true));
        }
        (low, high)
    }

    /// The bore's wall, which looks inwards.
    fn bore(
        &mut self,
        corners: &[[f64; 2]; 2],
        height: f64,
        cylinder: usize,
        radius: f64,
        faces: &mut Vec<usize>,
    ) -> (Vec<Rim>, Vec<Rim>) {
        let ends = corners.map(|p| [0.0, height].map(|z| self.vertex([p[0], p[1], z])));
        let uprights =
            [0, 1].map(|k: usize| self.upright(corners[k], height, ends[k][0], ends[k][1]));
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for k in 0..2 {
            let next = 1 - k;
            for (level, z, rims) in [(0, 0.0, &mut low), (1, height, &mut high)] {
                let axes = self.axes(z, 1.0);
                let circle = self.add(&format!("CIRCLE('',#{axes},{})", real(radius)));
                rims.push(self.edge(ends[k][level], ends[next][level], circle));
            }
            let ring = self.ring(&[
                (low[k], false),
                (uprights[k], true),
                (high[k], true),
                (uprights[next], false),
            ]);
            faces.push(self.face(cylinder, ring, None, false));
        }
        (low, high)
    }

    /// Product, units, header.
    fn finish(mut self, shell: usize, name: &str) -> Vec<u8> {
        let name = quoted(name);
        let solid = self.add(&format!("MANIFOLD_SOLID_BREP('cam',#{shell})"));
        let axes = self.axes(0.0, 1.0);
        let length = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        let angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let solid_angle = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let accuracy = self.add(&format!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-5),#{length},'distance_accuracy_value','')"
        ));
        let context = self.add(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{accuracy}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid_angle}))REPRESENTATION_CONTEXT('',''))"
        ));
        let shape = self.add(&format!(
            "ADVANCED_BREP_SHAPE_REPRESENTATION('',(#{axes},#{solid}),#{context})"
        ));
        let application =
            self.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        self.add(&format!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{application})"
        ));
        let discipline = self.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
        let product = self.add(&format!("PRODUCT('{name}','{name}','',(#{discipline}))"));
        let version = self.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let stage = self.add(&format!(
            "PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"
        ));
        let definition = self.add(&format!(
            "PRODUCT_DEFINITION('design','',#{version},#{stage})"
        ));
        let property = self.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        self.add(&format!(
            "SHAPE_DEFINITION_REPRESENTATION(#{property},#{shape})"
        ));
        // No clock: the same design gives the same bytes.
        format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n\
             FILE_NAME('{name}','2000-01-01T00:00:00',(''),(''),'gaitcam','gaitcam','');\n\
             FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n{}ENDSEC;\n\
             END-ISO-10303-21;\n",
            self.text
        )
        .into_bytes()
    }
}

/// A real with its point.
fn real(x: f64) -> String {
    let mut text = String::new();
    crate::number::append(&mut text, x, 12);
    if !text.contains('.') {
        text.push('.');
    }
    text
}

/// A text between apostrophes: printable ASCII, the rest as `?`.
fn quoted(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '\'' | '\\' => '_',
            c if c.is_ascii_graphic() || c == ' ' => c,
            _ => '?',
        })
        .collect()
}
