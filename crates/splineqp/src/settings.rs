//! Every tuning constant of the solvers, with its reason. None of them is a setting of a scene.

/// Tolerance of a finished law: a stroke, whose top and bottom each take it, still keeps 1e-9 of its value.
pub const TOLERANCE: f64 = 4e-10;

/// Groups of settings, each with its value: a line for a setting.
macro_rules! settings {
    ($($(#[$about:meta])* $group:ident { $($(#[$doc:meta])* $name:ident: $kind:ty = $value:expr,)* })*) => {
        $(
            $(#[$about])*
            #[derive(Debug, Clone, Copy, PartialEq)]
            pub struct $group {
                $($(#[$doc])* pub $name: $kind,)*
            }

            impl Default for $group {
                fn default() -> Self {
                    $group { $($name: $value,)* }
                }
            }
        )*
    };
}

settings! {
    /// Settings of a program's solution.
    Settings {
        /// A limit counts as kept when it is exceeded by no more than this part of its scale.
        tolerance: f64 = TOLERANCE,
        /// Least squares under equalities.
        equality: EqualitySettings = EqualitySettings::default(),
        /// Dual active-set method.
        active_set: ActiveSetSettings = ActiveSetSettings::default(),
        /// Proximal steps towards a least peak.
        proximal: ProximalSettings = ProximalSettings::default(),
        /// Rounds of separation and interior-point solution.
        exchange: ExchangeSettings = ExchangeSettings::default(),
        /// Weight of a limit on a root mean square.
        rms: RmsSettings = RmsSettings::default(),
        /// Newton's method on the contacts.
        refinement: RefinementSettings = RefinementSettings::default(),
        /// Duality gap.
        certificate: CertificateSettings = CertificateSettings::default(),
    }

    /// Settings of the least squares under equalities.
    EqualitySettings {
        /// Equalities whose pivot falls below this part of the first follow from the others, or contradict them.
        dependent: f64 = 1e-11,
        /// A dependent equality may miss its value by this part of its own scale before it is a contradiction.
        consistent: f64 = 1e-8,
        /// Weight, in units of H, that holds a level which limits may move.
        light_pin: f64 = 1e-6,
        /// An objective whose curvature along the constant function is below this part of the largest leaves the level open …
        level_is_free: f64 = 1e-10,
        /// … unless the entries of an equality sum to more than this part of their size.
        fixes_level: f64 = 1e-6,
    }

    /// Settings of the dual active-set method.
    ActiveSetSettings {
        /// Rounds of separation before the interior-point method takes over.
        rounds: usize = 60,
        /// Steps over all rounds, per unknown, before it takes over.
        steps_per_unknown: usize = 60,
        /// More rows than this at the start are cheaper without a dense basis.
        rows: usize = 1000,
        /// More active rows than this are left to the interior-point method.
        active: usize = 400,
        /// A row counts as violated beyond this part of its limit's size; far below the rounds' own tolerance.
        resolved: f64 = 1e-12,
        /// When progress ends, a law that violates limits by less than this is accepted: the rest is rounding.
        resolved_at_last: f64 = 1e-7,
        /// A round that leaves more than this part of the least violation makes no progress …
        progress: f64 = 0.9,
        /// … and after so many of them progress has ended.
        patience: usize = 4,
        /// A row whose part outside the span of the active ones is below this share of its square length
        /// depends on them.
        dependent: f64 = 1e-13,
        /// A new row this near (in units of its piece) to an old one of the same limit replaces it.
        coincident: f64 = 1e-5,
        /// Rounds in which contacts are refined, at most.
        refinements: usize = 8,
        /// The pin of an open level is moved at most this often …
        pin_moves: usize = 12,
        /// … until the level moves by no more than this part of the typical lift.
        pin_settled: f64 = 1e-9,
    }

    /// Settings of the proximal steps towards a least peak.
    ProximalSettings {
        /// ε: weight of a change of the law by its own size, in units of the peak, at first …
        nearness: f64 = 1e-2,
        /// … at last …
        least_nearness: f64 = 1e-9,
        /// … and from one centre to the next …
        fall: f64 = 0.2,
        /// … and times as much where rounding ends a step.
        heavier: f64 = 100.0,
        /// A law becomes the centre when its own peak falls by this part of what the rows promise.
        kept: f64 = 0.3,
        /// Part of the gap that a step may leave where its rows are those of its law.
        proved: f64 = 0.3,
        /// Laws that exceed other limits by less than this part of them are compared by their peaks.
        compared: f64 = 1e-4,
        /// Rounds of rows and centres; 20 are usual.
        rounds: usize = 150,
        /// Stop within this factor of the refinement threshold.
        accepted: f64 = 1e3,
        /// Rounds without a better certificate that end the search.
        patience: usize = 25,
    }

    /// Settings of the search for the weight of a limit on a root mean square.
    RmsSettings {
        /// Tolerance of the limits in the program with a cone, where the search begins.
        rough: f64 = 1e-6,
        /// First step of ln p, twice as long each time.
        peak_step: f64 = 0.2,
        /// First step of ln μ, in parts of the logarithm by which the limit is missed …
        step: f64 = 4.0,
        /// … no shorter than this, and four times as long each time …
        least_step: f64 = 1e-6,
        /// … so many times; of a peak too.
        steps: usize = 24,
        /// The least peak that is tried is larger than the least one there is by this part.
        pinch: f64 = 2e-7,
        /// Weights tried between two.
        weights: usize = 40,
        /// Weights whose logarithms are nearer than this are one.
        same_weight: f64 = 1e-11,
        /// Gap of the law between two optima, as a part of the objective.
        gap: f64 = 1e-10,
    }

    /// Settings of Newton's method on the contacts.
    RefinementSettings {
        /// Relative gap that needs no refinement …
        gap: f64 = 1e-7,
        /// … and stationarity, which often ends at 1e-7 where the gap is closed. A law is certified with both below 1e-6.
        stationarity: f64 = 3e-7,
        /// Programs of a coarser tolerance are steps of a sequence and are not refined.
        finest_tolerance: f64 = TOLERANCE,
        /// Steps on the banded factor; three are usual.
        band_steps: usize = 5,
        /// Dense steps; a handful is usual.
        steps: usize = 12,
        /// Dense systems solved in all: rows leave one by one.
        solves: usize = 40,
        /// Steps without a better certificate that end the search.
        patience: usize = 4,
        /// Gap and stationarity that end the search …
        clean: f64 = 1e-8,
        /// … and those accepted where rounding permits no better.
        proved: f64 = 1e-6,
        /// Contacts are refined together once limits are violated by less than this part of their scale.
        from: f64 = 1e-3,
        /// Steps to violations this many times those at the start have lost their contacts.
        divergence: f64 = 30.0,
        /// Peaks as far below the bound as this part of the limit's scale are candidates.
        below: f64 = 0.05,
        /// A limit that falls by less than this part of its scale over a piece's width has no contact point.
        flat: f64 = 1e-6,
        /// Contacts nearer than this part of a piece are one.
        same: f64 = 1e-7,
        /// Rows whose multiplier is below this part of the largest are no contacts.
        weakest: f64 = 1e-6,
        /// A multiplier below zero by this part of the largest means that the row is not active.
        negative_multiplier: f64 = 1e-9,
        /// More rows than this per unknown do not determine a vertex.
        rows_per_unknown: usize = 24,
        /// Rounds in which places that a step violates join it …
        joins: usize = 8,
        /// … by more than this part of the limit's size …
        resolved: f64 = 1e-10,
        /// … where no row of the limit is nearer than this part of a piece.
        apart: f64 = 0.25,
        /// Larger dense systems are not solved.
        largest: usize = 500,
        /// Proximal weight of the step, in the solver's units …
        held: f64 = 1e-9,
        /// … raised by this factor …
        raised: f64 = 100.0,
        /// … at most so often while the matrix has no factor.
        raises: i32 = 4,
        /// Proximal weight of the multipliers, for rows that depend on each other.
        light: f64 = 1e-13,
        /// Steps of the quadratic program, per unknown; two are usual.
        steps_per_unknown: usize = 10,
        /// Excess at which a plane of it is satisfied.
        step_resolved: f64 = 1e-14,
        /// As `ActiveSetSettings::dependent`, for its planes.
        dependent: f64 = 1e-25,
        /// A plane that depends on the active ones and is violated by less than this is left to rounding.
        rounding: f64 = 1e-9,
    }

    /// Settings of the rounds of separation and interior-point solution.
    ExchangeSettings {
        /// Rounds before giving up; a handful is usual.
        rounds: usize = 60,
        /// Rounds in which contacts are refined, at most: a dense step costs as much as a round.
        refinements: usize = 3,
        /// A round that leaves more than this part of the least violation has stalled.
        stalled: f64 = 0.5,
        /// Then room is kept inside every limit: this many times the violation, and the room of the round before …
        margin_growth: f64 = 2.0,
        /// … but never more than this part of its scale.
        largest_margin: f64 = 1e-6,
        /// What the solver leaves unresolved of a second-order cone, which is not refined.
        cone_margin: f64 = 1e-7,
        /// A new row this near (in units of its piece) to an old one of the same limit replaces it.
        coincident: f64 = 1e-4,
        /// Gap and feasibility tolerance of the interior-point method: tighter ones end in "insufficient progress" on some
        /// fits, and refinement restores the digits.
        solver_tolerance: f64 = 1e-9,
        /// Iterations of the interior-point method; 20 are usual.
        solver_iterations: u32 = 200,
    }

    /// Settings of the certificate.
    CertificateSettings {
        /// An objective below this part of its terms is rounding: a force error of a thousandth of the force.
        least_objective: f64 = 1e-6,
        /// Part of the objective below which xᵀr is small.
        small: f64 = 1e-9,
        /// As `ActiveSetSettings::dependent`, for equalities.
        dependent: f64 = 1e-20,
    }
}
