//! Certificates and the laws that they belong to.

mod certificate;
mod coefficients;
mod witness;
