//! Header of a table: the names above the columns, the groups above the names, the units, and the other lines above the table.

use super::delimited::{Delimiters, Fields, Position, Separator, text};
use crate::read::number::{Field, field, trim};

/// Position and header of a table in a text.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    /// Position of the first row of numbers.
    pub start: Position,
    /// Number of fields in a row. Empty fields at the end of the first row are excluded, unless a later row contains forces in them.
    pub width: usize,
    /// Name of each column; empty without a header. If the header has several rows, the names of a column are joined by a space.
    pub names: Vec<String>,
    /// Unit of each column; empty without a row of units.
    pub units: Vec<String>,
    /// Lines above the table, without comment marks and without the rows of names and units.
    pub head: Vec<String>,
}

impl Table {
    /// Text of a column in the row of units, without brackets.
    pub fn unit(&self, column: usize) -> Option<&str> {
        let unit = self.units.get(column)?;
        Some(unit.trim_matches(['[', ']', '(', ')']).trim()).filter(|u| !u.is_empty())
    }

    /// Number of the line above the first row of numbers, which usually contains the names.
    pub fn header_line(&self) -> usize {
        self.start.line.saturating_sub(1).max(1)
    }
}

fn cells(line: &[u8], delimiters: Delimiters, width: usize) -> Vec<String> {
    let split = |l: &[u8]| -> Vec<String> {
        let mut all: Vec<String> = Fields::new(l, delimiters).map(|f| text(trim(f))).collect();
        while all.last().is_some_and(String::is_empty) {
            all.pop();
        }
        all
    };
    let line = uncommented(line);
    let all = split(line);
    if delimiters.separator == Separator::Blanks && all.len() != width {
        // Names may contain single spaces if wider gaps separate the columns.
        let whole = text(line).replace('\t', "  ");
        let wide = whole.split("  ").map(str::trim).filter(|c| !c.is_empty());
        let wide: Vec<String> = wide.map(str::to_string).collect();
        if wide.len() == width {
            return wide;
        }
    }
    all
}

fn uncommented(line: &[u8]) -> &[u8] {
    let line = line.trim_ascii_end();
    let marks = line.iter().take_while(|b| b"#%!".contains(b)).count();
    if marks == 0 {
        return line;
    }
    line[marks..].strip_prefix(b" ").unwrap_or(&line[marks..])
}

pub(super) fn with_header(
    start: Position,
    width: usize,
    head: &[&[u8]],
    delimiters: Delimiters,
) -> Table {
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut units = Vec::new();
    let mut above = head.len();
    while above > 0 && rows.len() < 6 {
        let line = head[above - 1];
        let blank = line.trim_ascii().is_empty();
        let row = cells(line, delimiters, width);
        let over = || {
            above
                .checked_sub(2)
                .map(|k| cells(head[k], delimiters, width))
        };
        let of_units = || is_unit_row(&row) || is_below_names(&row, over(), width, delimiters);
        if units.is_empty() && rows.is_empty() && row.len() <= width + 1 && of_units() {
            units = row;
        } else if match rows.last() {
            None => is_name_row(&row, width, delimiters),
            Some(below) => is_group_row(&row, below, width, delimiters),
        } {
            rows.push(row);
        } else if !(blank && rows.is_empty() && above == head.len()) {
            break;
        }
        above -= 1;
    }
    rows.reverse();
    Table {
        start,
        width,
        names: joined(&rows),
        units,
        head: head[..above]
            .iter()
            .map(|l| text(uncommented(l)).trim().to_string())
            .collect(),
    }
}

fn filled(row: &[String]) -> usize {
    row.iter().filter(|c| !c.is_empty()).count()
}

fn is_wordy(row: &[String], delimiters: Delimiters) -> bool {
    let number = |c: &&String| matches!(field(c.as_bytes(), delimiters.comma), Field::Number(_));
    row.iter().filter(number).count() == 0
        && !row
            .first()
            .is_some_and(|c| c.contains('=') || c.eq_ignore_ascii_case("endheader"))
}

/// Minimum number of consecutive numbers in a row that count as names of sensors.
const FEWEST_COUNTED: usize = 6;

/// Whether the numbers in a row increase by one from 0 or 1, possibly with words between them, as the names of sensors do.
pub(super) fn are_counted<'a>(fields: impl Iterator<Item = &'a [u8]>, comma: bool) -> bool {
    let mut next = None;
    let mut count = 0;
    for f in fields {
        match field(f, comma) {
            Field::Number(x) if next.map_or(x == 0.0 || x == 1.0, |n| x == n) => {
                next = Some(x + 1.0);
                count += 1;
            }
            Field::Missing if trim(f).is_empty() => (),
            Field::Text => (),
            _ => return false,
        }
    }
    count >= FEWEST_COUNTED
}

