# Faults of the command: files, options, folders.
cli-negative-ball = the radius of a probing ball must be 0 or more, not { $typed }
cli-cannot-open = cannot be opened ({ $fault })
cli-scene-name = "{ $shown }" { $fault ->
        [blank] is blank
        [dash] begins with a dash
        [control] contains a control character or an invisible mark
       *[not-plain] is not a plain file name
    }
    .help = use letters, digits, - and _, because the results are written to out/NAME, or give another folder with --out
cli-few-rows = invalid value { $rows }
    .help = at least { $least } points are required; fewer are possible only with --front
cli-not-stances = { $file } is neither a new .csv file nor a table of stances
    .help = only an existing table of stances can be replaced; give a different name ending in .csv
cli-stances-of-several = several recordings are named, but { $table } can contain only one table
    .help = name one recording, or read the recordings one by one
cli-cycle-ending = { $file } is neither a .csv or .mot file nor a folder
    .help = the cycle is written as .csv or .mot, with pictures .svg and .png in the same folder
cli-table-changed = the table was changed after the sweep had finished
    .help = move the table to compute it again
cli-cams = "{ $typed }" is not a number of cams
    .help = write one number, or the first and the last number, as in 3 or 1:6; the maximum is { $most }
cli-among-recordings = the results would be written among the recordings in { $folder }
    .help = give another folder
cli-not-cover = this is not a table of gaitcam cover
    .help = give the output folder of gaitcam cover
cli-recording-not-scene = this option changes a scene, but the file is a recording
    .help = use the options of gaitcam gait
cli-scene-not-recording = the file is a scene, not a recording
    .help = use gaitcam synth or gaitcam doctor for the scene, or give the recording in its key gait.file
cli-no-key-contains = no key contains "{ $pattern }"
cli-input-time = the input was not read within { $limit } s
    .help = end the input, or set a longer --time-limit
cli-no-model = "{ $typed }" is not a model
    .help = write auto, rigid, flexible or contact
cli-no-walk = the design has no recording with eight or more consecutive strides
    .help = give a recording of a walk: gaitcam walk RESULT RECORDING
cli-nothing-to-walk = a speed programme requires the target force of one walker and a cam that turns once per force cycle
    .help = give a scene with a load model or a recording
cli-varies-too-much = the coefficient of variation must be between 0 and { $most }
    .help = the step time of healthy people varies by 1 to 4 %
cli-strides-missing = { $count } strides are requested, but only { $recorded } consecutive strides are recorded
    .help = give a smaller number, or use a recording with more strides; fewer than eight consecutive strides are not used
cli-few-strides = the recording has only { $strides } consecutive strides of both feet; at least { $needed } are required
    .help = record a longer walk on a treadmill or with insoles; gaitcam gait --stances lists the rejected contacts
cli-clipped-walk = the force is clipped, so its amplitude is unknown
    .help = record again with a larger range of the amplifier
cli-programme-column = the speed programme has no column { $column }
    .help = write the names of the columns in the first line: time_s,speed_rad_per_s
cli-speeds = { $typed } is not a range of speeds
    .help = write first speed, last speed and number of speeds (2 to { $most }): --speeds '1.4 Hz:2.3 Hz:10'
cli-cam-is-made = this result has a finished profile; a change of { $key } requires a new design
    .help = change only keys of drive and machine, or design a new cam with gaitcam synth SUMMARY.json --set …
cli-broken-table = { $fault }
    .help = write the table again with gaitcam synth
cli-field-not-number = a field is not a number
    .help = write the table again with gaitcam synth
cli-empty-table = the table has no row
cli-no-blocks = this folder contains no blocks of a sweep; give the table of gaitcam sweep, or the folder of its blocks (gaitcam sweep --shard)
cli-not-sweep-table = the file is not the table of a sweep, because it has no column "{ $column }"
    .help = give the output file of gaitcam sweep
cli-no-parquet = this gaitcam was built without Parquet (the feature "parquet")
    .help = use a .csv table, or build gaitcam with --features parquet
cli-table-ending = { $file } is neither .csv nor .parquet
    .help = use one of these endings
