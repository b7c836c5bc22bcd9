//! The papers' numbers, and the methods that fail.

mod reproduce;
mod stability;
