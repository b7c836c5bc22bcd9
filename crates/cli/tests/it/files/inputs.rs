//! No verb replaces a file that it reads, for any kind of input and any name of an output file.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::support::{run_in, stderr, walk};

/// A verb with one of its inputs. In the arguments, `IN` is the input and `OUT` is the output path.
struct Case {
    arguments: &'static str,
    /// File of the common folder that is the input.
    input: &'static str,
}

const fn case(arguments: &'static str, input: &'static str) -> Case {
    Case { arguments, input }
}

/// Every verb that writes files, with each kind of input that it reads.
const CASES: [Case; 25] = [
    case(
        "synth own.toml --set gait.file=IN --no-png --out OUT",
        "walk.csv",
    ),
    case(
        "synth motor.toml --set machine.motor.curve=IN --no-png --out OUT",
        "motor.csv",
    ),
    case(
        "synth motion.toml --set law.segment.1.motion=\"table IN\" --no-png --out OUT",
        "rise.csv",
    ),
    case("synth IN --no-png --out OUT", "motion.toml"),
    case("synth IN --no-png --out OUT", "design/summary.json"),
    case(
        "synth own.toml --set gait.file=IN --front force_error:stroke --points 3 --out OUT",
        "walk.csv",
    ),
    case("simulate own.toml --set gait.file=IN --out OUT", "walk.csv"),
    case(
        "simulate motor.toml --set machine.motor.curve=IN --out OUT",
        "motor.csv",
    ),
    case("simulate IN --out OUT", "motion.toml"),
    case(
        "simulate own.toml --set gait.file=IN --speeds 1Hz:2Hz:2 --out OUT",
        "walk.csv",
    ),
    case("identify design IN --out OUT", "log.csv"),
    case("identify IN log.csv --out OUT", "design/summary.json"),
    case("recut design IN --no-png --out OUT", "log.csv"),
    case("recut IN log.csv --no-png --out OUT", "design/summary.json"),
    case("inspect design IN --out OUT", "design/profile.csv"),
    case(
        "inspect IN design/profile.csv --out OUT",
        "design/summary.json",
    ),
    case("gait IN --out OUT.csv", "walk.csv"),
    case("gait IN walk.csv --out OUT", "second.csv"),
    case("cover IN --cams 1 --out OUT", "walkers.csv"),
    case(
        "cover walkers.csv --scene IN --cams 1 --out OUT",
        "plain.toml",
    ),
    case("sweep IN --vary law.spans=8,12 --out OUT.csv", "plain.toml"),
    case("sweep own.toml --recordings IN --out OUT.csv", "walk.csv"),
    case("sweep plain.toml --list IN --out OUT.csv", "list.csv"),
    case(
        "sweep IN --tolerance profile=0.02mm --sample 10 --out OUT.csv",
        "plain.toml",
    ),
    case("front IN --best --out OUT", "table.csv"),
];

const MODEL: &str = "[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\n[law]\nspans = 12\n";

