//! Results for the scene in a physics engine with time steps, measured by `lab/peers/rapier`.

use super::Page;

/// Output of the benchmark.
const MEASURED: &str = include_str!("rapier.csv");

/// Result of one method at one size for the eccentric at 35 rad/s with plastic landing.
#[derive(Debug, Clone, PartialEq)]
pub struct Peer {
    /// Name of the method.
    pub method: String,
    /// Number of points, or of steps per turn.
    pub size: String,
    /// Wall time of one turn, s.
    pub seconds: f64,
    /// RMS error of the follower's height over a turn, m.
    pub rms: f64,
    /// Largest error of the follower's height, m.
    pub largest: f64,
}

/// Measured rows. A row that cannot be read is left out.
pub fn rapier() -> Vec<Peer> {
    let mut reader = csv::Reader::from_reader(MEASURED.as_bytes());
    let rows = reader.deserialize().filter_map(std::result::Result::ok);
    rows.map(|(method, size, seconds, rms, largest)| Peer {
        method,
        size,
        seconds,
        rms,
        largest,
    })
    .collect()
}

/// Writes table and text of the comparison.
pub(super) fn against_rapier(out: &mut Page) {
    out.line("\n## Comparison with a time-stepping engine\n");
    out.line("The eccentric at 35 rad/s with plastic landing is simulated by rapier2d 0.22 in double precision (a ball on a circular path is the exact contour), and by the contact model from emitted points. Error of the follower's height against the closed form over a steady turn; medians of one run on one machine whose cores did other work as well (`lab/peers/rapier`).\n");
    out.table("method | size | wall time per turn ms | RMS error µm | largest µm");
    for p in rapier() {
        out.line(format_args!(
            "| {} | {} | {:.3} | {:.2e} | {:.2e} |",
            p.method,
            p.size,
            1e3 * p.seconds,
            1e6 * p.rms,
            1e6 * p.largest
        ));
    }
    out.line("");
    out.picture(
        "dynamics_rapier",
        "Error of the height against wall time: events and time steps",
    );
    out.line("With time steps, the landing is late by up to a step, and the penetration is corrected over several more steps. A quarter of the step size therefore gives a quarter of the error. Events are exact except for the interpolation of the points.");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_beat_steps_in_error_and_time() {
        let all = rapier();
        let best = |word: &str| {
            all.iter()
                .filter(|p| p.method.starts_with(word))
                .map(|p| p.rms)
                .fold(f64::INFINITY, f64::min)
        };
        assert!(all.len() >= 10);
        assert!(best("gaitcam") < 1e-3 * best("rapier2d"));
    }
}
