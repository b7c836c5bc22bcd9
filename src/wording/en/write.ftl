# Faults in writing the files of a design.
write-folder-refuses = { $fault ->
        [missing] the folder does not exist and cannot be created
        [denied] there is no permission to write here
        [read-only] the file system is read-only
        [full] there is no space left on the device
       *[other] cannot write into this folder ({ $fault })
    }
    .help = choose another folder with --out DIR
write-file-refuses = { $fault ->
        [missing] the folder does not exist and cannot be created
        [denied] there is no permission to write here
        [read-only] the file system is read-only
        [full] there is no space left on the device
       *[other] cannot be written ({ $fault })
    }
write-not-put-together = the file could not be created: { $fault }
write-plate-thickness = invalid plate thickness of { $thickness }
    .help = give a positive thickness
write-too-few-points = { $points } profile points are not sufficient for a plate
    .help = give at least { $least }
write-barrel-solid = a barrel cam has no STEP solid, only STL files of the groove walls
write-open-profile = the profile is open: it does not enclose a plate
    .help = use a disc cam with a closed law
write-undercut-profile = the profile is undercut and crosses itself
    .help = set a larger cam.base_radius or a smaller cam.roller_radius
write-profile-folds = a ray from the centre of rotation meets the profile more than once, so a plate about this centre is not possible
    .help = set a larger cam.base_radius
write-bore-too-large = a bore of { $bore } is not possible: the minimum distance of the profile from the centre is { $free }
    .help = give a positive bore smaller than twice that distance
write-cutter-radius = invalid cutter radius { $radius }
    .help = give a positive tool radius
write-depth-of-pass = invalid depth of pass { $pass }
    .help = give a depth of { $least } or more (a thousandth of the thickness)
write-no-cutter-path = a cutter path requires the groove of a barrel cam, or a smooth outer profile with concave parts that the cutter fits
write-groove-cutter = the groove is exact only if the cutter has the radius of the roller, { $roller }, not { $radius }
    .help = set --tool to the radius of the roller
write-wire-too-thick = the wire with its spark gap has a radius of { $radius } and does not fit the keyway
write-too-sharp = the profile is too sharp for a smooth spline
    .help = set limits.curvature so that the profile has no cusp
write-ecam-intervals = this controller does not accept { $asked } points
    .help = give { $least } to { $most }, or omit --points
write-ecam-points = with { $points } points the RMS force error of { $dialect } is { $error } of the mean force (maximum { $allowed })
    .help = give --points { $better } ({ $to }), or omit --points
write-ecam-law = the RMS force error of { $dialect } is at least { $error } of the mean force, with { $points } points (maximum { $allowed })
    .help = choose codesys, twincat or segments, or a law with continuous acceleration
write-ecam-of-motor = the law is designed for a shaft of varying speed, but the master of an electronic cam turns at constant speed
    .help = set law.shaft = "constant"
write-ecam-name = { $name } is not a name that a controller accepts
    .help = use letters, digits and single underscores, at most { $longest } characters, beginning with a letter, for example --name heel
