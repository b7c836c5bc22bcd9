//! Formats of files: laboratories, OpenSim, C3D.

use super::*;

pub fn plates_in_a_row(dice: &mut Dice) -> Case {
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

pub fn open_sim(dice: &mut Dice) -> Case {
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

pub fn forces(dice: &mut Dice) -> Case {
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

/// One contact of a person with a given mass; the stride time follows from the impulse.
pub fn asc(dice: &mut Dice) -> Case {
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

pub fn anc(dice: &mut Dice) -> Case {
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

/// One plate and one stance, with 70 kg in the file. The third word of the header may contain the number of channels.
pub fn c3d(dice: &mut Dice) -> Case {
    let (stride, peak) = (dice.between(1.0, 1.3), dice.between(0.12, 0.36));
    let lasts = 0.62 * stride;
    let rate = 500.0;
    let area = 2.0 / std::f64::consts::PI * (1.0 + peak / 3.0);
    let top = 70.0 * G * stride / (2.0 * lasts * area);
    let noise = dice.of(&[0.0, 1.0]);
    let wobble: Vec<f64> = (0..900).map(|_| noise * dice.normal()).collect();
    let built = Build {
        before: 0,
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

pub fn components(dice: &mut Dice) -> Case {
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
