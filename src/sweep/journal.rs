//! The bytes of a journal: a head that says which sweep it is, then chunks of finished rows.
//!
//! Every block has its length and a checksum, so that a chunk which a crash cut short is known for what it
//! is. Chunks stand in the order of their rows and without gaps.

use serde_json::Value;

use crate::error::{Error, Result};

/// First bytes of every journal; the number grows with the format.
const MAGIC: &[u8; 16] = b"gaitcam sweep 1\n";
/// First bytes of every chunk.
const CHUNK: &[u8; 4] = b"CHNK";
/// Length of a chunk's own head: mark, first row, rows, length, checksum.
pub const CHUNK_HEAD: usize = 4 + 8 + 4 + 8 + 4;
/// A head longer than this is no head.
const LONGEST_HEAD: u64 = 1 << 30;

/// Head of a chunk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ChunkHead {
    /// Number of its first row.
    pub first: u64,
    /// Number of its rows.
    pub rows: u32,
    /// Bytes that follow the head.
    pub length: u64,
    checksum: u32,
}

/// The head of a journal for a described sweep.
pub fn head(description: &Value) -> Vec<u8> {
    let text = description.to_string();
    let mut out = MAGIC.to_vec();
    out.extend((text.len() as u64).to_le_bytes());
    out.extend(crc32fast::hash(text.as_bytes()).to_le_bytes());
    out.extend_from_slice(text.as_bytes());
    out
}

/// Bytes before the description: mark, length, checksum.
pub const HEAD: usize = 16 + 8 + 4;

/// Length of the description that the first [`HEAD`] bytes announce; `None` when the file ends earlier, so
/// that nothing was ever kept in it. Fails on a file of another kind.
pub fn description_length(start: &[u8]) -> Result<Option<u64>> {
    if start.len() < HEAD {
        let known = start.len().min(MAGIC.len());
        if start[..known] == MAGIC[..known] {
            return Ok(None);
        }
        return Err(foreign());
    }
    let length = u64::from_le_bytes(array(&start[16..24]));
    if start[..16] != *MAGIC || length > LONGEST_HEAD {
        return Err(foreign());
    }
    Ok(Some(length))
}

/// The description itself; `None` when it was cut short.
pub fn description(start: &[u8], text: &[u8]) -> Option<Value> {
    let sum = u32::from_le_bytes([start[24], start[25], start[26], start[27]]);
    if crc32fast::hash(text) != sum {
        return None;
    }
    serde_json::from_slice(text).ok()
}

fn foreign() -> Error {
    Error::new("is not the journal of a sweep").help("move it away, or choose another --out")
}

/// A chunk of rows, ready to be appended.
pub fn chunk(first: u64, rows: u32, payload: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(CHUNK_HEAD + payload.len());
    out.extend_from_slice(CHUNK);
    out.extend(first.to_le_bytes());
    out.extend(rows.to_le_bytes());
    out.extend((payload.len() as u64).to_le_bytes());
    let sum = checksum(&out[4..24], payload);
    out.extend(sum.to_le_bytes());
    out.extend_from_slice(payload);
    out
}

/// Reads a chunk's head; `None` when these bytes are none.
pub fn chunk_head(bytes: &[u8]) -> Option<ChunkHead> {
    if bytes.len() < CHUNK_HEAD || bytes[..4] != *CHUNK {
        return None;
    }
    Some(ChunkHead {
        first: u64::from_le_bytes(array(&bytes[4..12])),
        rows: u32::from_le_bytes([bytes[12], bytes[13], bytes[14], bytes[15]]),
        length: u64::from_le_bytes(array(&bytes[16..24])),
        checksum: u32::from_le_bytes([bytes[24], bytes[25], bytes[26], bytes[27]]),
    })
}

impl ChunkHead {
    /// Whether the payload is the one that was written.
    pub fn holds(&self, payload: &[u8]) -> bool {
        let mut numbers = Vec::with_capacity(20);
        numbers.extend(self.first.to_le_bytes());
        numbers.extend(self.rows.to_le_bytes());
        numbers.extend(self.length.to_le_bytes());
        payload.len() as u64 == self.length && checksum(&numbers, payload) == self.checksum
    }
}

fn checksum(numbers: &[u8], payload: &[u8]) -> u32 {
    let mut sum = crc32fast::Hasher::new();
    sum.update(numbers);
    sum.update(payload);
    sum.finalize()
}

fn array(bytes: &[u8]) -> [u8; 8] {
    let mut out = [0; 8];
    out.copy_from_slice(bytes);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_are_known_and_damage_is_seen() {
        let bytes = chunk(7, 2, b"payload");
        let head = chunk_head(&bytes).unwrap();
        assert_eq!((head.first, head.rows, head.length), (7, 2, 7));
        assert!(head.holds(&bytes[CHUNK_HEAD..]));
        for i in 4..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[i] ^= 1;
            let head = chunk_head(&damaged).unwrap();
            assert!(!head.holds(&damaged[CHUNK_HEAD..]), "byte {i}");
        }
    }

    #[test]
    fn heads_give_their_description_back() {
        let sweep = serde_json::json!({"rows": 3});
        let bytes = head(&sweep);
        let length = description_length(&bytes[..HEAD]).unwrap().unwrap() as usize;
        assert_eq!(
            description(&bytes, &bytes[HEAD..HEAD + length]),
            Some(sweep)
        );
        assert_eq!(description_length(&bytes[..10]).unwrap(), None);
        assert!(description_length(b"theta_rad,s_m,v_m_per_rad,a_m").is_err());
    }
}
