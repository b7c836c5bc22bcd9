//! `drawing.pdf`: the workshop drawing, one sheet for each cam that is a disc or a slide.
//!
//! Lines and letters only (no pictures), with the fonts every reader has, so that the file stays small and its
//! numbers can be searched and copied. Lengths on the sheet are millimetres or inches, angles degrees, in the frame of
//! the cam at θ = 0, the follower's motion upwards.

mod block;
mod disc;
mod helvetica;
mod layout;
mod leader;
mod pen;
mod piece;
mod radii;
mod slide;
mod table;
mod views;

use gaitcam::cam::Cam;
use gaitcam::synth::Design;
use gaitcam::wording::Language;
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, TextStr};

use crate::Units;
use crate::words::Labels;
use layout::Layout;
use pen::{HELVETICA, POINT, Pen, SYMBOL, Stroke};
use piece::Piece;
use slide::Slide;
use table::Table;

/// Radius of the probing ball that the table is made for, m.
pub const BALL: f64 = 0.001;

/// Entries of the title block that are no part of the design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Title {
    /// The revision: it changes whenever the scene does.
    pub revision: Option<u32>,
    /// Date of the scene, where it is a file: days since 1970-01-01.
    pub date: Option<u64>,
    /// RMS force error allowed, part of the mean force.
    pub accuracy: f64,
    /// Unit of the dimensions.
    pub units: Units,
}

/// RMS force error allowed where the scene says nothing, part of the mean force.
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

/// The revision of a scene: CRC-32 of its text.
pub fn revision(scene: &str) -> u32 {
    crc32fast::hash(scene.as_bytes())
}

/// What one sheet is about.
enum Subject<'a> {
    Disc(Piece<'a>),
    Slide(Slide<'a>),
}

impl<'a> Subject<'a> {
    /// The sheets of a design.
    fn all(design: &'a Design) -> Vec<Self> {
        if design.cam.follower.is_unrolled() {
            return vec![Subject::Slide(Slide::new(design))];
        }
        Piece::all(design).into_iter().map(Subject::Disc).collect()
    }

    fn layout(&self) -> Layout {
        match self {
            Subject::Disc(piece) => piece.layout(),
            Subject::Slide(slide) => slide.layout(),
        }
    }

    /// Draws the views; returns the table that belongs to them.
    fn draw(&self, pen: &mut Pen, layout: &Layout, words: &Labels) -> Table {
        match self {
            Subject::Disc(piece) => piece.draw(pen, layout, words),
            Subject::Slide(slide) => slide.draw(pen, layout, words),
        }
    }

    /// The cam that it shows, and its name where there are two.
    fn cam(&self, design: &'a Design) -> (&'a Cam, Option<&'static str>) {
        match self {
            Subject::Disc(piece) => (piece.cam, piece.name),
            Subject::Slide(_) => (&design.cam, None),
        }
    }
}

/// The drawing; `None` of a barrel, which has no sheet.
pub fn pdf(design: &Design, title: &Title, language: Language) -> Option<Vec<u8>> {
    if design.groove.is_some() {
        return None;
    }
    let words = Labels::new(language, title.units);
    let subjects = Subject::all(design);
    let mut next = 0;
    let mut fresh = || {
        next += 1;
        Ref::new(next)
    };
    let (catalogue, tree, info) = (fresh(), fresh(), fresh());
    let fonts = [fresh(), fresh()];
    let sheets: Vec<(Ref, Ref)> = subjects.iter().map(|_| (fresh(), fresh())).collect();
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
    for (i, (subject, (page, content))) in subjects.iter().zip(&sheets).enumerate() {
        let layout = subject.layout();
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
        let number = [i + 1, subjects.len()];
        let drawn = drawn((design, subject), title, number, &layout, &words);
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
    (design, subject): (&Design, &Subject),
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
    let table = subject.draw(&mut pen, layout, words);
    table::draw(&mut pen, &table, layout);
    let (cam, name) = subject.cam(design);
    block::draw(&mut pen, (design, cam, name), title, number, layout, words);
    pen.finish()
}
