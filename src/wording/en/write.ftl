# Faults in handing a design over.
write-folder-refuses = { $fault ->
        [missing] there is no such folder, and it cannot be made
        [denied] this user may not write here
        [read-only] the file system is read-only
        [full] no space is left on the device
       *[other] cannot write into this folder ({ $fault })
    }
    .help = choose another with --out DIR
write-file-refuses = { $fault ->
        [missing] there is no such folder, and it cannot be made
        [denied] this user may not write here
        [read-only] the file system is read-only
        [full] no space is left on the device
       *[other] cannot be written ({ $fault })
    }
write-not-put-together = the file could not be put together: { $fault }
write-plate-thickness = invalid plate thickness of { $thickness }
    .help = give a positive thickness
write-too-few-points = { $points } profile points are too few for a plate
    .help = give at least { $least }
write-barrel-solid = a barrel has no STEP solid, only the walls of its groove as STL
write-open-profile = the profile is open: it does not enclose a plate
    .help = only a disc cam whose law closes makes a plate
write-undercut-profile = the profile is undercut: it crosses itself
    .help = enlarge the base circle or reduce the roller
write-profile-folds = a ray from the centre of rotation meets the profile more than once: no plate about that centre
    .help = enlarge the base circle
write-bore-too-large = a bore of { $bore } does not fit: the profile comes within { $free } of the centre
    .help = give a positive bore smaller than twice that distance
write-cutter-radius = invalid cutter radius { $radius }
    .help = give a positive tool radius
write-depth-of-pass = invalid depth of a pass { $pass }
    .help = give a depth of { $least } or more: a thousandth of the thickness
write-no-cutter-path = a cutter path exists only for the outside of a smooth cam, with a cutter that fits its hollows, and for the groove of a cylindrical cam
write-groove-cutter = the groove is exact only with a cutter of the roller's radius, { $roller }, not { $radius }
    .help = give that radius to --tool
write-wire-too-thick = the wire with its gap, { $radius }, does not fit the keyway
write-too-sharp = the profile is too sharp for a smooth spline
    .help = set limits.curvature so that the profile has no cusp
write-ecam-intervals = { $asked } points are too few or too many for this controller
    .help = give { $least } to { $most }, or leave --points out
write-ecam-points = with { $points } points the force error of { $dialect } is { $error } of the mean RMS (maximum { $allowed })
    .help = give --points { $better } ({ $to }), or leave it out
write-ecam-law = the smallest force error of { $dialect } is { $error } of the mean RMS, with { $points } points (maximum { $allowed })
    .help = choose codesys, twincat or segments, or a law whose acceleration does not jump
write-ecam-of-motor = the law is designed for a shaft of varying speed; the master of an electronic cam turns at constant speed
    .help = set law.shaft = "constant"
