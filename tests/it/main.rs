//! The library against closed forms, tables and independent routes.

mod cam_geometry;
mod cams;
mod certificate;
mod first_rung;
mod fuzz_readers;
mod gait_c3d;
mod gait_cycle;
mod gait_laboratories;
mod gait_layouts;
mod gait_models;
mod laws;
mod layering;
mod loads;
mod machine;
mod pair;
mod polydyne;
mod programmes;
mod put_back;
mod random_cams;
mod random_scenes;
mod refused_cams;
mod relaxations;
mod support;
mod targets;
