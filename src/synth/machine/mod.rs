//! Laws corrected for the machine: for a follower that gives, for a shaft whose speed varies, for a floor that moves. Each
//! designs for a rigid machine at constant speed, runs it, and designs again for what that says.

mod added;
pub mod on_machine;
pub mod polydyne;
mod runner;
pub mod sensitivity;
