# Report and pictures of a design: headings, labels, captions. Arguments arrive as text with their units.

# Verdict and outcome.
report-title = { $name }: cam report
report-acceptable = Acceptable
report-not-for-high-speed = Not for high speed
report-unacceptable = Unacceptable
report-infeasible = Infeasible
report-conflict = Conflicting limits
report-relaxations = Each of these changes makes the design feasible
report-no-relaxation = No change of a single limit makes the design feasible
report-relaxation = from { $from } to
report-not-alone = { $limit }, { $from }: not sufficient alone

# Figures at the top.
report-force-error-worst = Maximum force error
report-worst-walker = { $walker }; mean { $mean }
report-exact = exact
report-of-mean = { $percent } % of mean
report-force = Force
report-moment = Moment
report-mean = mean { $value }
report-at = at { $place }

# Diagrams.
report-animation = Animation
report-force-section = Force
report-recording-section = Recording
report-alt-recording = Recording { $file }: force over time with { $used } contacts used and { $rejected } rejected, and the mean stances of the feet.
report-moment-section = Moment on the arm
report-law-section = Law of motion
report-cam-section = Cam and follower
report-curvature-section = Curvature and contact
report-target = Target: { $name }. Force error { $rms } RMS, { $most } maximum.
report-variability = Step-to-step variability of the recording: { $spread } (RMS of the standard deviation).
report-variability-ratio = Step-to-step variability of the recording: { $spread } (RMS of the standard deviation), { $ratio } times the force error.
report-idle-force = The scene has no mass, spring or preload. The force is shown for a 1 kg follower.
report-idle-moment = The scene has no inertia, spring or preload. The moment is shown for a follower of 1 kg·m².
report-scroll = Scroll sideways for the whole diagram →
report-alt-animation = The cam turning under its follower
report-alt-force = Target and achieved force over the cam angle: { $low } to { $high }, force error { $rms } RMS
report-alt-force-alone = Force over the cam angle: { $low } to { $high }
report-alt-law = Lift, velocity, acceleration and jerk over the cam angle: stroke { $stroke }, acceleration { $acceleration }
report-alt-cam = The cam at θ = 0 with its follower, { $base } and minimum radius of curvature { $radius }
report-alt-curvature = Radius of curvature and contact over the cam angle: minimum radius { $radius } at { $place }

# Checks and active limits.
report-checks = Checks
report-check = Check
report-state = State
report-worst = Worst value
report-limit = Limit
report-margin = Margin
report-place = At
report-satisfied = satisfied
report-at-limit = at the limit
report-violated = violated
report-active-limits = Active limits
report-no-active-limits = No limit restricts the law.
report-times = Points
report-multiplier = Maximum multiplier (SI)
report-multiplier-note = Lagrange multiplier of the objective; the most restrictive limit has the maximum multiplier.
report-sensitivity = Sensitivity: each limit relaxed by 1 %
report-from = From
report-to = To
report-objective = Objective
report-now = Now
report-predicted = Predicted

# Tables of the design.
report-data = Design data
report-drive = Drive
report-law = Law
report-cam = Cam
report-machine = machine
report-one-turn = one turn
report-one-pass = one pass
report-force-at-rest = static force
report-moment-at-rest = static moment
report-spring = spring rate
report-column = stiffness of the fluid column
report-damping = damping
report-family = family
report-pieces = spans
report-degree = degree
report-velocity = velocity
report-velocity-time = velocity (per second)
report-acceleration = acceleration
report-acceleration-time = acceleration (per second)
report-jerk = jerk
report-jerk-time = jerk (per second)
report-follower = follower
report-profile-radii = profile radii
report-roller-radius = roller radius
report-found-at = at
report-concave-radius = minimum concave radius
report-pressure-angle = pressure angle
report-loads = Torque, power and pressure
report-load-factors = Dynamic load factors (harmonics of the force relative to { $weight } N, phase of sin(kθ − φ))
report-harmonic = harmonic
report-frequency = frequency
report-factor-target = target
report-factor-achieved = achieved
report-hertz-allowable = allowable Hertz pressure
report-material-borne = { $pressure } MPa, margin { $margin }
report-hertz-borne = { $pressure } MPa ({ $hardness }, 10⁸ contacts), margin { $margin }

