//! Several cams for many walkers, and the assignment of the walkers.
//!
//! From several starts, two steps alternate until the assignment is stable (Lloyd, 1982). First, every cam is designed for its walkers.
//! Then, every walker is assigned to the cam with the minimum error. If the objective counts only the worst walkers, the design of a cam
//! counts only its walkers that are among the worst of all walkers. The result need not be optimal. `bound` computes a lower bound.

mod alternation;
mod bound;
mod covers;
mod folds;
mod people;
mod served;

pub use covers::{Cover, covers};
pub use folds::{Fold, folds};
pub use served::{Assigned, served_by};
