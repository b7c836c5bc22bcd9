//! `report.html` of a sweep: parameters, best designs and figures on one page, which needs no network connection.

use std::fmt::Write;

use super::{Card, cards, figures, head, heading, paragraph, tables};
use crate::plot::picture::Picture;
use crate::words;
use gaitcam::wording::Language;
use gaitcam_base::text::escaped;

/// Table of the report: column names, and rows of text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// Names of the columns.
    pub head: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
}

/// Contents of the report page.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Page<'a> {
    /// Title of the page.
    pub title: String,
    /// Description of the sweep, in one or two sentences.
    pub words: String,
    /// Key figures: name, value, remark.
    pub cards: Vec<Card>,
    /// Figures with their headings.
    pub pictures: Vec<(&'a str, &'a Picture)>,
    /// Tables with their headings.
    pub tables: Vec<(String, Table)>,
}

/// HTML text of the report page.
pub fn html(page: &Page, language: Language) -> String {
    let words = words::words(language);
    let mut out = String::with_capacity(1 << 16);
    head(&mut out, &page.title, &words);
    // Writing to a String cannot fail, here and below.
    let _ = writeln!(
        out,
        "<header><div><h1>{}</h1>\n<p>{}</p></div></header>\n<main>",
        escaped(&page.title),
        escaped(&page.words)
    );
    cards(&mut out, &page.cards);
    for (i, (name, picture)) in page.pictures.iter().enumerate() {
        heading(&mut out, name);
        let id = format!("picture{i}");
        figures::figure(&mut out, &id, None, name, picture, &words);
    }
    for (name, rows) in &page.tables {
        heading(&mut out, name);
        table(&mut out, rows);
    }
    out.push_str("</main>\n<footer>\n");
    paragraph(&mut out, &words.text("report-footer-sweep"));
    out.push_str("</footer>\n</body>\n</html>\n");
    out
}

fn table(out: &mut String, table: &Table) {
    tables::open(out, &table.head, 0);
    for row in &table.rows {
        out.push_str("<tr>");
        tables::cells(out, row);
    }
    tables::close(out);
}
