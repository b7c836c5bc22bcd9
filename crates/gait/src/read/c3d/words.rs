//! Number formats of a C3D file.

/// How a processor wrote its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Words {
    /// Little endian, IEEE floats.
    Intel,
    /// Little endian words, VAX floats.
    Dec,
    /// Big endian, IEEE floats.
    Sgi,
}

impl Words {
    /// From the fourth byte of the parameter section.
    pub fn of(bytes: &[u8], parameters: usize) -> Option<Self> {
        match bytes.get(parameters + 3)? {
            84 => Some(Words::Intel),
            85 => Some(Words::Dec),
            86 => Some(Words::Sgi),
            _ => None,
        }
    }

    pub fn u16(self, bytes: &[u8], at: usize) -> Option<u16> {
        let b = bytes.get(at..at.checked_add(2)?)?;
        let pair = [b[0], b[1]];
        Some(match self {
            Words::Sgi => u16::from_be_bytes(pair),
            Words::Intel | Words::Dec => u16::from_le_bytes(pair),
        })
    }

    pub fn i16(self, bytes: &[u8], at: usize) -> Option<i16> {
        self.u16(bytes, at).map(u16::cast_signed)
    }

    /// A float; the VAX one has its halves swapped and an exponent two greater.
    pub fn f32(self, bytes: &[u8], at: usize) -> Option<f32> {
        let b = bytes.get(at..at.checked_add(4)?)?;
        Some(match self {
            Words::Intel => f32::from_le_bytes([b[0], b[1], b[2], b[3]]),
            Words::Sgi => f32::from_be_bytes([b[0], b[1], b[2], b[3]]),
            Words::Dec => f32::from_le_bytes([b[2], b[3], b[0], b[1]]) / 4.0,
        })
    }
}
