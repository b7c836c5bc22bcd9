//! Contact pressure along the profile, drawn as colour if the scene limits the pressure.

use super::Scene;
use crate::plot::layout::Figure;
use crate::plot::palette::{INK, shade};
use crate::plot::sheet::{Drawn, Lettering, Plane, line, stroke, trace};
use crate::words::Words;
use gaitcam::criterion::LimitKind;
use gaitcam::synth::Design;
use gaitcam::wording::range;

/// Number of colours of the scale.
const COLOURS: usize = 16;
/// Width of the coloured profile, points.
const WIDTH: f64 = 5.0;

/// Contact pressure at the points of a profile.
pub(super) struct Pressures {
    /// Pressure at each point, Pa; NaN without contact.
    values: Vec<f64>,
    low: f64,
    /// Upper end of the colour scale, Pa: the maximum of `values` or the worst value of the check, whichever is larger.
    high: f64,
}

impl Pressures {
    /// Pressures at the given cam angles; `None` if the scene does not limit the pressure, or if no value is finite.
    pub(super) fn of(design: &Design, angles: impl Iterator<Item = f64>) -> Option<Pressures> {
        let checks = &design.checks;
        let check = checks.iter().find(|c| c.name == LimitKind::HertzPressure)?;
        let values: Vec<f64> = angles.map(|a| design.contact_pressure_at(a)).collect();
        let finite = || values.iter().copied().filter(|p| p.is_finite());
        let low = finite().reduce(f64::min)?;
        let extreme = Some(check.worst).filter(|p| p.is_finite());
        let high = finite().chain(extreme).fold(low, f64::max);
        Some(Pressures { values, low, high })
    }

    /// Index of the colour at a point; `None` without a finite pressure.
    fn colour(&self, point: usize) -> Option<usize> {
        let share = (self.values[point] - self.low) / (self.high - self.low).max(f64::MIN_POSITIVE);
        let index = (share * COLOURS as f64) as usize;
        share.is_finite().then(|| index.min(COLOURS - 1))
    }

    /// Draws the profile with its colours.
    pub(super) fn draw(&self, plane: &Plane, outline: &[(f64, f64)]) -> Drawn {
        let points: Vec<usize> = (0..outline.len().saturating_sub(1)).collect();
        for part in points.chunk_by(|a, b| self.colour(*a) == self.colour(*b)) {
            if let (Some(colour), [first, ..]) = (self.colour(part[0]), part) {
                let colour = shade(colour as f64 / (COLOURS - 1) as f64);
                let path = &outline[*first..=first + part.len()];
                trace(plane, path, stroke(colour, WIDTH))?;
            }
        }
        Ok(())
    }
}

impl Scene<'_> {
    /// Draws the colour scale of the pressure, if the pressure is drawn. Returns the vertical position below the scale.
    pub(super) fn scale(&self, f: &Figure, [x, y]: [f64; 2], words: &Words) -> Drawn<f64> {
        let Some(pressures) = &self.pressures else {
            return Ok(y);
        };
        let width = 1.8 * f.e / COLOURS as f64;
        for i in 0..COLOURS {
            let left = x + width * i as f64;
            let colour = shade(i as f64 / (COLOURS - 1) as f64);
            line(
                f.canvas,
                &[[left, y], [left + width, y]],
                stroke(colour, WIDTH),
            )?;
        }
        let megapascals = [pressures.low, pressures.high].map(|p| 1e-6 * p);
        let shown = range(words.language(), megapascals[0], megapascals[1]);
        let name = words.fill("figure-pressure", &[("range", &shown)]);
        f.write(&name, [x + 2.3 * f.e, y], Lettering::new(f.e, INK))?;
        Ok(y + 1.75 * f.e)
    }
}
