//! Scene files: a commented template, and a list of all faults.

pub mod doctor;
pub mod init;
