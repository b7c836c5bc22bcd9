# Faults in the lengths of a cam and its follower.
cam-not-positive = the { $length ->
        [roller-radius] roller radius
        [arc-radius] arc radius
        [pivot-distance] pivot distance
        [arm] length of the arm
        [base-height] base height
        [barrel-radius] radius of the barrel
       *[prime-radius] prime radius
    } is { $value }
    .help = { $length ->
        [roller-radius] it must be more than 0 (0: a knife edge)
       *[other] it must be more than 0
    }
cam-not-finite = the { $length ->
        [face-offset] face offset
       *[offset] offset
    } is not a finite number
cam-roller-fills-cam = the roller (or arc) of { $radius } leaves nothing of a prime circle of { $prime }
    .help = the prime radius is the base radius plus that of the roller; it must exceed the roller's
cam-offset = the offset of { $offset } is not smaller than the prime radius of { $prime }
    .help = the follower would miss the prime circle: keep the offset below { $prime } or raise the prime radius
cam-below-centre = the law falls to { $lift }, below the cam's centre, which lies { $height } under the follower's start
    .help = the prime radius must exceed { $least }
cam-face-reach = a face of offset { $offset } cannot lie on a base circle of { $base } with its pivot at { $pivot }
    .help = the pivot distance must exceed { $least }
cam-arm-reach = the arm of { $arm } { $fault ->
        [too-short] is too short to reach
        [too-long] is too long to touch
       *[apart] cannot lie on
    } the prime circle of { $prime } from a pivot at { $pivot }
    .help = its length must lie between { $least } and { $most }
cam-swing = the arm swings from { $from } to { $to }, beyond its dead centres at { $dead }
    .help = from its start at { $start } it may rise by less than { $rise } and fall by less than { $fall }
cam-face-speed = at { $at } the arm swings with the cam at { $speed } rad/rad, as fast as the cam turns or faster
    .help = a flat face then has no contact point: spread this motion over a larger angle
cam-pivot-inside = the pivot at { $pivot } lies inside the cam, whose profile reaches { $reach } at { $at }
    .help = put the pivot farther out than { $reach }
cam-arms-by-distance = conjugate arms are not closed by a distance
    .help = give the angle between the arms or the second base radius
cam-slides-by-angle = translating conjugate followers are not closed by an angle
    .help = give the distance between faces or roller centres, or the second base radius
cam-no-conjugate-of = a { $follower } has no conjugate cam
    .help = its groove holds the follower from both sides already
cam-second-cam = the conjugate cam does not exist: { $because }
cam-no-conjugate = no conjugate cam fits { $total }: the first follower alone reaches { $reach }
    .help = { $least ->
        [none] it must exceed { $reach } by far
       *[other] from { $least } on (second base radius { $base }) one exists without undercut
    }
cam-translating-height = the height of a translating cam changes neither curvature nor pressure angle
    .help = lengthen its travel or use a smaller roller
cam-no-size = no base radius lets this { $follower } cam meet its limits
    .help = allow a larger pressure angle or a smaller radius, spread the motion over more angle, or move the pivot out
cam-groove-depth = a groove from radius { $floor } to { $surface } has no depth
    .help = the floor's radius must be more than 0 and less than the surface's
cam-groove-rollers = rollers of radius { $radius } set off by { $eccentricity } do not fit a groove
    .help = the radius must be more than 0, the eccentricity not negative
cam-groove-floor = rollers of radius { $radius } are as thick as the groove's floor of radius { $floor }
    .help = the roller must be thinner than the radius of the floor
