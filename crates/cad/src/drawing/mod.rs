//! `drawing.pdf`: the workshop drawing, with one sheet per rotating cam.
//!
//! The file contains lines and text in standard fonts. It is therefore small, and its numbers can be searched and copied. Lengths in the drawing
//! are in millimetres or inches, angles in degrees. The cam is shown at θ = 0, with the motion of the follower upwards.

mod block;
mod disc;
mod helvetica;
mod layout;
mod leader;
mod pen;
mod piece;
mod radii;
mod table;
mod views;

use gaitcam::synth::Design;
use gaitcam::wording::Language;
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, TextStr};

use crate::Units;
use crate::words::Labels;
use layout::Layout;
use pen::{HELVETICA, POINT, Pen, SYMBOL, Stroke};
use piece::Piece;

/// Radius of the probing ball for the table of radii, m.
pub const BALL: f64 = 0.001;

/// Entries of the title block and settings that are not part of the design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Title {
    /// Revision of the scene, computed by [`revision`]; `None` if the revision is left blank.
    pub revision: Option<u32>,
    /// Date of the scene file, in days since 1970-01-01; `None` if the scene is not a file.
    pub date: Option<u64>,
    /// Permitted RMS force error, as a fraction of the mean force.
    pub accuracy: f64,
    /// Unit of the lengths in the drawing.
    pub units: Units,
}

/// Default permitted RMS force error, as a fraction of the mean force.
const USUAL_ACCURACY: f64 = 0.005;

impl Default for Title {
    fn default() -> Title {
        Title {
            revision: None,
            date: None,
            accuracy: USUAL_ACCURACY,
            units: Units::default(),
        }
    }
}

/// Revision of a scene: CRC-32 of its text. It changes with every change of the text.
pub fn revision(scene: &str) -> u32 {
    crc32fast::hash(scene.as_bytes())
}

/// Drawing as a PDF file; `None` for a barrel cam and a translating cam.
pub fn pdf(design: &Design, title: &Title, language: Language) -> Option<Vec<u8>> {
    if design.cam.follower.is_unrolled() {
        return None;
    }
    let words = Labels::new(language, title.units);
    let pieces = Piece::all(design);
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
        .title(TextStr(&design.problem.name))
        .creator(TextStr("gaitcam"));
    pdf.pages(tree)
        .kids(sheets.iter().map(|s| s.0))
        .count(i32::try_from(sheets.len()).unwrap_or(i32::MAX));
    for (i, (piece, (page, content))) in pieces.iter().zip(&sheets).enumerate() {
        let layout = piece.layout();
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

/// Draws the sheet of one cam and returns its content stream.
fn drawn(
    (design, piece): (&Design, &Piece),
    title: &Title,
    number: [usize; 2],
    layout: &Layout,
    words: &Labels,
) -> pdf_writer::Buf {
    let mut pen = Pen::new();
    let frame = layout.frame;
    pen.frame(
        [frame.left, frame.bottom],
        [frame.right, frame.top],
        Stroke::Outline,
    );
    let table = piece.draw(&mut pen, layout, words);
    table::draw(&mut pen, &table, layout);
    block::draw(
        &mut pen,
        (design, piece.cam, piece.name),
        title,
        number,
        layout,
        words,
    );
    pen.finish()
}
