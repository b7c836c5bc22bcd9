//! Scene files: templates with explanations, and lists of all faults.

pub mod doctor;
pub mod init;
