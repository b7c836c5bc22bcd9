# Reasons for the verdict on a design.
reason-out-of-time = The time limit ended the search: this is the best cam found until then. Allow more with --time-limit.
reason-all-hold = All limits are satisfied; lift, velocity and acceleration are continuous over the whole cycle.
reason-mean-force = The mean target force is { $mean }, but the weight of the mass is { $weight }. A cam cannot change the mean force over a turn, so the force error is at least { $error } RMS. Set drive.mass = "auto" or gait.scale = "to-mass".
reason-recording-kind = The kind of movement in the recording is not certain: { $because }. Set { $keys }, or gait.accept = "kind" if it is right as it is.
reason-recording-clock = The time scale of the recording is not certain: { $because }. Set { $keys }, or gait.accept = "clock" if it is right as it is.
reason-recording-mass = The mass of the walker and the size of the forces are not certain: { $because }. Set { $keys }, or gait.accept = "mass" if they are right as they are.
reason-recording-clipped = The recording is clipped: { $because }. Its peaks and the mass are too low, which cannot be accepted. Record again with a larger range, or leave the column out ({ $keys }).
reason-lift-jumps = The lift is discontinuous at { $at }: no follower can execute it. Prescribe the same lift on both sides.
reason-velocity-jumps = The velocity is discontinuous at { $at }: infinite acceleration and impact on the follower. Prescribe the same velocity on both sides (law.point.N.velocity).
reason-acceleration-jumps = The acceleration is discontinuous at { $at }: infinite jerk, and vibration at high speed.
reason-lifts-off = The contact force becomes negative at { $at } (by { $pull }): above { $speed } the follower loses contact. Set limits.force_min = "0 N" to keep it in contact.
reason-lifts-off-as-prescribed = The contact force becomes negative at { $at } (by { $pull }): above { $speed } the follower loses contact. Run the cam more slowly, or prescribe a lower deceleration there.
reason-contact-lost = The contact force becomes negative at { $at } (by { $pull }): the follower loses contact. Use a stiffer spring, a larger preload, or a lower speed.
reason-contact-lost-in-run = Run on its machine, the follower is out of contact with the cam for { $share } of the motion. Use a stiffer spring, a larger preload, or a lower speed.
reason-cusp = The profile has a cusp at { $at } (zero radius of curvature). Set limits.curvature.
reason-undercut = The profile is undercut at { $at }: its convex radius of curvature would be { $radius }.
reason-too-sharp = The radius of curvature at { $at } is { $radius }; the minimum is { $allowed }.
reason-second-too-sharp = The radius of curvature of the second cam at { $at } is { $radius }; the minimum is { $allowed }. Place its follower farther from the shaft.
reason-base-radius-works = This law needs a base radius of { $radius }.
reason-enlarge-base-circle = Enlarge the base circle, or use a smaller roller.
reason-lengthen-travel = Increase the length of travel, or use a smaller roller.
reason-interference = At { $at } the follower interferes with another part of the cam by { $depth }. Use a smaller roller, or enlarge the base circle.
reason-sharp-wall = The radius of curvature of a groove wall at { $at } is { $radius }; the minimum is { $allowed }. Use a smaller roller, or a larger cylinder.
reason-roller-too-large = The roller does not fit the concave profile at { $at }: the roller radius is { $roller }, the radius of curvature { $hollow }. Use a smaller roller.
reason-pressure-angle = The pressure angle reaches { $angle } at { $at }; the maximum is { $allowed }. The follower may jam in its guide. Enlarge the prime circle.
reason-large-pressure-angle = The pressure angle reaches { $angle } at { $at }; more than { $usual } is for low speed only. Enlarge the prime circle, or set limits.pressure_angle.
reason-force-error-in-run = In this run the force error is { $error } RMS; accuracy.rms allows { $allowed }.
reason-force-error = The force error is { $error } RMS; the maximum is { $allowed }. Relax the active limits, allow more spans, or set accuracy.rms to the error that is acceptable.
reason-preload-above-target = The force error is { $error } RMS; the maximum is { $allowed }. The preload of { $preload } is above the smallest force of the target, { $least }, and the force cannot be smaller. Set drive.preload to { $least } or less.
reason-below-base-circle = The law falls { $depth } below the base circle at { $at }.
reason-prime-radius = The prime radius of the cam shown is { $needed }; the maximum is { $allowed }. Allow a larger pressure angle or a larger force error.
reason-outside-band = The force is outside its band by { $excess } at { $at }. Widen the band, or allow more spans.
reason-limit-unbounded = The { $limit } is infinite at { $at }: the next lower derivative is discontinuous there, and no value of this limit is sufficient. Use a law without that discontinuity, or remove the limit.
reason-limit-broken = The limit { $limit } is violated at { $at }: the value is { $value }, the limit { $allowed }.

