//! The papers' numbers, the methods that fail, the restitution of a compliant contact.

mod equality;
mod reproduce;
mod restitution;
mod stability;
mod twins;
