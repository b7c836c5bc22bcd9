//! Table of a recording: columns, stances, mean cycle, warnings.

use std::fmt::{Display, Write as _};

use serde_json::json;

use super::WORDS;
use gaitcam::force::{
    Contact, Cycle, Foot, ForceCurve, Format, Interpretation, Note, OpenQuestion, Point, Recording,
    Stances, Walk,
};
use gaitcam::units::G;
use gaitcam::wording::{Language, Messages};

/// Table of a recording as text. If there is no mean cycle, `cycle` is the text of the error, which may be empty. Stances and rejected
/// contacts are listed one by one if `all` is set, or if means of the feet cannot be computed.
pub fn table(
    understood: &Interpretation,
    recording: &Recording,
    stances: &Stances,
    cycle: Result<&Cycle, &str>,
    all: bool,
    language: Language,
) -> String {
    let mut out = Lines::new(language);
    let mut feet = Lines::new(language);
    if let Ok(cycle) = cycle {
        feet.feet(stances, cycle);
    }
    out.head(understood, recording);
    out.channels(recording, stances);
    if all || feet.text.is_empty() {
        out.stances(recording, stances);
        out.rejected(understood);
    } else {
        out.reasons(understood);
    }
    out.cycle(cycle);
    out.text += &feet.text;
    out.open_questions(understood);
    out.text
}

/// Table of a file that contains exactly one cycle, as text.
pub fn cycle_table(curve: &ForceCurve, language: Language) -> String {
    let mut out = Lines::new(language);
    let words = out.words;
    out.row("gait-format", words.text("gait-one-cycle"));
    out.period(curve.period_s, None);
    out.row("gait-samples", curve.force_n.len());
    let mean = words.fixed(curve.mean_n(), 1);
    match curve.mass_kg {
        Some(m) => {
            let ratio = words.fixed(curve.mean_n() / (m * G), 3);
            let m = words.fixed(m, 1);
            out.row("gait-mean", format_args!("{mean} N ({ratio} BW, {m} kg)"));
        }
        None => out.row("gait-mean", format_args!("{mean} N")),
    }
    if let Some(spread) = curve.spread_rms_n() {
        out.row("gait-spread", format_args!("{} N", words.fixed(spread, 1)));
    }
    out.notes("gait-note", &curve.notes);
    out.text.pop();
    out.text
}

/// Text of a table, to which lines are added.
pub(super) struct Lines {
    pub text: String,
    pub words: &'static Messages,
}

impl Lines {
    pub fn new(language: Language) -> Self {
        Lines {
            text: String::new(),
            words: WORDS.of(language),
        }
    }

