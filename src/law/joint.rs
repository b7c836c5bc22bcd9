//! How the pieces of a law join: the fundamental law of cam design asks for C² everywhere.

use super::{Law, Svaj};

/// What jumps at one break: value after less value before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Angle of the break, rad.
    pub at: f64,
    /// Jumps of s, v, a, j.
    pub jump: Svaj,
}

/// Joints at all inner breaks, and at the wrap (reported at the law's first angle) of a closed law.
pub(super) fn joints(law: &Law) -> Vec<Joint> {
    let n = law.poly().pieces();
    let first = usize::from(!law.is_closed());
    (first..n)
        .map(|i| {
            let before = law.svaj_on((i + n - 1) % n, 1.0);
            let after = law.svaj_on(i, 0.0);
            Joint {
                at: law.breaks()[i],
                jump: Svaj {
                    s: after.s - before.s,
                    v: after.v - before.v,
                    a: after.a - before.a,
                    j: after.j - before.j,
                },
            }
        })
        .collect()
}
