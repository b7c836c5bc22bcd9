# What is wrong with a scene (src/scene/error.rs), and keys without effect (src/scene/notes.rs).
scene-output-name = "{ $typed }" cannot name an output folder
    .help = use letters, digits, - and _
scene-no-such-key = there is no such key
    .help = { $nearest ->
        [none] keys here are { $known }
       *[other] did you mean "{ $nearest }"?
    }
scene-not-of-follower = a { $follower } follower has no such key
    .help = leave it out, or choose another cam.follower
scene-not-of-drive = a { $drive } drive has no such key
    .help = leave it out, or choose another drive.kind
scene-mass-of-arm = the lift of an oscillating follower is an angle, on which no mass acts
    .help = give its moment of inertia about the pivot: inertia = "0.02 kg m^2"
scene-not-table = { $typed } is not a table
    .help = write it as a table, [{ $section }]
scene-not-list = { $typed } is not a list of tables
    .help = write each as [[{ $list }]]
scene-not-text = { $typed } is not a text
    .help = write a text in quotes
scene-not-texts = { $typed } is not a text
    .help = write a text in quotes, or a list of them
scene-not-flag = { $typed } is neither true nor false
    .help = write true or false
scene-not-count = { $typed } is not a whole number from { $low } to { $high }
    .help = write a whole number from { $low } to { $high }, or "auto"
scene-not-quantity = { $typed } is not a number with its unit
    .help = write a number with its unit in quotes, for example { $example }
scene-unknown-word = "{ $word }" is not known here
    .help = { $nearest ->
        [none] known are { $known }
       *[other] did you mean "{ $nearest }"? Known are { $known }
    }
scene-not-positive = { $typed } is not positive
    .help = write for example { $example }
scene-negative = { $typed } is negative
    .help = write for example { $example }
scene-outside = { $typed } is outside { $low } … { $high }
    .help = give a value from { $low } to { $high }
scene-not-acute = at a pressure angle of { $typed } the cam only pushes sideways
    .help = 30° to 45° are usual
scene-needed-by-follower = a { $follower } follower needs it
    .help = write for example { $example }
scene-needed-by-drive = a { $drive } drive needs it
    .help = write for example { $example }
scene-needed-in-entry = every entry of the list needs it
    .help = write for example { $example }
scene-no-assignment = "{ $typed }" has no =
    .help = write KEY=VALUE, for example limits.stroke=40 mm
scene-no-entry = there is no { $list }.{ $number }; { $given ->
        [0] none is given
        [one] one is given
       *[other] { $given } are given
    }
    .help = entries count from 1: { $list }.1
scene-list-without-number = { $list } is a list of { $given }
    .help = write { $list }.1 for the first
scene-value-not-table = { $part } is a value, not a table
    .help = leave out what follows { $part }
scene-file-and-model = both file and model are given
    .help = keep one: file = "walk.mot" or model = "young"
scene-no-force-named = no recording and no load model is named
    .help = give file = "walk.mot" or model = "young"; leave [gait] out for a law of given segments or points
scene-no-phases = { $from } to { $to } is no range of one cycle
    .help = phases run from 0 to 360 deg; a range over the end has to < from
scene-nothing-weighed = every phase of the cycle has weight 0
    .help = give one range a weight above 0
scene-empty-weigh = no weight is given
    .help = say how much counts as one: force_error = "1 %", prime_radius = "20 mm", jerk = "100 m/s^3"
scene-minimise-and-weigh = law.weigh already says what is minimised
    .help = leave out one of the two
scene-no-force-to-follow = no force is wanted that the law could follow
    .help = add [gait], or minimise "jerk", "peak-acceleration" …
scene-size-not-free = the size of this cam is not free
    .help = it applies to translating flat faces, rollers and knife edges without a given radius
scene-spline-degree = a spline has degree 3 to 9, not { $typed }
    .help = write a whole number from 3 to 9, or "auto"
