//! The lines' names and the main dimensions beside the cam.

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::{BASE, MM, PITCH, PRIME, Scene};
use crate::number::{degrees, number};
use crate::plot::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, QUIET, RED};
use crate::plot::sheet::{Canvas, Drawn, Lettering, line, stroke, units, write};

impl Scene<'_> {
    /// Names the lines and gives the main dimensions, in a column.
    pub(super) fn table(&self, canvas: &Canvas, [x, mut y]: [f64; 2], e: f64) -> Drawn {
        let cam = &self.synthesis.cam;
        let step = 1.75 * e;
        let swatch = |colour: RGBAColor, width: f64, dash: Option<[f64; 2]>, y: f64| {
            let ends = [[x, y], [x + 1.8 * e, y]];
            let Some([on, off]) = dash else {
                return line(canvas, &ends, stroke(colour, width));
            };
            let path = ends.map(|[x, y]| (units(x), units(y)));
            canvas.draw(&DashedPathElement::new(
                path,
                units(on),
                units(off),
                stroke(colour, width),
            ))
        };
        let mut lines = vec![(BLUE, 2.6, None, "cam profile".to_string())];
        if self.synthesis.conjugate.is_some() {
            lines.push((PURPLE, 2.2, None, "second cam of the pair".into()));
        } else if !self.others.is_empty() {
            lines[0].3 = "walls of the groove, unrolled".into();
        }
        if !self.is_straight() {
            let base = format!("base circle R {} mm", number(self.base, 4));
            lines.push((GREEN, 1.6, Some(BASE), base));
        }
        if self.has_roller() || self.is_straight() {
            if !self.is_straight() {
                let prime = format!("prime circle R {} mm", number(self.prime, 4));
                lines.push((PURPLE, 1.6, Some(PRIME), prime));
            }
            lines.push((ORANGE, 1.6, Some(PITCH), "pitch curve".into()));
        }
        for (colour, width, dash, name) in lines {
            swatch(colour, width, dash, y)?;
            write(canvas, &name, [x + 2.3 * e, y], Lettering::new(e, INK))?;
            y += step;
        }
        for (filled, name) in [(true, "contact at θ = 0"), (false, "sharpest point")] {
            let style = if filled {
                RED.filled()
            } else {
                stroke(RED, 2.0)
            };
            canvas.draw(&Circle::new(
                (units(x + 0.8 * e), units(y)),
                units(if filled { 4.0 } else { 5.5 }),
                style,
            ))?;
            write(canvas, name, [x + 2.3 * e, y], Lettering::new(e, INK))?;
            y += step;
        }
        y += 0.8 * e;
        let sharpest = cam.curvature().convex;
        let (low, high) = self.synthesis.pressure_angle_extremes();
        let mut facts = vec![
            ("follower", cam.follower.name().to_string()),
            ("stroke", {
                let lift = cam.follower.measures().lift(0);
                lift.after(&number(lift.factor * cam.law.stroke(), 4))
            }),
            (
                "smallest radius",
                format!("{} mm", number(MM * sharpest.value, 4)),
            ),
            ("  at", cam.follower.measures().place(sharpest.at, 1)),
        ];
        if let Some(width) = cam.face_width() {
            facts.push(("face width", format!("{} mm", number(MM * width, 4))));
        } else {
            facts.push((
                "roller radius",
                format!("{} mm", number(MM * cam.follower.roller_radius(), 4)),
            ));
            facts.push((
                "offset",
                format!("{} mm", number(MM * cam.follower.offset(), 4)),
            ));
            let phi = format!("{} … {}", degrees(low.value), degrees(high.value));
            facts.push(("pressure angle", phi));
        }
        facts.push((
            "speed",
            cam.follower
                .measures()
                .speed()
                .after(&number(self.synthesis.drive.speed, 4)),
        ));
        for (name, value) in facts {
            write(canvas, name, [x, y], Lettering::new(e, QUIET))?;
            write(canvas, &value, [x + 8.8 * e, y], Lettering::new(e, INK))?;
            y += step;
        }
        Ok(())
    }
}
