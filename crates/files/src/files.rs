//! The files of a design: one table of names and makers for the command, the Python package and the studio.

use std::cell::OnceCell;

use gaitcam::cam::Wall;
use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam_cad::ecam::{self, Dialect};
use gaitcam_cad::{cutter, drawing, dxf, gcode, solid, step, svg};
use gaitcam_output::{Picture, Timing, csv, plots, report, xlsx};

use crate::contents::{Contents, Remark};
pub use crate::group::Group;

/// Vertices of a solid's profile and of the polylines in the drawing with arcs.
const VERTICES: usize = 720;
/// Largest distance of the fitted arcs from the profile, m.
const ARCS: f64 = 1e-6;
/// Triangles of a groove's wall: along the groove for every turn, and through its depth.
const WALL: [usize; 2] = [720, 8];

/// Which designs have a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Of {
    /// Every design, infeasible ones too.
    All,
    /// Those that have a cam.
    Cams,
    /// All but barrels.
    Profiles,
    /// The same; offered for cams that turn alone, since no other is a plate.
    Plates,
    /// Conjugate pairs.
    Pairs,
    /// Barrels.
    Barrels,
    /// Those on a floor that moves.
    Floors,
    /// Those for several walkers.
    Populations,
}

/// What [`Contents`] must ask for to have a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum With {
    /// Nothing.
    Always,
    /// Pictures as PNG.
    Png,
    /// Solids.
    Solid,
    /// The radius of a cutter.
    Tool,
    /// The same; only while the cutter does not gouge.
    Program,
    /// The radius of a wire.
    Wire,
    /// An electronic cam for this controller.
    Ecam(Dialect),
    /// Nothing, but it is written last, by [`design::finish`](crate::design::finish).
    Finish,
}

/// What files are made from; each picture is drawn once for SVG and PNG.
pub struct Source<'a> {
    design: &'a Design,
    time: Timing,
    contents: &'a Contents,
    pictures: [OnceCell<Picture>; 5],
}

/// The bytes of a file, if it can be made, with remarks about it.
type Made = Result<(Option<Vec<u8>>, Vec<Remark>)>;

/// A file that a design may have.
#[derive(Debug, Clone, Copy)]
pub struct File {
    /// Its name.
    pub name: &'static str,
    /// What it is for.
    pub group: Group,
    of: Of,
    with: With,
    make: fn(&Source) -> Made,
}

const fn file(
    group: Group,
    name: &'static str,
    of: Of,
    with: With,
    make: fn(&Source) -> Made,
) -> File {
    File {
        name,
        group,
        of,
        with,
        make: if cfg!(feature = "makers") {
            make
        } else {
            |_| none()
        },
    }
}

/// An electronic cam: its maker is chosen by what it is written for.
const fn electronic_cam(dialect: Dialect) -> File {
    let with = With::Ecam(dialect);
    file(Group::Workshop, dialect.file(), Of::Cams, with, |_| none())
}

