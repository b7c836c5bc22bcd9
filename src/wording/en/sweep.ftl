# Faults in a sweep: its axes, its plan, its tolerances and its tables.
sweep-no-assignment = "{ $typed }" contains no =
    .help = write KEY=VALUES, for example limits.stroke=20 mm:60 mm:5 or law.family=spline,harmonic
sweep-no-values = an empty grid: no value is given
    .help = write at least one value between commas, or START:STOP:COUNT
sweep-sampled-count = a range that is sampled takes no count
    .help = write START:STOP
sweep-no-count = a range of a grid needs its count
    .help = write START:STOP:COUNT, or sample the range
sweep-not-count = "{ $typed }" is not a whole number of values
    .help = write START:STOP:COUNT
sweep-different-units = the ends of the range have different units ("{ $first }" and "{ $last }")
    .help = give both in the same unit
sweep-not-number = "{ $typed }" does not start with a number
sweep-no-rows = an empty grid: no row to compute
sweep-out-of-time = the time limit ended the search for this design
    .help = allow more with --time-limit
sweep-fixed = "{ $key }" cannot vary
    .help = keys that vary: { $known }; and values of a list by number, such as law.segment.2.lift
sweep-key-twice = "{ $key }" is given twice
sweep-nothing-to-sample = no key varies, so there is nothing to sample
    .help = vary a key over a range: KEY=START:STOP
sweep-sobol-axes = Sobol sequences are available for up to { $most } keys
    .help = use Latin hypercube sampling (latin)
sweep-no-scene = there is no base scene { $scene }
sweep-no-tolerance-value = "{ $typed }" contains no =
    .help = write PART=VALUE, for example profile=0.02 mm
sweep-no-tolerance = "{ $typed }" takes no tolerance
    .help = parts with a tolerance: profile, base_radius, mass, speed
sweep-negative-tolerance = the tolerance of { $part } is negative: { $typed }
    .help = give the half width of the tolerance, 0 or more
sweep-no-force-error = the scene has no target force, so it has no force error
sweep-front-without-moving-axis = only on a moving axis does a force limit hold the lift-off speed; use gaitcam sweep and gaitcam front --maximise liftoff_speed
sweep-front-without-size = the size of the cam follows from the pressure here: give base_radius or prime_radius
    .help = add [gait] to the scene
sweep-no-column = "{ $typed }" is not a column of numbers
    .help = { $nearest ->
        [none] for example { $known }
       *[other] did you mean "{ $nearest }"?
    }
sweep-column-missing = the record batch has no such column
sweep-column-type = the column must be of type { $wanted }
sweep-arrow = Arrow: { $fault }
sweep-parquet = Parquet: { $fault }
