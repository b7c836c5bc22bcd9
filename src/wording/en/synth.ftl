# Reasons for the verdict on a design.
reason-all-hold = All limits are satisfied; lift, velocity and acceleration are continuous over the whole cycle.
reason-mean-force = The mean target force is { $mean }, but the weight of the mass is { $weight }. A cam cannot change the mean force over a turn, so the force error is at least { $error } RMS. Set drive.mass = "auto" or gait.scale = "to-mass".
reason-lift-jumps = The lift is discontinuous at { $at }: no follower can execute it.
reason-velocity-jumps = The velocity is discontinuous at { $at }: infinite acceleration and impact on the follower.
reason-acceleration-jumps = The acceleration is discontinuous at { $at }: infinite jerk, and vibration at high speed.
reason-lifts-off = The contact force becomes negative at { $at } (by { $pull }): above { $speed } the follower loses contact. Set limits.force_min = "0 N" to keep it in contact.
reason-contact-lost = The contact force becomes negative at { $at } (by { $pull }): the follower loses contact. Use a stiffer spring, a larger preload, or a lower speed.
reason-contact-lost-in-run = Run on its machine, the follower is out of contact with the cam for { $share } of the motion. Use a stiffer spring, a larger preload, or a lower speed.
reason-cusp = The profile has a cusp at { $at } (zero radius of curvature). Set limits.curvature.
reason-undercut = The profile is undercut at { $at }: its convex radius of curvature would be { $radius }.
reason-too-sharp = The radius of curvature at { $at } is { $radius }; the minimum is { $allowed }.
reason-second-too-sharp = The radius of curvature of the second cam at { $at } is { $radius }; the minimum is { $allowed }. Place its follower farther from the shaft.
reason-base-radius-works = The smallest feasible base radius is { $radius }.
reason-enlarge-base-circle = Enlarge the base circle, or use a smaller roller.
reason-lengthen-travel = Increase the length of travel, or use a smaller roller.
reason-interference = At { $at } the follower interferes with another part of the cam by { $depth }. Use a smaller roller, or enlarge the base circle.
reason-sharp-wall = The radius of curvature of a groove wall at { $at } is { $radius }; the minimum is { $allowed }. Use a smaller roller, or a larger barrel.
reason-roller-too-large = The roller does not fit the concave profile at { $at }: the roller radius is { $roller }, the radius of curvature { $hollow }. Use a smaller roller.
reason-pressure-angle = The pressure angle reaches { $angle } at { $at }; the maximum is { $allowed }. The follower may jam in its guide. Enlarge the prime circle.
reason-large-pressure-angle = The pressure angle reaches { $angle } at { $at }; more than { $usual } is for low speed only. Enlarge the prime circle, or set limits.pressure_angle.
reason-force-error = The force error is { $error } RMS; the maximum is { $allowed }. Relax the active limits, allow more spans, or set accuracy.rms to the error that is acceptable.
reason-below-base-circle = The law falls { $depth } below the base circle at { $at }.
reason-prime-radius = The cam needs a prime radius of { $needed }; the maximum is { $allowed }. Allow a larger pressure angle or a larger force error.
reason-outside-band = The force is outside its band by { $excess } at { $at }. Widen the band, or allow more spans.
reason-limit-broken = The limit { $limit } is violated at { $at }: the value is { $value }, the limit { $allowed }.

# Notes on problem and design beside the verdict.
design-said = { $text }
design-stretched = One turn takes { $turn } and the force cycle { $cycle }: the force curve is stretched to the turn.
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
design-no-base-circle = The smallest base radius is zero, so the profile passes through the shaft axis. Set cam.bore or cam.base_radius.
design-usual-pressure-angle = No limit on the pressure angle is given: the cam is sized for at most { $angle }, the usual value. Set limits.pressure_angle to change it.
design-polydyne = The cam is polydyne: at { $speed } the output end of a follower of stiffness { $stiffness } follows the law. Lift, velocity, acceleration, jerk and their limits are those of the cam; the force is that of the output end.
design-polydyne-miss = With its flexible follower this cam has a force error of { $own } RMS; a cam cut to the law itself would have { $plain } RMS.
design-polydyne-degree = A higher law.degree compensates more of the follower's damping.
