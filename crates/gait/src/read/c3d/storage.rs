//! Header and data section of a C3D file: frames and analog samples.

use std::path::Path;

use super::BLOCK;
use super::parameters::Parameters;
use crate::error::{Placed, ReadError, Result};
use crate::recording::{Format, Note, Processor, Storage};

/// Analog samples of a file, read channel by channel.
#[derive(Debug)]
pub(super) struct Analog<'a> {
    words: Processor,
    /// Content of the data section.
    data: &'a [u8],
    is_float: bool,
    unsigned: bool,
    /// Number of markers in a frame. The markers precede the analog samples of the frame.
    pub points: usize,
    frame: usize,
    pub channels: usize,
    /// Number of samples of one channel in one frame.
    pub per_frame: usize,
    /// Number of samples of one channel in the file.
    pub samples: usize,
    pub first_frame: usize,
    pub frame_hz: f64,
    pub rate_hz: f64,
    scale: Vec<f64>,
    offset: Vec<f64>,
    general_scale: f64,
}

impl<'a> Analog<'a> {
    /// Locates the data section. If the file contains fewer frames than announced, a note is added.
    pub fn read(
        path: &Path,
        bytes: &'a [u8],
        words: Processor,
        parameters: &Parameters,
        notes: &mut Vec<Note>,
    ) -> Result<Self> {
        let word = |at: usize| words.u16(bytes, at).map_or(0, usize::from);
        let points = word(2);
        let (first, last) = (word(6), word(8));
        let (per_all, per_frame) = values_per_frame(path, word(4), word(18), parameters)?;
        let start = start_of_data(word(16), parameters);
        let scale = words.f32(bytes, 12).map_or(1.0, f64::from);
        let is_float = parameters.number("POINT", "SCALE").unwrap_or(scale) < 0.0;
        let width = if is_float { 4 } else { 2 };
        let frame = (4 * points + per_all) * width;
        let rest = bytes.get(start..).unwrap_or(&[]);
        let found = rest.len() / frame;
        let announced = announced_frames(first, last, parameters);
        let frames = announced.map_or(found, |a| a.min(found));
        if let Some(announced) = announced.filter(|a| *a > found) {
            notes.push(Note::FramesMissing { announced, found });
        }
        if frames == 0 {
            return Err(ReadError::NoFrame { bytes: frame }.at_byte(path, start.min(bytes.len())));
        }
        let in_header = words.f32(bytes, 20).map_or(0.0, f64::from);
        let (frame_hz, rate_hz) = rates(in_header, per_frame, parameters)
            .ok_or_else(|| ReadError::NoFrameRate.at_byte(path, 20))?;
        Ok(Analog {
            words,
            data: &rest[..frames * frame],
            is_float,
            unsigned: parameters
                .strings("ANALOG", "FORMAT")
                .first()
                .is_some_and(|f| f.eq_ignore_ascii_case("UNSIGNED")),
            points,
            frame,
            channels: per_all / per_frame,
            per_frame,
            samples: frames * per_frame,
            first_frame: first,
            frame_hz,
            rate_hz,
            scale: parameters.all_numbers("ANALOG", "SCALE"),
            offset: parameters.all_numbers("ANALOG", "OFFSET"),
            general_scale: parameters.number("ANALOG", "GEN_SCALE").unwrap_or(1.0),
        })
    }

    /// Adds `factor` times the samples of a channel (index from 0) to `sum`. If a sample is not finite, the sum is NaN at this sample.
    pub fn add(&self, channel: usize, factor: f64, sum: &mut [f64]) {
        let scale = self.scale.get(channel).copied().unwrap_or(1.0) * self.general_scale * factor;
        let offset = self.offset.get(channel).map_or(0.0, |o| {
            if self.unsigned && *o < 0.0 {
                o + 65536.0
            } else {
                *o
            }
        });
        for (i, x) in sum.iter_mut().enumerate() {
            let (frame, k) = (i / self.per_frame, i % self.per_frame);
            let place = 4 * self.points + k * self.channels + channel;
            let value = self
                .value(frame, place, self.unsigned)
                .filter(|r| r.is_finite())
                .map_or(f64::NAN, |r| (r - offset) * scale);
            *x += value;
        }
    }