# Solution.
report-solution = Solution
report-attempt = Attempted solution
report-spectral = Closed-form spectral solution
report-equality = Equality-constrained least squares
report-qp = Convex quadratic program
report-socp = Second-order cone program
report-scp = Sequence of convex programs
report-solved = { $how }: { $time }, { $iterations ->
        [one] { $iterations } iteration
       *[other] { $iterations } iterations
    }.
report-verified = All limits are verified on the continuous law.
report-certified = No law of the family reduces the objective by more than one part in a million.
report-uncertified = The law is not certified as the optimum: { $why }.
report-certificate = Relative duality gap { $gap }, optimality error { $stationarity }, constraint violation { $violation }.
report-remarks = Remarks
report-footer = Lengths are in { $unit ->
        [in] inches
       *[mm] millimetres
    } and angles in degrees. θ is measured counter-clockwise from the start of the cycle. Extrema are computed on the continuous law.
report-footer-straight = Lengths are in { $unit ->
        [in] inches
       *[mm] millimetres
    } and angles in degrees. Travel is measured from the start of the pass. Extrema are computed on the continuous law.
report-footer-sweep = Every value has its unit. Extrema are computed on the continuous law.

# Animation.
report-play = Play
report-pause = Pause
report-pace = speed
report-full-speed = true speed
report-of-full-speed = of true speed
report-angle = cam angle
report-travel = travel of the cam
report-lift = lift s
report-now-force = force F
report-now-moment = moment on the arm
report-torque = shaft torque T
report-push = force along the travel
report-gap = gap
report-radius-at-contact = radius of curvature at contact
report-phi = pressure angle φ
report-inverted = The shaft is shown fixed; in the machine the plate is fixed and the shaft rises.

# Simulation.
report-simulation = Simulation
report-simulated = Simulated with the { $model } model: { $why }.
report-contact = Contact
report-contact-lost = lost
report-contact-kept = kept
report-lost-share = { $percent } % of the motion
report-kept-share = throughout the cycle
report-contact-force = Contact force
report-error-of-target = force error { $rms } RMS
report-shaft-torque = Shaft torque
report-cam-push = Force along the travel
report-rms = RMS { $value }
report-liftoff = Lift-off speed
report-liftoff-none = none
report-runs-at = operating speed { $speed }
report-steady = Steady state
report-steady-first = in the first turn
report-steady-after = after { $turns ->
        [one] { $turns } turn
       *[other] { $turns } turns
    }
report-steady-not = not reached
report-steady-within = within the simulated turns
report-period-one = period: 1 turn
report-period = period: { $turns } turns
report-alt-simulation = Force, torque and gap of the simulation over the turn: force { $low } to { $high }
report-impacts = Impacts
report-leaves = Lift-off at
report-lands = Contact at
report-impact-speed = Speed
report-impact-gap = Gap
report-impulse = Impulse
report-more-impacts = simulation.json contains { $count } more impacts. Angles are counted continuously over successive turns.
report-next-model = Next more detailed model: { $difference }.

