//! Scene files: a commented start, and every fault at once.

pub mod doctor;
pub mod init;
