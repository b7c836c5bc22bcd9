# Force curves, load models, recordings and their mean cycle.

force-few-samples = a force cycle of { $samples } samples is too short
    .help = give at least 4 samples per cycle
force-lengths = { $times } times are given for { $forces } forces
    .help = give one force for each time
force-sample-not-finite = force sample { $sample } is not a finite number
    .help = every sample must be a finite number of newtons
force-period-not-positive = invalid period { $period }
    .help = the period must be positive
force-unknown-feet = invalid value "{ $word }" for feet
    .help = use both, one, left, right or total
force-unknown-kind = "{ $word }" is not a kind of movement
    .help = the kinds are walking, running, standing, jumping, sit-to-stand and other; a mean cycle is computed for walking and running
force-unknown-doubt = "{ $word }" is not a property that can be accepted
    .help = list only the properties of the recording that you have checked: kind, clock, mass
force-no-joint-mean = { $trials ->
        [one] the recording gives no
       *[other] none of the { $trials } recordings gives a
    } cycle for a joint mean
    .help = the table contains the reasons; set gait.file to a single cycle instead
force-unknown-unit = "{ $word }" is not a unit of force
    .help = the units are N, daN, kN, lbf, kgf, N/kg, BW and %BW
force-unknown-model = "{ $name }" is not a load model
    .help = the load models are { $known }
force-misspelt-model = "{ $name }" is not a load model
    .help = did you mean "{ $near }"?
force-weight-not-positive = invalid body weight { $weight }
    .help = it must be positive, for example "700 N"
force-frequency-out-of-range = { $model } is not defined for a step frequency of { $frequency }
    .help = give { $low } to { $high }
force-frequency-missing = { $model } requires a step frequency
    .help = give for example step_frequency = "1.85 Hz"
force-both-feet-only = { $model } gives the total force of both feet, not the force of one foot
    .help = use feet = "both", or a single-foot model: li-2010, iso-22675
force-clock-implausible = with the time column in milliseconds a stride takes { $period }, which is implausible for walking
    .help = the column may count samples: give the sampling rate (option rate)
force-running = the recording of { $duration } shows running (short contacts with flight phases between them)
    .help = use kind = "running" for a running cycle, or give a recording of walking
force-not-walking = the recording of { $duration } does not show walking: { $movement ->
        [standing] the load hardly changes, as in standing
        [jumping] both feet leave the ground or land at the same time
        [sit-to-stand] the load rises from the weight of the feet to the body weight
       *[other] the gait is not periodic
    }
    .help = give a recording of walking or running; for very slow steps use kind = "walking"; for any other periodic force use gait.period
force-total-of-both-feet = the recording of { $duration } contains no complete stance of one foot: the column is the total force of both feet, which does not return to zero
    .help = use feet = "both"
force-no-stance = the recording of { $duration } contains no complete walking stance
    .help = { $contacts ->
        [one] one contact was found, from { $from } to { $to }
       *[other] { $contacts } contacts were found, the first from { $from } to { $to }
    }; most frequent reason for rejection: { $reason }
force-no-stance-file-cut = the recording of { $duration } contains no complete walking stance: the header states { $announced } rows, but the file has { $found }
    .help = export the complete trial; most frequent reason for rejection: { $reason }
force-force-too-low = no channel carries a load in the recording of { $duration }: the maximum force is { $peak }
    .help = if the force is in N/kg or body weights, give its unit (option unit) and the mass (option mass)
force-no-live-channel = the recording of { $duration } contains no complete walking stance, because no channel carries a load
    .help = name the force column (option force)
force-no-contact = the recording of { $duration } contains no complete walking stance, because no channel exceeds 20 N
    .help = check the unit of force and the force column (options unit and force)
force-no-stance-of-foot = the recording contains no complete stance of the { $foot } foot
    .help = all stances are of the other foot; use feet = "one" or "both"
force-feet-not-named = the recording contains no complete stance of the { $foot } foot
    .help = the file does not identify the feet; use feet = "one" or "both"

