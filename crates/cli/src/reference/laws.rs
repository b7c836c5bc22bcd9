//! `gaitcam laws`: the catalogue of rise laws.

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::BUILT;
use crate::console::language;
use crate::console::table::{Side, table};
use crate::console::terminal::{print, print_json};
use crate::console::words;
use gaitcam::error::{Placed, Result, nearest};
use gaitcam::law::{End, Ends, Factors, Rise};

const EXAMPLES: &str = "Examples:
  gaitcam laws
  gaitcam laws cycloidal
  gaitcam laws --json | python3 -m json.tool";

/// How to print it.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct LawsArgs {
    /// Only this law
    name: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Endpoint derivatives that the law can join, once if both ends agree.
fn joined(ends: &Ends) -> String {
    let joins = |end: &End| end.joins_in(language::current());
    let (start, end) = (joins(&ends.start), joins(&ends.end));
    if start == end {
        start
    } else {
        format!("{start} → {end}")
    }
}

/// Prints the catalogue as a table, or as a list of objects.
pub fn run(args: &LawsArgs) -> Result<u8> {
    let all = Rise::catalogue();
    // As scenes name it, in both languages.
    let named = args.name.as_deref().map(Rise::from_name);
    let asked = |rise: &Rise| match &named {
        None => true,
        Some(named) => named.as_ref().is_ok_and(|n| n.name() == rise.name()),
    };
    let mut rows = Vec::new();
    for rise in all.iter().filter(|rise| asked(rise)) {
        rows.push((rise.clone(), rise.factors()?, rise.ends()?));
    }
    if let (Some(typed), true) = (&args.name, rows.is_empty()) {
        let known: Vec<String> = all.iter().map(|rise| rise.name().to_string()).collect();
        let fault = CliError::NoLaw {
            typed: typed.clone(),
            nearest: nearest_law(typed, &all).unwrap_or("none").to_string(),
            known: known.join(", "),
        };
        return Err(fault.at_argument("NAME"));
    }
    if args.json {
        print_json(&rows.iter().map(object).collect());
    } else {
        print(&text(&rows));
    }
    Ok(BUILT)
}

/// The law with the name nearest to a word, as in scenes or as in the language.
fn nearest_law<'a>(typed: &str, all: &'a [Rise]) -> Option<&'a str> {
    let called: Vec<String> = all.iter().map(|r| words::name(r.name())).collect();
    let names = all
        .iter()
        .map(Rise::name)
        .chain(called.iter().map(String::as_str));
    let found = nearest(typed, names)?;
    let is_it = |(rise, called): (&'a Rise, &String)| {
        (rise.name() == found || called == found).then(|| rise.name())
    };
    all.iter().zip(&called).find_map(is_it)
}

type Row = (Rise, Factors, Ends);

fn object((rise, f, ends): &Row) -> Value {
    let finite = |x: f64| if x.is_finite() { json!(x) } else { json!(null) };
    json!({
        "name": rise.name(), "formula": rise.formula(),
        "cv": finite(f.cv), "ca": finite(f.ca), "cj": finite(f.cj), "ct": finite(f.ct),
        "v": [finite(f.v.0), finite(f.v.1)], "a": [finite(f.a.0), finite(f.a.1)], "j": [finite(f.j.0), finite(f.j.1)],
        "joins": [ends.start.joins(), ends.end.joins()],
        "continuity_with_dwell": [ends.start.continuity_with_dwell(), ends.end.continuity_with_dwell()],
    })
}

fn text(rows: &[Row]) -> String {
    // What the language calls a law, where scenes do not write it so.
    let called = |rise: &Rise| words::name(rise.name());
    let differs = rows.iter().any(|row| called(&row.0) != row.0.name());
    let second = |called: String| if differs { vec![called] } else { Vec::new() };
    let factors = ["Cv", "Ca", "Cj", "Ct"].map(String::from);
    let mut lines = vec![
        [
            vec![words::text("laws-law")],
            second(String::new()),
            factors.to_vec(),
            vec![words::text("laws-joins")],
        ]
        .concat(),
    ];
    lines.extend(rows.iter().map(|(rise, f, ends)| {
        [
            vec![rise.name().to_string()],
            second(called(rise)),
            [f.cv, f.ca, f.cj, f.ct].map(words::number).to_vec(),
            vec![joined(ends)],
        ]
        .concat()
    }));
    let names = vec![Side::Left; if differs { 2 } else { 1 }];
    let sides = [names, vec![Side::Right; 4], vec![Side::Left]].concat();
    format!("{}\n{}", words::text("laws-head"), table(&lines, &sides))
}
