//! Arrays of a MAT file of level 5 (MATLAB 5.0 to 7.2, `save -v7`).
//!
//! Format: "MAT-File Format" (The MathWorks), level 5. After a header of 128 bytes, each data element consists of a tag and its data, which
//! may be compressed. Every count is checked against the length of the file before it is used.

use miniz_oxide::inflate::TINFLStatus;
use miniz_oxide::inflate::core::inflate_flags as flags;
use miniz_oxide::inflate::core::{DecompressorOxide, decompress};

/// Size of the header, bytes.
const HEADER: usize = 128;
/// Maximum size of a compressed variable after decompression, bytes.
const LARGEST: usize = 1 << 30;
/// Maximum depth of structs within structs.
const DEEPEST: usize = 16;
const MOST_STRUCTS: usize = 1000;

/// Type numbers of data elements.
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Class numbers of arrays.
const CELL: u8 = 1;
const STRUCT: u8 = 2;
const CHARACTERS: u8 = 4;
const NUMERIC: std::ops::RangeInclusive<u8> = 6..=15;

/// Content of an array: numbers, or a list of texts.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Content {
    /// Values column by column, with the number of rows and of columns.
    Numbers {
        rows: usize,
        columns: usize,
        values: Vec<f64>,
    },
    /// Texts of a cell array, rows of a character array, or a single text.
    Texts(Vec<String>),
}

/// An array, with the names of the structs that contain it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Array {
    /// Names of the variable, of the structs and of the field. In an array of structs or a cell array, the index of the element, counted
    /// from 1, follows the name.
    pub path: Vec<String>,
    pub content: Content,
}

impl Array {
    /// Names of the structs that contain the array.
    pub fn owner(&self) -> &[String] {
        &self.path[..self.path.len().saturating_sub(1)]
    }

    /// Name, announced number and actual number of values of an incomplete array; `None` if it is complete.
    pub fn lacking(&self) -> Option<(String, usize, usize)> {
        let Content::Numbers {
            rows,
            columns,
            values,
        } = &self.content
        else {
            return None;
        };
        let announced = rows.saturating_mul(*columns);
        (announced != values.len()).then(|| (self.path.join("."), announced, values.len()))
    }
}

/// Whether the bytes start like a MAT file of level 5.
pub(in crate::read) fn is_level_5(bytes: &[u8]) -> bool {
    bytes.starts_with(b"MATLAB 5.0") && bytes.len() > HEADER
}

/// All arrays of a file. If the file is damaged, only the arrays before the damage are returned.
pub(super) fn arrays(bytes: &[u8]) -> Vec<Array> {
    let big = bytes.get(126..128) == Some(b"MI");
    let mut found = Vec::new();
    let variables = Elements {
        bytes: bytes.get(HEADER..).unwrap_or(&[]),
        big,
    };
    for (kind, data) in variables {
        let inflated: Vec<u8>;
        let mut inner = match kind {
            COMPRESSED => {
                inflated = inflate(data);
                Elements {
                    bytes: &inflated,
                    big,
                }
                .next()
            }
            _ => Some((kind, data)),
        };
        if let Some((MATRIX, data)) = inner.take() {
            matrix(Elements { bytes: data, big }, &[], None, 0, &mut found);
        }
    }
    found
}

/// Decompressed content of a zlib stream, up to `LARGEST` bytes. If the stream is damaged, only the content before the damage is returned.
fn inflate(data: &[u8]) -> Vec<u8> {
    let options =
        flags::TINFL_FLAG_PARSE_ZLIB_HEADER | flags::TINFL_FLAG_USING_NON_WRAPPING_OUTPUT_BUF;
    let mut state = DecompressorOxide::new();
    let mut out = vec![0; (4 * data.len() + 64).min(LARGEST)];
    let (mut from, mut size) = (0, 0);
    loop {
        let (status, read, written) =
            decompress(&mut state, &data[from..], &mut out, size, options);
        (from, size) = (from + read, size + written);
        if status != TINFLStatus::HasMoreOutput || out.len() >= LARGEST {
            break;
        }
        out.resize((2 * out.len()).min(LARGEST), 0);
    }
    out.truncate(size);
    out
}

/// Iterator over consecutive data elements.
#[derive(Clone, Copy)]
struct Elements<'a> {
    bytes: &'a [u8],
    big: bool,
}

impl<'a> Elements<'a> {
    fn word(&self, at: usize) -> Option<u32> {
        let word: [u8; 4] = self.bytes.get(at..at + 4)?.try_into().ok()?;
        Some(if self.big {
            u32::from_be_bytes(word)
        } else {
            u32::from_le_bytes(word)
        })
    }
}

impl<'a> Iterator for Elements<'a> {
    /// Type number and data of an element.
    type Item = (u32, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let first = self.word(0)?;
        // Up to four bytes of data are stored in the tag itself.
        let (kind, from, length, whole) = match first >> 16 {
            0 => {
                let length = self.word(4)? as usize;
                let padded = if first == COMPRESSED {
                    length
                } else {
                    length.next_multiple_of(8)
                };
                (first, 8, length, padded.saturating_add(8))
            }
            length => (first & 0xFFFF, 4, length as usize, 8),
        };
        let data = self.bytes.get(from..)?;
        // The last variable of a truncated file is read up to the end of the file.
        let data = data.get(..length).unwrap_or(data);
        self.bytes = self.bytes.get(whole..).unwrap_or(&[]);
        Some((kind, data))
    }
}

