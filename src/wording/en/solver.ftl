# How a law was found.
method-programme = the motion is prescribed and not optimised
method-interpolation = one linear system with as many conditions as coefficients
method-spectral = { $harmonics } harmonics; truncation error { $rest } RMS
method-harmonics = { $harmonics } harmonics, { $rounds ->
        [one] one exchange iteration
       *[other] { $rounds } exchange iterations
    }; constraint violation { $violation }
method-search = rise of { $rise } from { $from }, fall of { $fall }, found in { $steps } search steps; force error { $error } RMS
method-no-limit-active = the unconstrained optimum satisfies all limits
method-exchange = { $rounds ->
        [one] one exchange iteration
       *[other] { $rounds } exchange iterations
    }; constraint violation { $violation }
method-sequence = { $programs ->
        [one] one convex program
       *[other] { $programs } convex programs in sequence
    } for the non-convex limits; stopped: { $ended ->
        [out-of-time] { ended-out-of-time }
        [most-steps] { ended-most-steps }
        [no-solution] { ended-no-solution }
        [no-improvement] { ended-no-improvement }
       *[small-gain] { ended-small-gain }
    }; constraint violation { $violation }
ended-out-of-time = time limit reached
ended-most-steps = maximum number of steps reached
ended-no-solution = the linearised program is infeasible near the last law
ended-no-improvement = no fraction of the last step improves the objective
ended-small-gain = steps improve the objective by less than one part in ten million

# Why a law is not certified to be the optimum.
doubt-limits = a limit is exceeded by more than the solver's tolerance
doubt-gap = the duality gap could not be closed to one part in a million
doubt-touching-angle = the angle at which the law touches the base circle was found by search, without a proof that it is the best
doubt-left-out = this law was computed without the non-convex limits, because no law was found that satisfies them
doubt-fixed-motion = it is the optimum for one motion of shaft and floor; laws that cause a different motion were not compared
doubt-local = the problem is not convex, so only a local optimum is found; the gap refers to the best known lower bound

# Why a simpler family was rejected.
passed-over-accuracy = { $family } exceeds the allowed force error by { $excess }
passed-over-check = { $family } violates { $check } (value { $value }, limit { $limit })
passed-over-fault = { $family } is not possible: { $fault }

# Why a solver of convex programs stopped without a result.
name-singular-objective = singular objective matrix
name-singular-equalities = singular matrix of the equality constraints
name-out-of-time = time limit reached
name-iteration-limit = iteration limit reached
name-no-progress = no further progress
name-unbounded = objective unbounded below
name-numerical-error = loss of numerical accuracy
name-refused = program rejected by the interior-point method
