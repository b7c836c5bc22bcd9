//! Slopes of the interpolation between samples.
//!
//! The slope per sample at the middle of five samples is the fourth-order centred difference, held within three times the
//! smaller neighbouring step, so that a sharp heel strike is not overshot (Fritsch and Carlson's bound). At a local extreme
//! of the samples half that bound applies to either sign, so that a smooth peak between two samples is not flattened.

use pulp::{Arch, Scalar, Simd, WithSimd};

/// Slopes at all samples of a period, four or more, and at its end.
pub fn slopes(f: &[f64]) -> Vec<f64> {
    let n = f.len();
    let mut out = vec![0.0; n + 1];
    Arch::new().dispatch(Slopes {
        f,
        less_centred: false,
        out: &mut out[2..n - 2],
    });
    for i in [0, 1, n - 2, n - 1] {
        out[i] = slope_at(f, i);
    }
    out[n] = out[0];
    out
}

/// The slope at one sample of a period, counted round.
pub fn slope_at(f: &[f64], i: usize) -> f64 {
    let n = f.len();
    let around = [n - 2, n - 1, 0, 1, 2].map(|k| f[(i + k) % n]);
    slope(Scalar::new(), around, false)
}

/// Slopes at all samples but the first two and the last two, less the centred differences: zero but near crests and steps.
pub fn slope_corrections(f: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; f.len() - 4];
    Arch::new().dispatch(Slopes {
        f,
        less_centred: true,
        out: &mut out,
    });
    out
}

/// All samples but the first two and the last two.
struct Slopes<'a> {
    f: &'a [f64],
    less_centred: bool,
    out: &'a mut [f64],
}

impl WithSimd for Slopes<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let n = self.f.len() - 4;
        let (a, a_rest) = S::as_simd_f64s(&self.f[..n]);
        let (b, b_rest) = S::as_simd_f64s(&self.f[1..=n]);
        let (c, c_rest) = S::as_simd_f64s(&self.f[2..n + 2]);
        let (d, d_rest) = S::as_simd_f64s(&self.f[3..n + 3]);
        let (e, e_rest) = S::as_simd_f64s(&self.f[4..n + 4]);
        let (own, own_rest) = S::as_mut_simd_f64s(self.out);
        for (i, own) in own.iter_mut().enumerate() {
            *own = slope(simd, [a[i], b[i], c[i], d[i], e[i]], self.less_centred);
        }
        for (i, own) in own_rest.iter_mut().enumerate() {
            let f = [a_rest[i], b_rest[i], c_rest[i], d_rest[i], e_rest[i]];
            *own = slope(Scalar::new(), f, self.less_centred);
        }
    }
}

#[inline(always)]
fn slope<S: Simd>(simd: S, f: [S::f64s; 5], less_centred: bool) -> S::f64s {
    let number = |x: f64| simd.splat_f64s(x);
    let zero = number(0.0);
    let before = simd.sub_f64s(f[2], f[1]);
    let after = simd.sub_f64s(f[3], f[2]);
    let near = simd.mul_f64s(number(2.0 / 3.0), simd.sub_f64s(f[3], f[1]));
    let far = simd.mul_f64s(number(1.0 / 12.0), simd.sub_f64s(f[4], f[0]));
    let centred = simd.sub_f64s(near, far);
    let smaller = simd.min_f64s(simd.abs_f64s(before), simd.abs_f64s(after));
    let steady = simd.less_than_f64s(zero, simd.mul_f64s(before, after));
    let most = simd.select_f64s(steady, number(3.0), number(1.5));
    let bound = simd.mul_f64s(most, smaller);
    let held = simd.max_f64s(simd.neg_f64s(bound), simd.min_f64s(centred, bound));
    let against = simd.less_than_f64s(simd.mul_f64s(centred, before), zero);
    let backwards = simd.and_m64s(steady, against);
    let slope = simd.select_f64s(backwards, zero, held);
    if less_centred {
        simd.sub_f64s(slope, centred)
    } else {
        slope
    }
}
