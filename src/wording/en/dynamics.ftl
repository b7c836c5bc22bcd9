# Faults in what a simulation is given, and what its models cannot answer.
dynamics-machine = mass, spring rate, damping, friction and speed must be finite; mass, spring rate and damping must not be negative
dynamics-friction = invalid coefficient of friction { $friction }
    .help = it must be 0 or more
dynamics-contact-line = a contact line needs a positive length and materials with a positive Young's modulus and a Poisson's ratio in [0, 0.5]
dynamics-target = the target force must be finite at every angle
dynamics-slide-backwards = a translating cam with a law that does not repeat moves only forwards
    .help = set a positive drive.speed
dynamics-second-cam = a second cam on the shaft requires a law of one turn and a follower that rests on the first cam
    .help = omit the second cam (machine.second_cam)
dynamics-restitution = invalid coefficient of restitution { $restitution }
    .help = it must lie in [0, 1]: 0 for a plastic impact, 1 for an elastic one
dynamics-few-rows = { $rows } points are not sufficient for a profile
    .help = give at least 8 points, preferably 360 or more
dynamics-row-angle = profile row { $row } is at { $at } instead of { $expected }
    .help = a simulation needs rows at equal steps over the cycle of the cam
dynamics-row-reach = this follower ({ $follower }) cannot touch profile row { $row }
    .help = its coordinates must be finite and within the follower's range
dynamics-concave = at { $at } the profile is undercut or concave, with a radius of curvature of { $radius }
    .help = a flat face cannot touch it; set a larger cam.base_radius
dynamics-frequency = invalid natural frequency of { $frequency } Hz with damping ratio { $ratio }
    .help = the frequency must be positive and the damping ratio not negative
dynamics-frequency-without-mass = a natural frequency needs a moving mass
    .help = { $fluid ->
        [true] a hydraulic drive has no moving mass; instead of the frequency, give the stiffness of the fluid column (machine.stiffness)
       *[other] give drive.mass, or drive.inertia for a follower on an arm
    }
dynamics-train = the follower's stiffness must be positive and its damping not negative
dynamics-resonance = resonance: the undamped follower vibrates { $cycles } times per turn, at a harmonic of the cam, so there is no steady state
    .help = set machine.damping_ratio above 0, or another drive.speed
dynamics-no-train = the flexible model needs the stiffness of the follower
    .help = give machine.natural_frequency or machine.stiffness
dynamics-open-vibration = a translating cam with a law that does not repeat has no steady-state vibration
    .help = use the rigid model
dynamics-held-by-groove = the groove guides the roller on both sides, so contact cannot be lost
    .help = use the rigid or the flexible model, which give the side in contact
dynamics-held-by-pair = a conjugate pair guides the follower on both sides, so contact cannot be lost
    .help = use the rigid or the flexible model, which give the side in contact
dynamics-not-one-turn = the contact model requires a cam that turns once per cycle
    .help = use the rigid model: its minimum contact force shows whether a translating cam loses contact
dynamics-motor = inertia and friction of the motor shaft must be zero or positive, gear ratio and efficiency must be positive, and the shaft speed must not be zero
dynamics-motor-turns = a motor can only turn one cam whose law spans one turn
    .help = omit machine.motor or the second cam (machine.second_cam)
dynamics-stalls = the shaft stops: its inertia of { $inertia } is too small to carry it past the maximum load
    .help = set machine.inertia = "{ $needed }" or more, or a steeper torque line
dynamics-stalls-anyway = the shaft stops with any inertia: the torque line of the motor is too low for the load
    .help = give a steeper torque line (machine.motor.slope, machine.motor.stall_torque)
dynamics-no-load-speed = the no-load speed of the motor, { $nominal }, is too low for a mean camshaft speed of { $speed }
    .help = set machine.motor.no_load_speed = "{ $needed }" or more, or a lower machine.motor.gear
dynamics-few-programme-rows = the speed programme has only { $rows } rows
    .help = give at least three rows with the columns time_s,speed_rad_per_s
dynamics-programme-row = row { $row } of the speed programme is invalid
    .help = the times must increase, and the speeds must be positive
dynamics-programme-turns = a speed programme needs a cam that turns and a law that repeats after one turn
    .help = use a cam of one turn per cycle
dynamics-programme-acceleration = every speed programme for this walk exceeds the acceleration limit of { $most }
    .help = allow a larger acceleration (--max-acceleration)
dynamics-programme-contact = with any speed programme for this walk the contact force falls to { $least }; the limit is { $limit }
    .help = design the cam with a larger limits.force_min
