# What is wrong with a scene (src/scene/error.rs), and keys without effect (src/scene/notes.rs).
scene-not-toml = not TOML in line { $line }: { $fault }
scene-output-name = "{ $typed }" cannot name an output folder
    .help = use letters, digits, - and _
scene-no-such-key = unknown key
    .help = { $nearest ->
        [none] the keys here are { $known }
       *[other] did you mean "{ $nearest }"?
    }
scene-not-of-follower = this key does not apply to this follower ({ $follower })
    .help = remove it, or choose another cam.follower
scene-not-of-drive = this key does not apply to this drive ({ $drive })
    .help = remove it, or choose another drive.kind
scene-mass-of-arm = an oscillating follower has a moment of inertia instead of a mass
    .help = give its moment of inertia about the pivot: inertia = "0.02 kg m^2"
scene-not-table = { $typed } is not a table
    .help = write it as a table, [{ $section }]
scene-not-list = { $typed } is not a list of tables
    .help = write each as [[{ $list }]]
scene-not-text = { $typed } is not a string
    .help = write it in quotes
scene-not-hardness = "{ $typed }" is not a hardness with its scale
    .help = write for example "58 HRC", "650 HV" or "240 HB": 20 … 64 HRC, 105 … 800 HV, 100 … 722 HB
scene-not-robust = "{ $typed }" is not a measure of the errors of several walkers
    .help = write "mean", "worst" or for example "cvar 0.9"
scene-not-frequencies = "{ $typed }" gives no step frequencies
    .help = write one, "1.85 Hz", a range with its number of steps, "1.4 Hz:2.4 Hz:11", or "normal 1.87 Hz 0.19 Hz"
scene-not-texts = { $typed } is not a string
    .help = write a string in quotes, or a list of strings
scene-not-flag = { $typed } is neither true nor false
    .help = write true or false
scene-not-count = { $typed } is not a whole number from { $low } to { $high }
    .help = write a whole number from { $low } to { $high }, or "auto"
scene-not-spans = { $typed } is not a whole number from { $low } to { $high }
    .help = beyond { $high } spans a certified optimum is not assured in reasonable time; a cam needs 8 to 60, and "auto" takes the fewest that reach the accuracy
scene-not-quantity = { $typed } is not a number with its unit
    .help = write a number with its unit in quotes, for example { $example }
scene-unknown-word = invalid value "{ $word }"
    .help = { $nearest ->
        [none] valid values are { $known }
       *[other] did you mean "{ $nearest }"? Valid values are { $known }
    }
scene-not-positive = { $typed } is not positive
    .help = write for example { $example }
scene-negative = { $typed } is negative
    .help = write for example { $example }
scene-outside = { $typed } is outside { $low } … { $high }
    .help = give a value from { $low } to { $high }
scene-not-acute = the pressure angle limit of { $typed } is not below 90°
    .help = 30° to 45° are usual
scene-needed-by-follower = missing; this follower ({ $follower }) requires it
    .help = write for example { $example }
scene-needed-by-drive = missing; this drive ({ $drive }) requires it
    .help = write for example { $example }
scene-needed-in-entry = missing; every entry of the list requires it
    .help = write for example { $example }
scene-no-assignment = "{ $typed }" is not a key, = and a value
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
    .help = remove what follows { $part }
scene-file-and-model = more than one of file, model and harmonics is given
    .help = keep one: file = "walk.mot", model = "young" or harmonics = ["0.4", "0.1 at -90 deg"]
scene-not-harmonic = "{ $typed }" is not a load factor with its phase
    .help = write one text for each harmonic, the factor as a part of the weight (zero or above) and the phase added to its sine: ["0.4", "0.1 at -90 deg"]
scene-not-learned-force = "{ $typed }" is not a force with its phase
    .help = write the mean first, then one text for each harmonic of the cam's turn, its force and the phase added to its sine: ["0 N", "3.2 N at -90 deg"]
scene-learned-forces = { $given } harmonics of the learned force are too many
    .help = give the mean and the first harmonics, { $most } texts at most