scene-only-splines = a { $family } law cannot take it into account
    .help = use law.family = "spline"
scene-program-without-segments = a programme needs its segments
    .help = write [[law.segment]] motion = "cycloidal" lift = "10 mm" angle = "90 deg" for each
scene-polynomial-without-points = a polynomial needs at least two points
    .help = write [[law.point]] angle = "0 deg" lift = "0" velocity = "0" for each
scene-nothing-asked = nothing is asked of the law
    .help = add [gait] with a force, [[law.point]]s, or family = "program" with segments
scene-no-speed = "auto" needs a force cycle to take the speed from
    .help = write for example "60 rpm"
scene-no-mass = "auto" needs a force cycle to take the mass from
    .help = write for example "70 kg"
scene-base-and-prime = base_radius is given as well, and one follows from the other
    .help = leave one of them out
scene-radius-and-breadth = the base circle follows from the breadth: half of what the lift leaves of it
    .help = leave base_radius and prime_radius out
scene-breadth-without-program = constant breadth needs a programme whose halves mirror each other
    .help = set law.family = "program" with segments
scene-roller-fills-prime = the roller (or arc) of { $roller } leaves a base circle of { $base }
    .help = the prime radius must exceed the roller's
scene-base-in-bore = a base radius of { $base } lies inside the bore of { $bore }
    .help = make it larger than { $least }
scene-offset-reaches-prime = an offset of { $offset } reaches the prime circle of { $prime }
    .help = the offset must be smaller than the prime radius
scene-force-needs-translation = a wanted force shapes a lift in metres over one turn, which { $follower } does not make
    .help = use a translating follower, or leave [gait] out and give a programme
scene-length-needs-program = a law over a length is given as a programme
    .help = set law.family = "program" with segments
scene-turns-need-program = a law over several turns is given as a programme
    .help = set law.family = "program" with segments
scene-arm-needs-fixed-axis = the lift of an oscillating follower is an angle, on which no mass or spring in newtons acts
    .help = use kind = "fixed-axis"; inertia, spring_rate and preload then count about the pivot
scene-pair-not-closed = give either this or base_radius, not both and not none
    .help = give the distance of both faces or roller centres (oscillating: the angle between the arms), or the second cam's base_radius
scene-frequency-and-stiffness = natural_frequency says the same of the follower train
    .help = keep one of the two
scene-residual-without-frequency = a limit on vibration needs it
    .help = write for example "60 Hz" under [machine]
scene-force-range = { $low } is not below force_max = { $high }
    .help = lower force_min or raise force_max
scene-polydyne-without-stiffness = a polydyne cam needs the stiffness of the follower
    .help = write stiffness = "9 kN/m" or natural_frequency = "60 Hz" under [machine]
scene-polydyne-family = a polydyne cam needs a law with four continuous derivatives, which { $family } does not promise
    .help = use family = "spline" or "harmonic", or a programme of 5-6-7-8-9 segments
scene-polydyne-degree = the lift of a polydyne cam contains the force: below degree 5 its acceleration would jump
    .help = use degree 5 to 9; each degree above 5 also takes in one term of the damping
scene-polydyne-on-slide = a polydyne cam has to turn: a slide that ends has no steady motion
    .help = leave law.polydyne out, or use another follower
scene-polydyne-breadth = a polydyne cam keeps no breadth: the follower deflects differently half a turn later
    .help = leave law.polydyne or cam.breadth out
scene-no-such-scene = there is no built-in scene "{ $typed }"
    .help = { $nearest ->
        [none] built in are { $known }
       *[other] did you mean "{ $nearest }"?
    }

scene-no-effect = { $key } has no effect: { $why ->
        [family] a law of family { $family } does not use it
        [follower] a { $follower } follower does not use it
        [drive] a { $drive } drive does not use it
        [no-force] no force is wanted
        [recording] the force is a recording
        [model] the force is a load model
       *[rigid-follower] the follower is rigid without machine.natural_frequency or machine.stiffness
    }
