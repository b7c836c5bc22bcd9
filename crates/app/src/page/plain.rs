//! Messages for users who do not edit a scene file: the names of keys are replaced by the labels of form fields.
//!
//! The messages of the program contain keys as in a scene file: `gait.accept = "mass"`, `[machine]`, `(option rate)`. The page shows the labels of
//! its form instead: “Accepted interpretations: mass”, “Machine”, (“Sampling rate”).

use gaitcam::scene::keys::{self, KEYS};
use gaitcam::wording::{Language, limit_label};

use crate::page::words::WORDS;

/// Words that precede names of options of `gait` in messages, in both languages.
const OPTION: [&str; 4] = ["option", "options", "opción", "opciones"];
/// Separators between the names of several options, in both languages.
const BETWEEN: [&str; 7] = [", ", " and ", " or ", " y ", " e ", " o ", " u "];
/// Sections in which a key without a section is looked up, in this order.
const SECTIONS: [&str; 6] = ["gait", "law", "machine", "drive", "cam", "limits"];

/// Message in which keys are replaced by labels. A key without a section is looked up first in `section`.
pub fn plain(text: &str, section: &str, language: Language) -> String {
    let mut writer = Writer {
        out: String::with_capacity(text.len()),
        rest: text,
        section,
        language,
    };
    while writer.step() {}
    writer.out
}

/// Label of a key in the form. It contains the number of the list entry if the key has one.
pub fn label(path: &str, language: Language) -> String {
    let Some(key) = keys::find(path) else {
        return section_label(path, language).unwrap_or_else(|| path.to_string());
    };
    let own = text_of(
        &format!(
            "studio-key-{}",
            key.path.replace(".N.", ".").replace('.', "-")
        ),
        language,
    );
    let limit = || key.limit.map(|_| limit_label(language, key.path));
    let column = || text_of(&format!("studio-column-{}", key.name()), language);
    let name = own.or_else(limit).or_else(column);
    let name = name.unwrap_or_else(|| key.name().replace('_', " "));
    let number = path.split('.').find_map(|part| part.parse::<usize>().ok());
    number.map_or(name.clone(), |number| format!("{name} {number}"))
}

fn text_of(key: &str, language: Language) -> Option<String> {
    let text = WORDS.of(language).text(key);
    (text != key).then_some(text)
}

/// Label of a section, or of a list of entries; `None` if no key belongs to `path`.
fn section_label(path: &str, language: Language) -> Option<String> {
    let below = format!("{path}.");
    if !KEYS.iter().any(|key| key.path.starts_with(&below)) {
        return None;
    }
    let name = path.replace('.', "-");
    let texts = ["list", "section"].map(|kind| format!("studio-{kind}-{name}"));
    let last = || path.rsplit('.').next().unwrap_or(path).replace('_', " ");
    let part = format!("part-{name}");
    let own = texts
        .iter()
        .chain([&part])
        .find_map(|key| text_of(key, language));
    Some(own.unwrap_or_else(last))
}

/// Full path of a key that is given without its section; `None` if no section contains the key.
fn path_of(name: &str, section: &str) -> Option<&'static str> {
    let in_section = |section: &str| {
        let exact = format!("{section}.{name}");
        if let Some(key) = KEYS.iter().find(|key| key.path == exact) {
            return Some(key.path);
        }
        let mut all = KEYS.iter().filter(|key| key.section() == section);
        all.find(|key| key.name() == name).map(|key| key.path)
    };
    let mut sections = std::iter::once(section).chain(SECTIONS);
    sections.find_map(in_section)
}

struct Writer<'a> {
    out: String,
    rest: &'a str,
    section: &'a str,
    language: Language,
}

impl<'a> Writer<'a> {
    /// Copies the next word or character of the message to the output, and replaces a key by its label. Returns false at the end of the message.
    fn step(&mut self) -> bool {
        let Some(first) = self.rest.chars().next() else {
            return false;
        };
        let starts = !self
            .out
            .ends_with(|c: char| c.is_alphanumeric() || "_.-/\\$".contains(c));
        let is_written = match first {
            '[' => self.table(),
            _ if starts && first.is_ascii_lowercase() => self.word(),
            _ => false,
        };
        if !is_written {
            self.out.push(first);
            self.rest = &self.rest[first.len_utf8()..];
        }
        true
    }

