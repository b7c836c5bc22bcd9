//! Tables in a delimited text: position, column names and numbers.

use std::collections::VecDeque;

use super::clock_time::clock;
use super::delimited::{Delimiters, Fields, Lines, Position, TextFile};
use super::header::{Table, are_counted, with_header};
use super::plain_row::plain_row;
use crate::error::{Placed, ReadError, Result};
use crate::read::number::{Field, field, trim, value};

/// Maximum number of header lines that are stored. If there are more, lines in the middle of the header are skipped.
const HEADER_LINES: usize = 300;

/// Locates the next table at or after a position.
///
/// A table starts at the first of two consecutive rows of numbers. At the end of the text, one row of numbers is sufficient.
pub(crate) fn next_table(bytes: &[u8], delimiters: Delimiters, from: Position) -> Option<Table> {
    let mut head: VecDeque<&[u8]> = VecDeque::new();
    let mut lines = Lines::from(bytes, from);
    while let Some((at, line)) = lines.next() {
        if row_width(line, delimiters).is_some() {
            let next = lines
                .clone()
                .map(|(_, l)| l)
                .find(|l| !l.trim_ascii().is_empty());
            if next.is_none_or(|n| row_width(n, delimiters).is_some()) {
                let width = widest(line, lines.clone(), delimiters);
                let head: Vec<&[u8]> = head.into_iter().collect();
                return Some(with_header(at, width, &head, delimiters));
            }
        }
        // Only one of several consecutive blank lines is kept.
        if line.is_empty() && head.back().is_some_and(|l| l.is_empty()) {
            continue;
        }
        if head.len() >= HEADER_LINES {
            head.remove(HEADER_LINES / 2);
        }
        head.push_back(line);
    }
    None
}

/// Number of rows that are searched for forces if the first rows contain only a time or a counter.
const EMPTY_ROWS: usize = 20_000;

/// Number of fields of a table. If the first row contains only a time or a counter, its empty fields are included if a later row contains
/// forces.
fn widest(row: &[u8], later: Lines, delimiters: Delimiters) -> usize {
    let width = row_width(row, delimiters).unwrap_or(0);
    let fields = Fields::new(row, delimiters).count();
    if width > 2 || fields <= width + 1 {
        return width;
    }
    let widths = later.take(EMPTY_ROWS);
    let mut widths = widths.map_while(|(_, row)| row_width(row, delimiters));
    if widths.any(|w| w > 2) { fields } else { width }
}

/// Number of fields in a row of numbers; `None` if the line is not such a row.
///
/// A row contains more numbers than words. It starts with a number or a clock time, or it has at least five fields and four times as many
/// numbers as words. The numbered names of sensors, 1 2 3 …, are not a row.
fn row_width(line: &[u8], delimiters: Delimiters) -> Option<usize> {
    let (mut width, mut numbers, mut words, mut count) = (0, 0, 0, 0);
    let mut starts_well = None;
    for f in Fields::new(line, delimiters) {
        count += 1;
        match field(f, delimiters.comma) {
            Field::Number(_) => {
                numbers += 1;
                starts_well.get_or_insert(true);
            }
            Field::Text if starts_well.is_none() && clock(f, delimiters.comma).is_some() => {
                numbers += 1;
                starts_well = Some(true);
            }
            Field::Text => {
                words += 1;
                starts_well.get_or_insert(false);
            }
            Field::Missing if trim(f).is_empty() => continue,
            Field::Missing => (),
        }
        width = count;
    }
    let long = width >= 5 && numbers >= 4 * words;
    let is_row = numbers > words && (starts_well == Some(true) || long);
    let is_named = is_row && are_counted(Fields::new(line, delimiters), delimiters.comma);
    (is_row && !is_named).then_some(width)
}

/// Numbers in the selected columns of a table; NaN where a number is missing.
#[derive(Debug)]
pub(crate) struct Numbers {
    /// One vector per selected column, all of the same length.
    pub columns: Vec<Vec<f64>>,
    /// Numbers of the first lines that were skipped because they are not rows.
    pub skipped: Vec<usize>,
}

