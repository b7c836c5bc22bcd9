//! Text on a page: outlines and widths of letters.

use std::ops::Range;

/// Output of the build script: table of the letters, followed by their outlines.
static LETTERS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/letters.bin"));
/// Number of bytes before the first row of the table of letters.
const HEAD: usize = 4;
const ROW: usize = 8;
const CORNER: usize = 5;

/// Distance, em, by which a letter is shifted and drawn a second time to make it bold. There is no bold typeface.
const EMBOLDENED: f64 = 0.06;
/// Maximum distance between a curve and the chords that replace it, pixels.
const UNSEEN: f64 = 0.1;

/// A letter of the typeface.
struct Letter {
    /// Distance from the start of this letter to the start of the next letter, em.
    advance: f64,
    contours: Range<usize>,
}

fn word(at: usize) -> u16 {
    u16::from_le_bytes([LETTERS[at], LETTERS[at + 1]])
}

/// Number of units of the typeface per em.
fn em() -> f64 {
    f64::from(word(2))
}

/// Index of a letter in the table of letters; `None` if the table does not contain the letter.
fn row(c: char) -> Option<usize> {
    let code = u16::try_from(u32::from(c)).ok()?;
    let (mut low, mut high) = (0, usize::from(word(0)));
    while low < high {
        let middle = low.midpoint(high);
        match word(HEAD + ROW * middle) {
            found if found < code => low = middle + 1,
            found if found == code => return Some(middle),
            _ => high = middle,
        }
    }
    None
}

/// Letter of the typeface for the character `c`, or a replacement character if the typeface has no such letter.
fn letter(c: char) -> Letter {
    let count = usize::from(word(0));
    let row = row(c).unwrap_or(0);
    let outlines = HEAD + ROW * count;
    let start = |row: usize| {
        let at = HEAD + ROW * row + 4;
        let low = usize::from(word(at));
        outlines + low + (usize::from(word(at + 2)) << 16)
    };
    let end = if row + 1 < count {
        start(row + 1)
    } else {
        LETTERS.len()
    };
    Letter {
        advance: f64::from(word(HEAD + ROW * row + 2)) / em(),
        contours: start(row)..end,
    }
}

/// Width of a text in regular weight, em.
pub fn text_width(text: &str) -> f64 {
    text.chars().map(|c| letter(c).advance).sum()
}

/// Divides a text into lines of at most `width` em, broken between words. A word that is longer than `width` has its own line.
pub fn wrapped<'a>(words: impl Iterator<Item = &'a str>, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if text_width(line) + text_width(" ") + text_width(word) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_string()),
        }
    }
    lines
}

/// A line of text on a baseline.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs)] // the names are the documentation
pub struct Line {
    pub text: String,
    /// Position of the start, middle or end of the baseline, points.
    pub at: [f64; 2],
    /// Height of an em, points.
    pub size: f64,
    /// Horizontal anchor of the text, as a fraction of its length: 0 if `at` is its start, ½ for its middle, 1 for its end.
    pub anchor: f64,
    pub bold: bool,
    pub upwards: bool,
}

impl Line {
    /// Outlines of the letters as polygons with equal orientation; coordinates in points.
    pub fn outline(&self) -> Vec<Vec<[f64; 2]>> {
        let shift = if self.bold { EMBOLDENED } else { 0.0 };
        let letters = || self.text.chars().map(letter);
        let total: f64 = letters().map(|l| l.advance + shift).sum();
        let [x, y] = self.at;
        let mut out = Vec::new();
        let mut pen = -total * self.anchor;
        for letter in letters() {
            for again in 0..1 + usize::from(self.bold) {
                let start = pen + again as f64 * shift;
                let on_page = |[right, up]: [f64; 2]| {
                    let (along, up) = (self.size * (start + right), self.size * up);
                    match self.upwards {
                        false => [x + along, y - up],
                        true => [x - up, y - along],
                    }
                };
                contours(&LETTERS[letter.contours.clone()], on_page, &mut out);
            }
            pen += letter.advance + shift;
        }
        out
    }
}