/// Every file that a design may have except its scene, in the order of writing.
pub const ALL: [File; 36] = {
    use Group::{Drawings, Pictures, Report, Tables, Workshop};
    use Of::{All, Barrels, Cams, Floors, Pairs, Plates, Populations, Profiles};
    use With::{Always, Finish, Png, Program, Solid, Tool, Wire};
    [
        file(Report, "report.html", All, Always, |s| {
            made(report::html(s.design, s.time, s.contents.language))
        }),
        file(Tables, "law.csv", Cams, Always, |s| {
            made(csv::law(s.design, s.contents.points))
        }),
        file(Tables, "profile.csv", Cams, Always, |s| {
            made(csv::profile(s.design, s.contents.points))
        }),
        file(Tables, "second_profile.csv", Pairs, Always, second_profile),
        file(Tables, "walkers.csv", Populations, Always, |s| {
            Ok((csv::walkers(s.design).map(String::into_bytes), Vec::new()))
        }),
        file(Tables, "floor.csv", Floors, Always, |s| {
            Ok((csv::floor(s.design).map(String::into_bytes), Vec::new()))
        }),
        // Made by [`design::summary`](crate::design::summary), which knows the scene.
        file(Tables, "summary.json", All, Finish, |_| none()),
        file(Drawings, "profile.dxf", Cams, Always, |s| {
            let c = s.contents;
            made(dxf::profile(s.design, c.points, c.drawn, c.curves, c.units))
        }),
        file(Drawings, "profile.svg", Cams, Always, |s| {
            made(svg::profile(s.design, s.contents.points))
        }),
        file(Pictures, "svaj.svg", Cams, Always, |s| made(s.svaj().svg())),
        file(Pictures, "svaj.png", Cams, Png, |s| made(s.svaj().png())),
        file(Pictures, "force.svg", Cams, Always, |s| {
            made(s.force().svg())
        }),
        file(Pictures, "force.png", Cams, Png, |s| made(s.force().png())),
        file(Pictures, "cam.svg", Cams, Always, |s| made(s.cam().svg())),
        file(Pictures, "cam.png", Cams, Png, |s| made(s.cam().png())),
        file(Pictures, "walkers.svg", Populations, Always, |s| {
            made(s.walkers().svg())
        }),
        file(Pictures, "walkers.png", Populations, Png, |s| {
            made(s.walkers().png())
        }),
        file(Pictures, "floor.svg", Floors, Always, |s| {
            made(s.floor().svg())
        }),
        file(Pictures, "floor.png", Floors, Png, |s| {
            made(s.floor().png())
        }),
        file(Workshop, "drawing.pdf", Cams, Solid, sheet),
        file(Workshop, "profile.stl", Plates, Solid, |s| {
            or_remark(solid::stl(s.design, s.plate()), Remark::NoSolid)
        }),
        file(Workshop, "profile.3mf", Plates, Solid, |s| {
            or_remark(solid::threemf(s.design, s.plate()), Remark::NoSolid)
        }),
        file(Workshop, "groove_upper.stl", Barrels, Solid, |s| {
            wall(s, Wall::Upper)
        }),
        file(Workshop, "groove_lower.stl", Barrels, Solid, |s| {
            wall(s, Wall::Lower)
        }),
        file(Workshop, "cam.step", Cams, Solid, |s| {
            or_remark(step::solid(s.design), Remark::NoStep)
        }),
        file(Workshop, "profile.xlsx", Cams, Solid, |s| {
            made(xlsx::workbook(s.design, s.time, s.contents.language)?)
        }),
        file(Drawings, "profile_arcs.dxf", Profiles, Solid, arcs),
        file(Workshop, "cutter.csv", Cams, Tool, |s| {
            let path = cutter::path(s.design, s.tool(), s.contents.points)?;
            let bytes = cutter::csv(&path).into_bytes();
            Ok((
                Some(bytes),
                path.gouges.into_iter().map(Remark::Gouge).collect(),
            ))
        }),
        file(Workshop, "cutter.nc", Cams, Program, |s| program(s, 0)),
        file(Workshop, "cutter_second.nc", Pairs, Program, |s| {
            program(s, 1)
        }),
        file(Workshop, "wire.nc", Cams, Wire, |s| {
            let radius = s.contents.wire.unwrap_or_default();
            or_remark(
                gcode::wire(s.design, radius, s.contents.units),
                Remark::NoProgram,
            )
        }),
        electronic_cam(Dialect::Codesys),
        electronic_cam(Dialect::Twincat),
        electronic_cam(Dialect::Segments),
        electronic_cam(Dialect::Rockwell),
        electronic_cam(Dialect::Csv),
    ]
};

fn made(bytes: impl Into<Vec<u8>>) -> Made {
    Ok((Some(bytes.into()), Vec::new()))
}

fn none() -> Made {
    Ok((None, Vec::new()))
}

fn or_remark(made: Result<impl Into<Vec<u8>>>, remark: fn(Error) -> Remark) -> Made {
    Ok(match made {
        Ok(bytes) => (Some(bytes.into()), Vec::new()),
        Err(fault) => (None, vec![remark(fault)]),
    })
}

fn second_profile(source: &Source) -> Made {
    match &source.design.conjugate {
        Some(pair) => made(csv::points(&pair.second_profile(source.contents.points))),
        None => none(),
    }
}

fn sheet(source: &Source) -> Made {
    let (design, contents) = (source.design, source.contents);
    let title = drawing::Title {
        units: contents.units,
        ..contents.title
    };
    let bytes = drawing::pdf(design, &title, contents.language);
    let lacks = design.making.balance && design.balance_holes().contains(&None);
    Ok((
        Some(bytes),
        lacks.then_some(Remark::NoBalanceHole).into_iter().collect(),
    ))
}

fn wall(source: &Source, wall: Wall) -> Made {
    match &source.design.groove {
        Some(groove) => made(solid::binary_stl(&solid::wall(
            groove, wall, WALL[0], WALL[1],
        ))?),
        None => none(),
    }
}

