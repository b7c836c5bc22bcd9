//! Contents of a DXF file: header, tables, blocks and entities in the dialects R12 and R2000.
//!
//! Source: Autodesk, DXF Reference (R12; 2000). A group is a code on one line and its value on the next line. Since R13, every object has a handle
//! (group 5), an owner (330) and subclass markers (100). Tables, block records and the root dictionary are required even if they are empty.

use std::fmt::{Display, Write};

use super::Version;
use crate::Units;
use crate::spline::Clamped;
use gaitcam_base::text::append;

/// Entity of the drawing; lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Polyline. A vertex contains x, y and the bulge of the following edge. The bulge is the tangent of a quarter of the arc's angle, and
    /// 0 for a chord.
    Polyline {
        vertices: Vec<[f64; 3]>,
        closed: bool,
    },
    /// Cubic B-spline curve with clamped ends.
    Spline(Clamped),
    /// Circle about the origin of the drawing.
    Circle { radius: f64 },
    /// Straight line between two points.
    Line { ends: [[f64; 2]; 2] },
    /// ASCII text that begins at a point; `%%d` is the degree sign.
    Text {
        at: [f64; 2],
        height: f64,
        text: &'static str,
    },
}

/// Drawing that consists of shapes on layers.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    pub version: Version,
    /// Unit of lengths in the file.
    pub units: Units,
    /// Names of the layers with their AutoCAD colour indices.
    pub layers: Vec<(&'static str, u8)>,
    pub shapes: Vec<(&'static str, Shape)>,
    /// Lower left and upper right corners of the drawing, mm.
    pub extent: [[f64; 2]; 2],
}

impl Drawing {
    /// Content of the DXF file. Equal drawings give equal bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut body = Groups::new(self.version, self.units);
        let space = self.tables(&mut body);
        self.entities(&mut body, space);
        if body.later {
            objects(&mut body);
        }
        body.put(0, "EOF");
        // The header contains the first free handle, which is known only at the end.
        let mut file = Groups::new(self.version, self.units);
        self.header(&mut file, body.handle);
        file.text.push_str(&body.text);
        file.text.into_bytes()
    }

    fn header(&self, out: &mut Groups, free: u32) {
        let version = match self.version {
            Version::R12 => "AC1009",
            Version::R2000 => "AC1015",
        };
        out.section("HEADER");
        out.put(9, "$ACADVER").put(1, version);
        if out.later {
            out.put(9, "$DWGCODEPAGE").put(3, "ANSI_1252");
            out.put(9, "$HANDSEED").put(5, format!("{free:X}"));
        }
        let [unit, measurement] = match self.units {
            Units::Millimetres => [4, 1],
            Units::Inches => [1, 0],
        };
        // R12 has no variable for units. Programs that read R12 use the variable of later dialects.
        out.put(9, "$INSUNITS").put(70, unit);
        out.put(9, "$MEASUREMENT").put(70, measurement);
        for (name, [x, y]) in ["$EXTMIN", "$EXTMAX"].into_iter().zip(self.extent) {
            out.put(9, name).point(10, [x, y]);
        }
        out.put(0, "ENDSEC");
    }

    /// Writes the tables and the blocks. Returns the handle of the model space.
    fn tables(&self, out: &mut Groups) -> u32 {
        out.section("TABLES");
        out.table("VPORT", &[], |_, _| {});
        let types = if out.later {
            &["ByBlock", "ByLayer", "Continuous"][..]
        } else {
            &["CONTINUOUS"]
        };
        out.table("LTYPE", types, |out, name| {
            out.class("AcDbLinetypeTableRecord");
            out.put(2, name).put(70, 0).put(3, "").put(72, 65);
            out.put(73, 0).put(40, "0.0");
        });
        let layers = self.layers.iter().map(|l| l.0);
        let layers: Vec<&str> = ["0"].into_iter().chain(layers).collect();
        out.table("LAYER", &layers, |out, name| {
            let colour = self.layers.iter().find(|l| l.0 == name).map_or(7, |l| l.1);
            out.class("AcDbLayerTableRecord");
            let solid = if out.later {
                "Continuous"
            } else {
                "CONTINUOUS"
            };
            out.put(2, name).put(70, 0).put(62, colour).put(6, solid);
        });
        out.table("STYLE", &["Standard"], |out, name| {
            out.class("AcDbTextStyleTableRecord");
            out.put(2, name).put(70, 0).put(40, "0.0").put(41, "1.0");
            out.put(50, "0.0")
                .put(71, 0)
                .put(42, "2.5")
                .put(3, "txt")
                .put(4, "");
        });
        out.table("VIEW", &[], |_, _| {});
        out.table("UCS", &[], |_, _| {});
        out.table("APPID", &["ACAD"], |out, name| {
            out.class("AcDbRegAppTableRecord");
            out.put(2, name).put(70, 0);
        });
        out.table("DIMSTYLE", &["Standard"], |out, name| {
            out.class("AcDbDimStyleTableRecord");
            out.put(2, name).put(70, 0);
        });
        let spaces = ["*Model_Space", "*Paper_Space"];
        let records = if out.later {
            out.table("BLOCK_RECORD", &spaces, |out, name| {
                out.class("AcDbBlockTableRecord");
                out.put(2, name);
            })
        } else {
            Vec::new()
        };
        out.put(0, "ENDSEC");
        blocks(out, spaces, &records);
        records.first().copied().unwrap_or(0)
    }

    fn entities(&self, out: &mut Groups, space: u32) {
        out.section("ENTITIES");
        for (layer, shape) in &self.shapes {
            match shape {
                Shape::Polyline { vertices, closed } => {
                    out.polyline(space, layer, vertices, *closed);
                }
                Shape::Spline(spline) => out.spline(space, layer, spline),
                Shape::Circle { radius } => {
                    out.entity("CIRCLE", "AcDbCircle", space, layer);
                    out.point(10, [0.0; 2]).length(40, *radius);
                }
                Shape::Line { ends: [from, to] } => {
                    out.entity("LINE", "AcDbLine", space, layer);
                    out.point(10, *from).point(11, *to);
                }
                Shape::Text { at, height, text } => {
                    out.entity("TEXT", "AcDbText", space, layer);
                    out.point(10, *at).length(40, *height).put(1, text);
                    out.class("AcDbText");
                }
            }
        }
        out.put(0, "ENDSEC");
    }
}