    /// Replaces a section name in brackets by the label of the section. Returns false if the next text is not a section name.
    fn table(&mut self) -> bool {
        let Some(end) = self.rest.find(']') else {
            return false;
        };
        let name = self.rest[..end].trim_start_matches('[');
        let Some(label) = section_label(name, self.language) else {
            return false;
        };
        self.rest = self.rest[end..].trim_start_matches(']');
        self.quote(&label);
        true
    }

    fn word(&mut self) -> bool {
        let is_inside = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let end = self.rest.find(|c| !is_inside(c)).unwrap_or(self.rest.len());
        let word = self.rest[..end].trim_end_matches('.');
        let after = &self.rest[word.len()..];
        if OPTION.contains(&word) && self.options(after) {
            return true;
        }
        let is_assigned = after.starts_with(" = \"") || after.starts_with(" = [");
        let path = match keys::find(word) {
            Some(_) if word.contains('.') => Some(word),
            _ if is_assigned || word.contains('_') => path_of(word, self.section),
            _ => None,
        };
        if let Some(path) = path {
            let label = label(path, self.language);
            self.rest = after;
            let value = is_assigned.then(|| self.value(path)).flatten();
            match value {
                Some(value) => self.quote(&format!("{label}: {value}")),
                None => self.quote(&label),
            }
            return true;
        }
        let section = word
            .contains('.')
            .then(|| section_label(word, self.language));
        if let Some(label) = section.flatten() {
            self.rest = after;
            self.quote(&label);
            return true;
        }
        self.out.push_str(word);
        self.rest = after;
        true
    }

    /// Reads the value after an equals sign and returns it without quotation marks. For a choice, the label is returned. `None` if no value
    /// follows.
    fn value(&mut self, path: &str) -> Option<String> {
        let written = self.rest.strip_prefix(" = ")?;
        let (value, rest) = match written.strip_prefix('"') {
            Some(text) => text.split_once('"')?,
            None => written.strip_prefix('[')?.split_once(']')?,
        };
        self.rest = rest;
        let value = value.replace('"', "");
        let is_choice = keys::find(path).is_some_and(|key| key.choices().contains(&value.as_str()));
        let choice = is_choice.then(|| text_of(&format!("studio-choice-{value}"), self.language));
        Some(choice.flatten().unwrap_or(value))
    }

    /// Replaces names of options of `gait` by their labels, as in `options unit and mass`. Returns false if no option name follows.
    fn options(&mut self, after: &'a str) -> bool {
        let mut rest = after;
        let mut between = " ";
        let mut labels = Vec::new();
        while let Some(names) = rest.strip_prefix(between) {
            let end = names.find(|c: char| !(c.is_alphanumeric() || c == '_'));
            let (name, more) = names.split_at(end.unwrap_or(names.len()));
            let path = format!("gait.{name}");
            if keys::find(&path).is_none() {
                break;
            }
            labels.push((between, label(&path, self.language)));
            rest = more;
            between = match BETWEEN.iter().find(|word| rest.starts_with(**word)) {
                Some(word) => word,
                None => break,
            };
        }
        self.rest = match labels.is_empty() {
            true => return false,
            false => rest,
        };
        for (i, (between, label)) in labels.iter().enumerate() {
            if i > 0 {
                self.out.push_str(between);
            }
            self.quote(label);
        }
        true
    }

    fn quote(&mut self, text: &str) {
        let [before, after] = match self.language {
            Language::En => ['“', '”'],
            Language::Es => ['«', '»'],
        };
        self.out.push(before);
        self.out.push_str(text);
        self.out.push(after);
    }
}

