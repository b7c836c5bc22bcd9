//! Foundations shared by the crates of gaitcam.
//!
//! - [`error`]: errors in the input, each with its location, its data and a code for programs;
//! - [`units`]: quantities with units as users write them, `"3 in"` or `"30 psi/in^3"`;
//! - [`wording`]: messages in English and Spanish, from codes and data;
//! - [`text`]: formatting of numbers and text in files and pages;
//! - [`halt`]: stop condition of a computation;
//! - [`random`]: pseudo-random numbers that are the same on every machine;
//! - [`threads`]: start of threads on systems that may reject them.
//!
//! ```
//! use gaitcam_base::units::{Dimension, parse};
//! use gaitcam_base::wording::Language;
//!
//! let error = parse("3 parsec", Dimension::Length).unwrap_err();
//! assert_eq!(error.code(), "units-unknown-unit");
//! assert_eq!(error.sentence(Language::Es).split(';').next(), Some("unidad desconocida «parsec»"));
//! ```
#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![deny(clippy::missing_errors_doc)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

pub mod error;
pub mod halt;
mod quantity;
pub mod random;
pub mod text;
pub mod threads;
pub mod units;
pub mod wording;

/// Compiles and runs the program in the README as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
