//! Colours on a white background that colour-blind people can distinguish (Okabe and Ito).

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

/// Names of the colours in the style sheet of the page. The page redefines the colours in dark mode.
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

/// Colour for `u` from 0 (dark blue) to 1 (yellow), interpolated between five colours of viridis. Lightness increases uniformly.
pub fn shade(u: f64) -> RGBAColor {
    const STOPS: [[f64; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [253.0, 231.0, 37.0],
    ];
    let x = u.clamp(0.0, 1.0) * 4.0;
    let i = (x as usize).min(3);
    let mix = |k: usize| (STOPS[i][k] + (x - i as f64) * (STOPS[i + 1][k] - STOPS[i][k])) as u8;
    RGBAColor(mix(0), mix(1), mix(2), 1.0)
}
