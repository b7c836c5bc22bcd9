# Faults in a scene (src/scene/error.rs), and keys without effect (src/scene/notes.rs).
scene-not-toml = not TOML in line { $line }: { $fault }
scene-output-name = "{ $typed }" is not a valid name for an output folder
    .help = use letters, digits, - and _
scene-no-such-key = unknown key
    .help = { $nearest ->
        [none] the keys of this section are { $known }
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
scene-not-frequencies = "{ $typed }" does not contain step frequencies
    .help = write one frequency, "1.85 Hz", a range with the number of values, "1.4 Hz:2.4 Hz:11", or a normal distribution, "normal 1.87 Hz 0.19 Hz"
scene-not-texts = { $typed } is not a string
    .help = write a string in quotes, or a list of strings
scene-not-flag = { $typed } is neither true nor false
    .help = write true or false
scene-not-count = { $typed } is not a whole number from { $low } to { $high }
    .help = write a whole number from { $low } to { $high }, or "auto"
scene-not-spans = { $typed } is not a whole number from { $low } to { $high }
    .help = write 8 to 60 for most cams, or "auto" for the minimum number that reaches the accuracy; more than { $high } spans can prevent a certified optimum
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
    .help = set a limit below 90°; 30° to 45° are usual
scene-needed-by-follower = this follower ({ $follower }) requires this key
    .help = write for example { $example }
scene-needed-by-drive = this drive ({ $drive }) requires this key
    .help = write for example { $example }
scene-needed-in-entry = every entry of the list requires this key
    .help = write for example { $example }
scene-no-assignment = "{ $typed }" does not have the form KEY=VALUE
    .help = write KEY=VALUE, for example limits.stroke=40 mm
scene-no-entry = { $list }.{ $number } does not exist; { $given ->
        [0] no entry is given
        [one] one entry is given
       *[other] { $given } entries are given
    }
    .help = entries count from 1: { $list }.1
scene-list-without-number = { $list } is a list of { $given } entries
    .help = write { $list }.1 for the first
scene-value-not-table = { $part } is a value, not a table
    .help = remove the part after { $part }
scene-file-and-model = only one of file, model and harmonics can be given
    .help = keep one: file = "walk.mot", model = "young" or harmonics = ["0.4", "0.1 at -90 deg"]
scene-not-harmonic = "{ $typed }" is not a load factor with its phase
    .help = write one string per harmonic with its amplitude (fraction of the weight, zero or more) and the phase of its sine: ["0.4", "0.1 at -90 deg"]
scene-not-learned-force = "{ $typed }" is not a force with its phase
    .help = write one string for the mean force and one for each harmonic with its amplitude and sine phase: ["0 N", "3.2 N at -90 deg"]
scene-learned-forces = the learned force has { $given } harmonics, which are too many
    .help = give the mean and the first harmonics, at most { $most } strings
scene-harmonics = { $given ->
        [one] the only load factor is zero
       *[other] the { $given } load factors are all zero or too many
    }
    .help = give 1 to { $most } factors, at least one of them above zero, for example ["0.4", "0.1 at -90 deg"]
scene-no-force-named = neither a recording nor a load model is given
    .help = give file = "walk.mot", model = "young" or harmonics = ["0.4", "0.1 at -90 deg"]; remove [gait] for a law given by segments or points
scene-no-phases = the range of phases from { $from } to { $to } is not valid
    .help = phases run from 0 to 360 deg; in a range across the end of the cycle, to is smaller than from
scene-nothing-weighed = all phases of the cycle have weight 0
    .help = give at least one range a weight above 0
scene-weigh-removed = law.weigh was removed
    .help = run gaitcam synth --front force_error:prime_radius, select a point of the trade-off, and set its limits
scene-no-force-to-follow = no target force is given
    .help = add [gait], or minimise "jerk", "peak-acceleration" …
scene-size-not-free = the size of this cam is not free
    .help = remove this key; it applies only to disc cams without a given radius, except with oscillating mushroom followers
scene-spline-degree = invalid spline degree { $typed }
    .help = write a whole number from 3 to 9, or "auto"
scene-degree-below-objective = the derivative of order { $order } of a law of degree { $degree } is zero between the knots and cannot be minimised
    .help = use degree { $order } or higher, or another law.minimise
scene-only-splines = a law of this family ({ $family }) does not support this key
    .help = use law.family = "spline"
scene-program-without-segments = the programme has no segments
    .help = write for each segment: [[law.segment]] motion = "cycloidal" lift = "10 mm" angle = "90 deg"
scene-polynomial-without-points = a polynomial needs at least two points
    .help = write for each point: [[law.point]] angle = "0 deg" lift = "0" velocity = "0"
scene-nothing-asked = the law has no target force, no points and no segments
    .help = add [gait] with a force, [[law.point]] entries, or family = "program" with segments
scene-no-speed = "auto" requires a target force, because its period determines the speed
    .help = write for example "60 rpm"
scene-no-mass = "auto" requires a target force, because its mean determines the mass
    .help = write for example "70 kg"
scene-base-and-prime = base_radius and prime_radius are both given, but each determines the other
    .help = remove one of them
scene-radius-and-breadth = the breadth determines the base radius: (breadth − lift) / 2
    .help = remove base_radius and prime_radius
scene-breadth-without-program = constant breadth requires a programme of the first half turn, which determines the second half turn
    .help = set law.family = "program" with segments
scene-roller-fills-prime = with the roller or arc radius of { $roller } the base radius would be { $base }
    .help = the prime radius must exceed the roller radius
scene-base-in-bore = the base radius of { $base } lies inside the bore of { $bore }
    .help = use a base radius above { $least }
scene-keyway-without-bore = a keyway needs a bore
    .help = give cam.bore, for example "20 mm"
scene-no-keyway-for-bore = DIN 6885-1 has no keyway for a bore of { $bore }
    .help = the standard covers bores above 6 mm up to 150 mm; give a width, or omit the keyway
scene-no-keyway-of-width = DIN 6885-1 has no keyway of { $width }
    .help = the standard widths are { $widths } mm
scene-keyway-too-wide = a keyway of { $width } does not fit a bore of { $bore }
    .help = write "auto" for the width of DIN 6885-1
scene-offset-reaches-prime = the offset of { $offset } is not smaller than the prime radius of { $prime }
    .help = reduce cam.offset or increase the prime radius
scene-force-needs-turn = a target force requires a law over one turn, but this cam ({ $follower }) translates or has a law of several turns
    .help = use a follower on a disc cam, or remove [gait] and give a programme
scene-length-needs-program = a law over a length must be given as a programme
    .help = set law.family = "program" with segments
scene-turns-need-program = a law over several turns must be given as a programme
    .help = set law.family = "program" with segments
scene-arm-on-moving-axis = a cam on a moving axis rests on a translating follower, but this follower swings about a fixed pivot
    .help = use kind = "hydraulic", or kind = "fixed-axis" with inertia, spring_rate and preload about the pivot
scene-pair-not-closed = give either this key or base_radius
    .help = give the distance between faces or roller centres (oscillating followers: the angle between the arms), or base_radius of the second cam
scene-frequency-and-stiffness = natural_frequency already defines the stiffness of the follower train
    .help = remove one of the two
scene-motor-line = a motor needs one of slope, stall_torque, rated_torque and curve
    .help = write for example slope = "10 N m s/rad" under [machine.motor], the decrease of torque per rad/s at the camshaft
scene-no-load-without-stall = a no-load speed requires a stall_torque
    .help = give stall_torque and no_load_speed, or only slope (the no-load speed is then computed)
scene-points-of-fusion = Fusion reads points in centimetres
    .help = omit --units
scene-half-nameplate = an induction motor requires both rated_torque and rated_speed
    .help = write for example rated_torque = "5.1 N m" and rated_speed = "1395 rpm" under [machine.motor]
scene-not-synchronous = the synchronous speed of the motor must be above its rated speed
    .help = write for example synchronous_speed = "1500 rpm": 120 times the frequency of the supply over the number of poles
scene-motor-curve = the torque of the motor must decrease with its speed
    .help = give at least two rows with increasing speeds and decreasing torques: a file with the columns speed_rad_per_s and torque_n_m, or pairs such as "0 50 10 20 12 -4"
scene-motor-without-inertia = a motor requires the moment of inertia of its shaft
    .help = write for example inertia = "0.5 kg m^2" under [machine] for flywheel and rotor, at the camshaft
scene-floor-lacks = a moving floor requires modal mass, frequency and damping ratio
    .help = write for example "{ $example }" under [machine.floor]
scene-floor-twice = the floor is given as one mode and as a list of modes
    .help = move the numbers of [machine.floor] into a [[machine.floor.mode]]
scene-walker-phases = one angle is required for each of the { $count } walkers of machine.walkers.count
    .help = write { $count } angles, the shaker first, as in ["0 deg", "90 deg"] for 2; or omit the key for random phases
scene-walker-weights = one positive weight is required for each of the { $count } walkers of machine.walkers.count
    .help = write { $count } weights, the shaker first, as in ["700 N", "850 N"] for 2; or omit the key for equal weights
scene-floor-alone = this key is not available with a moving floor
    .help = omit this key, or [machine.floor]
scene-floor-needs-shaker = a moving floor requires drive.kind = "moving-axis" with [gait] and without law.polydyne
    .help = omit [machine.floor], or use this drive
scene-residual-without-frequency = the limit on residual vibration requires this key
    .help = write for example "60 Hz" under [machine]
scene-force-range = { $low } is not less than force_max = { $high }
    .help = lower force_min or raise force_max
scene-polydyne-without-stiffness = a polydyne cam needs the stiffness of the follower
    .help = write stiffness = "9 kN/m" or natural_frequency = "60 Hz" under [machine]
scene-polydyne-family = a polydyne cam needs a law with four continuous derivatives, which this family ({ $family }) does not guarantee
    .help = use family = "spline" or "harmonic", or a programme of 5-6-7-8-9 segments
scene-polydyne-degree = below degree 5 the acceleration of a polydyne cam would be discontinuous, because its lift includes the deflection of the follower
    .help = use degree 5 to 9
scene-polydyne-on-slide = a polydyne cam must rotate, because a law that does not repeat has no steady state
    .help = remove law.polydyne, or use another follower
scene-polydyne-breadth = a polydyne cam cannot have constant breadth, because the deflection of the follower differs half a turn later
    .help = remove law.polydyne or cam.breadth
scene-no-such-scene = the built-in scene "{ $typed }" does not exist
    .help = { $nearest ->
        [none] the built-in scenes are { $known }
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
