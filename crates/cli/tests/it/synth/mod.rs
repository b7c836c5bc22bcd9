//! `gaitcam synth`: built-in scenes, motions from files, verdicts, and the meaning of the stated accuracy.

mod all_scenes;
mod explain;
mod main_job;
mod motion_file;
mod motor_file;
#[cfg(target_os = "linux")]
mod time_limit;
mod verdicts;
