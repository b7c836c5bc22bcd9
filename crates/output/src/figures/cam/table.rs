//! Legend of the lines, and main dimensions, in the figure of the cam.

use plotters::style::{Color, RGBAColor};

use super::{BASE, PITCH, PRIME, Scene};
use crate::facts::{Group, facts, label};
use crate::plot::layout::Figure;
use crate::plot::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, RED};
use crate::plot::sheet::{Drawn, Lettering, circle, dashed, line, stroke};
use crate::plot::text::text_width;
use crate::words::Words;

/// Keys of the facts that are written next to the cam. The base radius and the prime radius are given in the legend.
const KEYS: [&str; 8] = [
    "stroke_m",
    "report-follower",
    "report-roller-radius",
    "offset_m",
    "rho_min_m",
    "report-found-at",
    "face_width_m",
    "report-pressure-angle",
];

impl Scene<'_> {
    /// Draws the legend of the lines. Returns the vertical position below the legend.
    pub(super) fn lines(&self, f: &Figure, [x, mut y]: [f64; 2], words: &Words) -> Drawn<f64> {
        let e = f.e;
        let step = 1.75 * e;
        let swatch = |colour: RGBAColor, width: f64, dash: Option<[f64; 2]>, y: f64| {
            let ends = [[x, y], [x + 1.8 * e, y]];
            match dash {
                Some(dash) => dashed(f.canvas, ends, dash, stroke(colour, width)),
                None => line(f.canvas, &ends, stroke(colour, width)),
            }
        };
        let mut lines = vec![(BLUE, 2.6, None, words.text("figure-profile"))];
        if self.synthesis.conjugate.is_some() {
            lines.push((PURPLE, 2.2, None, words.text("figure-second-profile")));
        } else if !self.others.is_empty() {
            lines[0].3 = words.text("figure-walls");
        }
        if !self.is_straight() {
            let radius = words.length(1e-3 * self.base);
            let base = words.fill("figure-base-circle", &[("radius", &radius)]);
            lines.push((GREEN, 1.6, Some(BASE), base));
        }
        if self.has_roller() || self.is_straight() {
            if !self.is_straight() {
                let radius = words.length(1e-3 * self.prime);
                let prime = words.fill("figure-prime-circle", &[("radius", &radius)]);
                lines.push((PURPLE, 1.6, Some(PRIME), prime));
            }
            lines.push((ORANGE, 1.6, Some(PITCH), words.text("figure-pitch-curve")));
        }
        if self.pressures.is_some() {
            // The colour scale of the pressure replaces the legend entry of the profile.
            lines.remove(0);
        }
        for (colour, width, dash, name) in lines {
            swatch(colour, width, dash, y)?;
            f.write(&name, [x + 2.3 * e, y], Lettering::new(e, INK))?;
            y += step;
        }
        let marks = [
            ("figure-contact", 4.0, RED.filled()),
            ("figure-sharpest", 5.5, stroke(RED, 2.0)),
        ];
        for (name, radius, style) in marks {
            circle(f.canvas, [x + 0.8 * e, y], radius, style)?;
            let name = words.text(name);
            f.write(&name, [x + 2.3 * e, y], Lettering::new(e, INK))?;
            y += step;
        }
        Ok(y)
    }

    /// Main dimensions of the cam as pairs of name and value.
    pub(super) fn facts(&self, words: &Words) -> Vec<(String, String)> {
        let language = words.language();
        let all = [Group::Law, Group::Cam].map(|group| facts(self.synthesis, group, language));
        let shown = all.into_iter().flatten();
        let shown = shown.filter(|fact| KEYS.contains(&fact.key));
        let speed = self.synthesis.problem.drive.speed;
        let measures = self.synthesis.cam.follower.measures();
        let speed = (
            label(self.synthesis, "speed_rad_per_s", words),
            measures.speed().shown(speed, language),
        );
        shown
            .map(|fact| (fact.name, fact.value))
            .chain([speed])
            .collect()
    }
}

/// Horizontal position of the values relative to their names, em.
pub(super) fn values_at(facts: &[(String, String)]) -> f64 {
    let ends = facts.iter().map(|f| text_width(&f.0) + 0.9);
    ends.fold(8.8, f64::max)
}
