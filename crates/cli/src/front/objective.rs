//! What is minimised or maximised: a column, and the sense in which it counts.

use crate::input::at_flag;
use crate::words;
use gaitcam::error::Result;
use gaitcam::sweep::objective;
use gaitcam_output::sweep_plots::unit_for_people;

/// Minimised when nothing is said.
const USUAL: &str = "force_error,prime_radius";

/// A column that designs are compared by.
#[derive(Debug, Clone)]
pub struct Objective {
    /// Its place in the table.
    pub column: usize,
    /// Its name.
    pub name: String,
    /// Whether the larger is the better.
    pub maximised: bool,
}

impl Objective {
    /// Those that both flags name; the usual ones where neither is given.
    pub fn of_all(
        minimise: Option<&str>,
        maximise: Option<&str>,
        names: &[String],
    ) -> Result<Vec<Objective>> {
        let usual = if maximise.is_none() {
            Some(USUAL)
        } else {
            None
        };
        let mut out = Vec::new();
        for (flag, list, maximised) in [
            ("--minimise", minimise.or(usual), false),
            ("--maximise", maximise, true),
        ] {
            for name in list.into_iter().flat_map(|list| list.split(',')) {
                let column = objective(name, names).map_err(at_flag(flag))?;
                out.push(Objective {
                    column,
                    name: names[column].clone(),
                    maximised,
                });
            }
        }
        Ok(out)
    }

    fn sign(&self) -> f64 {
        if self.maximised { -1.0 } else { 1.0 }
    }

    /// The smaller the better.
    pub fn cost(&self, value: f64) -> f64 {
        self.sign() * value
    }

    /// Its value, SI, of a cost.
    pub fn value(&self, cost: f64) -> f64 {
        self.sign() * cost
    }

    /// Its name with the unit in which people read it.
    pub fn label(&self) -> String {
        unit_for_people(&words::column(&self.name)).0
    }

    /// A cost as people read it.
    pub fn shown(&self, cost: f64) -> String {
        let value = unit_for_people(&words::column(&self.name)).1 * self.value(cost);
        words::fixed(value, 6)
    }
}
