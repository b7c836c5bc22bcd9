//! HTML representation of objects in notebooks.

use gaitcam_base::text::escaped;

/// Maximum number of displayed rows of a table. One half is from the start of the table, the other half from its end.
const SHOWN: usize = 10;

/// HTML paragraph with a name in bold and its description.
pub fn head(name: &str, said: &str) -> String {
    format!("<p><b>{}</b>: {}</p>", escaped(name), escaped(said))
}

/// HTML block with preformatted text.
pub fn fixed(text: &str) -> String {
    format!("<pre>{}</pre>", escaped(text))
}

/// HTML table with column names and the first and last rows. `count` is the number of all rows. `cells` returns the cells of a row.
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