note-rows-differ = the header states { $announced } rows, but the file has { $found }
note-frames-missing = the header states { $announced } frames, but the file has { $found }
note-lines-skipped = lines without a row of numbers were skipped; the first is line { $first-line }
note-insole-columns = columns { $left } and { $right } are the sums of two equal groups of sensors; they are used as left and right insole
note-insole-beside-plate = the table contains forces of a plate ({ $plate }) and of an insole ({ $insole }), and the plate is used; to use the insole, name its columns (option force)
note-stance-per-row = the table has one stance per row, { $rows } rows
note-masses-missing = the mass is known for { $known } of { $rows } stances; add the others to the table of subjects (metadata)
note-durations-lost = all stances have { $samples } samples, so their durations are unknown; a duration of { $assumed } is assumed
note-rate-guessed = the table has no sampling rate; the assumed rate of { $rate } results in stances of { $stance }; give the correct rate (option rate) if these are wrong
note-rate-overrides-times = the given rate of { $rate } replaces the rate of the time column, { $column }
note-time-unit-guessed = the time column has steps of { $step }; the assumed unit is { $unit ->
        [ms] milliseconds
        [us] microseconds
       *[ns] nanoseconds
    }
note-samples-missing = { $count ->
        [one] one sample is missing
       *[other] { $count } samples are missing
    }, the first near { $first }; the sampling rate is computed from the samples present
