//! Every tuning constant of the solvers, with its reason. Nothing here is seen by users of a scene.

/// Tolerance of a finished law: a stroke, whose top and bottom each take it, still keeps 1e-9 of its value.
pub const TOLERANCE: f64 = 4e-10;

/// Settings of a program's solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// A limit counts as kept when it is exceeded by no more than this part of its scale.
    pub tolerance: f64,
    /// Least squares under equalities.
    pub equality: EqualitySettings,
    /// Dual active-set method.
    pub active_set: ActiveSetSettings,
    /// Newton's method on the contact points.
    pub local_reduction: LocalReductionSettings,
    /// The same with variables beside the law.
    pub contacts: ContactSettings,
    /// Rounds of separation and interior-point solution.
    pub exchange: ExchangeSettings,
    /// Interior-point method.
    pub interior_point: InteriorPointSettings,
}

/// Settings of the least squares under equalities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EqualitySettings {
    /// Equalities whose pivot falls below this part of the first follow from the others, or contradict them.
    pub dependent: f64,
    /// A dependent equality may miss its value by this part of its own scale before it is a contradiction.
    pub consistent: f64,
    /// Weight, in units of H, that holds a level which limits may move.
    pub light_pin: f64,
}

/// Settings of the dual active-set method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActiveSetSettings {
    /// Rounds of separation before the interior-point method takes over.
    pub rounds: usize,
    /// Steps over all rounds, per unknown, before it takes over.
    pub steps_per_unknown: usize,
    /// More rows than this at the start are cheaper without a dense basis.
    pub rows: usize,
    /// More active rows than this are left to the interior-point method.
    pub active: usize,
    /// A row counts as violated beyond this part of its limit's size; far below the rounds' own tolerance.
    pub resolved: f64,
    /// When progress ends, a law that violates limits by less than this is as good as numbers allow.
    pub resolved_at_last: f64,
    /// A row whose part outside the span of the active ones is below this share of its square length
    /// depends on them.
    pub dependent: f64,
    /// A new row this near (in units of its piece) to an old one of the same limit replaces it.
    pub coincident: f64,
    /// Contact points are moved all together once limits are violated by less than this part of their
    /// scale …
    pub local_reduction_from: f64,
    /// … at most this often.
    pub local_reductions: usize,
    /// The pin of an open level is moved at most this often …
    pub pin_moves: usize,
    /// … until the level moves by no more than this part of the typical lift.
    pub pin_settled: f64,
}

/// Settings of Newton's method on the contact points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalReductionSettings {
    /// Steps; three are usual.
    pub steps: usize,
    /// Steps to violations this many times those at the start have lost their contact points.
    pub divergence: f64,
    /// Peaks as far below the bound as this part of the limit's scale are looked at.
    pub below: f64,
    /// A limit that falls by less than this part of its scale over a piece's width has no contact point.
    pub flat: f64,
    /// A multiplier below zero by this part of the largest means that the row is not active.
    pub negative_multiplier: f64,
}

/// Settings of Newton's method on the contacts of a program with variables beside the law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactSettings {
    /// Limits exceeded by less than this part of their scale are near enough to begin.
    pub from: f64,
    /// Rows whose multiplier is below this part of the largest are no contacts.
    pub weakest: f64,
    /// Steps; a handful is usual.
    pub steps: usize,
    /// Systems solved in all: rows leave one by one.
    pub solves: usize,
    /// Steps to violations this many times those at the start have lost their contacts.
    pub divergence: f64,
    /// Weight that holds a step where neither objective nor contacts do, in the solver's units.
    pub held: f64,
    /// The same for multipliers of rows that depend on each other.
    pub light: f64,
}

/// Settings of the rounds of separation and interior-point solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExchangeSettings {
    /// Rounds before giving up; a handful is usual.
    pub rounds: usize,
    /// A point that violates limits by more than this part of their scale is not polished.
    pub polish_below: f64,
    /// Larger systems are not polished.
    pub polish_size: usize,
    /// Room inside a limit never exceeds this part of its scale.
    pub largest_margin: f64,
    /// What the solver leaves unresolved of a second-order cone, which is not polished.
    pub cone_margin: f64,
    /// A new row this near (in units of its piece) to an old one of the same limit replaces it.
    pub coincident: f64,
    /// Whether a solution a hair outside its limits is exchanged for the nearest one inside.
    pub moves_inside: bool,
}

/// Settings of the interior-point method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InteriorPointSettings {
    /// Gap and feasibility tolerance: tighter ones end in "insufficient progress" on some fits, and
    /// polishing restores the digits.
    pub tolerance: f64,
    /// Iterations; 20 are usual.
    pub iterations: u32,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            tolerance: TOLERANCE,
            equality: EqualitySettings {
                dependent: 1e-11,
                consistent: 1e-8,
                light_pin: 1e-6,
            },
            active_set: ActiveSetSettings {
                rounds: 60,
                steps_per_unknown: 60,
                rows: 400,
                active: 400,
                resolved: 1e-12,
                resolved_at_last: 1e-7,
                dependent: 1e-13,
                coincident: 1e-5,
                local_reduction_from: 1e-3,
                local_reductions: 8,
                pin_moves: 12,
                pin_settled: 1e-9,
            },
            local_reduction: LocalReductionSettings {
                steps: 5,
                divergence: 30.0,
                below: 0.05,
                flat: 1e-6,
                negative_multiplier: 1e-9,
            },
            contacts: ContactSettings {
                from: 1e-3,
                weakest: 1e-6,
                steps: 12,
                solves: 40,
                divergence: 30.0,
                held: 1e-9,
                light: 1e-13,
            },
            exchange: ExchangeSettings {
                rounds: 60,
                polish_below: 1e-5,
                polish_size: 500,
                largest_margin: 1e-6,
                cone_margin: 1e-7,
                coincident: 1e-4,
                moves_inside: true,
            },
            interior_point: InteriorPointSettings {
                tolerance: 1e-9,
                iterations: 200,
            },
        }
    }
}
