//! Markdown of the reports.

use std::fmt::Write;

/// Markdown table with a head and rows.
pub(crate) fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let rule = "---|".repeat(head.len());
    let mut out = format!("| {} |\n|{rule}\n", head.join(" | "));
    for row in rows {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "| {} |", row.join(" | "));
    }
    out
}

/// Duration with a suitable unit.
pub(crate) fn duration(seconds: f64) -> String {
    if seconds < 1e-6 {
        format!("{:.0} ns", 1e9 * seconds)
    } else if seconds < 1e-3 {
        format!("{:.1} µs", 1e6 * seconds)
    } else if seconds < 1.0 {
        format!("{:.2} ms", 1e3 * seconds)
    } else {
        format!("{seconds:.2} s")
    }
}
