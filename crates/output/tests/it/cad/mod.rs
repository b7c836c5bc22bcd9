//! Files for machines: outlines, solids, cutter paths.

mod cutter;
mod outline;
mod solids;
