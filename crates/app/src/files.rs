//! Files of a design. One table contains their names and the functions that make them. The command, the Python package and the studio use
//! this table.

use std::cell::OnceCell;

use gaitcam::cam::Wall;
use gaitcam::error::Result;
use gaitcam::synth::Design;
use gaitcam_output::{Picture, Timing, csv, plots, report};

use crate::contents::Contents;
pub use crate::group::Group;
use crate::workshop::Piece;
pub use crate::workshop::usual_cutter;
use crate::workshop::{Exported, Remark};

/// Kind of design for which a file exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Of {
    /// All designs, including infeasible ones.
    All,
    /// Designs with a cam.
    Cams,
    /// Designs with a rotating disc cam, but not with a translating or barrel cam.
    Discs,
    /// All cams except barrel cams.
    Profiles,
    /// All cams except barrel cams. The list of available files omits these files for a translating cam, which is not a plate.
    Plates,
    /// Designs with a conjugate pair of cams.
    Pairs,
    /// Designs with a cylindrical (barrel) cam.
    Barrels,
    /// Designs for a moving floor.
    Floors,
    /// Designs for a population of walkers.
    Populations,
    /// Designs for a recording of eight or more consecutive strides.
    Walks,
}

/// Condition under which a file is written, and the function that makes it.
#[derive(Debug, Clone, Copy)]
enum Maker {
    /// The file is always written.
    Always(fn(&Source) -> Exported),
    /// The file is a figure in PNG format. It is written if [`Contents`] requests PNG.
    Png(fn(&Source) -> Exported),
    /// The file is for CAD or manufacturing. It is written if an option in [`Contents`] requests it.
    Workshop(Piece),
    /// The file is always written, after all others, by [`design::finish`](crate::design::finish).
    Finish,
}

/// Data from which the files are made. Each figure is drawn only once and is used for both SVG and PNG.
pub struct Source<'a> {
    design: &'a Design,
    time: Timing,
    contents: &'a Contents,
    pictures: [OnceCell<Picture>; 6],
}

/// File that a design may have.
#[derive(Debug, Clone, Copy)]
pub struct File {
    /// Name of the file in the result folder.
    pub name: &'static str,
    /// Purpose of the file. Lists of files are grouped by it.
    pub group: Group,
    of: Of,
    maker: Maker,
}

const fn file(group: Group, name: &'static str, of: Of, maker: Maker) -> File {
    let maker = match maker {
        Maker::Always(_) if !cfg!(feature = "cad") => Maker::Always(|_| none()),
        Maker::Png(_) if !cfg!(feature = "cad") => Maker::Png(|_| none()),
        maker => maker,
    };
    File {
        group,
        name,
        of,
        maker,
    }
}

const fn piece(group: Group, name: &'static str, of: Of, piece: Piece) -> File {
    file(group, name, of, Maker::Workshop(piece))
}

