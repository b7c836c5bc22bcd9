//! Scenes made in Rust: every method takes a part and returns it with one thing set, lengths in m, angles in rad.

use super::{
    Band, CamSpec, DriveSpec, Dwell, Family, ForceScale, Gait, LawPoint, LawSpec, Limits,
    MachineSpec, Minimise, Phase, PhaseWeight, Scene, SegmentSpec, Source,
};
use crate::cam::FollowerKind;
use crate::drive::DriveKind;
use crate::error::{Placed, Result};
use crate::force::{self, Feet, ForceCurve};
use crate::law::Rise;

impl Scene {
    /// With another name.
    #[must_use]
    pub fn named(mut self, name: &str) -> Scene {
        self.name = name.to_string();
        self
    }

    /// With a wanted force.
    #[must_use]
    pub fn with_gait(mut self, gait: Gait) -> Scene {
        self.gait = Some(gait);
        self
    }

    /// With another drive.
    #[must_use]
    pub fn with_drive(mut self, drive: DriveSpec) -> Scene {
        self.drive = drive;
        self
    }

    /// With other demands on the law.
    #[must_use]
    pub fn with_law(mut self, law: LawSpec) -> Scene {
        self.law = law;
        self
    }

    /// With another cam; its drive is the usual one of such a cam until [`Scene::with_drive`] says otherwise.
    #[must_use]
    pub fn with_cam(mut self, cam: CamSpec) -> Scene {
        if self.drive.kind == DriveSpec::usual_kind(&self.cam) {
            self.drive.kind = DriveSpec::usual_kind(&cam);
        }
        self.cam = cam;
        self
    }

    /// With other limits.
    #[must_use]
    pub fn with_limits(mut self, limits: Limits) -> Scene {
        self.limits = limits;
        self
    }

    /// With what is known of the machine.
    #[must_use]
    pub fn with_machine(mut self, machine: MachineSpec) -> Scene {
        self.machine = machine;
        self
    }

    /// With an RMS force error asked for, as part of the mean force.
    #[must_use]
    pub fn with_accuracy(mut self, rms: f64) -> Scene {
        self.rms = Some(rms);
        self
    }

    /// The force of the load model that it names; `None` where it names none.
    ///
    /// # Errors
    /// As [`Gait::model_force`].
    pub fn model_force(&self) -> Result<Option<ForceCurve>> {
        let force = self.gait.as_ref().map(Gait::model_force);
        Ok(force.transpose()?.flatten())
    }
}

impl Gait {
    /// The force that the caller hands over with the scene.
    #[must_use]
    pub fn given() -> Gait {
        Gait::default()
    }

    /// With so many steps of the model in a second.
    #[must_use]
    pub fn with_step_frequency(mut self, hertz: f64) -> Gait {
        self.step_frequency = Some(hertz);
        self
    }

    /// With a weight of the model's walker, N.
    #[must_use]
    pub fn with_body_weight(mut self, newtons: f64) -> Gait {
        self.body_weight = Some(newtons);
        self
    }

    /// With the force of these feet.
    #[must_use]
    pub fn with_feet(mut self, feet: Feet) -> Gait {
        self.feet = feet;
        self
    }

    /// Brought to the moved mass in this way.
    #[must_use]
    pub fn with_scale(mut self, scale: ForceScale) -> Gait {
        self.scale = scale;
        self
    }

    /// To be kept within a band instead of followed.
    #[must_use]
    pub fn with_band(mut self, band: Band) -> Gait {
        self.band = Some(band);
        self
    }

    /// With one more range of the cycle that counts more or less than once.
    #[must_use]
    pub fn with_weight(mut self, weight: PhaseWeight) -> Gait {
        self.weights.push(weight);
        self
    }

    /// With this phase of the cycle at cam angle 0.
    #[must_use]
    pub fn with_phase(mut self, phase: Phase) -> Gait {
        self.phase = phase;
        self
    }

    /// The force of its load model; `None` for a recording, which somebody has to read.
    ///
    /// # Errors
    /// An unknown model, or a frequency or weight that it is not made for.
    pub fn model_force(&self) -> Result<Option<ForceCurve>> {
        match &self.source {
            Source::Model(name) => {
                force::model(name, self.step_frequency, self.model_weight(), self.feet)
                    .map(Some)
                    .map_err(|e| e.at_key("gait.model"))
            }
            Source::File(_) => Ok(None),
        }
    }
}

impl DriveSpec {
    /// A shaft block that rides on the cam with a mass, kg.
    #[must_use]
    pub fn moving_axis(mass: f64) -> DriveSpec {
        DriveSpec {
            mass: Some(mass),
            ..DriveSpec::default()
        }
    }

    /// A cam in a fixed bearing that lifts a mass, kg, against a spring, N/m.
    #[must_use]
    pub fn fixed_axis(mass: f64, spring_rate: f64) -> DriveSpec {
        DriveSpec {
            kind: DriveKind::FixedAxis,
            mass: Some(mass),
            spring_rate,
            ..DriveSpec::default()
        }
    }

    /// A piston of a radius, m, in a circuit of a pressure per displaced volume, Pa/m³.
    #[must_use]
    pub fn hydraulic(pressure_per_volume: f64, piston_radius: f64) -> DriveSpec {
        DriveSpec {
            kind: DriveKind::Hydraulic,
            pressure_per_volume,
            piston_radius,
            ..DriveSpec::default()
        }
    }