cli-no-base-scene = the file does not contain the base scene of this row
cli-row-not-number = row { $row }: "{ $cell }" is not a number
cli-nothing-varies = the grid is empty: no key is varied
    .help = write --vary 'limits.stroke=20 mm:60 mm:5', --list FILE.csv or --recordings FOLDER
cli-list-value = { $fault }
cli-list-cell = a value is missing
    .help = every row requires a value for every key
cli-empty-list = the grid is empty: the list has no row
    .help = write the keys in the first line and their values in each further line
cli-no-recordings = the folder contains no file
    .help = give a folder with recordings, whose names end in { $endings }
cli-not-recordings = none of { $files } files has the name ending of a recording
    .help = give a folder with recordings, whose names end in { $endings }
cli-many-rows = the table would have { $rows } rows
    .help = use fewer values or a smaller --sample, or confirm the size with --yes; --estimate predicts the computing time
cli-scatter-csv = the samples of --tolerance can only be written as .csv
cli-too-many-samples = invalid value { $count }
    .help = the maximum is { $most }
cli-no-sample = the number of samples is zero
cli-partial-rows = the folder contains { $rows } rows of an interrupted sweep
    .help = continue with --resume, or delete the folder to start again
cli-not-partial = the folder is not the partial table of a sweep
    .help = move the folder, or choose another --out
cli-rows-safe = cannot be written ({ $fault })
    .help = the table contains { $rows } complete rows: free disk space and continue with --resume
cli-all-rows-safe = cannot be written ({ $fault })
    .help = all rows are saved in the same folder: free disk space and continue with --resume
cli-cannot-repair = cannot be repaired ({ $fault })
cli-file-is-there = the file already exists and is not overwritten
    .help = give another name with --out
cli-unknown-flag = unknown option
    .help = { $near ->
        [none] gaitcam COMMAND --help lists the options
       *[other] did you mean { $near }?
    }
cli-one-too-many = there is one argument too many
    .help = quote values that contain blanks: --set 'limits.stroke=40 mm'
cli-unknown-verb = "{ $typed }" is not a command
    .help = { $near ->
        [none] gaitcam --help lists the commands; write the scene after the command: gaitcam synth SCENE.toml
       *[other] did you mean { $near }?
    }
cli-in-lab = "{ $typed }" has moved to the lab of the source repository: cargo run --release -p gaitcam-lab -- { $typed }
cli-flag-without-value = a value is missing
cli-flag-choice = "{ $typed }" is not a valid choice
    .help = write one of: { $choices }
cli-flag-value = invalid value "{ $typed }"
    .help = { $fault }
cli-flag-whole = invalid value "{ $typed }"
    .help = write a whole number
cli-flag-range = invalid value { $typed }
    .help = it must be in { $range }
cli-missing-arguments = missing: { $missing }
    .help = { $choices ->
        [none] see --help
        [table] add, for example, --out table.csv
       *[other] write one of: { $choices }
    }
cli-flag-conflict = cannot be used together with { $other }
cli-flag-count = the number of values is wrong
cli-arguments = { $fault }

# Every verb.
run-internal-error = internal error; please report it with { $file ->
        [none] the scene
       *[other] { $file }
    }
run-no-command = No command is given, so the cam of the built-in scene footbridge is designed. `gaitcam --help` lists the commands.
run-stdout = the output cannot be written to standard output ({ $fault })
run-files = Files are in { $folder }; open { $first } first.

