//! Tests of the studio over its socket, as a browser or an attacker would use it.

mod answers;
mod client;
mod security;
mod words;
