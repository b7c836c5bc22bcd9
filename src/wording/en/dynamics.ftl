# Faults in what a simulation is given, and what its models cannot answer.
dynamics-machine = mass, spring rate, damping, friction and speed must be finite, the first three not negative
dynamics-friction = invalid coefficient of friction { $friction }
    .help = it must be 0 or more
dynamics-contact-line = a contact line needs a positive length and materials with a positive Young's modulus and a Poisson's ratio in [0, 0.5]
dynamics-target = the target force must be finite at every angle
dynamics-slide-backwards = a translating cam whose law does not repeat runs forwards only
    .help = give the drive a positive speed
dynamics-second-cam = a second cam on the shaft needs a follower that rests on the first, and a law of one turn
    .help = omit the second cam
dynamics-restitution = invalid coefficient of restitution { $restitution }
    .help = it must lie in [0, 1]: 0 for a plastic impact, 1 for an elastic one
dynamics-few-rows = { $rows } points are too few for a profile
    .help = give at least 8 points, preferably 360 or more
dynamics-row-angle = profile row { $row } is at { $at } instead of { $expected }
    .help = a simulation needs rows at equal steps over the cycle of the cam
dynamics-row-reach = profile row { $row } cannot be touched by this follower: { $follower }
    .help = its coordinates must be finite and within the follower's range
dynamics-concave = the profile is undercut or concave at { $at }: radius of curvature { $radius }
    .help = a flat face cannot touch it; increase the base radius
dynamics-frequency = invalid natural frequency of { $frequency } Hz with damping ratio { $ratio }
    .help = the frequency must be positive and the damping ratio not negative
dynamics-frequency-without-mass = a natural frequency needs a moving mass
    .help = { $fluid ->
        [true] a hydraulic drive moves none; give machine.stiffness, that of the fluid column, in place of the frequency
       *[other] give drive.mass, under an arm drive.inertia
    }
dynamics-train = the follower's stiffness must be positive and its damping not negative
dynamics-resonance = resonance: the undamped follower vibrates { $cycles } times per turn, at a harmonic of the cam; there is no steady state
    .help = give a damping ratio above 0, or another speed
dynamics-no-train = the flexible model needs the stiffness of the follower
    .help = give machine.natural_frequency or machine.stiffness
dynamics-open-vibration = a translating cam whose law does not repeat has no steady-state vibration
    .help = use the rigid model
dynamics-held-by-groove = the groove guides the roller on both sides: contact cannot be lost
    .help = use the rigid or the flexible model, which give the side in contact
dynamics-held-by-pair = a conjugate pair guides the follower on both sides: contact cannot be lost
    .help = use the rigid or the flexible model, which give the side in contact
dynamics-not-one-turn = the contact model needs a cam that turns once per cycle
    .help = use the rigid model: its minimum contact force shows whether a translating cam keeps contact
dynamics-motor = inertia and friction of the motor's shaft must not be negative, gear and efficiency positive, and the speed of the shaft not 0
dynamics-motor-turns = a motor can only turn one cam whose law spans one turn
    .help = omit machine.motor or the second cam
dynamics-stalls = the shaft does not keep turning: its inertia of { $inertia } is too small to carry it past the maximum load
    .help = set machine.inertia = "{ $needed }" or more, or a steeper torque line
dynamics-stalls-anyway = the shaft does not keep turning with any inertia: the torque line of the motor is too weak for the load
    .help = give a steeper torque line (machine.motor.slope, machine.motor.stall_torque)
dynamics-no-load-speed = the no-load speed of the motor, { $nominal }, is too low for a mean speed of { $speed } of the camshaft
    .help = set machine.motor.no_load_speed = "{ $needed }" or more, or a lower machine.motor.gear
dynamics-floor-resonance = the floor has no steady motion: harmonic { $harmonic } of the force is at its undamped frequency of { $frequency }
    .help = give this mode a damping ratio above 0, for example "0.005"
dynamics-contact-under-motor = the contact model needs a constant speed, and the motor varies it
    .help = use --model rigid, or omit [machine.motor]
dynamics-floor-not-rigid = only the rigid model has a floor that moves
    .help = use --model rigid or auto without flexible follower, or omit [machine.floor]
dynamics-floor-and-shaft = shaft and floor find no common steady motion
    .help = use a larger machine.inertia or a larger machine.floor.damping
dynamics-open-polydyne = a polydyne cam needs a law that repeats: otherwise there is no steady state
dynamics-polydyne-jump = the { $derivative } of the law is discontinuous at { $at }; the lift of a polydyne cam contains the force, so the cam's own acceleration would be discontinuous there
    .help = use a law with four continuous derivatives: a spline of degree 5 or more, harmonics, or 5-6-7-8-9 segments

# Why a model was chosen.
model-asked-for = selected
model-low-force = the rigid contact load falls to { $force }, below { $part } of its mean { $mean }; { $liftoff }
model-near-liftoff = near lift-off: { $liftoff }
model-two-cams = impacts occur where one cam takes over from the other; only the contact model includes them
model-nothing-vibrates = { $margin }; no natural frequency or stiffness is given, so nothing can vibrate
model-vibration-loses-contact = { $vibration }; with vibration the contact load falls to { $force } and contact is lost; the contact model leaves the vibration out
model-vibrates = { $vibration }, more than { $allowed }; { $margin }
model-hardly-vibrates = { $vibration }, no more than { $allowed }; { $margin }
model-held-from-both-sides = held from both sides, the follower cannot lift off
model-no-liftoff = speed { $speed }, no speed lifts the follower off
model-moving-floor = speed { $speed }; the lift-off speed of a moving floor is not computed
model-liftoff-at = speed { $speed }, lift-off at { $liftoff }
model-no-force = nothing presses the follower on the cam: the drive has neither mass nor spring nor preload
model-inertia-only = no mean load presses the follower on the cam, inertia gives { $low } … { $high }; { $liftoff }
model-smallest-force = the minimum contact load { $force } is { $part } of the mean; { $liftoff }
model-no-mass = the fluid column yields without vibration
model-harmonics = the first natural frequency is { $frequency }, { $ratio } times the shaft frequency; vibration would change the force by { $part } of the mean (RMS)

# What to know of a run.
run-second-cam-bears = the second cam bears for { $part } of the cycle, up to { $force }; at each change the clearance between both sides is crossed
run-other-wall-bears = the other wall of the groove bears for { $part } of the cycle, up to { $force }; at each change the clearance between both sides is crossed
run-rigid-pulls = the rigid model pulls where the force is negative: the contact model follows the lift-off
run-rigid-without-impacts = the rigid model leaves out the impacts where one cam takes over from the other
run-flexible-pulls = the vibrating follower leaves the cam: the flexible model pulls there
run-escapes = the mass leaves the cam and nothing brings it back
run-not-periodic = the motion does not repeat within { $turns } turns and { $impacts } impacts
run-swings = the follower oscillates: lift and gap are angles in rad, the force is the moment about the pivot in N·m (in the files the force at the lever, in N), and mass, spring and preload of the drive act about the pivot; the normal force is in N
run-pair-distance = the conjugate pair keeps its distance within { $deviation }; where the force turns negative the second cam bears it
run-steady-shaft = under its motor the speed would ripple by about { $ripple } and change the force by { $change } of the mean, no more than { $allowed }: constant speed is enough
run-shaft-varies = under its motor the speed ripples by { $found } (forecast from inertia and energy { $ripple }, which would change the force by { $change } of the mean): the force is that of the varying speed
run-flexible-at-mean-speed = the compliant follower is run at the mean speed of the shaft; the ripple is that under a rigid follower
