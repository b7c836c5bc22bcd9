//! Letters as outlines on a page.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, OutlinedGlyph, PxScale, ScaleFont, point};

static FONT: LazyLock<Option<FontRef<'static>>> =
    LazyLock::new(|| FontRef::try_from_slice(dejavu::sans::regular()).ok());

/// Ems by which a bold letter is drawn again to the right: a second face would add 0.7 MB to the program.
const EMBOLDENED: f32 = 0.06;

/// Width of a text in ems, regular weight.
pub fn text_width(text: &str) -> f64 {
    let Some(font) = &*FONT else {
        return 0.0;
    };
    let em = f64::from(font.units_per_em().unwrap_or(2048.0));
    text.chars()
        .map(|c| f64::from(font.h_advance_unscaled(font.glyph_id(c))) / em)
        .sum()
}

/// Lines of at most `width` ems of words that stay whole; a longer word has its own line.
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
    /// Where the baseline starts, is centred or ends, points.
    pub at: [f64; 2],
    /// Height of an em, points.
    pub size: f64,
    /// 0 for the start, ½ for the middle, 1 for the end.
    pub anchor: f64,
    pub bold: bool,
    pub upwards: bool,
}

/// A letter in its place.
pub struct Letter {
    outline: OutlinedGlyph,
    /// The pixel about which an upward letter is turned.
    turned_about: Option<[i64; 2]>,
}

impl Letter {
    /// The letters of a line; blanks have none.
    pub fn all(line: &Line) -> Vec<Letter> {
        let Some(font) = &*FONT else {
            return Vec::new();
        };
        let em = font.units_per_em().unwrap_or(2048.0);
        let scale = PxScale::from(line.size as f32 * font.height_unscaled() / em);
        let scaled = font.as_scaled(scale);
        let shift = if line.bold {
            EMBOLDENED * line.size as f32
        } else {
            0.0
        };
        let advance = |c: char| scaled.h_advance(scaled.glyph_id(c)) + shift;
        let total: f32 = line.text.chars().map(advance).sum();
        // Upright text is placed to a fraction of a pixel; turned text is turned pixel by pixel.
        let turned_about = line.upwards.then(|| line.at.map(|x| x.round() as i64));
        let [left, baseline] = if line.upwards { [0.0; 2] } else { line.at };
        let mut pen = -total * line.anchor as f32;
        let mut letters = Vec::with_capacity(line.text.len());
        for c in line.text.chars() {
            for again in if line.bold { &[0.0, 1.0][..] } else { &[0.0] } {
                let place = point(left as f32 + pen + again * shift, baseline as f32);
                let glyph = scaled.glyph_id(c).with_scale_and_position(scale, place);
                letters.extend(font.outline_glyph(glyph).map(|outline| Letter {
                    outline,
                    turned_about,
                }));
            }
            pen += advance(c);
        }
        letters
    }

    /// Rows that the letter may touch: first, one past the last.
    pub fn rows(&self) -> [f64; 2] {
        let bounds = self.outline.px_bounds();
        match self.turned_about {
            None => [f64::from(bounds.min.y), f64::from(bounds.max.y)],
            Some([_, y]) => {
                let row = |x: f32| y as f64 - f64::from(x);
                [row(bounds.max.x), row(bounds.min.x) + 1.0]
            }
        }
    }

    /// Gives column, row and coverage of every pixel.
    pub fn draw(&self, mut give: impl FnMut(i64, i64, f32)) {
        let corner = self.outline.px_bounds().min;
        self.outline.draw(|x, y, covered| {
            let x = corner.x as i64 + i64::from(x);
            let y = corner.y as i64 + i64::from(y);
            match self.turned_about {
                None => give(x, y, covered),
                Some([ax, ay]) => give(ax + y, ay - x, covered),
            }
        });
    }
}
