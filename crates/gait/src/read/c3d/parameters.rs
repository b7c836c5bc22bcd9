//! Parameter section of a C3D file.

use crate::recording::Processor;

/// Maximum number of values that are read of one parameter. Real files contain a few hundred.
const MOST_VALUES: usize = 1 << 16;

/// One parameter: group number, name, dimensions and bytes of its values.
#[derive(Debug, Clone)]
struct Parameter<'a> {
    group: i8,
    name: String,
    /// Number of bytes per value: 1, 2 or 4; −1 for characters.
    kind: i8,
    dims: Vec<usize>,
    data: &'a [u8],
}

/// All readable parameters of a file.
#[derive(Debug)]
pub(super) struct Parameters<'a> {
    words: Processor,
    groups: Vec<(i8, String)>,
    all: Vec<Parameter<'a>>,
}

impl<'a> Parameters<'a> {
    /// Reads the chain of groups and parameters. An invalid link ends the chain.
    pub fn read(bytes: &'a [u8], start: usize, words: Processor) -> Self {
        let mut found = Parameters {
            words,
            groups: Vec::new(),
            all: Vec::new(),
        };
        let mut at = start + 4;
        while let Some(next) = found.record(bytes, at) {
            at = next;
        }
        found
    }

    /// Reads one record. Returns the position of the next record, which must be larger than the position of this record.
    fn record(&mut self, bytes: &'a [u8], at: usize) -> Option<usize> {
        // A negative length only means that the name is locked.
        let length = usize::from(bytes.get(at)?.cast_signed().unsigned_abs());
        let group = bytes.get(at + 1)?.cast_signed();
        if length == 0 || group == 0 {
            return None;
        }
        let link = at + 2 + length;
        let name: String = bytes
            .get(at + 2..link)?
            .iter()
            .map(|&b| char::from(b.to_ascii_uppercase()))
            .collect();
        let offset = usize::from(self.words.u16(bytes, link)?);
        if group < 0 {
            if self.groups.len() < 256 {
                self.groups.push((group.checked_neg()?, name));
            }
        } else if let Some(p) = self.parameter(bytes, link + 2, group, name) {
            self.all.push(p);
        }
        (offset > 2).then_some(link + offset)
    }

    fn parameter(
        &self,
        bytes: &'a [u8],
        at: usize,
        group: i8,
        name: String,
    ) -> Option<Parameter<'a>> {
        let kind = bytes.get(at)?.cast_signed();
        let count = usize::from(*bytes.get(at + 1)?);
        let dims: Vec<usize> = bytes
            .get(at + 2..at + 2 + count)?
            .iter()
            .map(|&d| usize::from(d))
            .collect();
        let size = usize::from(kind.unsigned_abs()).clamp(1, 4);
        let values = dims.iter().try_fold(1usize, |p, &d| p.checked_mul(d))?;
        let from = at + 2 + count;
        let end = from.checked_add(values.checked_mul(size)?)?;
        Some(Parameter {
            group,
            name,
            kind,
            dims,
            data: bytes.get(from..end)?,
        })
    }

    fn find(&self, group: &str, name: &str) -> Option<&Parameter<'a>> {
        let id = self.groups.iter().find(|(_, g)| g == group)?.0;
        self.all.iter().find(|p| p.group == id && p.name == name)
    }

    /// Numbers of a parameter in the order of the file (the first index varies fastest); empty if the parameter is absent.
    pub fn numbers(&self, group: &str, name: &str) -> Vec<f64> {
        self.find(group, name)
            .map_or(Vec::new(), |p| self.values(p))
    }

    /// First number of a parameter.
    pub fn number(&self, group: &str, name: &str) -> Option<f64> {
        self.numbers(group, name).first().copied()
    }

    /// Dimensions of a parameter; empty if the parameter is absent.
    pub fn dims(&self, group: &str, name: &str) -> &[usize] {
        self.find(group, name).map_or(&[], |p| &p.dims)
    }

    /// Texts of a parameter, without spaces at both ends.
    pub fn strings(&self, group: &str, name: &str) -> Vec<String> {
        let Some(p) = self.find(group, name).filter(|p| p.kind == -1) else {
            return Vec::new();
        };
        let length = p.dims.first().copied().unwrap_or(p.data.len());
        let text = |c: &[u8]| {
            let text: String = c.iter().map(|&b| char::from(b)).collect();
            text.trim_matches(['\0', ' ']).to_string()
        };
        p.data.chunks(length.max(1)).map(text).collect()
    }

    /// Numbers of a parameter and of its continuations, such as `SCALE2`. One parameter has at most 255 values, so longer lists are
    /// continued.
    pub fn all_numbers(&self, group: &str, name: &str) -> Vec<f64> {
        Self::continued(name, |name| self.numbers(group, name))
    }

    /// Texts of a parameter and of its continuations, such as `LABELS2`.
    pub fn all_strings(&self, group: &str, name: &str) -> Vec<String> {
        Self::continued(name, |name| self.strings(group, name))
    }

    fn continued<T>(name: &str, read: impl Fn(&str) -> Vec<T>) -> Vec<T> {
        let next = (2..).map(|k| read(&format!("{name}{k}")));
        let more = next.take_while(|values| !values.is_empty()).flatten();
        read(name).into_iter().chain(more).collect()
    }

    /// All numeric parameters, in any group, whose name satisfies the condition `fits`.
    pub fn named<'s>(
        &'s self,
        fits: impl Fn(&str) -> bool + 's,
    ) -> impl Iterator<Item = (&'s str, Vec<f64>)> + 's {
        let numeric = self.all.iter().filter(move |p| p.kind > 0 && fits(&p.name));
        numeric.map(|p| (p.name.as_str(), self.values(p)))
    }

    fn values(&self, p: &Parameter) -> Vec<f64> {
        let width = usize::from(p.kind.unsigned_abs()).max(1);
        let number = |cell: &[u8]| match p.kind {
            1 => Some(f64::from(cell[0])),
            2 => self.words.i16(cell, 0).map(f64::from),
            4 => self.words.f32(cell, 0).map(f64::from),
            _ => None,
        };
        let cells = p.data.chunks_exact(width).take(MOST_VALUES);
        cells.filter_map(number).collect()
    }
}
