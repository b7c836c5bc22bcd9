//! Several cams for many walkers, and the assignment of walkers. From several starts, every cam is designed for its walkers, then every walker is
//! assigned to the best cam, until the assignment is stable (Lloyd, 1982). If the objective counts only the worst part of all walkers, each
//! cam counts only its own walkers in that part. The result need not be optimal; `bound` gives a lower bound.

mod alternation;
mod bound;
mod covers;
mod folds;
mod people;
mod served;

pub use covers::{Cover, covers};
pub use folds::{Fold, folds};
pub use served::{Assigned, served_by};
