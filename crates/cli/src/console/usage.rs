//! Converts errors of the command-line parser to error messages in the language of the output.

use std::error::Error as _;
use std::ffi::{OsStr, OsString};
use std::num::ParseIntError;

use clap::builder::PossibleValue;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command};
use gaitcam::error::{Error, Placed};

use crate::console::error::CliError;
use crate::console::help::command;
use gaitcam::wording::Language;

/// Joins a negative number to the preceding flag: `--tool -3mm` becomes `--tool=-3mm`. Otherwise the parser would read the number as an
/// option. No option begins with a digit.
pub fn with_negative_values(arguments: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let mut out: Vec<OsString> = Vec::new();
    for argument in arguments {
        match out.last_mut() {
            Some(flag) if is_negative(&argument) && is_flag(flag) => {
                flag.push("=");
                flag.push(argument);
            }
            _ => out.push(argument),
        }
    }
    out
}

/// Whether a text is a negative number, with or without a unit.
fn is_negative(argument: &OsStr) -> bool {
    let text = argument.to_string_lossy();
    let number = text.strip_prefix('-').map(|n| n.trim_start_matches('.'));
    number.is_some_and(|n| n.starts_with(|c: char| c.is_ascii_digit()))
}

/// Whether a text is a flag that has its value in the following argument.
fn is_flag(argument: &OsStr) -> bool {
    let text = argument.to_string_lossy();
    text.len() > 2 && text.starts_with("--") && !text.contains('=')
}

/// Converts an error of the command-line parser to an error of this program.
pub fn fault(error: &clap::Error) -> Error {
    let part = |kind| context(error, kind);
    let flag = part(ContextKind::InvalidArg).unwrap_or_default();
    let near = part(ContextKind::SuggestedArg)
        .or_else(|| part(ContextKind::SuggestedSubcommand))
        .or_else(|| part(ContextKind::SuggestedValue));
    let value = part(ContextKind::InvalidValue).unwrap_or_default();
    match error.kind() {
        ErrorKind::UnknownArgument if flag.starts_with('-') => {
            CliError::UnknownFlag { near }.at_argument(&flag)
        }
        ErrorKind::UnknownArgument => CliError::OneTooMany.at_argument(&flag),
        ErrorKind::InvalidSubcommand => {
            let typed = part(ContextKind::InvalidSubcommand).unwrap_or_default();
            Error::from(match IN_LAB.contains(&typed.as_str()) {
                true => CliError::InLab { typed },
                false => CliError::UnknownVerb { typed, near },
            })
        }
        ErrorKind::InvalidValue if value.is_empty() => {
            CliError::FlagWithoutValue.at_argument(&flag)
        }
        ErrorKind::InvalidValue => {
            let choices = part(ContextKind::ValidValue).unwrap_or_default();
            let typed = value;
            CliError::FlagChoice { typed, choices }.at_argument(plain(&flag))
        }
        ErrorKind::ValueValidation => unsuitable(error, value).at_argument(plain(&flag)),
        ErrorKind::MissingRequiredArgument => {
            let choices = choices(&flag);
            Error::from(CliError::MissingArguments {
                missing: flag,
                choices,
            })
        }
        ErrorKind::ArgumentConflict => {
            let other = part(ContextKind::PriorArg).unwrap_or_default();
            CliError::FlagConflict {
                other: plain(&other).to_string(),
            }
            .at_argument(plain(&flag))
        }
        ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues | ErrorKind::TooManyValues => {
            CliError::FlagCount.at_argument(&flag)
        }
        _ => {
            let text = error.to_string();
            let fault = text.lines().next().unwrap_or_default();
            let fault = fault.trim_start_matches("error: ").to_string();
            Error::from(CliError::Arguments { fault })
        }
    }
}

/// Valid values of a missing flag, joined by commas. For a flag without a list of values, the result is "table" if the flag is the output
/// file of a table, otherwise "none".
fn choices(missing: &str) -> String {
    if missing.starts_with("--out <") {
        return "table".to_string();
    }
    let command = command(Language::En);
    let arguments = command.get_subcommands().flat_map(Command::get_arguments);
    let is_it = |a: &&Arg| {
        let long = a.get_long().map(|long| format!("--{long} "));
        long.is_some_and(|long| missing.starts_with(&long))
    };
    let found = arguments.filter(is_it).find_map(|a| {
        let values = a.get_possible_values();
        let names: Vec<&str> = values.iter().map(PossibleValue::get_name).collect();
        (!names.is_empty()).then(|| names.join(", "))
    });
    found.unwrap_or_else(|| "none".to_string())
}

/// Former verbs of `gaitcam` that are now verbs of `gaitcam-lab`.
const IN_LAB: [&str; 2] = ["chart", "reproduce"];

/// Error for an invalid value of a flag. It contains the valid values or the valid range, if clap provides them.
fn unsuitable(error: &clap::Error, typed: String) -> CliError {
    let source = error.source();
    if source.is_some_and(|s| s.is::<ParseIntError>()) {
        return CliError::FlagWhole { typed };
    }
    let fault = source.map(ToString::to_string).unwrap_or_default();
    // Message of clap for a value outside its range.
    match fault.split_once(" is not in ") {
        Some((_, range)) => CliError::FlagRange {
            typed,
            range: range.replace("..=", " … "),
        },
        None => CliError::FlagValue { typed, fault },
    }
}

/// Context value of a clap error as text. The elements of a list are joined by commas.
fn context(error: &clap::Error, kind: ContextKind) -> Option<String> {
    match error.get(kind)? {
        ContextValue::String(text) => Some(text.clone()),
        ContextValue::Strings(list) => Some(list.join(", ")),
        ContextValue::Number(n) => Some(n.to_string()),
        ContextValue::StyledStr(text) => Some(text.to_string()),
        _ => None,
    }
}

/// Flag without the placeholder of its value: `--feet <FEET>` → `--feet`.
fn plain(flag: &str) -> &str {
    flag.split([' ', '=']).next().unwrap_or(flag)
}
