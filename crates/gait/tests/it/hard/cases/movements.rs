//! Movements other than walking.

use super::*;

pub fn run(dice: &mut Dice) -> (Table, Person) {
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

pub fn running(dice: &mut Dice) -> Case {
    let (table, person) = run(dice);
    let mut truth = truth(&person);
    truth.strides = Vec::new();
    let text = table.delimited(seconds_clock(dice), false);
    case("running", text, truth, false)
}

pub fn running_asked(dice: &mut Dice) -> Case {
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

/// Total force of a person without steps, on one plate or distributed over two.
pub fn without_steps(dice: &mut Dice, name: &'static str, person: &Person) -> Case {
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

pub fn standing(dice: &mut Dice) -> Case {
    let person = stander(dice);
    without_steps(dice, "standing", &person)
}

pub fn jumping(dice: &mut Dice) -> Case {
    let person = jumper(dice);
    without_steps(dice, "jumping", &person)
}

pub fn hopping(dice: &mut Dice) -> Case {
    let person = hopper(dice);
    without_steps(dice, "hopping", &person)
}

pub fn rising(dice: &mut Dice) -> Case {
    let person = riser(dice);
    without_steps(dice, "rising from a chair", &person)
}

pub fn bending(dice: &mut Dice) -> Case {
    let person = squatter(dice);
    without_steps(dice, "bending the knees", &person)
}