# synth: labels of the rows of the summary, at most nine characters.
label-failed = FAIL
label-ok = ok
label-force = force
label-law = law
label-drive = drive
label-cam = cam
label-machine = machine
label-floor = floor
label-resonance = resonance
label-walkers = walkers
label-shaft = shaft
label-active = active
label-relaxing = relaxing
label-note = note
label-solved = solved
label-optimum = optimum
label-sequence = sequence
more-failed = { $count } more failed checks in summary.json
more-passed = { $count } more passed checks in summary.json
more-active = { $count } more active limits in summary.json
more-relaxing = { $count } more sensitivities in summary.json
more-notes = { $count } more notes in summary.json
time-limit-seconds = write a number of seconds above 0, such as 20
synth-searching = designing (at most { $limit } s)
synth-check = { $name } { $value } (limit { $limit }) at { $at }
synth-check-none = { $name } none
synth-check-overall = { $name } { $value } (limit { $limit })
synth-force-error = error { $rms } RMS ({ $percent } % of the mean), { $most } maximum
synth-force-range = { $range }, mean { $mean }
synth-load-factors = dynamic load factors 1 to 4: { $list }
synth-walkers = { $count }: force error { $mean } % of the mean force on average, { $cvar } % for the worst { $tail ->
        [tenth] tenth
       *[other] { $tail } %
    }, { $worst } % for the worst walker ({ $who })
synth-walkers-n = { $count }: force error { $mean } N on average, { $cvar } N for the worst { $tail ->
        [tenth] tenth
       *[other] { $tail } %
    }, { $worst } N for the worst walker ({ $who })
synth-shaft = { $low } … { $high } rad/s, ripple { $ripple } %; motor: no-load speed { $noload } rad/s, torque { $rms } N·m RMS, { $most } N·m peak
synth-shaft-error = force error over time { $own } % of the mean; { $before } % with the law for constant speed{ $rounds ->
        [0] {""}
        [one] {"; "}one iteration
       *[other] {"; "}{ $rounds } iterations
    }
synth-shaft-sensitivity = with 10 % less or more of { $list }
synth-shaft-differs = { $key }: { $less } %, { $more } %
synth-active = limit { $limit } { $points ->
        [1] at { $at }
       *[other] at { $points } points, maximum multiplier at { $at }
    }
synth-relaxing = { $limit } by 1 % to { $to }: { $name } { $after } { $unit } instead of { $before } { $unit }
synth-solved = method { $tier }, { $solve } ms of { $total } ms: { $status }
synth-certified = { $family ->
        [spline] proved: no spline of this degree with these spans is better within these limits
       *[other] proved: no law of this family is better within these limits
    }
synth-uncertified = not certified as the optimum: { $why }
synth-optimum = relative duality gap { $gap }, optimality error { $kkt }, constraint violation { $violation }
synth-no-sequence = not needed
synth-sequence = { $count } convex programs
synth-step-head = step   prime radius          objective   relative clearance   step length
synth-ended = stopped: { $why }
synth-no-solid = the solid was not written: { $fault }
synth-no-step = the STEP file was not written: { $fault }
synth-no-program = the machine program was not written: { $fault }
synth-gouge-hollow = the cutter radius is too large for the concave profile at { $at }; the maximum is { $radius }
synth-gouge-elsewhere = while the cutter cuts the profile at { $at }, it gouges the profile at { $damaged } by { $depth }
synth-gouge-undercut = the profile is undercut at { $at } and cannot be cut

# synth --front.
trade-stopped = The time limit ended the search, and points of the front are missing. Set a longer --time-limit.
trade-none = no point of the front has a feasible cam
trade-title = { $name }: minimum force error for each { $quantity }

# gait.
gait-cycle-of = cycle of { $file }
gait-joint-mean-of = joint mean of { $file }
gait-mean-cycle-of = mean cycle of { $file }

# simulate.
simulate-no-cam = there is no cam to simulate: { $why }
simulate-speeds-error = error, N RMS
simulate-speeds-torque = torque, N·m
simulate-speeds-ripple = ripple, %
simulate-speeds-factors = load factors 1 to 4
simulate-speeds-lost = contact lost
simulate-speeds-none = the shaft stops: { $why }
simulate-no-target = there is no target at this speed: { $why }
simulate-as-made = the cam as manufactured, at { $rpm } rpm
simulate-designed-again = the cam was designed for this drive.speed; use --speed to run it at another speed

# sweep.
sweep-skipped = { $count } file(s) in the folder are not recordings and are skipped ({ $first }{ $count ->
        [1] {""}
       *[other] {" …"}
    })
