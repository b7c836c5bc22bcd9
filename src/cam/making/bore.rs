//! Bore for the shaft, with or without a keyway, and the wall around the bore.

use serde::Serialize;

/// Parallel keys of DIN 6885-1 (ISO 773): maximum shaft diameter, width, depth of the keyway in the hub, mm.
const DIN_6885: [[f64; 3]; 17] = [
    [8.0, 2.0, 1.0],
    [10.0, 3.0, 1.4],
    [12.0, 4.0, 1.8],
    [17.0, 5.0, 2.3],
    [22.0, 6.0, 2.8],
    [30.0, 8.0, 3.3],
    [38.0, 10.0, 3.3],
    [44.0, 12.0, 3.3],
    [50.0, 14.0, 3.8],
    [58.0, 16.0, 4.3],
    [65.0, 18.0, 4.4],
    [75.0, 20.0, 4.9],
    [85.0, 22.0, 5.4],
    [95.0, 25.0, 5.4],
    [110.0, 28.0, 6.4],
    [130.0, 32.0, 7.4],
    [150.0, 36.0, 8.4],
];
/// Minimum shaft diameter for which the standard specifies a key, m.
const THINNEST: f64 = 6e-3;
/// Thickness of the wall of a hub, as a fraction of its bore diameter. The outer diameter of a hub is usually 1.5 to 2 times the shaft
/// diameter.
const HUB: f64 = 0.25;
/// Minimum thickness of the wall around a bore without a keyway, m. The next constant applies to the wall outside a keyway.
const WALL: f64 = 1e-3;
const KEYED_WALL: f64 = 3e-3;

/// Keyway in the bore of the cam, for a parallel key.
///
/// ```
/// use gaitcam::cam::Keyway;
///
/// // DIN 6885-1 for shafts above 17 mm, up to 22 mm: 6 mm wide, 2.8 mm deep in the hub.
/// let keyway = Keyway::for_shaft(0.020).unwrap();
/// assert_eq!((keyway.width, keyway.depth), (0.006, 0.0028));
/// assert_eq!(Keyway::of_width(0.006), Some(keyway));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Keyway {
    /// Width of the keyway, m.
    pub width: f64,
    /// Depth above the circle of the bore in the middle of the keyway (t₂ of the standard), m.
    pub depth: f64,
}

impl Keyway {
    /// Keyway of DIN 6885-1 for a shaft diameter, m; `None` outside 6 … 150 mm.
    ///
    /// ```
    /// use gaitcam::cam::Keyway;
    ///
    /// assert_eq!(Keyway::for_shaft(0.012), Some(Keyway { width: 0.004, depth: 0.0018 }));
    /// assert_eq!(Keyway::for_shaft(0.2), None);
    /// ```
    pub fn for_shaft(diameter: f64) -> Option<Keyway> {
        let row = DIN_6885.iter().find(|row| diameter <= 1e-3 * row[0])?;
        (diameter > THINNEST).then_some(Keyway::of(row))
    }

    /// Keyway of DIN 6885-1 with this width, m; `None` if the standard has no such width.
    pub fn of_width(width: f64) -> Option<Keyway> {
        let row = DIN_6885
            .iter()
            .find(|row| (1e-3 * row[1] - width).abs() < 1e-9)?;
        Some(Keyway::of(row))
    }

    /// Keyway widths of DIN 6885-1, m.
    pub fn widths() -> impl Iterator<Item = f64> {
        DIN_6885.iter().map(|row| 1e-3 * row[1])
    }

    fn of(row: &[f64; 3]) -> Keyway {
        // Division by 1000 gives the floating-point numbers nearest to those of the standard. Multiplication by 1e-3 does not.
        Keyway {
            width: row[1] / 1e3,
            depth: row[2] / 1e3,
        }
    }
}

/// Bore for the shaft, about the centre of rotation. Its keyway points along +y, towards θ = 0.
///
/// ```
/// use gaitcam::cam::Bore;
///
/// let bore = Bore::plain(0.012);
/// assert_eq!(bore.radius(), 0.006);
/// assert_eq!(bore.reach(), 0.006);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Bore {
    /// Diameter of the bore, m.
    pub diameter: f64,
    /// Keyway, which must be narrower than the bore; `None` for a bore without a keyway.
    pub keyway: Option<Keyway>,
}

impl Bore {
    /// Creates a bore without a keyway; `diameter` in m.
    pub fn plain(diameter: f64) -> Bore {
        Bore {
            diameter,
            keyway: None,
        }
    }

