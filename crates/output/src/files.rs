//! The files of a design by name: one list for the command, the Python package and the studio.

use gaitcam::synth::Design;

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
    /// What a workshop takes.
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

/// Which designs have a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Of {
    /// Every design, those that cannot be met too.
    All,
    /// Those that have a cam.
    Cams,
    /// All but barrels.
    Profiles,
    /// Cams that turn, but barrels.
    Discs,
    /// Conjugate pairs.
    Pairs,
    /// Barrels.
    Barrels,
    /// Cams but barrels for which a wire is given.
    Wires,
}

/// A file that a design may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct File {
    /// Its name.
    pub name: &'static str,
    /// What it is for.
    pub group: Group,
    of: Of,
}

const fn file(group: Group, name: &'static str, of: Of) -> File {
    File { name, group, of }
}

/// Every file that a design may have beside its scene.
pub const ALL: [File; 25] = [
    file(Group::Tables, "law.csv", Of::Cams),
    file(Group::Tables, "profile.csv", Of::Cams),
    file(Group::Tables, "second_profile.csv", Of::Pairs),
    file(Group::Tables, "summary.json", Of::All),
    file(Group::Drawings, "profile.dxf", Of::Cams),
    file(Group::Drawings, "profile_arcs.dxf", Of::Profiles),
    file(Group::Drawings, "profile.svg", Of::Cams),
    file(Group::Pictures, "cam.svg", Of::Cams),
    file(Group::Pictures, "cam.png", Of::Cams),
    file(Group::Pictures, "force.svg", Of::Cams),
    file(Group::Pictures, "force.png", Of::Cams),
    file(Group::Pictures, "svaj.svg", Of::Cams),
    file(Group::Pictures, "svaj.png", Of::Cams),
    file(Group::Report, "report.html", Of::All),
    file(Group::Workshop, "drawing.pdf", Of::Cams),
    file(Group::Workshop, "cam.step", Of::Cams),
    file(Group::Workshop, "profile.stl", Of::Discs),
    file(Group::Workshop, "profile.3mf", Of::Discs),
    file(Group::Workshop, "profile.xlsx", Of::Cams),
    file(Group::Workshop, "groove_upper.stl", Of::Barrels),
    file(Group::Workshop, "groove_lower.stl", Of::Barrels),
    file(Group::Workshop, "cutter.csv", Of::Cams),
    file(Group::Workshop, "cutter.nc", Of::Cams),
    file(Group::Workshop, "cutter_second.nc", Of::Pairs),
    file(Group::Workshop, "wire.nc", Of::Wires),
];

/// The files that a design has by its kind, but those for a wire, whose radius only the user knows.
pub fn of(design: &Design) -> impl Iterator<Item = &'static File> {
    let cam = design.infeasible.is_none();
    let barrel = design.groove.is_some();
    let disc = !design.cam.follower.is_unrolled();
    let pair = design.conjugate.is_some();
    ALL.iter().filter(move |file| match file.of {
        Of::All => true,
        Of::Cams => cam,
        Of::Profiles => cam && !barrel,
        Of::Discs => cam && disc,
        Of::Pairs => cam && pair,
        Of::Barrels => cam && barrel,
        Of::Wires => false,
    })
}

/// Radius of the cutter that a path is made for where nobody says another, m: that of a barrel's roller, otherwise
/// 3 mm.
pub fn usual_cutter(design: &Design) -> f64 {
    let roller = design.groove.as_ref().map(|groove| groove.roller_radius());
    roller.unwrap_or(0.003)
}
