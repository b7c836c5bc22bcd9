//! The follower where it stands: face or roller, stem or arm, pivot.

use plotters::prelude::*;

use super::{MM, Scene, circle, dot};
use crate::plot::palette::{AXIS, INK, PAPER};
use crate::plot::sheet::{Drawn, Plane, stroke};
use crate::pose::Pose;

impl Scene<'_> {
    pub(super) fn follower(&self, plane: &Plane) -> Drawn {
        let mut half = 0.045 * self.reach;
        if let Pose::Roller { radius, .. } = self.pose
            && radius > 0.0
        {
            half = half.min(0.6 * MM * radius);
        }
        let rod = |x: f64, from: f64, to: f64| {
            let corners = vec![
                (x - half, from),
                (x - half, to),
                (x + half, to),
                (x + half, from),
            ];
            let sides = [
                [(x - half, from), (x - half, to)],
                [(x + half, from), (x + half, to)],
            ];
            plane.draw(&Polygon::new(corners.clone(), PAPER.filled()))?;
            plane.draw(&Polygon::new(corners, AXIS.mix(0.35).filled()))?;
            for side in sides {
                plane.draw(&PathElement::new(side, stroke(INK, 1.8)))?;
            }
            Ok(())
        };
        if let (true, Pose::Roller { centre, radius }) = (self.is_mushroom(), self.pose) {
            return self.cap(plane, centre.map(|c| MM * c), MM * radius);
        }
        if let (Some(pivot), Pose::Roller { centre, .. }) = (self.pivot(), self.pose) {
            self.arm(plane, pivot, centre.map(|c| MM * c))?;
        }
        let sliding = self.pivot().is_none();
        match self.pose {
            Pose::Face { at, angle } => {
                let y = MM * at[1];
                let (mut low, high) = self.face();
                let thick = 0.035 * self.reach;
                if let Some(pivot) = self.pivot() {
                    // The face starts at the foot of its pivot.
                    low = low.min(0.0);
                    self.arm(plane, pivot, [MM * at[0], y])?;
                } else {
                    rod(MM * at[0], y + thick, y + self.stem())?;
                }
                let (sin, cos) = angle.sin_cos();
                let corner =
                    |u: f64, w: f64| (MM * at[0] + u * cos - w * sin, y + u * sin + w * cos);
                let plate = [
                    corner(low, 0.0),
                    corner(high, 0.0),
                    corner(high, thick),
                    corner(low, thick),
                    corner(low, 0.0),
                ];
                plane.draw(&Polygon::new(plate.to_vec(), PAPER.filled()))?;
                plane.draw(&Polygon::new(plate.to_vec(), AXIS.mix(0.35).filled()))?;
                plane.draw(&PathElement::new(plate.to_vec(), stroke(INK, 2.2)))
            }
            Pose::Roller { centre, radius } => {
                let [x, y] = centre.map(|c| MM * c);
                let radius = MM * radius;
                if radius == 0.0 && !sliding {
                    return dot(plane, (x, y), INK);
                }
                if radius == 0.0 {
                    let shoulder = y + 2.5 * half;
                    let edge = vec![(x - half, shoulder), (x, y), (x + half, shoulder)];
                    rod(x, shoulder, y + self.stem())?;
                    plane.draw(&Polygon::new(edge.clone(), PAPER.filled()))?;
                    plane.draw(&Polygon::new(edge.clone(), AXIS.mix(0.35).filled()))?;
                    return plane.draw(&PathElement::new(edge, stroke(INK, 1.8)));
                }
                if sliding {
                    rod(x, y, y + radius + self.stem())?;
                }
                let rim: Vec<(f64, f64)> = circle(radius)
                    .into_iter()
                    .map(|(u, v)| (x + u, y + v))
                    .collect();
                plane.draw(&Polygon::new(rim.clone(), PAPER.filled()))?;
                plane.draw(&Polygon::new(rim.clone(), AXIS.mix(0.35).filled()))?;
                plane.draw(&PathElement::new(rim, stroke(INK, 2.2)))?;
                dot(plane, (x, y), INK)
            }
        }
    }

    /// The part of a mushroom's arc that the contact needs, and a little more, with its chord.
    fn cap(&self, plane: &Plane, centre: [f64; 2], radius: f64) -> Drawn {
        let cam = &self.synthesis.cam;
        let [nx, ny] = cam.motion(self.start);
        let reach = cam.contact_travel().map_or(0.0, |(low, high)| {
            MM * high.value.abs().max(low.value.abs())
        });
        let half = ((reach + 0.15 * self.reach) / radius)
            .clamp(0.05, 1.2)
            .asin();
        let half = if half.is_finite() { half } else { 1.2 };
        let at = |angle: f64, rho: f64| {
            // Turned from the direction towards the cam, which is against the motion.
            let (sin, cos) = angle.sin_cos();
            (
                centre[0] - rho * (cos * nx - sin * ny),
                centre[1] - rho * (sin * nx + cos * ny),
            )
        };
        if let Some(pivot) = self.pivot() {
            let (x, y) = at(0.0, radius);
            self.arm(plane, pivot, [x, y])?;
        }
        let mut rim: Vec<(f64, f64)> = (0..=60)
            .map(|i| at(half * (f64::from(i) / 30.0 - 1.0), radius))
            .collect();
        rim.push(rim[0]);
        plane.draw(&Polygon::new(rim.clone(), PAPER.filled()))?;
        plane.draw(&Polygon::new(rim.clone(), AXIS.mix(0.35).filled()))?;
        plane.draw(&PathElement::new(rim, stroke(INK, 2.2)))?;
        if self.pivot().is_some() {
            return Ok(());
        }
        let chord = radius * half.cos();
        let (x, from) = at(0.0, chord);
        let (side, to) = (0.045 * self.reach, from + self.stem());
        for x in [x - side, x + side] {
            plane.draw(&PathElement::new([(x, from), (x, to)], stroke(INK, 1.8)))?;
        }
        Ok(())
    }

    /// A bar from the pivot, with the pivot's bearing.
    fn arm(&self, plane: &Plane, pivot: [f64; 2], end: [f64; 2]) -> Drawn {
        let (dx, dy) = (end[0] - pivot[0], end[1] - pivot[1]);
        let length = dx.hypot(dy);
        let half = 0.025 * self.reach;
        if length > half {
            let (nx, ny) = (-dy / length * half, dx / length * half);
            let corner = |p: [f64; 2], side: f64| (p[0] + side * nx, p[1] + side * ny);
            let bar = vec![
                corner(pivot, 1.0),
                corner(end, 1.0),
                corner(end, -1.0),
                corner(pivot, -1.0),
                corner(pivot, 1.0),
            ];
            plane.draw(&Polygon::new(bar.clone(), AXIS.mix(0.35).filled()))?;
            plane.draw(&PathElement::new(bar, stroke(INK, 1.8)))?;
        }
        let bearing: Vec<(f64, f64)> = circle(0.045 * self.reach)
            .into_iter()
            .map(|(u, v)| (pivot[0] + u, pivot[1] + v))
            .collect();
        plane.draw(&Polygon::new(bearing.clone(), PAPER.filled()))?;
        plane.draw(&PathElement::new(bearing, stroke(INK, 1.8)))?;
        dot(plane, (pivot[0], pivot[1]), INK)
    }
}
