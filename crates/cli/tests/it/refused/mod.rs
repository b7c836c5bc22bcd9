//! What cannot be: named with its place and with what would work.

mod cams;
mod input;
mod no_cam;
