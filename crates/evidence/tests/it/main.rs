//! The papers' numbers, the methods that fail, the restitution of a compliant contact.

mod reproduce;
mod restitution;
mod stability;
mod twins;
