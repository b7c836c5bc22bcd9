//! What is written, read back by other readers.

mod designs;
mod drawings;
mod emit;
