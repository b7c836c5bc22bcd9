//! Number formats of a C3D file.

use crate::recording::Processor;

impl Processor {
    /// Number format, from the fourth byte of the parameter section; `None` for an invalid value.
    pub(super) fn of(bytes: &[u8], parameters: usize) -> Option<Self> {
        match bytes.get(parameters + 3)? {
            84 => Some(Processor::Intel),
            85 => Some(Processor::Dec),
            86 => Some(Processor::Sgi),
            _ => None,
        }
    }

    pub(super) fn u16(self, bytes: &[u8], at: usize) -> Option<u16> {
        let b = bytes.get(at..at.checked_add(2)?)?;
        let pair = [b[0], b[1]];
        Some(match self {
            Processor::Sgi => u16::from_be_bytes(pair),
            Processor::Intel | Processor::Dec => u16::from_le_bytes(pair),
        })
    }

    pub(super) fn i16(self, bytes: &[u8], at: usize) -> Option<i16> {
        self.u16(bytes, at).map(u16::cast_signed)
    }

    /// Reads a float. In the VAX format, the two 16-bit halves are swapped and the exponent is larger by two.
    pub(super) fn f32(self, bytes: &[u8], at: usize) -> Option<f32> {
        let b = bytes.get(at..at.checked_add(4)?)?;
        Some(match self {
            Processor::Intel => f32::from_le_bytes([b[0], b[1], b[2], b[3]]),
            Processor::Sgi => f32::from_be_bytes([b[0], b[1], b[2], b[3]]),
            Processor::Dec => f32::from_le_bytes([b[2], b[3], b[0], b[1]]) / 4.0,
        })
    }
}
