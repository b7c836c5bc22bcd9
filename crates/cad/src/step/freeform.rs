//! Writing of B-spline curves and surfaces in space to a STEP file, mm.

use super::file::{File, list, real};

/// Multiplicities and values of the knots of a clamped B-spline.
pub type Knots = [(usize, f64)];

impl File {
    /// Adds a cubic B-spline curve with the given control points, mm.
    pub fn spline_curve(&mut self, control: &[[f64; 3]], knots: &Knots) -> usize {
        let points = self.points(control);
        let (counts, values) = written(knots);
        self.add(&format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{points},.UNSPECIFIED.,.F.,.F.,{counts},{values},.UNSPECIFIED.)"
        ))
    }

    /// Adds a B-spline surface, cubic in the first direction and of any degree in the second. `net[i][j]` is its control point with the index i in
    /// the first direction and j in the second, mm.
    pub fn spline_surface(&mut self, net: &[Vec<[f64; 3]>], knots: [&Knots; 2]) -> usize {
        let rows: Vec<String> = net.iter().map(|row| self.points(row)).collect();
        let degree = knots[1][0].0 - 1;
        let [(u_counts, u), (v_counts, v)] = knots.map(written);
        self.add(&format!(
            "B_SPLINE_SURFACE_WITH_KNOTS('',3,{degree},({}),.UNSPECIFIED.,.F.,.F.,.F.,{u_counts},{v_counts},{u},{v},.UNSPECIFIED.)",
            rows.join(",")
        ))
    }

    /// Writes the control points and returns the STEP list of their references.
    fn points(&mut self, control: &[[f64; 3]]) -> String {
        let points: Vec<usize> = control.iter().map(|p| self.point(*p)).collect();
        list(&points)
    }
}

fn written(knots: &Knots) -> (String, String) {
    let counts: Vec<String> = knots.iter().map(|k| k.0.to_string()).collect();
    let values: Vec<String> = knots.iter().map(|k| real(k.1)).collect();
    (
        format!("({})", counts.join(",")),
        format!("({})", values.join(",")),
    )
}
