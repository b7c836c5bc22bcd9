//! Open questions that follow from the notes on a recording, and the keys with which a user answers them.

use super::{Note, OpenQuestion};

impl Note {
    /// The open question that follows from the note; `None` if no question follows from it.
    pub fn doubt(&self) -> Option<OpenQuestion> {
        Some(self.question()?.0)
    }

    /// The open questions that follow from several notes, without repetition.
    pub fn doubts(notes: &[Note]) -> Vec<OpenQuestion> {
        let mut all: Vec<OpenQuestion> = notes.iter().filter_map(Note::doubt).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The notes from which a question follows.
    pub fn opening(notes: &[Note], question: OpenQuestion) -> Vec<Note> {
        let opens = |n: &&Note| n.doubt() == Some(question);
        notes.iter().filter(opens).cloned().collect()
    }

    /// Scene keys, such as `gait.mass`, that answer the question of the note. The most likely key is the first.
    pub fn settled_by(&self) -> &'static [&'static str] {
        self.question().map_or(&[], |(_, keys)| keys)
    }

    fn question(&self) -> Option<(OpenQuestion, &'static [&'static str])> {
        use OpenQuestion::{Clipped, Clock, Kind, Mass};
        Some(match self {
            Note::KindDiffers { .. } => (Kind, &["gait.kind"]),
            Note::DutyImplausible { .. } => (Kind, &["gait.kind", "gait.rate"]),
            Note::CountOrMilliseconds { .. }
            | Note::DurationsLost { .. }
            | Note::RatesDiffer { .. } => (Clock, &["gait.rate"]),
            Note::StrideAssumed { .. } => (Clock, &["gait.mass", "gait.period", "gait.span"]),
            Note::StrideImplausible { .. } => (Clock, &["gait.rate", "gait.kind"]),
            Note::StrideVaries { .. } => (Clock, &["gait.file"]),
            // If less than two thirds of the stances have a common speed, the speed that the user needs is unknown.
            Note::SpeedChanges { used, stances, .. } if 3 * used < 2 * stances => {
                (Clock, &["gait.file"])
            }
            Note::Clipped { .. } => (Clipped, &["gait.file", "gait.force"]),
            Note::UnitUnconfirmed { .. } => (Mass, &["gait.unit", "gait.mass"]),
            Note::PeakImplausible { .. } => (Mass, &["gait.mass", "gait.unit", "gait.kind"]),
            Note::MeanForceNotWeight { .. } => (Mass, &["gait.mass", "gait.unit", "gait.feet"]),
            Note::MassImplausible { .. } => (Mass, &["gait.unit", "gait.feet"]),
            Note::StancesDiffer { .. } | Note::FewAlike { .. } => {
                (Mass, &["gait.force", "gait.feet"])
            }
            Note::LeftOpen { question } => (*question, &["gait.file"]),
            Note::InsoleMass { .. } | Note::UnloadedDiffers { .. } => (Mass, &["gait.mass"]),
            _ => return None,
        })
    }
}
