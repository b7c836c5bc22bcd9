//! Figure of a cam at several speeds: force error, load factors, torque, and speed variation of a motor-driven shaft.

use std::f64::consts::PI;
use std::ops::Range;

use plotters::style::{Color, RGBAColor};

use super::force::force_frame;
use crate::plot::axes::{Panel, padded, ticks};
use crate::plot::layout::{Figure, Layout, strips};
use crate::plot::palette::{BLUE, GREEN, PURPLE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Drawn, Frame};
use crate::words::{self, Words};
use gaitcam::cam::Measures;
use gaitcam::wording::Language;

/// Points, colour and width of a drawn curve.
type Curve = (Vec<(f64, f64)>, RGBAColor, f64);

/// Results for a cam at one speed.
///
/// ```
/// use gaitcam_output::plots::{AtSpeed, speeds};
/// use gaitcam_output::Language;
/// use gaitcam::cam::Measures;
///
/// let at = |speed: f64| AtSpeed { speed, rms_error: Some(speed), torque: 2.0, ..AtSpeed::default() };
/// let picture = speeds("cam", &[at(8.0), at(9.0)], Measures::Translating, Language::En);
/// assert!(picture.svg().contains("rpm"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AtSpeed {
    /// Speed of the cam, rad/s, or m/s for a translating cam.
    pub speed: f64,
    /// RMS difference between the force and the target for this speed, N; `None` without a target.
    pub rms_error: Option<f64>,
    /// Amplitudes of the force at harmonics 1 to 4 of the step frequency, as fractions of the walker's weight.
    pub load_factors: Option<[f64; 4]>,
    /// Amplitudes of the target at the same harmonics for this speed, as fractions of the walker's weight.
    pub target_factors: Option<[f64; 4]>,
    /// Maximum absolute torque of the cam on the shaft, N·m; NaN if the shaft does not turn.
    pub torque: f64,
    /// Difference between maximum and minimum speed of the shaft, as a fraction of the mean speed.
    pub ripple: f64,
    /// Whether the follower loses contact with the cam.
    pub contact_lost: bool,
}

/// Colours of harmonics 1 to 4. The target is a wide pale line in the same colour.
const COLOURS: [RGBAColor; 4] = [BLUE, GREEN, PURPLE, RED];

/// Quantity that is drawn in one diagram of the figure.
#[derive(Clone, Copy, PartialEq)]
enum Strip {
    Error,
    /// Load factor of harmonic 1.
    FirstFactor,
    /// Load factors of harmonics 2 to 4. They are several times smaller and therefore have a separate axis.
    HigherFactors,
    Torque,
    Ripple,
}

/// Figure of a cam at several speeds. `rows` must be in ascending order of the speed.
pub fn speeds(name: &str, rows: &[AtSpeed], measures: Measures, language: Language) -> Picture {
    let (layout, words) = (Layout::ALONE, &words::words(language));
    let factor = match measures {
        Measures::Straight => 1.0,
        Measures::Translating | Measures::Oscillating => 30.0 / PI,
    };
    let shown = Shown {
        rows,
        factor,
        words,
    };
    layout.picture(language, |f| {
        f.title(name, &words.text("figure-speeds"))?;
        let has_factors = rows.iter().any(|r| r.load_factors.is_some());
        let used = [
            (Strip::Error, rows.iter().any(|r| r.rms_error.is_some())),
            (Strip::FirstFactor, has_factors),
            (Strip::HigherFactors, has_factors),
            (Strip::Torque, true),
            (Strip::Ripple, rows.iter().any(|r| r.ripple > 0.0)),
        ];
        let used: Vec<Strip> = used.iter().filter(|s| s.1).map(|s| s.0).collect();
        let shares: Vec<f64> = used.iter().map(|s| s.share()).collect();
        let frames = strips(force_frame(layout), &shares, 0.9 * f.e);
        let mut last = None;
        for (strip, frame) in used.iter().zip(frames) {
            last = Some(shown.strip(*strip, &f, frame)?);
        }
        if let Some(panel) = last {
            let straight = measures == Measures::Straight;
            let across = ["figure-cam-rpm", "figure-cam-travel"][usize::from(straight)];
            panel.across(&words.text(across))?;
        }
        shown.key(&f, &used)
    })
}

impl Strip {
    fn share(self) -> f64 {
        match self {
            Strip::FirstFactor | Strip::HigherFactors => 1.4,
            Strip::Error | Strip::Torque | Strip::Ripple => 1.0,
        }
    }

