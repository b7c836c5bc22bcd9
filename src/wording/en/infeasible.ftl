# Why no cam keeps all limits, and the smallest changes that would do.
reason-demands-contradict = The demands contradict each other: { $demands } cannot hold beside the others.
reason-demands-infeasible = No law on or above the base circle meets these demands together: { $demands }.
reason-limit-infeasible = No law that meets the demands keeps the { $limit } limit.
reason-limits-infeasible = No law keeps these limits together: { $limits }.
reason-solver-stopped = The solver stopped without an answer ({ $stop }), which does not prove that no law exists.
reason-relaxation = Smallest relaxation: { $changes }.
reason-relaxations = Smallest relaxation, any one of: { $changes }.
reason-no-relaxation = No single one of them can be relaxed far enough.
reason-all-together = No single one of them can be relaxed far enough; all of them together by { $share }.
reason-change = { $limit } { $to } instead of { $from }
