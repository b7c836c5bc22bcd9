//! Entities of a STEP file (ISO 10303-21), and the topology of extruded solids.

use std::fmt::Write;

use crate::spline::Clamped;

/// Part of a closed outline, counter-clockwise, mm.
#[derive(Debug, Clone)]
pub enum Piece {
    /// A clamped cubic B-spline curve.
    Spline(Clamped),
    /// A straight line from the first point to the second.
    Line([[f64; 2]; 2]),
    /// A circular arc about a centre, between two points.
    Arc {
        ends: [[f64; 2]; 2],
        centre: [f64; 2],
        radius: f64,
    },
}

impl Piece {
    fn start(&self) -> [f64; 2] {
        match self {
            Piece::Spline(spline) => spline.control[0],
            Piece::Line(ends) | Piece::Arc { ends, .. } => ends[0],
        }
    }
}

/// Circle as two arcs, because an edge must not start and end at the same vertex.
pub fn circle(centre: [f64; 2], radius: f64) -> Vec<Piece> {
    let at = |side: f64| [centre[0] + side * radius, centre[1]];
    let arc = |from: f64| Piece::Arc {
        ends: [at(from), at(-from)],
        centre,
        radius,
    };
    vec![arc(1.0), arc(-1.0)]
}

/// Number of the STEP entity of an edge.
type Rim = usize;

/// Bottom and top edges of a wall, as numbers of STEP entities.
pub struct Rims {
    pub low: Vec<Rim>,
    pub high: Vec<Rim>,
}

/// Entities of a file, numbered in the order in which they are added.
#[derive(Default)]
pub struct File {
    text: String,
    last: usize,
}

