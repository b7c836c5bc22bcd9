//! Files that are written are read back by independent readers.

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