note-rates-differ = the header gives a rate of { $header }, but the time column gives { $column }; the time column is used
note-uneven-samples = the samples are unevenly spaced in time and were resampled at constant intervals
note-unit-guessed = the unit of force is not given; the peak of { $peak } indicates { $unit }
note-unit-label-rejected = a peak of { $peak } is implausible in { $label }; the unit is assumed to be { $unit }
note-low-force = no force exceeds { $peak }; if the forces are in body weights, give the unit BW and the mass (options unit and mass)
note-vertical-guessed = components { $vertical } and { $other } have similar magnitudes; { $vertical } is used as the vertical force
note-feet-guessed = ground_force is used for the right foot, 1_ground_force for the left foot (convention of OpenSim's examples)
note-no-plates = the file describes no force plate; analog channels are selected by their labels
note-plate-type-unknown = plate { $plate } is ignored, because TYPE { $kind } is not supported (supported: 1 to 7); to use the plate, name its force channel
note-plate-channel-missing = plate { $plate } is ignored, because its channel { $channel } is not in the file
note-plate-matrix-missing = plate { $plate } is ignored: its calibration matrix is missing
note-plate-tilted = plate { $plate } is not parallel to plate 1: at most one of their normal forces is vertical
note-insole-mass = the mass of { $mass } is computed from the mean total force of the insoles, which are seldom calibrated; give the walker's mass
note-clipped = { $column } is clipped: its readings do not exceed about { $level }, which is below the peaks of the force
note-missing-is-unloaded = samples of { $column } are missing between its contacts, where the plate is assumed to be unloaded
note-spikes-removed = { $count ->
        [one] a single sample of { $column } at { $first } differs strongly from both neighbours and was
       *[other] { $count } single samples of { $column } differ strongly from both neighbours (the first at { $first }) and were
    } replaced by a straight line
note-drop-outs = the readings of { $column } are zero under load { $count ->
        [one] once, at { $first }
       *[other] { $count } times, first at { $first }
    } (lost samples); stances with such gaps are not used
note-unloaded-differs = the unloaded reading of { $column } is { $level } between contacts, but { $at-ends } at both ends of the recording. Cross-talk or a changed offset makes the mass uncertain. Give the mass (option mass)
note-stance-fills-span = { $stances ->
        [one] the stance from { $from } to { $to } fills the span
       *[other] the mean of { $stances } stances, the first from { $from } to { $to }, fills the span
    }; the rest of the turn is unloaded
note-cross-talk-removed = while { $column } is unloaded, it shows { $share } of the force of { $of } (cross-talk); this share was subtracted
note-column-repeats = { $column } repeats { $original } (raw and filtered, or a copy) and was excluded
note-drift-removed = the unloaded reading of { $column } drifts by { $rise } per second; the drift was removed
note-stride-varies = the stride time is { $period } ± { $spread }, which is typical of several speeds or unsteady walking; give a recording at one speed
note-stride-from-one = the stride time of { $period } is measured from only one step or stride and has an uncertainty of { $error }; the resulting uncertainty of the stroke is { $stroke }
note-one-foot-for-both = { $stances ->
        [one] one stance of one foot is
       *[other] { $stances } stances of one foot are averaged and
    } repeated half a stride apart for the other foot (gait.feet = "both"); gait.feet = "one" gives the force of one foot
note-stride-assumed = the recording does not contain the stride time; { $period } is assumed, with a stance of { $duty } of the stride. Give the mass, the stride time or the angle of the stance (options mass, period and span)
note-stride-implausible = the stride time of { $period } is implausible for this movement (range { $low } to { $high }): check the sampling rate and the kind (options rate and kind)
note-duty-implausible = a stance of { $duty } of the stride is implausible for this movement (range { $low } to { $high }): check the kind and the sampling rate (options kind and rate)
note-peak-implausible = a peak force of { $ratio } body weights is implausible for this movement (range { $low } to { $high }): check mass, unit and kind (options mass, unit and kind)
note-mean-force-not-weight = the mean force over a stride is { $ratio } times { $share ->
        [half] half the
       *[whole] the
    } weight of { $mass }, but the expected ratio is 1: the mass, the unit of force or its calibration is wrong, or a foot is missing
note-mass-implausible = a mean force of { $mean } over a stride corresponds to a walker of { $mass }: the unit of force or its calibration is wrong, or a foot is missing
note-unit-unconfirmed = the unit of force is not given, and { $unit } would result in an implausible mass of { $mass }: give the unit or the mass (options unit and mass)
note-left-open = the file is the mean cycle of a recording for which this question was not answered
note-clock-differs = the time column covers { $clock }, but the given period is { $period }: the times are scaled to the given period
note-count-or-milliseconds = the time column has no unit and increases by 1. It counts samples, or it is in milliseconds and a stride takes { $stride }. Give the sampling rate (option rate)
note-kind-differs = kind { $typed } is given, but the contacts show { $movement ->
        [running] { kind-running }
        [standing] { kind-standing }
        [jumping] { kind-jumping }
        [sit-to-stand] { kind-sit-to-stand }
        [walking] { kind-walking }
       *[other] { kind-other }
    }
note-speed-changes = the speed changes during the recording; the mean is computed from { $used } of { $stances } stances or steps that last { $low } to { $high }, the largest group of one speed
note-few-alike = only { $used } of { $stances } contacts of a steady walk have a similar duration; the others are excluded (partial contacts, or contacts of both feet)
note-stances-differ = the stances differ by { $share }; at most { $most } is expected (share of the body weight, or of the mean impulse of both feet). Possible causes: partial contacts, cross-talk, two feet on one plate, or feet that differ. Give the mass (option mass), or name the columns of whole stances (option force)
note-total-column = the column is used as the total force of both feet
note-plates-summed = the feet move from plate to plate, so the mean cycle is computed from the sum of { $plates } plates, which always carry the walker
note-several-masses = the recordings show walkers with masses of { $low } to { $high }: forces are averaged in body weights and scaled to { $mean }
note-counts-scaled = the readings are converter counts without calibration; they are scaled so that the mean force is the weight of { $mass }

cycle-whole-strides = { $strides ->
        [one] one whole stride
       *[other] { $strides } whole strides
    } of both feet{ $from ->
        [left] , from left heel strike
        [right] , from right heel strike
       *[none] {""}
    }
cycle-right-and-left = force of both feet together from { $right } right and { $left } left single stances, half a stride apart; stride time from { $period }
cycle-two-feet = force of both feet together from { $one ->
        [one] one single stance
       *[other] { $one } single stances
    } of one foot and { $other } of the other, half a stride apart; stride time from { $period }
cycle-any-foot = force of both feet together from { $stances ->
        [one] one single stance
       *[other] { $stances } single stances
    }, repeated half a stride apart; stride time from { $period }
cycle-one-foot = { $stances ->
        [one] one stance
       *[other] { $stances } stances
    } of one foot; stride time from { $period }
cycle-total-force = { $strides ->
        [one] one stride
       *[other] { $strides } strides
    } of the total force of both feet, between upward crossings of the mean force

kind-walking = walking
kind-running = running
kind-standing = standing
kind-jumping = jumping
kind-sit-to-stand = sit-to-stand
kind-other = a different movement

open-kind = the kind of movement
open-clock = the time scale
open-mass = the mass and the unit of force
open-clipped = readings that are clipped below the peaks of the force

left-out-open = open: { $questions }
left-out-kind = { open-kind }
left-out-clock = { open-clock }
left-out-mass = { open-mass }
left-out-clipped = { open-clipped }
left-out-other-kind = { $movement ->
        [running] { kind-running }
       *[walking] { kind-walking }
    }, but most recordings show { $most ->
        [running] { kind-running }
       *[walking] { kind-walking }
    }
left-out-other-speed = different speed: the stride takes { $period }, but { $low } to { $high } in most recordings
left-out-mean-already = already a mean cycle, not a recording
left-out-no-cycle = no cycle

clock-user = given
clock-times = time column
clock-guessed-times = time column, unit guessed
clock-header = from the header
clock-guessed-rate = guessed

name-heel-strikes = consecutive heel strikes of one foot
name-marked-strikes = consecutive marked strikes of one foot
name-heel-markers = heel markers
name-doubled-steps = twice the mean step time
name-impulse = the impulse balance with the body mass
name-usual-duty = an assumed ratio of stance to stride (not in the recording)
name-total-force = upward crossings of the mean total force

mass-from-user = given
mass-from-file = from the file
mass-from-subjects = mean of the table of subjects
mass-from-mean-force = mean force over the stride

channel-never-loaded = never loaded
channel-constant = constant at { $level }
channel-mostly-empty = mostly empty: { $missing } of { $samples } samples are missing
channel-empty = empty

contact-cut-at-start = truncated: the recording starts during the stance
contact-cut-at-end = truncated: the recording ends during the stance
contact-edge-fragment = partial contact at the edge of the recording, ignored
contact-never-unloaded = never unloaded: standing, or both feet on one plate
contact-missing-samples = samples are missing during the stance
contact-too-short = too short for a step
contact-running = contact typical of running
contact-jumping = take-off or landing of both feet
contact-cross-talk = cross-talk from a foot on another plate
contact-other-speed = whole stance at another speed
contact-unlike = different from the other stances in duration, peak or impulse
contact-standing = too long for a step: standing
contact-cross-over = too long for one foot: both feet on one plate
contact-two-plates = foot on two plates
contact-partial-contact = partial contact: the force is too low for a full step

name-cut-at-start = { contact-cut-at-start }
name-cut-at-end = { contact-cut-at-end }
name-edge-fragment = { contact-edge-fragment }
name-never-unloaded = { contact-never-unloaded }
name-missing-samples = { contact-missing-samples }
name-too-short = { contact-too-short }
name-running = { contact-running }
name-jumping = { contact-jumping }
name-cross-talk = { contact-cross-talk }
name-other-speed = { contact-other-speed }
name-unlike = { contact-unlike }
name-standing = { contact-standing }
name-cross-over = { contact-cross-over }
name-two-plates = { contact-two-plates }
name-partial-contact = { contact-partial-contact }

format-c3d = C3D, { $processor } { $storage }
format-export = { $program } export
format-stance-table = table of stances, one per row
format-text = { $separator } separated text{ $decimal ->
        [comma] , decimal comma
       *[point] {""}
    }
format-headerless-text = { $separator } separated text{ $decimal ->
        [comma] , decimal comma
       *[point] {""}
    } without header

# Feet and storage.
name-left = left
name-right = right
name-vertical = vertical
name-integers = integers
name-floats = floats
force-no-walkers = the population contains no walker
    .help = give at least one cycle
force-walker-impossible = the walker { $walker } has no positive weight or mean force
    .help = correct the cycle, or omit it
force-walker-column-missing = the table of walkers has no column { $column }
    .help = the table needs the columns walker, period_s and f_000 to f_100 (N at equal steps of the cycle); speed_m_per_s, mass_kg and weight are optional
force-walker-value = invalid value "{ $value }" in column { $column }
    .help = give a number (positive for period_s and weight); only speed_m_per_s, mass_kg and weight may be empty
