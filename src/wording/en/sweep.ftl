# Faults in a sweep: its axes, its plan, its tolerances and its tables.
sweep-no-assignment = "{ $typed }" does not have the form KEY=VALUES
    .help = write KEY=VALUES, for example limits.stroke=20 mm:60 mm:5 or law.family=spline,harmonic
sweep-no-values = the grid is empty: no value is given
    .help = write values separated by commas, or START:STOP:COUNT
sweep-sampled-count = a sampled range has no count
    .help = write START:STOP
sweep-no-count = a range of a grid has no count
    .help = write START:STOP:COUNT, or draw random values with --sample
sweep-not-count = "{ $typed }" is not a whole number of values
    .help = write START:STOP:COUNT
sweep-different-units = the first and the last value of the range have different units ("{ $first }" and "{ $last }")
    .help = give both in the same unit
sweep-not-number = "{ $typed }" does not start with a number
sweep-no-rows = the grid is empty: there is no row to compute
sweep-too-many-rows = { $rows } combinations are too many to compute
    .help = use fewer values, or sample them
sweep-list-lengths = the list has { $values } values of "{ $key }", but { $first } values of the first key
    .help = give every key of a list the same number of values
sweep-not-carried = this file is not among the recordings of this sweep
sweep-scatter-alone = tolerances cannot be combined with another variation, because they apply to one design
sweep-no-design = the scene has no feasible cam, so tolerances cannot be applied
    .help = relax its limits as suggested in the summary of the design
sweep-out-of-time = the time limit ended the search for this design
    .help = set a longer --time-limit
sweep-fixed = "{ $key }" cannot be varied
    .help = the keys { $known } can be varied; entries of a list are numbered, as in law.segment.2.lift
sweep-key-twice = "{ $key }" is given twice
sweep-nothing-to-sample = no key varies, so there is nothing to sample
    .help = vary a key over a range: KEY=START:STOP
sweep-sobol-axes = Sobol sequences are available for up to { $most } keys
    .help = use Latin hypercube sampling (latin)
sweep-no-scene = the base scene { $scene } does not exist
sweep-no-tolerance-value = "{ $typed }" does not have the form PART=VALUE
    .help = write PART=VALUE, for example profile=0.02 mm
sweep-no-tolerance = "{ $typed }" has no tolerance
    .help = these parts have a tolerance: profile, base_radius, mass, speed
sweep-negative-tolerance = the tolerance of { $part } is negative: { $typed }
    .help = give the half width of the tolerance, 0 or more
sweep-no-force-error = the scene has no target force, so it has no force error
sweep-scatter-of-arm = tolerances are computed only for translating followers; for a follower on an arm, measure a manufactured cam with gaitcam inspect
sweep-front-without-moving-axis = a force limit controls the lift-off speed only on a moving axis; use gaitcam sweep and gaitcam front --maximise liftoff_speed
sweep-front-without-size = the pressure limit determines the size of this cam, but this trade-off requires a given size
    .help = give cam.base_radius or cam.prime_radius
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
differs-only-old = { $path }: only the first run contains "{ $text }"
differs-only-new = { $path }: only this run contains "{ $text }"
