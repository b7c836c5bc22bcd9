//! Kinds of follower in a scene.

use serde::{Deserialize, Serialize};

use super::{Follower, Measures};

/// Kind of follower, without its dimensions.
///
/// ```
/// use gaitcam::cam::FollowerKind;
///
/// let kind = FollowerKind::named("roller-oscillating").unwrap();
/// assert!(kind.is_oscillating() && kind.has_roller());
/// assert_eq!(kind.name(), "roller-oscillating");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
#[derive(
    Deserialize, strum::Display, strum::IntoStaticStr, strum::VariantArray, strum::EnumString,
)]
#[strum(serialize_all = "kebab-case")]
pub enum FollowerKind {
    /// A flat face that translates along a line.
    #[default]
    FlatTranslating,
    /// A roller that translates along a line.
    RollerTranslating,
    /// A knife edge that translates along a line.
    KnifeTranslating,
    /// A translating mushroom: a face rounded to an arc, convex towards the cam.
    MushroomTranslating,
    /// A roller on an oscillating arm.
    RollerOscillating,
    /// A knife edge on an oscillating arm.
    KnifeOscillating,
    /// A face rounded to an arc, on an oscillating arm.
    MushroomOscillating,
    /// A flat face on an oscillating arm.
    FlatOscillating,
    /// A roller on a translating cam.
    TranslatingCam,
    /// A roller in the groove of a cylindrical cam.
    Barrel,
}

impl FollowerKind {
    /// All kinds, in the order used in messages.
    pub const ALL: &'static [FollowerKind] = <FollowerKind as strum::VariantArray>::VARIANTS;

    /// Name of the kind in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The kind with this name in a scene file; `None` for an unknown name.
    pub fn named(name: &str) -> Option<FollowerKind> {
        name.parse().ok()
    }

    /// Whether the follower translates on a rotating disc cam and may have an offset.
    pub fn is_translating(self) -> bool {
        matches!(
            self,
            FollowerKind::FlatTranslating
                | FollowerKind::RollerTranslating
                | FollowerKind::KnifeTranslating
                | FollowerKind::MushroomTranslating
        )
    }

    /// Whether the follower oscillates. Its law is then in rad.
    pub fn is_oscillating(self) -> bool {
        matches!(
            self,
            FollowerKind::RollerOscillating
                | FollowerKind::KnifeOscillating
                | FollowerKind::MushroomOscillating
                | FollowerKind::FlatOscillating
        )
    }

    /// Whether the face of the follower is flat.
    pub fn is_flat(self) -> bool {
        matches!(
            self,
            FollowerKind::FlatTranslating | FollowerKind::FlatOscillating
        )
    }

    /// Whether the follower touches the cam with a roller. This is always the case for translating cams and barrel cams.
    pub fn has_roller(self) -> bool {
        matches!(
            self,
            FollowerKind::RollerTranslating
                | FollowerKind::RollerOscillating
                | FollowerKind::TranslatingCam
                | FollowerKind::Barrel
        )
    }

    /// Whether the follower has an arc-shaped face.
    pub fn is_mushroom(self) -> bool {
        matches!(
            self,
            FollowerKind::MushroomTranslating | FollowerKind::MushroomOscillating
        )
    }

    /// Whether law and size are determined together in one optimisation. This is false for a translating cam, which has no size. It is also
    /// false for a barrel and an oscillating mushroom. Their size is determined after the law.
    pub fn has_size_beside_law(self) -> bool {
        !matches!(
            self,
            FollowerKind::MushroomOscillating | FollowerKind::TranslatingCam | FollowerKind::Barrel
        )
    }

    /// Kind of motion of follower and cam, which determines the units of the law.
    pub fn measures(self) -> Measures {
        match self {
            FollowerKind::TranslatingCam => Measures::Straight,
            _ if self.is_oscillating() => Measures::Oscillating,
            _ => Measures::Translating,
        }
    }
}

impl Follower {
    /// Kind of the follower. A roller of radius 0 is a knife edge.
    pub fn kind(&self) -> FollowerKind {
        let knife = self.roller_radius() == 0.0;
        match self {
            Follower::FlatTranslating { .. } => FollowerKind::FlatTranslating,
            Follower::RollerTranslating { .. } if knife => FollowerKind::KnifeTranslating,
            Follower::RollerTranslating { .. } => FollowerKind::RollerTranslating,
            Follower::MushroomTranslating { .. } => FollowerKind::MushroomTranslating,
            Follower::RollerOscillating { .. } if knife => FollowerKind::KnifeOscillating,
            Follower::RollerOscillating { .. } => FollowerKind::RollerOscillating,
            Follower::MushroomOscillating { .. } => FollowerKind::MushroomOscillating,
            Follower::FlatOscillating { .. } => FollowerKind::FlatOscillating,
            Follower::TranslatingCam { .. } => FollowerKind::TranslatingCam,
            Follower::Barrel { .. } => FollowerKind::Barrel,
        }
    }

    /// Kind of motion of follower and cam, which determines the units of the law.
    pub fn measures(&self) -> Measures {
        self.kind().measures()
    }

    /// Name of the kind in a scene file.
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// Whether the face of the follower is flat.
    pub fn is_flat(&self) -> bool {
        self.kind().is_flat()
    }

    /// Whether the follower oscillates. Its law is then in rad.
    pub fn is_oscillating(&self) -> bool {
        self.kind().is_oscillating()
    }
}
