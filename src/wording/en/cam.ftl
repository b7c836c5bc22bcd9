# Faults in the lengths of a cam and its follower.
cam-not-positive = invalid { $length ->
        [roller-radius] roller radius
        [arc-radius] arc radius
        [pivot-distance] pivot distance
        [arm] arm length
        [base-height] base height
        [barrel-radius] barrel radius
       *[prime-radius] prime radius
    } of { $value }
    .help = { $length ->
        [roller-radius] it must be 0 (a knife edge) or more
       *[other] it must be more than 0
    }
cam-not-finite = the { $length ->
        [face-offset] face offset
       *[offset] offset
    } is not a finite number
cam-roller-fills-cam = the roller or arc radius of { $radius } is not smaller than the prime radius of { $prime }
    .help = the prime radius is the sum of base radius and roller radius; it must exceed the roller radius
cam-offset = the offset of { $offset } is not smaller than the prime radius of { $prime }
    .help = the follower cannot touch the prime circle: keep the offset below { $prime } or increase the prime radius
cam-below-centre = the law falls to { $lift }, below the cam centre, which is { $height } below the follower's start position
    .help = the prime radius must exceed { $least }
cam-face-reach = a flat face of offset { $offset } cannot touch a base circle of radius { $base } with its pivot at { $pivot }
    .help = the pivot distance must exceed { $least }
cam-arm-reach = the arm of { $arm } { $fault ->
        [short] is too short to reach
        [long] is too long to touch
       *[apart] cannot touch
    } the prime circle of radius { $prime } from a pivot at { $pivot }
    .help = the length of the arm must lie between { $least } and { $most }
cam-swing = the arm swings from { $from } to { $to }, beyond its dead centres at { $dead }
    .help = from its start at { $start }, the arm must rise by less than { $rise } and fall by less than { $fall }
cam-face-speed = at { $at } the angular velocity of the arm is { $speed } rad/rad, not less than that of the cam
    .help = a flat face has no contact point there: spread this motion over a larger cam angle
cam-pivot-inside = the pivot at { $pivot } lies inside the cam, whose profile radius is { $reach } at { $at }
    .help = use a pivot distance above { $reach }
cam-arms-by-distance = conjugate oscillating followers are not defined by a distance
    .help = give the angle between the arms or the second base radius
cam-slides-by-angle = conjugate translating followers are not defined by an angle
    .help = give the distance between faces or roller centres, or the second base radius
cam-no-conjugate-of = a conjugate cam for this follower ({ $follower }) does not exist
    .help = the groove already guides this follower on both sides
cam-second-cam = the conjugate cam does not exist: { $because }
cam-no-conjugate = no conjugate cam exists for a distance or angle of { $total } between both followers: the first follower alone reaches { $reach }
    .help = { $least ->
        [none] the distance or angle must be much larger than { $reach }
       *[other] use at least { $least } (second base radius { $base }) to avoid undercut of the conjugate cam
    }
cam-translating-height = the base height of a translating cam affects neither curvature nor pressure angle
    .help = increase the length of travel (cam.travel) or use a smaller roller (cam.roller_radius)
cam-no-size = no base radius satisfies the limits with this follower ({ $follower })
    .help = allow a larger pressure angle or a smaller radius of curvature, spread the motion over a larger angle, or increase the pivot distance
cam-groove-depth = a groove with floor radius { $floor } and surface radius { $surface } has no depth
    .help = the floor radius must be more than 0 and less than the surface radius
cam-groove-rollers = rollers of radius { $radius } with eccentricity { $eccentricity } do not fit a groove
    .help = the radius must be more than 0 and the eccentricity not negative
cam-groove-floor = the roller radius of { $radius } is not smaller than the floor radius of the groove, { $floor }
    .help = use a smaller roller or a larger floor radius
cam-measured-few = { $points } measured points are not sufficient
    .help = measure at least { $least }, spread over the whole profile, preferably 360 or more
cam-measured-not-finite = measured point { $row } is not finite
    .help = leave it out or measure it again
cam-measured-unrolled = only the profile of a rotating cam can be fitted, not that of this follower ({ $follower })
cam-measured-circle = the profile is a circle within the scatter of the measured points, so they do not determine its zero angle
    .help = measure the bore and the keyway, which fix centre and angle
cam-measured-mirror = the points belong to the mirror image of this cam: their RMS distance from the profile is { $distance }, and { $mirrored } after mirroring
    .help = the cam was measured from its other side: change the sign of x
cam-measured-other = the points do not belong to this cam: their RMS distance from its profile (radii of { $low } to { $high }) is { $distance } after the best fit
    .help = check the units of the columns, the radius of the probing ball (--ball) and which cam was measured