sweep-complete = { $file } is already complete.
sweep-stopped = stopped after { $done } of { $rows } rows; completed rows are saved; continue with --resume
sweep-counts = { $rows } rows in { $file }: { $built } built ({ $acceptable } acceptable, { $slow } not for high speed), { $infeasible } infeasible, { $errors } errors
sweep-estimate = { $rows } designs take about { $time } with { $threads } threads ({ $core } core hours): { $rate } per second and core, measured with { $computed } designs
sweep-rate = { $designs } designs in { $seconds } s, { $rate } per second
sweep-first-error = First error, row { $row }: { $fault }
sweep-damaged = { $file } is damaged, so its rows are computed again
sweep-no-design = tolerances cannot be applied without a design: { $why }
sweep-samples = { $name }: { $count } manufactured samples; force error as designed { $own } % of the mean
sweep-spread = spread    mean { $mean } %, standard deviation { $deviation } %, 5 % to 95 %: { $p5 } % … { $p95 } %, median { $median } %, maximum { $largest } %
sweep-yield = yield     { $within } % of the cams have a force error of at most { $band } %
sweep-scatter-files = Samples are in { $file }, pictures in { $page }.
sweep-shard = write I/N with I from 1 to N, for example 3/16 for the third of sixteen shares (0/16 means 16/16)
sweep-shard-done = { $folder }: { $rows } rows computed, { $left ->
        [0] every block is complete
        [one] one block is missing
       *[other] { $left } blocks are missing
    }
sweep-designs = designs
sweep-progress = { $done }/{ $total } { $what }, { $rate }/s, { $left } left

# sweep --tolerance: the report.
scatter-title = { $name }: manufacturing scatter
scatter-how = Each sample is the cam with random errors that are uniformly distributed over the tolerances. The force error of each sample is computed.
scatter-heading = Force error of manufactured samples
scatter-picture = { $name }: force error of manufactured samples
scatter-axis = force error RMS, % of the mean
scatter-own = as designed
scatter-band = band
scatter-by-design = As designed
scatter-of-mean = of the mean force, RMS
scatter-median = Median of the samples
scatter-below = 95 % of the samples are below
scatter-largest = Maximum
scatter-yield = Yield
scatter-within = within { $band } %
scatter-tolerances = Tolerances
scatter-tolerance = tolerance

# front.
front-none-built = { $file }: no design was built
front-none-feasible = { $file }: no design is acceptable (--all includes unacceptable designs)
front-counts = { $file }: { $candidates } of { $seen } designs are admissible; { $front } of them are non-dominated
front-missing = { $count ->
        [one] row { $list } is missing in the folder and in the front
       *[other] { $count } rows are missing in the folder and in the front ({ $list })
    }. Start the same sweep again to compute the missing rows
front-low-speed = { $count ->
        [one] one design that is not for high speed is
       *[other] { $count } designs that are not for high speed are
    } excluded; --low-speed includes them
front-row = row
front-best = best compromise
front-more = … { $count } more in front.csv; best compromise: row { $row }
front-page-title = Sweep { $name }
front-page-counts = { $seen } designs, { $candidates } of them admissible; { $front } are non-dominated in { $text }. The best compromise is row { $row }.
front-page-low-speed = { $count ->
        [one] One design that is not for high speed is
       *[other] { $count } designs that are not for high speed are
    } excluded.
front-heading-front = Front
front-heading-heat = Heat map
front-heading-parallel = Parallel coordinates
front-picture-front = { $name }: front
front-picture-least = { $name }: minimum { $text }
front-picture-largest = { $name }: maximum { $text }
front-picture-parallel = { $name }: designs, front in blue
front-table = The front
front-best-table = The best compromise
front-column = column
front-value = value

# Columns of a sweep's table.
column-time = time
column-row = row

