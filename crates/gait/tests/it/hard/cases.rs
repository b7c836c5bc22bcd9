//! Recordings with a known truth: movements, plates, traps and layouts, one of each by its seed.

use gaitcam_gait::units::{G, LBF};
use gaitcam_gait::{Feet, ForceUnit, Kind, ReadOptions};

use super::dice::Dice;
use super::layout::{Clock, Plate, Table};
use super::person::{
    Person, changing, child, hopper, jumper, limper, riser, runner, slow_walker, squatter, stander,
    walker,
};
use crate::c3d_file::{Build, Processor, build};

/// What a reader should find.
#[derive(Debug, Clone)]
pub struct Truth {
    /// The kind of movement that a cycle may be made of.
    pub kind: Kind,
    /// Right durations of a stride, s.
    pub strides: Vec<f64>,
    /// Mass, kg, where the plates (or the options) give it.
    pub mass: Option<f64>,
}

/// One recording.
pub struct Case {
    pub name: &'static str,
    pub file: &'static str,
    pub bytes: Vec<u8>,
    pub options: ReadOptions,
    pub feet: Feet,
    pub truth: Truth,
    /// Nothing about it is ambiguous: it should be read, not questioned.
    pub plain: bool,
}

/// Name of a family of cases, how many are drawn, and how one is.
pub type Family = (&'static str, usize, fn(&mut Dice) -> Case);

/// Every family of cases with how many seeds it gets.
pub const FAMILIES: &[Family] = &[
    ("two belts or insoles", 260, two_belts),
    ("plates in a row", 260, plates_in_a_row),
    ("OpenSim, old and new header", 120, open_sim),
    (".forces", 80, forces),
    (".asc", 60, asc),
    (".anc", 60, anc),
    ("C3D with either header", 60, c3d),
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

/// A person whose recording begins and ends beside the plates or on them.
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

/// Each contact of some neighbours on a plate of its own; all others beside the plates.
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

/// The strides that a row of contacts shows: their mean, each foot's own, and each step doubled, since the contacts
/// that can be used may be two.
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

fn plates_in_a_row(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = if dice.chance(30.0) {
        Plate::thresholded(dice)
    } else {
        Plate::of(dice)
    };
    let count = dice.of(&[2, 2, 3, 4, 5]);
    let table = row_of_plates(dice, &person, &plate, 2, count);
    let text = table.delimited(seconds_clock(dice), dice.chance(20.0));
    case("plates in a row", text, row_truth(&person, 2, count), true)
}

fn open_sim(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::thresholded(dice);
    let names = dice.of(&[
        ["l_ground_force", "r_ground_force"],
        ["1_ground_force", "ground_force"],
        ["ground_force_l", "ground_force_r"],
        ["L_ground_force", "R_ground_force"],
    ]);
    let table = sides(dice, &person, &plate, names);
    let text = table.open_sim(dice.chance(50.0));
    Case {
        file: "made.mot",
        ..case("OpenSim, old and new header", text, truth(&person), true)
    }
}

fn forces(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate {
        sign: 1.0,
        ..Plate::of(dice)
    };
    let count = dice.of(&[3, 4, 5]);
    let table = row_of_plates(dice, &person, &plate, 1, count);
    Case {
        file: "made.forces",
        ..case(
            ".forces",
            table.forces(),
            row_truth(&person, 1, count),
            true,
        )
    }
}

/// One contact of a person whose mass is given: the impulse tells the stride.
fn asc(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::of(dice);
    let table = row_of_plates(dice, &person, &plate, 3, 1);
    let known = dice.chance(60.0);
    // The impulse of this one contact, doubled, over the weight.
    let mut truth = truth(&person);
    truth.strides = vec![2.0 * person.impulse(&person.steps[3]) / (person.mass * G)];
    let mut made = case(".asc", table.amti(), truth, known);
    made.file = "made.asc";
    if known {
        made.options.mass_kg = Some(person.mass);
    }
    made
}

fn anc(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::of(dice);
    let count = dice.of(&[2, 3]);
    let table = row_of_plates(dice, &person, &plate, 2, count);
    let known = dice.chance(50.0);
    let mut made = case(".anc", table.counts(), row_truth(&person, 2, count), known);
    made.file = "made.anc";
    if known {
        made.options.mass_kg = Some(person.mass);
    }
    made
}

/// One plate, one stance, 70 kg in the file; the third word of the header may hold channels.
fn c3d(dice: &mut Dice) -> Case {
    let (stride, peak) = (dice.between(1.0, 1.3), dice.between(0.12, 0.36));
    let lasts = 0.62 * stride;
    let rate = 500.0;
    let area = 2.0 / std::f64::consts::PI * (1.0 + peak / 3.0);
    let top = 70.0 * G * stride / (2.0 * lasts * area);
    let noise = dice.of(&[0.0, 1.0]);
    let wobble: Vec<f64> = (0..900).map(|_| noise * dice.normal()).collect();
    let built = Build {
        processor: dice.of(&[Processor::Intel, Processor::Dec, Processor::Sgi]),
        float: dice.chance(50.0),
        kind: dice.of(&[1, 2, 3, 4, 5]),
        per_frame: 5,
        frames: 180,
        scale: 0.05,
        offset: 7,
    };
    let processor = built.processor;
    let mut bytes = build(&built, |i| {
        let x = (i as f64 / rate - 0.5) / lasts;
        let a = std::f64::consts::PI * x;
        let on = (0.0..1.0).contains(&x);
        let f = top * (a.sin() + peak * (3.0 * a).sin());
        -(if on { f } else { 0.0 }) + wobble[i]
    });
    if dice.chance(50.0) {
        let big = matches!(processor, Processor::Sgi);
        let word = [bytes[4], bytes[5]];
        let all = if big {
            u16::from_be_bytes(word)
        } else {
            u16::from_le_bytes(word)
        };
        let channels = all / 5;
        let word = if big {
            channels.to_be_bytes()
        } else {
            channels.to_le_bytes()
        };
        bytes[4..6].copy_from_slice(&word);
    }
    let truth = Truth {
        kind: Kind::Walking,
        strides: vec![stride],
        mass: Some(70.0),
    };
    Case {
        file: "made.c3d",
        bytes,
        ..case("C3D with either header", String::new(), truth, true)
    }
}

fn components(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate {
        sign: 1.0,
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["l", "r"]);
    let sets: [[[&str; 3]; 2]; 4] = [
        [
            ["GRF_ML_L", "GRF_AP_L", "GRF_V_L"],
            ["GRF_ML_R", "GRF_AP_R", "GRF_V_R"],
        ],
        [
            ["L_mlGRF", "L_apGRF", "L_vGRF"],
            ["R_mlGRF", "R_apGRF", "R_vGRF"],
        ],
        [
            ["LGRF_X", "LGRF_Y", "LGRF_Z"],
            ["RGRF_X", "RGRF_Y", "RGRF_Z"],
        ],
        [
            ["Left Fx", "Left Fy", "Left Fz"],
            ["Right Fx", "Right Fy", "Right Fz"],
        ],
    ];
    let set = dice.of(&sets);
    let mut wide = Table {
        rate_hz: table.rate_hz,
        names: Vec::new(),
        columns: Vec::new(),
    };
    for (names, column) in set.iter().zip(&table.columns) {
        for (name, part) in names.iter().zip([0.05, 0.18, 1.0]) {
            wide.names.push((*name).to_string());
            wide.columns.push(column.iter().map(|f| part * f).collect());
        }
    }
    let text = wide.delimited(seconds_clock(dice), false);
    case("components beside the vertical", text, truth(&person), true)
}

fn one_foot(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::of(dice);
    let left = dice.chance(50.0);
    let column = plate.samples(dice, person.seconds, |t| {
        person.feet(t, |_, s| s.left == left)
    });
    let table = Table {
        rate_hz: plate.rate_hz,
        names: vec!["Fz".to_string()],
        columns: vec![column],
    };
    let text = table.delimited(seconds_clock(dice), false);
    let mut made = case("one foot", text, truth(&person), true);
    made.feet = dice.of(&[Feet::One, Feet::Both]);
    made
}

fn total(dice: &mut Dice) -> Case {
    let seconds = dice.between(9.0, 14.0);
    let person = walker(dice, seconds);
    let plate = Plate {
        offset_n: dice.of(&[0.0, 5.0, -5.0]),
        sign: 1.0,
        ..Plate::of(dice)
    };
    // The first and the last double support lie outside.
    let from = person.steps[2].at;
    let until = person.steps[person.steps.len() - 3].at;
    let column = plate.samples(dice, until - from, |t| person.total(t + from));
    let table = Table {
        rate_hz: plate.rate_hz,
        names: vec![dice.of(&["Fz", "Total Fz [N]", "TOTAL"]).to_string()],
        columns: vec![column],
    };
    let text = table.delimited(seconds_clock(dice), false);
    let mut made = case("total of both feet", text, truth(&person), true);
    if table.names[0] == "TOTAL" || dice.chance(30.0) {
        made.options.force = vec![table.names[0].clone()];
        made.feet = Feet::Total;
    }
    made
}

fn children(dice: &mut Dice) -> Case {
    let person = child(dice, 6.0);
    let plate = Plate {
        offset_n: dice.of(&[0.0, 10.0, -14.0]),
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    case("children", text, truth(&person), true)
}

fn limping(dice: &mut Dice) -> Case {
    let person = limper(dice, 8.0);
    let plate = Plate::of(dice);
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    case("limping", text, truth(&person), true)
}

fn slow(dice: &mut Dice) -> Case {
    let person = slow_walker(dice, 22.0);
    let plate = Plate {
        rate_hz: 100.0,
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    let asked = dice.chance(50.0);
    let mut made = case("very slow steps", text, truth(&person), asked);
    made.options.kind = asked.then_some(Kind::Walking);
    made
}

fn changing_speed(dice: &mut Dice) -> Case {
    let person = changing(dice);
    let plate = Plate {
        rate_hz: 100.0,
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    let mut made = case("changing speed", text, truth(&person), true);
    made.feet = dice.of(&[Feet::Both, Feet::One, Feet::Left]);
    made
}

fn counting(dice: &mut Dice) -> Case {
    let person = walker(dice, 5.0);
    let plate = Plate {
        rate_hz: dice.of(&[60.0, 100.0, 200.0, 300.0, 500.0, 800.0, 1000.0, 1200.0]),
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["left fz", "right fz"]);
    let text = table.delimited(Clock::Counts, false);
    let mut made = case(
        "time column that counts samples",
        text,
        truth(&person),
        false,
    );
    if dice.chance(20.0) {
        made.options.rate_hz = Some(plate.rate_hz);
        made.plain = true;
    }
    made
}

fn milliseconds(dice: &mut Dice) -> Case {
    let person = walker(dice, 5.0);
    let plate = Plate {
        rate_hz: dice.of(&[50.0, 100.0, 200.0, 240.0, 300.0, 500.0]),
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["left fz", "right fz"]);
    let named = dice.chance(50.0);
    let text = table.delimited(Clock::Milliseconds { named }, false);
    case("time column in milliseconds", text, truth(&person), true)
}

fn units(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate {
        sign: 1.0,
        ..Plate::of(dice)
    };
    let mut table = sides(dice, &person, &plate, ["left fz", "right fz"]);
    let weight = person.mass * G;
    let (factor, label, unit, plain) = dice.of(&[
        (1.0, "", None, true),
        (1e-3, " [kN]", None, true),
        (1.0 / LBF, " [lbf]", None, true),
        (1.0 / LBF, "", None, false),
        (1.0 / 9.806_65, "", None, false),
        (1.0 / 9.806_65, "", Some(ForceUnit::KilogramForce), true),
        (1.0, " [kN]", None, false),
        (1.0 / weight, " [BW]", None, true),
        (100.0 / weight, "", Some(ForceUnit::PercentBodyWeight), true),
        (100.0 / weight, "", None, false),
    ]);
    for c in &mut table.columns {
        for x in c.iter_mut() {
            *x *= factor;
        }
    }
    for n in &mut table.names {
        n.push_str(label);
    }
    // Three decimals of a body weight are too few.
    let text = if factor < 0.1 {
        for c in &mut table.columns {
            for x in c.iter_mut() {
                *x = (*x * 1e3).round() / 1e3;
            }
        }
        table.delimited(seconds_clock(dice), false)
    } else {
        table.delimited(seconds_clock(dice), false)
    };
    let mut made = case("unit not given or wrong", text, truth(&person), plain);
    made.options.unit = unit;
    if label.contains("BW") || unit == Some(ForceUnit::PercentBodyWeight) {
        made.options.mass_kg = Some(person.mass);
    }
    made
}

fn cross_talk(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate {
        sign: 1.0,
        ..Plate::of(dice)
    };
    let count = dice.of(&[2, 3, 4]);
    let mut table = row_of_plates(dice, &person, &plate, 2, count);
    let clean = table.columns.clone();
    let part = dice.between(0.03, 0.2);
    let idle = dice.chance(50.0);
    for k in 0..count {
        let neighbour = (k + 1) % count;
        for (x, other) in table.columns[k].iter_mut().zip(&clean[neighbour]) {
            *x += part * (other - plate.offset_n).max(0.0);
        }
    }
    if idle {
        // A plate that nobody steps on, but that shows its neighbour.
        let ghost = clean[0].iter().map(|x| part * x).collect();
        table.columns.push(ghost);
        table.names.push(format!("Fz{}", count + 1));
    }
    let text = table.delimited(seconds_clock(dice), false);
    case("cross-talk", text, row_truth(&person, 2, count), false)
}

fn partial(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::of(dice);
    let count = dice.of(&[3, 4, 5]);
    let mut table = row_of_plates(dice, &person, &plate, 2, count);
    let which = (dice.between(0.0, count as f64 - 0.01)) as usize;
    let part = dice.between(0.15, 0.75);
    let rest = plate.sign * plate.offset_n;
    for x in &mut table.columns[which] {
        *x = rest + part * (*x - rest);
    }
    let text = table.delimited(seconds_clock(dice), false);
    case(
        "partial contacts",
        text,
        row_truth(&person, 2, count),
        false,
    )
}

fn heel_and_toe(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate {
        offset_n: 0.0,
        drift_n: 0.0,
        ..Plate::of(dice)
    };
    let count = dice.of(&[2, 3, 4]);
    let mut table = row_of_plates(dice, &person, &plate, 2, count);
    let which = (dice.between(0.0, count as f64 - 0.01)) as usize;
    let step = person.steps[2 + which];
    let begin = step.at - (person.steps[2].at - 0.4);
    let (from, to) = (dice.between(0.25, 0.4), dice.between(0.55, 0.7));
    let share = |i: usize| {
        let x = (i as f64 / plate.rate_hz - begin) / step.lasts;
        ((x - from) / (to - from)).clamp(0.0, 1.0)
    };
    let column = &table.columns[which];
    let toe: Vec<f64> = column
        .iter()
        .enumerate()
        .map(|(i, f)| share(i) * f)
        .collect();
    let heel: Vec<f64> = column
        .iter()
        .enumerate()
        .map(|(i, f)| (1.0 - share(i)) * f)
        .collect();
    table.columns[which] = heel;
    table.columns.insert(which + 1, toe);
    table.names = (1..=count + 1).map(|k| format!("Fz{k}")).collect();
    let text = table.delimited(seconds_clock(dice), false);
    case(
        "heel on one plate, toe on the next",
        text,
        row_truth(&person, 2, count),
        false,
    )
}

fn two_steps(dice: &mut Dice) -> Case {
    let person = some_walker(dice);
    let plate = Plate::of(dice);
    let from = person.steps[2].at - 0.4;
    let until = person.steps[5].at + person.steps[5].lasts + 0.4;
    let pairs = dice.of(&[1, 2]);
    let columns = (0..pairs)
        .map(|k| {
            plate.samples(dice, until - from, |t| {
                person.feet(t + from, |i, _| i == 2 + 2 * k || i == 3 + 2 * k)
            })
        })
        .collect();
    let table = Table {
        rate_hz: plate.rate_hz,
        names: (1..=pairs).map(|k| format!("Fz{k}")).collect(),
        columns,
    };
    let text = table.delimited(seconds_clock(dice), false);
    case("two steps on one plate", text, truth(&person), false)
}

fn cross_overs(dice: &mut Dice) -> Case {
    let person = walker(dice, 16.0);
    let plate = Plate {
        rate_hz: 100.0,
        ..Plate::of(dice)
    };
    // Some left feet come down on the right belt, or partly.
    let shares: Vec<f64> = (0..person.steps.len())
        .map(|_| match dice.chance(15.0) {
            true => dice.of(&[1.0, 1.0, 0.4]),
            false => 0.0,
        })
        .collect();
    let columns = [true, false]
        .map(|left| {
            plate.samples(dice, person.seconds, |t| {
                let part = |side: bool| {
                    person
                        .steps
                        .iter()
                        .enumerate()
                        .filter(|(_, s)| s.left == side && s.at <= t && t < s.at + s.lasts)
                        .map(|(i, s)| {
                            let share = if side { shares[i] } else { 0.0 };
                            (person.foot(s, t), share)
                        })
                        .collect::<Vec<_>>()
                };
                if left {
                    part(true).iter().map(|(f, share)| (1.0 - share) * f).sum()
                } else {
                    let own: f64 = part(false).iter().map(|p| p.0).sum();
                    own + part(true).iter().map(|(f, share)| share * f).sum::<f64>()
                }
            })
        })
        .to_vec();
    let table = Table {
        rate_hz: plate.rate_hz,
        names: vec!["left fz".to_string(), "right fz".to_string()],
        columns,
    };
    let text = table.delimited(seconds_clock(dice), false);
    let mut made = case("cross-overs on belts", text, truth(&person), true);
    made.feet = dice.of(&[Feet::Both, Feet::One, Feet::Left, Feet::Right]);
    made
}

fn run(dice: &mut Dice) -> (Table, Person) {
    let person = runner(dice, 6.0);
    let plate = Plate {
        rate_hz: dice.of(&[200.0, 300.0]),
        ..Plate::of(dice)
    };
    if dice.chance(30.0) {
        let count = dice.of(&[1, 2, 3]);
        return (row_of_plates(dice, &person, &plate, 2, count), person);
    }
    if dice.chance(20.0) {
        let column = plate.samples(dice, person.seconds, |t| person.total(t));
        let table = Table {
            rate_hz: plate.rate_hz,
            names: vec!["Fz".to_string()],
            columns: vec![column],
        };
        return (table, person);
    }
    let table = sides(dice, &person, &plate, ["left fz", "right fz"]);
    (table, person)
}

fn running(dice: &mut Dice) -> Case {
    let (table, person) = run(dice);
    let mut truth = truth(&person);
    truth.strides = Vec::new();
    let text = table.delimited(seconds_clock(dice), false);
    case("running", text, truth, false)
}

fn running_asked(dice: &mut Dice) -> Case {
    let person = runner(dice, 6.0);
    let plate = Plate {
        rate_hz: dice.of(&[200.0, 300.0]),
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["left fz", "right fz"]);
    let text = table.delimited(seconds_clock(dice), false);
    let mut made = case("running asked for", text, truth(&person), true);
    made.options.kind = Some(Kind::Running);
    made
}

/// The total of a person without steps on one plate, or shared by two.
fn without_steps(dice: &mut Dice, name: &'static str, person: &Person) -> Case {
    let plate = Plate::of(dice);
    let share = dice.between(0.35, 0.65);
    let shares: Vec<f64> = if dice.chance(50.0) {
        vec![1.0]
    } else {
        vec![share, 1.0 - share]
    };
    let columns: Vec<Vec<f64>> = shares
        .iter()
        .map(|part| plate.samples(dice, person.seconds, |t| part * person.total(t)))
        .collect();
    let names: Vec<String> = match (columns.len(), dice.chance(50.0)) {
        (2, true) => vec!["left fz".to_string(), "right fz".to_string()],
        (n, _) => (1..=n).map(|k| format!("Fz{k}")).collect(),
    };
    let table = Table {
        rate_hz: plate.rate_hz,
        names,
        columns,
    };
    let text = table.delimited(seconds_clock(dice), false);
    case(name, text, truth(person), false)
}

fn standing(dice: &mut Dice) -> Case {
    let person = stander(dice);
    without_steps(dice, "standing", &person)
}

fn jumping(dice: &mut Dice) -> Case {
    let person = jumper(dice);
    without_steps(dice, "jumping", &person)
}

fn hopping(dice: &mut Dice) -> Case {
    let person = hopper(dice);
    without_steps(dice, "hopping", &person)
}

fn rising(dice: &mut Dice) -> Case {
    let person = riser(dice);
    without_steps(dice, "rising from a chair", &person)
}

fn bending(dice: &mut Dice) -> Case {
    let person = squatter(dice);
    without_steps(dice, "bending the knees", &person)
}
