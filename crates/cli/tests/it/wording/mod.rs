//! What is said: in which language, in which unit, and to lead a newcomer.

mod guidance;
mod spanish;
mod units;