    fn quantity(self) -> &'static str {
        match self {
            Strip::Error => "figure-error-rms",
            Strip::FirstFactor => "figure-first-factor",
            Strip::HigherFactors => "figure-higher-factors",
            Strip::Torque => "figure-torque-largest",
            Strip::Ripple => "figure-ripple",
        }
    }
}

struct Shown<'a> {
    rows: &'a [AtSpeed],
    factor: f64,
    words: &'a Words,
}

impl Shown<'_> {
    fn curve(&self, of: impl Fn(&AtSpeed) -> Option<f64>) -> Vec<(f64, f64)> {
        let point = |r: &AtSpeed| (self.factor * r.speed, of(r).unwrap_or(f64::NAN));
        self.rows.iter().map(point).collect()
    }

    /// Curves of one diagram. The curves of the target come first, so that the other curves are drawn over them.
    fn curves(&self, strip: Strip) -> Vec<Curve> {
        let one = |of: &dyn Fn(&AtSpeed) -> Option<f64>| vec![(self.curve(of), BLUE, 2.2)];
        match strip {
            Strip::Error => one(&|r| r.rms_error),
            Strip::Torque => one(&|r| Some(r.torque)),
            Strip::Ripple => one(&|r| Some(100.0 * r.ripple)),
            Strip::FirstFactor => self.factors(0..1),
            Strip::HigherFactors => self.factors(1..4),
        }
    }

    /// Curves of the load factors at the given indices in [`AtSpeed::load_factors`], with those of the target first.
    fn factors(&self, indices: Range<usize>) -> Vec<Curve> {
        let target = |k: usize| self.curve(|r| r.target_factors.map(|f| f[k]));
        let own = |k: usize| self.curve(|r| r.load_factors.map(|f| f[k]));
        let targets = indices
            .clone()
            .map(|k| (target(k), COLOURS[k].mix(0.35), 7.0));
        let all = targets.chain(indices.map(|k| (own(k), COLOURS[k], 2.2)));
        all.collect()
    }

    fn strip<'a, 'c>(
        &self,
        strip: Strip,
        f: &Figure<'a, 'c>,
        frame: Frame,
    ) -> Drawn<Panel<'a, 'c>> {
        let curves = self.curves(strip);
        let ends = self.rows.first().zip(self.rows.last());
        let x = ends.map_or([0.0, 1.0], |(a, b)| {
            [a.speed, b.speed].map(|w| self.factor * w)
        });
        let values = curves.iter().flat_map(|c| &c.0).map(|p| p.1);
        let y = [0.0, padded(values.chain([0.0]), 0.12)[1]];
        let panel = f.panel(frame, x, ticks(x[0], x[1], 10.0), y)?;
        for [from, to] in self.lost() {
            let level = |v: f64| [(from, v), (to, v)];
            panel.band(&level(y[1]), &level(y[0]), RED.mix(0.14))?;
        }
        for (curve, colour, width) in &curves {
            panel.curve(curve, *colour, *width)?;
        }
        panel.quantity(&self.words.text(strip.quantity()))?;
        Ok(panel)
    }

    /// Ranges of the displayed speed in which contact is lost. Their ends are midway between simulated speeds.
    fn lost(&self) -> Vec<[f64; 2]> {
        let at = |i: usize| self.factor * self.rows[i].speed;
        let last = self.rows.len().saturating_sub(1);
        let lost = (0..=last).filter(|&i| self.rows.get(i).is_some_and(|r| r.contact_lost));
        lost.map(|i| {
            let [before, after] = [i.saturating_sub(1), (i + 1).min(last)];
            [0.5 * (at(before) + at(i)), 0.5 * (at(i) + at(after))]
        })
        .collect()
    }

    fn key(&self, f: &Figure, used: &[Strip]) -> Drawn {
        let mut entries = Vec::new();
        if used.contains(&Strip::FirstFactor) {
            if self.rows.iter().any(|r| r.target_factors.is_some()) {
                entries.push((QUIET.mix(0.4), 7.0, self.words.text("figure-target")));
            }
            for (k, colour) in COLOURS.into_iter().enumerate() {
                let number = (k + 1).to_string();
                let name = self.words.fill("figure-harmonic", &[("number", &number)]);
                entries.push((colour, 2.2, name));
            }
        }
        if self.rows.iter().any(|r| r.contact_lost) {
            entries.push((RED.mix(0.3), 8.0, self.words.text("figure-contact-lost")));
        }
        let entries: Vec<_> = entries.iter().map(|(c, w, n)| (*c, *w, &**n)).collect();
        let frame = force_frame(f.layout);
        f.key([frame.left, frame.top - 1.1 * f.e], f.e, &entries)
    }
}
