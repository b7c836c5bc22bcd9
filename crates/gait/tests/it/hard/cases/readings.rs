//! Readings with disturbances from programs and amplifiers: words for missing values, spikes, hum, cross-talk, copies, unusual numbers.

use super::*;

/// A person on two belts whose readings begin and end unloaded.
fn belts(dice: &mut Dice, plate: &Plate) -> (Person, Table) {
    let person = some_walker(dice);
    let names = dice.of(&SIDES);
    let mut table = sides(dice, &person, plate, names);
    let rest = (0.4 * plate.rate_hz) as usize;
    for column in &mut table.columns {
        let idle: Vec<f64> = (0..rest).map(|_| plate.sign * plate.offset_n).collect();
        *column = [&idle[..], column, &idle[..]].concat();
    }
    (person, table)
}

/// A plate with low noise, at a rate at which adjacent samples are similar.
fn dense(dice: &mut Dice) -> Plate {
    Plate {
        rate_hz: dice.of(&[200.0, 250.0, 500.0]),
        noise_n: dice.of(&[0.0, 1.0]),
        offset_n: dice.of(&[0.0, -14.0, 20.0]),
        drift_n: 0.0,
        ..Plate::of(dice)
    }
}

/// Cells of an unloaded plate are empty or contain a word.
pub fn words_for_unloaded(dice: &mut Dice) -> Case {
    let plate = Plate {
        cut_n: dice.of(&[5.0, 10.0, 20.0]),
        rate_hz: dice.of(&[100.0, 200.0, 500.0]),
        ..Plate::thresholded(dice)
    };
    let (person, mut table) = belts(dice, &plate);
    for x in table.columns.iter_mut().flatten() {
        *x = if *x == 0.0 { f64::NAN } else { *x };
    }
    let word = dice.of(&["", "NaN", "NA", "-", "n/a"]);
    let text = table.delimited(seconds_clock(dice), dice.chance(20.0));
    let text = text.replace("NaN", word);
    case("words for unloaded", text, truth(&person), true)
}

/// Single samples are much too high or too low.
pub fn spikes(dice: &mut Dice) -> Case {
    let plate = dense(dice);
    let (person, mut table) = belts(dice, &plate);
    let rows = table.rows() as f64;
    for _ in 0..dice.of(&[1, 3, 6]) {
        let (column, row) = (dice.of(&[0, 1]), dice.between(2.0, rows - 2.0) as usize);
        table.columns[column][row] = dice.of(&[-1.0, 1.0]) * dice.between(2500.0, 6000.0);
    }
    let text = table.delimited(seconds_clock(dice), false);
    case("spikes", text, truth(&person), true)
}

/// Mains hum in the amplifier.
pub fn hum(dice: &mut Dice) -> Case {
    let plate = dense(dice);
    let (person, mut table) = belts(dice, &plate);
    let (hz, hum) = (dice.of(&[50.0, 60.0]), dice.between(4.0, 9.0));
    let phase = dice.between(0.0, 6.0);
    for column in &mut table.columns {
        for (i, x) in column.iter_mut().enumerate() {
            let turn = std::f64::consts::TAU * hz * i as f64 / plate.rate_hz;
            *x += hum * (turn + phase).sin();
        }
    }
    let text = table.delimited(seconds_clock(dice), false);
    case("hum", text, truth(&person), false)
}

/// A part of the force on each belt also appears in the readings of the other belt.
pub fn coupled_plates(dice: &mut Dice) -> Case {
    let plate = dense(dice);
    let (person, mut table) = belts(dice, &plate);
    let part = dice.between(0.02, 0.08);
    let [left, right] = [table.columns[0].clone(), table.columns[1].clone()];
    for (column, other) in table.columns.iter_mut().zip([right, left]) {
        for (x, other) in column.iter_mut().zip(other) {
            *x += part * (other - plate.sign * plate.offset_n);
        }
    }
    let text = table.delimited(seconds_clock(dice), false);
    case("coupled plates", text, truth(&person), false)
}

/// Raw columns together with the same columns filtered, or with copies.
pub fn columns_twice(dice: &mut Dice) -> Case {
    let plate = dense(dice);
    let (person, mut table) = belts(dice, &plate);
    table.names = ["Fz1 (N)", "Fz2 (N)"].map(str::to_string).to_vec();
    let width = dice.of(&[0usize, 1, 2]);
    let smooth = |column: &Vec<f64>| -> Vec<f64> {
        let mean = |i: usize| {
            let span = &column[i.saturating_sub(width)..(i + width + 1).min(column.len())];
            span.iter().sum::<f64>() / span.len() as f64
        };
        (0..column.len()).map(mean).collect()
    };
    let filtered: Vec<Vec<f64>> = table.columns.iter().map(smooth).collect();
    table.columns.extend(filtered);
    let names = ["Fz1 (N) filtered", "Fz2 (N) filtered"].map(str::to_string);
    table.names.extend(names);
    let text = table.delimited(seconds_clock(dice), false);
    case("columns twice", text, truth(&person), true)
}

