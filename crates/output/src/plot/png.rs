//! Pixels to PNG (ISO/IEC 15948), 8-bit RGB.
//!
//! A drawing repeats the pixel to the left or the one above almost everywhere. So the compressor looks at
//! these two places only and writes DEFLATE (RFC 1951) with the fixed Huffman codes: one pass, no search.

/// Longest match of DEFLATE.
const LONGEST: usize = 258;
/// Shortest match of DEFLATE.
const SHORTEST: usize = 3;
/// Reach of DEFLATE's matches.
const WINDOW: usize = 32768;

/// Bytes of a row: the filter's number, 0 for none, then three bytes per pixel.
pub fn stride(width: usize) -> usize {
    3 * width + 1
}

/// The file; `rows` has [`stride`] bytes per row.
pub fn encode(width: usize, height: usize, rows: &[u8]) -> Vec<u8> {
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut head = [(width as u32).to_be_bytes(), (height as u32).to_be_bytes()].concat();
    // Eight bits, RGB, the only compression and filter methods, no interlace.
    head.extend([8, 2, 0, 0, 0]);
    chunk(&mut out, b"IHDR", &head);
    chunk(&mut out, b"IDAT", &zlib(stride(width), rows));
    chunk(&mut out, b"IEND", &[]);
    out
}

fn chunk(out: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    out.extend((data.len() as u32).to_be_bytes());
    let start = out.len();
    out.extend(kind);
    out.extend(data);
    let sum = crc32fast::hash(&out[start..]);
    out.extend(sum.to_be_bytes());
}

/// The rows as a zlib stream (RFC 1950).
fn zlib(stride: usize, data: &[u8]) -> Vec<u8> {
    let mut bits = Bits {
        out: vec![0x78, 0x01],
        ..Bits::default()
    };
    // One block, the last, with fixed codes.
    bits.put(0b011, 3);
    let mut i = 0;
    while i < data.len() {
        let at = |distance: usize| match i.checked_sub(distance) {
            Some(j) if data[j] == data[i] && distance <= WINDOW => run(data, i, j),
            _ => 0,
        };
        let left = at(3);
        let above = if left < LONGEST { at(stride) } else { 0 };
        if above.max(left) >= SHORTEST {
            let distance = if left >= above { 3 } else { stride };
            bits.matched(above.max(left), distance);
            i += above.max(left);
        } else {
            bits.literal(data[i]);
            i += 1;
        }
    }
    // The end of the block.
    bits.code(0, 7);
    let mut out = bits.finish();
    out.extend(simd_adler32::adler32(&data).to_be_bytes());
    out
}

/// How many bytes from `i` on equal those from `j` on, up to the longest match.
fn run(data: &[u8], i: usize, j: usize) -> usize {
    let most = LONGEST.min(data.len() - i);
    let (here, there) = (&data[i..i + most], &data[j..j + most]);
    let (eights, rest) = here.as_chunks::<8>();
    let (others, other_rest) = there.as_chunks::<8>();
    for (n, (a, b)) in eights.iter().zip(others).enumerate() {
        let differ = u64::from_le_bytes(*a) ^ u64::from_le_bytes(*b);
        if differ != 0 {
            return 8 * n + (differ.trailing_zeros() / 8) as usize;
        }
    }
    let equal = rest.iter().zip(other_rest).take_while(|(a, b)| a == b);
    8 * eights.len() + equal.count()
}

/// Bits from the lowest of each byte on.
#[derive(Default)]
struct Bits {
    out: Vec<u8>,
    held: u64,
    count: u32,
}

impl Bits {
    fn put(&mut self, value: u32, count: u32) {
        self.held |= u64::from(value) << self.count;
        self.count += count;
        if self.count >= 32 {
            self.out.extend((self.held as u32).to_le_bytes());
            self.held >>= 32;
            self.count -= 32;
        }
    }

    /// Huffman codes are written from their highest bit on.
    fn code(&mut self, code: u32, length: u32) {
        self.put(code.reverse_bits() >> (32 - length), length);
    }

    fn literal(&mut self, byte: u8) {
        match u32::from(byte) {
            b @ 0..144 => self.code(0x30 + b, 8),
            b => self.code(0x190 + b - 144, 9),
        }
    }

    fn matched(&mut self, length: usize, distance: usize) {
        // Length symbols 257 … 284 in groups of four per extra bit, 285 for the longest.
        let (symbol, extra, bits) = match length as u32 {
            258 => (285, 0, 0),
            l @ 3..11 => (254 + l, 0, 0),
            l => {
                let bits = (l - 3).ilog2() - 2;
                (
                    257 + 4 * bits + ((l - 3) >> bits),
                    (l - 3) & ((1 << bits) - 1),
                    bits,
                )
            }
        };
        match symbol {
            257..280 => self.code(symbol - 256, 7),
            _ => self.code(0xc0 + symbol - 280, 8),
        }
        self.put(extra, bits);
        // Distance symbols in groups of two per extra bit.
        let d = distance as u32 - 1;
        if d < 4 {
            return self.code(d, 5);
        }
        let bits = d.ilog2() - 1;
        self.code(2 * bits + (d >> bits), 5);
        self.put(d & ((1 << bits) - 1), bits);
    }

    fn finish(mut self) -> Vec<u8> {
        let whole = self.count.div_ceil(8) as usize;
        self.out.extend(&self.held.to_le_bytes()[..whole]);
        self.out
    }
}
