//! Letters as outlines on a page.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, PxScale, ScaleFont, point};

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

/// Draws the letters of a line: gives column, row and coverage of every pixel.
pub fn draw_letters(line: &Line, mut give: impl FnMut(i64, i64, f32)) {
    let Some(font) = &*FONT else {
        return;
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
    // Upright text is placed to a fraction of a pixel; turned text is turned pixel by pixel about its place.
    let about = line.at.map(|x| x.round() as i64);
    let [left, baseline] = if line.upwards { [0.0; 2] } else { line.at };
    let mut pen = -total * line.anchor as f32;
    for c in line.text.chars() {
        for again in if line.bold { &[0.0, 1.0][..] } else { &[0.0] } {
            let place = point(left as f32 + pen + again * shift, baseline as f32);
            let glyph = scaled.glyph_id(c).with_scale_and_position(scale, place);
            let Some(outline) = font.outline_glyph(glyph) else {
                continue;
            };
            let corner = outline.px_bounds().min;
            outline.draw(|x, y, covered| {
                let x = corner.x as i64 + i64::from(x);
                let y = corner.y as i64 + i64::from(y);
                match line.upwards {
                    false => give(x, y, covered),
                    true => give(about[0] + y, about[1] - x, covered),
                }
            });
        }
        pen += advance(c);
    }
}