/// Numbers such as `"1,050.22"` together with `999.12`, and Unicode minus signs.
pub fn odd_numbers(dice: &mut Dice) -> Case {
    let plate = Plate {
        sign: 1.0,
        offset_n: -14.0,
        ..dense(dice)
    };
    let (person, table) = belts(dice, &plate);
    let (quote, minus) = (dice.chance(70.0), dice.of(&["-", "\u{2212}"]));
    let number = |x: f64| {
        let digits = format!("{:.2}", x.abs());
        let sign = if x < 0.0 { minus } else { "" };
        match digits.len() {
            7 if quote => format!("\"{sign}{},{}\"", &digits[..1], &digits[1..]),
            _ => format!("{sign}{digits}"),
        }
    };
    let mut text = "time (s),Left Fz (N),Right Fz (N)\n".to_string();
    for i in 0..table.rows() {
        let [left, right] = [0, 1].map(|k| number(table.columns[k][i]));
        let _ = writeln!(text, "{:.4},{left},{right}", i as f64 / table.rate_hz);
    }
    case("odd numbers", text, truth(&person), true)
}

/// Two rows of names, zones together with their totals, and a time column for each sensor.
pub fn loadsol(dice: &mut Dice) -> Case {
    let plate = Plate {
        rate_hz: dice.of(&[100.0, 200.0]),
        ..Plate::thresholded(dice)
    };
    let (person, table) = belts(dice, &plate);
    let mut head = [String::new(), "Time[secs]".to_string()];
    for (side, number) in ["L", "R"].into_iter().zip([12, 13]) {
        for zone in ["::heel", "::medial", "::lateral", ""] {
            head[0] += &format!("\tABC{number}-{side}{zone}");
            head[1] += "\tForce[N]";
        }
        head[0] += "\t";
        head[1] += "\tTime[secs]";
    }
    let mut text = format!(
        "loadapp_2024_01_01.loadflux\ncomment\n{}\n{}\n",
        head[0], head[1]
    );
    for i in 0..table.rows() {
        let t = i as f64 / table.rate_hz;
        let _ = write!(text, "{t:.4}");
        for column in &table.columns {
            let f = column[i];
            let _ = write!(
                text,
                "\t{:.1}\t{:.1}\t{:.1}\t{f:.1}\t{t:.4}",
                0.5 * f,
                0.2 * f,
                0.3 * f
            );
        }
        text.push('\n');
    }
    case("loadsol", text, truth(&person), false)
}

/// Five rows of names, a counter, and empty cells while no foot is on a plate.
pub fn visual3d(dice: &mut Dice) -> Case {
    let plate = Plate {
        cut_n: 10.0,
        rate_hz: dice.of(&[100.0, 200.0, 500.0]),
        ..Plate::thresholded(dice)
    };
    let (person, table) = belts(dice, &plate);
    let mut text = String::new();
    for row in ["walk.c3d", "FP", "FORCE", "PROCESSED"] {
        for plate in 1..=2 {
            let name = if row == "FP" {
                format!("FP{plate}")
            } else {
                row.to_string()
            };
            text += &format!("\t{name}").repeat(3);
        }
        text.push('\n');
    }
    text += "ITEM\tX\tY\tZ\tX\tY\tZ\n";
    let word = dice.of(&["", "NaN"]);
    for i in 0..table.rows() {
        let _ = write!(text, "{}", i + 1);
        for column in &table.columns {
            let cells = match column[i] {
                0.0 => [word; 3].map(str::to_string),
                f => [0.02 * f, 0.1 * f, f].map(|x| format!("{x:.3}")),
            };
            let _ = write!(text, "\t{}", cells.join("\t"));
        }
        text.push('\n');
    }
    let mut made = case("Visual3D with blanks", text, truth(&person), true);
    made.options.rate_hz = Some(plate.rate_hz);
    made
}

