//! Drawing of the follower at the start of the law: face or roller, stem or arm, pivot.

use plotters::style::Color;

use super::{MM, Scene, circle, dot, part};
use crate::plot::palette::{AXIS, INK, PAPER};
use crate::plot::sheet::{Drawn, Plane, fill, stroke, trace};
use crate::pose::Pose;

impl Scene<'_> {
    pub(super) fn follower(&self, plane: &Plane) -> Drawn {
        let mut half = 0.045 * self.reach;
        if let Pose::Roller { radius, .. } = self.pose
            && radius > 0.0
        {
            half = half.min(0.6 * MM * radius);
        }
        let rod = |x, from, to| rod(plane, half, x, [from, to]);
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
                    // The face starts at the foot of the perpendicular from its pivot.
                    low = low.min(0.0);
                    self.arm(plane, pivot, [MM * at[0], y])?;
                } else {
                    rod(MM * at[0], y + thick, y + self.stem())?;
                }
                let (sin, cos) = libm::sincos(angle);
                let corner =
                    |u: f64, w: f64| (MM * at[0] + u * cos - w * sin, y + u * sin + w * cos);
                let plate = vec![
                    corner(low, 0.0),
                    corner(high, 0.0),
                    corner(high, thick),
                    corner(low, thick),
                    corner(low, 0.0),
                ];
                part(plane, plate, 2.2)
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
                    return part(plane, edge, 1.8);
                }
                if sliding {
                    rod(x, y, y + radius + self.stem())?;
                }
                part(plane, circle_about([x, y], radius), 2.2)?;
                dot(plane, (x, y), INK)
            }
        }
    }

    /// Draws a mushroom follower: the arc in contact with the cam, slightly extended, its chord, and the stem or arm.
    fn cap(&self, plane: &Plane, centre: [f64; 2], radius: f64) -> Drawn {
        let cam = &self.synthesis.cam;
        let [nx, ny] = cam.motion(self.start);
        let reach = cam.contact_travel().map_or(0.0, |(low, high)| {
            MM * high.value.abs().max(low.value.abs())
        });
        let half = libm::asin(((reach + 0.15 * self.reach) / radius).clamp(0.05, 1.2));
        let half = if half.is_finite() { half } else { 1.2 };
        let at = |angle: f64, rho: f64| {
            // The angle is measured from the direction towards the cam, which is opposite to the motion.
            let (sin, cos) = libm::sincos(angle);
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
        part(plane, rim, 2.2)?;
        if self.pivot().is_some() {
            return Ok(());
        }
        let chord = radius * libm::cos(half);
        let (x, from) = at(0.0, chord);
        let (side, to) = (0.045 * self.reach, from + self.stem());
        for x in [x - side, x + side] {
            trace(plane, [(x, from), (x, to)], stroke(INK, 1.8))?;
        }
        Ok(())
    }

    /// Draws an arm as a bar from `pivot` to `end`, with the bearing of the pivot.
    fn arm(&self, plane: &Plane, pivot: [f64; 2], end: [f64; 2]) -> Drawn {
        let (dx, dy) = (end[0] - pivot[0], end[1] - pivot[1]);
        let length = libm::hypot(dx, dy);
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
            fill(plane, &bar, AXIS.mix(0.35))?;
            trace(plane, bar, stroke(INK, 1.8))?;
        }
        let bearing = circle_about(pivot, 0.045 * self.reach);
        fill(plane, &bearing, PAPER)?;
        trace(plane, bearing, stroke(INK, 1.8))?;
        dot(plane, (pivot[0], pivot[1]), INK)
    }
}

fn circle_about([x, y]: [f64; 2], radius: f64) -> Vec<(f64, f64)> {
    let points = circle(radius).into_iter();
    points.map(|(u, v)| (x + u, y + v)).collect()
}

/// Draws a vertical rod at `x` with the half width `half`. Its ends are open.
fn rod(plane: &Plane, half: f64, x: f64, [from, to]: [f64; 2]) -> Drawn {
    let side = |x: f64| [(x, from), (x, to)];
    let [left, right] = [side(x - half), side(x + half)];
    let corners = [left[0], left[1], right[1], right[0]];
    fill(plane, &corners, PAPER)?;
    fill(plane, &corners, AXIS.mix(0.35))?;
    trace(plane, left, stroke(INK, 1.8))?;
    trace(plane, right, stroke(INK, 1.8))
}
