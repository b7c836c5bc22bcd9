//! Groups in which the files of a design are listed.

/// What a file is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Numbers.
    Tables,
    /// The cam at true scale.
    Drawings,
    /// Pictures.
    Pictures,
    /// The report.
    Report,
    /// Solids, workshop drawing, programs for machines.
    Workshop,
}

impl Group {
    /// Every group, in the order in which they are listed.
    pub const ALL: [Group; 5] = [
        Group::Tables,
        Group::Drawings,
        Group::Pictures,
        Group::Report,
        Group::Workshop,
    ];

    /// Its name in data.
    pub fn name(self) -> &'static str {
        match self {
            Group::Tables => "tables",
            Group::Drawings => "drawings",
            Group::Pictures => "pictures",
            Group::Report => "report",
            Group::Workshop => "workshop",
        }
    }
}
