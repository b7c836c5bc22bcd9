//! Recordings: what is made of them, what is doubted, what is asked first.

mod cover;
mod doubts;
mod open;
mod plates;
mod trials;
mod writes;
