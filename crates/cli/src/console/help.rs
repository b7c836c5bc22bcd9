//! Help texts in the language of the output. The English texts are the doc comments of the arguments. The Spanish texts are in
//! `words/es/help.ftl`, with the keys `VERB`, `VERB-ARGUMENT` and, for arguments of several verbs, `all-ARGUMENT`.

use clap::{Arg, Command, CommandFactory};
use gaitcam::wording::{Catalogue, Language, Messages, Sentences};

use crate::Cli;

/// Command-line parser with help texts in a language. In English, clap builds only the subcommand that is used, which saves time.
pub fn parser(language: Language) -> Command {
    match language {
        Language::En => Cli::command().arg(lang()),
        Language::Es => command(language),
    }
}

/// Command-line parser with all subcommands and their help texts in a language.
pub fn command(language: Language) -> Command {
    let mut command = Cli::command().arg(lang());
    // Flags and subcommands that clap adds automatically exist only after `build`.
    command.build();
    match language {
        Language::En => command,
        Language::Es => in_spanish(command, ""),
    }
}

/// Argument `--lang`, which is read before all other arguments (see [`language`](crate::console::language)).
fn lang() -> Arg {
    Arg::new("lang")
        .long("lang")
        .global(true)
        .value_name("LANG")
        .value_parser(["en", "es"])
        .help("Language of messages and reports (default: LC_ALL, LANG, else English)")
}

/// Spanish help texts. The English texts are the doc comments of the arguments.
static HELP: Catalogue = Catalogue::new(&[Sentences {
    files: &[["", include_str!("../../words/es/help.ftl")]],
    ..Sentences::NONE
}]);

fn spanish() -> &'static Messages {
    HELP.of(Language::Es)
}

/// Spanish help text of the message `key`; `None` if the catalogue does not contain this key.
fn message(key: &str) -> Option<String> {
    let text = spanish().text(key);
    (text != key).then_some(text)
}

fn label(key: &str) -> String {
    spanish().text(key)
}

/// Replaces the help texts of a verb and its subcommands by the Spanish texts. An empty `verb` means `gaitcam` without a verb.
fn in_spanish(command: Command, verb: &str) -> Command {
    let about = if verb.is_empty() { "gaitcam" } else { verb };
    let usage = command.clone().render_usage().to_string();
    let usage = usage
        .trim_start_matches("Usage: ")
        .replace("[OPTIONS]", "[OPCIONES]")
        .replace("[COMMAND]", "[ORDEN]");
    let examples = command.get_after_help().map(|text| {
        let text = text.to_string();
        text.replacen("Examples:", &label("label-examples"), 1)
    });
    let mut command = command
        .about(label(about))
        .override_usage(with_names(&usage))
        .help_template(format!(
            "{{about-with-newline}}\n{} {{usage}}\n\n{{all-args}}{{after-help}}",
            label("label-usage")
        ))
        .subcommand_help_heading(label("label-commands"))
        .mut_args(|arg| argument(arg, verb));
    if let Some(examples) = examples {
        command = command.after_help(examples);
    }
    command.mut_subcommands(|sub| {
        let name = sub.get_name().to_string();
        in_spanish(sub, &name)
    })
}

fn argument(arg: Arg, verb: &str) -> Arg {
    let id = arg.get_id().to_string();
    let mut help = message(&format!("{verb}-{id}"))
        .or_else(|| message(&format!("all-{id}")))
        .unwrap_or_default();
    let values: Vec<String> = arg
        .get_possible_values()
        .iter()
        .map(|v| v.get_name().to_string())
        .collect();
    if takes_value(&arg) && !values.is_empty() {
        help = format!("{help} [{} {}]", label("label-values"), values.join(", "));
    }
    let default: Vec<_> = arg
        .get_default_values()
        .iter()
        .map(|v| v.to_string_lossy())
        .collect();
    if takes_value(&arg) && !default.is_empty() {
        help = format!("{help} [{} {}]", label("label-default"), default.join(", "));
    }
    let heading = match arg.get_help_heading() {
        Some(heading) => format!("label-{}", heading.to_lowercase().replace(' ', "-")),
        None if arg.is_positional() => "label-arguments".to_string(),
        None => "label-options".to_string(),
    };
    let names: Option<Vec<String>> = arg
        .get_value_names()
        .map(|names| names.iter().map(|n| with_names(n)).collect());
    let arg = arg
        .help(help)
        .help_heading(label(&heading))
        .hide_possible_values(true)
        .hide_default_value(true);
    match names {
        Some(names) if takes_value(&arg) => arg.value_names(names),
        _ => arg,
    }
}

fn takes_value(arg: &Arg) -> bool {
    arg.get_action().takes_values()
}

/// Translates the placeholders in a usage line or a value name to Spanish, such as `<FILE>` to `<ARCHIVO>`.
fn with_names(text: &str) -> String {
    let mut out = String::new();
    let mut word = String::new();
    for c in text.chars().chain(['\0']) {
        if c.is_ascii_uppercase() || (c == '_' && !word.is_empty()) {
            word.push(c);
            continue;
        }
        let known = message(&format!("value-{}", word.to_lowercase()));
        out.push_str(&known.unwrap_or_else(|| word.clone()));
        word.clear();
        out.push(c);
    }
    out.pop();
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys_of(command: &Command, verb: &str, found: &mut Vec<(String, String)>) {
        for arg in command.get_arguments() {
            found.push((verb.to_string(), arg.get_id().to_string()));
        }
        for sub in command.get_subcommands().filter(|s| s.get_name() != "help") {
            keys_of(sub, sub.get_name(), found);
        }
    }

    #[test]
    fn every_verb_and_argument_has_its_spanish_help_and_every_help_its_argument() {
        let command = command(Language::En);
        let mut used: Vec<String> = vec!["gaitcam".to_string()];
        used.extend(command.get_subcommands().map(|s| s.get_name().to_string()));
        let mut arguments = Vec::new();
        keys_of(&command, "", &mut arguments);
        for (verb, id) in arguments {
            let own = format!("{verb}-{id}");
            let key = if message(&own).is_some() {
                own
            } else {
                format!("all-{id}")
            };
            used.push(key);
        }
        for key in &used {
            assert!(
                message(key).is_some(),
                "{key} is missing in words/es/help.ftl"
            );
        }
        for key in &spanish().keys() {
            let of_page = key.starts_with("label-") || key.starts_with("value-");
            assert!(
                of_page || used.contains(key),
                "{key} is no verb and no argument"
            );
        }
    }

    #[test]
    fn placeholders_are_replaced_whole() {
        assert_eq!(
            with_names("gaitcam front [OPCIONES] <FILE>"),
            "gaitcam front [OPCIONES] <ARCHIVO>"
        );
        assert_eq!(with_names("FILE.csv"), "ARCHIVO.csv");
        assert_eq!(with_names("A:B"), "A:B");
    }
}