    /// Writes a line without a label.
    pub fn line(&mut self, text: impl Display) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "{text}");
    }

    /// Writes a line that begins with a label. The label is padded to nine characters.
    pub fn row(&mut self, key: &str, text: impl Display) {
        let label = self.words.text(key);
        self.line(format_args!("{label:<9} {text}"));
    }

    fn head(&mut self, understood: &Interpretation, r: &Recording) {
        let words = self.words;
        self.row("gait-format", words.sentence("format", &r.format));
        let kind = understood.kind.map(|k| words.sentence("kind", &k));
        let unknown = || words.text("gait-kind-unknown");
        self.row("gait-kind", kind.unwrap_or_else(unknown));
        let clock = words.sentence("clock", &r.clock);
        let (rate, duration) = (words.fixed(r.rate_hz, 2), words.fixed(r.duration_s, 3));
        self.row(
            "gait-rate",
            format_args!("{rate} Hz ({clock}), {duration} s"),
        );
        let mass = understood.mass.map(|(kg, from)| {
            let from = words.sentence("mass-from", &from);
            let [kg, low, high] = match understood.mass_interval_kg {
                Some((low, high)) => [kg, low, high].map(|m| words.fixed(m, 1)),
                None => return format!("{} kg ({from})", words.fixed(kg, 1)),
            };
            format!("{kg} kg, 95 %: {low} … {high} kg ({from})")
        });
        let unknown = || words.text("gait-mass-unknown");
        self.row("gait-mass", mass.unwrap_or_else(unknown));
        self.notes("gait-note", &r.notes);
        self.line("");
    }

    pub fn notes(&mut self, key: &str, notes: &[Note]) {
        for note in notes {
            self.row(key, self.words.sentence("note", note));
        }
    }

    fn channels(&mut self, r: &Recording, stances: &Stances) {
        let words = self.words;
        let widest = r.channels.iter().map(|c| c.name.chars().count()).max();
        let wide = widest.unwrap_or(0).clamp(7, 40);
        let name = words.text("gait-channel");
        let columns = words.text("gait-channel-columns");
        self.line(format_args!("{name:<wide$}  {columns}"));
        for (i, c) in r.channels.iter().enumerate() {
            let used = stances.used.iter().filter(|s| s.channel == i).count();
            let rejected = stances.rejected.iter().filter(|s| s.channel == i).count();
            let name: String = c.name.chars().take(40).collect();
            let foot = self.foot(c.foot);
            let rest = match &c.idle {
                Some(why) => words.sentence("channel", why),
                None => {
                    let baseline = words.fixed(c.baseline_n, 1);
                    format!("{baseline:>10}  {used:>7}  {rejected:>8}")
                }
            };
            self.line(format_args!("{name:<wide$}  {foot:<9}  {rest}"));
        }
    }

    fn stances(&mut self, r: &Recording, stances: &Stances) {
        if stances.used.is_empty() {
            return;
        }
        self.line(format_args!("\n{}", self.words.text("gait-stance-columns")));
        for s in &stances.used {
            let foot = self.foot(s.foot);
            let [start, end] = [s.start_s, s.end_s].map(|t| self.words.fixed(r.start_s + t, 3));
            let [p1, valley, p2] = s.landmarks().map(|p| self.point(p));
            self.line(format_args!(
                "{foot:<9} {start:>8} {end:>8}  {p1}  {valley}  {p2}"
            ));
        }
    }

    fn rejected(&mut self, understood: &Interpretation) {
        let rejected = self.rejections(understood);
        if rejected.is_empty() {
            return;
        }
        self.line(format_args!("\n{}", self.words.text("gait-rejected")));
        for (c, reason) in rejected {
            let [from, to] = [c.from_s, c.to_s].map(|t| self.words.fixed(t, 3));
            self.line(format_args!("{from:>8} {to:>8}  {reason}"));
        }
    }

    /// Writes the reasons for rejection, each with the number of rejected contacts.
    fn reasons(&mut self, understood: &Interpretation) {
        let mut counts: Vec<(String, usize)> = Vec::new();
        for (_, reason) in self.rejections(understood) {
            match counts.iter_mut().find(|(known, _)| *known == reason) {
                Some((_, count)) => *count += 1,
                None => counts.push((reason, 1)),
            }
        }
        if counts.is_empty() {
            return;
        }
        self.line(format_args!("\n{}", self.words.text("gait-rejected")));
        for (reason, count) in counts {
            self.line(format_args!("{count:>8}  {reason}"));
        }
    }

    /// Rejected contacts, each with a text that contains its column and the reason for the rejection.
    fn rejections<'a>(&self, understood: &'a Interpretation) -> Vec<(&'a Contact, String)> {
        let sentence = |c: &'a Contact| {
            let column = understood.columns.get(c.column);
            let name = column.map_or("", |c| c.name.as_str());
            let reason = self.words.sentence("contact", &c.rejected?);
            Some((c, format!("{name}: {reason}")))
        };
        understood.contacts.iter().filter_map(sentence).collect()
    }

    fn cycle(&mut self, cycle: Result<&Cycle, &str>) {
        let words = self.words;
        self.line("");
        let c = match cycle {
            Ok(c) => c,
            Err("") => return self.line(words.text("gait-no-cycle")),
            Err(why) => return self.line(format_args!("{}: {why}", words.text("gait-no-cycle"))),
        };
        self.row("gait-cycle", words.sentence("cycle", &c.source));
        let period = c.period;
        match period.uncertainty_s() {
            // The period of a single step or stride is uncertain, so it is shown with two decimals.
            Some(error) => {
                let [period, error] = [period.seconds, error].map(|x| words.fixed(x, 2));
                self.row("gait-period", format_args!("{period} s ± {error} s"));
            }
            None => self.period(period.seconds, period.spread_s),
        }
        self.mean(&c.curve, c.mass_kg);
        self.notes("gait-warning", &c.notes);
        self.spread(&c.curve, c.repeatability_n, c.mass_kg);
        self.variability(c.curve.walk.as_ref());
    }

    /// Writes the variability of consecutive strides and, if the pace changes, a warning.
    fn variability(&mut self, walk: Option<&Walk>) {
        let Some(walk) = walk else {
            return;
        };
        let of = walk.variability();
        let percent = |x: f64| self.words.fixed(100.0 * x, 1);
        let label = json!({"variability": {
            "strides": of.strides, "runs": of.runs, "time": percent(of.step_time_cv), "amplitude": percent(of.amplitude_cv),
            "autocorrelation": self.words.fixed(of.autocorrelation, 2), "single": walk.is_one_foot,
        }});
        let text = self.words.sentence("gait", &label);
        self.row("gait-varies", text);
        if walk.changes_pace() {
            let label = json!({"pace": {"change": percent(of.drift)}});
            let text = self.words.sentence("gait", &label);
            self.row("gait-warning", text);
        }
    }

    /// Writes the open questions: first those that cannot be accepted, then the others with the options that answer them and the names
    /// under which the user can accept them.
    fn open_questions(&mut self, understood: &Interpretation) {
        let questions = understood.doubts();
        let (others, refused): (Vec<_>, Vec<_>) =
            questions.into_iter().partition(|q| q.is_acceptable());
        let list = |questions: &[OpenQuestion]| {
            let sentences = questions.iter().map(|q| self.words.sentence("open", q));
            sentences.collect::<Vec<_>>().join(", ")
        };
        let (refusal, question) = (list(&refused), list(&others));
        let unclipped = unclipped(understood);
        if !refused.is_empty() {
            let label = json!({"unacceptable": {"list": refusal, "others": unclipped}});
            let text = self.words.sentence("gait", &label);
            self.row("gait-doubt", text);
        }
        if !others.is_empty() && (refused.is_empty() || unclipped > 0) {
            let names = others.iter().map(|q| q.name()).collect::<Vec<_>>();
            let options = options(understood, &others);
            let label = json!({"doubts": {
                "list": question, "names": names.join(", "), "count": options.len(), "options": options.join(", "),
            }});
            let text = self.words.sentence("gait", &label);
            self.row("gait-doubt", text);
        }
    }

    fn point(&self, p: Option<Point>) -> String {
        p.map_or(format!("{:>6}  {:>5}", "-", "-"), |p| {
            let at = self.words.fixed(100.0 * p.at, 1);
            format!("{:>6.0}  {at:>5}", p.force_n)
        })
    }

    pub fn foot(&self, foot: Option<Foot>) -> String {
        foot.map_or("-".to_string(), |f| self.words.name(f.name()))
    }

    /// Writes the duration of a cycle, with its standard deviation over several cycles.
    pub fn period(&mut self, period_s: f64, spread_s: Option<f64>) {
        let period = self.words.fixed(period_s, 4);
        let spread =
            spread_s.map_or_else(String::new, |s| format!(" ± {} s", self.words.fixed(s, 4)));
        self.row("gait-period", format_args!("{period} s{spread}"));
    }

    /// Writes the mean force in newtons and in body weights.
    pub fn mean(&mut self, curve: &ForceCurve, mass_kg: f64) {
        let mean = curve.mean_n();
        let (newtons, share) = (
            self.words.fixed(mean, 1),
            self.words.fixed(mean / (mass_kg * G), 3),
        );
        self.row("gait-mean", format_args!("{newtons} N ({share} BW)"));
    }

    /// Writes the step-to-step standard deviation and the repeatability of the mean, if there are several cycles.
    pub fn spread(&mut self, curve: &ForceCurve, repeatability_n: Option<f64>, mass_kg: f64) {
        let (Some(spread), Some(repeat)) = (curve.spread_rms_n(), repeatability_n) else {
            return;
        };
        let percent = self.words.fixed(100.0 * spread / (mass_kg * G), 1);
        let [spread, repeat] = [spread, repeat].map(|x| self.words.fixed(x, 1));
        self.row("gait-spread", format_args!("{spread} N ({percent} % BW)"));
        self.row("gait-repeatability", format_args!("{repeat} N"));
    }
}

/// Names of the options that answer the questions, each once, without another file. A key of `gait` and an option of the command have
/// the same name.
fn options(understood: &Interpretation, questions: &[OpenQuestion]) -> Vec<&'static str> {
    let mut out = Vec::new();
    let notes = questions.iter().flat_map(|&q| understood.opened_by(q));
    for key in notes.flat_map(|note| note.settled_by()) {
        let name = key.trim_start_matches("gait.");
        if name != "file" && !out.contains(&name) {
            out.push(name);
        }
    }
    out
}

/// Number of loaded columns without clipped forces. The user can select these columns and thus exclude the clipped columns. The number is
/// zero for a C3D file, because a plate may be the sum of several channels.
fn unclipped(understood: &Interpretation) -> usize {
    if matches!(understood.format, Format::C3d { .. }) {
        return 0;
    }
    let notes = understood.opened_by(OpenQuestion::Clipped);
    let is_clipped = |name: &String| {
        let mut notes = notes.iter();
        notes.any(|n| matches!(n, Note::Clipped { column, .. } if column == name))
    };
    let live = understood.columns.iter().filter(|c| c.idle.is_none());
    live.filter(|c| !is_clipped(&c.name)).count()
}
