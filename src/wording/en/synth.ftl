# Reasons for the verdict on a design.
reason-out-of-time = The time limit ended the search; this is the best cam found. Allow more time with --time-limit.
reason-all-hold = All limits are satisfied; lift, velocity and acceleration are continuous over the whole cycle.
reason-mean-force = The mean target force is { $mean }, but the weight of the mass is { $weight }. A cam cannot change the mean force over a turn, so the force error is at least { $error } RMS. Set drive.mass = "auto" or gait.scale = "to-mass".
reason-recording-kind = The kind of movement in the recording is not certain: { $because }. Set { $keys }, or gait.accept = "kind" if the kind is correct.
reason-recording-clock = The time scale of the recording is not certain: { $because }. Set { $keys }, or gait.accept = "clock" if the time scale is correct.
reason-recording-mass = The mass of the walker and the scale of the forces are not certain: { $because }. Set { $keys }, or gait.accept = "mass" if mass and scale are correct.
reason-recording-clipped = The recording is clipped: { $because }. Its peaks and the mass are too low, and gait.accept does not permit a clipped recording. Record again with a larger range, or omit the column ({ $keys }).
reason-lift-jumps = The lift is discontinuous at { $at }; no follower can follow such a lift. Prescribe the same lift on both sides.
reason-velocity-jumps = The velocity is discontinuous at { $at }, which causes infinite acceleration and an impact on the follower. Prescribe the same velocity on both sides (law.point.N.velocity).
reason-acceleration-jumps = The acceleration is discontinuous at { $at }, which causes infinite jerk, and vibration at high speed.
reason-lifts-off = The minimum contact force is −{ $pull } at { $at }, so the follower loses contact above { $speed }. Set limits.force_min = "0 N" to maintain contact.
reason-lifts-off-as-prescribed = The minimum contact force is −{ $pull } at { $at }, so the follower loses contact above { $speed }. Run the cam more slowly, or prescribe a lower deceleration there.
reason-contact-lost = The minimum contact force is −{ $pull } at { $at }, so the follower loses contact. Set a larger drive.spring_rate or drive.preload, or a lower drive.speed.
reason-contact-lost-in-run = In this run the follower is out of contact with the cam for { $share } of the motion. Set a larger drive.spring_rate or drive.preload, or a lower drive.speed.
reason-cusp = The profile has a cusp (zero radius of curvature) at { $at }. Set limits.curvature.
reason-undercut = The profile is undercut at { $at }; its convex radius of curvature would be { $radius }.
reason-too-sharp = The radius of curvature at { $at } is { $radius }; the minimum is { $allowed }.
reason-second-too-sharp = The radius of curvature of the second cam at { $at } is { $radius }; the minimum is { $allowed }. Place its follower farther from the shaft.
reason-base-radius-works = This law requires a base radius of { $radius }.
reason-enlarge-base-circle = Enlarge the base circle (cam.base_radius), or use a smaller roller (cam.roller_radius).
reason-lengthen-travel = Increase the length of travel (cam.travel), or use a smaller roller (cam.roller_radius).
reason-interference = At { $at } the follower interferes with another part of the cam by { $depth }. Use a smaller roller (cam.roller_radius), or enlarge the base circle (cam.base_radius).
reason-sharp-wall = The radius of curvature of a groove wall at { $at } is { $radius }; the minimum is { $allowed }. Use a smaller roller (cam.roller_radius), or a larger cylinder (cam.base_radius).
reason-roller-too-large = The roller does not fit the concave profile at { $at }: the roller radius is { $roller }, but the radius of curvature is { $hollow }. Set a smaller cam.roller_radius.
reason-pressure-angle = The pressure angle reaches { $angle } at { $at }; the maximum is { $allowed }. The follower may jam in its guide. Enlarge the prime circle (cam.prime_radius or cam.base_radius).
reason-large-pressure-angle = The pressure angle reaches { $angle } at { $at }; angles above { $usual } are for low speed only. Enlarge the prime circle (cam.prime_radius or cam.base_radius), or set limits.pressure_angle.
reason-force-error-in-run = In this run the force error is { $error } RMS; the maximum is { $allowed } (accuracy.rms).
reason-force-error = The force error is { $error } RMS; the maximum is { $allowed }. Relax the active limits, set more law.spans, or set accuracy.rms to an acceptable error.
reason-preload-above-target = The force error is { $error } RMS; the maximum is { $allowed }. The force cannot be less than the preload of { $preload }, but the minimum of the target is { $least }. Set drive.preload to { $least } or less.
reason-below-base-circle = The law falls { $depth } below the base circle at { $at }.
reason-prime-radius = The prime radius of this cam is { $needed }; the maximum is { $allowed }. Allow a larger pressure angle (limits.pressure_angle) or a larger force error (accuracy.rms).
reason-outside-band = The force is outside its band by { $excess } at { $at }. Set a wider gait.band or more law.spans.
reason-limit-unbounded = The { $limit } is infinite at { $at }, because the next lower derivative is discontinuous there. No value of this limit is sufficient. Use a law without that discontinuity, or remove the limit.
reason-pressure-unbounded = The contact pressure is infinite at { $at }, because the convex radius of curvature of the profile is zero or negative there.
reason-limit-broken = The limit { $limit } is violated at { $at }: the value is { $value }, but the limit is { $allowed }.