/// Writes the root dictionary. The format requires it even if it has only the entry for groups.
fn objects(out: &mut Groups) {
    out.section("OBJECTS");
    let root = out.object("DICTIONARY", 0, &["AcDbDictionary"]);
    let groups = out.handle;
    out.put(281, 1).put(3, "ACAD_GROUP");
    out.put(350, format!("{groups:X}"));
    out.object("DICTIONARY", root, &["AcDbDictionary"]);
    out.put(281, 1).put(0, "ENDSEC");
}

/// Text of a file, extended group by group.
struct Groups {
    text: String,
    /// Whether the dialect is R13 or later, in which objects have handles, owners and subclasses.
    later: bool,
    /// Handle of the next object.
    handle: u32,
    /// Factor that converts millimetres to the unit of the file.
    scale: f64,
}

/// Writes the empty blocks of the model space and the paper space, whose names are in `spaces`.
fn blocks(out: &mut Groups, spaces: [&str; 2], records: &[u32]) {
    out.section("BLOCKS");
    for (name, &record) in spaces.into_iter().zip(records) {
        out.object("BLOCK", record, &["AcDbEntity"]);
        out.put(8, "0").class("AcDbBlockBegin");
        out.put(2, name).put(70, 0).point(10, [0.0; 2]);
        out.put(3, name).put(1, "");
        out.object("ENDBLK", record, &["AcDbEntity"]);
        out.put(8, "0").class("AcDbBlockEnd");
    }
    out.put(0, "ENDSEC");
}

impl Groups {
    fn new(version: Version, units: Units) -> Self {
        Groups {
            text: String::new(),
            later: version != Version::R12,
            handle: 1,
            scale: 1e-3 * units.per_metre(),
        }
    }

    fn put(&mut self, code: u16, value: impl Display) -> &mut Self {
        // Writing to a String cannot fail.
        let _ = write!(self.text, "{code:3}\r\n{value}\r\n");
        self
    }

