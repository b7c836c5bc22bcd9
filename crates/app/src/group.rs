//! Groups into which lists of files are divided.

/// Purpose of a file. Lists of files are grouped by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Tables of numbers, as CSV, JSON and workbooks.
    Tables,
    /// Drawings of the cam's outline at true scale.
    Drawings,
    /// Figures of the design, as SVG and PNG.
    Pictures,
    /// The HTML report of a design or a run.
    Report,
    /// Files for manufacturing: solids, workshop drawing, machine programs.
    Workshop,
}

impl Group {
    /// All groups, in the order of the lists.
    pub const ALL: [Group; 5] = [
        Group::Tables,
        Group::Drawings,
        Group::Pictures,
        Group::Report,
        Group::Workshop,
    ];

    /// Name of the group in JSON data.
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