/// All files that a design may have, in the order in which they are written. The scene is not included.
pub const ALL: [File; 38] = {
    use Group::{Drawings, Pictures, Report, Tables, Workshop};
    use Maker::{Always, Finish, Png};
    use Of::{All, Barrels, Cams, Discs, Floors, Pairs, Plates, Populations, Profiles, Walks};
    [
        file(
            Report,
            "report.html",
            All,
            Always(|s| made(report::html(s.design, s.time, s.contents.language))),
        ),
        file(
            Tables,
            "law.csv",
            Cams,
            Always(|s| made(csv::law(s.design, s.contents.points))),
        ),
        file(
            Tables,
            "profile.csv",
            Cams,
            Always(|s| made(csv::profile(s.design, s.contents.points))),
        ),
        file(Tables, "second_profile.csv", Pairs, Always(second_profile)),
        file(
            Tables,
            "walkers.csv",
            Populations,
            Always(|s| {
                Ok((
                    csv::walkers(s.design).map(|t| t.csv().into_bytes()),
                    Vec::new(),
                ))
            }),
        ),
        file(
            Tables,
            "floor.csv",
            Floors,
            Always(|s| Ok((csv::floor(s.design).map(String::into_bytes), Vec::new()))),
        ),
        file(
            Tables,
            "strides.csv",
            Walks,
            Always(|s| Ok((csv::strides(s.design).map(String::into_bytes), Vec::new()))),
        ),
        // [`design::summary`](crate::design::summary) makes this file, because it also requires the scene.
        file(Tables, "summary.json", All, Finish),
        piece(Drawings, "profile.dxf", Cams, Piece::Dxf),
        piece(Drawings, "profile.svg", Cams, Piece::Svg),
        file(Pictures, "svaj.svg", Cams, Always(|s| made(s.svaj().svg()))),
        file(Pictures, "svaj.png", Cams, Png(|s| made(s.svaj().png()))),
        file(
            Pictures,
            "force.svg",
            Cams,
            Always(|s| made(s.force().svg())),
        ),
        file(Pictures, "force.png", Cams, Png(|s| made(s.force().png()))),
        file(Pictures, "cam.svg", Cams, Always(|s| made(s.cam().svg()))),
        file(Pictures, "cam.png", Cams, Png(|s| made(s.cam().png()))),
        file(
            Pictures,
            "walkers.svg",
            Populations,
            Always(|s| made(s.walkers().svg())),
        ),
        file(
            Pictures,
            "walkers.png",
            Populations,
            Png(|s| made(s.walkers().png())),
        ),
        file(
            Pictures,
            "floor.svg",
            Floors,
            Always(|s| made(s.floor().svg())),
        ),
        file(
            Pictures,
            "floor.png",
            Floors,
            Png(|s| made(s.floor().png())),
        ),
        file(
            Pictures,
            "resonance.svg",
            Walks,
            Always(|s| made(s.resonance().svg())),
        ),
        file(
            Pictures,
            "resonance.png",
            Walks,
            Png(|s| made(s.resonance().png())),
        ),
        piece(Workshop, "drawing.pdf", Discs, Piece::Sheet),
        piece(Workshop, "profile.stl", Plates, Piece::Stl),
        piece(Workshop, "profile.3mf", Plates, Piece::ThreeMf),
        piece(
            Workshop,
            "groove_upper.stl",
            Barrels,
            Piece::Wall(Wall::Upper),
        ),
        piece(
            Workshop,
            "groove_lower.stl",
            Barrels,
            Piece::Wall(Wall::Lower),
        ),
        piece(Workshop, "cam.step", Profiles, Piece::Step),
        piece(Workshop, "profile.xlsx", Cams, Piece::Workbook),
        piece(Workshop, "cutter.csv", Cams, Piece::Cutter),
        piece(Workshop, "cutter.nc", Cams, Piece::Program(0)),
        piece(Workshop, "cutter_second.nc", Pairs, Piece::Program(1)),
        piece(Workshop, "wire.nc", Cams, Piece::Wire),
        piece(Workshop, "ecam_codesys.st", Cams, Piece::Ecam(0)),
        piece(Workshop, "ecam_twincat.st", Cams, Piece::Ecam(1)),
        piece(Workshop, "ecam_segments.csv", Cams, Piece::Ecam(2)),
        piece(Workshop, "ecam_rockwell.st", Cams, Piece::Ecam(3)),
        piece(Workshop, "ecam_csv.csv", Cams, Piece::Ecam(4)),
    ]
};

fn made(bytes: impl Into<Vec<u8>>) -> Exported {
    Ok((Some(bytes.into()), Vec::new()))
}

fn none() -> Exported {
    Ok((None, Vec::new()))
}

fn second_profile(source: &Source) -> Exported {
    match &source.design.conjugate {
        Some(pair) => made(csv::points(&pair.second_profile(source.contents.points))),
        None => none(),
    }
}

