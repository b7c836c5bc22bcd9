//! Legend and main dimensions next to the cam.

use plotters::style::{Color, RGBAColor};

use super::{BASE, PITCH, PRIME, Scene};
use crate::plot::layout::Figure;
use crate::plot::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, RED};
use crate::plot::sheet::{Drawn, Lettering, circle, dashed, line, stroke};
use crate::plot::text::text_width;
use crate::words::Words;
use gaitcam_base::text::{degrees, millimetres, number};

impl Scene<'_> {
    /// The lines' names; returns the vertical position below them.
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
            let radius = format!("{} mm", number(self.base, 4));
            let base = words.fill("figure-base-circle", &[("radius", &radius)]);
            lines.push((GREEN, 1.6, Some(BASE), base));
        }
        if self.has_roller() || self.is_straight() {
            if !self.is_straight() {
                let radius = format!("{} mm", number(self.prime, 4));
                let prime = words.fill("figure-prime-circle", &[("radius", &radius)]);
                lines.push((PURPLE, 1.6, Some(PRIME), prime));
            }
            lines.push((ORANGE, 1.6, Some(PITCH), words.text("figure-pitch-curve")));
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

    /// The names of the main dimensions and their values.
    pub(super) fn facts(&self, words: &Words) -> Vec<(String, String)> {
        let cam = &self.synthesis.cam;
        let measures = cam.follower.measures();
        let sharpest = cam.curvature().convex;
        let (low, high) = self.synthesis.pressure_angle_extremes();
        let lift = measures.lift(0);
        let stroke = lift.after(&number(lift.factor * cam.law.stroke(), 4));
        let mut facts = vec![
            ("figure-follower", words.name(cam.follower.name())),
            ("figure-stroke", stroke),
            ("figure-smallest-radius", millimetres(sharpest.value, 4)),
            ("figure-smallest-at", measures.place(sharpest.at, 1)),
        ];
        if let Some(width) = cam.face_width() {
            facts.push(("figure-face-width", millimetres(width, 4)));
        } else {
            let roller = millimetres(cam.follower.roller_radius(), 4);
            facts.push(("figure-roller-radius", roller));
            facts.push(("figure-offset", millimetres(cam.follower.offset(), 4)));
            let phi = format!("{} … {}", degrees(low.value), degrees(high.value));
            facts.push(("figure-phi", phi));
        }
        let speed = number(self.synthesis.problem.drive.speed, 4);
        facts.push(("figure-speed", measures.speed().after(&speed)));
        let named = |(key, value): (&str, String)| (words.text(key), value);
        facts.into_iter().map(named).collect()
    }
}

/// Where the values start beside their names, ems.
pub(super) fn values_at(facts: &[(String, String)]) -> f64 {
    let ends = facts.iter().map(|f| text_width(&f.0) + 0.9);
    ends.fold(8.8, f64::max)
}
