# Why no cam satisfies all limits, and the smallest changes that suffice.
reason-demands-contradict = Contradictory conditions: { $demands }.
reason-demands-infeasible = No law on or above the base circle satisfies these conditions together: { $demands }.
reason-limit-infeasible = No law that satisfies the conditions satisfies the limit { $limit }.
reason-nothing-presses = No force presses the follower on the cam, so limits.force_min cannot be satisfied. Set drive.spring_rate, drive.preload or, on a moving axis, drive.mass.
reason-limits-infeasible = Conflicting limits: { $limits }. No law satisfies them together.
reason-no-law-found = No law was found that satisfies the conditions and these limits: { $limits }. This does not prove that none exists, because not all limits are convex.
reason-solver-stopped = The solver stopped without a result ({ $stop }); this does not prove that no law exists.
reason-relaxation = Smallest sufficient change: { $changes }.
reason-relaxations = Smallest sufficient changes (each is sufficient alone): { $changes }.
reason-no-relaxation = Relaxing a single one of these limits is not sufficient.
reason-all-together = Relaxing a single one of these limits is not sufficient. Together, these changes are sufficient: { $changes }.
reason-far-relaxations = A change of one value is sufficient only if it is large: { $changes }.
reason-far-together = No small change is sufficient. Together, these changes are sufficient: { $changes }.
reason-out-of-reach = No small change is sufficient. Each of these limits is infeasible even without the others and would have to change: { $changes }. These changes together are still not sufficient.
reason-not-the-limits = No change of limits or sizes is sufficient: the design is infeasible even without them. Change the speed, mass, spring, preload or the conditions on the law.
reason-change = { $key } { $to } instead of { $from }

# Demands on the law in a conflict.
demand-at-point = { $given } at point { $point } ({ $at })
demand-in-dwell = dwell { $dwell }
demand-on-base-circle = contact with the base circle
