//! The studio from outside: over its socket, as a browser or an attacker meets it.

mod answers;
mod client;
mod security;
mod words;
