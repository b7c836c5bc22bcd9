//! Small problems whose law and cam are known in closed form, for tests.

use crate::problem::Problem;
use crate::units::G;

/// Problem with a force of one harmonic, 0.3 of the weight at 2 Hz, on a moving axis. Its law has three coefficients (constant, cosine, sine).
/// `cam` and `limits` are the TOML lines of the tables `[cam]` and `[limits]`.
pub fn one_wave(cam: &str, limits: &str) -> Problem {
    let text = format!(
        "[gait]\nharmonics = [\"0.3\"]\nstep_frequency = \"2 Hz\"\n[drive]\nkind = \"moving-axis\"\n\
         [law]\nfamily = \"harmonic\"\nharmonics = 1\n[cam]\n{cam}\n[accuracy]\nrms = \"none\"\n[limits]\n{limits}"
    );
    let scene = crate::scene::parse(&text).unwrap();
    Problem::resolve(&scene, scene.model_force().unwrap().as_ref()).unwrap()
}

/// TOML line of the table `[cam]` for a flat face of automatic size.
pub const FLAT: &str = "follower = \"flat-translating\"";

/// Amplitude of the lift, m, that produces the complete alternating force: 0.3 g/ω².
pub fn amplitude(problem: &Problem) -> f64 {
    0.3 * G / problem.drive.speed.powi(2)
}
