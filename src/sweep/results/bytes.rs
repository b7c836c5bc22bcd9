//! Rows as bytes, for the journal of a sweep.

use super::{NUMBERS, Results};
use crate::error::{Error, Result};

impl Results {
    /// The rows as bytes, little-endian, column by column.
    pub fn to_bytes(&self) -> Vec<u8> {
        let rows = self.len();
        let mut out = Vec::with_capacity(4 + rows * (8 * (NUMBERS.len() + 1) + 3) + 64);
        out.extend((rows as u32).to_le_bytes());
        for column in self.numbers.iter().chain([&self.time_s]) {
            for x in column {
                out.extend(x.to_le_bytes());
            }
        }
        for codes in [&self.outcome, &self.verdict, &self.tier] {
            out.extend_from_slice(codes);
        }
        for texts in &self.texts {
            out.extend((texts.len() as u32).to_le_bytes());
            for (row, text) in texts {
                out.extend(row.to_le_bytes());
                out.extend((text.len() as u32).to_le_bytes());
                out.extend_from_slice(text.as_bytes());
            }
        }
        out
    }

    /// Reads what [`Results::to_bytes`] wrote. Fails on bytes that are too few, too many or no text.
    pub fn from_bytes(bytes: &[u8]) -> Result<Results> {
        let mut rest = Rest { bytes };
        let rows = rest.number()? as usize;
        let mut out = Results::with_capacity(0);
        for column in &mut out.numbers {
            *column = rest.floats(rows)?;
        }
        out.time_s = rest.floats(rows)?;
        out.outcome = rest.take(rows)?.to_vec();
        out.verdict = rest.take(rows)?.to_vec();
        out.tier = rest.take(rows)?.to_vec();
        for texts in &mut out.texts {
            for _ in 0..rest.number()? {
                let row = rest.number()?;
                let length = rest.number()? as usize;
                let text = std::str::from_utf8(rest.take(length)?)
                    .map_err(|_| Error::new("a chunk holds bytes that are no text"))?;
                texts.push((row, text.to_string()));
            }
        }
        if rest.bytes.is_empty() {
            Ok(out)
        } else {
            Err(Error::new("a chunk is longer than its rows"))
        }
    }
}

/// Bytes not yet read.
struct Rest<'a> {
    bytes: &'a [u8],
}

impl<'a> Rest<'a> {
    fn take(&mut self, length: usize) -> Result<&'a [u8]> {
        if self.bytes.len() < length {
            return Err(Error::new("a chunk is shorter than its rows"));
        }
        let (head, tail) = self.bytes.split_at(length);
        self.bytes = tail;
        Ok(head)
    }

    fn number(&mut self) -> Result<u32> {
        let b = self.take(4)?;
        Ok(u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
    }

    fn floats(&mut self, count: usize) -> Result<Vec<f64>> {
        let bytes = self.take(8 * count)?;
        Ok(bytes
            .chunks_exact(8)
            .map(|b| f64::from_le_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]]))
            .collect())
    }
}
