//! Bindings of the Python package `gaitcam` to the library and to the crates `gaitcam-app` and `gaitcam-output`. The command uses the same crates.

#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod asked;
mod convert;
mod cover;
mod design;
mod doctor;
mod error;
mod force;
mod front;
mod html;
mod interrupt;
mod law;
mod made;
mod scene;
mod sweep;
mod synth;
mod table;

// These crates are used only to enable their features (see Cargo.toml).
#[cfg(target_os = "linux")]
use {getrandom as _, libc as _, rustix as _, serde_core as _};

use pyo3::prelude::*;

#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::cover::cover;
    #[pymodule_export]
    use crate::design::Design;
    #[pymodule_export]
    use crate::doctor::doctor;
    #[pymodule_export]
    use crate::error::{InputError, NoSuchCam};
    #[pymodule_export]
    use crate::force::{Force, read_gait};
    #[pymodule_export]
    use crate::front::{Front, front};
    #[pymodule_export]
    use crate::law::{Law, laws, program};
    #[pymodule_export]
    use crate::made::inspect::inspect;
    #[pymodule_export]
    use crate::made::logs::{identify, recut};
    #[pymodule_export]
    use crate::made::run::{Run, simulate};
    #[pymodule_export]
    use crate::scene::{Scene, keys};
    #[pymodule_export]
    use crate::sweep::Sweep;
    #[pymodule_export]
    use crate::synth::synth;
    #[pymodule_export]
    use crate::table::Table;

    use pyo3::prelude::*;

    /// Causes a panic on a separate thread, to test the conversion of panics to exceptions.
    #[pyfunction]
    fn _panic(py: Python<'_>) {
        py.detach(|| {
            std::thread::scope(|scope| {
                scope.spawn(|| panic!("on purpose"));
            });
        });
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("InternalError", crate::error::internal(module.py())?)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