# cover and gait --against.
cover-head = { $name }: { $cycles } cycles; force error in % of each mean force
cover-head-n = { $name }: { $cycles } cycles; force error in N
cover-cams = cams
cover-mean = mean
cover-worst = worst
cover-objective = minimised
cover-bound = bound
cover-others-mean = others, mean
cover-others-worst = others, worst
cover-who = worst walker (main error component)
cover-weight = mean force
cover-speed = size at this speed
cover-shape = shape
cover-bound-worst = minimised: the worst error; bound: lower bound for this number of cams; others: error for new walkers, by five-fold cross-validation
cover-bound-mean = minimised: the RMS of the errors; bound: lower bound for this number of cams; others: error for new walkers, by five-fold cross-validation
cover-bound-tail = minimised: the RMS of the errors of the worst walkers; bound: lower bound for this number of cams; others: error for new walkers, by five-fold cross-validation
cover-stopped = The time limit ended the search before all numbers of cams were examined. Set a longer --time-limit.
cover-cut = The time limit ended the search; better assignments may exist. Set a longer --time-limit.
cover-error = RMS force error, % of the mean force
cover-error-n = RMS force error, N
cover-number = number of cams
cover-what = Error as a function of the number of cams
against-head = Cams of { $folder }
against-walker = walker
against-cams = cams
against-cam = assigned cam
against-error = error %
against-error-n = error, N
against-reason = largest component of the error

# compare.
compare-diagrams = Diagrams in { $folder }
compare-title = Comparison of { $name }
compare-figures = Figures
compare-verdict = verdict
compare-outcome = outcome
compare-law = law
compare-follower = follower
compare-built = built
compare-infeasible = infeasible
compare-over-angle = cam angle θ, degrees
compare-over-travel = travel of the cam x, { $unit }
compare-over-both = cam angle θ, degrees; for a translating cam its travel, { $unit }
compare-laws = Laws
compare-lifts = lift and its derivatives
compare-profiles = Profiles
compare-scale = drawn to the same scale
compare-forces = Forces
compare-force = force, N
compare-target = target of { $name }

# laws.
laws-head = Rise by 1 in time 1: maximum velocity Cv, acceleration Ca, jerk Cj, torque Ct = max|a·v|
laws-law = law
laws-joins = joins

# synth --explain.
explain-title = { $name }: model selection
explain-because = because { $reason }
explain-none-passed-over = it is the simplest of the families that were tried
explain-family-degree = { $family } of degree { $degree }
explain-constant-speed = constant speed
explain-motor = the speed of the shaft with the motor
explain-forecast = inertia and alternating energy give an estimated ripple of { $ripple } % and a force change of { $change } % of the mean (RMS); a change up to { $neglected } % is neglected{ $enough ->
        [true] {": "}constant speed is sufficient
       *[other] {""}
    }

# keys.
keys-default = default { $text }

init-shaker = A mass on the cam that shakes a footbridge like a walker: F = M (g + d²s/dt²).
init-walk = A cam for your own recording of walking, reproduced by a mass on the cam.
init-heel-tester = A heel tester: the lift compresses oil or air in a cylinder, and the force increases with the lift. For your own recording, write file = "walk.csv" instead of model, step_frequency and body_weight.
init-spring-bench = A test bench with a spring for prosthetic feet, shoes or joints: F = F₀ + k s + m d²s/dt².
init-programme = A classical cam from a programme of rises, falls and dwells, without a target force.
init-written = { $file } was written
init-how = Design the cam with gaitcam synth { $file }. List every key with gaitcam keys. Lines that begin with "# key =" are inactive options.
doctor-toml = { $file }: { $keys } values
doctor-keys-right = all keys are known, and all values are in their ranges
doctor-faults = { $count ->
        [one] There is one fault. Correct it and run the command again.
       *[other] There are { $count } faults. Correct them and run the command again.
    }
doctor-one-cycle = { $file }: one cycle of { $period } s
doctor-recording = { $file }: { $columns ->
        [one] one force column
       *[other] { $columns } force columns
    }, { $used ->
        [one] one contact
       *[other] { $used } contacts
    } used, { $rejected } excluded
doctor-unacceptable = The recording cannot be used: { $sentence }. Give another recording or column.
doctor-doubt = Not certain: { $sentence }. Check this. Then give the key with the missing information, or accept the assumption with gait.accept = "{ $name }".
doctor-recording-options = Missing information can be given with gait.time, gait.force, gait.unit, gait.rate, gait.mass, gait.kind, gait.period (see gaitcam keys gait).

