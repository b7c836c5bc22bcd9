//! `gaitcam laws`: catalogue of rise laws.

use clap::Args;
use serde_json::{Value, json};

use crate::console::exit_code::BUILT;
use crate::console::language;
use crate::console::table::{Side, table};
use crate::console::terminal::{print, print_json};
use crate::console::words;
use gaitcam::error::Result;
use gaitcam::law::{End, Ends, Factors, Rise};

const EXAMPLES: &str = "Examples:
  gaitcam laws
  gaitcam laws cycloidal
  gaitcam laws --json | python3 -m json.tool";

/// Arguments of `gaitcam laws`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct LawsArgs {
    /// Only this law
    name: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Derivatives of the lift that the rise can match at its start and end. If they are the same at both ends, they are listed only once.
fn joined(ends: &Ends) -> String {
    let joins = |end: &End| end.joins_in(language::current());
    let (start, end) = (joins(&ends.start), joins(&ends.end));
    if start == end {
        start
    } else {
        format!("{start} → {end}")
    }
}

/// Prints the catalogue as a table or as JSON.
pub fn run(args: &LawsArgs) -> Result<u8> {
    // Scenes use the same names in both languages.
    let laws = match &args.name {
        Some(name) => vec![Rise::from_name(name)?],
        None => Rise::catalogue(),
    };
    let mut rows = Vec::new();
    for rise in laws {
        rows.push((rise.clone(), rise.factors()?, rise.ends()?));
    }
    if args.json {
        print_json(&rows.iter().map(object).collect());
    } else {
        print(&text(&rows));
    }
    Ok(BUILT)
}

type Row = (Rise, Factors, Ends);

fn object((rise, f, ends): &Row) -> Value {
    let finite = |x: f64| if x.is_finite() { json!(x) } else { json!(null) };
    json!({
        "name": rise.name(), "formula": rise.formula(),
        "cv": finite(f.cv), "ca": finite(f.ca), "cj": finite(f.cj), "ct": finite(f.ct),
        "v": [finite(f.v.0), finite(f.v.1)], "a": [finite(f.a.0), finite(f.a.1)], "j": [finite(f.j.0), finite(f.j.1)],
        "joins": [ends.start.joins(), ends.end.joins()], "vdi": [ends.start.vdi(), ends.end.vdi()],
        "continuity_with_dwell": [ends.start.continuity_with_dwell(), ends.end.continuity_with_dwell()],
    })
}

fn text(rows: &[Row]) -> String {
    // Name of a law in the language of the output. It may differ from the name in scenes.
    let called = |rise: &Rise| words::name(rise.name());
    let differs = rows.iter().any(|row| called(&row.0) != row.0.name());
    let second = |called: String| if differs { vec![called] } else { Vec::new() };
    let factors = ["Cv", "Ca", "Cj", "Ct"].map(String::from);
    let mut lines = vec![
        [
            vec![words::text("laws-law")],
            second(String::new()),
            factors.to_vec(),
            vec!["VDI".to_string(), words::text("laws-joins")],
        ]
        .concat(),
    ];
    lines.extend(rows.iter().map(|(rise, f, ends)| {
        [
            vec![rise.name().to_string()],
            second(called(rise)),
            [f.cv, f.ca, f.cj, f.ct].map(words::number).to_vec(),
            vec![
                format!("{}-{}", ends.start.vdi(), ends.end.vdi()),
                joined(ends),
            ],
        ]
        .concat()
    }));
    let names = vec![Side::Left; if differs { 2 } else { 1 }];
    let sides = [names, vec![Side::Right; 4], vec![Side::Left; 2]].concat();
    format!("{}\n{}", words::text("laws-head"), table(&lines, &sides))
}
