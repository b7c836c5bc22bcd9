//! Recordings with known true values: movements, plates, misleading data and layouts, each determined by a seed.

mod contacts;
mod files;
mod movements;
mod readings;
mod walking;

use contacts::{cross_overs, cross_talk, heel_and_toe, partial, two_steps};
use files::{anc, asc, c3d, components, forces, open_sim, plates_in_a_row};
use movements::{bending, hopping, jumping, rising, running, running_asked, standing};
use readings::{
    clock_units, columns_twice, coupled_plates, drop_outs, hum, landing, loadsol, odd_numbers,
    one_stride, per_kilogram, spikes, visual3d, words_for_unloaded,
};
use walking::{
    changing_speed, children, counting, limping, milliseconds, one_foot, slow, total, units,
};

use std::fmt::Write as _;

use gaitcam_gait::units::{G, LBF};
use gaitcam_gait::{Feet, ForceUnit, Kind, ReadOptions};

use super::dice::Dice;
use super::layout::{Clock, Plate, Table};
use super::person::{
    Person, changing, child, hopper, jumper, limper, riser, runner, slow_walker, squatter, stander,
    walker,
};
use crate::c3d_file::{Build, Processor, build};

/// Values that a reader should find.
#[derive(Debug, Clone)]
pub struct Truth {
    /// Kind of movement of the cycle.
    pub kind: Kind,
    /// Permitted durations of a stride, s.
    pub strides: Vec<f64>,
    /// Mass, kg, if the plates (or the options) determine it.
    pub mass: Option<f64>,
}

/// A generated recording with its true values.
pub struct Case {
    pub name: &'static str,
    pub file: &'static str,
    pub bytes: Vec<u8>,
    pub options: ReadOptions,
    pub feet: Feet,
    pub truth: Truth,
    /// Whether the recording is unambiguous: it should be read without open questions.
    pub plain: bool,
}

/// Name of a family of cases, number of cases, and function that generates one.
pub type Family = (&'static str, usize, fn(&mut Dice) -> Case);

/// All families of cases, with the number of seeds of each.
pub const FAMILIES: &[Family] = &[
    ("two belts or insoles", 260, two_belts),
    ("plates in a row", 260, plates_in_a_row),
    ("OpenSim, old and new header", 120, open_sim),
    (".forces", 80, forces),
    (".asc", 60, asc),
    (".anc", 60, anc),
    ("C3D with either header", 60, c3d),
    ("words for unloaded", 60, words_for_unloaded),
    ("spikes", 60, spikes),
    ("hum", 40, hum),
    ("coupled plates", 40, coupled_plates),
    ("columns twice", 40, columns_twice),
    ("odd numbers", 40, odd_numbers),
    ("loadsol", 40, loadsol),
    ("Visual3D with blanks", 40, visual3d),
    ("one stride of unlike feet", 60, one_stride),
    ("landing on one leg", 60, landing),
    ("lost packets", 40, drop_outs),
    ("N/kg under N", 20, per_kilogram),
    ("clocks that start far from zero", 40, clock_units),
    ("components beside the vertical", 100, components),
    ("one foot", 100, one_foot),
    ("total of both feet", 100, total),
    ("children", 80, children),
    ("limping", 60, limping),
    ("very slow steps", 60, slow),
    ("changing speed", 80, changing_speed),
    ("time column that counts samples", 120, counting),
    ("time column in milliseconds", 80, milliseconds),
    ("unit not given or wrong", 160, units),
    ("cross-talk", 120, cross_talk),
    ("partial contacts", 120, partial),
    ("heel on one plate, toe on the next", 80, heel_and_toe),
    ("two steps on one plate", 80, two_steps),
    ("cross-overs on belts", 80, cross_overs),
    ("running", 120, running),
    ("running asked for", 80, running_asked),
    ("standing", 80, standing),
    ("jumping", 80, jumping),
    ("hopping", 60, hopping),
    ("rising from a chair", 80, rising),
    ("bending the knees", 60, bending),
];

fn seconds_clock(dice: &mut Dice) -> Clock {
    Clock::Seconds {
        from: dice.of(&[0.0, 0.0, 12.5, 534.13]),
        decimals: dice.of(&[3, 4, 6]),
    }
}

fn truth(person: &Person) -> Truth {
    Truth {
        kind: person.kind,
        strides: person.strides.clone(),
        mass: Some(person.mass),
    }
}

fn case(name: &'static str, text: String, truth: Truth, plain: bool) -> Case {
    Case {
        name,
        file: "made.csv",
        bytes: text.into_bytes(),
        options: ReadOptions::default(),
        feet: Feet::Both,
        truth,
        plain,
    }
}

/// A person whose recording begins and ends next to the plates or on them.
fn some_walker(dice: &mut Dice) -> Person {
    let seconds = dice.between(5.0, 9.0);
    walker(dice, seconds)
}

/// Left and right columns of a person.
fn sides(dice: &mut Dice, person: &Person, plate: &Plate, names: [&str; 2]) -> Table {
    let of = |dice: &mut Dice, left: bool| {
        plate.samples(dice, person.seconds, |t| {
            person.feet(t, |_, s| s.left == left)
        })
    };
    let columns = vec![of(dice, true), of(dice, false)];
    Table {
        rate_hz: plate.rate_hz,
        names: names.map(str::to_string).to_vec(),
        columns,
    }
}

const SIDES: [[&str; 2]; 5] = [
    ["left fz", "right fz"],
    ["LFz (N)", "RFz (N)"],
    ["Left Fz [N]", "Right Fz [N]"],
    ["Kraft links [N]", "Kraft rechts [N]"],
    ["L_vGRF", "R_vGRF"],
];

fn two_belts(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::of(dice);
    let names = dice.of(&SIDES);
    let table = sides(dice, &person, &plate, names);
    let comma = dice.chance(25.0);
    let text = table.delimited(seconds_clock(dice), comma);
    case("two belts or insoles", text, truth(&person), true)
}

/// Several consecutive contacts, each on a separate plate; all others are next to the plates.
fn row_of_plates(
    dice: &mut Dice,
    person: &Person,
    plate: &Plate,
    first: usize,
    count: usize,
) -> Table {
    let from = person.steps[first].at - 0.4;
    let until = person.steps[first + count - 1].at + person.steps[first + count - 1].lasts + 0.4;
    let columns = (0..count)
        .map(|k| {
            plate.samples(dice, until - from, |t| {
                person.feet(t + from, |i, _| i == first + k)
            })
        })
        .collect();
    Table {
        rate_hz: plate.rate_hz,
        names: (1..=count).map(|k| format!("Fz{k}")).collect(),
        columns,
    }
}

/// Permitted strides of a row of contacts: their mean, the stride of each foot, and each step doubled, because only two contacts may be usable.
fn row_truth(person: &Person, first: usize, count: usize) -> Truth {
    let at = |i: usize| person.steps[i].at;
    let strides: Vec<f64> = (first..first + count.saturating_sub(2))
        .map(|i| at(i + 2) - at(i))
        .collect();
    let steps = (first..first + count - 1).map(|i| 2.0 * (at(i + 1) - at(i)));
    let mean = strides.iter().sum::<f64>() / strides.len() as f64;
    let all: Vec<f64> = std::iter::once(mean)
        .chain(strides.iter().copied())
        .chain(steps)
        .filter(|s| s.is_finite())
        .collect();
    Truth {
        strides: all,
        ..truth(person)
    }
}
