//! Requirements of a random scene in SI units, and its scene file.

use super::swing::Train;
use gaitcam::force::ForceCurve;
use std::fmt::Write;

/// Minimised quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Objective {
    ForceError,
    PeakForceError,
    /// Mean square of a derivative by angle.
    Energy(usize),
    /// Largest absolute value of a derivative by angle.
    Peak(usize),
    /// Base radius of a flat-faced cam.
    Size,
}

/// Range of the cycle with its weight of the force error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    pub from: f64,
    pub to: f64,
    pub weight: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    pub angle: f64,
    pub lift: f64,
    pub velocity: Option<f64>,
    pub acceleration: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dwell {
    pub from: f64,
    pub to: f64,
    pub lift: Option<f64>,
}

/// Limits by time, SI units.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Limits {
    pub stroke: Option<f64>,
    pub velocity: Option<f64>,
    pub acceleration: Option<f64>,
    pub jerk: Option<f64>,
    pub force_min: Option<f64>,
    pub force_max: Option<f64>,
    pub curvature: Option<f64>,
    pub prime_radius: Option<f64>,
    /// Maximum pressure angles of rise and fall, rad.
    pub pressure_angle: [Option<f64>; 2],
}

/// Follower with its lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Follower {
    /// Flat face, with the radius of the base circle, m, if given.
    Flat { base: Option<f64> },
    /// Knife edge on a given prime circle with an offset, m.
    Knife { prime: f64, offset: f64 },
}

/// Requirements of a random scene.
#[derive(Debug, Clone)]
pub struct Asked {
    pub degree: usize,
    pub spans: usize,
    /// Weights of s, v and a in the force: k, cω, mω².
    pub weights: [f64; 3],
    /// Force at lift 0, N.
    pub rest: f64,
    /// Speed of the cam, rad/s.
    pub speed: f64,
    /// Target force as scaled by the drive, and as given to the library.
    pub target: Option<(ForceCurve, ForceCurve)>,
    pub objective: Objective,
    pub follower: Follower,
    pub points: Vec<Point>,
    pub dwells: Vec<Dwell>,
    pub limits: Limits,
    /// Weights of the force error.
    pub ranges: Vec<Range>,
    /// Half-width of the band around the target for the force, N.
    pub band: Option<f64>,
    /// Compliant follower whose vibration in dwells is limited.
    pub train: Option<Train>,
    /// Tables `[gait]` and `[drive]` of the scene file.
    pub machine: String,
}

impl Asked {
    /// Whether spring, points or dwells determine the level of the law.
    pub fn level_is_known(&self) -> bool {
        let dwelt = self.dwells.iter().any(|d| d.lift.is_some());
        self.weights[0] != 0.0 || !self.points.is_empty() || dwelt
    }

    /// Whether the law must be placed on its base circle for its limits to have a meaning.
    pub fn touches(&self) -> bool {
        let sized = match self.follower {
            Follower::Flat { base } => {
                self.limits.curvature.is_some() && (base.or(self.limits.prime_radius)).is_some()
            }
            Follower::Knife { .. } => true,
        };
        sized && !self.level_is_known()
    }

    /// Weight of the force error at an angle. Where ranges overlap, the last one holds.
    pub fn weight(&self, theta: f64) -> f64 {
        let inside = |r: &&Range| {
            let (from, to) = (r.from, r.to);
            if from < to {
                theta >= from && theta < to
            } else {
                theta >= from || theta < to
            }
        };
        self.ranges
            .iter()
            .rev()
            .find(inside)
            .map_or(1.0, |r| r.weight)
    }

    /// Largest lift that is given or that the force alone would need, m.
    pub fn length(&self) -> f64 {
        let dwelt = self.dwells.iter().filter_map(|d| d.lift);
        let written = self.points.iter().map(|p| p.lift).chain(dwelt);
        let gain: f64 = self.weights.iter().sum();
        let forced = self
            .target
            .as_ref()
            .filter(|_| gain > 0.0)
            .map_or(0.0, |t| {
                let far = t.0.force_n.iter().map(|f| (f - self.rest).abs());
                far.fold(0.0, f64::max) / gain
            });
        written.fold(forced, |most, x| most.max(x.abs()))
    }

    /// Scene as a TOML file.
    pub fn toml(&self) -> String {
        let mut out = String::from("name = \"guard\"\n");
        self.write(&mut out).expect("text grows");
        out
    }

