//! The command as users call it: files, messages, exit codes.

mod all_scenes;
mod bad_cams;
mod bad_input;
mod explain;
mod folder;
mod front_and_compare;
mod gait_command;
mod gait_doubts;
mod gait_trials;
mod guidance;
mod input_and_output;
mod inspect_command;
mod language;
mod main_job;
mod open_recordings;
mod polish;
mod sweep;
mod verdicts;
mod words;
