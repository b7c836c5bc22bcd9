# Faults in motions, programmes and polynomials of boundary conditions.
law-segment = segment { $number } ({ $motion })
law-no-segment = a programme needs at least one segment
    .help = give [[law.segment]] with motion, lift and angle
law-extent = a programme cannot have an extent of { $length }
    .help = give a number of turns or a length of travel above 0
law-segment-not-finite = lift and length of { $segment } must be finite numbers
    .help = give both as finite numbers
law-segment-length = the length of { $segment } is { $length }, but it must be positive
    .help = give a length above 0, or remove the segment
law-dwell-lift = { $segment } has a lift of { $lift }
    .help = the lift of a dwell is constant: choose a motion or set the lift to 0
law-uncovered = the segments cover { $covered } of { $wanted }: { $missing } are missing
    .help = add a dwell, or change the angle or length of a segment
law-overfull = the segments cover { $covered }, which is { $excess } more than { $wanted }
    .help = change the angle or length of a segment
law-general-neighbours = the general polynomials { $first } and { $second } are adjacent, so their end conditions are not determined
    .help = change the motion of one segment, or merge the two segments
law-lift-jump = { $before } cannot join { $after } at { $at }: the lift changes by { $jump } there
    .help = the lifts of all segments must add to 0
law-velocity-jump = { $before } cannot join { $after } at { $at }: the velocity jumps by { $jump } (from { $from } to { $to })
    .help = { $cure }
law-let-cover = set the extent of { $segment } to { $length }, or insert a polynomial-5 between the two segments
law-put-between = { $segment } is not at rest there, so insert a half motion (semicycloidal) or a polynomial-5 between the two segments
law-below-base-circle = { $segment } falls { $depth } below the base circle, at { $at }
    .help = start the programme at the lowest position of the follower, or increase the lift before this segment
law-table-below-base-circle = { $segment } falls { $depth } below the base circle between rows { $first } and { $second } of its table, at { $at }; at most half a unit of the last decimal is allowed
    .help = add rows between these two, or correct them
law-breadth-angle = the segments of a constant-breadth cam cover { $covered } instead of half a turn
    .help = the segments must add to 180°; the other half follows from the breadth
law-breadth-polynomial = segment { $segment } of the half turn is a general polynomial whose neighbour is not yet determined
    .help = use 3-4-5 or 4-5-6-7
law-breadth-lift = the half turn of a constant-breadth cam must go from 0 to its maximum lift, but it ends at { $lift } and ranges from { $low } to { $high }
    .help = keep the lift between 0 and the lift at 180°
law-no-condition = a polynomial needs at least one condition
    .help = give [[law.point]] with angle and lift
law-interval = invalid interval of a polynomial: { $start } to { $end } rad
    .help = the start must be below the end
law-many-conditions = { $conditions } conditions require a polynomial of degree { $degree }
    .help = at most { $most } can be solved accurately; use a spline for more points
law-condition-not-finite = condition { $condition } is not a finite number
    .help = give its angle and value as finite numbers
law-condition-outside = condition { $condition } is at { $at }, outside { $start } … { $end }
    .help = move the condition into the interval
law-condition-order = condition { $condition } prescribes derivative { $order }, which is too high for a polynomial of degree { $degree }
    .help = give more conditions of lower order
law-condition-twice = conditions { $first } and { $second } both prescribe derivative { $order } at { $at }
    .help = remove one of them
law-not-fixed = these { $conditions } conditions do not determine a polynomial of degree { $degree }
    .help = give at least one lift, and at each point give lower derivatives before higher ones
law-parameter = `{ $word }` after `{ $motion }` is not a number
    .help = write parameters as in `scca 0.25 0.25 0.5`
law-parameters = `{ $motion }` does not take { $given } parameters
    .help = only scca (b, c, d) and eccentric (ratio) have parameters
law-unknown-motion = unknown motion `{ $motion }`
    .help = { $nearest ->
        [none] the catalogue contains { $catalogue }
       *[other] did you mean `{ $nearest }`?
    }
law-motion-type = `{ $motion }` is a type of motion of VDI 2143, not a law
    .help = { $laws ->
        [none] no law of the catalogue has these ends; use polynomial-5 or polynomial-7, which join any neighbours
       *[other] laws with these ends: { $laws }
    }
law-motion-needs-points = the motion `{ $motion }` needs points
    .help = write pairs of angle and lift as fractions of the segment, motion = "table 0 0 0.5 0.3 1 1", or name a CSV file, motion = "table lift.csv"
law-motion-file = the motion `{ $motion }` names the file { $file }, which cannot be read here
    .help = name files only in the scene file or after --set; for a sweep, write the rows themselves: motion = "table 0 0 0.5 0.3 1 1"
law-general-degree = the conditions of a general polynomial of degree { $degree } cannot be divided equally between both ends
    .help = use degree 5 (joins s, v, a) or 7 (also j)
law-scca-shares = the shares b = { $b }, c = { $c }, d = { $d } of an SCCA law do not add to 1
    .help = b, c and d must be 0 or more and add to 1, for example 0.25, 0.25, 0.5
law-eccentric-ratio = an eccentric of ratio { $ratio } does not enclose its shaft
    .help = the ratio (disc radius + roller radius)/eccentricity must be more than 1, for example 3
law-table-pairs = the { $numbers } numbers of a table do not form pairs
    .help = alternate x and s, for example motion = "table 0 0 0.5 0.3 1 1"
law-table-rows = { $table }: { $rows } rows are not sufficient
    .help = give at least two rows of x and s
law-table-not-finite = { $table }: row { $row } is not a finite number
    .help = give x and s as finite numbers
law-table-order = { $table }: row { $row } has x = { $x } after { $before }
    .help = x must increase from row to row
law-table-level = { $table }: the last lift equals the first
    .help = a motion leads from one lift to a different one: split the table at its maximum lift
law-table-spacing = { $table }: the spacing of its rows is too uneven for a spline
    .help = space the rows more evenly

# Possible neighbours of the end of a law.
joins-dwell = dwell
joins-return-of-equal-acceleration = return of equal acceleration
joins-constant-velocity = constant velocity
joins-nothing-but-a-general-polynomial = only a general polynomial
