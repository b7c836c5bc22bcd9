//! Optima and certificates against closed forms and independent computation.

mod certificate;
mod optima;
mod rms;
mod rms_limit;
