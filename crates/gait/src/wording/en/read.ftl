# Faults in files of force.

read-empty = the file is empty
    .help = give a file with a header and rows of numbers
read-foreign = { $kind ->
        [zip] this is an Excel workbook or another zipped file
        [old-office] this is an old Excel or Word file
        [matlab] this is a MATLAB file that is not of level 5 (save -v7)
        [hdf5] this is an HDF5 file or a MATLAB file of version 7.3 (save it with -v7)
        [parquet] this is a Parquet file
        [gzip] this is a gzipped file
        [pdf] this is a PDF
        [xml] this is an XML file
        [numpy] this is a NumPy file
        [picture] this is a picture
       *[binary] this is a binary file of unknown kind
    }, which is not supported
    .help = export the trial as C3D or as text (csv, txt, mot)
read-rate-not-positive = invalid sampling rate { $rate }
    .help = the rate must be positive, for example "1000 Hz"
read-mass-not-positive = invalid mass { $mass }
    .help = the mass must be positive, for example "70 kg"

read-no-table = the file contains no table of numbers
    .help = the file starts with "{ $start }"; a recording is a table with a column of time or a rate, and columns of force
read-header-without-rows = the header has a force column ("{ $column }"), but no rows of numbers follow
    .help = export the samples as well; each row should start with a time or a number
read-no-force-column = the file contains no column of vertical force
    .help = the columns are { $columns }; name the force column (option force)
read-many-forces = the file contains { $found } columns of force, which is more than usual for a walkway
    .help = name the columns to use (option force)
read-single-sensors = the { $sensors } numbered columns are readings of single sensors, such as pressures of an insole, and not forces
    .help = export the total force of each insole in newtons, because forces cannot be computed from pressures without the area of each sensor
read-long-table = the table with { $cycles ->
        [one] one cycle
       *[other] { $cycles } cycles
    } contains the phase, but no time
    .help = give the duration of the cycle (option period); the mean of the cycles is then used. Forces in body weights also require the mass (option mass)
read-long-tasks = the cycles of this table belong to several tasks: { $tasks }
    .help = keep only the rows of one task
read-long-forces = the table contains several forces ({ $columns }), but only one can be used
    .help = name the force to use (option force)
read-nameless-columns = the columns have no names, and none resembles a vertical force
    .help = give the number of the force column (option force) and, if there is one, of the time column (option time)
read-no-column = the column "{ $column }" does not exist
    .help = the columns are { $columns }
read-misspelt-column = the column "{ $column }" does not exist
    .help = did you mean "{ $near }"? The columns are { $columns }
read-no-column-number = the column "{ $column }" does not exist
    .help = the columns have no names; give a number from 1 to { $count }
read-no-force-unit = the unit of column "{ $column }" is { $unit }, which is not a unit of force
    .help = export calibrated forces, or give the unit of the readings (option unit)
read-force-is-time = the given force column is the time column
    .help = name another force column, or the time column (option time)
read-time-backwards = time decreases ({ $time } after { $after })
    .help = give one recording per file, in ascending time
read-short-rows = the rows have far fewer fields than the header
    .help = each row should have { $fields } fields
read-commas-twice = the header has { $columns } columns, but a row has { $fields } fields: commas are used as decimal marks and as separators
    .help = export with semicolons or tabs as separators, or with decimal points
read-few-samples = { $samples ->
        [0] the recording has no samples
        [one] the recording has one sample
       *[other] the recording has { $samples } samples
    }
    .help = give at least one complete stance
read-time-stands-still = time does not increase after { $at }
    .help = name the time column (option time) or give the sampling rate (option rate)
read-mostly-gaps = samples are missing for { $lost } of { $whole }
    .help = split the recording at its gaps
read-counts-without-mass = the file contains converter counts without calibration
    .help = give the mass of the walker (option mass) or the unit of the counts (option unit), or use the .c3d file of the trial
read-mat-without-force = no array of the MATLAB file is recognised as a force; its arrays are { $arrays }
    .help = name the force (option force); save the trial as numeric arrays or structs, because tables and timetables of MATLAB cannot be read
read-mat-cut = the file is incomplete: its array { $array } has { $found } of { $announced } values
    .help = copy or export the file again
read-phase-without-period = { $column } is the phase of a cycle, not a time
    .help = give the duration of the cycle (option period), for example "1.1 s"
read-phase-of-stance = { $column } is the phase of a stance, not of the whole cycle
    .help = give the duration of the cycle (option period) and the angle of the stance (option span), for example "1.1 s" and "223 deg"
read-cycle-in-c3d = a C3D file is a recording, not a table of one cycle
    .help = omit the period; give a span only if the file contains a whole stance (options period and span)
read-cycle-forces = the table of one cycle must have one force column, but it has several: { $columns }
    .help = name the force to use (option force)
read-no-rate = the file contains neither time nor sampling rate
    .help = give the rate (option rate), for example "1000 Hz"
read-mass-missing = the force is in { $unit }, but the body mass is not known
    .help = give the mass (option mass), for example "70 kg"

read-stance-sample = sample { $sample } of the stance is not a number: "{ $text }"
    .help = samples must be numbers; only the end of a row may contain empty fields
read-no-stance-row = the table contains no stance
    .help = each row should contain the samples of one stance
read-row-mass-missing = the force is in { $unit }, but the mass of row { $row } is not known
    .help = give the mass (option mass), or place the table of subjects in the folder of the file

read-cycle-column-missing = the file has no { $column ->
        [time] time
       *[force] force
    } column
    .help = the columns are { $columns }
read-cycle-without-table = the file is marked as a cycle but contains no table of numbers
    .help = give columns time_s and force_n
read-cycle-row = this row does not contain a time and a force
    .help = every row of a cycle requires a time and a force
read-cycle-value = a value is missing or not a number
    .help = every row of a cycle requires a time and a force
read-cycle-too-long = the samples span { $span }, longer than the period of { $period }
    .help = correct period_s, or give one cycle only
read-cycle-period-missing = the period of the critical points is not given
    .help = write "# period_s = 0.5" above the table
read-points-not-rising = at least two critical points in ascending time are required
    .help = sort the rows by time
read-point-beyond-period = the point at { $at } is outside the period of { $period }
    .help = correct period_s or the point

read-processor = unknown C3D processor type { $code }
    .help = it must be 84 (Intel), 85 (DEC) or 86 (SGI)
read-no-analog = the file contains no analog samples
    .help = force plates are recorded as analog channels; export them with the trial
read-odd-analog = { $values } analog values per frame cannot be divided into { $samples } samples per channel
    .help = the header is damaged: export the trial again
read-no-frame = the file contains no complete frame of data
    .help = the file is truncated (a frame has { $bytes } bytes): copy or export it again
read-no-frame-rate = the file gives no frame rate
    .help = POINT:RATE must be positive
read-no-channel = the analog channel "{ $channel }" does not exist
    .help = the channels are { $channels }
read-no-plate = the file contains neither a force plate nor an analog force channel
    .help = the analog channels are { $channels }
read-not-plates-of-one-trial = these files are not plates of the same trial
    .help = give each file once; files are combined only if they name their plate and have the same time stamp, number of samples and rate
read-plate-uncalibrated = force plate { $plate } has no calibration matrix (FORCE_PLATFORM:CAL_MATRIX), which is required for its type
    .help = export the trial with this matrix, or name a channel of calibrated vertical force (option force). The channels are { $channels }
read-plate-type-unknown = force plate { $plate } has the unsupported TYPE { $kind }
    .help = types 1 to 7 are supported; name its vertical force channel (option force). The channels are { $channels }
