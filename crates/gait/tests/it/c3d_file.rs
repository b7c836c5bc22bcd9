//! Writes small C3D files with force plates, for tests: every processor, storage and plate type.

/// Number format of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Processor {
    Intel,
    Dec,
    Sgi,
}

/// Properties of a synthetic file.
#[derive(Debug, Clone, Copy)]
pub struct Build {
    pub processor: Processor,
    pub float: bool,
    /// Number of idle channels before the channels of the plate. More than 255 channels need several parameters.
    pub before: usize,
    /// FORCE_PLATFORM:TYPE of the plate, 1 to 7.
    pub kind: i16,
    /// Analog samples per frame.
    pub per_frame: usize,
    pub frames: usize,
    /// Newtons per unit of an integer sample.
    pub scale: f32,
    /// ANALOG:OFFSET of every channel.
    pub offset: i16,
}

impl Processor {
    fn word(self, x: u16) -> [u8; 2] {
        if self == Processor::Sgi {
            x.to_be_bytes()
        } else {
            x.to_le_bytes()
        }
    }

    fn float(self, x: f32) -> [u8; 4] {
        match self {
            Processor::Intel => x.to_le_bytes(),
            Processor::Sgi => x.to_be_bytes(),
            Processor::Dec => {
                let b = if x == 0.0 {
                    [0; 4]
                } else {
                    (x * 4.0).to_le_bytes()
                };
                [b[2], b[3], b[0], b[1]]
            }
        }
    }
}

/// A marker: its label, and its position in mm in each frame in which it is visible.
pub type Marker<'a> = (&'a str, &'a dyn Fn(usize) -> Option<[f64; 3]>);

struct Writer {
    p: Processor,
    out: Vec<u8>,
}

impl Writer {
    fn record(&mut self, id: i8, name: &str, body: &[u8]) {
        self.out.push(name.len() as u8);
        self.out.push(id.cast_unsigned());
        self.out.extend(name.as_bytes());
        let next = (2 + body.len()) as u16;
        self.out.extend(self.p.word(next));
        self.out.extend(body);
    }

    fn group(&mut self, id: i8, name: &str) {
        self.record(-id, name, &[0]);
    }

    fn ints(&mut self, id: i8, name: &str, dims: &[u8], values: &[i16]) {
        let mut body = vec![2, dims.len() as u8];
        body.extend(dims);
        for v in values {
            body.extend(self.p.word(v.cast_unsigned()));
        }
        body.push(0);
        self.record(id, name, &body);
    }

    fn floats(&mut self, id: i8, name: &str, dims: &[u8], values: &[f32]) {
        let mut body = vec![4, dims.len() as u8];
        body.extend(dims);
        for v in values {
            body.extend(self.p.float(*v));
        }
        body.push(0);
        self.record(id, name, &body);
    }

    fn texts(&mut self, id: i8, name: &str, length: u8, values: &[&str]) {
        let mut body = vec![0xFF, 2, length, values.len() as u8];
        for v in values {
            body.extend(format!("{v:<width$}", width = length as usize).bytes());
        }
        body.push(0);
        self.record(id, name, &body);
    }
}

/// Values of the channels of a plate of a given type, for a vertical force.
fn channels(kind: i16, force: f64) -> Vec<f64> {
    match kind {
        3 => vec![
            1.0,
            -1.0,
            2.0,
            -2.0,
            0.1 * force,
            0.2 * force,
            0.3 * force,
            0.4 * force,
        ],
        // TYPE 4: the calibration matrix below doubles the third channel and adds a tenth of the first.
        4 => vec![10.0, 0.0, (force - 1.0) / 2.0, 0.0, 0.0, 0.0],
        // TYPE 5: the same matrix with two more columns, the eighth channel counted whole.
        5 => vec![10.0, 0.0, (force - 21.0) / 2.0, 0.0, 0.0, 0.0, 9.0, 20.0],
        // TYPE 6: Fx, Fy, Fz at each of four corners.
        6 => (0..12)
            .map(|k| match k {
                2 | 5 | 8 | 11 => 0.05 * f64::from(k) * force - 0.075 * force,
                k => 3.0 * f64::from(k),
            })
            .collect(),
        // TYPE 7: four horizontal and four vertical sensors; the matrix halves the vertical ones.
        7 => vec![
            1.0,
            2.0,
            3.0,
            4.0,
            0.2 * force,
            0.4 * force,
            0.6 * force,
            0.8 * force,
        ],
        _ => vec![3.0, -4.0, force, 5.0, 6.0, 7.0],
    }
}

/// Height, width and entries of the calibration matrix of a plate type: one row per force, one column per channel, first index varying fastest.
fn matrix(kind: i16) -> (usize, usize, Vec<f32>) {
    let (high, across) = match kind {
        5 => (6, 8),
        6 => (12, 12),
        7 => (8, 8),
        _ => (6, 6),
    };
    let mut matrix = vec![0.0f32; high * across];
    for i in 0..high {
        matrix[high * i + i] = if kind == 7 && i >= 4 { 0.5 } else { 1.0 };
    }
    if kind == 4 || kind == 5 {
        matrix[2] = 0.1;
        matrix[high * 2 + 2] = 2.0;
    }
    if kind == 5 {
        matrix[high * 7 + 2] = 1.0;
    }
    (high, across, matrix)
}

/// Label of a channel: a letter for the channels of one plate, `c249` and so on for more.
fn label(k: usize) -> String {
    match u8::try_from(k) {
        Ok(k) if k < 26 => char::from(b'a' + k).to_string(),
        _ => format!("c{k}"),
    }
}

