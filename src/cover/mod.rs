//! Several cams for many walkers, and the assignment of the walkers. From several starts, every cam is designed for its walkers, then every walker is
//! assigned to the best cam, until the assignment is stable (Lloyd, 1982). If only the worst walkers of all count, each cam counts only its own
//! walkers among them. The result need not be optimal; `bound` gives a lower bound.

mod alternation;
mod bound;
mod covers;
mod folds;
mod people;
mod served;

pub use covers::{Cover, covers};
pub use folds::{Fold, folds};
pub use served::{Assigned, served_by};
