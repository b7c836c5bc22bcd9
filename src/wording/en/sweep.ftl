# Faults in a sweep: its axes, its plan, its tolerances and its tables.
sweep-no-assignment = "{ $typed }" is not a key, = and a value
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
sweep-too-many-rows = { $rows } combinations
    .help = too many to compute: use fewer values, or sample them
sweep-list-lengths = the list gives { $values } values of "{ $key }", and { $first } of its first key
    .help = give every key of a list the same number of values
sweep-not-carried = is not among the recordings of this sweep
sweep-scatter-alone = cannot be combined with another variation: it applies to one design
sweep-no-design = the scene has no feasible cam, so tolerances cannot be applied
    .help = relax its limits as the summary of the design says
sweep-out-of-time = the time limit ended the search for this design
    .help = allow more time
sweep-fixed = "{ $key }" cannot vary
    .help = keys that vary: { $known }; and values of a list by number, such as law.segment.2.lift
sweep-key-twice = "{ $key }" is given twice
sweep-nothing-to-sample = no key varies, so there is nothing to sample
    .help = vary a key over a range: KEY=START:STOP
sweep-sobol-axes = Sobol sequences are available for up to { $most } keys
    .help = use Latin hypercube sampling (latin)
sweep-no-scene = there is no base scene { $scene }
sweep-no-tolerance-value = "{ $typed }" is not a part, = and a value
    .help = write PART=VALUE, for example profile=0.02 mm
sweep-no-tolerance = "{ $typed }" takes no tolerance
    .help = parts with a tolerance: profile, base_radius, mass, speed
sweep-negative-tolerance = the tolerance of { $part } is negative: { $typed }
    .help = give the half width of the tolerance, 0 or more
sweep-no-force-error = the scene has no target force, so it has no force error
sweep-scatter-of-arm = tolerances are computed for followers that translate: on an arm the same error of the profile changes the lift differently at every angle; measure a manufactured cam with gaitcam inspect
sweep-front-without-moving-axis = only on a moving axis does a force limit hold the lift-off speed; use gaitcam sweep and gaitcam front --maximise liftoff_speed
sweep-front-without-size = the size of the cam follows from the pressure here: give base_radius or prime_radius
    .help = add [gait] to the scene
sweep-no-column = "{ $typed }" is not a column of numbers
    .help = { $nearest ->
        [none] for example { $known }
       *[other] did you mean "{ $nearest }"?
    }
sweep-arrow = Arrow: { $fault }
sweep-parquet = Parquet: { $fault }

# Differences between two plans.
differs-value = { $path }: { $old ->
        [none] nothing
       *[other] { $old }
    } before, { $new ->
        [none] nothing
       *[other] { $new }
    } now
differs-long = { $path }: the text differs
differs-only-old = { $path }: only the first run has "{ $text }"
differs-only-new = { $path }: only this run has "{ $text }"