# inspect.
inspect-no-cam = there is no cam to compare with: { $why }
inspect-fit = { $points } points; the cam is turned by { $turn }°, with its centre at x { $x }, y { $y }
inspect-alike = the cam is symmetric, so it fits equally well after a rotation by { $others }
inspect-deviation = deviation along the normal: { $rms } µm RMS, from { $least } µm at { $below } to { $most } µm at { $above }
inspect-outliers = { $count } { $count ->
        [one] point is excluded, because it differs
       *[other] points are excluded, because they differ
    } by up to { $most } µm from the others (lines { $lines })
inspect-part = the profile is not measured between { $from } and { $to }, so force and motion as manufactured are unknown
inspect-waves = { $waves } harmonics of the turn describe the deviation; the noise is { $left } RMS
inspect-rms = force error RMS: as designed { $before }, as manufactured { $after } { $unit }
inspect-max = force error maximum: as designed { $before }, as manufactured { $after } { $unit }
inspect-least-force = minimum force: as designed { $before }, as manufactured { $after } { $unit }
inspect-most-force = maximum force: as designed { $before }, as manufactured { $after } { $unit }
inspect-acceleration = peak acceleration: as designed { $before }, as manufactured { $after } { $unit }
inspect-liftoff = lift-off speed: as designed { $before }, as manufactured { $after } { $unit }
inspect-lifts-off = this cam loses contact at the speed of the scene
# Electronic cams.
synth-no-ecam = the electronic cam was not written: { $fault }
# walk: the speed programme of a recorded walk.
walk-no-cam = there is no cam for the speed programme: { $why }
walk-strides = { $strides } recorded strides, { $duration } s, step time ± { $time } %; the programme reproduces the recorded step times within { $error } ms
walk-generated = { $strides } generated strides, { $duration } s, step time ± { $time } %; the programme reproduces the generated step times within { $error } ms
walk-misfit = damping, %: { $dampings }; misfit of the response: { $misfit }; peak, relative to the walk: { $peak }
walk-constant = at constant speed: misfit { $misfit }; peak { $peak }
walk-motion = speed { $low } … { $high } rad/s, acceleration up to { $acceleration } rad/s², torque up to { $torque } N·m
walk-force = force { $low } … { $high } N; RMS difference from the force of the walk { $error } N
walk-amplitude = the amplitude at the step frequency varies by ± { $own } % with the programme and by ± { $recorded } % in the walk; a cam can vary it only together with the step time
walk-pace = the stride time changes by { $change } % from the first to the last quarter of the strides; record a steady walk, or cut the recording
walk-file = The programme is in { $file }. Run it with gaitcam simulate RESULT --speed-programme.
programme-kept = the cam keeps contact and all limits of force and torque
programme-lost = the cam loses contact
programme-broken = the cam violates a limit
programme-force = force { $low } … { $high } N
programme-limit = { $limit }: { $worst }, limit { $bound } (SI)

ecam-no-strides = no electronic cam: { $why }
ecam-strides = the strides repeat after { $duration } s; damping, %: { $dampings }; misfit of the response: { $misfit }; peak, relative to the walk: { $peak }
ecam-no-cam = there is no cam to simulate: { $why }
points-file = { $count } points in { $unit }: { $file }
ecam-file = File { $file }.
ecam-quintic = quintic
ecam-cubic = cubic spline
ecam-below = less than { $least }
ecam-force = { $file }: { $points } intervals, { $curve }, { $number }; force error with this controller { $error } N RMS; RMS deviation from the designed force { $added } % of the mean
ecam-law = { $file }: { $points } intervals, { $curve }, { $number }; RMS deviation from the designed force { $error } N with this controller ({ $added } % of the maximum force)
ecam-acceleration = { $file }: { $points } intervals, { $curve }, { $number }; RMS deviation from the designed acceleration { $added } % of its maximum

# identify, recut.
identify-no-cam = the scene of this log has no cam: { $why }
recut-error = force error measured before { $before } N RMS, predicted with the new cam { $after } N RMS
