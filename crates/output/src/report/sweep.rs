//! `report.html` of a sweep: what was tried, what is best, pictures; one page that opens offline.

use std::fmt::Write;

use crate::escape::escaped;
use crate::plot::picture::Picture;

const STYLE: &str = include_str!("page.css");

/// A table of the report: head and rows of text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// Names of the columns.
    pub head: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
}

/// What the page shows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Page<'a> {
    /// Headline.
    pub title: String,
    /// What was done, in one or two sentences.
    pub words: String,
    /// Figures one looks for first: name, value, remark.
    pub cards: Vec<(String, String, String)>,
    /// Pictures with their headings.
    pub pictures: Vec<(&'a str, &'a Picture)>,
    /// Tables with their headings.
    pub tables: Vec<(&'a str, Table)>,
}

/// The page.
pub fn html(page: &Page) -> String {
    let title = escaped(&page.title);
    let mut out = String::with_capacity(1 << 16);
    // Writing to a String cannot fail, here and below.
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><div><h1>{title}</h1>\n<p>{}</p></div></header>\n<dl class=\"cards\">\n",
        escaped(&page.words)
    );
    for (name, value, remark) in &page.cards {
        let _ = writeln!(
            out,
            "<div><dt>{}</dt><dd>{}<small>{}</small></dd></div>",
            escaped(name),
            escaped(value),
            escaped(remark)
        );
    }
    out.push_str("</dl>\n");
    for (i, (heading, picture)) in page.pictures.iter().enumerate() {
        let drawing = picture.svg_for_page(&format!("picture{i}"), heading, "");
        let _ = writeln!(
            out,
            "<h2>{}</h2>\n<figure>{drawing}</figure>",
            escaped(heading)
        );
    }
    for (heading, table) in &page.tables {
        let _ = writeln!(
            out,
            "<h2>{}</h2>\n<div class=\"scroll\"><table>\n<tr>",
            escaped(heading)
        );
        for cell in &table.head {
            let _ = write!(out, "<th class=\"n\">{}</th>", escaped(cell));
        }
        out.push_str("</tr>\n");
        for row in &table.rows {
            out.push_str("<tr>");
            for cell in row {
                let _ = write!(out, "<td class=\"n\">{}</td>", escaped(cell));
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</table></div>\n");
    }
    out.push_str("<footer>SI units. Every number belongs to the continuous law, not to samples.</footer>\n</body>\n</html>\n");
    out
}
