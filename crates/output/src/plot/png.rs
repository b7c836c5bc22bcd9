//! Pixels to PNG (ISO/IEC 15948), 8-bit RGB.
//!
//! A drawing repeats the pixel to the left or the one above almost everywhere. So the compressor looks at
//! these two places only and writes DEFLATE (RFC 1951) with the fixed Huffman codes: one pass, no search.

use simd_adler32::Adler32;

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

/// Some rows of [`stride`] bytes each.
pub struct Rows<'a> {
    pub bytes: &'a [u8],
    /// How many of the bytes were written before: matches may reach back to them.
    pub known: usize,
}

/// A file that gets its rows from the top.
pub struct Encoder {
    /// Everything before the pixels.
    head: Vec<u8>,
    stride: usize,
    bits: Bits,
    sum: Adler32,
}

impl Encoder {
    pub fn new(width: usize, height: usize) -> Encoder {
        let mut head = b"\x89PNG\r\n\x1a\n".to_vec();
        let mut size = [(width as u32).to_be_bytes(), (height as u32).to_be_bytes()].concat();
        // Eight bits, RGB, the only compression and filter methods, no interlace.
        size.extend([8, 2, 0, 0, 0]);
        chunk(&mut head, b"IHDR", &size);
        // A zlib stream (RFC 1950) of one block, the last, with fixed codes.
        let mut bits = Bits {
            out: vec![0x78, 0x01],
            ..Bits::default()
        };
        bits.put(Code::raw(0b011, 3));
        Encoder {
            head,
            stride: stride(width),
            bits,
            sum: Adler32::new(),
        }
    }

    /// Adds the rows that follow.
    pub fn rows(&mut self, rows: Rows) {
        let data = rows.bytes;
        self.sum.write(&data[rows.known..]);
        let (left_code, above_code) = (distance(3), distance(self.stride as u32));
        let mut i = rows.known;
        while i < data.len() {
            let at = |distance: usize| match i.checked_sub(distance) {
                Some(j) if data[j] == data[i] && distance <= WINDOW => run(data, i, j),
                _ => 0,
            };
            let left = at(3);
            let above = if left < LONGEST { at(self.stride) } else { 0 };
            let length = above.max(left);
            if length >= SHORTEST {
                let code = if left >= above { left_code } else { above_code };
                self.bits.put(LENGTHS[length].then(code));
                i += length;
            } else {
                self.bits.put(LITERALS[usize::from(data[i])]);
                i += 1;
            }
        }
    }

    /// The file.
    pub fn finish(mut self) -> Vec<u8> {
        // The end of the block.
        self.bits.put(Code::huffman(0, 7));
        let mut pixels = self.bits.finish();
        pixels.extend(self.sum.finish().to_be_bytes());
        let mut out = self.head;
        chunk(&mut out, b"IDAT", &pixels);
        chunk(&mut out, b"IEND", &[]);
        out
    }
}

fn chunk(out: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    out.extend((data.len() as u32).to_be_bytes());
    let start = out.len();
    out.extend(kind);
    out.extend(data);
    let sum = crc32fast::hash(&out[start..]);
    out.extend(sum.to_be_bytes());
}

/// How many bytes from `i` on equal those from `j` on, up to the longest match.
#[inline]
fn run(data: &[u8], i: usize, j: usize) -> usize {
    let most = LONGEST.min(data.len() - i);
    let (here, there) = (&data[i..i + most], &data[j..j + most]);
    let (blocks, others) = (here.as_chunks::<32>().0, there.as_chunks::<32>().0);
    let equal = blocks.iter().zip(others).take_while(|(a, b)| a == b);
    let whole = 32 * equal.count();
    let (here, there) = (&here[whole..], &there[whole..]);
    let (eights, rest) = here.as_chunks::<8>();
    let (others, other_rest) = there.as_chunks::<8>();
    for (n, (a, b)) in eights.iter().zip(others).enumerate() {
        let differ = u64::from_le_bytes(*a) ^ u64::from_le_bytes(*b);
        if differ != 0 {
            return whole + 8 * n + (differ.trailing_zeros() / 8) as usize;
        }
    }
    let equal = rest.iter().zip(other_rest).take_while(|(a, b)| a == b);
    whole + 8 * eights.len() + equal.count()
}

/// Bits that are written together, the first of them lowest.
#[derive(Clone, Copy)]
struct Code {
    bits: u32,
    count: u32,
}

impl Code {
    const fn raw(bits: u32, count: u32) -> Code {
        Code { bits, count }
    }

    /// Huffman codes are written from their highest bit on.
    const fn huffman(code: u32, count: u32) -> Code {
        Code::raw(code.reverse_bits() >> (32 - count), count)
    }

    const fn then(self, next: Code) -> Code {
        Code::raw(self.bits | next.bits << self.count, self.count + next.count)
    }
}

/// Codes of single bytes.
static LITERALS: [Code; 256] = {
    let mut all = [Code::raw(0, 0); 256];
    let mut byte = 0;
    while byte < 256 {
        all[byte as usize] = match byte {
            0..144 => Code::huffman(0x30 + byte, 8),
            _ => Code::huffman(0x190 + byte - 144, 9),
        };
        byte += 1;
    }
    all
};

/// Codes of the lengths of matches.
static LENGTHS: [Code; LONGEST + 1] = {
    let mut all = [Code::raw(0, 0); LONGEST + 1];
    let mut length = SHORTEST;
    while length <= LONGEST {
        all[length] = match_length(length as u32);
        length += 1;
    }
    all
};

/// Length symbols 257 … 284 in groups of four per extra bit, 285 for the longest.
const fn match_length(length: u32) -> Code {
    let (symbol, extra) = match length {
        258 => (285, Code::raw(0, 0)),
        3..11 => (254 + length, Code::raw(0, 0)),
        _ => {
            let bits = (length - 3).ilog2() - 2;
            let extra = (length - 3) & ((1 << bits) - 1);
            (
                257 + 4 * bits + ((length - 3) >> bits),
                Code::raw(extra, bits),
            )
        }
    };
    let symbol = match symbol {
        257..280 => Code::huffman(symbol - 256, 7),
        _ => Code::huffman(0xc0 + symbol - 280, 8),
    };
    symbol.then(extra)
}

/// Distance symbols in groups of two per extra bit.
const fn distance(distance: u32) -> Code {
    let d = distance - 1;
    if d < 4 {
        return Code::huffman(d, 5);
    }
    let bits = d.ilog2() - 1;
    let symbol = Code::huffman(2 * bits + (d >> bits), 5);
    symbol.then(Code::raw(d & ((1 << bits) - 1), bits))
}

/// Bits from the lowest of each byte on.
#[derive(Default)]
struct Bits {
    out: Vec<u8>,
    held: u64,
    count: u32,
}

impl Bits {
    #[inline]
    fn put(&mut self, code: Code) {
        self.held |= u64::from(code.bits) << self.count;
        self.count += code.count;
        if self.count >= 32 {
            self.out.extend((self.held as u32).to_le_bytes());
            self.held >>= 32;
            self.count -= 32;
        }
    }

    fn finish(mut self) -> Vec<u8> {
        let whole = self.count.div_ceil(8) as usize;
        self.out.extend(&self.held.to_le_bytes()[..whole]);
        self.out
    }
}