# Notes on problem and design beside the verdict.
design-scene = { $note }
design-recording = { $note }
design-stretched = One turn takes { $turn } and the force cycle { $cycle }: the force curve is stretched to the turn.
design-rounded-table = The lifts of the table of segment { $segment } are rounded: up to { $share } of its maximum acceleration can be due to rounding. Give lifts with more decimals.
design-not-judged = { $key } = "none": the default bound is not judged.
design-mean-force = The mean target force is { $mean }, but the weight of the mass is { $weight }. A cam cannot change the mean force over a turn, so the force error is at least { $error } RMS. Set drive.mass = "auto" or gait.scale = "to-mass".
design-free-fall = The target force is near zero for { $share } of the turn ({ $duration }). The mass must be in free fall there, which alone needs a lift of about { $lift }. The total force of both feet (feet = "both") does not reach zero in walking.
design-largest-stroke = The target force accelerates the mass by at most { $acceleration }, so the stroke is at most { $stroke } (16 h/T² ≤ max|a|){ $idle ->
        [true] ; the stroke limit cannot be active
       *[other] {""}
    }.
design-phase = The turn of the cam starts at { $phase } of the force cycle, the phase of smallest force error.
design-out-of-time = The search was ended at its time limit: the result is the best found until then, and relaxations that are not listed were not tried. Allow more with --time-limit.
design-noise = The number of { $size } is limited to a force error of { $error } RMS, one fifth of the step-to-step standard deviation of the recording; more would fit its noise. Set accuracy.rms to change this.
design-sensor-noise = The samples of the force contain sensor noise of { $noise } RMS: the automatic accuracy and the number of { $size } are set for a force error of { $error } RMS. Set gait.noise or accuracy.rms to change this.
design-many-spans-in-band = The automatic number of spans is { $spans }, because fewer do not keep the force inside gait.band. Set a wider band or fewer law.spans.
design-many-spans = The automatic number of spans is { $spans }, because the force error has to reach { $error } RMS. Set gait.noise if the force is noisy, or a larger accuracy.rms or fewer law.spans.
design-thin-wall = The wall between the hole for the shaft and the base circle is { $wall }; a hub usually has { $usual }. Set a larger cam.base_radius or a smaller cam.bore.
design-large-roller = The roller has a radius of { $roller }, more than the cam that it rolls on, { $cam }. Check cam.roller_radius and its unit.
design-thin-shaft = The base circle has a diameter of { $circle }; a steel shaft that carries the torque of { $torque } needs { $shaft } (shear stress 40 MPa). Make the cam larger, or leave its size open and set cam.bore to the diameter of the shaft.
design-large-bore = The hole has a diameter of { $bore }; a steel shaft that carries the torque of { $torque } needs only { $shaft } (shear stress 40 MPa). Check cam.bore and its unit.
design-inertia-for-accuracy = Under its motor the force error over time is { $error } of the mean; { $allowed } is allowed. The smallest inertia that meets it is { $inertia } (machine.inertia); law.shaft = "motor" designs for the motor where the family of the law allows it.
design-no-base-circle = The smallest base radius is zero, so the profile passes through the shaft axis. Set cam.bore or cam.base_radius.
design-usual-pressure-angle = No limit on the pressure angle is given: the cam is sized for at most { $angle }, the usual value. Set limits.pressure_angle to change it.
design-polydyne = The cam is polydyne: at { $speed } the output end of a follower of stiffness { $stiffness } follows the law. Lift, velocity, acceleration, jerk and their limits are those of the cam; the force is that of the output end.
design-polydyne-miss = With its flexible follower this cam has a force error of { $own } RMS; a cam cut to the law itself would have { $plain } RMS.

# Faults in what a design is asked for.
synth-shaft-diverges = the law and the speed of the shaft do not converge: the ripple is { $ripple }
    .help = use a larger inertia (about "{ $inertia }" leaves a ripple of { $calm }), a steeper torque line, or law.shaft = "constant"
