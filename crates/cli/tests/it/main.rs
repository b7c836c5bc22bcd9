//! The command as users call it: files, messages, exit codes.

mod all_scenes;
mod as_made;
mod explain;
mod folder;
mod foreign;
mod front_and_compare;
mod gait;
mod input_and_output;
mod inspect;
mod main_job;
mod motion_file;
mod polish;
mod refused;
mod support;
mod sweep;
mod verdicts;
mod wording;
