//! Extracts the outlines of the letters that figures may contain from the typeface. The result has a seventh of the size and needs no parsing.
//!
//! Format of `letters.bin`, little-endian: number of letters and units per em (u16 each). Per letter, in ascending order: code and advance (u16
//! each), and start of its outline among the bytes after the table (u32). Then the outlines. A contour consists of the number of its corners (u8)
//! and, for each corner, whether it is on the curve (u8), x and y (i16), with y upwards. A corner off the curve is the control point between its
//! neighbours. The first letter, of code 0, replaces missing ones.

use std::path::Path;
use std::{env, fs};

use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Codes of the letters: Latin of Europe, accents, Greek, Cyrillic, punctuation, signs.
const LETTERS: [[u16; 2]; 12] = [
    [0x0020, 0x007e],
    [0x00a0, 0x017f],
    [0x02bc, 0x02dd],
    [0x0300, 0x030c],
    [0x0370, 0x045f],
    [0x1e9e, 0x1e9e],
    [0x2010, 0x204a],
    [0x2070, 0x20ac],
    [0x2100, 0x2126],
    [0x2190, 0x2199],
    [0x21d0, 0x21d4],
    [0x2200, 0x2265],
];

#[derive(Default)]
struct Contours {
    bytes: Vec<u8>,
    /// Corners of the contour that is being read.
    corners: Vec<(bool, [i16; 2])>,
}

impl Contours {
    fn add(&mut self, on_curve: bool, x: f32, y: f32) {
        self.corners
            .push((on_curve, [x, y].map(|q| q.round() as i16)));
    }
}

impl OutlineBuilder for Contours {
    fn move_to(&mut self, x: f32, y: f32) {
        self.add(true, x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add(true, x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.add(false, x1, y1);
        self.add(true, x, y);
    }

    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {
        unreachable!("TrueType outlines have no cubic curves");
    }

    fn close(&mut self) {
        let corners = std::mem::take(&mut self.corners);
        self.bytes.push(u8::try_from(corners.len()).unwrap());
        for (on_curve, place) in corners {
            self.bytes.push(u8::from(on_curve));
            self.bytes
                .extend(place.iter().flat_map(|q| q.to_le_bytes()));
        }
    }
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let face = Face::parse(dejavu::sans::regular(), 0).unwrap();
    let codes = LETTERS.iter().flat_map(|&[first, last]| first..=last);
    let found =
        codes.filter_map(|code| Some((code, face.glyph_index(char::from_u32(code.into())?)?)));
    let letters: Vec<(u16, GlyphId)> = [(0, GlyphId(0))].into_iter().chain(found).collect();
    let mut outlines = Contours::default();
    let mut table = [letters.len() as u16, face.units_per_em()]
        .map(u16::to_le_bytes)
        .concat();
    for (code, glyph) in letters {
        let advance = face.glyph_hor_advance(glyph).unwrap();
        table.extend([code, advance].map(u16::to_le_bytes).as_flattened());
        table.extend((outlines.bytes.len() as u32).to_le_bytes());
        face.outline_glyph(glyph, &mut outlines);
    }
    table.extend(outlines.bytes);
    let out = env::var_os("OUT_DIR").unwrap();
    fs::write(Path::new(&out).join("letters.bin"), table).unwrap();
}
