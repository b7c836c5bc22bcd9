# Faults in reading scenes and recordings and in putting results into folders.
file-cannot-read = { $fault ->
        [missing] the file or folder does not exist
        [denied] there is no permission to read
       *[other] cannot be read ({ $fault })
    }
    .help = check the path
file-missing = the file "{ $file }" does not exist
file-cannot-place = the files cannot be moved into place ({ $fault })
file-foreign = this file has the name of a gaitcam file, but gaitcam did not write it
    .help = remove it, or choose another folder
file-held = another gaitcam process{ $process ->
        [none] {""}
       *[other] {" "}({ $process })
    } is writing to this folder
    .help = wait until it ends, stop it, or choose another --out
file-folder = this is a folder, not a file
    .help = give a file
file-device = this is a pipe or a device, not a file
    .help = give a file, or - for standard input
file-too-large = the file is larger than { $mib } MiB
file-not-utf8 = the file is not UTF-8 text
    .help = a scene is a TOML file; `gaitcam scenes footbridge` prints an example
file-not-toml = { $fault }
    .help = a scene is a TOML file; `gaitcam scenes footbridge` prints an example
file-not-json = the file is not JSON ({ $fault })
file-measured-columns = there are no columns of measured points; the columns are { $found }
    .help = name them x_mm,y_mm or angle_deg,radius_mm (or m, in, rad)
file-measured-field = "{ $typed }" is not a finite number
    .help = each line requires two numbers with a decimal point
file-not-csv = the file is not a CSV table ({ $fault })
file-no-scene-in-summary = the file contains no scene
    .help = give a summary.json of gaitcam, or a scene file
file-replaced = the input file { $file } would be replaced
    .help = input files are never overwritten; choose another folder
file-another-sweep = the folder contains a different sweep: { $differences }
    .help = repeat the sweep unchanged, or choose another folder
file-not-sweep-folder = the folder contains { $file }, which is not a block of a sweep
    .help = give an empty folder or the folder of this sweep
file-no-table = the file contains no table of numbers
    .help = the file starts with "{ $start }"; { $purpose ->
        [motor] the torque curve of a motor has the header speed_rad_per_s,torque_n_m
       *[table] a motion has a header such as angle_deg,lift_mm
    }, followed by rows of numbers
file-motor-column = the torque curve has no column { $column } (columns: { $columns })
    .help = its header is speed_rad_per_s,torque_n_m
file-motion-column = the column { $column } does not exist (columns: { $columns })
    .help = name it with its unit in the header, for example { $example }
file-motion-unit = column { $column }: the unit is missing or has a wrong dimension
    .help = name it with its unit in the header, for example { $example }
file-motion-value = column { $column }: "{ $typed }" is not a number
    .help = every row requires a finite number
file-motion-order = column { $column } does not increase: { $x } after { $before }
    .help = it must increase from row to row
file-motion-many-rows = the file has more than { $most } rows
    .help = reduce the number of rows, for example to every second row
file-motion-differs = column { $column } covers { $covered }, but { $key } is { $typed }
    .help = correct one of them, or omit { $key } to use the value of the file
file-walkers = { $count ->
        [one] 1 cycle
       *[other] { $count } cycles
    } cannot be used in the population.{ $unreadable ->
        [none] {""}
       *[other] {" "}Files without a cycle: { $unreadable }.
    }{ $weight ->
        [none] {""}
       *[other] {" "}Mean force not equal to the weight: { $weight }.
    }{ $unit ->
        [none] {""}
       *[other] {" "}Different unit of force: { $unit }.
    }{ $feet ->
        [none] {""}
       *[other] {" "}Force of one foot and of both feet mixed: { $feet }.
    }{ $cycle ->
        [none] {""}
       *[other] {" "}Steps and strides mixed: { $cycle }.
    }{ $kind ->
        [none] {""}
       *[other] {" "}Different kind of movement: { $kind }.
    }{ $open ->
        [none] {""}
       *[other] {" "}Open questions: { $open }.
    }
    .help = correct them, or exclude them by name: gait.leave_out = ["NAME", "FILE:LINE", …] (FILE:LINE for a row of a table); open questions can be accepted with gait.accept
file-no-such-walker = no walker and no file has the name "{ $name }"
    .help = { $nearest ->
        [none] the names are { $known }
       *[other] did you mean "{ $nearest }"?
    }
