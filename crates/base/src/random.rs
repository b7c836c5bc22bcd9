//! Pseudo-random numbers that are the same in every run and on every machine.

/// Difference between consecutive states of SplitMix64.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// SplitMix64: maps a 64-bit number to a pseudo-random 64-bit number (Steele, Lea, Flood 2014).
///
/// ```
/// // First output of the published generator with seed 0.
/// assert_eq!(gaitcam_base::random::mixed(0), 0xe220_a839_7b1d_cdaf);
/// ```
pub fn mixed(x: u64) -> u64 {
    let mut z = x.wrapping_add(STEP);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Converts the upper 53 bits to a number in [0, 1). Random bits give a uniform distribution.
pub fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// Sequence of pseudo-random numbers from SplitMix64.
///
/// ```
/// use gaitcam_base::random::{Sequence, mixed, unit};
///
/// let mut sequence = Sequence::new(7);
/// assert_eq!(sequence.next_unit(), unit(mixed(7)));
/// ```
#[derive(Debug, Clone)]
pub struct Sequence {
    state: u64,
}

impl Sequence {
    /// Starts a sequence. Equal seeds give equal sequences.
    pub fn new(seed: u64) -> Sequence {
        Sequence { state: seed }
    }

    /// Next number of the sequence, uniformly distributed in [0, 1).
    pub fn next_unit(&mut self) -> f64 {
        let bits = mixed(self.state);
        self.state = self.state.wrapping_add(STEP);
        unit(bits)
    }
}
