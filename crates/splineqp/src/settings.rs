//! Every tuning constant of the solvers, with its reason. None of them is a setting of a scene.

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
    /// Proximal steps towards a least peak.
    pub proximal: ProximalSettings,
    /// Rounds of separation and interior-point solution.
    pub exchange: ExchangeSettings,
    /// Weight of a limit on a root mean square.
    pub rms: RmsSettings,
    /// Newton's method on the contacts.
    pub refinement: RefinementSettings,
    /// Duality gap.
    pub certificate: CertificateSettings,
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
    /// An objective whose curvature along the constant function is below this part of the largest leaves the level open …
    pub level_is_free: f64,
    /// … unless the entries of an equality sum to more than this part of their size.
    pub fixes_level: f64,
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
    /// When progress ends, a law that violates limits by less than this is accepted: the rest is rounding.
    pub resolved_at_last: f64,
    /// A round that leaves more than this part of the least violation makes no progress …
    pub progress: f64,
    /// … and after so many of them progress has ended.
    pub patience: usize,
    /// A row whose part outside the span of the active ones is below this share of its square length
    /// depends on them.
    pub dependent: f64,
    /// A new row this near (in units of its piece) to an old one of the same limit replaces it.
    pub coincident: f64,
    /// Rounds in which contacts are refined, at most.
    pub refinements: usize,
    /// The pin of an open level is moved at most this often …
    pub pin_moves: usize,
    /// … until the level moves by no more than this part of the typical lift.
    pub pin_settled: f64,
}

/// Settings of the proximal steps towards a least peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProximalSettings {
    /// ε: weight of a change of the law by its own size, in units of the peak, at first …
    pub nearness: f64,
    /// … at last …
    pub least_nearness: f64,
    /// … and from one centre to the next …
    pub fall: f64,
    /// … and times as much where rounding ends a step.
    pub heavier: f64,
    /// A law becomes the centre when its own peak falls by this part of what the rows promise.
    pub kept: f64,
    /// Part of the gap that a step may leave where its rows are those of its law.
    pub proved: f64,
    /// Laws that exceed other limits by less than this part of them are compared by their peaks.
    pub compared: f64,
    /// Rounds of rows and centres; 20 are usual.
    pub rounds: usize,
    /// A law whose certificate is open by no more than so many times what needs no refinement is left to that.
    pub accepted: f64,
    /// Rounds without a better certificate that end the search.
    pub patience: usize,
}

/// Settings of the search for the weight of a limit on a root mean square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RmsSettings {
    /// Tolerance of the limits in the program with a cone, where the search begins.
    pub rough: f64,
    /// First step of ln μ or ln p, in parts of the logarithm by which the limit is missed …
    pub step: f64,
    /// … no shorter than this, and four times as long each time …
    pub least_step: f64,
    /// … so many times.
    pub steps: usize,
    /// The least peak that is tried is larger than the least one there is by this part.
    pub pinch: f64,
    /// Weights tried between two.
    pub weights: usize,
    /// Weights whose logarithms are nearer than this are one.
    pub same_weight: f64,
    /// Gap of the law between two optima, as a part of the objective.
    pub gap: f64,
}

/// Settings of Newton's method on the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RefinementSettings {
    /// Relative gap that needs no refinement …
    pub gap: f64,
    /// … and stationarity, which often ends at 1e-7 where the gap is closed. A law is certified with both below 1e-6.
    pub stationarity: f64,
    /// Programs of a coarser tolerance are steps of a sequence and are not refined.
    pub finest_tolerance: f64,
    /// Steps on the banded factor; three are usual.
    pub band_steps: usize,
    /// Dense steps; a handful is usual.
    pub steps: usize,
    /// Dense systems solved in all: rows leave one by one.
    pub solves: usize,
    /// Steps without a better certificate that end the search.
    pub patience: usize,
    /// Gap and stationarity that end the search …
    pub clean: f64,
    /// … and those accepted where rounding permits no better.
    pub proved: f64,
    /// Contacts are refined together once limits are violated by less than this part of their scale.
    pub from: f64,
    /// Steps to violations this many times those at the start have lost their contacts.
    pub divergence: f64,
    /// Peaks as far below the bound as this part of the limit's scale are candidates.
    pub below: f64,
    /// A limit that falls by less than this part of its scale over a piece's width has no contact point.
    pub flat: f64,
    /// Contacts nearer than this part of a piece are one.
    pub same: f64,
    /// Rows whose multiplier is below this part of the largest are no contacts.
    pub weakest: f64,
    /// A multiplier below zero by this part of the largest means that the row is not active.
    pub negative_multiplier: f64,
    /// More rows than this per unknown do not determine a vertex.
    pub rows_per_unknown: usize,
    /// Rounds in which places that a step violates join it …
    pub joins: usize,
    /// … by more than this part of the limit's size …
    pub resolved: f64,
    /// … where no row of the limit is nearer than this part of a piece.
    pub apart: f64,
    /// Larger dense systems are not solved.
    pub largest: usize,
    /// Proximal weight of the step, in the solver's units …
    pub held: f64,
    /// … raised by this factor …
    pub raised: f64,
    /// … at most so often while the matrix has no factor.
    pub raises: i32,
    /// Proximal weight of the multipliers, for rows that depend on each other.
    pub light: f64,
    /// Steps of the quadratic program, per unknown; two are usual.
    pub steps_per_unknown: usize,
    /// Excess at which a plane of it is satisfied.
    pub step_resolved: f64,
    /// As `ActiveSetSettings::dependent`, for its planes.
    pub dependent: f64,
    /// A plane that depends on the active ones and is violated by less than this is left to rounding.
    pub rounding: f64,
}

