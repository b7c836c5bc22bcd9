//! Optima and certificates compared with closed forms and independent computation.

mod certificate;
mod certificate_prices;
mod optima;
mod rms;
mod rms_limit;