scene-harmonics = { $given ->
        [one] the one load factor is zero
       *[other] { $given } load factors: all zero or too many
    }
    .help = give 1 to { $most } factors, at least one of them above zero, for example ["0.4", "0.1 at -90 deg"]
scene-no-force-named = neither a recording nor a load model is given
    .help = give file = "walk.mot", model = "young" or harmonics = ["0.4", "0.1 at -90 deg"]; remove [gait] for a law given by segments or points
scene-no-phases = { $from } to { $to } is not a valid range of phases
    .help = phases run from 0 to 360 deg; in a range across the end of the cycle, to is smaller than from
scene-nothing-weighed = all phases of the cycle have weight 0
    .help = give at least one range a weight above 0
scene-weigh-removed = law.weigh was removed
    .help = the trade-off is shown by gaitcam synth --front force_error:prime_radius; choose a point of it and set its limits
scene-no-force-to-follow = no target force is given
    .help = add [gait], or minimise "jerk", "peak-acceleration" …
scene-size-not-free = the size of this cam is not free
    .help = this applies to cams whose radius is not given, but not to translating cams, barrel cams and oscillating mushroom followers
scene-spline-degree = invalid spline degree { $typed }
    .help = write a whole number from 3 to 9, or "auto"
scene-degree-below-objective = a law of degree { $degree } has no derivative of order { $order } to minimise: it is zero between the knots
    .help = use degree { $order } or higher, or another law.minimise
scene-only-splines = a law of this family ({ $family }) does not support this key
    .help = use law.family = "spline"
scene-program-without-segments = the programme has no segments
    .help = write [[law.segment]] motion = "cycloidal" lift = "10 mm" angle = "90 deg" for each
scene-polynomial-without-points = a polynomial needs at least two points
    .help = write [[law.point]] angle = "0 deg" lift = "0" velocity = "0" for each
scene-nothing-asked = the law has neither a target force nor points nor segments
    .help = add [gait] with a force, [[law.point]] entries, or family = "program" with segments
scene-no-speed = "auto" needs a target force: the speed follows from its period
    .help = write for example "60 rpm"
scene-no-mass = "auto" needs a target force: the mass follows from its mean
    .help = write for example "70 kg"
scene-base-and-prime = base_radius is given as well; each follows from the other
    .help = remove one of them
scene-radius-and-breadth = the base radius follows from the breadth: (breadth − lift) / 2
    .help = remove base_radius and prime_radius
scene-breadth-without-program = constant breadth needs a programme with mirrored halves
    .help = set law.family = "program" with segments
scene-roller-fills-prime = the roller or arc radius of { $roller } leaves a base radius of { $base }
    .help = the prime radius must exceed the roller radius
scene-base-in-bore = the base radius of { $base } lies inside the bore of { $bore }
    .help = use a base radius above { $least }
scene-keyway-without-bore = a keyway needs a bore
    .help = give cam.bore, for example "20 mm"
scene-no-keyway-for-bore = DIN 6885-1 has no keyway for a bore of { $bore }
    .help = it goes from above 6 mm to 150 mm; give a width, or leave the keyway out
scene-no-keyway-of-width = DIN 6885-1 has no keyway of { $width }
    .help = its widths are { $widths } mm
scene-keyway-too-wide = a keyway of { $width } does not fit a bore of { $bore }
    .help = write "auto", which takes the width of DIN 6885-1 for the bore
scene-offset-reaches-prime = the offset of { $offset } is not smaller than the prime radius of { $prime }
    .help = reduce the offset or increase the prime radius
scene-force-needs-turn = a target force defines a lift over one turn, which this follower ({ $follower }) does not have
    .help = use a follower on a disc cam, or remove [gait] and give a programme
scene-length-needs-program = a law over a length must be given as a programme
    .help = set law.family = "program" with segments
scene-turns-need-program = a law over several turns must be given as a programme
    .help = set law.family = "program" with segments
