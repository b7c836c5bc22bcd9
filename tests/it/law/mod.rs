//! Laws of motion and programmes of segments.

mod programmes;
mod tables;