impl<'a> Source<'a> {
    /// Creates the source from a design, its computing time, and the options of its files.
    pub fn new(design: &'a Design, time: Timing, contents: &'a Contents) -> Self {
        Source {
            design,
            time,
            contents,
            pictures: Default::default(),
        }
    }

    fn svaj(&self) -> &Picture {
        self.pictures[0].get_or_init(|| plots::svaj(self.design, self.contents.language))
    }

    fn force(&self) -> &Picture {
        self.pictures[1].get_or_init(|| plots::force(self.design, self.contents.language))
    }

    fn cam(&self) -> &Picture {
        self.pictures[2].get_or_init(|| plots::cam(self.design, self.contents.language))
    }

    fn walkers(&self) -> &Picture {
        self.pictures[4].get_or_init(|| plots::walkers(self.design, self.contents.language))
    }

    fn resonance(&self) -> &Picture {
        self.pictures[5].get_or_init(|| plots::resonance(self.design, self.contents.language))
    }

    fn floor(&self) -> &Picture {
        self.pictures[3].get_or_init(|| plots::floor(self.design, self.contents.language))
    }
}

impl File {
    /// Makes the content of the file and remarks on the file. The content is `None` if the file cannot be made.
    ///
    /// # Errors
    ///
    /// The cutter has no path, or a workbook or mesh cannot be assembled.
    pub fn make(&self, source: &Source) -> Exported {
        match self.maker {
            Maker::Always(make) | Maker::Png(make) => make(source),
            Maker::Workshop(piece) => {
                let c = source.contents;
                (c.workshop).make(piece, source.design, source.time, c.points, c.language)
            }
            Maker::Finish => none(),
        }
    }

    fn is(&self, other: Piece) -> bool {
        matches!(self.maker, Maker::Workshop(piece) if piece == other)
    }

    fn suits(&self, design: &Design) -> bool {
        let cam = design.infeasible.is_none();
        let barrel = design.groove.is_some();
        match self.of {
            Of::All => true,
            Of::Cams => cam,
            Of::Profiles | Of::Plates => cam && !barrel,
            Of::Discs => cam && !design.cam.follower.is_unrolled(),
            Of::Pairs => cam && design.conjugate.is_some(),
            Of::Barrels => cam && barrel,
            Of::Floors => cam && design.floor.is_some(),
            Of::Populations => cam && design.population.is_some(),
            Of::Walks => design.walk().is_some(),
        }
    }

    fn is_asked(&self, contents: &Contents) -> bool {
        match self.maker {
            Maker::Always(_) => true,
            Maker::Png(_) => contents.png,
            Maker::Workshop(piece) => contents.workshop.asks(piece),
            Maker::Finish => false,
        }
    }
}

/// Files that can be made for this design. The program for wire cutting is not included, because the user must give the radius of the wire.
pub fn of(design: &Design) -> impl Iterator<Item = &'static File> {
    let is_plate = !design.cam.follower.is_unrolled();
    let offered = move |f: &&File| !f.is(Piece::Wire) && (f.of != Of::Plates || is_plate);
    ALL.iter().filter(offered).filter(|file| file.suits(design))
}

/// Makes the requested files and passes the name and content of each to `put`. Returns remarks on the files.
///
/// # Errors
///
/// A file cannot be written, or the cutter has no path.
pub fn write(
    source: &Source,
    mut put: impl FnMut(&str, &[u8]) -> Result<()>,
) -> Result<Vec<Remark>> {
    let mut remarks: Vec<Remark> = Vec::new();
    let asked = |file: &&File| file.suits(source.design) && file.is_asked(source.contents);
    for file in ALL.iter().filter(asked) {
        let program = matches!(file.maker, Maker::Workshop(Piece::Program(_)));
        if program && remarks.iter().any(Remark::forbids_program) {
            continue;
        }
        let (bytes, own) = file.make(source)?;
        if let Some(bytes) = bytes {
            put(file.name, &bytes)?;
        }
        for remark in own {
            if !remarks.contains(&remark) {
                remarks.push(remark);
            }
        }
    }
    Ok(remarks)
}
