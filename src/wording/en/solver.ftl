# How a law was found.
method-programme = the programme is given: nothing to solve
method-interpolation = as many conditions as coefficients: one linear system
method-spectral = { $harmonics } harmonics inverted one by one; { $rest } RMS lie in the rest
method-harmonics = { $harmonics } harmonics, { $rounds } rounds of exchange; limits hold to { $violation }
method-search = rise of { $rise } from { $from }, fall of { $fall }, found by { $steps } steps of search; the force error is { $error } RMS
method-no-limit-active = no limit is active
method-exchange = { $rounds ->
        [one] one round of exchange
       *[other] { $rounds } rounds of exchange
    }; limits hold to { $violation }
method-sequence = { $programs } convex programs in sequence for what is not convex, ended because { $ended ->
        [most-steps] { ended-most-steps }
        [no-solution] { ended-no-solution }
        [no-improvement] { ended-no-improvement }
       *[small-gain] { ended-small-gain }
    }; limits hold to { $violation }
ended-most-steps = as many steps as are allowed were taken
ended-no-solution = the linearised program has no solution beside the last law
ended-no-improvement = no part of the last step improves the objective
ended-small-gain = the last step improved the objective by less than one part in ten million

# What a simpler family missed.
passed-over-accuracy = { $family } misses the accuracy by { $excess }
passed-over-check = { $family } misses { $check } ({ $value } against { $limit })
passed-over-limits = { $family } misses { $limits }
passed-over-fault = { $family } misses: { $fault }

# How a solver of convex programs stopped without an answer.
name-singular-objective = singular matrix of the objective
name-singular-equalities = singular matrix of the equality constraints
name-iteration-limit = iteration limit reached
name-no-progress = no further progress
name-unbounded = objective unbounded below
name-numerical-error = loss of numerical accuracy
name-refused = program refused by the interior-point method