# Notes on problem and design, in addition to the verdict.
design-scene = { $note }
design-recording = { $note }
design-stretched = One turn takes { $turn }, but the force cycle takes { $cycle }. The force curve is stretched to the turn.
design-rounded-table = The lifts in the table of segment { $segment } are rounded. The rounding errors can cause up to { $share } of the maximum acceleration of the segment. Give lifts with more decimals.
design-not-judged = { $key } = "none" switches the default limit off.
design-mean-force = The mean target force is { $mean }, but the weight of the mass is { $weight }. A cam cannot change the mean force over a turn, so the force error is at least { $error } RMS. Set drive.mass = "auto" or gait.scale = "to-mass".
design-free-fall = The target force is near zero for { $share } of the turn ({ $duration }). There the mass must be in free fall, which alone requires a lift of about { $lift }. In walking, the total force of both feet (feet = "both") does not reach zero. A hydraulic drive (drive.kind = "hydraulic") reproduces zero force without free fall.
design-largest-stroke = The target force accelerates the mass by at most { $acceleration }. The stroke h is therefore at most { $stroke }, because 16 h/T² ≤ max|a| for a turn of duration T{ $idle ->
        [true] ; the stroke limit cannot be active
       *[other] {""}
    }.
design-first-walker = The machine counts as the first walker, with the weight { $weight } (first entry of { $key }).
design-phase = Cam angle 0 is at { $phase } of the force cycle. This phase gives the minimum force error.
design-out-of-time = The search ended at its time limit. The result is the best one found, and not all relaxations were tried. Allow more time with --time-limit.
design-noise = The number of { $size } is chosen for a force error of { $error } RMS, one fifth of the step-to-step standard deviation of the recording. A larger number would fit the noise of the recording. Set accuracy.rms to change this.
design-sensor-noise = The samples of the force contain sensor noise of { $noise } RMS. The automatic accuracy and number of { $size } are set for a force error of { $error } RMS. Set gait.noise or accuracy.rms to change this.
design-many-spans-in-band = The automatic number of spans is { $spans }; with fewer spans the force leaves gait.band. Set a wider band or fewer law.spans.
design-many-spans = The automatic number of spans is { $spans }, because the force error must be at most { $error } RMS. Set gait.noise if the force is noisy, a larger accuracy.rms, or fewer law.spans.
design-thin-wall = The wall between bore and base circle is { $wall }; hubs usually have { $usual }. Set a larger cam.base_radius or a smaller cam.bore.
design-large-roller = The radius of the roller, { $roller }, exceeds that of the cam, { $cam }. Check cam.roller_radius and its unit.
design-thin-shaft = The base circle has a diameter of { $circle }, but a steel shaft for the torque of { $torque } requires { $shaft } (shear stress 40 MPa). Enlarge the cam, or leave its size open and set cam.bore to the diameter of the shaft.
design-large-bore = The bore has a diameter of { $bore }, but a steel shaft for the torque of { $torque } requires only { $shaft } (shear stress 40 MPa). Check cam.bore and its unit.
design-inertia-for-accuracy = With this motor the force error over time is { $error } of the mean; the maximum is { $allowed }. An inertia of { $inertia } (machine.inertia) is sufficient. If the family of the law allows it, law.shaft = "motor" designs the law for this motor.
design-no-base-circle = The minimum base radius is zero, so the profile passes through the shaft axis. Set cam.bore or cam.base_radius.
design-usual-pressure-angle = No limit on the pressure angle is given; the cam is sized for the usual maximum of { $angle }. Set limits.pressure_angle to change it.
design-polydyne = The cam is polydyne: at { $speed } the output end of a follower of stiffness { $stiffness } follows the law. Lift, velocity, acceleration, jerk and their limits refer to the cam; the force refers to the output end.
design-polydyne-miss = With its flexible follower this cam has a force error of { $own } RMS. A cam without the polydyne correction would have { $plain } RMS.

# Faults in the input of a design.
synth-shaft-diverges = the iteration of law and shaft speed does not converge: the speed ripple is { $ripple } or more
    .help = set machine.inertia = "{ $inertia }" (ripple of about { $calm }), a steeper torque line of the motor, or law.shaft = "constant"
