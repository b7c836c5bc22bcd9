//! Colours that colour-blind people can distinguish (Okabe and Ito) on white.

#![allow(missing_docs)] // the names are the documentation

use super::sheet::Ink;

pub const PAPER: Ink = Ink::opaque(255, 255, 255);
pub const INK: Ink = Ink::opaque(31, 36, 43);
pub const QUIET: Ink = Ink::opaque(96, 104, 115);
pub const GRID: Ink = Ink::opaque(229, 232, 237);
pub const AXIS: Ink = Ink::opaque(158, 166, 177);
pub const BLUE: Ink = Ink::opaque(0, 114, 178);
pub const ORANGE: Ink = Ink::opaque(230, 159, 0);
pub const GREEN: Ink = Ink::opaque(0, 158, 115);
pub const PURPLE: Ink = Ink::opaque(190, 95, 155);
pub const RED: Ink = Ink::opaque(213, 94, 0);

/// Names of the colours in the page's style sheet, which replaces them in dark mode.
pub const NAMES: [(Ink, &str); 10] = [
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