/// Writes the input files that all cases use.
fn prepare(at: &Path) {
    let write = |name: &str, text: &str| fs::write(at.join(name), text).unwrap();
    walk(&at.join("walk.csv"));
    walk(&at.join("second.csv"));
    let machine = "[drive]\nmass = \"auto\"\nspeed = \"auto\"\n[law]\nspans = 12\n";
    write(
        "own.toml",
        &format!("[gait]\nfile = \"walk.csv\"\n{machine}"),
    );
    write("plain.toml", MODEL);
    let motor = "[machine]\ninertia = \"5 kg m^2\"\n[machine.motor]\ncurve = \"motor.csv\"\n";
    write("motor.toml", &format!("{MODEL}{motor}"));
    write("motor.csv", "speed_rad_per_s,torque_n_m\n0,400\n30,0\n");
    let segments = "[law]\nfamily = \"program\"\n[[law.segment]]\nmotion = \"table rise.csv\"\nangle = \"180 deg\"\nlift = \"10 mm\"\n\
                    [[law.segment]]\nmotion = \"3-4-5\"\nangle = \"180 deg\"\nlift = \"-10 mm\"\n";
    write(
        "motion.toml",
        &format!("{segments}[drive]\nmass = \"5 kg\"\nspeed = \"60 rpm\"\n"),
    );
    let rise = |i: i32| {
        let x = f64::from(i) / 60.0;
        let lift = 10.0 * x.powi(3) * (10.0 - 15.0 * x + 6.0 * x * x);
        format!("{},{lift:.9}\n", 3 * i)
    };
    write(
        "rise.csv",
        &format!(
            "angle_deg,lift_mm\n{}",
            (0..=60).map(rise).collect::<String>()
        ),
    );
    write("list.csv", "limits.stroke\n50 mm\n60 mm\n");
    let cell = |weight: f64| {
        move |i: i32| {
            let x = f64::from(i % 100) / 100.0;
            format!(
                ",{:.3}",
                weight * (1.0 + 0.3 * (std::f64::consts::TAU * x).sin())
            )
        }
    };
    let names: String = (0..=100).map(|i| format!(",f_{i:03}")).collect();
    let row = |who: &str, w: f64| {
        format!(
            "{who},,,0.55{}\n",
            (0..=100).map(cell(w)).collect::<String>()
        )
    };
    let rows = row("A", 600.0) + &row("B", 700.0) + &row("C", 800.0);
    write(
        "walkers.csv",
        &format!("walker,speed_m_per_s,mass_kg,period_s{names}\n{rows}"),
    );
    let run = |arguments: &[&str]| {
        let output = run_in(at, arguments);
        assert!(
            output.status.success(),
            "{arguments:?}: {}",
            stderr(&output)
        );
    };
    run(&["synth", "plain.toml", "--no-png", "--out", "design"]);
    let table = [
        "sweep",
        "plain.toml",
        "--vary",
        "limits.stroke=50 mm:70 mm:3",
        "--out",
        "table.csv",
    ];
    run(&table);
    let law = fs::read_to_string(at.join("design/law.csv")).unwrap();
    let force = |row: &str| row.split(',').nth(5).unwrap().parse::<f64>().unwrap();
    let forces: Vec<f64> = law.lines().skip(1).map(force).collect();
    let row = |i: usize| {
        let theta = std::f64::consts::TAU * 1.85 * i as f64 / 900.0;
        let turn = theta / std::f64::consts::TAU;
        let at = (turn.fract() * forces.len() as f64) as usize;
        let more = 9.0 * (2.0 * theta).sin() + (i * 7919 % 601) as f64 / 100.0 - 3.0;
        format!("{:.5},{:.3}\n", i as f64 / 900.0, forces[at] + more)
    };
    write(
        "log.csv",
        &format!("time_s,force_n\n{}", (0..9000).map(row).collect::<String>()),
    );
}

/// Arguments of a case for an input path and an output path.
fn arguments(case: &Case, input: &str, out: &str) -> Vec<String> {
    let words = case.arguments.replace('"', "");
    let mut joined: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match joined.last_mut() {
            Some(last) if last.ends_with("=table") => *last += &format!(" {word}"),
            _ => joined.push(word.to_string()),
        }
    }
    joined
        .iter()
        .map(|word| word.replace("IN", input).replace("OUT", out))
        .collect()
}

/// Collects every file below a folder, with its path relative to it.
fn files(folder: &Path, from: &Path, out: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => files(&path, from, out),
            false => {
                out.insert(
                    path.strip_prefix(from)
                        .unwrap()
                        .to_str()
                        .unwrap()
                        .to_string(),
                );
            }
        }
    }
}

fn below(folder: &Path) -> BTreeSet<String> {
    let mut out = BTreeSet::new();
    files(folder, folder, &mut out);
    out
}

fn run(at: &Path, arguments: &[String]) -> std::process::Output {
    run_in(
        at,
        &arguments.iter().map(String::as_str).collect::<Vec<_>>(),
    )
}

#[test]
fn no_verb_replaces_a_file_that_it_reads() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    prepare(at);
    for case in CASES {
        let before = below(at);
        fs::create_dir_all(at.join("new")).unwrap();
        let output = run(at, &arguments(&case, case.input, "new/out"));
        let written: Vec<String> = below(at).difference(&before).cloned().collect();
        assert!(
            !written.is_empty(),
            "{}: {}",
            case.arguments,
            stderr(&output)
        );
        let content = fs::read(at.join(case.input)).unwrap();
        fs::remove_dir_all(at.join("new")).unwrap();
        for name in &written {
            // The input under the name of a file that the verb writes.
            let place = at.join(name);
            fs::create_dir_all(place.parent().unwrap()).unwrap();
            fs::write(&place, &content).unwrap();
            let output = run(at, &arguments(&case, name, "new/out"));
            let stays = fs::read(&place).is_ok_and(|bytes| bytes == content);
            assert!(
                stays,
                "{} replaced {name}: {}",
                case.arguments,
                stderr(&output)
            );
            fs::remove_dir_all(at.join("new")).unwrap();
        }
    }
}
