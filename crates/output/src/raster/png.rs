//! Conversion of pixels to PNG (ISO/IEC 15948), 8-bit RGB.

use std::io;

use fdeflate::Compressor;

/// PNG filters of a row: `LEFT` stores differences from the pixel to the left, `UP` differences from the row above.
const LEFT: u8 = 1;
const UP: u8 = 2;

/// Content of a PNG file. `pixels` contains rows of `width` pixels from the top.
pub fn png(width: usize, pixels: &[[u8; 3]]) -> Vec<u8> {
    let height = pixels.len() / width.max(1);
    let mut size = [(width as u32).to_be_bytes(), (height as u32).to_be_bytes()].concat();
    // Eight bits, RGB, the only compression and filter methods, no interlace.
    size.extend([8, 2, 0, 0, 0]);
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    chunk(&mut out, b"IHDR", &size);
    // Writing to a vector cannot fail.
    chunk(
        &mut out,
        b"IDAT",
        &compressed(width, pixels).unwrap_or_default(),
    );
    chunk(&mut out, b"IEND", &[]);
    out
}

fn compressed(width: usize, pixels: &[[u8; 3]]) -> io::Result<Vec<u8>> {
    let mut out = Compressor::new(Vec::new())?;
    let mut above: &[[u8; 3]] = &[];
    let mut filtered = Vec::with_capacity(3 * width + 1);
    for row in pixels.chunks_exact(width.max(1)) {
        let bytes = row.as_flattened();
        filtered.clear();
        if row == above {
            filtered.push(UP);
            filtered.resize(1 + bytes.len(), 0);
        } else {
            filtered.push(LEFT);
            filtered.extend(&bytes[..3]);
            let pairs = bytes[3..].iter().zip(bytes);
            filtered.extend(pairs.map(|(here, left)| here.wrapping_sub(*left)));
        }
        out.write_data(&filtered)?;
        above = row;
    }
    out.finish()
}

fn chunk(out: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    out.extend((data.len() as u32).to_be_bytes());
    let start = out.len();
    out.extend(kind);
    out.extend(data);
    let sum = crc32fast::hash(&out[start..]);
    out.extend(sum.to_be_bytes());
}
