//! gaitcam: design of cams that reproduce a given force, such as the vertical force of a person walking.
//!
//! # The problem
//!
//! A machine has to reproduce the force of a walker on the ground. A cam with the angle θ = ωt lifts a follower by s(θ). With v = ds/dθ and
//! a = d²s/dθ², the force is a linear function of the law (Campillo de Blas 2017, eq. 22; Vargas and León 2024, eq. 3):
//!
//! ```text
//! F(θ) = F₀ + k·s + c·ω·v + m·ω²·a
//! ```
//!
//! Here F₀ is the static force at zero lift, k the stiffness, c the damping coefficient, m the moved mass and ω the cam speed. The problem
//! is to find the law s with the minimum difference between F and a measured force F*, and the cam with this law:
//!
//! ```text
//! minimise    (1/2π) ∮ (F − F*)² dθ          or the energy, or the peak, of a derivative, or the cam's size
//! subject to  s, v, a, j at given angles      equalities: points, dwells
//!             Σ wₖ s⁽ᵏ⁾(θ) ≤ bound, all θ      stroke, speed, acceleration, jerk, contact, flat-face curvature
//!             v − e ≤ tan φ·(s + D), all θ     pressure angle, with Rp ≥ ‖(D, e)‖ a second-order cone
//!             ρ(s, v, a, D, e) ≥ ρ_min, all θ  roller curvature: a sequence of the above
//! ```
//!
//! The jerk is j = d³s/dθ³, and wₖ are the weights of the derivatives s⁽ᵏ⁾ in a limit. Rp is the prime radius, and e is the offset of the
//! follower. D is the height of the prime circle above the cam centre, on the line of the follower. The maximum pressure angle is φ, and ρ
//! is the radius of curvature of the profile.
//!
//! # Example
//!
//! ```
//! use gaitcam::scene::{CamSpec, Gait};
//! use gaitcam::{LimitKind, Scene};
//! use gaitcam::scene::Limits;
//!
//! let scene = Scene {
//!     gait: Some(Gait { step_frequency: Some(1.85), body_weight: Some(700.0), ..Gait::model("young") }),
//!     cam: CamSpec { bore: Some(0.012), ..CamSpec::default() },
//!     limits: Limits::default().with(LimitKind::Curvature, 0.005),
//!     rms: Some(0.005),
//!     ..Scene::default()
//! };
//! let design = scene.design()?;
//!
//! assert!(design.force.rms_error_percent_of_mean <= 0.5);
//! assert!((design.cam.law.stroke() - 0.0492).abs() < 0.0002);
//! assert!(design.checks.iter().all(|check| check.pass));
//! let contact = design.cam.point(1.0); // where cam and follower touch at θ = 1 rad
//! assert!(contact.rho > 0.005);
//! # Ok::<(), gaitcam::error::Error>(())
//! ```
//!
//! # The modules
//!
//! [`force`] reads the given force. [`law`] describes the law of motion, and [`drive`] describes the relation between motion and force.
//! [`synth`] computes the law that produces the given force. [`cam`] describes the cam that produces the law, and checks it. [`dynamics`]
//! simulates the cam. The crate `gaitcam-output` writes the files. Each module imports only modules of lower layers.
#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![deny(clippy::missing_errors_doc)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

/// Lets the unit tests use this crate by its name `gaitcam`. They share files with `gaitcam-test-support`, which depends on this crate.
#[cfg(test)]
extern crate self as gaitcam;

pub mod criterion;
pub mod wording;

pub mod error;

pub use splineqp::poly;

pub mod law;

pub mod drive;

pub mod cam;

pub mod dynamics;

pub mod scene;

pub mod problem;

pub mod synth;

pub mod cover;

pub mod identify;

pub mod sweep;

pub use criterion::LimitKind;
pub use gaitcam_base::{halt, units};
pub use gaitcam_gait::{self as force, ForceCurve};
pub use problem::Problem;
pub use scene::Scene;

/// Compiles and runs the program in the README as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
