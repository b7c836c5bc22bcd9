//! Contacts that are not whole steps on one plate.

use super::*;

pub fn cross_talk(dice: &mut Dice) -> Case {
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

pub fn partial(dice: &mut Dice) -> Case {
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

pub fn heel_and_toe(dice: &mut Dice) -> Case {
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

pub fn two_steps(dice: &mut Dice) -> Case {
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

pub fn cross_overs(dice: &mut Dice) -> Case {
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
