//! Numbers of the papers, numerical stability, restitution of a compliant contact, limit on the diameter.

mod diameter;
mod equality;
mod reproduce;
mod restitution;
mod stability;
mod twins;
