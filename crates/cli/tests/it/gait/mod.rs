//! Recordings: cycles, doubts, and questions to the user.

mod cover;
mod doubts;
mod open;
mod plates;
mod trials;
mod writes;