synth-adjusts-given = { $key } is given and is to be set anew for each walker
    .help = leave { $key } out, or leave it out of gait.adjust
synth-mass-not-adjustable = the mass of this drive carries no walker's weight
    .help = leave "mass" out of gait.adjust; a moving axis carries the weight
synth-speed-not-adjustable = the force of this drive at another speed is no multiple of that at one speed: spring, damping and inertia depend on it differently
    .help = leave "speed" out of gait.adjust and give drive.speed
synth-not-of-population = this setting is not available for several walkers
    .help = give one cycle, or leave the setting out; law.robust needs law.family = "spline", "harmonic" or none, and the force error as objective
synth-one-walker = one walker alone has no choice of cams
    .help = give a folder, a list or a table of several walkers
synth-force-not-read = the force curve was not read
synth-no-lift-changes-force = no lift changes the force: spring rate, damping and mass are all zero
    .help = give at least one of spring_rate, damping, mass
synth-value-missing = needs a value where no force is given
synth-mean-force-negative = the mean force is { $mean }, so no mass can rest on the cam
    .help = forces must press downwards: check the sign and the column
synth-not-scalable = a mean force of { $mean } cannot be scaled to { $weight }
synth-no-spread = the target is one cycle and has no spread
    .help = give a recording of several steps, or a width: band = "20 N"
synth-pair-incomplete = "{ $pair }" does not name two quantities
    .help = write force_error:prime_radius; in place of prime_radius also { $known }
synth-pair-without-force-error = one of the two must be force_error
    .help = write force_error:prime_radius; in place of prime_radius also { $known }
synth-pair-unknown = invalid value "{ $typed }"
    .help = write force_error:prime_radius; in place of prime_radius also { $known }
synth-no-target = no target force: the trade-off is not available
synth-only-splines = the trade-off is available for splines only
    .help = use law.family = "spline", or gaitcam sweep and gaitcam front
synth-size-fixed = the scene fixes the size of the cam
    .help = leave out base_radius and prime_radius
synth-no-law = { $reason }
synth-search-failed = the search failed: { $fault }
synth-too-many-harmonics = { $samples } samples hold no more than { $most } harmonics
synth-resonance = harmonic { $harmonic } of the force is at the resonance of the drive, where spring and inertia forces cancel
    .help = add damping, or change mass, spring rate or speed
synth-no-constant-breadth = the law does not keep a breadth: the lifts half a turn apart add to { $sum } at 0° but differ from that by { $miss } at { $at }
    .help = give the segments of the first 180° only; the other half then follows
synth-breadth-too-small = a breadth of { $breadth } is too small for a lift of { $lift }
    .help = the breadth is twice the base radius (roller: prime radius) plus the lift
synth-no-prime-circle = no prime circle is large enough for it
    .help = a discontinuous velocity gives the profile a corner, which no base radius removes
synth-follower-needs = this follower needs it
synth-no-range = { $start } to { $end } is not a valid range within one turn
    .help = angles run from 0 to 360 deg
synth-degree-too-low = { $conditions } conditions fix a polynomial of degree { $fixed }, not { $degree }
    .help = write degree = { $fixed }, or remove { $excess } of them
synth-degree-too-high = { $conditions } conditions fix a polynomial of degree { $fixed }, not { $degree }
    .help = write degree = { $fixed }, or add { $missing } conditions
synth-many-demands = points and dwells make { $given } conditions on one law; at most { $most } are solved
    .help = describe a measured curve as a force or a band, or leave out points
synth-law-open = the law ends { $rise } above its start and cannot close
    .help = give the last point the lift of the first
synth-force-gives-no-lift = this drive does not turn a force into a lift
    .help = give the lift, or use a hydraulic drive
synth-points-empty = the points give no condition
    .help = give lift, force, velocity, acceleration or jerk
synth-family-needs-force = this family follows a force, and none is given
    .help = add [gait], or use spline, polynomial or program
synth-no-double-harmonic = the search found no double harmonic law
synth-double-harmonic-useless = no double-harmonic law reproduces this force better than a constant force
    .help = use family = "spline"
synth-dwells-overlap = two dwells overlap
    .help = write them as one
synth-dwells-fill-turn = the dwells fill the whole turn
    .help = leave room for motion
synth-point-outside = { $at } lies outside the turn
    .help = angles run from 0 to 360 deg