/// Reads the selected columns (numbers from 0, ascending) of a table.
///
/// `time` is the index in `places` of a time column, which must not decrease. Equal times are accepted, because times are rounded.
///
/// The memory is limited to a small multiple of the size of the text. It is reserved for at most as many rows as there are line ends.
/// Reading stops with an error at a row that lacks most of its fields.
pub(crate) fn numbers(
    file: &TextFile,
    table: &Table,
    places: &[usize],
    time: Option<usize>,
) -> Result<Numbers> {
    let (bytes, delimiters) = (file.bytes, file.delimiters);
    let body = bytes.get(table.start.offset..).unwrap_or(&[]);
    let mut rows = Rows::new(line_ends(body) + 1, body.len(), places.len(), time);
    let mut row = vec![f64::NAN; places.len()];
    let mut absent = 0usize;
    let mut skipped = Vec::new();
    let mut lines = Lines::from(bytes, table.start);
    loop {
        let here = lines.at;
        if let Some(length) = plain_row(&bytes[here.offset..], delimiters, places, &mut row) {
            rows.push(&row, table)
                .map_err(|e| e.at_line(file.path, here.line))?;
            lines.at = Position {
                offset: here.offset + length,
                line: here.line + 1,
            };
            continue;
        }
        let Some((at, line)) = lines.next() else {
            break;
        };
        let present = chosen_fields(line, delimiters, places, &mut row, time);
        let is_empty = !row.iter().any(|x| x.is_finite());
        if is_empty || time.is_some_and(|t| row[t].is_nan()) {
            let is_row = row_width(line, delimiters).is_some();
            let is_blank = line.trim_ascii().is_empty();
            let goes_on = |n: &[u8]| row_width(n, delimiters).is_some_and(|w| 2 * w > table.width);
            let next = lines.clone().next();
            if !(is_row || is_blank || is_comment(line) || next.is_some_and(|n| goes_on(n.1))) {
                break;
            }
            if !is_blank {
                note_line(&mut skipped, at.line);
            }
            // Without times, a row with empty selected fields is still a sample, because the samples are counted.
            if is_row && time.is_none() && rows.has_room() {
                rows.append(&row);
            }
            continue;
        }
        let is_cut = present < places.len() && !bytes.ends_with(b"\n");
        if is_cut && lines.clone().next().is_none() {
            // The file was truncated within its last row.
            note_line(&mut skipped, at.line);
            break;
        }
        absent += places.len() - present;
        if absent > rows.count() * places.len() / 2 + 64 * places.len().max(8) {
            return Err(ragged(table).at_line(file.path, at.line));
        }
        rows.push(&row, table)
            .map_err(|e| e.at_line(file.path, at.line))?;
    }
    Ok(Numbers {
        columns: rows.columns,
        skipped,
    })
}

/// Number of line ends. For speed, they are counted in 8-bit numbers over short blocks.
fn line_ends(bytes: &[u8]) -> usize {
    let of = |block: &[u8]| block.iter().map(|&b| u8::from(b == b'\n')).sum::<u8>();
    bytes.chunks(128).map(|block| usize::from(of(block))).sum()
}

fn ragged(table: &Table) -> ReadError {
    let fields = table.width;
    ReadError::ShortRows { fields }
}

/// The rows read so far, column by column.
struct Rows {
    columns: Vec<Vec<f64>>,
    /// Maximum number of rows for which memory is reserved.
    room: usize,
    /// Index of the time column, and the time in the previous row.
    time: Option<usize>,
    last: f64,
}

impl Rows {
    /// Reserves memory for at most `most` rows of a text. The size of the text also limits the number of rows, because a field needs at
    /// least one byte.
    fn new(most: usize, bytes: usize, columns: usize, time: Option<usize>) -> Rows {
        let room = most.min(bytes / columns.max(1) + 1);
        Rows {
            columns: (0..columns).map(|_| Vec::with_capacity(room)).collect(),
            room,
            time,
            last: f64::NEG_INFINITY,
        }
    }

    fn count(&self) -> usize {
        self.columns[0].len()
    }

    fn has_room(&self) -> bool {
        self.count() < self.room
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// The time of the row is below that of the previous row.
    #[inline]
    fn push(&mut self, row: &[f64], table: &Table) -> std::result::Result<(), ReadError> {
        if !self.has_room() {
            return Err(ragged(table));
        }
        if let Some(t) = self.time {
            if row[t] < self.last {
                let (time, after) = (row[t], self.last);
                return Err(ReadError::TimeBackwards { time, after });
            }
            self.last = row[t];
        }
        self.append(row);
        Ok(())
    }

    #[inline]
    fn append(&mut self, row: &[f64]) {
        for (column, x) in self.columns.iter_mut().zip(row) {
            column.push(*x);
        }
    }
}

/// Skips a table without reading its numbers. Returns the position after the table.
pub(crate) fn skip(file: &TextFile, table: &Table) -> Position {
    let mut lines = Lines::from(file.bytes, table.start);
    let mut end = table.start;
    while let Some((_, line)) = lines.next() {
        if row_width(line, file.delimiters).is_none() && !line.trim_ascii().is_empty() {
            break;
        }
        end = lines.at;
    }
    end
}

fn note_line(lines: &mut Vec<usize>, line: usize) {
    if lines.len() < 8 {
        lines.push(line);
    }
}

fn is_comment(line: &[u8]) -> bool {
    matches!(line.trim_ascii(), [b'#' | b'%' | b'!' | b'/', ..])
}

/// Fills `row` with the selected fields of a line. Returns the number of fields in the line.
#[inline]
fn chosen_fields(
    line: &[u8],
    delimiters: Delimiters,
    places: &[usize],
    row: &mut [f64],
    time: Option<usize>,
) -> usize {
    row.fill(f64::NAN);
    let mut next = 0;
    for (i, f) in Fields::new(line, delimiters).enumerate() {
        if places.get(next) != Some(&i) {
            if next >= places.len() {
                break;
            }
            continue;
        }
        row[next] = value(f, delimiters.comma);
        if time == Some(next) && row[next].is_nan() {
            row[next] = clock(f, delimiters.comma).unwrap_or(f64::NAN);
        }
        next += 1;
    }
    next
}

#[cfg(test)]
mod tests {
    use super::super::delimited::detect;
    use super::*;
    use crate::recording::ReadOptions;
    use std::path::Path;