scene-arm-on-moving-axis = the shaft of a cam on a moving axis rides on a follower that translates; this follower swings about a fixed pivot
    .help = use kind = "fixed-axis", whose inertia, spring_rate and preload refer to the pivot, or "hydraulic"
scene-pair-not-closed = exactly one of this key and base_radius must be given
    .help = give the distance between faces or roller centres (oscillating: the angle between the arms), or the second cam's base_radius
scene-frequency-and-stiffness = natural_frequency already defines the stiffness of the follower train
    .help = remove one of the two
scene-motor-line = a motor needs one of slope, stall_torque and curve
    .help = write for example slope = "10 N m s/rad" under [machine.motor], the torque lost per rad/s at the camshaft
scene-no-load-without-stall = a no-load speed belongs to a stall_torque
    .help = give both, or the slope alone: its no-load speed is found
scene-motor-curve = the torque of the motor must fall with its speed, from row to row
    .help = name a file with the columns speed_rad_per_s and torque_n_m and two rows or more, speeds increasing and torques decreasing, or write the pairs: "0 50 10 20 12 -4"
scene-motor-without-inertia = missing; the motor needs the moment of inertia of its shaft
    .help = write for example inertia = "0.5 kg m^2" under [machine], flywheel and rotor at the camshaft
scene-floor-lacks = missing; a floor that moves needs modal mass, frequency and damping ratio
    .help = write for example "{ $example }" under [machine.floor]
scene-floor-twice = the floor is given twice: as one mode and as a list
    .help = move the numbers of [machine.floor] into a [[machine.floor.mode]]
scene-walker-phases = not one angle for each of the { $count } walkers of machine.walkers.count
    .help = write { $count } angles, the shaker first, for example ["0 deg", "90 deg"] for 2; or omit the key: they are drawn
scene-walker-weights = not one positive weight for each of the { $count } walkers of machine.walkers.count
    .help = write { $count } weights, the shaker first, for example ["700 N", "850 N"] for 2; or omit the key: all are equal
scene-floor-alone = not available on a floor that moves
    .help = omit it, or [machine.floor]
scene-floor-needs-shaker = a floor moves under a mass that follows a force: drive.kind = "moving-axis", with [gait], without law.polydyne
    .help = omit [machine.floor], or use such a drive
scene-residual-without-frequency = missing; the limit on residual vibration requires it
    .help = write for example "60 Hz" under [machine]
scene-force-range = { $low } is not below force_max = { $high }
    .help = lower force_min or raise force_max
scene-polydyne-without-stiffness = a polydyne cam needs the stiffness of the follower
    .help = write stiffness = "9 kN/m" or natural_frequency = "60 Hz" under [machine]
scene-polydyne-family = a polydyne cam needs a law with four continuous derivatives, which this family ({ $family }) does not guarantee
    .help = use family = "spline" or "harmonic", or a programme of 5-6-7-8-9 segments
scene-polydyne-degree = the lift of a polydyne cam contains the force: below degree 5 its acceleration would be discontinuous
    .help = use degree 5 to 9
scene-polydyne-on-slide = a polydyne cam must rotate: a law that does not repeat has no steady state
    .help = remove law.polydyne, or use another follower
scene-polydyne-breadth = a polydyne cam does not keep constant breadth: the follower deflects differently half a turn later
    .help = remove law.polydyne or cam.breadth
scene-no-such-scene = there is no built-in scene "{ $typed }"
    .help = { $nearest ->
        [none] built in are { $known }
       *[other] did you mean "{ $nearest }"?
    }

scene-no-effect = { $key } has no effect: { $why ->
        [family] a law of this family ({ $family }) does not use it
        [follower] this follower ({ $follower }) does not use it
        [drive] this drive ({ $drive }) does not use it
        [no-force] no target force is given
        [recording] the force is a recording
        [model] the force is a load model
        [no-motor] the shaft turns at constant speed without machine.motor
        [stiff-floor] the floor does not move without machine.floor
        [no-dwell] the law has no dwell
       *[rigid-follower] the follower is rigid without machine.natural_frequency or machine.stiffness
    }