# Axes and keys of the pictures.
figure-angle = cam angle θ, °
figure-travel = travel, { $unit }
figure-law = law of motion
figure-force = force, N
figure-moment = moment, N·m
figure-error = error, N
figure-error-moment = error, N·m
figure-vertical-force = vertical force
figure-arm-moment = moment on the arm
figure-inertia = inertia force without load
figure-target = target
figure-achieved = achieved
figure-force-alone = force
figure-moment-alone = moment
figure-force-of-unit = force of a 1 kg follower
figure-moment-of-unit = moment of a follower of 1 kg·m²
figure-difference = error
figure-difference-rms = error, RMS { $rms } ({ $percent } % of mean)
figure-tolerance-band = tolerance band
figure-step-band = ± SD, step to step
figure-rigid = rigid
figure-constant-speed = at constant speed
figure-walkers = Force of all walkers, and of the cam for the worst walker
figure-walkers-force = force, % of the mean force
figure-walkers-band = all walkers
figure-walkers-worst = worst walker: { $name }
figure-walkers-cam = cam, error { $error } RMS
figure-floor = Peak acceleration of the floor, comfort classes
figure-floor-wanted = with the target force
figure-floor-cam = with this cam at other speeds
figure-floor-acceleration = acceleration, m/s²
figure-resonance = Response of a mode with { $damping } % damping about the step frequency
figure-resonance-recorded = recorded walk
figure-resonance-generated = generated walk
figure-resonance-cam = cam at constant speed
figure-resonance-strides = { $count } strides, repeated
figure-resonance-programme = cam with speed programme
figure-resonance-acceleration = RMS acceleration, 1 kg mode, m/s²
figure-resonance-frequency = frequency of the mode, Hz
resonance-severity = At resonance with { $damping } % damping this cam at constant speed is { $ratio } times as severe as the recorded walk.
resonance-severity-few = At resonance with { $damping } % damping this cam at constant speed is at least { $ratio } times as severe as the recorded walk. The recording has { $strides } strides, but this damping requires { $needed }.
report-resonance-section = Recorded walk and cam at resonance
report-resonance-damping = damping ratio
report-resonance-recorded = recorded walk, m/s²
report-resonance-cam = this cam, m/s²
report-resonance-ratio = ratio
report-resonance-note = The table contains the maximum RMS acceleration of a mode with a modal mass of 1 kg in steady vibration. The natural frequency is 0.9 to 1.1 times the step frequency. The recorded walk is { $strides } consecutive strides ({ $frequency } Hz), repeated periodically. The cam turns at constant speed. The steps of a person vary, but those of a cam do not. gaitcam walk computes a speed programme that varies the steps of the cam.
figure-speeds = the cam as manufactured at other speeds
figure-cam-rpm = speed of the cam, rpm
figure-cam-travel = speed of the cam, m/s
figure-error-rms = error RMS, N
figure-first-factor = load factor 1
figure-higher-factors = factors 2 to 4
figure-torque-largest = torque, N·m
figure-ripple = ripple, %
figure-harmonic = harmonic { $number }
figure-contact-lost = contact lost
figure-step-frequency = step frequency, Hz
figure-shaft-speed = ω, rad/s
figure-simulated = simulated
figure-torque = torque, N·m
figure-push = force, N
figure-gap = gap, { $unit }
figure-pressure = contact pressure { $range } MPa
figure-curvature = curvature and contact
figure-rho = radius ρ, { $unit }
figure-contact-travel = contact, { $unit }
figure-pressure-angle = pressure angle, °
figure-limit = limit { $value }
figure-cam = the cam at θ = 0
figure-profile = cam profile
figure-second-profile = second cam of the pair
figure-walls = walls of the groove, unrolled
figure-base-circle = base circle R { $radius }
figure-prime-circle = prime circle R { $radius }
figure-pitch-curve = pitch curve
figure-contact = contact at θ = 0
figure-sharpest = minimum radius
figure-stance-share = share of stance, % (mean { $seconds } s)
figure-one-stance = one stance
figure-mean-of-stances = mean of { $count } stances
figure-sd = ± 1 SD
figure-left = left
figure-right = right
figure-foot-unknown = unknown foot
figure-time = time, s
figure-mean-cycle = mean cycle
figure-body-weight = body weight
figure-body-weights = BW
figure-no-stance = no stance used
figure-joint-mean = joint mean of { $count } recordings
figure-joint-facts = { $cycles } cycles · stride { $seconds } s · mass { $mass } kg
figure-each-recording = each recording
figure-more-notes = { $count ->
        [one] and one more note
       *[other] and { $count } more notes
    }
figure-stride = stride { $seconds } s ({ $from })
figure-stride-spread = stride { $seconds } ± { $spread } s ({ $from })
figure-mass = mass { $mass } kg ({ $from })
figure-contacts = contacts: { $used } used, { $rejected } rejected
figure-designs = designs
figure-non-dominated = non-dominated
figure-best = best compromise

