# Labels of the tables of recordings.
gait-format = format
gait-kind = kind
gait-kind-unknown = not recognised
gait-rate = rate
gait-mass = mass
gait-mass-unknown = not known
gait-note = note
gait-channel = channel
gait-channel-columns = foot       baseline N  stances  rejected
gait-stance-columns = foot       start s    end s   P1 N     @ %   V N     @ %   P2 N     @ %
gait-rejected = rejected
gait-feet-columns = foot       n          P1 BW           V BW          P2 BW  stance %
gait-double-support = double support
gait-cadence = cadence
gait-symmetry = symmetry index of the impulse
gait-no-cycle = no mean cycle
gait-cycle = cycle
gait-period = period
gait-mean = mean
gait-warning = warning
gait-spread = spread
gait-repeatability = repeats
gait-varies = varies
gait-variability = { $strides } consecutive strides{ $runs ->
        [one] {""}
       *[other] {" "}in { $runs } runs
    }: step time ± { $time } %{ $single ->
        [true] {" "}(half the stride time: one foot is recorded)
       *[other] {""}
    }, amplitude at the step frequency ± { $amplitude } %, correlation of consecutive step times { $autocorrelation }
gait-pace = the stride time changes by { $change } % from the first to the last quarter of the strides; at resonance this has the same effect as variability
gait-samples = samples
gait-doubt = open
gait-unacceptable = The recording cannot be used: { $list }. { $others ->
        [0] Record again with a larger range.
       *[other] Record again with a larger range, or exclude the clipped column (--force).
    }
gait-doubts = Check { $list }. Then { $count ->
        [0] give another recording
        [one] give the correct value (option { $options })
       *[other] give the correct value (options { $options })
    }, or accept with gait.accept = "{ $names }".
gait-trial-columns = file  kind  used  rejected  stride s  mass kg  mean N  notes  joint mean
gait-used = used
gait-left-out = excluded: { $reason }
gait-joint-mean = { $trials ->
        [one] joint mean of one recording
       *[other] joint mean of { $trials } recordings
    }, { $cycles ->
        [one] one cycle
       *[other] { $cycles } cycles
    }: { $movement ->
        [running] { kind-running }
       *[walking] { kind-walking }
    }
gait-no-joint-mean = no joint mean
gait-as-given = one cycle
gait-several-sources = from several sources
gait-one-cycle = one force cycle, used unchanged (no stance detection)
