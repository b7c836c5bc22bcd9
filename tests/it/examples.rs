//! Every example finishes without an error.

#[path = "../../examples/custom_force.rs"]
mod custom_force;
#[path = "../../examples/programme.rs"]
mod programme;
#[path = "../../examples/simulate.rs"]
mod simulate;
#[path = "../../examples/sweep.rs"]
mod sweep;

#[test]
fn a_force_given_as_numbers_becomes_a_cam() {
    custom_force::main().unwrap();
}

#[test]
fn a_programme_becomes_a_cam_and_is_checked() {
    programme::main().unwrap();
}

#[test]
fn a_grid_of_scenes_is_designed_in_parallel() {
    sweep::main().unwrap();
}

#[test]
fn the_emitted_cam_runs() {
    simulate::main().unwrap();
}