/// Settings of the rounds of separation and interior-point solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExchangeSettings {
    /// Rounds before giving up; a handful is usual.
    pub rounds: usize,
    /// Rounds in which contacts are refined, at most: a dense step costs as much as a round.
    pub refinements: usize,
    /// A round that leaves more than this part of the least violation has stalled.
    pub stalled: f64,
    /// Then room is kept inside every limit: this many times the violation, and the room of the round before …
    pub margin_growth: f64,
    /// … but never more than this part of its scale.
    pub largest_margin: f64,
    /// What the solver leaves unresolved of a second-order cone, which is not refined.
    pub cone_margin: f64,
    /// A new row this near (in units of its piece) to an old one of the same limit replaces it.
    pub coincident: f64,
    /// Gap and feasibility tolerance of the interior-point method: tighter ones end in "insufficient progress" on some
    /// fits, and refinement restores the digits.
    pub solver_tolerance: f64,
    /// Iterations of the interior-point method; 20 are usual.
    pub solver_iterations: u32,
}

/// Settings of the certificate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CertificateSettings {
    /// An objective below this part of its terms is rounding: a force error of a thousandth of the force.
    pub least_objective: f64,
    /// Part of the objective below which xᵀr is small.
    pub small: f64,
    /// As `ActiveSetSettings::dependent`, for equalities.
    pub dependent: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            tolerance: TOLERANCE,
            equality: EQUALITY,
            active_set: ACTIVE_SET,
            proximal: PROXIMAL,
            exchange: EXCHANGE,
            rms: RMS,
            refinement: REFINEMENT,
            certificate: CERTIFICATE,
        }
    }
}

const EQUALITY: EqualitySettings = EqualitySettings {
    dependent: 1e-11,
    consistent: 1e-8,
    light_pin: 1e-6,
    level_is_free: 1e-10,
    fixes_level: 1e-6,
};

const ACTIVE_SET: ActiveSetSettings = ActiveSetSettings {
    rounds: 60,
    steps_per_unknown: 60,
    rows: 1000,
    active: 400,
    resolved: 1e-12,
    resolved_at_last: 1e-7,
    progress: 0.9,
    patience: 4,
    dependent: 1e-13,
    coincident: 1e-5,
    refinements: 8,
    pin_moves: 12,
    pin_settled: 1e-9,
};

const PROXIMAL: ProximalSettings = ProximalSettings {
    nearness: 1e-2,
    least_nearness: 1e-9,
    fall: 0.2,
    heavier: 100.0,
    kept: 0.3,
    proved: 0.3,
    compared: 1e-4,
    rounds: 150,
    accepted: 1e3,
    patience: 25,
};

const EXCHANGE: ExchangeSettings = ExchangeSettings {
    rounds: 60,
    refinements: 3,
    stalled: 0.5,
    margin_growth: 2.0,
    largest_margin: 1e-6,
    cone_margin: 1e-7,
    coincident: 1e-4,
    solver_tolerance: 1e-9,
    solver_iterations: 200,
};

const CERTIFICATE: CertificateSettings = CertificateSettings {
    least_objective: 1e-6,
    small: 1e-9,
    dependent: 1e-20,
};

const RMS: RmsSettings = RmsSettings {
    rough: 1e-6,
    step: 4.0,
    least_step: 1e-6,
    steps: 16,
    pinch: 2e-7,
    weights: 40,
    same_weight: 1e-11,
    gap: 1e-10,
};

const REFINEMENT: RefinementSettings = RefinementSettings {
    gap: 1e-7,
    stationarity: 3e-7,
    finest_tolerance: TOLERANCE,
    band_steps: 5,
    steps: 12,
    solves: 40,
    patience: 4,
    clean: 1e-8,
    proved: 1e-6,
    from: 1e-3,
    divergence: 30.0,
    below: 0.05,
    flat: 1e-6,
    same: 1e-7,
    weakest: 1e-6,
    negative_multiplier: 1e-9,
    rows_per_unknown: 24,
    joins: 8,
    resolved: 1e-10,
    apart: 0.25,
    largest: 500,
    held: 1e-9,
    raised: 100.0,
    raises: 4,
    light: 1e-13,
    steps_per_unknown: 10,
    step_resolved: 1e-14,
    dependent: 1e-25,
    rounding: 1e-9,
};