/// Whether a row contains names for at least half of the columns.
fn is_name_row(row: &[String], width: usize, delimiters: Delimiters) -> bool {
    let named = filled(row);
    let are_names = is_wordy(row, delimiters)
        || are_counted(row.iter().map(String::as_bytes), delimiters.comma);
    named > 0 && 2 * named >= width && row.len() <= 2 * width + 2 && are_names
}

/// Whether a row above the names distinguishes columns of the same name, for example a row of plates above the components.
fn is_group_row(row: &[String], below: &[String], width: usize, delimiters: Delimiters) -> bool {
    let mut names: Vec<&String> = below.iter().filter(|c| !c.is_empty()).collect();
    let all = names.len();
    names.sort();
    names.dedup();
    let repeats = names.len() < all;
    let fits = filled(row) > 0 && row.len() <= width + 1 && is_wordy(row, delimiters);
    let over_names = row.first().is_some_and(String::is_empty);
    fits && (over_names || repeats && filled(row) * 2 >= width)
}

/// Whether a word denotes a unit.
pub(super) fn is_unit(word: &str) -> bool {
    const UNITS: &str = " s sec secs seconds ms min n kn dan newton newtons kilonewton kilonewtons lbf lb lbs kgf kp kg mm cm m nmm n.mm n*mm nm n.m n*m n-m \
        n·m n·mm v mv uv µv volt volts deg ° deg/s rad hz - % bw %bw n/kg ns kip dyn ozf gf mn n/bw adc bits a.u. g mm/s m/s m/s2 n/cm2 pa hpa kpa mpa bar mbar psi mv/v count counts digits lsb \
        frame frames ";
    let bare = word.trim_matches(['[', ']', '(', ')', ' ']).to_lowercase();
    let bare = bare.replace('²', "2").replace("^2", "2");
    !bare.is_empty() && UNITS.contains(&format!(" {bare} "))
}

/// Whether at least three quarters of the non-empty cells of a row denote units.
fn is_unit_row(row: &[String]) -> bool {
    let named = filled(row);
    named > 0 && row.iter().filter(|c| is_unit(c)).count() * 4 >= named * 3
}

/// Whether a row of words below the names begins with a unit of time. The row then contains the units of all columns, even if they are
/// unknown.
fn is_below_names(
    row: &[String],
    over: Option<Vec<String>>,
    width: usize,
    delimiters: Delimiters,
) -> bool {
    let first = |row: &[String]| row.iter().find(|c| !c.is_empty()).cloned();
    let timed = first(row).is_some_and(|c| is_time_unit(&c));
    let named = |over: &[String]| {
        is_name_row(over, width, delimiters)
            && filled(over) == filled(row)
            && first(over).is_some_and(|c| !is_unit(&c))
    };
    timed && filled(row) > 1 && is_wordy(row, delimiters) && over.is_some_and(|over| named(&over))
}

/// Whether a word denotes a unit of time.
fn is_time_unit(word: &str) -> bool {
    let bare = word.trim_matches(['[', ']', '(', ')', ' ']).to_lowercase();
    ["s", "sec", "secs", "seconds", "ms", "min"].contains(&bare.as_str())
}

/// Joins the rows of a header column by column. The name of a group applies to all columns up to the next group.
fn joined(rows: &[Vec<String>]) -> Vec<String> {
    let Some(last) = rows.last() else {
        return Vec::new();
    };
    let mut names = vec![String::new(); last.len()];
    for (depth, row) in rows.iter().enumerate() {
        let mut held = "";
        for (name, i) in names.iter_mut().zip(0..) {
            let cell = row.get(i).map_or("", String::as_str);
            if !cell.is_empty() || depth + 1 == rows.len() {
                held = cell;
            }
            if !held.is_empty() {
                if !name.is_empty() {
                    name.push(' ');
                }
                name.push_str(held);
            }
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_of_names_names_half_the_columns_at_least() {
        let delimiters = Delimiters {
            separator: Separator::Byte(b','),
            comma: false,
        };
        let row = |names: usize| -> Vec<String> {
            (0..6)
                .map(|k| {
                    if k < names {
                        format!("f{k}x")
                    } else {
                        String::new()
                    }
                })
                .collect()
        };
        let named: Vec<usize> = (0..=6)
            .filter(|n| is_name_row(&row(*n), 6, delimiters))
            .collect();
        assert_eq!(named, [3, 4, 5, 6]);
        assert!(!is_name_row(&vec!["1.5".to_string(); 6], 6, delimiters));
    }
}
