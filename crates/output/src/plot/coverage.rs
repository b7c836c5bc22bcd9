//! How much of each pixel a shape covers: signed areas summed along the rows, kept where edges pass.
//!
//! Source: R. Levien, font-rs (2015): each edge adds, per row, its area to the right to an accumulation
//! buffer whose running sum is the coverage. Only the cells of [`CELL`] pixels that an edge touched are
//! visited afterwards; between two of them the sum is constant.

/// Pixels per cell.
const CELL: usize = 16;
/// Coverage below this is rounding.
const NOTHING: f32 = 1e-3;

/// How much of neighbouring pixels of a row is covered, 0 … 1.
pub enum Covered<'a> {
    /// So many pixels, all by the same part.
    Evenly(usize, f32),
    /// Each by its own.
    Each(&'a [f32]),
}

/// The accumulation buffer of some rows of a page.
pub struct Coverage {
    width: usize,
    /// The first of the rows.
    top: usize,
    height: usize,
    /// Values per row: the pixels and what edges leave beyond the last, in whole cells.
    stride: usize,
    sums: Vec<f32>,
    /// Per row, which cells edges touched: words of 64.
    touched: Vec<u64>,
    words: usize,
    /// Rows touched: first, one past the last.
    rows: [usize; 2],
}

impl Coverage {
    /// A buffer of `height` rows.
    pub fn new(width: usize, height: usize) -> Self {
        let cells = (width + 2).div_ceil(CELL);
        let words = cells.div_ceil(64);
        Coverage {
            width,
            top: 0,
            height,
            stride: cells * CELL,
            sums: vec![0.0; cells * CELL * height],
            touched: vec![0; words * height],
            words,
            rows: [height, 0],
        }
    }

    /// Starts the rows from `top` on, at most the capacity.
    pub fn begin(&mut self, top: usize, height: usize) {
        (self.top, self.height) = (top, height);
        self.rows = [height, 0];
    }

    /// Adds one edge of a polygon, clamped to the borders of the page.
    pub fn edge(&mut self, from: [f64; 2], to: [f64; 2]) {
        let down = from[1] < to[1];
        let first_row = self.top as f64;
        let [p, q] = if down { [from, to] } else { [to, from] };
        let [p, q] = [p, q].map(|[x, y]| [x, y - first_row]);
        let (top, bottom) = (p[1].max(0.0), q[1].min(self.height as f64));
        if top >= bottom {
            return;
        }
        let slope = (q[0] - p[0]) / (q[1] - p[1]);
        let sign = if down { 1.0 } else { -1.0 };
        let whole = bottom as usize;
        let last = (whole + usize::from(bottom > whole as f64)).min(self.height);
        let first = top as usize;
        let mut x = p[0] + (top - p[1]) * slope;
        for row in first..last {
            let dy = bottom.min((row + 1) as f64) - top.max(row as f64);
            let next = x + slope * dy;
            self.row(row, x.min(next), x.max(next), sign * dy);
            x = next;
        }
        self.rows = [self.rows[0].min(first), self.rows[1].max(last)];
    }

    /// An edge within one row, from x = `a` to `b`, of signed height `d`.
    fn row(&mut self, row: usize, a: f64, b: f64, d: f64) {
        let most = self.width as f64;
        let (a, b) = (a.clamp(0.0, most), b.clamp(0.0, most));
        let (i, whole) = (a as usize, b as usize);
        let end = (whole + usize::from(b > whole as f64)).max(i + 1);
        let marks = &mut self.touched[row * self.words..(row + 1) * self.words];
        for cell in i / CELL..=end / CELL {
            marks[cell / 64] |= 1 << (cell % 64);
        }
        let sums = &mut self.sums[row * self.stride..][i..=end];
        if sums.len() == 2 {
            // Within one pixel: what is right of the edge's middle is covered.
            let right = d * (0.5 * (a + b) - i as f64);
            sums[0] += (d - right) as f32;
            sums[1] += right as f32;
            return;
        }
        // Over several pixels the covered area right of the edge grows as a parabola, a line, a parabola.
        let area = |x: f64| -> f64 {
            let u = (x - a).clamp(0.0, b - a);
            (0.5 * u * u + (x - b).max(0.0) * (b - a)) / (b - a)
        };
        let (mut before, mut total) = (0.0, 0.0);
        for (k, sum) in sums.iter_mut().enumerate() {
            let now = area((i + k + 1) as f64);
            let covered = now - before;
            *sum += (d * (covered - total)) as f32;
            (before, total) = (now, covered);
        }
    }

    /// Gives what is covered of the rows, one by one and from the left (row from the first of them, first pixel, what is
    /// covered), and empties them.
    pub fn take(&mut self, mut give: impl FnMut(usize, usize, Covered)) {
        for row in self.rows[0]..self.rows[1] {
            let sums = &mut self.sums[row * self.stride..(row + 1) * self.stride];
            let marks = &mut self.touched[row * self.words..(row + 1) * self.words];
            let (mut sum, mut x) = (0.0_f32, 0);
            for (w, mark) in marks.iter_mut().enumerate() {
                let mut bits = std::mem::take(mark);
                while bits != 0 {
                    let cell = CELL * (64 * w + bits.trailing_zeros() as usize);
                    bits &= bits - 1;
                    let even = cell.min(self.width).saturating_sub(x);
                    if even > 0 && sum.abs() > NOTHING {
                        give(row, x, Covered::Evenly(even, sum.abs().min(1.0)));
                    }
                    let mut parts = [0.0; CELL];
                    for (part, value) in parts.iter_mut().zip(&mut sums[cell..cell + CELL]) {
                        sum += std::mem::take(value);
                        if sum.abs() > NOTHING {
                            *part = sum.abs().min(1.0);
                        }
                    }
                    let pixels = self.width.saturating_sub(cell).min(CELL);
                    if pixels > 0 {
                        give(row, cell, Covered::Each(&parts[..pixels]));
                    }
                    x = cell + CELL;
                }
            }
            let even = self.width.saturating_sub(x);
            if even > 0 && sum.abs() > NOTHING {
                give(row, x, Covered::Evenly(even, sum.abs().min(1.0)));
            }
        }
        self.rows = [self.height, 0];
    }
}
