//! Reading recordings, their mean cycle, and the load models.

mod c3d;
mod cycle;
mod damaged_files;
mod laboratories;
mod layouts;
mod models;
