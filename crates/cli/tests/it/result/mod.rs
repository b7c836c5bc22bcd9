//! Reuse of results: other speeds, comparison with a measured cam and with each other.

mod as_made;
mod ecam;
mod front_and_compare;
mod identify;
mod inspect;
mod walk;