/// Exactly one stride on two belts, from heel strike to heel strike, of feet with different forces.
pub fn one_stride(dice: &mut Dice) -> Case {
    let plate = Plate {
        noise_n: dice.of(&[0.0, 1.0]),
        ..Plate::thresholded(dice)
    };
    let mut person = some_walker(dice);
    let uneven = dice.between(-0.08, 0.08);
    for step in &mut person.steps {
        step.factor *= if step.left {
            1.0 + uneven
        } else {
            1.0 - uneven
        };
    }
    let from = person.steps[2].at;
    let seconds = person.steps[4].at - from;
    let of = |dice: &mut Dice, left: bool| {
        plate.samples(dice, seconds, |t| {
            person.feet(t + from, |_, s| s.left == left)
        })
    };
    let table = Table {
        rate_hz: plate.rate_hz,
        names: dice.of(&SIDES).map(str::to_string).to_vec(),
        columns: vec![of(dice, true), of(dice, false)],
    };
    let text = table.delimited(seconds_clock(dice), false);
    // The stride itself, or its one whole step twice.
    let step = person.steps[3].at - from;
    let truth = Truth {
        strides: vec![seconds, 2.0 * step],
        ..truth(&person)
    };
    case("one stride of unlike feet", text, truth, false)
}

/// A jump down on one leg: a single contact with a fast rise, without a step before or after.
pub fn landing(dice: &mut Dice) -> Case {
    let plate = Plate {
        rate_hz: dice.of(&[200.0, 500.0, 1000.0]),
        ..Plate::of(dice)
    };
    let weight = G * dice.between(50.0, 90.0);
    let (lasts, first) = (dice.between(0.55, 0.8), dice.between(0.09, 0.14));
    let points = [
        (0.0, 0.0),
        (first, dice.between(1.75, 2.3)),
        (first + 0.1, dice.between(1.5, 1.65)),
        (0.7, dice.between(1.7, 1.85)),
        (1.0, 0.0),
    ];
    let force = |t: f64| {
        let x = (t - 1.0) / lasts;
        let after = points.partition_point(|p| p.0 <= x);
        let (Some(a), Some(b)) = (after.checked_sub(1).map(|i| points[i]), points.get(after))
        else {
            return 0.0;
        };
        let part = (x - a.0) / (b.0 - a.0);
        weight * (a.1 + (b.1 - a.1) * 0.5 * (1.0 - (std::f64::consts::PI * part).cos()))
    };
    let table = Table {
        rate_hz: plate.rate_hz,
        names: vec!["Fz (N)".to_string()],
        columns: vec![plate.samples(dice, 3.0, force)],
    };
    let truth = Truth {
        kind: Kind::Jumping,
        strides: Vec::new(),
        mass: None,
    };
    let mut made = case(
        "landing on one leg",
        table.delimited(seconds_clock(dice), false),
        truth,
        false,
    );
    if dice.chance(50.0) {
        made.options.mass_kg = Some(weight / G);
    }
    made
}

/// Time of a computer clock: a large number in some unit, without the name of the unit.
pub fn clock_units(dice: &mut Dice) -> Case {
    let plate = dense(dice);
    let (person, table) = belts(dice, &plate);
    let (per_second, from) = dice.of(&[(1.0, 1.7e9), (1e3, 1.7e12), (1e6, 5e9), (1e9, 3e14)]);
    let decimals = if per_second == 1.0 { 4 } else { 0 };
    let mut text = "timestamp,left fz,right fz\n".to_string();
    for i in 0..table.rows() {
        let t = from + per_second * i as f64 / table.rate_hz;
        let [left, right] = [0, 1].map(|k| table.columns[k][i]);
        let _ = writeln!(text, "{t:.decimals$},{left:.2},{right:.2}");
    }
    case(
        "clocks that start far from zero",
        text,
        truth(&person),
        true,
    )
}

/// Packets lost by a wireless insole: zeros of some hundredths of a second.
pub fn drop_outs(dice: &mut Dice) -> Case {
    let plate = Plate {
        rate_hz: dice.of(&[100.0, 200.0]),
        ..Plate::thresholded(dice)
    };
    let person = walker(dice, 20.0);
    let names = dice.of(&SIDES);
    let mut table = sides(dice, &person, &plate, names);
    let (rows, lost) = (table.rows() as f64, (0.055 * plate.rate_hz) as usize);
    for _ in 0..dice.of(&[2, 5, 9]) {
        let (column, row) = (dice.of(&[0, 1]), dice.between(1.0, rows - 20.0) as usize);
        table.columns[column][row..row + lost].fill(0.0);
    }
    let text = table.delimited(seconds_clock(dice), false);
    case("lost packets", text, truth(&person), false)
}

/// Values in newtons per kilogram, although the header states newtons.
pub fn per_kilogram(dice: &mut Dice) -> Case {
    let plate = Plate {
        offset_n: 0.0,
        ..dense(dice)
    };
    let (person, mut table) = belts(dice, &plate);
    table.names = ["Left Fz (N)", "Right Fz (N)"].map(str::to_string).to_vec();
    for x in table.columns.iter_mut().flatten() {
        *x /= person.mass;
    }
    let text = table.delimited(seconds_clock(dice), false);
    case("N/kg under N", text, truth(&person), false)
}