    /// Position of a marker (counted from 0) in a frame, in the axes of the file; `None` if the marker was not visible. Positions that are
    /// stored as integers are not scaled.
    pub fn point(&self, frame: usize, marker: usize) -> Option<[f64; 3]> {
        let mut four = [0.0; 4];
        for (k, x) in four.iter_mut().enumerate() {
            *x = self.value(frame, 4 * marker + k, false)?;
        }
        let [x, y, z, residual] = four;
        let position = [x, y, z];
        let seen = residual >= 0.0 && position.iter().all(|x| x.is_finite());
        (seen && position != [0.0; 3]).then_some(position)
    }

    /// Number at the index `place` of a frame; `unsigned` applies to 16-bit integers. `None` beyond the end of the data.
    fn value(&self, frame: usize, place: usize, unsigned: bool) -> Option<f64> {
        let width = if self.is_float { 4 } else { 2 };
        let at = frame * self.frame + place * width;
        if self.is_float {
            self.words.f32(self.data, at).map(f64::from)
        } else if unsigned {
            self.words.u16(self.data, at).map(f64::from)
        } else {
            self.words.i16(self.data, at).map(f64::from)
        }
    }

    /// Number format and storage of the file.
    pub fn format(&self) -> Format {
        Format::C3d {
            processor: self.words,
            storage: if self.is_float {
                Storage::Floats
            } else {
                Storage::Integers
            },
        }
    }
}

/// Number of analog values in one frame, for all channels together, and number of samples of one channel in a frame.
///
/// Some programs write the number of channels instead of the number of values in the header.
fn values_per_frame(
    path: &Path,
    values: usize,
    samples: usize,
    parameters: &Parameters,
) -> Result<(usize, usize)> {
    let used = parameters.number("ANALOG", "USED");
    if samples > 1 && used == Some(values as f64) {
        return Ok((values * samples, samples));
    }
    if values == 0 || samples == 0 {
        return Err(ReadError::NoAnalog.at_byte(path, 4));
    }
    if !values.is_multiple_of(samples) {
        return Err(ReadError::OddAnalog { values, samples }.at_byte(path, 18));
    }
    Ok((values, samples))
}

/// Numbers of frames and of analog samples per second; `None` if the file contains neither.
fn rates(in_header: f64, per_frame: usize, parameters: &Parameters) -> Option<(f64, f64)> {
    let is_rate = |r: &f64| r.is_finite() && *r > 0.0;
    let frame_hz = [parameters.number("POINT", "RATE"), Some(in_header)]
        .into_iter()
        .flatten()
        .find(is_rate);
    let rate_hz = frame_hz
        .map(|r| r * per_frame as f64)
        .or(parameters.number("ANALOG", "RATE"))
        .filter(is_rate)?;
    Some((frame_hz.unwrap_or(rate_hz / per_frame as f64), rate_hz))
}

fn start_of_data(in_header: usize, parameters: &Parameters) -> usize {
    let named = parameters.number("POINT", "DATA_START");
    let named = named.map_or(0, |block| block as usize);
    let block = if in_header > 0 { in_header } else { named };
    block.saturating_sub(1) * BLOCK
}

/// Number of frames announced in the header or the parameters. `None` if the number exceeds 16 bits and no parameter contains it.
fn announced_frames(first: usize, last: usize, parameters: &Parameters) -> Option<usize> {
    let field = |name| {
        let words = parameters.numbers("TRIAL", name);
        // Two 16-bit words, the low word first.
        let unsigned = |x: &f64| if *x < 0.0 { x + 65536.0 } else { *x };
        match words.as_slice() {
            [low, high, ..] => Some(unsigned(low) + 65536.0 * unsigned(high)),
            _ => None,
        }
    };
    if let (Some(a), Some(b)) = (field("ACTUAL_START_FIELD"), field("ACTUAL_END_FIELD"))
        && b >= a
    {
        return Some((b - a) as usize + 1);
    }
    if last == 65535 {
        return parameters
            .number("POINT", "LONG_FRAMES")
            .filter(|f| *f >= 1.0)
            .map(|f| f as usize);
    }
    Some((last + 1).saturating_sub(first))
}
