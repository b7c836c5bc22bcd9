//! Rejected input: messages with the place and a correction.

mod cams;
mod input;
mod no_cam;
