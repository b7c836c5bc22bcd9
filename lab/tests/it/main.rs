//! Numbers of the papers, numerical stability, restitution of a compliant contact.

mod equality;
mod reproduce;
mod restitution;
mod stability;
mod twins;
