//! Speed of the camshaft as a function of time.

use crate::error::{DynamicsError, Result};

/// Speed of the camshaft as a function of time, linear between its rows.
///
/// ```
/// use gaitcam::dynamics::SpeedProgramme;
///
/// let even = SpeedProgramme::new(vec![0.0, 1.0, 2.0], vec![3.0, 3.0, 3.0])?;
/// assert_eq!(even.angles(0.5), [0.5, 3.5, 6.5]);
/// assert!(SpeedProgramme::new(vec![0.0, 1.0, 1.0], vec![3.0, 3.0, 3.0]).is_err());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedProgramme {
    /// Times of the rows, s, increasing.
    pub time_s: Vec<f64>,
    /// Speed at these times, rad/s. The last value belongs to the end of the programme.
    pub speed: Vec<f64>,
}

impl SpeedProgramme {
    /// Creates a programme of at least three rows.
    ///
    /// # Errors
    /// Fewer rows, times that do not increase, or speeds that are not positive.
    pub fn new(time_s: Vec<f64>, speed: Vec<f64>) -> Result<SpeedProgramme> {
        let rows = time_s.len().min(speed.len());
        if rows < 3 {
            return Err(DynamicsError::FewProgrammeRows { rows }.into());
        }
        let finite = |row: &usize| time_s[*row].is_finite() && speed[*row].is_finite();
        let later = |row: usize| row == 0 || time_s[row] > time_s[row - 1];
        let sound = |row: &usize| finite(row) && later(*row) && speed[*row] > 0.0;
        if let Some(row) = (0..rows).find(|row| !sound(row)) {
            return Err(DynamicsError::ProgrammeRow { row: row + 1 }.into());
        }
        Ok(SpeedProgramme { time_s, speed })
    }

    /// Cam angles at the rows, rad. `start` is the angle at the first row.
    pub fn angles(&self, start: f64) -> Vec<f64> {
        let mut angle = start;
        let steps = self.time_s.windows(2).zip(self.speed.windows(2));
        let next = steps.map(|(t, w)| {
            angle += 0.5 * (t[1] - t[0]) * (w[0] + w[1]);
            angle
        });
        std::iter::once(start).chain(next).collect()
    }

    /// Angular acceleration at the rows, rad/s²: mean of the slopes before and after the row.
    pub(super) fn accelerations(&self) -> Vec<f64> {
        let steps = self.time_s.windows(2).zip(self.speed.windows(2));
        let slopes: Vec<f64> = steps.map(|(t, w)| (w[1] - w[0]) / (t[1] - t[0])).collect();
        let last = slopes.len() - 1;
        (0..=last + 1)
            .map(|i| 0.5 * (slopes[i.max(1) - 1] + slopes[i.min(last)]))
            .collect()
    }

    /// Duration of the programme, s.
    pub fn duration_s(&self) -> f64 {
        self.time_s[self.time_s.len() - 1] - self.time_s[0]
    }
}