/// Message in which every number has at most four significant digits.
pub fn short(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, number) = rest.split_at(start);
        let is_part = before.ends_with(|c: char| c.is_alphanumeric() || "_.^".contains(c));
        let end = number.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ','));
        let (number, after) = number.split_at(end.unwrap_or(number.len()));
        let trimmed = number.trim_end_matches(['.', ',']);
        out.push_str(before);
        match is_part || after.starts_with(|c: char| c.is_alphabetic()) {
            true => out.push_str(trimmed),
            false => out.push_str(&rounded(trimmed)),
        }
        out.push_str(&number[trimmed.len()..]);
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Text of a decimal number with at most four significant digits. Any other text is unchanged.
fn rounded(number: &str) -> String {
    let Some(mark) = number.find(['.', ',']) else {
        return number.to_string();
    };
    let sign = &number[mark..=mark];
    let Ok(value) = number.replacen(sign, ".", 1).parse::<f64>() else {
        return number.to_string();
    };
    let digits = number.trim_start_matches(['0', '.', ',']);
    if value == 0.0 || digits.chars().filter(char::is_ascii_digit).count() <= 4 {
        return number.to_string();
    }
    let whole = libm::log10(value.abs()).floor() as i32 + 1;
    let decimals = usize::try_from(4 - whole).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    text.replace('.', sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    const EN: Language = Language::En;

    #[test]
    fn keys_become_the_labels_of_their_fields() {
        let cases = [
            (
                "Set gait.force, gait.feet, or gait.accept = \"mass\" if right.",
                "Set “Force columns”, “Feet”, or “Accepted interpretations: mass” if right.",
            ),
            (
                "give the rate (option rate), for example",
                "give the rate (“Sampling rate”), for example",
            ),
            (
                "unit (options unit and mass)",
                "unit (“Unit of force” and “Mass of the walker”)",
            ),
            (
                "indique (opciones unit y mass)",
                "indique (“Unit of force” y “Mass of the walker”)",
            ),
            (
                "write inertia = \"0.5 kg m^2\" under [machine]",
                "write “Inertia of the shaft: 0.5 kg m^2” under “Machine”",
            ),
            (
                "give [[law.segment]] with motion",
                "give “Segments” with motion",
            ),
            (
                "a file motor.csv of 3.5 N, e.g. this",
                "a file motor.csv of 3.5 N, e.g. this",
            ),
        ];
        for (before, after) in cases {
            assert_eq!(plain(before, "machine", EN), after);
        }
        assert_eq!(
            plain("use kind = \"running\"", "gait", EN),
            "use “Kind of recording: running”"
        );
        assert_eq!(
            plain("accuracy.rms", "", Language::Es).chars().next(),
            Some('«')
        );
    }

    #[test]
    fn numbers_have_four_digits() {
        assert_eq!(
            short("98.9194 N, 14,1359 %, 0.0012346 m, 12345.6, 20 mm."),
            "98.92 N, 14,14 %, 0.001235 m, 12346, 20 mm."
        );
        assert_eq!(
            short("at 1.5 s, walk_12.34567a, 2048"),
            "at 1.5 s, walk_12.34567a, 2048"
        );
    }

    /// Every message of the program in one language, one line each.
    fn messages(folder: &str) -> Vec<String> {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../");
        let mut out = Vec::new();
        let mut files: Vec<_> = std::fs::read_dir(format!("{root}{folder}"))
            .unwrap()
            .collect();
        files.sort_by_key(|f| f.as_ref().unwrap().path());
        for file in files {
            let path = file.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_string();
            // Key descriptions are for readers of scene files. Messages about sweeps and folders belong to commands.
            if path.extension().is_none_or(|e| e != "ftl")
                || ["keys", "sweep", "write"].contains(&name.as_str())
            {
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            let lines = text.lines().filter(|l| !l.starts_with('#'));
            out.extend(lines.map(|l| format!("{name}|{l}")));
        }
        out
    }

    #[test]
    fn no_message_shows_a_key_of_the_scene_file() {
        let folders = [
            "src/wording/",
            "crates/gait/src/wording/",
            "crates/base/src/wording/",
        ];
        let mut seen = 0;
        for (tag, language) in [("en", EN), ("es", Language::Es)] {
            for line in folders.iter().flat_map(|f| messages(&format!("{f}{tag}"))) {
                let (area, line) = line.split_once('|').unwrap();
                let (_, message) = line.split_once(" = ").unwrap_or(("", line));
                let given = message
                    .replace("{ $key }", "limits.stroke")
                    .replace("{ $keys }", "gait.mass");
                let section = match area {
                    "force" | "read" => "gait",
                    area => area,
                };
                let shown = plain(&given, section, language);
                seen += usize::from(shown != given);
                assert!(!shown.contains(" = \""), "{area}: {shown}");
                for word in shown.split(|c: char| !(c.is_alphanumeric() || "._".contains(c))) {
                    assert!(
                        keys::find(word.trim_matches('.')).is_none_or(|k| !k.path.contains('.')),
                        "{area}: {shown}"
                    );
                }
            }
        }
        assert!(seen > 200, "{seen}");
    }
}