    fn section(&mut self, name: &str) {
        self.put(0, "SECTION").put(2, name);
    }

    /// Writes a group with a length, which is given in mm and written in the unit of the file.
    fn length(&mut self, code: u16, x: f64) -> &mut Self {
        self.number(code, self.scale * x)
    }

    /// Writes a group with a real number, with a decimal point and at most 12 decimals.
    fn number(&mut self, code: u16, x: f64) -> &mut Self {
        let mut text = String::with_capacity(24);
        append(&mut text, x, 12);
        if !text.contains('.') {
            text.push_str(".0");
        }
        self.put(code, text)
    }

    fn point(&mut self, code: u16, [x, y]: [f64; 2]) -> &mut Self {
        self.length(code, x)
            .length(code + 10, y)
            .put(code + 20, "0.0")
    }

    fn class(&mut self, name: &str) -> &mut Self {
        if self.later {
            self.put(100, name);
        }
        self
    }

    /// Starts an object and returns the handle that is assigned to it.
    fn object(&mut self, kind: &str, owner: u32, classes: &[&str]) -> u32 {
        self.put(0, kind);
        let own = self.handle;
        if self.later {
            self.handle += 1;
            // The handle of a dimension style has a separate group code.
            let code = if kind == "DIMSTYLE" { 105 } else { 5 };
            self.put(code, format!("{own:X}"));
            self.put(330, format!("{owner:X}"));
        }
        for class in classes {
            self.class(class);
        }
        own
    }

    /// Writes a table of named records. `rest` completes each record. Returns the handles of the records.
    fn table(&mut self, kind: &str, names: &[&str], rest: impl Fn(&mut Self, &str)) -> Vec<u32> {
        self.put(0, "TABLE").put(2, kind);
        let own = self.handle;
        if self.later {
            self.handle += 1;
            self.put(5, format!("{own:X}")).put(330, 0);
        }
        self.class("AcDbSymbolTable").put(70, names.len());
        if kind == "DIMSTYLE" {
            self.class("AcDbDimStyleTable");
        }
        let mut handles = Vec::new();
        for name in names {
            handles.push(self.object(kind, own, &["AcDbSymbolTableRecord"]));
            rest(self, name);
        }
        self.put(0, "ENDTAB");
        handles
    }

    fn entity(&mut self, kind: &str, class: &str, space: u32, layer: &str) {
        self.object(kind, space, &["AcDbEntity"]);
        self.put(8, layer).class(class);
    }

    /// Writes a spline, which R12 does not support. Bit 8 of its flags marks it as planar.
    fn spline(&mut self, space: u32, layer: &str, Clamped { control, knots }: &Clamped) {
        self.entity("SPLINE", "AcDbSpline", space, layer);
        self.put(210, "0.0").put(220, "0.0").put(230, "1.0");
        let count: usize = knots.iter().map(|k| k.0).sum();
        self.put(70, 8)
            .put(71, 3)
            .put(72, count)
            .put(73, control.len());
        self.put(74, 0).put(42, "1e-9").put(43, "1e-9");
        for &(times, value) in knots {
            for _ in 0..times {
                self.number(40, value);
            }
        }
        for p in control {
            self.point(10, *p);
        }
    }

    /// Writes a polyline. R12 supports only the heavy polyline, in which each vertex is a separate entity.
    fn polyline(&mut self, space: u32, layer: &str, vertices: &[[f64; 3]], closed: bool) {
        let flag = u8::from(closed);
        if self.later {
            self.entity("LWPOLYLINE", "AcDbPolyline", space, layer);
            self.put(90, vertices.len()).put(70, flag);
            for &[x, y, bulge] in vertices {
                self.length(10, x).length(20, y).number(42, bulge);
            }
            return;
        }
        self.entity("POLYLINE", "", space, layer);
        self.put(66, 1).put(70, flag).point(10, [0.0; 2]);
        for &[x, y, bulge] in vertices {
            self.put(0, "VERTEX").put(8, layer);
            self.point(10, [x, y]).number(42, bulge);
        }
        self.put(0, "SEQEND").put(8, layer);
    }
}