fn arcs(source: &Source) -> Made {
    let options = dxf::Options {
        points: VERTICES,
        version: dxf::Version::R2000,
        bore: source.design.bore,
        content: source.contents.drawn,
        units: source.contents.units,
    };
    Ok(match dxf::arcs(source.design, ARCS, options) {
        Some(drawing) => {
            let (arcs, deviation) = (drawing.arcs, drawing.deviation);
            (Some(drawing.bytes), vec![Remark::Arcs { arcs, deviation }])
        }
        None => (None, vec![Remark::NoArcs]),
    })
}

fn electronic(source: &Source, dialect: Dialect) -> Made {
    Ok(match ecam::make(source.design, dialect, None) {
        Ok(made) => {
            let text = made.text.clone().into_bytes();
            (Some(text), vec![Remark::Ecam(made)])
        }
        Err(fault) => (None, vec![Remark::NoEcam(fault)]),
    })
}

/// The program for the first or the second cam.
fn program(source: &Source, cam: usize) -> Made {
    let cut = gcode::Milling {
        tool: source.tool(),
        pass: source.contents.pass,
        units: source.contents.units,
    };
    match gcode::milling(source.design, &cut) {
        Ok(programs) => Ok((
            programs.into_iter().nth(cam).map(String::into_bytes),
            Vec::new(),
        )),
        Err(fault) => Ok((None, vec![Remark::NoProgram(fault)])),
    }
}

impl<'a> Source<'a> {
    /// A design, how long it took, and what its files are to contain.
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

    fn floor(&self) -> &Picture {
        self.pictures[3].get_or_init(|| plots::floor(self.design, self.contents.language))
    }

    fn plate(&self) -> solid::Plate {
        solid::Plate {
            thickness: self.design.thickness,
            bore: self.design.bore,
            points: VERTICES,
        }
    }

    fn tool(&self) -> f64 {
        let own = self.contents.tool;
        own.unwrap_or_else(|| usual_cutter(self.design))
    }
}

impl File {
    /// Its bytes, where it can be made, and remarks about it.
    ///
    /// # Errors
    /// A cutter that has no path; a workbook or mesh that cannot be put together.
    pub fn make(&self, source: &Source) -> Made {
        match self.with {
            With::Ecam(dialect) => electronic(source, dialect),
            _ => (self.make)(source),
        }
    }

    fn suits(&self, design: &Design) -> bool {
        let cam = design.infeasible.is_none();
        let barrel = design.groove.is_some();
        match self.of {
            Of::All => true,
            Of::Cams => cam,
            Of::Profiles | Of::Plates => cam && !barrel,
            Of::Pairs => cam && design.conjugate.is_some(),
            Of::Barrels => cam && barrel,
            Of::Floors => cam && design.floor.is_some(),
            Of::Populations => cam && design.population.is_some(),
        }
    }

    fn is_asked(&self, contents: &Contents) -> bool {
        match self.with {
            With::Always => true,
            With::Png => contents.png,
            With::Solid => contents.solid,
            With::Tool | With::Program => contents.tool.is_some(),
            With::Wire => contents.wire.is_some(),
            With::Ecam(dialect) => contents.ecam == Some(dialect),
            With::Finish => false,
        }
    }
}

/// The files that a design has by its kind, but those for a wire, whose radius only the user knows.
pub fn of(design: &Design) -> impl Iterator<Item = &'static File> {
    let is_plate = !design.cam.follower.is_unrolled();
    let offered = move |f: &&File| f.with != With::Wire && (f.of != Of::Plates || is_plate);
    ALL.iter().filter(offered).filter(|file| file.suits(design))
}

/// Makes the files that are asked for and gives each to `put`; returns remarks on them.
///
/// # Errors
/// Files that cannot be written; a cutter that has no path.
pub fn write(
    source: &Source,
    mut put: impl FnMut(&str, &[u8]) -> Result<()>,
) -> Result<Vec<Remark>> {
    let mut remarks: Vec<Remark> = Vec::new();
    let asked = |file: &&File| file.suits(source.design) && file.is_asked(source.contents);
    for file in ALL.iter().filter(asked) {
        let refused = |r: &Remark| matches!(r, Remark::Gouge(_) | Remark::NoProgram(_));
        if file.with == With::Program && remarks.iter().any(refused) {
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

/// Radius of the cutter that a path is made for unless the user gives another, m: that of a barrel's roller, otherwise
/// 3 mm.
pub fn usual_cutter(design: &Design) -> f64 {
    let roller = design.groove.as_ref().map(|groove| groove.roller_radius());
    roller.unwrap_or(0.003)
}
