//! Computes the fraction of each pixel that a shape covers. The changes of the covered area at the edges of the shape are stored and then
//! summed along each row of pixels.
//!
//! Source: R. Levien, font-rs (2015). In each row, an edge adds its signed area to the pixels on its right. The running sum along the row
//! is the coverage.

use std::ops::Range;

/// Coverage below which a value counts as zero. Smaller values are rounding errors.
const NOTHING: f32 = 1e-3;

/// Coverage of the pixels by a shape. It is accumulated from the edges of the polygons of the shape.
pub struct Coverage {
    width: usize,
    /// For each row: columns in which the coverage changes, and the changes.
    rows: Vec<Vec<(usize, f32)>>,
    /// Range of rows that contain edges.
    touched: Range<usize>,
}

impl Coverage {
    /// Creates an accumulator without edges.
    pub fn new(width: usize, height: usize) -> Self {
        Coverage {
            width,
            rows: vec![Vec::new(); height],
            touched: height..0,
        }
    }

    /// Adds one edge of a polygon. Sections of the edge outside the page are moved to the border of the page.
    pub fn edge(&mut self, from: [f64; 2], to: [f64; 2]) {
        let down = from[1] < to[1];
        let [p, q] = if down { [from, to] } else { [to, from] };
        let (top, bottom) = (p[1].max(0.0), q[1].min(self.rows.len() as f64));
        if top >= bottom {
            return;
        }
        let slope = (q[0] - p[0]) / (q[1] - p[1]);
        let sign = if down { 1.0 } else { -1.0 };
        let mut x = p[0] + (top - p[1]) * slope;
        let rows = top as usize..bottom.ceil() as usize;
        self.touched.start = self.touched.start.min(rows.start);
        self.touched.end = self.touched.end.max(rows.end);
        for row in rows {
            let dy = bottom.min((row + 1) as f64) - top.max(row as f64);
            let next = x + slope * dy;
            self.row(row, x.min(next), x.max(next), sign * dy);
            x = next;
        }
    }

    /// Adds the section of an edge within one row of pixels. It extends from x = `a` to `b` and has the signed height `d`.
    fn row(&mut self, row: usize, a: f64, b: f64, d: f64) {
        let most = self.width as f64;
        let (a, b) = (a.clamp(0.0, most), b.clamp(0.0, most));
        let first = a as usize;
        let end = (b.ceil() as usize).max(first + 1);
        let row = &mut self.rows[row];
        if end == first + 1 {
            // Edge within one pixel: the area to the right of the middle of the edge is covered.
            let right = d * (0.5 * (a + b) - first as f64);
            row.extend([(first, (d - right) as f32), (end, right as f32)]);
            return;
        }
        // Edge over several pixels: the covered area on its right is a parabola, then a line, then a parabola.
        let area = |x: f64| -> f64 {
            let u = (x - a).clamp(0.0, b - a);
            (0.5 * u * u + (x - b).max(0.0) * (b - a)) / (b - a)
        };
        let (mut before, mut total) = (0.0, 0.0);
        for x in first..=end {
            let now = area((x + 1) as f64);
            let covered = now - before;
            row.push((x, (d * (covered - total)) as f32));
            (before, total) = (now, covered);
        }
    }

    /// Calls `give` with the row, the columns and the coverage 0 … 1 of each part of a row in which the coverage is constant. The order
    /// is row by row from left to right. All edges are then removed.
    pub fn take(&mut self, mut give: impl FnMut(usize, Range<usize>, f32)) {
        let touched = std::mem::replace(&mut self.touched, self.rows.len()..0);
        for row in touched {
            let edges = &mut self.rows[row];
            edges.sort_unstable_by_key(|(x, _)| *x);
            let (mut sum, mut at) = (0.0_f32, 0);
            for (x, part) in edges.drain(..).chain([(self.width, 0.0)]) {
                let until = x.min(self.width);
                if until > at && sum.abs() > NOTHING {
                    give(row, at..until, sum.abs().min(1.0));
                }
                (at, sum) = (until, sum + part);
            }
        }
    }
}