# The sheet of the cam in the workbook.
sheet-title = Disc cam, { $follower } follower
sheet-base-radius = Base radius { $value }
sheet-prime-radius = Prime radius { $value }
sheet-roller-radius = Roller radius { $value }
sheet-offset = Offset { $value }
sheet-speed = Speed { $value }
sheet-travel = Travel, mm
sheet-angle = Cam angle, °
sheet-lift = Lift, { $unit }
sheet-velocity = Velocity, { $unit }/s
sheet-acceleration = Acceleration, { $unit }/s²
sheet-jerk = Jerk, { $unit }/s³
sheet-curvature = Radius of curvature, mm
sheet-contour-radius = Contour, radius, mm
sheet-contour-angle = Contour, angle, °
sheet-contour-x = Contour, x, mm
sheet-contour-y = Contour, y, mm
sheet-contact-left = Contact left of the centre, mm
sheet-contact-right = Contact right of the centre, mm
sheet-pressure-angle = Pressure angle, °
sheet-pitch-radius = Pitch curve, radius, mm
sheet-pitch-angle = Pitch curve, angle, °
sheet-pitch-x = Pitch curve, x, mm
sheet-pitch-y = Pitch curve, y, mm

# The catalogue of rise laws.
laws-use-constant-velocity = Use it between two laws with the same velocity, for example for the working stroke of a feed. Next to a dwell its velocity is discontinuous, so insert semiharmonic or semicycloidal ends there.
laws-use-parabolic = It has the minimum peak acceleration of all laws for a given lift and time. Use it only at low speed, because the acceleration is discontinuous at both ends and in the middle.
laws-use-cubic = It is the simplest polynomial with rest at both ends. Use it only at low speed, because the acceleration is discontinuous at the ends.
laws-use-simple-harmonic = Its peak values are low. Use it for a rise that is followed directly by an equal return. Next to a dwell its acceleration is discontinuous.
laws-use-double-harmonic = Use it for a rise from a dwell that is followed directly by its return. The start is at rest; at the top, rise and return have the same acceleration.
laws-use-cycloidal = Use it between dwells at moderate and high speed. The acceleration is continuous and the jerk is finite. The peak acceleration is high.
laws-use-semiharmonic-start = It leads from rest to a constant velocity with a low peak acceleration. Its acceleration at the start is not zero, so it can follow a fall that ends with the same acceleration.
laws-use-semiharmonic-end = It leads from a constant velocity to rest with a low peak acceleration. Its acceleration at the end is not zero, so a return must start with the same acceleration.
laws-use-semicycloidal-start = It leads from a dwell to a constant velocity with continuous acceleration.
laws-use-semicycloidal-end = It leads from a constant velocity to a dwell with continuous acceleration.
laws-use-modified-trapezoid = Its acceleration is low and continuous. Use it for light followers that are limited by the inertia force.
laws-use-modified-sine = Its peak velocity and torque are low, and its acceleration is continuous. Use it for heavy rotary tables and large masses.
laws-use-scca = This family includes modified trapezoid, modified sine and cycloidal. Use the shares b, c and d to balance acceleration against velocity.
laws-use-3-4-5 = It is the usual polynomial between dwells. The acceleration is continuous, the peak values are moderate, and the cam is easy to manufacture.
laws-use-4-5-6-7 = Use it between dwells if the jerk must be zero at both ends. It is quieter at high speed but has a higher peak acceleration.
laws-use-5-6-7-8-9 = Use it between dwells if the snap must also be zero at both ends, as in stiff, fast machines. Of the three polynomials it has the highest peak acceleration.
laws-use-polynomial-5 = It matches lift, velocity and acceleration of both neighbours. Use it between two laws that cannot be joined directly.
laws-use-polynomial-7 = It matches lift, velocity, acceleration and jerk of both neighbours. Use it like polynomial-5 if the jerk must also be continuous.
laws-use-berzak-d = It is a polynomial with a low peak acceleration for use between dwells (Bautista Morelos 2018). The jerk at its ends is not zero.
laws-use-gutman-1-3 = It is a sum of two harmonics. Its peak acceleration is lower than that of the cycloidal law, and it has no higher harmonics that could excite the follower.
laws-use-freudenstein-1-3 = It is the law Freudenstein 1-3 as commonly printed. Its ends are not at rest (v = −1/56), so it cannot join a dwell. Use freudenstein-1-3-at-rest instead.
laws-use-freudenstein-1-3-at-rest = It is a sum of two harmonics with a low peak acceleration and rest at both ends.
laws-use-freudenstein-1-3-5 = It is a sum of three harmonics. Its peak acceleration is close to the minimum for three harmonics.
laws-use-eccentric = It is half a turn of an eccentric disc, the cheapest cam to manufacture. The return must follow directly, on the other half of the disc.

