# Reasons for the verdict on a design.
reason-all-hold = Every limit holds, and lift, velocity and acceleration are continuous all around.
reason-lift-jumps = The lift jumps at { $at }: no follower can be in two places at once.
reason-velocity-jumps = The velocity jumps at { $at }: the follower would be struck, with an infinite acceleration.
reason-acceleration-jumps = Every limit holds, but the acceleration jumps at { $at }: the force jumps with it and excites vibration at high speed.
reason-lifts-off = Every limit holds, but at { $at } the cam would have to pull with { $pull }: above { $speed } the follower lifts off. limits.force_min = "0 N" keeps it in contact.
reason-cusp = Every limit holds, but the profile has a cusp at { $at }, an edge that wears at once: limits.curvature asks for a radius.
reason-undercut = The profile is undercut at { $at }: its convex radius would be { $radius }.
reason-too-sharp = The radius of curvature at { $at } is { $radius }, less than the { $allowed } allowed.
reason-second-too-sharp = The radius of curvature of the second cam at { $at } is { $radius }, less than the { $allowed } allowed. Move its follower farther out.
reason-base-radius-works = A base radius of { $radius } is the smallest that works here.
reason-enlarge-base-circle = Enlarge the base circle, or use a smaller roller.
reason-lengthen-travel = Lengthen the travel, or use a smaller roller.
reason-interference = At { $at } the follower interferes with another part of the cam by { $depth }. Use a smaller roller, or enlarge the base circle.
reason-sharp-wall = The radius of curvature of a wall of the groove at { $at } is { $radius }, less than the { $allowed } allowed. Use a smaller roller, or a larger barrel.
reason-roller-too-large = The roller of { $roller } does not fit the concave radius of { $hollow } at { $at }. Use a smaller roller.
reason-pressure-angle = The pressure angle reaches { $angle } at { $at }, more than the { $allowed } allowed: the follower may jam in its guide. Enlarge the prime circle.
reason-force-error = The force differs from the target by { $error } RMS, more than the { $allowed } asked for. Relax the limits that are active, or allow more spans.
reason-below-base-circle = The law goes { $depth } below its base circle at { $at }.
reason-prime-radius = The cam needs a prime radius of { $needed }, more than the { $allowed } allowed. Allow a larger pressure angle or more force error.
reason-outside-band = The force leaves the band by { $excess } at { $at }. Widen the band, or allow more spans.
reason-limit-broken = The limit "{ $limit }" is broken at { $at }: { $value } against { $allowed }.

# What is said of problem and design beside the verdict.
design-said = { $text }
design-stretched = One turn takes { $turn }, the force cycle { $cycle }: the curve is stretched to the turn.
design-mean-force = The mean of the wanted force is { $mean }, but the mass weighs { $weight }. Over a turn a cam cannot change the mean, so the error stays at { $error } at least. Set drive.mass = "auto" or gait.scale = "to-mass".
design-free-fall = For { $share } of the turn ({ $duration }) the wanted force is near zero: the mass must fall freely there, which alone needs about { $lift } of lift. Both feet together (feet = "both") never leave the ground.
design-largest-stroke = The wanted force accelerates the mass by up to { $acceleration }, so the stroke is at most { $stroke } (16 h/T² ≤ max|a|){ $idle ->
        [true] ; the stroke limit cannot be active
       *[other] {""}
    }.
design-phase = The cam's turn begins at { $phase } of the force cycle: the phase with the least error.
design-noise = The { $size } stop at an error of { $error } RMS, a fifth of the walker's step-to-step spread: more would follow its noise. accuracy.rms asks for another.
design-no-base-circle = The smallest base circle has no radius, so the profile passes through the shaft's axis: cam.bore or cam.base_radius gives it room.
design-usual-pressure-angle = Nothing limits the pressure angle, so the size keeps it to { $angle }, the usual rule: limits.pressure_angle sets another.
design-polydyne = The cam is polydyne: at { $speed } the end of a follower of stiffness { $stiffness } moves as the law asks. Lift, velocity, acceleration, jerk and the limits on them are the cam's; the force is the end's.
design-polydyne-miss = Run with its flexible follower, this cam misses that force by { $own } RMS; one cut to the law itself would miss it by { $plain }.
design-polydyne-degree = A higher law.degree takes in more of the follower's damping.
