//! What is written, read back by other readers.

mod designs;
mod drawing;
mod drawings;
mod emit;
mod machining;
mod sheets;
mod words;
mod workshop;
