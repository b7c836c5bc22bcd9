//! Scene files: templates with comments, and lists of all faults.

pub mod doctor;
pub mod init;
