//! Tuning constants of the solvers, with reasons. None of them is a key of a scene.

/// Tolerance of a finished law: a stroke, whose top and bottom may each use it, keeps 1e-9 of its value.
pub const TOLERANCE: f64 = 4e-10;

/// Groups of settings with default values, one line per setting.
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
        /// Relative excess below which a limit counts as satisfied.
        tolerance: f64 = TOLERANCE,
        /// Settings of least squares under equalities.
        equality: EqualitySettings = EqualitySettings::default(),
        /// Settings of the dual active-set method.
        active_set: ActiveSetSettings = ActiveSetSettings::default(),
        /// Settings of the proximal steps for minimax objectives.
        proximal: ProximalSettings = ProximalSettings::default(),
        /// Settings of separation and interior-point iterations.
        exchange: ExchangeSettings = ExchangeSettings::default(),
        /// Settings of a limit on a root mean square.
        rms: RmsSettings = RmsSettings::default(),
        /// Settings of Newton's method on the contacts.
        refinement: RefinementSettings = RefinementSettings::default(),
        /// Settings of the duality gap.
        certificate: CertificateSettings = CertificateSettings::default(),
    }

    /// Settings of the least squares under equalities.
    EqualitySettings {
        /// Relative pivot below which equalities depend on the others, or contradict them.
        dependent: f64 = 1e-11,
        /// Relative residual of a dependent equality above which it is a contradiction.
        consistent: f64 = 1e-8,
        /// Weight, relative to H, that fixes a level which limits may move.
        light_pin: f64 = 1e-6,
        /// Curvature along the constant function, relative to the maximum, below which the level is open …
        level_is_free: f64 = 1e-10,
        /// … unless the entries of an equality sum to more than this fraction of their magnitude.
        fixes_level: f64 = 1e-6,
    }

    /// Settings of the dual active-set method.
    ActiveSetSettings {
        /// Maximum number of separation iterations before the interior-point method is used.
        rounds: usize = 60,
        /// Maximum number of steps over all iterations, per unknown.
        steps_per_unknown: usize = 60,
        /// Number of initial rows above which a dense basis is avoided.
        rows: usize = 1000,
        /// Maximum number of active rows; more are left to the interior-point method.
        active: usize = 400,
        /// Excess relative to the limit's scale above which a row is violated; far below the tolerance of the iterations.
        resolved: f64 = 1e-12,
        /// Violation below which a law without further progress is accepted as exact to rounding.
        resolved_at_last: f64 = 1e-7,
        /// Fraction of the smallest violation above which an iteration made no progress …
        progress: f64 = 0.9,
        /// … and number of such iterations that end the method.
        patience: usize = 4,
        /// Fraction of its squared length outside the span of the active rows below which a row is dependent.
        dependent: f64 = 1e-13,
        /// Distance (relative to the piece) from an old row of the same limit below which a new row replaces it.
        coincident: f64 = 1e-5,
        /// Maximum number of iterations that refine contacts.
        refinements: usize = 8,
        /// Maximum number of moves of the pin of an open level …
        pin_moves: usize = 12,
        /// … until the level moves by at most this fraction of the typical lift.
        pin_settled: f64 = 1e-9,
    }

    /// Settings of the proximal steps for minimax objectives.
    ProximalSettings {
        /// ε: initial weight of a change of the law by its own size, in units of the peak …
        nearness: f64 = 1e-2,
        /// … final weight …
        least_nearness: f64 = 1e-9,
        /// … factor from one centre to the next …
        fall: f64 = 0.2,
        /// … and factor after a step that ends in rounding errors.
        heavier: f64 = 100.0,
        /// Decrease of the peak, as a fraction of the predicted one, above which a law becomes the centre.
        kept: f64 = 0.3,
        /// Fraction of the gap that a step may leave if its rows are those of its law.
        proved: f64 = 0.3,
        /// Relative excess over other limits below which laws are compared by their peaks.
        compared: f64 = 1e-4,
        /// Maximum number of iterations of rows and centres; 20 are usual.
        rounds: usize = 150,
        /// Factor of the refinement threshold within which the search stops.
        accepted: f64 = 1e3,
        /// Number of iterations without a better certificate that end the search.
        patience: usize = 25,
    }

    /// Settings of the search for the weight of a root-mean-square limit.
    RmsSettings {
        /// Tolerance of the limits in the initial program with a cone.
        rough: f64 = 1e-6,
        /// First step of ln p, doubled each time.
        peak_step: f64 = 0.2,
        /// First step of ln μ, relative to the logarithm of the excess …
        step: f64 = 4.0,
        /// … at least this, quadrupled each time …
        least_step: f64 = 1e-6,
        /// … for this number of steps; also for a peak.
        steps: usize = 24,
        /// Relative distance of the smallest trial peak from the minimum.
        pinch: f64 = 2e-7,
        /// Number of trial weights between two others.
        weights: usize = 40,
        /// Difference of logarithms below which weights are equal.
        same_weight: f64 = 1e-11,
        /// Relative gap of the law between two optima.
        gap: f64 = 1e-10,
    }

    /// Settings of Newton's method on the contacts.
    RefinementSettings {
        /// Relative gap below which no refinement is needed …
        gap: f64 = 1e-7,
        /// … and stationarity, which often ends at 1e-7 with a closed gap. A law is certified with both below 1e-6.
        stationarity: f64 = 3e-7,
        /// Tolerance above which a program is a step of a sequence and is not refined.
        finest_tolerance: f64 = TOLERANCE,
        /// Maximum number of steps on the banded factor; three are usual.
        band_steps: usize = 5,
        /// Maximum number of dense steps; a handful is usual.
        steps: usize = 12,
        /// Maximum number of dense systems in all, since rows leave one by one.
        solves: usize = 40,
        /// Number of steps without a better certificate that end the search.
        patience: usize = 4,
        /// Gap and stationarity at which the search ends …
        clean: f64 = 1e-8,
        /// … and those accepted if rounding prevents better ones.
        proved: f64 = 1e-6,
        /// Relative violation below which contacts are refined together.
        from: f64 = 1e-3,
        /// Ratio to the initial violation above which a step has lost its contacts.
        divergence: f64 = 30.0,
        /// Relative distance from the bound within which maxima are candidates.
        below: f64 = 0.05,
        /// Relative decrease over the width of a piece below which a limit has no contact point.
        flat: f64 = 1e-6,
        /// Distance, as a fraction of a piece, below which contacts coincide.
        same: f64 = 1e-7,
        /// Multiplier relative to the largest below which a row is not a contact.
        weakest: f64 = 1e-6,
        /// Negative multiplier relative to the largest below which a row is not active.
        negative_multiplier: f64 = 1e-9,
        /// Maximum number of rows per unknown that determine a vertex.
        rows_per_unknown: usize = 24,
        /// Maximum number of iterations in which violated points join a step …
        joins: usize = 8,
        /// … with at least this relative violation …
        resolved: f64 = 1e-10,
        /// … and no row of the limit nearer than this fraction of a piece.
        apart: f64 = 0.25,
        /// Maximum size of a dense system.
        largest: usize = 500,
        /// Proximal weight of the step, in units of the solver …
        held: f64 = 1e-9,
        /// … multiplied by this factor …
        raised: f64 = 100.0,
        /// … at most this number of times while the matrix cannot be factorised.
        raises: i32 = 4,
        /// Proximal weight of the multipliers, for linearly dependent rows.
        light: f64 = 1e-13,
        /// Maximum number of steps of the quadratic program, per unknown; two are usual.
        steps_per_unknown: usize = 10,
        /// Excess at which one of its planes is satisfied.
        step_resolved: f64 = 1e-14,
        /// As `ActiveSetSettings::dependent`, for its planes.
        dependent: f64 = 1e-25,
        /// Violation of a dependent plane below which it is attributed to rounding.
        rounding: f64 = 1e-9,
    }

    /// Settings of the rounds of separation and interior-point solution.
    ExchangeSettings {
        /// Maximum number of iterations; a handful is usual.
        rounds: usize = 60,
        /// Fraction of the smallest violation above which an iteration has stalled.
        stalled: f64 = 0.5,
        /// After a stall, margin of every limit as a multiple of the violation, added to the previous margin …
        margin_growth: f64 = 2.0,
        /// … limited to this fraction of the scale.
        largest_margin: f64 = 1e-6,
        /// Residual of the solver for a second-order cone, which is not refined.
        cone_margin: f64 = 1e-7,
        /// Distance (relative to the piece) from an old row of the same limit below which a new row replaces it.
        coincident: f64 = 1e-4,
        /// Gap and feasibility tolerance of the interior-point method: tighter ones end in "insufficient progress" on some
        /// fits, and refinement restores the digits.
        solver_tolerance: f64 = 1e-9,
        /// Maximum number of iterations of the interior-point method; 20 are usual.
        solver_iterations: u32 = 200,
    }

    /// Settings of the certificate.
    CertificateSettings {
        /// Objective relative to its terms below which it is a rounding error: a force error of a thousandth of the force.
        least_objective: f64 = 1e-6,
        /// Fraction of the objective below which xᵀr is small.
        small: f64 = 1e-9,
        /// As `ActiveSetSettings::dependent`, for equalities.
        dependent: f64 = 1e-20,
    }
}
