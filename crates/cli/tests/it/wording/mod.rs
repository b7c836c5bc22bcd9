//! Texts of the command: language, units, guidance for new users.

mod guidance;
mod spanish;
mod units;