dynamics-programme-motor = the motor cannot follow the programme: at { $at } it would need { $torque } at a camshaft speed of { $speed }
    .help = use a larger machine.inertia, a steeper torque line (machine.motor.slope, machine.motor.stall_torque) or a larger machine.motor.no_load_speed
dynamics-programme-stops = the shaft stops at { $at } of the speed programme: the motor is too weak
    .help = use a larger machine.inertia or a steeper torque line (machine.motor.slope, machine.motor.stall_torque)
dynamics-floor-resonance = the floor has no steady motion: harmonic { $harmonic } of the force is at the natural frequency of an undamped mode, { $frequency }
    .help = give this mode a damping ratio above 0, for example "0.005"
dynamics-contact-under-motor = the contact model requires a constant speed, but the motor varies it
    .help = use --model rigid, or omit [machine.motor]
dynamics-floor-not-rigid = only the rigid model includes a moving floor
    .help = use --model rigid, use --model auto without a flexible follower, or omit [machine.floor]
dynamics-floor-and-shaft = the search found no common steady motion of shaft and floor
    .help = use a larger machine.inertia or a larger machine.floor.damping
dynamics-open-polydyne = a polydyne cam requires a law that repeats, because otherwise there is no steady state
dynamics-polydyne-jump = the { $derivative } of the law is discontinuous at { $at }, so the acceleration of the polydyne cam would be discontinuous there
    .help = use a law with four continuous derivatives: a spline of degree 5 or more, harmonics, or 5-6-7-8-9 segments

# Why a model was chosen.
model-asked-for = selected by the user
model-low-force = the contact load of the rigid model falls to { $force }, below { $part } of its mean { $mean }; { $liftoff }
model-near-liftoff = near lift-off: { $liftoff }
model-two-cams = impacts occur where the load changes from one cam to the other; only the contact model includes them
model-nothing-vibrates = { $margin }; no natural frequency or stiffness is given, so vibration is not computed
model-vibration-loses-contact = { $vibration }; with vibration the minimum contact load is { $force } and contact is lost, but the contact model does not include vibration
model-vibrates = { $vibration }, more than { $allowed }; { $margin }
model-hardly-vibrates = { $vibration }, no more than { $allowed }; { $margin }
model-held-from-both-sides = the follower is guided on both sides and cannot lift off
model-no-liftoff = speed { $speed }; the follower does not lift off at any speed
model-moving-floor = speed { $speed }; the lift-off speed of a moving floor is not computed
model-liftoff-at = speed { $speed }, lift-off at { $liftoff }
model-no-force = no force presses the follower on the cam: the drive has no mass, spring or preload
model-inertia-only = the mean load on the follower is zero; the inertia force is { $low } … { $high }; { $liftoff }
model-smallest-force = the minimum contact load is { $force }, { $part } of the mean; { $liftoff }
model-no-mass = the fluid column deflects without vibration
model-harmonics = the first natural frequency is { $frequency }, { $ratio } times the shaft frequency; vibration would change the force by { $part } of the mean (RMS)

# What to know of a run.
run-second-cam-bears = the second cam carries the load, at most { $force }, for { $part } of the cycle; the follower moves through the clearance at each change
run-other-wall-bears = the opposite wall of the groove carries the load, at most { $force }, for { $part } of the cycle; the follower moves through the clearance at each change
run-rigid-pulls = the rigid model permits a negative contact force; use the contact model to compute the lift-off
run-rigid-without-impacts = the rigid model does not include the impacts where the load changes from one cam to the other
run-flexible-pulls = the vibrating follower loses contact, but the flexible model permits a negative contact force
run-escapes = the mass loses contact with the cam and does not return
run-not-periodic = the motion does not repeat within { $turns } turns and { $impacts } impacts
run-swings = the follower oscillates: lift and gap are angles in rad; the force is the moment about the pivot in N·m. Mass, spring and preload refer to the pivot. The force at the lever (in the files) and the normal force are in N
run-pair-distance = the distance of the conjugate pair is constant within { $deviation }; the second cam carries negative forces
run-steady-shaft = with this motor the speed would vary by about { $ripple } and the force by { $change } of the mean. The speed is taken as constant, because this force change is within { $allowed }
run-shaft-varies = the motor causes a speed ripple of { $found } (estimate: { $ripple }, with a force change of { $change } of the mean), and the force is computed for this varying speed
run-flexible-at-mean-speed = the compliant follower is simulated at the mean speed of the shaft; the speed ripple is computed with a rigid follower