    /// At a speed of the cam, rad/s.
    #[must_use]
    pub fn with_speed(mut self, speed: f64) -> DriveSpec {
        self.speed = Some(speed);
        self
    }

    /// With a force on the base circle, N.
    #[must_use]
    pub fn with_preload(mut self, preload: f64) -> DriveSpec {
        self.preload = preload;
        self
    }

    /// With damping, N·s/m.
    #[must_use]
    pub fn with_damping(mut self, damping: f64) -> DriveSpec {
        self.damping = damping;
        self
    }
}

impl LawSpec {
    /// Laws of one family.
    #[must_use]
    pub fn of(family: Family) -> LawSpec {
        LawSpec {
            family,
            ..LawSpec::default()
        }
    }

    /// A programme of motions.
    #[must_use]
    pub fn program(segments: Vec<SegmentSpec>) -> LawSpec {
        LawSpec {
            segments,
            ..LawSpec::of(Family::Program)
        }
    }

    /// Chosen for this.
    #[must_use]
    pub fn minimising(mut self, what: Minimise) -> LawSpec {
        self.minimise = Some(what);
        self
    }

    /// Through one more point.
    #[must_use]
    pub fn through(mut self, point: LawPoint) -> LawSpec {
        self.points.push(point);
        self
    }

    /// At rest over one more range.
    #[must_use]
    pub fn resting(mut self, dwell: Dwell) -> LawSpec {
        self.dwells.push(dwell);
        self
    }

    /// With pieces of a degree.
    #[must_use]
    pub fn with_degree(mut self, degree: usize) -> LawSpec {
        self.degree = Some(degree);
        self
    }

    /// With so many spline spans.
    #[must_use]
    pub fn with_spans(mut self, spans: usize) -> LawSpec {
        self.spans = Some(spans);
        self
    }

    /// With so many harmonics.
    #[must_use]
    pub fn with_harmonics(mut self, harmonics: usize) -> LawSpec {
        self.harmonics = Some(harmonics);
        self
    }
}

impl LawPoint {
    /// A lift at a cam angle.
    #[must_use]
    pub fn at(angle: f64, lift: f64) -> LawPoint {
        LawPoint {
            angle,
            lift: Some(lift),
            ..LawPoint::default()
        }
    }
}

impl SegmentSpec {
    /// A motion over a lift and an angle; a fall has a negative lift.
    #[must_use]
    pub fn new(motion: Rise, lift: f64, angle: f64) -> SegmentSpec {
        SegmentSpec {
            motion,
            lift,
            angle,
        }
    }

    /// Rest over an angle.
    #[must_use]
    pub fn dwell(angle: f64) -> SegmentSpec {
        SegmentSpec::new(Rise::Dwell, 0.0, angle)
    }
}

impl CamSpec {
    /// A cam for a kind of follower, its size to be found.
    #[must_use]
    pub fn new(follower: FollowerKind) -> CamSpec {
        CamSpec {
            follower,
            ..CamSpec::default()
        }
    }

    /// With a base radius.
    #[must_use]
    pub fn with_base_radius(mut self, radius: f64) -> CamSpec {
        self.base_radius = Some(radius);
        self
    }

    /// With a prime radius.
    #[must_use]
    pub fn with_prime_radius(mut self, radius: f64) -> CamSpec {
        self.prime_radius = Some(radius);
        self
    }

    /// With a roller, or a mushroom's arc, of a radius.
    #[must_use]
    pub fn with_roller(mut self, radius: f64) -> CamSpec {
        self.roller_radius = radius;
        self
    }

    /// With an offset of the follower.
    #[must_use]
    pub fn with_offset(mut self, offset: f64) -> CamSpec {
        self.offset = Some(offset);
        self
    }

    /// With a follower on an arm of a length about a pivot at a distance.
    #[must_use]
    pub fn with_arm(mut self, pivot_distance: f64, arm: f64) -> CamSpec {
        self.pivot_distance = Some(pivot_distance);
        self.arm = Some(arm);
        self
    }

    /// With a bore of a diameter.
    #[must_use]
    pub fn with_bore(mut self, diameter: f64) -> CamSpec {
        self.bore = Some(diameter);
        self
    }

    /// With a plate of a thickness.
    #[must_use]
    pub fn with_thickness(mut self, thickness: f64) -> CamSpec {
        self.thickness = thickness;
        self
    }
}

impl MachineSpec {
    /// With a follower train of a first natural frequency, Hz, and a damping ratio.
    #[must_use]
    pub fn with_natural_frequency(mut self, hertz: f64, damping_ratio: f64) -> MachineSpec {
        self.natural_frequency = Some(hertz);
        self.damping_ratio = damping_ratio;
        self
    }

    /// With a coefficient of friction where cam and follower rub.
    #[must_use]
    pub fn with_friction(mut self, friction: f64) -> MachineSpec {
        self.friction = friction;
        self
    }

    /// With a coefficient of restitution of landings, 0 … 1.
    #[must_use]
    pub fn with_restitution(mut self, restitution: f64) -> MachineSpec {
        self.restitution = restitution;
        self
    }
}
