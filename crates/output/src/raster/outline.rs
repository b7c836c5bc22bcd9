//! Lines and circles as polygons.

/// Minimum number of corners of a circle.
const CORNERS: usize = 24;
/// Maximum distance of a removed point from the simplified line, pixels. Coordinates are rounded to 1/16 pixel.
const UNSEEN: f64 = 0.06;
/// Sine of the angle between two segments above which a disc is drawn at their joint.
const SHARP: f64 = 0.1;

/// Corners of a filled circle as a polygon of equal area. The first corner is not repeated at the end.
pub fn disc([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    // Corners outside the radius compensate the area that the sides cut off.
    let corners = CORNERS.max((4.0 * radius) as usize);
    let half = std::f64::consts::PI / corners as f64;
    let r = radius * (half / libm::sin(half)).sqrt();
    (0..corners)
        .map(|i| {
            let (sin, cos) = libm::sincos(2.0 * half * i as f64);
            [x + r * cos, y + r * sin]
        })
        .collect()
}

/// Simplified line. Points within 0.06 pixel of the line through the remaining points are removed.
pub fn straightened(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut out: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let Some((&first, rest)) = points.split_first() else {
        return out;
    };
    out.push(first);
    let (mut corner, mut last) = (first, first);
    // Range of directions from the corner for which a line passes all points after the corner within the tolerance.
    let mut passing: Option<[[f64; 2]; 2]> = None;
    for &point in rest {
        let mut way = [point[0] - corner[0], point[1] - corner[1]];
        let onward = (point[0] - last[0]) * (last[0] - corner[0])
            + (point[1] - last[1]) * (last[1] - corner[1]);
        let passes = passing.is_none_or(|[left, right]| {
            cross(left, way) >= 0.0 && cross(way, right) >= 0.0 && onward >= 0.0
        });
        if !passes {
            out.push(last);
            (corner, passing) = (last, None);
            way = [point[0] - corner[0], point[1] - corner[1]];
        }
        let square = way[0] * way[0] + way[1] * way[1];
        if square > UNSEEN * UNSEEN {
            let lean = UNSEEN / square.sqrt();
            let left = [way[0] + lean * way[1], way[1] - lean * way[0]];
            let right = [way[0] - lean * way[1], way[1] + lean * way[0]];
            passing = Some(passing.map_or([left, right], |[l, r]| {
                [
                    if cross(l, left) > 0.0 { left } else { l },
                    if cross(right, r) > 0.0 { right } else { r },
                ]
            }));
        }
        last = point;
    }
    out.push(last);
    out
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A line of the given width as polygons of equal orientation: a rectangle for each segment, and a disc for each sharp corner.
pub fn outline(points: &[[f64; 2]], width: f64) -> Vec<Vec<[f64; 2]>> {
    let half = 0.5 * width;
    let mut out = Vec::with_capacity(points.len());
    let mut before: Option<[f64; 2]> = None;
    for pair in points.windows(2) {
        let (p, q) = (pair[0], pair[1]);
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let length = libm::hypot(dx, dy);
        if length <= 0.0 {
            continue;
        }
        let t = [dx / length, dy / length];
        if let Some(b) = before {
            let turn = b[0] * t[1] - b[1] * t[0];
            if turn.abs() > SHARP || b[0] * t[0] + b[1] * t[1] < 0.0 {
                out.push(disc(p, half));
            }
        }
        before = Some(t);
        let n = [-t[1] * half, t[0] * half];
        // The corners are in counter-clockwise order, as in `disc`. In these coordinates, all polygons then have a positive area.
        out.push(vec![
            [p[0] - n[0], p[1] - n[1]],
            [q[0] - n[0], q[1] - n[1]],
            [q[0] + n[0], q[1] + n[1]],
            [p[0] + n[0], p[1] + n[1]],
        ]);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn off(points: &[[f64; 2]], at: [f64; 2]) -> f64 {
        let to = |pair: &[[f64; 2]]| {
            let way = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            let here = [at[0] - pair[0][0], at[1] - pair[0][1]];
            let square = way[0] * way[0] + way[1] * way[1];
            let t = ((here[0] * way[0] + here[1] * way[1]) / square.max(1e-300)).clamp(0.0, 1.0);
            (here[0] - t * way[0]).hypot(here[1] - t * way[1])
        };
        points.windows(2).map(to).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_straightened_line_passes_every_point_by_less_than_is_seen() {
        let wave = |i: i32| {
            let x = f64::from(i) * 0.76;
            [x, 200.0 + 150.0 * (0.02 * x).sin() + 3.0 * (0.1 * x).cos()]
        };
        let circle = |i: i32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 1440.0).sin_cos();
            [300.0 + 250.0 * cos, 300.0 + 250.0 * sin]
        };
        let there_and_back = |i: i32| [f64::from(i.min(1440 - i)), 5.0];
        let shapes: [&dyn Fn(i32) -> [f64; 2]; 3] = [&wave, &circle, &there_and_back];
        for shape in shapes {
            let points: Vec<[f64; 2]> = (0..=1440).map(shape).collect();
            let fewer = straightened(&points);
            assert!(fewer.len() < points.len() / 2, "{}", fewer.len());
            let most = points.iter().map(|p| off(&fewer, *p)).fold(0.0, f64::max);
            assert!(most <= UNSEEN + 1e-9, "{most}");
        }
    }

    #[test]
    fn corners_and_ends_stay() {
        let corner = [[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, 10.0]];
        let kept = vec![[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]];
        assert_eq!(straightened(&corner), kept);
        let ring = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [0.0, 0.0]];
        assert_eq!(straightened(&ring), ring.to_vec());
        assert_eq!(straightened(&[]), Vec::<[f64; 2]>::new());
        assert_eq!(straightened(&[[1.0, 2.0]]).len(), 2);
    }
}