/// Adds the contours of a letter as polygons. `on_page` converts coordinates in em to positions on the page.
fn contours(
    mut bytes: &[u8],
    on_page: impl Fn([f64; 2]) -> [f64; 2],
    out: &mut Vec<Vec<[f64; 2]>>,
) {
    let em = em();
    while let Some((&count, rest)) = bytes.split_first() {
        let (corners, others) = rest.split_at(CORNER * usize::from(count));
        let mut polygon: Vec<[f64; 2]> = Vec::with_capacity(2 * usize::from(count));
        let mut control = None;
        for corner in corners.chunks_exact(CORNER) {
            let ems = |k: usize| f64::from(i16::from_le_bytes([corner[k], corner[k + 1]])) / em;
            let place = on_page([ems(1), ems(3)]);
            match (corner[0] == 1, control.take(), polygon.last()) {
                (false, ..) => control = Some(place),
                (true, Some(control), Some(&from)) => curve(from, control, place, &mut polygon),
                (true, ..) => polygon.push(place),
            }
        }
        out.push(polygon);
        bytes = others;
    }
}

/// Adds a quadratic Bézier curve as a series of chords. The first point of the curve is not added.
fn curve(from: [f64; 2], control: [f64; 2], to: [f64; 2], polygon: &mut Vec<[f64; 2]>) {
    // With n chords, the maximum distance is a quarter of the magnitude of the second difference of the control points, divided by n².
    let bend = |k: usize| from[k] - 2.0 * control[k] + to[k];
    let chords = (0.25 * libm::hypot(bend(0), bend(1)) / UNSEEN)
        .sqrt()
        .ceil()
        .max(1.0) as usize;
    polygon.extend((1..=chords).map(|i| {
        let t = i as f64 / chords as f64;
        let along = |k: usize| {
            let [a, b] = [
                from[k] + t * (control[k] - from[k]),
                control[k] + t * (to[k] - control[k]),
            ];
            a + t * (b - a)
        };
        [along(0), along(1)]
    }));
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use ab_glyph::{Font, FontRef, PxScale};

    use super::*;
    use crate::raster::Coverage;

    /// Characters of all texts of the workspace, in both languages.
    fn written(folder: &Path, all: &mut Vec<char>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() && !path.ends_with("target") && !path.ends_with("node_modules") {
                written(&path, all);
            } else if path.extension().is_some_and(|e| e == "ftl") {
                all.extend(fs::read_to_string(path).unwrap().chars());
            }
        }
    }

    #[test]
    fn every_character_of_the_texts_has_a_letter() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let mut all = Vec::new();
        written(&root.join("src"), &mut all);
        written(&root.join("crates"), &mut all);
        assert!(all.len() > 50_000, "{}", all.len());
        all.sort_unstable();
        all.dedup();
        all.retain(|&c| c != '\n' && row(c).is_none());
        assert!(all.is_empty(), "{all:?}");
    }

    #[test]
    fn letters_are_those_of_the_typeface() {
        let font = FontRef::try_from_slice(dejavu::sans::regular()).unwrap();
        let scale = PxScale::from(60.0 * font.height_unscaled() / font.units_per_em().unwrap());
        for c in "aÁñøθω²%·−°→∞Ж".chars() {
            let glyph = font.glyph_id(c);
            assert!(row(c).is_some(), "{c}");
            let ems = f64::from(font.h_advance_unscaled(glyph) / font.units_per_em().unwrap());
            assert_eq!(text_width(&c.to_string()), ems, "{c}");
            let mut expected = 0.0;
            let outline = font.outline_glyph(glyph.with_scale(scale)).unwrap();
            outline.draw(|_, _, covered| expected += f64::from(covered));
            let line = Line {
                text: c.to_string(),
                at: [10.0, 80.0],
                size: 60.0,
                anchor: 0.0,
                bold: false,
                upwards: false,
            };
            let mut coverage = Coverage::new(100, 100);
            for polygon in line.outline() {
                let next = polygon.iter().cycle().skip(1);
                (polygon.iter().zip(next)).for_each(|(p, q)| coverage.edge(*p, *q));
            }
            let mut found = 0.0;
            coverage.take(|_, columns, covered| found += columns.len() as f64 * f64::from(covered));
            assert!(
                (found / expected - 1.0).abs() < 0.01,
                "{c}: {found}, {expected}"
            );
        }
        let missing = letter('\u{5d0}');
        assert_eq!(missing.contours, letter('\0').contours);
    }
}
