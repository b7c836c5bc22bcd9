//! Tables of the stances and strides of a recording.

use gaitcam::force::{Foot, StepRow};
use gaitcam::sweep::{Field, Records};

use crate::table::Table;

/// Table with the columns of `gaitcam gait --stances FILE`. `used` is 1 or 0. A missing number is NaN. A missing text is `None`.
pub fn table(rows: &[StepRow<'_>]) -> Table {
    let number = |name: &str, of: &dyn Fn(&StepRow<'_>) -> Option<f64>| {
        let values = rows.iter().map(|row| of(row).unwrap_or(f64::NAN));
        Field::numbers(name, values.collect())
    };
    let fields = vec![
        Field::words("column", rows.iter().map(|r| r.column)),
        Field::words("foot", rows.iter().map(|r| r.foot.map_or("", Foot::name))),
        number("start_s", &|r| Some(r.start_s)),
        number("end_s", &|r| Some(r.end_s)),
        number("p1_n", &|r| r.p1_n),
        number("valley_n", &|r| r.valley_n),
        number("p2_n", &|r| r.p2_n),
        number("impulse", &|r| r.impulse_ns),
        number("used", &|r| Some(f64::from(u8::from(r.used)))),
        Field::words("why", rows.iter().map(|r| r.why)),
    ];
    Table::new(Records { fields }, Vec::new())
}
