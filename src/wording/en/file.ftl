# Faults in reading scenes and recordings and in putting results into folders.
file-cannot-read = { $fault ->
        [missing] there is no such file or folder
        [denied] may not be read by this user
       *[other] cannot be read ({ $fault })
    }
    .help = check the path
file-missing = there is no file "{ $file }"
file-cannot-place = the files cannot be moved into place ({ $fault })
file-foreign = is not a file of gaitcam, but has the name of one
    .help = remove it, or choose another folder
file-held = another gaitcam{ $process ->
        [none] {""}
       *[other] {" "}(process { $process })
    } is writing here
    .help = wait for it, end it, or choose another --out
file-folder = is a folder
    .help = give a file
file-device = is a pipe or a device, not a file
    .help = give a file, or - for standard input
file-too-large = is larger than { $mib } MiB
file-not-utf8 = is not UTF-8 text
    .help = a scene is a TOML file, `gaitcam scenes footbridge` prints one
file-not-toml = { $fault }
    .help = a scene is a TOML file, `gaitcam scenes footbridge` prints one
file-not-json = is not JSON ({ $fault })
file-measured-columns = no columns of measured points among: { $found }
    .help = name them x_mm,y_mm or angle_deg,radius_mm (or m, in, rad)
file-measured-field = "{ $typed }" is not a finite number
    .help = each line needs two numbers with a decimal point
file-not-csv = is not a CSV table ({ $fault })
file-no-scene-in-summary = holds no scene
    .help = give a summary.json of gaitcam, or a scene file
file-replaced = { $file } would be replaced
    .help = an input file is never overwritten; choose another folder
file-another-sweep = is another sweep: { $differences }
    .help = repeat the sweep as it was, or choose another place
file-not-sweep-folder = holds { $file }, which is not a block of a sweep
    .help = give an empty folder, or the one of this sweep
file-no-table = no table of numbers found
    .help = the file starts with "{ $start }"; { $purpose ->
        [motor] the torque curve of a motor has the header speed_rad_per_s,torque_n_m
       *[table] a motion has a header such as angle_deg,lift_mm
    } and under it rows of numbers
file-motor-column = the torque curve has no column { $column } (columns: { $columns })
    .help = its header is speed_rad_per_s,torque_n_m
file-motion-column = there is no column { $column } (columns: { $columns })
    .help = name it with its unit in the header, for example { $example }
file-motion-unit = column { $column }: its unit is missing or of another kind
    .help = name it with its unit in the header, for example { $example }
file-motion-value = column { $column }: "{ $typed }" is not a number
    .help = every row needs a finite number
file-motion-order = column { $column }: { $x } after { $before }
    .help = it must increase from row to row
file-motion-many-rows = more than { $most } rows
    .help = give every second row or fewer
file-motion-differs = column { $column } covers { $covered }, but { $key } is { $typed }
    .help = correct one of them, or leave { $key } out: it is then taken from the file
file-walkers = { $count ->
        [one] 1 cycle
       *[other] { $count } cycles
    } cannot be taken into the population.{ $unreadable ->
        [none] {""}
       *[other] {" "}No cycle in { $unreadable }.
    }{ $weight ->
        [none] {""}
       *[other] {" "}The mean force is not the weight: { $weight }.
    }{ $unit ->
        [none] {""}
       *[other] {" "}Another unit of force: { $unit }.
    }{ $feet ->
        [none] {""}
       *[other] {" "}One foot among both, or the reverse: { $feet }.
    }{ $cycle ->
        [none] {""}
       *[other] {" "}One step among strides, or the reverse: { $cycle }.
    }{ $kind ->
        [none] {""}
       *[other] {" "}Another kind of movement: { $kind }.
    }
    .help = correct them, or leave them out by name, a row of a table also by its line: gait.leave_out = ["NAME", "FILE:LINE", …]
