//! `drawing.pdf`: the drawing that a machinist works from, one sheet for each cam.
//!
//! Lines and letters only (no pictures), with the fonts every reader has, so that the file stays small and its
//! numbers can be searched and copied. Lengths on the sheet are millimetres, angles degrees, in the frame of
//! the cam at θ = 0, the follower's motion upwards.

mod block;
mod helvetica;
mod layout;
mod pen;
mod radii;
mod table;
mod views;

use gaitcam::cam::{Bore, Cam};
use gaitcam::synth::Design;
use gaitcam::wording::Language;
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, TextStr};

use super::outline::Edge;
use crate::words::Words;
use layout::Layout;
use pen::{HELVETICA, POINT, Pen, SYMBOL, Stroke};
use radii::{farthest, radii};
use views::Views;

/// Rows of the table: one every 5°.
const ROWS: usize = 72;
/// Radius of the probing ball that the table is made for, m.
pub const BALL: f64 = 0.001;

/// What stands in the title block and is no part of the design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Title {
    /// The revision: it changes whenever the scene does.
    pub revision: Option<u32>,
    /// Date of the scene, where it is a file: days since 1970-01-01.
    pub date: Option<u64>,
    /// RMS force error allowed, part of the mean force.
    pub accuracy: f64,
}

/// RMS force error allowed where the scene says nothing, part of the mean force.
const USUAL_ACCURACY: f64 = 0.005;

impl Default for Title {
    fn default() -> Title {
        Title {
            revision: None,
            date: None,
            accuracy: USUAL_ACCURACY,
        }
    }
}

/// The revision that a scene's text stands for: its CRC-32.
pub fn revision(scene: &str) -> u32 {
    crc32fast::hash(scene.as_bytes())
}

/// One cam to be made.
struct Piece<'a> {
    cam: &'a Cam,
    edge: Edge<'a>,
    /// Key of its name where there are two.
    name: Option<&'static str>,
    bore: Option<Bore>,
    thickness: f64,
    clockwise: bool,
}

impl<'a> Piece<'a> {
    /// The cams of a design that turn.
    fn all(design: &'a Design) -> Vec<Self> {
        if design.cam.follower.is_unrolled() {
            return Vec::new();
        }
        let names = match design.conjugate {
            Some(_) => [Some("drawing-first"), Some("drawing-second")],
            None => [None, None],
        };
        let second = design.conjugate.as_ref().map(|pair| &pair.second);
        let cams = [&design.cam].into_iter().chain(second);
        let edges = Edge::all(design).into_iter().zip(names);
        cams.zip(edges)
            .map(|(cam, (edge, name))| Piece {
                cam,
                edge,
                name,
                bore: design.bore,
                thickness: design.thickness,
                clockwise: design.drive.speed < 0.0,
            })
            .collect()
    }

    fn base(&self) -> f64 {
        self.cam.follower.base_radius()
    }

    fn prime(&self) -> f64 {
        self.cam.follower.prime_radius()
    }

    /// Radius of the circle about the centre that holds everything drawn, m.
    fn radius(&self) -> f64 {
        let [x, y] = farthest(&self.edge, 1440).p;
        x.hypot(y).max(self.prime())
    }
}

/// The drawing; `None` for a cam that slides and for a barrel, which are not given by radii about a centre.
pub fn pdf(design: &Design, title: &Title, language: Language) -> Option<Vec<u8>> {
    let words = Words::new(language);
    let pieces = Piece::all(design);
    if pieces.is_empty() {
        return None;
    }
    let mut next = 0;
    let mut fresh = || {
        next += 1;
        Ref::new(next)
    };
    let (catalogue, tree, info) = (fresh(), fresh(), fresh());
    let fonts = [fresh(), fresh()];
    let sheets: Vec<(Ref, Ref)> = pieces.iter().map(|_| (fresh(), fresh())).collect();
    let mut pdf = Pdf::new();
    pdf.catalog(catalogue)
        .pages(tree)
        .lang(TextStr(words.tag()));
    pdf.document_info(info)
        .title(TextStr(&design.name))
        .creator(TextStr("gaitcam"));
    pdf.pages(tree)
        .kids(sheets.iter().map(|s| s.0))
        .count(i32::try_from(sheets.len()).unwrap_or(i32::MAX));
    for (i, (piece, (page, content))) in pieces.iter().zip(&sheets).enumerate() {
        let layout = Layout::of(piece.radius(), piece.thickness);
        let [width, height] = layout.paper.map(|mm| (POINT * mm) as f32);
        let mut sheet = pdf.page(*page);
        sheet
            .media_box(Rect::new(0.0, 0.0, width, height))
            .parent(tree)
            .contents(*content);
        let mut resources = sheet.resources();
        resources
            .fonts()
            .pair(HELVETICA, fonts[0])
            .pair(SYMBOL, fonts[1]);
        resources.finish();
        sheet.finish();
        let number = [i + 1, pieces.len()];
        let drawn = drawn((design, piece), title, number, &layout, &words);
        pdf.stream(*content, &drawn);
    }
    pdf.type1_font(fonts[0])
        .base_font(HELVETICA)
        .encoding_predefined(Name(b"WinAnsiEncoding"));
    pdf.type1_font(fonts[1]).base_font(SYMBOL);
    Some(pdf.finish())
}

/// One sheet.
fn drawn(
    (design, piece): (&Design, &Piece),
    title: &Title,
    number: [usize; 2],
    layout: &Layout,
    words: &Words,
) -> pdf_writer::Buf {
    let mut pen = Pen::new();
    let frame = layout.frame;
    pen.frame(
        [frame.left, frame.bottom],
        [frame.right, frame.top],
        Stroke::Outline,
    );
    Views::new(piece, layout, words).draw(&mut pen);
    let rows = radii(&piece.edge, BALL, ROWS);
    table::draw(&mut pen, &rows, BALL, layout, words);
    block::draw(&mut pen, (design, piece), title, number, layout, words);
    pen.finish()
}