# The picture of a measured cam.
figure-identification = identified machine
figure-measured = measured
figure-modelled = modelled
figure-residual = residual
figure-inspection = measured profile
figure-deviation = deviation along the normal, µm
figure-inspected-force = force
figure-as-made = as manufactured
figure-as-designed = as designed
figure-exaggerated = as manufactured, deviations × { $factor }

# Workshop.
report-workshop = Workshop
report-cutting = Cutting
report-largest-cutter = maximum cutter radius
report-cutter-fits = R { $radius }, the minimum concave radius
report-any-cutter = any, because the profile is convex
report-hollow-and-roller = minimum concave radius
report-times-roller = { $ratio } times the roller radius
report-wall = wall at the bore
report-wall-enough = { $wall } (at least { $least })
report-wall-thin = { $wall }, less than { $least }: increase the base radius or reduce the bore

# The table of a run.
simulation-model = model
simulation-why = reason
simulation-contact = contact
simulation-contact-kept = kept over the whole turn
simulation-contact-lost = lost for { $percent } % of the motion
simulation-force = force
simulation-error = force error
simulation-bearings = loads
simulation-bearings-values = normal force up to { $normal } N, side thrust up to { $side } N
simulation-torque = torque
simulation-push = push
simulation-torque-values = { $least } … { $most }, mean { $mean }, RMS { $rms }
simulation-pressure = pressure
simulation-pressure-values = { $pressure } at { $at }, half-width { $width }, maximum shear stress { $depth } below the surface
simulation-floor = floor
simulation-floor-values = { $peak } m/s² peak, { $rms } m/s² RMS; comfort class { $class } (HiVoSS), comfort { $setra ->
    [maximum] maximum
    [mean] mean
    [minimum] minimum
   *[unacceptable] unacceptable
} (SETRA)
simulation-speed = shaft speed
simulation-speed-values = { $least } … { $most } rad/s, ripple { $ripple } %
simulation-motor = motor
simulation-motor-values = no-load speed { $noload } rad/s at the camshaft, torque RMS { $rms } N·m, peak { $most } N·m, mean power { $power } W
simulation-start = start
simulation-starts = when started from rest at minimum lift, the shaft completes the first turn
simulation-stops = when started from rest at minimum lift, the shaft stops after { $degrees }°
simulation-any-inertia = the shaft keeps turning with any inertia
simulation-least-inertia = the shaft keeps turning with at least { $inertia } kg·m²
simulation-lift-off = lift-off
simulation-never = at no speed
simulation-settles = settles
simulation-settled = { $turns ->
        [0] in the first turn
        [one] after { $turns } turn
       *[other] after { $turns } turns
    }; repeats every { $period ->
        [one] turn
       *[other] { $period } turns
    }
simulation-unsettled = not within the simulated turns
simulation-impacts = impacts
simulation-impact-values = { $count } in this run, maximum speed { $speed } at { $at }, maximum rebound { $bounce }
simulation-next-model = next model
simulation-next-failed = the simulation with { $model } failed: { $fault }
simulation-next-rms = , the RMS error by { $rms } N
simulation-next-same = { $model } gives the same results to four decimals
simulation-next-changes = { $model } would change the minimum force by { $least } N, the maximum by { $most } N{ $error }, the fraction without contact by { $lost } %
simulation-note = note

# Identification of a machine from its logs.
identify-head = { $name }: { $cycles } cycles at { $speed }; noise { $noise } N RMS, unexplained repeatable force { $repeats } N RMS
identify-logs = { $name }: { $cycles } cycles of several logs; noise { $noise } N RMS, unexplained repeatable force { $repeats } N RMS
identify-known = { $key } { $value } (95 %: { $low } … { $high })
identify-unknown = { $key } not identified: { $value } (95 %: { $low } … { $high })
identify-scale = the logs do not determine the scale of the load cell; the values apply to a calibrated load cell
identify-no-angle = in a log without a cam angle the phase is fitted, so a delay cannot be identified
identify-next = a further log at { $value } ({ $times } times the first speed) would identify { $keys }
