//! Size, scale and areas of a drawing sheet. Coordinates are in mm from the lower left corner.

/// Rectangle on the sheet, given by its edges, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Area {
    pub left: f64,
    pub bottom: f64,
    pub right: f64,
    pub top: f64,
}

impl Area {
    pub fn width(self) -> f64 {
        self.right - self.left
    }

    pub fn height(self) -> f64 {
        self.top - self.bottom
    }
}

/// Space for the labels of dimensions on both sides of the plan view, mm.
pub const LABELS: f64 = 40.0;
/// Space above the plan view for the mark of θ = 0, mm.
pub const ABOVE: f64 = 12.0;
/// Space below the plan view for the dimension of the side view, mm.
pub const BELOW: f64 = 14.0;
/// Space to the right of the side view for the thickness dimension of a thin plate, mm.
pub const BESIDE: f64 = 16.0;
/// Distance of the frame from the edge of the sheet, mm. The distance is 20 mm on the left, where sheets are bound.
const EDGE: f64 = 10.0;
const BOUND: f64 = 20.0;

/// Mantissas of the standard scales (ISO 5455), in decreasing order.
const ENLARGED: [f64; 3] = [5.0, 2.0, 1.0];
const REDUCED: [f64; 3] = [2.0, 5.0, 10.0];

/// Scale of the views: length on the sheet and corresponding length of the cam, both in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    sheet: f64,
    cam: f64,
}

impl Scale {
    /// Millimetres on the sheet per millimetre of the cam.
    pub fn factor(self) -> f64 {
        self.sheet / self.cam
    }

    /// Scale as it is written in the drawing, such as `1 : 2`.
    pub fn text(self) -> String {
        format!("{} : {}", self.sheet, self.cam)
    }

    /// All standard scales from 50 : 1 to 1 : 10 000, in decreasing order.
    fn all() -> impl Iterator<Item = Scale> {
        let enlarged = [10.0, 1.0].into_iter().flat_map(|ten| {
            ENLARGED.map(|step| Scale {
                sheet: ten * step,
                cam: 1.0,
            })
        });
        let reduced = [1.0, 10.0, 100.0, 1000.0].into_iter().flat_map(|ten| {
            REDUCED.map(|step| Scale {
                sheet: 1.0,
                cam: ten * step,
            })
        });
        enlarged.chain(reduced)
    }
}

/// Format, scale and areas of a drawing sheet, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// Name of the sheet format: A4 or A3.
    pub name: &'static str,
    /// Width and height of the paper in mm: 210 × 297 or 420 × 297.
    pub paper: [f64; 2],
    /// Area inside the frame of the drawing, with the margins outside.
    pub frame: Area,
    /// Area for the plan view and the side view.
    pub views: Area,
    /// Area for the table of radii.
    pub table: Area,
    /// Area for the title block.
    pub title: Area,
    /// Number of blocks side by side into which the table of radii is divided. The title block has the same number of columns.
    pub blocks: usize,
    /// Scale of the plan view and the side view.
    pub scale: Scale,
}

/// Heights of the title block on A4 and on A3, mm.
const TITLE: [f64; 2] = [50.0, 74.0];
const TABLE: [f64; 2] = [96.0, 137.0];
/// Width of the right column with table and title block on A3, mm.
const COLUMN: f64 = 112.0;
const GAP: f64 = 2.0;

impl Layout {
    /// Smallest suitable sheet for the views. `room` computes the width and height of the views on the sheet, mm, from a scale.
    ///
    /// The sheet is A3 if the views would be reduced on A4 and A3 permits a larger scale. Otherwise it is A4.
    pub fn fitting(room: impl Fn(f64) -> [f64; 2]) -> Layout {
        let [on_a4, on_a3] = [false, true].map(|is_a3| Self::of_paper(is_a3).scaled(&room));
        if on_a4.scale.factor() >= on_a3.scale.factor().min(1.0) {
            on_a4
        } else {
            on_a3
        }
    }

    fn scaled(self, room: impl Fn(f64) -> [f64; 2]) -> Layout {
        let fits = |scale: &Scale| {
            let [wide, high] = room(scale.factor());
            wide <= self.views.width() && high <= self.views.height()
        };
        let scale = Scale::all().find(fits).unwrap_or(self.scale);
        Layout { scale, ..self }
    }

    /// Layout of a portrait A4 sheet or of an A3 sheet. On A4, all areas are in one column. On A3, table and title block are in a second column.
    fn of_paper(is_a3: bool) -> Layout {
        let (name, width, blocks) = if is_a3 {
            ("A3", 420.0, 2)
        } else {
            ("A4", 210.0, 3)
        };
        let size = usize::from(is_a3);
        let frame = Area {
            left: BOUND,
            bottom: EDGE,
            right: width - EDGE,
            top: 297.0 - EDGE,
        };
        let column = if is_a3 {
            frame.right - COLUMN
        } else {
            frame.left
        };
        let title = Area {
            left: column,
            top: frame.bottom + TITLE[size],
            ..frame
        };
        let table = Area {
            left: column,
            bottom: title.top + GAP,
            top: title.top + GAP + TABLE[size],
            ..frame
        };
        let mut views = frame;
        if is_a3 {
            views.right = column - GAP;
        } else {
            views.bottom = table.top;
        }
        Layout {
            name,
            paper: [width, 297.0],
            frame,
            views,
            table,
            title,
            blocks,
            scale: SMALLEST,
        }
    }
}

/// Scale for cams that do not fit on the sheet at any standard scale.
const SMALLEST: Scale = Scale {
    sheet: 1.0,
    cam: 10_000.0,
};
