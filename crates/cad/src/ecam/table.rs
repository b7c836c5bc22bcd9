//! Points of an electronic cam, in the units of its controller.

use gaitcam::cam::Measures;
use gaitcam::law::Svaj;
use gaitcam::synth::Design;

use super::Number;

/// Rounding error of a column, in units in the last place of the column's maximum. A smaller value is replaced by 0.
const ROUNDED: f64 = 64.0;
/// Difference between the two sides of a joint, relative to the column's maximum, below which it counts as a rounding error.
const SAME: f64 = 1e-9;

/// Point of the cam, in the units of the file. The derivatives are derivatives of the follower's position with respect to the cam's
/// position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Position of the cam (master), degrees or mm.
    pub x: f64,
    /// Position of the follower (slave), mm or degrees.
    pub y: f64,
    /// First derivative dy/dx at the point.
    pub v: f64,
    /// Second derivative d²y/dx² at the point.
    pub a: f64,
}

/// Contents of a file for a controller, in the units of the controller.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Name of the scene.
    pub name: String,
    /// Unit of x: `deg` or `mm`.
    pub x_unit: &'static str,
    /// Unit of y: `mm` or `deg`.
    pub y_unit: &'static str,
    /// Conversion factors: x per rad (or m) of the law, and y per m (or rad) of the lift.
    pub factors: [f64; 2],
    /// Whether the motion is periodic.
    pub closed: bool,
    /// Both end points of every interval. Derivatives of the law may jump between two intervals.
    pub segments: Vec<[Node; 2]>,
}

impl Table {
    /// Table of a design with points at the given angles, rad (for a translating cam: positions, m), rounded to the number type of the controller.
    pub fn of(design: &Design, angles: &[f64], number: Number) -> Table {
        let measures = design.cam.follower.measures();
        let (x_unit, x) = match measures {
            Measures::Straight => ("mm", 1e3),
            Measures::Translating | Measures::Oscillating => ("deg", 1f64.to_degrees()),
        };
        let (y_unit, y) = match measures {
            Measures::Oscillating => ("deg", 1f64.to_degrees()),
            Measures::Translating | Measures::Straight => ("mm", 1e3),
        };
        let law = &design.cam.law;
        let breaks = law.breaks();
        let node = |theta: f64, at: Svaj| Node {
            x: number.nearest(x * theta),
            y: number.nearest(y * at.s),
            v: number.nearest(y / x * at.v),
            a: number.nearest(y / (x * x) * at.a),
        };
        let end = |theta: f64| {
            // Index of the last span of the law that begins before the angle `theta`.
            let i = breaks
                .partition_point(|b| *b < theta)
                .clamp(1, breaks.len() - 1)
                - 1;
            law.svaj_on(i, (theta - breaks[i]) / (breaks[i + 1] - breaks[i]))
        };
        let segment = |pair: &[f64]| {
            [
                node(pair[0], law.svaj(pair[0])),
                node(pair[1], end(pair[1])),
            ]
        };
        Table {
            name: design.problem.name.clone(),
            x_unit,
            y_unit,
            factors: [x, y],
            closed: law.is_closed(),
            segments: clean(angles.windows(2).map(segment).collect(), number),
        }
    }

    /// All points without repetition: the left ends of all intervals, and the right end of the last interval.
    pub fn nodes(&self) -> impl Iterator<Item = Node> {
        let last = self.segments.last().map(|s| s[1]);
        self.segments.iter().map(|s| s[0]).chain(last)
    }

    /// Structured-text literal: `TRUE` if the controller repeats the cam, otherwise `FALSE`.
    pub fn periodic(&self) -> &'static str {
        if self.closed { "TRUE" } else { "FALSE" }
    }

    /// Comment in English and Spanish about the kind of master axis that the cam requires.
    pub fn axes(&self) -> String {
        match (self.closed, self.x_unit) {
            (true, "deg") => "(* The master is a modulo axis of 360 deg; cam angle 0 is its position 0. *)\n\
                              (* El maestro es un eje módulo de 360 grados; el ángulo 0 de la leva es su posición 0. *)\n",
            _ => "(* The master is a linear axis: the motion is not repeated. *)\n\
                  (* El maestro es un eje lineal: el movimiento no se repite. *)\n",
        }
        .to_string()
    }

    /// Description of the columns and their units, for the first lines of a file.
    pub fn head(&self) -> String {
        let (x, y) = (self.x_unit, self.y_unit);
        // Removes characters that would end a comment in the file.
        let name = self.name.replace(['*', '(', ')', '\n', '\r'], " ");
        let points = self.segments.len() + 1;
        format!(
            "{name}: cam in {x}, follower in {y}, derivatives by the position of the cam, {points} points"
        )
    }
}

/// Removes rounding errors from the segments. A value below [`ROUNDED`] units in the last place of its column's maximum becomes 0. Values on both
/// sides of a joint that differ only by rounding errors become equal.
fn clean(mut segments: Vec<[Node; 2]>, number: Number) -> Vec<[Node; 2]> {
    type Column = fn(&mut Node) -> &mut f64;
    let columns: [Column; 4] = [|n| &mut n.x, |n| &mut n.y, |n| &mut n.v, |n| &mut n.a];
    for column in columns {
        let values = segments.iter_mut().flatten().map(|n| column(n).abs());
        let most = values.fold(0.0, f64::max);
        for x in segments.iter_mut().flatten().map(column) {
            if x.abs() < ROUNDED * number.unit_of_last_place() * most {
                *x = 0.0;
            }
        }
        for i in 1..segments.len() {
            let before = *column(&mut segments[i - 1][1]);
            let after = column(&mut segments[i][0]);
            if (*after - before).abs() <= SAME * most {
                *after = before;
            }
        }
    }
    segments
}

impl Number {
    /// Number of this type that is nearest to `x`.
    pub fn nearest(self, x: f64) -> f64 {
        match self {
            Number::Single => f64::from(x as f32),
            Number::Double => x,
        }
    }

    /// Distance between 1 and the next larger number of this type.
    fn unit_of_last_place(self) -> f64 {
        match self {
            Number::Single => f64::from(f32::EPSILON),
            Number::Double => f64::EPSILON,
        }
    }
}
