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

/// The file; `rgb` has three bytes per pixel, row by row.
pub fn encode(width: usize, height: usize, rgb: &[u8]) -> Vec<u8> {
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut head = [(width as u32).to_be_bytes(), (height as u32).to_be_bytes()].concat();
    // Eight bits, RGB, the only compression and filter methods, no interlace.
    head.extend([8, 2, 0, 0, 0]);
    chunk(&mut out, b"IHDR", &head);
    chunk(&mut out, b"IDAT", &zlib(3 * width, rgb));
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

/// The rows, each after the byte 0 for "no filter", as a zlib stream (RFC 1950).
fn zlib(row: usize, rgb: &[u8]) -> Vec<u8> {
    let stride = row + 1;
    let mut data = Vec::with_capacity(rgb.len() / row.max(1) * stride);
    for line in rgb.chunks_exact(row.max(1)) {
        data.push(0);
        data.extend_from_slice(line);
    }
    let mut bits = Bits {
        out: vec![0x78, 0x01],
        ..Bits::default()
    };
    // One block, the last, with fixed codes.
    bits.put(0b011, 3);
    let mut i = 0;
    while i < data.len() {
        let at = |distance: usize| match i.checked_sub(distance) {
            Some(j) if distance <= WINDOW => run(&data, i, j),
            _ => 0,
        };
        let (above, left) = (at(stride), at(3));
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
    out.extend(simd_adler32::adler32(&data.as_slice()).to_be_bytes());
    out
}

/// How many bytes from `i` on equal those from `j` on, up to the longest match.
fn run(data: &[u8], i: usize, j: usize) -> usize {
    let most = LONGEST.min(data.len() - i);
    let (here, there) = (&data[i..i + most], &data[j..j + most]);
    let mut n = 0;
    for (a, b) in here.chunks_exact(8).zip(there.chunks_exact(8)) {
        if a != b {
            break;
        }
        n += 8;
    }
    n + here[n..]
        .iter()
        .zip(&there[n..])
        .take_while(|(a, b)| a == b)
        .count()
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
        while self.count >= 8 {
            self.out.push(self.held as u8);
            self.held >>= 8;
            self.count -= 8;
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
        // What fills the last byte.
        self.put(0, 7);
        self.out
    }
}