    fn write(&self, out: &mut String) -> std::fmt::Result {
        let gait = match self.band {
            Some(half) => format!("[gait]\nband = \"{half} N\"\n"),
            None => "[gait]\n".to_string(),
        };
        write!(out, "{}", self.machine.replacen("[gait]\n", &gait, 1))?;
        if let Some(train) = &self.train {
            let hertz = train.own / std::f64::consts::TAU;
            writeln!(out, "[machine]\nnatural_frequency = \"{hertz} Hz\"")?;
            writeln!(out, "damping_ratio = {}", train.ratio)?;
        }
        self.write_follower(out)?;
        self.write_limits(out)?;
        self.write_law(out)?;
        self.write_demands(out)
    }

    fn write_follower(&self, out: &mut String) -> std::fmt::Result {
        match self.follower {
            Follower::Flat { base } => {
                writeln!(out, "[cam]\nfollower = \"flat-translating\"")?;
                if let Some(base) = base {
                    writeln!(out, "base_radius = \"{base} m\"")?;
                }
            }
            Follower::Knife { prime, offset } => writeln!(
                out,
                "[cam]\nfollower = \"knife-translating\"\nprime_radius = \"{prime} m\"\noffset = \"{offset} m\""
            )?,
        }
        Ok(())
    }

    fn write_limits(&self, out: &mut String) -> std::fmt::Result {
        let limits = &self.limits;
        // The reference knows no accuracy: another test compares that with a cone program.
        writeln!(out, "[accuracy]\nrms = \"none\"\n[limits]")?;
        for (key, value, unit) in [
            ("stroke", limits.stroke, "m"),
            ("velocity", limits.velocity, "m/s"),
            ("acceleration", limits.acceleration, "m/s^2"),
            ("jerk", limits.jerk, "m/s^3"),
            ("force_min", limits.force_min, "N"),
            ("force_max", limits.force_max, "N"),
            ("curvature", limits.curvature, "m"),
            ("prime_radius", limits.prime_radius, "m"),
            ("residual", self.train.map(|t| t.most), "m"),
            ("pressure_angle_rise", limits.pressure_angle[0], "rad"),
            ("pressure_angle_fall", limits.pressure_angle[1], "rad"),
        ] {
            if let Some(value) = value {
                writeln!(out, "{key} = \"{value} {unit}\"")?;
            }
        }
        Ok(())
    }

    fn write_law(&self, out: &mut String) -> std::fmt::Result {
        let (degree, spans) = (self.degree, self.spans);
        writeln!(
            out,
            "[law]\nfamily = \"spline\"\ndegree = {degree}\nspans = {spans}"
        )?;
        let derivative = |k: usize| ["lift", "velocity", "acceleration", "jerk", "snap"][k];
        match self.objective {
            Objective::ForceError if self.band.is_none() => {}
            Objective::ForceError => writeln!(out, "minimise = \"force-error\"")?,
            Objective::PeakForceError => writeln!(out, "minimise = \"peak-force-error\"")?,
            Objective::Energy(k) => writeln!(out, "minimise = \"{}\"", derivative(k))?,
            Objective::Peak(k) => writeln!(out, "minimise = \"peak-{}\"", derivative(k))?,
            Objective::Size => writeln!(out, "minimise = \"size\"")?,
        }
        Ok(())
    }

    /// Writes points, weights of the force and dwells.
    fn write_demands(&self, out: &mut String) -> std::fmt::Result {
        for p in &self.points {
            writeln!(out, "[[law.point]]\nangle = \"{} rad\"", p.angle)?;
            writeln!(out, "lift = \"{} m\"", p.lift)?;
            if let Some(v) = p.velocity {
                writeln!(out, "velocity = \"{v} m/rad\"")?;
            }
            if let Some(a) = p.acceleration {
                writeln!(out, "acceleration = \"{a} m/rad^2\"")?;
            }
        }
        for range in &self.ranges {
            let Range { from, to, weight } = range;
            writeln!(
                out,
                "[[gait.weight]]\nfrom = \"{from} rad\"\nto = \"{to} rad\"\nweight = {weight}"
            )?;
        }
        for d in &self.dwells {
            writeln!(
                out,
                "[[law.dwell]]\nfrom = \"{} rad\"\nto = \"{} rad\"",
                d.from, d.to
            )?;
            if let Some(lift) = d.lift {
                writeln!(out, "lift = \"{lift} m\"")?;
            }
        }
        Ok(())
    }
}
