//! Colours on white that colour-blind people can distinguish (Okabe and Ito).

#![allow(missing_docs)] // the names are the documentation

use plotters::prelude::RGBAColor;

const fn opaque(r: u8, g: u8, b: u8) -> RGBAColor {
    RGBAColor(r, g, b, 1.0)
}

pub const PAPER: RGBAColor = opaque(255, 255, 255);
pub const INK: RGBAColor = opaque(31, 36, 43);
pub const QUIET: RGBAColor = opaque(96, 104, 115);
pub const GRID: RGBAColor = opaque(229, 232, 237);
pub const AXIS: RGBAColor = opaque(158, 166, 177);
pub const BLUE: RGBAColor = opaque(0, 114, 178);
pub const ORANGE: RGBAColor = opaque(230, 159, 0);
pub const GREEN: RGBAColor = opaque(0, 158, 115);
pub const PURPLE: RGBAColor = opaque(190, 95, 155);
pub const RED: RGBAColor = opaque(213, 94, 0);

/// Names of the colours in the style sheet of the page, which redefines them in dark mode.
pub const NAMES: [(RGBAColor, &str); 10] = [
    (PAPER, "paper"),
    (INK, "ink"),
    (QUIET, "quiet"),
    (GRID, "grid"),
    (AXIS, "axis"),
    (BLUE, "blue"),
    (ORANGE, "orange"),
    (GREEN, "green"),
    (PURPLE, "purple"),
    (RED, "red"),
];
