//! What is written, read back by readers that did not write it.

mod cutter;
mod drawing;
mod drawings;
mod ecam;
mod machining;
mod odd_designs;
mod outline;
mod sheets;
mod solids;
mod words;
mod workshop;
