//! Tables of a sweep: columns, rows and CSV output.

mod csv;
pub(super) mod records;
pub(super) mod results;

pub use gaitcam_base::text::{cell_text, text_cell};

/// Suffixes of column names, each with its unit.
const UNITS: [(&str, &str); 18] = [
    ("_m_per_s3", "m/s^3"),
    ("_m_per_s2", "m/s^2"),
    ("_pa_per_m3", "Pa/m^3"),
    ("_n_s_per_m", "N s/m"),
    ("_n_m_per_rad", "N m/rad"),
    ("_n_per_m", "N/m"),
    ("_rad_per_s", "rad/s"),
    ("_m_per_s", "m/s"),
    ("_percent", "%"),
    ("_n_m", "N m"),
    ("_pa", "Pa"),
    ("_hz", "Hz"),
    ("_kg", "kg"),
    ("_rad", "rad"),
    ("_n", "N"),
    ("_w", "W"),
    ("_m", "m"),
    ("_s", "s"),
];

fn unit_entry(column: &str) -> Option<(&'static str, &'static str)> {
    UNITS.into_iter().find(|u| column.ends_with(u.0))
}

/// Unit that the suffix of a column name denotes; empty for words, whole numbers and ratios.
pub(crate) fn unit_of(column: &str) -> &'static str {
    unit_entry(column).map_or("", |u| u.1)
}

/// Name of a column for display, with its unit, such as `limits.stroke, m`.
pub fn label(column: &str) -> String {
    let (ending, unit) = unit_entry(column).unwrap_or(("", ""));
    let name = column.strip_suffix(ending).unwrap_or(column);
    let name = name.replace('_', " ");
    if unit.is_empty() {
        return name;
    }
    format!("{name}, {}", unit.replace("^2", "²").replace("^3", "³"))
}
