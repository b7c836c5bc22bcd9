//! Walkers: one foot, total forces, children, limping, several speeds, time bases, units.

use super::*;

pub fn one_foot(dice: &mut Dice) -> Case {
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

pub fn total(dice: &mut Dice) -> Case {
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

pub fn children(dice: &mut Dice) -> Case {
    let person = child(dice, 6.0);
    let plate = Plate {
        offset_n: dice.of(&[0.0, 10.0, -14.0]),
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    case("children", text, truth(&person), true)
}

pub fn limping(dice: &mut Dice) -> Case {
    let person = limper(dice, 8.0);
    let plate = Plate::of(dice);
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    case("limping", text, truth(&person), true)
}

pub fn slow(dice: &mut Dice) -> Case {
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

pub fn changing_speed(dice: &mut Dice) -> Case {
    let person = changing(dice);
    let plate = Plate {
        rate_hz: 100.0,
        ..Plate::of(dice)
    };
    let table = sides(dice, &person, &plate, ["Left Fz [N]", "Right Fz [N]"]);
    let text = table.delimited(seconds_clock(dice), false);
    let mut made = case("changing speed", text, truth(&person), false);
    made.feet = dice.of(&[Feet::Both, Feet::One, Feet::Left]);
    made
}

pub fn counting(dice: &mut Dice) -> Case {
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

pub fn milliseconds(dice: &mut Dice) -> Case {
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

pub fn units(dice: &mut Dice) -> Case {
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
