//! Console tables. A column is as wide as its longest cell.

/// Alignment of the text in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Aligned to the left, for names and text.
    Left,
    /// Aligned to the right, for numbers.
    Right,
}

/// Table with aligned columns from rows of equal length. `sides` contains the alignment of each column. Its last element also applies to
/// all further columns.
pub fn table(rows: &[Vec<String>], sides: &[Side]) -> String {
    let count = rows.first().map_or(0, Vec::len);
    let long = |text: &String| text.chars().count();
    let widths: Vec<usize> = (0..count)
        .map(|k| rows.iter().map(|row| long(&row[k])).max().unwrap_or(0))
        .collect();
    let cell = |(k, text): (usize, &String)| {
        let width = widths[k];
        match sides.get(k).or(sides.last()) {
            Some(Side::Right) => format!("  {text:>width$}"),
            _ => format!("  {text:<width$}"),
        }
    };
    let line = |row: &Vec<String>| -> String { row.iter().enumerate().map(cell).collect() };
    let lines = rows.iter().map(|row| line(row).trim_end().to_string());
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_longest_cell_and_lines_end_with_text() {
        let rows = [["", "α", "ω"], ["stroke", "20 mm", ""]];
        let rows = rows.map(|row| row.map(String::from).to_vec());
        let text = table(&rows, &[Side::Left, Side::Right]);
        assert_eq!(text, "              α  ω\n  stroke  20 mm");
    }
}