/// Parameter section: one plate, a mass of 70 kg and one strike of the right foot at 0.5 s.
fn parameters(b: &Build, count: usize, markers: &[Marker]) -> Vec<u8> {
    let mut w = Writer {
        p: b.processor,
        out: Vec::new(),
    };
    let code = match b.processor {
        Processor::Intel => 84,
        Processor::Dec => 85,
        Processor::Sgi => 86,
    };
    w.out.extend([1, 0x50, 0, code]);
    w.group(1, "POINT");
    w.floats(1, "RATE", &[], &[100.0]);
    w.floats(1, "SCALE", &[], &[if b.float { -0.1 } else { 0.1 }]);
    let labels: Vec<&str> = markers.iter().map(|m| m.0).collect();
    w.texts(1, "LABELS", 16, &labels);
    w.group(2, "ANALOG");
    w.ints(2, "USED", &[], &[count as i16]);
    w.floats(2, "GEN_SCALE", &[], &[1.0]);
    let scales: Vec<f32> = (0..count)
        .map(|k| if k < b.before { 0.5 } else { b.scale })
        .collect();
    let offsets: Vec<i16> = (0..count)
        .map(|k| if k < b.before { 2 } else { b.offset })
        .collect();
    let labels: Vec<String> = (0..count).map(label).collect();
    for (k, from) in (0..count).step_by(255).enumerate() {
        let part = from..count.min(from + 255);
        let name = |name: &str| match k {
            0 => name.to_string(),
            _ => format!("{name}{}", k + 1),
        };
        let length = [part.len() as u8];
        w.floats(2, &name("SCALE"), &length, &scales[part.clone()]);
        w.ints(2, &name("OFFSET"), &length, &offsets[part.clone()]);
        w.texts(2, &name("UNITS"), 4, &vec!["N"; part.len()]);
        let labels: Vec<&str> = labels[part].iter().map(String::as_str).collect();
        w.texts(2, &name("LABELS"), 4, &labels);
    }
    w.group(3, "FORCE_PLATFORM");
    w.ints(3, "USED", &[], &[1]);
    w.ints(3, "TYPE", &[1], &[b.kind]);
    w.ints(3, "ZERO", &[2], &[1, 5]);
    let numbers: Vec<i16> = (b.before as i16 + 1..=count as i16).collect();
    w.ints(3, "CHANNEL", &[numbers.len() as u8, 1], &numbers);
    let (high, across, matrix) = matrix(b.kind);
    w.floats(3, "CAL_MATRIX", &[high as u8, across as u8, 1], &matrix);
    w.group(4, "PROCESSING");
    w.floats(4, "Bodymass", &[], &[70.0]);
    w.group(5, "EVENT");
    w.texts(5, "LABELS", 12, &["Foot Strike"]);
    w.texts(5, "CONTEXTS", 6, &["Right"]);
    w.floats(5, "TIMES", &[2, 1], &[0.0, 0.5]);
    w.out.push(0);
    let blocks = w.out.len().div_ceil(512);
    w.out.resize(512 * blocks, 0);
    w.out[2] = blocks as u8;
    w.out
}

/// File with one plate and `force` (newtons, downwards negative as in plate data), a mass of 70 kg and one strike of the right foot at 0.5 s.
pub fn build(b: &Build, force: impl Fn(usize) -> f64) -> Vec<u8> {
    build_with(b, force, &[("M1", &|_| Some([0.1, 0.2, 0.3]))])
}

/// As [`build`], with markers.
pub fn build_with(b: &Build, force: impl Fn(usize) -> f64, markers: &[Marker]) -> Vec<u8> {
    let count = b.before + channels(b.kind, 0.0).len();
    let parameters = parameters(b, count, markers);
    let blocks = parameters.len() / 512;
    let p = b.processor;
    let mut file = vec![0u8; 512];
    file[0] = 2;
    file[1] = 0x50;
    let words = [markers.len(), count * b.per_frame, 1, b.frames, 10];
    for (i, x) in words.iter().enumerate() {
        file[2 + 2 * i..4 + 2 * i].copy_from_slice(&p.word(*x as u16));
    }
    file[12..16].copy_from_slice(&p.float(if b.float { -0.1 } else { 0.1 }));
    file[16..18].copy_from_slice(&p.word((2 + blocks) as u16));
    file[18..20].copy_from_slice(&p.word(b.per_frame as u16));
    file[20..24].copy_from_slice(&p.float(100.0));
    file.extend(parameters);
    for frame in 0..b.frames {
        let mut put = |x: f64| {
            if b.float {
                file.extend(p.float(x as f32));
            } else {
                file.extend(p.word((x.round() as i16).cast_unsigned()));
            }
        };
        for (_, at) in markers {
            // POINT:SCALE is 0.1 mm for integers; a residual of −1 says that the marker is not seen.
            let unit = if b.float { 1.0 } else { 0.1 };
            let [x, y, z] = at(frame).unwrap_or_default().map(|x| x / unit);
            let residual = if at(frame).is_some() { 0.0 } else { -1.0 };
            for x in [x, y, z, residual] {
                put(x);
            }
        }
        for k in 0..b.per_frame {
            (0..b.before).for_each(|_| put(2.0));
            for x in channels(b.kind, force(frame * b.per_frame + k)) {
                put(x / f64::from(b.scale) + f64::from(b.offset));
            }
        }
    }
    file
}

/// Downward force of one stance of 0.6 s, starting at 0.5 s, sampled at `rate` Hz, with peaks of 770 N and a valley of 455 N.
pub fn one_stance(i: usize, rate: f64) -> f64 {
    let x = (i as f64 / rate - 0.5) / 0.6;
    if (0.0..=1.0).contains(&x) {
        let a = std::f64::consts::PI * x;
        -700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
    } else {
        0.0
    }
}