    fn table(t: &str) -> Table {
        let delimiters = detect(t.as_bytes());
        next_table(t.as_bytes(), delimiters, Position::START).unwrap()
    }

    #[test]
    fn names_units_and_key_lines_are_told_apart() {
        let t =
            table("Abtastrate [Hz];1000\nGewicht [kg];56,8\n\nZeit;Fz\ns;N\n0,0;1,5\n0,1;2,5\n");
        assert_eq!(t.names, ["Zeit", "Fz"]);
        assert_eq!(t.units, ["s", "N"]);
        assert_eq!(t.head[1], "Gewicht [kg];56,8");
        assert_eq!(t.start.line, 6);
    }

    #[test]
    fn group_rows_are_joined_to_the_names_below_them() {
        let t = table(
            "Devices\n1000\n,,Plate 1 - Force,,,Plate 1 - Moment,,\nFrame,Sub Frame,Fx,Fy,Fz,Mx,My,Mz\n,,N,N,N,N.mm,N.mm,N.mm\n1,0,1,2,3,4,5,6\n1,1,1,2,3,4,5,6\n",
        );
        assert_eq!(t.names[4], "Plate 1 - Force Fz");
        assert_eq!(t.names[5], "Plate 1 - Moment Mx");
        assert_eq!(t.head, ["Devices", "1000"]);
        let t = table(
            "\tw.c3d\tw.c3d\tw.c3d\n\tFP1\tFP1\tFP1\n\tFORCE\tFORCE\tFORCE\nITEM\tX\tY\tZ\n1\t0\t0\t5\n2\t0\t0\t6\n",
        );
        assert_eq!(t.names[3], "w.c3d FP1 FORCE Z");
    }

    #[test]
    fn padded_opensim_headers_leave_only_the_names() {
        let t = table(
            "my walk\t\t\nversion=1\t\t\nendheader\t\t\ntime\t   vx\t  vy\n0\t1\t2\n0.1\t1\t2\n",
        );
        assert_eq!(t.names, ["time", "vx", "vy"]);
        assert_eq!(t.head.len(), 3);
    }

    #[test]
    fn time_that_falls_is_refused_by_line() {
        let text = b"time,f\n0.0,1\n0.2,2\n0.1,3\n";
        let options = ReadOptions::default();
        let file = TextFile::new(Path::new("a.csv"), text, &options);
        let t = next_table(text, file.delimiters, Position::START).unwrap();
        let e = numbers(&file, &t, &[0, 1], Some(0)).unwrap_err();
        assert!(
            e.to_string().starts_with("a.csv line 4: time decreases"),
            "{e}"
        );
    }

    #[test]
    fn a_last_row_that_was_cut_is_left_out() {
        for (end, kept) in [("0.1", 2), ("0.1\n", 2), ("0.21,3", 3), ("0.3,", 3)] {
            let text = format!("time,f\n0.0,1\n0.2,2\n{end}");
            let options = ReadOptions::default();
            let file = TextFile::new(Path::new("a.csv"), text.as_bytes(), &options);
            let t = next_table(text.as_bytes(), file.delimiters, Position::START).unwrap();
            let read = numbers(&file, &t, &[0, 1], Some(0));
            match end.ends_with('\n') {
                // A whole row with an earlier time is not the end of a file that was cut.
                true => assert!(read.is_err()),
                false => assert_eq!(read.unwrap().columns[0].len(), kept, "{end}"),
            }
        }
    }

    #[test]
    fn blanks_words_and_clock_times_inside_the_data_are_borne() {
        let text = b"time;f\n00:00,0;1\n00:00,1;\n00:00,2;--\nPause\n00:00,3;4\n";
        let options = ReadOptions::default();
        let file = TextFile::new(Path::new("a"), text, &options);
        let t = next_table(text, file.delimiters, Position::START).unwrap();
        let n = numbers(&file, &t, &[0, 1], Some(0)).unwrap();
        assert_eq!(n.columns[0], [0.0, 0.1, 0.2, 0.3]);
        assert!(n.columns[1][1].is_nan() && n.columns[1][2].is_nan());
        assert_eq!(n.skipped, [5]);
    }
}
