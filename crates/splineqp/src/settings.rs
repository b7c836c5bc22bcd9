//! Tuning constants of the solvers, with the reasons for their values. They are not keys of a scene.

/// Relative tolerance of the limits of a finished law. The maximum and the minimum of a lift may each deviate by this tolerance, so a
/// stroke is accurate to 1e-9.
pub const TOLERANCE: f64 = 4e-10;

/// Defines groups of settings with default values, one line per setting.
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

    /// Settings of the least squares under equalities. The level of a law is its constant part.
    EqualitySettings {
        /// Relative pivot below which an equality counts as dependent on the others.
        dependent: f64 = 1e-11,
        /// Relative residual of a dependent equality above which the equality contradicts the others.
        consistent: f64 = 1e-8,
        /// Weight, relative to H, of the quadratic term that fixes the level of the law if limits may change this level.
        light_pin: f64 = 1e-6,
        /// Curvature of the objective along the constant function, relative to the maximum, below which the level of the law is free.
        level_is_free: f64 = 1e-10,
        /// Threshold for equalities that fix the level. Such an equality has a sum of entries, divided by the sum of their magnitudes,
        /// above this value.
        fixes_level: f64 = 1e-6,
    }

    /// Settings of the dual active-set method.
    ActiveSetSettings {
        /// Maximum number of separation iterations before the interior-point method is used.
        rounds: usize = 60,
        /// Maximum number of steps over all iterations, per unknown.
        steps_per_unknown: usize = 60,
        /// Number of initial rows above which this method is not used, because its basis is dense.
        rows: usize = 1000,
        /// Maximum number of active rows. With more active rows, the interior-point method is used.
        active: usize = 400,
        /// Excess, relative to the scale of the limit, above which a row counts as violated. It is far below the tolerance of the
        /// iterations.
        resolved: f64 = 1e-12,
        /// Violation below which a law without further progress is accepted as exact up to rounding errors.
        resolved_at_last: f64 = 1e-7,
        /// An iteration made no progress if its violation, divided by the minimum violation so far, is above this value.
        progress: f64 = 0.9,
        /// Number of iterations without progress after which the method ends.
        patience: usize = 4,
        /// Threshold for linear dependence. A row is split into a component in the span of the active rows and the remaining component. It
        /// counts as dependent if the squared length of the remaining component is below this fraction of the squared length of the row.
        dependent: f64 = 1e-13,
        /// Distance of a new row from an old row of the same limit, as a fraction of the piece, below which the new row replaces the old
        /// one.
        /// old one.
        coincident: f64 = 1e-5,
        /// Maximum number of refinements by Newton's method in the iterations.
        refinements: usize = 8,
        /// Maximum number of changes of the fixed level for a law whose level is free.
        pin_moves: usize = 12,
        /// Change of the level, relative to the typical lift, below which the level is final.
        pin_settled: f64 = 1e-9,
    }

    /// Settings of the proximal method for minimax objectives.
    ProximalSettings {
        /// Initial weight ε. It is the weight of the change of the law in a proximal step, divided by the weight of the peak's change.
        nearness: f64 = 1e-2,
        /// Minimum of the weight ε, below which it is not reduced.
        least_nearness: f64 = 1e-9,
        /// Factor by which the weight ε is multiplied from one centre to the next.
        fall: f64 = 0.2,
        /// Factor by which the weight ε is multiplied after a step that fails because of rounding errors.
        heavier: f64 = 100.0,
        /// Ratio of the actual to the predicted decrease of the peak above which a law becomes the next centre.
        kept: f64 = 0.3,
        /// Fraction of the permitted gap. If the lower bound and the predicted peak with the present rows differ by less, ε is not reduced.
        /// Only further rows are then necessary.
        proved: f64 = 0.3,
        /// Maximum relative violation of the other limits for which laws are compared by their peaks alone.
        compared: f64 = 1e-4,
        /// Maximum number of proximal steps; 20 are usual.
        rounds: usize = 150,
        /// Maximum ratio of the final certificate to the refinement thresholds for which the law is accepted.
        accepted: f64 = 1e3,
        /// Number of iterations without a better certificate after which the search ends.
        patience: usize = 25,
    }

    /// Settings of the search for the weight μ or the peak p of a root-mean-square limit.
    RmsSettings {
        /// Tolerance of the limits in the initial program with a cone.
        rough: f64 = 1e-6,
        /// First step of ln p. Each further step is twice the previous step.
        peak_step: f64 = 0.2,
        /// First step of ln μ, divided by |ln(root mean square/limit)|. The first step is at most 1.
        step: f64 = 4.0,
        /// Minimum first step of ln μ. Each further step is four times the previous step.
        least_step: f64 = 1e-6,
        /// Maximum number of steps of ln μ or ln p.
        steps: usize = 24,
        /// Relative distance between the smallest trial peak and the minimum peak under the other limits.
        pinch: f64 = 2e-7,
        /// Maximum number of trial weights or peaks after one trial satisfies the limit and another trial violates it.
        weights: usize = 40,
        /// Difference between the logarithms of two weights below which the weights count as equal.
        same_weight: f64 = 1e-11,
        /// Relative duality gap below which the law interpolated between two optima is accepted.
        gap: f64 = 1e-10,
    }

    /// Settings of the refinement by Newton's method.
    RefinementSettings {
        /// Relative gap below which no refinement is necessary.
        gap: f64 = 1e-7,
        /// Stationarity below which no refinement is necessary. The solver often stops at a stationarity of 1e-7 when the gap is already
        /// negligible. A law with stationarity and gap below 1e-6 is certified.
        stationarity: f64 = 3e-7,
        /// Tolerance above which a program counts as one step of a sequence of programs. Such a program is not refined.
        finest_tolerance: f64 = TOLERANCE,
        /// Maximum number of steps with the banded factor; three are usual.
        band_steps: usize = 5,
        /// Maximum number of dense steps; about five are usual.
        steps: usize = 12,
        /// Maximum total number of dense systems. About one system is solved for each removed row.
        solves: usize = 40,
        /// Number of steps without a better certificate after which the refinement ends.
        patience: usize = 4,
        /// Gap and stationarity below which the refinement ends.
        clean: f64 = 1e-8,
        /// Gap and stationarity below which the result is accepted if rounding errors prevent smaller values.
        proved: f64 = 1e-6,
        /// Relative violation below which the refinement by Newton's method starts.
        from: f64 = 1e-3,
        /// Ratio of the violation to the initial violation above which the refinement has failed.
        divergence: f64 = 30.0,
        /// Distance from the bound, relative to the scale of the limit, within which local maxima are candidates for active points.
        below: f64 = 0.05,
        /// Decrease of the left side over the width of a piece, relative to its scale, below which a limit has no isolated active point.
        flat: f64 = 1e-6,
        /// Distance, as a fraction of a piece, below which two active points count as one.
        same: f64 = 1e-7,
        /// Multiplier, relative to the maximum, below which a row does not count as active.
        weakest: f64 = 1e-6,
        /// Magnitude of a negative multiplier, relative to the maximum multiplier, above which its row is removed as inactive.
        negative_multiplier: f64 = 1e-9,
        /// Maximum number of rows per coefficient in the quadratic program of a step.
        rows_per_unknown: usize = 24,
        /// Maximum number of iterations that add violated points to a step.
        joins: usize = 8,
        /// Minimum relative violation of a point that is added to a step.
        resolved: f64 = 1e-10,
        /// Minimum distance of an added point from the rows of the same limit, as a fraction of a piece.
        apart: f64 = 0.25,
        /// Maximum size of the dense system of a step.
        largest: usize = 500,
        /// Proximal weight of the step, in units of the solver.
        held: f64 = 1e-9,
        /// Factor by which the proximal weight is multiplied after a failed factorisation.
        raised: f64 = 100.0,
        /// Maximum number of increases of the proximal weight.
        raises: i32 = 4,
        /// Proximal weight of the multipliers, for linearly dependent rows.
        light: f64 = 1e-13,
        /// Maximum number of steps of the quadratic program, per unknown; two are usual.
        steps_per_unknown: usize = 10,
        /// Excess below which a plane of the quadratic program is satisfied.
        step_resolved: f64 = 1e-14,
        /// Threshold for linear dependence. The normal of a plane is split into a component in the span of the active planes' normals and
        /// the remaining component. The plane counts as dependent if the squared length of the remaining component is below this fraction
        /// of the normal's squared length.
        dependent: f64 = 1e-25,
        /// Violation of a dependent plane below which it counts as a rounding error.
        rounding: f64 = 1e-9,
    }

    /// Settings of the iterations of separation and interior-point solution.
    ExchangeSettings {
        /// Maximum number of iterations; about five are usual.
        rounds: usize = 60,
        /// An iteration has stalled if its violation, divided by the minimum violation so far, is above this value.
        stalled: f64 = 0.5,
        /// Factor for the margin of every limit after a stall. The new margin is this factor times the larger of the violation and the
        /// previous margin.
        margin_growth: f64 = 2.0,
        /// Maximum margin, as a fraction of the scale of the limit.
        largest_margin: f64 = 1e-6,
        /// Initial margin of programs with second-order cones or root-mean-square limits, as a fraction of the scale of each limit. This
        /// margin exceeds the residual of the solver, since these programs are not refined.
        cone_margin: f64 = 1e-7,
        /// Distance of a new row from an old row of the same limit, as a fraction of the piece, below which the new row replaces the old
        /// one.
        /// old one.
        coincident: f64 = 1e-4,
        /// Gap and feasibility tolerance of the interior-point method. With smaller tolerances, some fits end with the status "insufficient
        /// progress". The refinement increases the accuracy afterwards.
        solver_tolerance: f64 = 1e-9,
        /// Maximum number of iterations of the interior-point method; 20 are usual.
        solver_iterations: u32 = 200,
    }

    /// Settings of the duality gap in the certificate.
    CertificateSettings {
        /// Objective, relative to its largest term, below which it counts as a rounding error. It corresponds to a force error of a
        /// thousandth of the force.
        least_objective: f64 = 1e-6,
        /// Maximum magnitude of xᵀr, relative to the objective, for which xᵀr is part of the gap. A larger xᵀr is replaced by ½rᵀH⁻¹r.
        small: f64 = 1e-9,
        /// Threshold for linear dependence. The row of an equality is split into a component in the span of the other equalities and the
        /// remaining component. The equality counts as dependent if the squared length of the remaining component is below this fraction of
        /// the row's squared length.
        dependent: f64 = 1e-20,
    }
}