impl File {
    pub fn add(&mut self, entity: &str) -> usize {
        self.last += 1;
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "#{}={entity};", self.last);
        self.last
    }

    pub fn point(&mut self, p: [f64; 3]) -> usize {
        let [x, y, z] = p.map(real);
        self.add(&format!("CARTESIAN_POINT('',({x},{y},{z}))"))
    }

    fn direction(&mut self, d: [f64; 3]) -> usize {
        let [x, y, z] = d.map(real);
        self.add(&format!("DIRECTION('',({x},{y},{z}))"))
    }

    pub fn vertex(&mut self, p: [f64; 3]) -> usize {
        let point = self.point(p);
        self.add(&format!("VERTEX_POINT('',#{point})"))
    }

    /// Adds an axis system at a point, with z along `normal` and x along `right`.
    fn axes(&mut self, at: [f64; 3], normal: [f64; 3], right: [f64; 3]) -> usize {
        let origin = self.point(at);
        let up = self.direction(normal);
        let right = self.direction(right);
        self.add(&format!("AXIS2_PLACEMENT_3D('',#{origin},#{up},#{right})"))
    }

    fn level(&mut self, [x, y]: [f64; 2], z: f64, normal: f64) -> usize {
        self.axes([x, y, z], [0.0, 0.0, normal], [1.0, 0.0, 0.0])
    }

    pub fn edge(&mut self, from: usize, to: usize, curve: usize) -> Rim {
        self.add(&format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
    }

    pub fn line(&mut self, from: [f64; 3], to: [f64; 3]) -> usize {
        let d = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        let foot = self.point(from);
        let along = self.direction(d.map(|x| x / length));
        let vector = self.add(&format!("VECTOR('',#{along},{})", real(length)));
        self.add(&format!("LINE('',#{foot},#{vector})"))
    }

    /// Adds a circle at the height z, counter-clockwise.
    pub fn circle(&mut self, centre: [f64; 2], radius: f64, z: f64) -> usize {
        let axes = self.level(centre, z, 1.0);
        self.add(&format!("CIRCLE('',#{axes},{})", real(radius)))
    }

    /// Adds a cylinder about a vertical axis, with an outward normal.
    pub fn cylinder(&mut self, centre: [f64; 2], radius: f64, z: f64) -> usize {
        let axes = self.level(centre, z, 1.0);
        self.add(&format!("CYLINDRICAL_SURFACE('',#{axes},{})", real(radius)))
    }

    /// Adds the curve of one part of an outline at the height z.
    fn curve(&mut self, piece: &Piece, z: f64) -> usize {
        match piece {
            Piece::Line([a, b]) => self.line([a[0], a[1], z], [b[0], b[1], z]),
            Piece::Arc { centre, radius, .. } => self.circle(*centre, *radius, z),
            Piece::Spline(Clamped { control, knots }) => {
                let points: Vec<[f64; 3]> = control.iter().map(|p| [p[0], p[1], z]).collect();
                self.spline_curve(&points, knots)
            }
        }
    }

    /// Adds the vertical surface over one part of an outline, from the height `low` to the height `high`. Seen along the direction of the
    /// outline, the normal of the surface points to the right.
    fn surface(&mut self, piece: &Piece, [low, high]: [f64; 2]) -> usize {
        match piece {
            Piece::Line([a, b]) => {
                let d = [b[0] - a[0], b[1] - a[1]];
                let length = libm::hypot(d[0], d[1]);
                let d = d.map(|x| x / length);
                let axes = self.axes([a[0], a[1], low], [d[1], -d[0], 0.0], [d[0], d[1], 0.0]);
                self.add(&format!("PLANE('',#{axes})"))
            }
            Piece::Arc { centre, radius, .. } => self.cylinder(*centre, *radius, low),
            Piece::Spline(Clamped { control, knots }) => {
                // Index of the control points: first along the curve, then upwards.
                let net: Vec<Vec<[f64; 3]>> = (control.iter())
                    .map(|p| [low, high].map(|z| [p[0], p[1], z]).to_vec())
                    .collect();
                self.spline_surface(&net, [knots, &[(2, 0.0), (2, 1.0)]])
            }
        }
    }

    /// Adds a loop of edges. Each edge is used in its own direction (`true`) or in the opposite direction.
    pub fn ring(&mut self, edges: &[(Rim, bool)]) -> usize {
        let oriented: Vec<usize> = (edges.iter())
            .map(|(rim, along)| {
                self.add(&format!("ORIENTED_EDGE('',*,*,#{rim},{})", truth(*along)))
            })
            .collect();
        self.add(&format!("EDGE_LOOP('',{})", list(&oriented)))
    }

    /// Adds a loop of consecutive edges, in their direction (`along`) or in the opposite direction and order.
    fn round(&mut self, rims: &[Rim], along: bool) -> usize {
        let mut edges: Vec<(Rim, bool)> = rims.iter().map(|r| (*r, along)).collect();
        if !along {
            edges.reverse();
        }
        self.ring(&edges)
    }

    pub fn face(&mut self, surface: usize, outer: usize, inner: &[usize], along: bool) -> usize {
        let mut bounds = vec![self.add(&format!("FACE_OUTER_BOUND('',#{outer},.T.)"))];
        for ring in inner {
            bounds.push(self.add(&format!("FACE_BOUND('',#{ring},.T.)")));
        }
        let (bounds, sense) = (list(&bounds), truth(along));
        self.add(&format!("ADVANCED_FACE('',{bounds},#{surface},{sense})"))
    }

    /// Adds the vertical wall over an outline between two heights, and appends its faces to `faces`. Returns the edges of the wall. The material is
    /// inside the outline, or outside it for a hole.
    pub fn wall(
        &mut self,
        pieces: &[Piece],
        z: [f64; 2],
        hole: bool,
        faces: &mut Vec<usize>,
    ) -> Rims {
        let n = pieces.len();
        let corners: Vec<[f64; 2]> = pieces.iter().map(Piece::start).collect();
        let ends: Vec<[usize; 2]> = (corners.iter())
            .map(|p| z.map(|z| self.vertex([p[0], p[1], z])))
            .collect();
        let uprights: Vec<Rim> = (0..n)
            .map(|k| {
                let [x, y] = corners[k];
                let line = self.line([x, y, z[0]], [x, y, z[1]]);
                self.edge(ends[k][0], ends[k][1], line)
            })
            .collect();
        let mut rims = Rims {
            low: Vec::new(),
            high: Vec::new(),
        };
        for (k, piece) in pieces.iter().enumerate() {
            let next = (k + 1) % n;
            let [below, above] = z.map(|z| self.curve(piece, z));
            let (low, high) = (
                self.edge(ends[k][0], ends[next][0], below),
                self.edge(ends[k][1], ends[next][1], above),
            );
            let surface = self.surface(piece, z);
            let (left, right) = (uprights[k], uprights[next]);
            let ring = if hole {
                [(low, false), (left, true), (high, true), (right, false)]
            } else {
                [(low, true), (right, true), (high, false), (left, false)]
            };
            let ring = self.ring(&ring);
            faces.push(self.face(surface, ring, &[], !hole));
            rims.low.push(low);
            rims.high.push(high);
        }
        rims
    }

    /// Adds a horizontal face inside an outline and outside the holes, and appends it to `faces`. Its normal points upwards or downwards.
    pub fn cap(
        &mut self,
        z: f64,
        up: bool,
        outer: &[Rim],
        holes: &[&[Rim]],
        faces: &mut Vec<usize>,
    ) {
        let axes = self.level([0.0; 2], z, if up { 1.0 } else { -1.0 });
        let plane = self.add(&format!("PLANE('',#{axes})"));
        let outer = self.round(outer, up);
        let inner: Vec<usize> = holes.iter().map(|rims| self.round(rims, !up)).collect();
        faces.push(self.face(plane, outer, &inner, true));
    }

    /// Adds the solid that is bounded by the faces.
    pub fn solid(&mut self, name: &str, faces: &[usize]) -> usize {
        let shell = self.add(&format!("CLOSED_SHELL('',{})", list(faces)));
        self.add(&format!("MANIFOLD_SOLID_BREP('{name}',#{shell})"))
    }

    /// Adds the product and the units, and returns the content of the file with its header.
    pub fn finish(mut self, solids: &[usize], name: &str) -> Vec<u8> {
        let name = quoted(name);
        let mut items = vec![self.level([0.0; 2], 0.0, 1.0)];
        items.extend(solids);
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
            "ADVANCED_BREP_SHAPE_REPRESENTATION('',{},#{context})",
            list(&items)
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
        // The header contains no time stamp, so equal designs give equal bytes.
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

/// STEP list of references to entities.
pub fn list(instances: &[usize]) -> String {
    let all: Vec<String> = instances.iter().map(|i| format!("#{i}")).collect();
    format!("({})", all.join(","))
}

/// Logical value in STEP syntax.
fn truth(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}

/// Real number in STEP syntax, with a decimal point.
pub fn real(x: f64) -> String {
    let mut text = String::new();
    gaitcam_base::text::append(&mut text, x, 12);
    if !text.contains('.') {
        text.push('.');
    }
    text
}

/// Text in STEP syntax, in quotation marks. Characters other than printable ASCII are replaced by `?`.
fn quoted(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '\'' | '\\' => '_',
            c if c.is_ascii_graphic() || c == ' ' => c,
            _ => '?',
        })
        .collect()
}
