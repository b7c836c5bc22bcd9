//! OpenSim tables whose cells are vectors: `DataType=Vec3`, with three numbers separated by commas in each cell.

use super::delimited::{Lines, text};

/// Number of bytes of the header that are examined.
const HEAD: usize = 1 << 14;
/// Names of the components of a vector.
const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// The table with one column per component of each vector; `None` for other texts.
///
/// `ground_force_r_v` becomes `ground_force_r_vx`, `ground_force_r_vy`, `ground_force_r_vz`. Other names receive the suffixes `_x`, `_y`,
/// `_z`.
pub(super) fn flattened(bytes: &[u8]) -> Option<Vec<u8>> {
    let head = text(&bytes[..bytes.len().min(HEAD)]);
    let mut keys = head
        .lines()
        .take_while(|line| !line.trim().eq_ignore_ascii_case("endheader"));
    keys.find(|line| line.replace(' ', "").eq_ignore_ascii_case("datatype=vec3"))?;
    let mut lines = Lines::new(bytes);
    lines.find(|(_, line)| line.trim_ascii().eq_ignore_ascii_case(b"endheader"))?;
    let mut flat = bytes[..lines.at.offset].to_vec();
    let (_, names) = lines.next()?;
    let names = text(names);
    let mut names = names.trim_end().split('\t');
    flat.extend(names.next()?.bytes());
    for name in names {
        let is_short = ["_v", "_p", "_f", "_m"]
            .iter()
            .any(|end| name.ends_with(end));
        let joint = if is_short { "" } else { "_" };
        for component in COMPONENTS {
            flat.extend(format!("\t{name}{joint}{component}").bytes());
        }
    }
    flat.push(b'\n');
    for (_, line) in lines {
        flat.extend(line.iter().map(|&b| if b == b',' { b'\t' } else { b }));
        flat.push(b'\n');
    }
    Some(flat)
}
