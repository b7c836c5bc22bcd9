//! Laws of motion and programmes of segments.

mod formulas;
mod programmes;
mod tables;
