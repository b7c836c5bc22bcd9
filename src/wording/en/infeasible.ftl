# Why no cam satisfies all limits, and the smallest changes that suffice.
reason-demands-contradict = Contradictory conditions: { $demands }.
reason-demands-infeasible = No law on or above the base circle satisfies these conditions together: { $demands }.
reason-limit-infeasible = No law that satisfies the conditions satisfies the limit { $limit }.
reason-nothing-presses = Nothing presses the follower on the cam, so limits.force_min is out of reach: give a spring, a preload or, on a moving axis, a mass.
reason-limits-infeasible = Conflicting limits: { $limits }. No law satisfies them together.
reason-no-law-found = No law was found that satisfies the conditions and these limits: { $limits }. This does not prove that none exists, because not all limits are convex.
reason-solver-stopped = The solver stopped without a result ({ $stop }); this does not prove that no law exists.
reason-relaxation = Smallest sufficient change: { $changes }.
reason-relaxations = Smallest sufficient changes, any one of them: { $changes }.
reason-no-relaxation = Relaxing a single one of these limits is not sufficient.
reason-all-together = Relaxing a single one of these limits is not sufficient; these changes together are: { $changes }.
reason-far-relaxations = Only a large change of one value is sufficient: { $changes }.
reason-far-together = No small change is sufficient; these together are: { $changes }.
reason-out-of-reach = No small change is sufficient. Even alone, out of reach of any law: { $changes }. The other limits do not hold beside these values either.
reason-not-the-limits = No change of limits or sizes is sufficient: the design fails without them too. Speed, mass, spring, preload or the conditions on the law have to change.
reason-change = { $key } { $to } instead of { $from }

# Demands on the law in a conflict.
demand-at-point = { $given } at point { $point } ({ $at })
demand-in-dwell = dwell { $dwell }
demand-on-base-circle = contact with the base circle
