//! Triangles of a plane face with holes, by cutting ears.
//!
//! Holes are joined to the outline by bridges (Eberly, *Triangulation by ear clipping*), so that one ring of vertices is
//! left.

/// The triangles of a face within `rings[0]`, counter-clockwise, around the other rings, clockwise; vertices count through
/// all rings. `None` where the rings cross.
pub fn triangulate(rings: &[Vec<[f64; 2]>]) -> Option<Vec<[usize; 3]>> {
    let points: Vec<[f64; 2]> = rings.concat();
    let mut first = 0;
    let mut indices: Vec<Vec<usize>> = Vec::new();
    for ring in rings {
        indices.push((first..first + ring.len()).collect());
        first += ring.len();
    }
    let mut holes: Vec<Vec<usize>> = indices.split_off(1);
    let mut ring = indices.pop()?;
    // The hole farthest to the right first: its bridge cannot meet another hole.
    holes.sort_by(|a, b| rightmost(b, &points).1.total_cmp(&rightmost(a, &points).1));
    for hole in holes {
        bridge(&mut ring, &hole, &points)?;
    }
    cut(ring, &points)
}

/// Place and x of the vertex of a ring that lies farthest to the right.
fn rightmost(ring: &[usize], points: &[[f64; 2]]) -> (usize, f64) {
    let mut best = (0, f64::NEG_INFINITY);
    for (place, &i) in ring.iter().enumerate() {
        if points[i][0] > best.1 {
            best = (place, points[i][0]);
        }
    }
    best
}

/// Twice the signed area of a triangle.
fn side(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether a point lies in a counter-clockwise triangle or on its edge.
fn within(p: [f64; 2], [a, b, c]: [[f64; 2]; 3]) -> bool {
    side(a, b, p) >= 0.0 && side(b, c, p) >= 0.0 && side(c, a, p) >= 0.0
}

/// Joins a hole to the ring from its rightmost vertex to one that sees it.
fn bridge(ring: &mut Vec<usize>, hole: &[usize], points: &[[f64; 2]]) -> Option<()> {
    let (start, _) = rightmost(hole, points);
    let m = points[hole[start]];
    let n = ring.len();
    // The nearest edge that the ray to the right meets, which runs upwards.
    let mut met: Option<(f64, usize)> = None;
    for k in 0..n {
        let (a, b) = (points[ring[k]], points[ring[(k + 1) % n]]);
        if a[1] <= m[1] && b[1] > m[1] {
            let x = a[0] + (b[0] - a[0]) * (m[1] - a[1]) / (b[1] - a[1]);
            if x >= m[0] && met.is_none_or(|(best, _)| x < best) {
                met = Some((x, k));
            }
        }
    }
    let (x, k) = met?;
    let ends = [k, (k + 1) % n];
    let right = |k: &usize| points[ring[*k]][0];
    let mut seen = *ends.iter().max_by(|a, b| right(a).total_cmp(&right(b)))?;
    // A vertex within the triangle hides the end of that edge: the one at the smallest angle from the ray is seen.
    let (hit, end) = ([x, m[1]], points[ring[seen]]);
    let triangle = if side(m, hit, end) >= 0.0 {
        [m, hit, end]
    } else {
        [m, end, hit]
    };
    let mut smallest = (end[1] - m[1]).abs() / (end[0] - m[0]).hypot(end[1] - m[1]);
    for (place, &i) in ring.iter().enumerate() {
        let p = points[i];
        let far = (p[0] - m[0]).hypot(p[1] - m[1]);
        let angle = (p[1] - m[1]).abs() / far;
        if i != ring[seen] && p[0] >= m[0] && within(p, triangle) && angle < smallest {
            (seen, smallest) = (place, angle);
        }
    }
    let mut joined: Vec<usize> = ring[..=seen].to_vec();
    joined.extend(hole[start..].iter().chain(&hole[..=start]));
    joined.extend(&ring[seen..]);
    *ring = joined;
    Some(())
}

/// Cuts ears until nothing is left.
fn cut(mut ring: Vec<usize>, points: &[[f64; 2]]) -> Option<Vec<[usize; 3]>> {
    let mut out = Vec::with_capacity(ring.len());
    let mut place = 0;
    let mut tried = 0;
    while ring.len() > 2 {
        let n = ring.len();
        let corners = [(place + n - 1) % n, place % n, (place + 1) % n].map(|k| ring[k]);
        if is_ear(&ring, corners, points) {
            out.push(corners);
            ring.remove(place % n);
            tried = 0;
            // The next but one, so that ears are taken all round and stay compact.
            place = (place % n) + 1;
        } else {
            place += 1;
            tried += 1;
            if tried > n {
                return None;
            }
        }
    }
    Some(out)
}

fn is_ear(ring: &[usize], corners: [usize; 3], points: &[[f64; 2]]) -> bool {
    let triangle = corners.map(|i| points[i]);
    let [a, b, c] = triangle;
    if side(a, b, c) <= 0.0 {
        return false;
    }
    ring.iter()
        .map(|&i| points[i])
        .all(|p| p == a || p == b || p == c || !within(p, triangle))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round(centre: [f64; 2], radius: f64, count: usize, sense: f64) -> Vec<[f64; 2]> {
        (0..count)
            .map(|i| {
                let a = sense * std::f64::consts::TAU * i as f64 / count as f64;
                [centre[0] + radius * a.cos(), centre[1] + radius * a.sin()]
            })
            .collect()
    }

    fn area(ring: &[[f64; 2]]) -> f64 {
        let n = ring.len();
        let cross = |i: usize| {
            let (a, b) = (ring[i], ring[(i + 1) % n]);
            a[0] * b[1] - a[1] * b[0]
        };
        0.5 * (0..n).map(cross).sum::<f64>()
    }

    #[test]
    fn triangles_fill_a_disc_between_its_holes() {
        let rings = [
            round([0.0, 0.0], 30.0, 361, 1.0),
            round([0.0, 0.0], 8.0, 60, -1.0),
            round([15.0, 3.0], 5.0, 47, -1.0),
            round([-17.0, -4.0], 6.0, 48, -1.0),
        ];
        let triangles = triangulate(&rings).unwrap();
        let points = rings.concat();
        let filled: f64 = triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| points[i]);
                let twice = side(a, b, c);
                assert!(twice > 0.0);
                0.5 * twice
            })
            .sum();
        let exact: f64 = rings.iter().map(|ring| area(ring)).sum();
        assert!((filled / exact - 1.0).abs() < 1e-12, "{filled} {exact}");
        // Every edge of a ring once, every other edge twice in opposite senses.
        let mut count = std::collections::HashMap::new();
        for t in &triangles {
            for k in 0..3 {
                *count.entry((t[k], t[(k + 1) % 3])).or_insert(0) += 1;
            }
        }
        assert!(count.values().all(|n| *n == 1));
        let open = count
            .keys()
            .filter(|(a, b)| !count.contains_key(&(*b, *a)))
            .count();
        assert_eq!(open, points.len());
    }
}
