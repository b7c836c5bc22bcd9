//! Figure of the joint mean of several recordings.

use plotters_backend::text_anchor::{HPos, VPos};

use super::{closed, draw_cycle};
use crate::plot::layout::Layout;
use crate::plot::palette::QUIET;
use crate::plot::picture::Picture;
use crate::plot::sheet::Lettering;
use crate::words;
use gaitcam::force::JointMean;
use gaitcam::wording::{Language, catalogue};

/// Figure of a joint mean: the cycle of each recording as a thin line, the mean of all cycles, and a band of one standard deviation.
///
/// `files` contains the names of the recordings in the mean.
pub fn joint_mean(joint: &JointMean, files: &[&str], language: Language) -> Picture {
    let words = &words::words(language);
    let layout = Layout {
        size: (1200, 720),
        ..Layout::ALONE
    };
    layout.picture(language, |f| {
        let e = f.e;
        let count = files.len().to_string();
        let head = words.fill("figure-joint-mean", &[("count", &count)]);
        f.title(&head, &words.text("figure-vertical-force"))?;
        let mut frame = layout.frame();
        let fixed = |x: f64, decimals| catalogue(language).fixed(x, decimals);
        let facts = [
            ("cycles", &*joint.cycles.to_string()),
            ("seconds", &fixed(joint.curve.period_s, 3)),
            ("mass", &fixed(joint.mass_kg, 1)),
        ];
        let facts = words.fill("figure-joint-facts", &facts);
        let plain = Lettering::new(e, QUIET).anchored(HPos::Left, VPos::Top);
        f.write(&facts, [frame.left, frame.top], plain)?;
        frame.top += 4.0 * e;
        frame.right -= 3.2 * e;
        let period = joint.curve.period_s;
        let single = joint.trials_n.iter().map(|row| closed(row, period));
        let single: Vec<_> = single.collect();
        draw_cycle(&f, frame, &joint.curve, &single, words)
    })
}
