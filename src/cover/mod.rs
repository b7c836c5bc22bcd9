//! Several cams for many walkers: which cams, and which cam each walker gets.
//!
//! Cams and walkers are sought in turn from several starts: every cam is the design for its walkers, then every walker goes to
//! the cam that serves him best, until nobody changes (Lloyd, 1982). Where the worst part of all walkers counts, every cam counts
//! of its own walkers the part that belongs to it. What is found need not be the best; `bound` says how far it can be
//! from it.

mod alternation;
mod bound;
mod covers;
mod folds;
mod people;
mod served;

pub use covers::{Cover, covers};
pub use folds::{Fold, folds};
pub use served::{Assigned, served_by};