    /// Radius of the bore, m.
    pub fn radius(&self) -> f64 {
        0.5 * self.diameter
    }

    /// Maximum distance of the edge of the bore from the centre, m. With a keyway, it is the distance of the outer corners of the keyway.
    pub fn reach(&self) -> f64 {
        match self.keyway {
            None => self.radius(),
            Some(key) => libm::hypot(self.radius() + key.depth, 0.5 * key.width),
        }
    }

    /// Minimum base radius with a sufficient wall around the bore, m. Around a bore without a keyway, the wall is 1 mm. Outside a keyway,
    /// the wall is 3 mm, or half the depth of the keyway if this is more.
    pub fn least_base_radius(&self) -> f64 {
        let wall = |key: Keyway| KEYED_WALL.max(0.5 * key.depth);
        self.reach() + self.keyway.map_or(WALL, wall)
    }

    /// Base radius with the usual wall of a hub, m. The usual wall is a quarter of the bore diameter. The result is at least the minimum
    /// base radius.
    pub fn hub_radius(&self) -> f64 {
        (self.radius() + HUB * self.diameter).max(self.least_base_radius())
    }

    /// Distance of the edge of the bore from the centre, m, in the direction `angle` from +x, rad. Every ray from the centre intersects the
    /// edge once.
    pub fn edge(&self, angle: f64) -> f64 {
        let Some(key) = self.keyway else {
            return self.radius();
        };
        let (sin, cos) = libm::sincos(angle);
        let (half, top) = (0.5 * key.width, self.radius() + key.depth);
        let [top_corner, foot] = self.corner_angles(key);
        // Magnitude of the angle from +y. The edge is symmetric about the y axis.
        let aside = libm::atan2(cos.abs(), sin);
        if aside <= top_corner {
            top / sin
        } else if aside < foot {
            half / cos.abs()
        } else {
            self.radius()
        }
    }

    /// Edge of the bore, counter-clockwise. Each element contains a vertex x, y (m) and the bulge of the segment that follows it. The bulge
    /// is tan(¼ of the arc angle), and 0 for a straight segment.
    pub fn outline(&self) -> Vec<[f64; 3]> {
        let r = self.radius();
        let Some(key) = self.keyway else {
            // Two semicircles.
            return vec![[r, 0.0, 1.0], [-r, 0.0, 1.0]];
        };
        let (half, top) = (0.5 * key.width, r + key.depth);
        let foot = (r * r - half * half).sqrt();
        let [_, aside] = self.corner_angles(key);
        // The circular part of the edge consists of two arcs that meet at the lowest point.
        let quarter = 0.25 * (std::f64::consts::PI - aside);
        vec![
            [half, foot, 0.0],
            [half, top, 0.0],
            [-half, top, 0.0],
            [-half, foot, libm::tan(quarter)],
            [0.0, -r, libm::tan(quarter)],
        ]
    }

    /// Directions of the corners of the edge, from +x, rad.
    pub fn corners(&self) -> Vec<f64> {
        let up = std::f64::consts::FRAC_PI_2;
        let angles = self.keyway.map(|key| self.corner_angles(key));
        let both = |a: f64| [up - a, up + a];
        angles.into_iter().flatten().flat_map(both).collect()
    }

    /// Angles at the centre of the bore, rad, from the middle of the keyway to two corners. The first is an outer corner of the keyway, the
    /// second an inner corner on the circle of the bore.
    fn corner_angles(&self, key: Keyway) -> [f64; 2] {
        let half = 0.5 * key.width;
        let outer = libm::atan2(half, self.radius() + key.depth);
        [outer, libm::asin((half / self.radius()).clamp(-1.0, 1.0))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outline_edge_and_reach_are_of_one_hole() {
        for bore in [
            Bore::plain(0.012),
            Bore {
                diameter: 0.02,
                keyway: Keyway::for_shaft(0.02),
            },
        ] {
            for [x, y, _] in bore.outline() {
                // The edge is continuous on both sides of a corner.
                for turn in [-1e-9, 1e-9] {
                    let r = bore.edge(y.atan2(x) + turn);
                    assert!((r - x.hypot(y)).abs() < 1e-9, "{x} {y} {r}");
                }
            }
            let farthest = bore
                .outline()
                .iter()
                .map(|v| v[0].hypot(v[1]))
                .fold(0.0, f64::max);
            assert!((farthest - bore.reach()).abs() < 1e-15);
        }
    }
}
