//! Layouts of text recordings. Each entry of `LAYOUTS` defines how a layout is recognised, where its table is, and how it is read.

mod converter_counts;
mod plates;
mod sensors;
mod stances;

use super::choose::choose;
use super::delimited::{Delimiters, Separator, TextFile};
use super::header::Table;
use super::samples::Samples;
use crate::error::Result;
use crate::read::keys;
use crate::recording::{DecimalMark, Format, Recording, SeparatorName};

pub use plates::{PlateFile, joined_plates, parts, plate_of};
pub use stances::metadata_name;

/// Layout of a text recording, and the functions that read it.
pub(super) struct Layout {
    /// Program that writes this layout, with the file ending if it identifies the kind of export.
    program: Option<&'static str>,
    /// Whether a text has this layout.
    is_of: fn(&Seen) -> bool,
    /// Function that locates the table. It returns `None` if the table is the first one below a header.
    table: fn(&TextFile) -> Option<Table>,
    /// Function that adjusts the samples to the layout: columns, units, names, feet.
    complete: fn(&TextFile, &[String], &mut Samples) -> Result<()>,
    /// Function that reads the whole table; `None` if each row of the layout is a sample.
    read: Option<ReadTable>,
    /// Whether the forces are those of pressure insoles.
    insole: bool,
}

/// Function that reads a table and the lines above it.
type ReadTable = fn(&TextFile, &Table, &[String]) -> Result<Recording>;

/// Any delimited text. Its columns are interpreted by their names.
const DELIMITED: Layout = Layout {
    program: None,
    is_of: |_| true,
    table: |_| None,
    complete: |_, _, _| Ok(()),
    read: None,
    insole: false,
};

/// All layouts. The first layout that matches a text is used.
const LAYOUTS: &[Layout] = &[
    Layout {
        program: Some("Motion Analysis (.anc)"),
        is_of: |text| text.starts("file_type"),
        table: converter_counts::table,
        complete: converter_counts::complete,
        ..DELIMITED
    },
    Layout {
        is_of: |text| sensors::are_in(text.file, text.names, &text.head),
        read: Some(sensors::read),
        ..DELIMITED
    },
    Layout {
        is_of: |text| stances::are_in(text.names),
        read: Some(stances::read),
        ..DELIMITED
    },
    Layout {
        program: Some("OpenSim"),
        is_of: |text| text.starts("endheader"),
        ..DELIMITED
    },
    Layout {
        program: Some("Cortex (.forces)"),
        is_of: |text| text.contains("[force data]"),
        ..DELIMITED
    },
    Layout {
        program: Some("Vicon Nexus"),
        is_of: |text| text.starts("devices") && text.has_name("sub"),
        ..DELIMITED
    },
    Layout {
        program: Some("Moticon OpenGo"),
        is_of: |text| text.contains("insoles"),
        insole: true,
        ..DELIMITED
    },
    Layout {
        program: Some("Novel loadsol"),
        is_of: |text| text.contains("loadapp") || text.has_name("::"),
        insole: true,
        ..DELIMITED
    },
    Layout {
        program: Some("Kistler BioWare"),
        is_of: |text| text.contains("bioware"),
        ..DELIMITED
    },
    Layout {
        program: Some("Qualisys"),
        is_of: |text| text.starts("no_of_") || text.starts("force_plate"),
        complete: plates::complete,
        ..DELIMITED
    },
    Layout {
        program: Some("AMTI (.asc)"),
        is_of: |text| text.names.is_empty() && text.is_file("asc") && text.is_comma_separated(),
        ..DELIMITED
    },
    DELIMITED,
];

/// Features of a text from which its layout is recognised.
struct Seen<'a> {
    file: &'a TextFile<'a>,
    /// Lines above the table, in lower case.
    head: Vec<String>,
    /// Names of the columns of the table.
    names: &'a [String],
}

impl Seen<'_> {
    fn starts(&self, line: &str) -> bool {
        self.head.iter().any(|l| l.starts_with(line))
    }

    fn contains(&self, words: &str) -> bool {
        self.head.iter().any(|l| l.contains(words))
    }

    fn has_name(&self, part: &str) -> bool {
        let mut names = self.names.iter();
        names.any(|name| name.to_lowercase().contains(part))
    }

    fn is_file(&self, ending: &str) -> bool {
        let extension = self.file.path.extension();
        extension.is_some_and(|e| e.eq_ignore_ascii_case(ending))
    }

    fn is_comma_separated(&self) -> bool {
        self.file.delimiters.separator == Separator::Byte(b',')
    }
}

/// Layout of a text, recognised from one of its tables and the lines above the table.
pub(super) fn layout(file: &TextFile, table: &Table, head: &[String]) -> &'static Layout {
    let seen = Seen {
        file,
        head: head.iter().map(|line| line.to_lowercase()).collect(),
        names: &table.names,
    };
    let of_text = LAYOUTS.iter().find(|layout| (layout.is_of)(&seen));
    of_text.unwrap_or(&DELIMITED)
}

impl Layout {
    /// Table located by the layout; `None` if the table is the first one below a header, as in most texts.
    pub fn own_table(&self, file: &TextFile) -> Option<Table> {
        (self.table)(file)
    }

    /// Reads a table with its layout; `None` if the table has no force.
    ///
    /// # Errors
    ///
    /// The errors of [`read`](super::read).
    pub fn read(
        &self,
        file: &TextFile,
        table: &Table,
        head: &[String],
    ) -> Result<Option<Recording>> {
        if let Some(read) = self.read {
            return read(file, table, head).map(Some);
        }
        let Some(columns) = choose(file, table)? else {
            return Ok(None);
        };
        let mut samples = Samples::read(file, table, columns)?;
        (self.complete)(file, head, &mut samples)?;
        if samples.forces.is_empty() {
            return Ok(None);
        }
        samples.insole.get_or_insert(self.insole);
        let keys = keys::read(head, file.delimiters.comma);
        let format = self.format(file.delimiters, table);
        samples.recording(file, table, &keys, format).map(Some)
    }

    fn format(&self, delimiters: Delimiters, table: &Table) -> Format {
        if let Some(program) = self.program {
            return Format::Export { program };
        }
        let (separator, decimal) = described(delimiters);
        match table.names.is_empty() {
            true => Format::HeaderlessText { separator, decimal },
            false => Format::Text { separator, decimal },
        }
    }
}

fn described(delimiters: Delimiters) -> (SeparatorName, DecimalMark) {
    let separator = match delimiters.separator {
        Separator::Byte(b'\t') => SeparatorName::Tab,
        Separator::Byte(b';') => SeparatorName::Semicolon,
        Separator::Byte(b'|') => SeparatorName::Bar,
        Separator::Byte(_) => SeparatorName::Comma,
        Separator::Blanks => SeparatorName::Blank,
    };
    let decimal = match delimiters.comma {
        true => DecimalMark::Comma,
        false => DecimalMark::Point,
    };
    (separator, decimal)
}
