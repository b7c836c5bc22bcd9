//! Character codes and widths of Helvetica and Symbol, two fonts that every PDF reader contains.
//!
//! Widths are in thousandths of an em, from the metrics of the standard fonts. Helvetica has the Windows encoding.

/// Font that contains a character: Helvetica or Symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// Helvetica, used for letters and digits.
    Helvetica,
    /// Symbol, used for Greek letters and mathematical signs.
    Symbol,
}

/// Character with its font, code and width.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Glyph {
    /// Font that contains the glyph.
    pub face: Face,
    /// Code of the character in the encoding of the font.
    pub byte: u8,
    /// Width of the glyph, thousandths of an em.
    width: u16,
}

/// Characters that are taken from Symbol. An entry contains the character, its code, and its width in thousandths of an em.
const SYMBOLS: [(char, u8, u16); 14] = [
    ('−', 0x2d, 549),
    ('Δ', b'D', 612),
    ('α', b'a', 631),
    ('β', b'b', 549),
    ('θ', b'q', 521),
    ('ξ', b'x', 493),
    ('π', b'p', 549),
    ('ρ', b'r', 549),
    ('φ', b'f', 521),
    ('ω', b'w', 686),
    ('≤', 0xa3, 549),
    ('∞', 0xa5, 713),
    ('→', 0xae, 987),
    ('≥', 0xb3, 549),
];

/// Widths of the Helvetica characters from the space (0x20) to the tilde (0x7E), thousandths of an em.
#[rustfmt::skip]
const ASCII: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
    556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
    667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
    333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
    556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

/// Widths of the Helvetica characters from the non-breaking space (0xA0) to ÿ (0xFF), thousandths of an em.
#[rustfmt::skip]
const LATIN: [u16; 96] = [
    278, 333, 556, 556, 556, 556, 260, 556, 333, 737, 370, 556, 584, 333, 737, 333,
    400, 584, 333, 333, 333, 556, 537, 278, 333, 333, 365, 556, 834, 834, 834, 611,
    667, 667, 667, 667, 667, 667, 1000, 722, 667, 667, 667, 667, 278, 278, 278, 278,
    722, 722, 778, 778, 778, 778, 778, 584, 778, 722, 722, 722, 722, 667, 667, 611,
    556, 556, 556, 556, 556, 556, 889, 500, 556, 556, 556, 556, 278, 278, 278, 278,
    556, 556, 556, 556, 556, 556, 556, 584, 611, 556, 556, 556, 556, 500, 556, 500,
];

/// Glyph of a character; a question mark if neither font contains the character.
pub fn glyph(c: char) -> Glyph {
    let helvetica = |byte, width| Glyph {
        face: Face::Helvetica,
        byte,
        width,
    };
    let code = u8::try_from(u32::from(c)).unwrap_or(b'?');
    match c {
        ' '..='~' => helvetica(code, ASCII[usize::from(code - 0x20)]),
        '\u{a0}'..='ÿ' => helvetica(code, LATIN[usize::from(code - 0xa0)]),
        '…' => helvetica(0x85, 1000),
        '’' => helvetica(0x92, 222),
        '–' => helvetica(0x96, 556),
        '—' => helvetica(0x97, 1000),
        _ => match SYMBOLS.iter().find(|row| row.0 == c) {
            Some(&(_, byte, width)) => Glyph {
                face: Face::Symbol,
                byte,
                width,
            },
            None => helvetica(b'?', 556),
        },
    }
}

/// Width of a line of text, em.
pub fn width(text: &str) -> f64 {
    text.chars()
        .map(|c| f64::from(glyph(c).width) / 1000.0)
        .sum()
}
