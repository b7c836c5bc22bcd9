# Files of force: what is wrong with them.

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

read-no-table = no table of numbers found
    .help = the file starts with "{ $start }"; a recording is a table with a column of time or a rate, and columns of force
read-header-without-rows = the header has a force column ("{ $column }"), but no rows of numbers follow
    .help = export the samples as well; each row should start with a time or a number
read-no-force-column = no column of vertical force found
    .help = the columns are { $columns }; name the force column (option force)
read-many-forces = { $found } columns of force are more than a walkway has
    .help = name those that are meant (option force)
read-single-sensors = the { $sensors } numbered columns are readings of single sensors, such as the pressures of an insole, and none is a force
    .help = export the total force of each insole in newtons; pressures make a force only with the area of each sensor
read-long-table = a long table of { $cycles ->
        [one] one cycle
       *[other] { $cycles } cycles
    } over their phase, one for each subject, task and step, has no clock
    .help = give the duration of the cycle (option period): the mean of the cycles is read. Forces in body weights also need the mass (option mass)
read-long-tasks = the cycles of this table are of several tasks: { $tasks }
    .help = keep the rows of one task
read-long-forces = only one force of a long table is read, not { $columns }
    .help = name the one that is meant (option force)
read-nameless-columns = the columns have no names, and none resembles a vertical force
    .help = give the number of the force column (option force), and of the time column where there is one (option time)
read-no-column = no column "{ $column }"
    .help = the columns are { $columns }
read-misspelt-column = no column "{ $column }"
    .help = did you mean "{ $near }"? The columns are { $columns }
read-no-column-number = no column "{ $column }"
    .help = the columns have no names; give a number from 1 to { $count }
read-no-force-unit = the unit of column "{ $column }" is { $unit }, which is not a unit of force
    .help = export calibrated forces, or give the unit of the readings (option unit)
read-force-is-time = the column named as force is the time column
    .help = name another force column, or the time column (option time)
read-time-backwards = time decreases ({ $time } after { $after })
    .help = give one recording per file, in ascending time
read-short-rows = the rows have far fewer fields than the header
    .help = each row should have { $fields } fields
read-commas-twice = { $columns } columns, and { $fields } fields in a row: decimal commas, with commas between the columns
    .help = export with semicolons or tabs between the columns, or with decimal points
read-few-samples = { $samples ->
        [0] the recording has no samples
        [one] the recording has one sample
       *[other] the recording has { $samples } samples
    }
    .help = give at least one complete stance
read-time-stands-still = time does not increase from { $at } on
    .help = name the time column (option time) or give the sampling rate (option rate)
read-mostly-gaps = samples are missing for { $lost } of { $whole }
    .help = split the recording at its gaps
read-counts-without-mass = the file holds converter counts without calibration
    .help = give the mass of the walker (option mass), by which they are scaled, or the unit of the counts (option unit), or the .c3d file of the trial
read-mat-without-force = no array of the MATLAB file is known to be a force; its arrays are { $arrays }
    .help = name the force (option force); save the trial as numeric arrays or structs, because tables and timetables of MATLAB cannot be read
read-mat-cut = the file was cut: its array { $array } has { $found } of { $announced } values
    .help = copy or export the file again
read-phase-without-period = { $column } is the phase of a cycle, not a time
    .help = give the duration of the cycle (option period), for example "1.1 s"
read-phase-of-stance = { $column } is the phase of a stance, which is a part of the cycle
    .help = give the duration of the cycle and the part of the turn that the stance covers (options period and span), for example "1.1 s" and "223 deg"
read-cycle-in-c3d = a C3D file is a recording, not a table of one cycle
    .help = leave out the period; give a span only where the file has a whole stance (options period and span)
read-cycle-forces = one cycle has one force, not { $columns }
    .help = name the one that is meant (option force)
read-no-rate = the file contains neither time nor sampling rate
    .help = give the rate (option rate), for example "1000 Hz"
read-mass-missing = the force is in { $unit } and the body mass is not known
    .help = give the mass (option mass), for example "70 kg"

read-stance-sample = sample { $sample } of the stance is "{ $text }"
    .help = samples must be numbers, empty fields only at the end of the row
read-no-stance-row = no stance found
    .help = each row should hold the samples of one stance
read-row-mass-missing = the force is in { $unit } and the mass of row { $row } is not known
    .help = give the mass (option mass), or put the table of subjects beside the file

read-cycle-column-missing = no { $column ->
        [time] time
       *[force] force
    } column
    .help = the columns are { $columns }
read-cycle-without-table = the file is marked as a cycle but contains no table of numbers
    .help = give columns time_s and force_n
read-cycle-row = this row does not hold a time and a force
    .help = every row of a cycle needs both
read-cycle-value = a value is missing or not a number
    .help = every row of a cycle needs a time and a force
read-cycle-too-long = the samples span { $span }, longer than the period of { $period }
    .help = correct period_s, or give one cycle only
read-cycle-period-missing = the period of the critical points is not given
    .help = write "# period_s = 0.5" above the table
read-points-not-rising = at least two critical points in ascending time are needed
    .help = sort the rows by time
read-point-beyond-period = a point at { $at } lies beyond the period of { $period }
    .help = correct period_s or the point

read-processor = unknown C3D processor type { $code }
    .help = it must be 84 (Intel), 85 (DEC) or 86 (SGI)
read-no-analog = the file contains no analog samples
    .help = force plates are recorded as analog channels; export them with the trial
read-odd-analog = { $values } analog values per frame cannot be divided into { $samples } samples per channel
    .help = the header is damaged
read-no-frame = the file contains no complete frame of data
    .help = a frame has { $bytes } bytes; the file is truncated
read-no-frame-rate = the file gives no frame rate
    .help = POINT:RATE must be positive
read-no-channel = no analog channel "{ $channel }"
    .help = the channels are { $channels }
read-no-plate = neither a force plate nor an analog force channel found
    .help = the analog channels are { $channels }
read-not-plates-of-one-trial = these files are not the plates of one trial
    .help = only files that name their plate and have the same time stamp, samples and rate are read together, each once
read-plate-uncalibrated = force plate { $plate } has no calibration matrix (FORCE_PLATFORM:CAL_MATRIX), which its type needs
    .help = export the trial with it, or name a channel of calibrated vertical force (option force). The channels are { $channels }
read-plate-type-unknown = force plate { $plate } has the unsupported TYPE { $kind }
    .help = types 1 to 7 are supported; name its vertical force channel (option force). The channels are { $channels }