/// Adds an array and the arrays that it contains. If the array is a field, `name` is the name of the field and replaces the name in the
/// array.
fn matrix(
    mut elements: Elements<'_>,
    owner: &[String],
    name: Option<String>,
    depth: usize,
    found: &mut Vec<Array>,
) -> Option<()> {
    let big = elements.big;
    let flags = elements.next()?.1;
    let class = *flags.get(if big { 3 } else { 0 })?;
    let sizes = numbers(elements.next()?, big)?;
    let own = latin(elements.next()?.1);
    let mut path = owner.to_vec();
    path.push(name.unwrap_or(own));
    let rows = sizes.first().map_or(0, |n| *n as usize);
    match class {
        CELL => {
            let texts: Option<Vec<String>> = elements.map(|e| text_of(e, big)).collect();
            if let Some(texts) = texts {
                found.push(Array {
                    path,
                    content: Content::Texts(texts),
                });
            } else if depth < DEEPEST {
                for (k, cell) in (1..=MOST_STRUCTS).zip(elements) {
                    let inner = Elements { bytes: cell.1, big };
                    let _ = matrix(inner, &path, Some(k.to_string()), depth + 1, found);
                }
            }
        }
        STRUCT if depth < DEEPEST => {
            let length = *numbers(elements.next()?, big)?.first()? as usize;
            let names = elements.next()?.1;
            let names: Vec<String> = names.chunks(length.max(1)).map(latin).collect();
            let count = sizes.iter().product::<f64>() as usize;
            for k in 1..=count.min(MOST_STRUCTS) {
                let mut place = path.clone();
                if count > 1 {
                    place.push(k.to_string());
                }
                for name in &names {
                    let field = elements.next()?;
                    let inner = Elements {
                        bytes: field.1,
                        big,
                    };
                    // A field without content is ignored, and the following fields are still read.
                    let _ = matrix(inner, &place, Some(name.clone()), depth + 1, found);
                }
            }
        }
        CHARACTERS => {
            let content = Content::Texts(characters(elements.next()?, big, rows));
            found.push(Array { path, content });
        }
        class if NUMERIC.contains(&class) => {
            let values = numbers(elements.next()?, big)?;
            let columns = sizes.iter().skip(1).product::<f64>() as usize;
            let content = Content::Numbers {
                rows,
                columns,
                values,
            };
            found.push(Array { path, content });
        }
        _ => (),
    }
    Some(())
}

/// Text of a character array that is an element of a cell array.
fn text_of((kind, data): (u32, &[u8]), big: bool) -> Option<String> {
    let mut elements = Elements { bytes: data, big };
    let class = *elements.next()?.1.get(if big { 3 } else { 0 })?;
    if kind != MATRIX || class != CHARACTERS {
        return None;
    }
    let _sizes = elements.next()?;
    let _name = elements.next()?;
    characters(elements.next()?, big, 1).pop()
}

/// Rows of a character array without trailing spaces.
fn characters((kind, data): (u32, &[u8]), big: bool, rows: usize) -> Vec<String> {
    // UTF-16 words, or bytes of UTF-8 and older encodings.
    let letters: Vec<char> = match kind {
        4 | 17 => {
            let (pairs, _) = data.as_chunks();
            let unit = |pair: &[u8; 2]| {
                if big {
                    u16::from_be_bytes(*pair)
                } else {
                    u16::from_le_bytes(*pair)
                }
            };
            let units: Vec<u16> = pairs.iter().map(unit).collect();
            String::from_utf16_lossy(&units).chars().collect()
        }
        _ => String::from_utf8_lossy(data).chars().collect(),
    };
    let rows = rows.clamp(1, letters.len().max(1));
    let row = |k: usize| letters.iter().skip(k).step_by(rows).collect::<String>();
    (0..rows).map(|k| row(k).trim_end().to_string()).collect()
}

/// Bytes up to the first zero, decoded as Latin-1.
fn latin(bytes: &[u8]) -> String {
    let text = bytes.split(|b| *b == 0).next().unwrap_or_default();
    text.iter().map(|&b| char::from(b)).collect()
}

/// Numbers of a data element of any numeric type.
fn numbers((kind, data): (u32, &[u8]), big: bool) -> Option<Vec<f64>> {
    macro_rules! of {
        ($type:ty) => {{
            let (parts, _) = data.as_chunks::<{ size_of::<$type>() }>();
            let number = |part: &[u8; size_of::<$type>()]| match big {
                true => <$type>::from_be_bytes(*part) as f64,
                false => <$type>::from_le_bytes(*part) as f64,
            };
            Some(parts.iter().map(number).collect())
        }};
    }
    match kind {
        1 => of!(i8),
        2 => of!(u8),
        3 => of!(i16),
        4 => of!(u16),
        5 => of!(i32),
        6 => of!(u32),
        7 => of!(f32),
        9 => of!(f64),
        12 => of!(i64),
        13 => of!(u64),
        _ => None,
    }
}
