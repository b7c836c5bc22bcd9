//! Additions to drawings of the outline: identifiers of layers, marks, and the arrow of rotation.

use gaitcam::synth::Design;

/// Half the length of the strokes of the centre mark, m.
const MARK: f64 = 0.003;

/// Name of a layer as an SVG identifier: without the prefix `CUT_` or `REF_`, in lower case, with hyphens.
pub fn id(layer: &str) -> String {
    let name = layer.split_once('_').map_or(layer, |(_, name)| name);
    name.to_lowercase().replace('_', "-")
}

/// Reference lines of the drawing, each with its layer and its end points (m). They mark the centre of a disc, the foot of a translating
/// cam, or the ends of each turn of an unrolled barrel.
pub fn marks(synthesis: &Design) -> Vec<(&'static str, [[f64; 2]; 2])> {
    let follower = &synthesis.cam.follower;
    let (start, length) = synthesis.cam.law.extent();
    if !follower.is_unrolled() {
        return vec![
            ("REF_CENTRE", [[-MARK, 0.0], [MARK, 0.0]]),
            ("REF_CENTRE", [[0.0, -MARK], [0.0, MARK]]),
        ];
    }
    if synthesis.groove.is_none() {
        return vec![("REF_FOOT", [[start, 0.0], [start + length, 0.0]])];
    }
    let radius = follower.base_radius();
    let (low, high) = synthesis.cam.law.extremes(0);
    let room = follower.roller_radius() + MARK;
    let turns = (length / std::f64::consts::TAU).round() as usize;
    (0..=turns)
        .map(|k| {
            let x = radius * (start + length * k as f64 / turns.max(1) as f64);
            ("REF_SEAM", [[x, low.value - room], [x, high.value + room]])
        })
        .collect()
}

/// Mark of θ = 0, a line along the motion of the follower (+y). It extends from the middle between bore and base circle to the base circle. The
/// radii and the result have the same unit.
pub fn zero_mark(base: f64, bore: f64) -> [[f64; 2]; 2] {
    [[0.0, 0.5 * (base + bore)], [0.0, base]]
}

/// Arrow in the direction of rotation: an arc about the centre, on the side opposite to the mark of θ = 0.
pub struct Arrow {
    /// Whether the cam rotates clockwise, with decreasing θ.
    pub clockwise: bool,
    /// Radius of the arrow's arc, in the unit of the radii given to [`Arrow::new`].
    pub radius: f64,
    /// Start and tip of the arrow, in the unit of `radius`.
    pub ends: [[f64; 2]; 2],
    /// Ends of the two strokes of the arrow's head, in the unit of `radius`.
    pub head: [[f64; 2]; 2],
}

impl Arrow {
    /// Angle of the arrow's arc, rad.
    pub const ANGLE: f64 = std::f64::consts::FRAC_PI_3;

    /// Arrow whose arc is halfway between bore and base circle. The radii `base` and `bore` are in any common unit.
    pub fn new(base: f64, bore: f64, clockwise: bool) -> Self {
        let radius = 0.5 * (base + bore);
        let sense = if clockwise { -1.0 } else { 1.0 };
        let middle = -std::f64::consts::FRAC_PI_2;
        let at = |r: f64, part: f64| {
            let angle = middle + sense * part * Self::ANGLE;
            [r * libm::cos(angle), r * libm::sin(angle)]
        };
        Arrow {
            clockwise,
            radius,
            ends: [at(radius, -0.5), at(radius, 0.5)],
            head: [at(0.94 * radius, 0.38), at(1.06 * radius, 0.38)],
        }
    }
}
