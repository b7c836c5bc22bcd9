//! Path along the edge of the bore, for a wire or a milling cutter that starts at the centre of the bore.

use gaitcam::cam::Bore;

use super::{Move, Path};

/// Path inside the bore at the distance `radius` m from its edge, counter-clockwise from the lowest point. `None` if the tool does not fit.
pub fn hole(bore: &Bore, radius: f64) -> Option<Path> {
    let round = bore.radius() - radius;
    if round <= 0.0 {
        return None;
    }
    let centre = [0.0; 2];
    let lowest = [0.0, -round];
    let mut moves = vec![Move::line(lowest)];
    match bore.keyway {
        None => {
            moves.push(Move::arc([0.0, round], centre, true));
            moves.push(Move::arc(lowest, centre, true));
        }
        Some(key) => {
            let half = 0.5 * key.width;
            let (aside, top) = (half - radius, bore.radius() + key.depth - radius);
            if aside <= 0.0 {
                return None;
            }
            let foot = (bore.radius() * bore.radius() - half * half).sqrt();
            // Where the round part of the bore ends, the wire passes around the corner of the keyway.
            let shrunk = round / bore.radius();
            let corner = |side: f64| [side * half, foot];
            let before = |side: f64| [side * half * shrunk, foot * shrunk];
            moves.push(Move::arc(before(1.0), centre, true));
            moves.push(Move::arc([aside, foot], corner(1.0), false));
            moves.extend([[aside, top], [-aside, top], [-aside, foot]].map(Move::line));
            moves.push(Move::arc(before(-1.0), corner(-1.0), false));
            moves.push(Move::arc(lowest, centre, true));
        }
    }
    moves.push(Move::line(centre));
    Some(Path {
        start: centre,
        moves,
    })
}
