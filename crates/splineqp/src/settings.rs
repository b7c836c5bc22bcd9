//! Tuning constants of the solvers, with reasons. They are not keys of a scene.

/// Relative tolerance of a finished law. A stroke, whose maximum and minimum may both use it, is accurate to 1e-9.
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
    /// Settings of the solution of a program.
    Settings {
        /// Relative excess below which a limit counts as satisfied.
        tolerance: f64 = TOLERANCE,
        /// Settings of least squares under equalities.
        equality: EqualitySettings = EqualitySettings::default(),
        /// Settings of the dual active-set method.
        active_set: ActiveSetSettings = ActiveSetSettings::default(),
        /// Settings of the proximal method for minimax objectives.
        proximal: ProximalSettings = ProximalSettings::default(),
        /// Settings of separation and interior-point iterations.
        exchange: ExchangeSettings = ExchangeSettings::default(),
        /// Settings of a limit on a root mean square.
        rms: RmsSettings = RmsSettings::default(),
        /// Settings of the refinement by Newton's method.
        refinement: RefinementSettings = RefinementSettings::default(),
        /// Settings of the duality gap.
        certificate: CertificateSettings = CertificateSettings::default(),
    }

    /// Settings of the least squares under equalities.
    EqualitySettings {
        /// Relative pivot below which an equality depends on the others, or contradicts them.
        dependent: f64 = 1e-11,
        /// Relative residual of a dependent equality above which it contradicts the others.
        consistent: f64 = 1e-8,
        /// Weight, relative to H, of the term that fixes a level which limits may move.
        light_pin: f64 = 1e-6,
        /// Curvature along the constant function, relative to the maximum, below which the level is free.
        level_is_free: f64 = 1e-10,
        /// Sum of the entries of an equality, relative to the sum of their magnitudes, above which the equality fixes the level.
        fixes_level: f64 = 1e-6,
    }

    /// Settings of the dual active-set method.
    ActiveSetSettings {
        /// Maximum number of separation iterations before the interior-point method is used.
        rounds: usize = 60,
        /// Maximum number of steps over all iterations, per unknown.
        steps_per_unknown: usize = 60,
        /// Number of initial rows above which a dense basis is not used.
        rows: usize = 1000,
        /// Maximum number of active rows; with more, the interior-point method is used.
        active: usize = 400,
        /// Excess, relative to the scale of the limit, above which a row is violated; far below the tolerance of the iterations.
        resolved: f64 = 1e-12,
        /// Violation below which a law without further progress is accepted as exact up to rounding errors.
        resolved_at_last: f64 = 1e-7,
        /// Fraction of the minimum violation so far. An iteration with a violation above this fraction made no progress.
        progress: f64 = 0.9,
        /// Number of iterations without progress after which the method ends.
        patience: usize = 4,
        /// Squared fraction of a row outside the span of the active rows below which the row is dependent.
        dependent: f64 = 1e-13,
        /// Distance between a new row and an old row of the same limit, relative to the piece, below which the new row replaces the old one.
        coincident: f64 = 1e-5,
        /// Maximum number of iterations that refine contacts.
        refinements: usize = 8,
        /// Maximum number of times that the fixed level of a free law is moved.
        pin_moves: usize = 12,
        /// Move of the level, relative to the typical lift, below which it is final.
        pin_settled: f64 = 1e-9,
    }

    /// Settings of the proximal method for minimax objectives.
    ProximalSettings {
        /// ε: initial weight of the change of the law in a proximal step, in units of the peak.
        nearness: f64 = 1e-2,
        /// Minimum of the weight ε.
        least_nearness: f64 = 1e-9,
        /// Factor of the weight ε from one centre to the next.
        fall: f64 = 0.2,
        /// Factor of the weight ε after a step that ends in rounding errors.
        heavier: f64 = 100.0,
        /// Decrease of the peak, as a fraction of the predicted decrease, above which a law becomes the centre.
        kept: f64 = 0.3,
        /// Fraction of the gap below which a step is accepted if its rows are those of its law.
        proved: f64 = 0.3,
        /// Maximum relative violation of the other limits for which a law may be accepted by its peak alone.
        compared: f64 = 1e-4,
        /// Maximum number of iterations of rows and centres; 20 are usual.
        rounds: usize = 150,
        /// Factor between the final certificate and the refinement threshold within which the search stops.
        accepted: f64 = 1e3,
        /// Number of iterations without a better certificate after which the search ends.
        patience: usize = 25,
    }

    /// Settings of the search for the weight of a root-mean-square limit.
    RmsSettings {
        /// Tolerance of the limits in the initial program with a cone.
        rough: f64 = 1e-6,
        /// First step of ln p; each further step is twice as large.
        peak_step: f64 = 0.2,
        /// First step of ln μ, relative to the logarithm of the excess.
        step: f64 = 4.0,
        /// Minimum first step of ln μ; each further step is four times larger.
        least_step: f64 = 1e-6,
        /// Maximum number of steps of ln μ or ln p.
        steps: usize = 24,
        /// Relative distance between the smallest trial peak and the minimum.
        pinch: f64 = 2e-7,
        /// Number of trial weights between two others.
        weights: usize = 40,
        /// Difference of logarithms below which two weights are equal.
        same_weight: f64 = 1e-11,
        /// Relative gap of a law between two optima below which it is accepted.
        gap: f64 = 1e-10,
    }

    /// Settings of the refinement by Newton's method.
    RefinementSettings {
        /// Relative gap below which no refinement is necessary.
        gap: f64 = 1e-7,
        /// Stationarity below which no refinement is necessary. The solver often stops at 1e-7 with a closed gap. A law with stationarity and gap
        /// below 1e-6 is certified.
        stationarity: f64 = 3e-7,
        /// Tolerance above which a program is a step of a sequence and is not refined.
        finest_tolerance: f64 = TOLERANCE,
        /// Maximum number of steps with the banded factor; three are usual.
        band_steps: usize = 5,
        /// Maximum number of dense steps; about five are usual.
        steps: usize = 12,
        /// Maximum total number of dense systems, because rows are removed one by one.
        solves: usize = 40,
        /// Number of steps without a better certificate after which the refinement ends.
        patience: usize = 4,
        /// Gap and stationarity at which the refinement ends.
        clean: f64 = 1e-8,
        /// Gap and stationarity that are accepted if rounding prevents smaller ones.
        proved: f64 = 1e-6,
        /// Relative violation below which contacts are refined together.
        from: f64 = 1e-3,
        /// Ratio of the violation to the initial violation above which a step has lost its contacts.
        divergence: f64 = 30.0,
        /// Relative distance from the bound within which maxima are candidates for contacts.
        below: f64 = 0.05,
        /// Relative decrease over the width of a piece below which a limit has no contact point.
        flat: f64 = 1e-6,
        /// Distance, as a fraction of a piece, below which two contacts coincide.
        same: f64 = 1e-7,
        /// Multiplier, relative to the maximum, below which a row is not a contact.
        weakest: f64 = 1e-6,
        /// Negative multiplier, relative to the maximum, beyond which a row is not active.
        negative_multiplier: f64 = 1e-9,
        /// Maximum number of rows per unknown that determine a vertex.
        rows_per_unknown: usize = 24,
        /// Maximum number of iterations that add violated points to a step.
        joins: usize = 8,
        /// Minimum relative violation of an added point.
        resolved: f64 = 1e-10,
        /// Minimum distance of an added point from the rows of the same limit, as a fraction of a piece.
        apart: f64 = 0.25,
        /// Maximum size of a dense system.
        largest: usize = 500,
        /// Proximal weight of the step, in units of the solver.
        held: f64 = 1e-9,
        /// Factor of the proximal weight after a failed factorisation.
        raised: f64 = 100.0,
        /// Maximum number of increases of the proximal weight.
        raises: i32 = 4,
        /// Proximal weight of the multipliers, for linearly dependent rows.
        light: f64 = 1e-13,
        /// Maximum number of steps of the quadratic program, per unknown; two are usual.
        steps_per_unknown: usize = 10,
        /// Excess below which a plane of the quadratic program is satisfied.
        step_resolved: f64 = 1e-14,
        /// The same fraction as `ActiveSetSettings::dependent`, for the planes of the quadratic program.
        dependent: f64 = 1e-25,
        /// Violation of a dependent plane below which it is a rounding error.
        rounding: f64 = 1e-9,
    }

    /// Settings of the iterations of separation and interior-point solution.
    ExchangeSettings {
        /// Maximum number of iterations; about five are usual.
        rounds: usize = 60,
        /// Fraction of the minimum violation so far above which an iteration has stalled.
        stalled: f64 = 0.5,
        /// After a stall, increase of the margin of every limit, as a multiple of the violation.
        margin_growth: f64 = 2.0,
        /// Maximum margin, as a fraction of the scale of the limit.
        largest_margin: f64 = 1e-6,
        /// Residual of the solver for a second-order cone, which is not refined.
        cone_margin: f64 = 1e-7,
        /// Distance between a new row and an old row of the same limit, relative to the piece, below which the new row replaces the old one.
        coincident: f64 = 1e-4,
        /// Gap and feasibility tolerance of the interior-point method. Smaller ones end in "insufficient progress" for some fits; the refinement
        /// restores the digits.
        solver_tolerance: f64 = 1e-9,
        /// Maximum number of iterations of the interior-point method; 20 are usual.
        solver_iterations: u32 = 200,
    }

    /// Settings of the certificate.
    CertificateSettings {
        /// Objective, relative to its terms, below which it is a rounding error. It corresponds to a force error of a thousandth of the force.
        least_objective: f64 = 1e-6,
        /// Fraction of the objective below which xᵀr is small.
        small: f64 = 1e-9,
        /// The same fraction as `ActiveSetSettings::dependent`, for equalities.
        dependent: f64 = 1e-20,
    }
}
