//! The papers' numbers, the methods that fail, the restitution of a compliant contact.

mod equality_by_faer;
mod reproduce;
mod restitution;
mod stability;
mod twins;
