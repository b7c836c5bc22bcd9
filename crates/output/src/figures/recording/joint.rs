//! The joint mean of several recordings: the cycle of each, their mean and its band.

use plotters_backend::text_anchor::{HPos, VPos};

use super::{draw_cycle, thinned};
use crate::plot::layout::{Layout, title};
use crate::plot::palette::QUIET;
use crate::plot::picture::Picture;
use crate::plot::sheet::{Lettering, write};
use crate::words;
use gaitcam::force::JointMean;
use gaitcam::wording::{Language, catalogue};

/// The cycles of the recordings of a joint mean, thin, with the mean and one standard deviation of all cycles.
///
/// `files`: names of the recordings in the mean.
pub fn joint_mean(joint: &JointMean, files: &[&str], language: Language) -> Picture {
    let words = &words::words(language);
    let layout = Layout {
        size: (1200, 720),
        ..Layout::ALONE
    };
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let e = layout.letters;
        let count = files.len().to_string();
        let head = words.fill("figure-joint-mean", &[("count", &count)]);
        title(canvas, layout, &head, &words.text("figure-vertical-force"))?;
        let mut frame = layout.frame();
        let facts = words.fill(
            "figure-joint-facts",
            &[
                ("cycles", joint.cycles.to_string().as_str()),
                (
                    "seconds",
                    &catalogue(language).fixed(joint.curve.period_s, 3),
                ),
                ("mass", &catalogue(language).fixed(joint.mass_kg, 1)),
            ],
        );
        let plain = Lettering::new(e, QUIET).anchored(HPos::Left, VPos::Top);
        write(canvas, &facts, [frame.left, frame.top], plain)?;
        frame.top += 4.0 * e;
        frame.right -= 3.2 * e;
        let single: Vec<_> = joint
            .trials_n
            .iter()
            .map(|row| {
                let closed: Vec<f64> = row.iter().chain(row.first()).copied().collect();
                let period = joint.curve.period_s;
                thinned(&closed, |i, n| period * i as f64 / (n - 1) as f64)
            })
            .collect();
        draw_cycle(canvas, frame, &joint.curve, &single, e, words)
    })
    .in_language(words.language())
}