synth-adjusts-given = { $key } is given, but gait.adjust sets it for each walker
    .help = omit { $key }, or remove it from gait.adjust
synth-mass-not-adjustable = with this drive, the mass does not balance the weight of a walker
    .help = remove "mass" from gait.adjust, or set drive.kind = "moving-axis"
synth-speed-not-adjustable = the force of this drive does not scale with the speed, because its spring, damping and inertia forces scale differently
    .help = remove "speed" from gait.adjust and give drive.speed
synth-not-of-population = this setting is not available for several walkers
    .help = give one cycle, or omit the setting; law.robust requires the objective force-error and law.family = "spline" or "harmonic", or no law.family
synth-machine-of-population = a cam for several walkers is designed without motor and floor
    .help = omit this setting here, then simulate the finished cam with it: gaitcam simulate DIR --set KEY=VALUE --speeds START:STOP:COUNT
synth-one-walker = cams cannot be selected for only one walker
    .help = give a folder, a list or a table of several walkers
synth-force-not-read = the force curve was not read
synth-no-lift-changes-force = the force does not depend on the lift: spring rate, damping and mass are all zero
    .help = give at least one of spring_rate, damping, mass
synth-value-missing = a value is required if no force is given
synth-mean-force-negative = the mean force is { $mean }, but a mass on the cam requires a positive one
    .help = compressive forces must be positive: check the sign and the column
synth-not-scalable = a mean force of { $mean } cannot be scaled to { $weight }
synth-no-spread = the target is a single cycle without spread
    .help = give a recording of several steps, or a width: band = "20 N"
synth-pair-incomplete = "{ $pair }" is not a pair of quantities
    .help = write force_error:prime_radius; instead of prime_radius you can use { $known }
synth-pair-without-force-error = one of the two quantities must be force_error
    .help = write force_error:prime_radius; instead of prime_radius you can use { $known }
synth-pair-unknown = invalid value "{ $typed }"
    .help = write force_error:prime_radius; instead of prime_radius you can use { $known }
synth-no-target = the trade-off requires a target force
synth-only-splines = the trade-off is available for splines only
    .help = use law.family = "spline", or gaitcam sweep and gaitcam front
synth-size-fixed = the scene fixes the size of the cam
    .help = omit base_radius and prime_radius
synth-no-law = { $reason }
synth-search-failed = the search failed: { $fault }
synth-too-many-harmonics = { $samples } samples determine at most { $most } harmonics
synth-resonance = harmonic { $harmonic } of the force is at the resonance of the drive, where spring and inertia forces cancel
    .help = set a larger drive.damping, or change drive.mass, drive.spring_rate or drive.speed
synth-no-constant-breadth = the law does not have a constant breadth: the sum of the lifts at θ and θ + 180° is { $sum } at θ = 0°, but changes by { $miss } at θ = { $at }
    .help = give only the segments of the first 180°; they determine the other half
synth-breadth-too-small = a breadth of { $breadth } is too small for a lift of { $lift }
    .help = the breadth is twice the base radius (roller: prime radius) plus the lift
synth-no-prime-circle = no prime circle is large enough
    .help = remove the discontinuity of the velocity, because it causes a corner of the profile with any base radius
synth-follower-needs = this follower requires this key
synth-no-range = the range from { $start } to { $end } is not valid within one turn
    .help = angles run from 0 to 360 deg
synth-degree-too-low = { $conditions } conditions fix a polynomial of degree { $fixed }, not { $degree }
    .help = write degree = { $fixed }, or remove { $excess } conditions
synth-degree-too-high = { $conditions } conditions fix a polynomial of degree { $fixed }, not { $degree }
    .help = write degree = { $fixed }, or add { $missing } conditions
synth-many-demands = points and dwells give { $given } conditions on one law; at most { $most } can be solved
    .help = give a measured curve as a force or a band, or omit points
synth-law-open = the law ends { $rise } above its start, so it is not closed
    .help = set the lift of the last point to the lift of the first point
synth-force-gives-no-lift = with this drive a force does not determine a lift
    .help = give the lift of the point, or set drive.kind = "hydraulic"
synth-points-empty = the points give no condition
    .help = give lift, force, velocity, acceleration or jerk
synth-family-needs-force = this family requires a target force
    .help = add [gait], or set law.family = "spline", "polynomial" or "program"
synth-no-double-harmonic = the search found no double harmonic law
synth-double-harmonic-useless = no double-harmonic law reproduces this force better than a constant force
    .help = use family = "spline"
synth-dwells-overlap = two dwells overlap
    .help = combine them into one dwell
synth-dwells-fill-turn = the dwells cover the whole turn
    .help = shorten a dwell
synth-point-outside = { $at } is outside the turn
    .help = angles run from 0 to 360 deg
