//! What a text file is called in front of people.

use std::path::Path;

use super::layout::{Layout, Separator};
use super::table::Table;

/// The name of a format, from its header and the shape of its table.
pub(super) fn format_name(path: &Path, layout: Layout, table: &Table, head: &[String]) -> String {
    let says = |what: &str| head.iter().any(|l| l.to_lowercase().contains(what));
    let starts = |what: &str| head.iter().any(|l| l.to_lowercase().starts_with(what));
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or("")
        .to_lowercase();
    if starts("endheader") {
        let age = if starts("datacolumns") || starts("datarows") {
            "old"
        } else {
            "new"
        };
        return format!("OpenSim storage, {age} header");
    }
    if says("[force data]") {
        return "force data with key lines (.forces)".to_string();
    }
    if starts("devices") && table.names.iter().any(|n| n.to_lowercase().contains("sub")) {
        return "Nexus device export".to_string();
    }
    if says("insoles") {
        return "insole text export".to_string();
    }
    if says("bioware") {
        return "BioWare text export".to_string();
    }
    if starts("no_of_") || starts("force_plate") {
        return "Qualisys text export".to_string();
    }
    if table.names.is_empty() {
        if extension == "asc" && layout.separator == Separator::Byte(b',') {
            return "AMTI text without header".to_string();
        }
        return format!("{} without header", layout.describe());
    }
    layout.describe()
}
