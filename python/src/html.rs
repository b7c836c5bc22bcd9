//! HTML output for notebooks.

use gaitcam_base::text::escaped;

/// Maximum number of displayed rows of a table, half from each end.
const SHOWN: usize = 10;

/// A name with its description.
pub fn head(name: &str, said: &str) -> String {
    format!("<p><b>{}</b>: {}</p>", escaped(name), escaped(said))
}

/// Preformatted text as HTML.
pub fn fixed(text: &str) -> String {
    format!("<pre>{}</pre>", escaped(text))
}

/// HTML table of the first and the last of `count` rows with their column names.
pub fn table(names: &[String], count: usize, cells: impl Fn(usize) -> Vec<String>) -> String {
    let line = |tag: &str, cells: &[String]| {
        let cells = cells
            .iter()
            .map(|c| format!("<{tag}>{}</{tag}>", escaped(c)));
        format!("<tr>{}</tr>", cells.collect::<String>())
    };
    let rows = |rows: std::ops::Range<usize>| -> String {
        rows.map(|row| line("td", &cells(row))).collect()
    };
    let body = match count > SHOWN {
        true => {
            let gap = line("td", &vec!["…".to_string(); names.len()]);
            rows(0..SHOWN / 2) + &gap + &rows(count - SHOWN / 2..count)
        }
        false => rows(0..count),
    };
    format!("<table>{}{body}</table>", line("th", names))
}
