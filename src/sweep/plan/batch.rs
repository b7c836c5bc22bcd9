//! Parameters of many rows, stored as one column per varied key.

use std::sync::Arc;

use super::axis::AxisValue;

/// Values of one varied key for all rows of a batch.
#[derive(Debug, Clone, PartialEq)]
pub enum Column {
    /// Numbers in SI units, one for each row.
    Numbers(Vec<f64>),
    /// Words, whole numbers or paths as text, one for each row.
    Words(Vec<Arc<str>>),
}

impl Column {
    pub(super) fn with_capacity(is_number: bool, rows: usize) -> Column {
        if is_number {
            Column::Numbers(Vec::with_capacity(rows))
        } else {
            Column::Words(Vec::with_capacity(rows))
        }
    }

    /// Words of the column; `None` for a column of numbers.
    pub fn words(&self) -> Option<&Vec<Arc<str>>> {
        match self {
            Column::Words(words) => Some(words),
            Column::Numbers(_) => None,
        }
    }

    pub(super) fn push(&mut self, value: AxisValue) {
        match (self, value) {
            (Column::Numbers(list), AxisValue::Number(x)) => list.push(x),
            (Column::Words(list), AxisValue::Words(w)) => list.push(w),
            (Column::Words(list), AxisValue::Number(x)) => list.push(Arc::from(format!("{x}"))),
            // A word in a column of numbers becomes NaN. The scene with this value is then rejected.
            (Column::Numbers(list), AxisValue::Words(_)) => list.push(f64::NAN),
        }
    }
}

/// Parameters of consecutive rows. Each row has the index of its base scene and a value of each varied key.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Batch {
    /// Index of the base scene of each row.
    pub scene: Vec<u32>,
    /// Values of the varied keys. There is one column for each key, in the order of the keys. Each column has as many entries as `scene`.
    pub columns: Vec<Column>,
}

impl Batch {
    /// Number of rows in the batch.
    pub fn len(&self) -> usize {
        self.scene.len()
    }

    /// Whether the batch contains no rows.
    pub fn is_empty(&self) -> bool {
        self.scene.is_empty()
    }
}
