# Report and pictures of a design: headings, labels, captions. Arguments arrive as text with their units.

# Verdict and outcome.
report-title = { $name }: cam report
report-acceptable = Acceptable
report-not-for-high-speed = Not for high speed
report-unacceptable = Unacceptable
report-infeasible = Infeasible
report-conflict = Conflicting limits
report-relaxations = Any one of these changes makes the design feasible
report-no-relaxation = No change of a single limit makes the design feasible
report-relaxation = from { $from } to
report-not-alone = { $limit }, { $from }: not sufficient alone

# Figures at the top.
report-force-error-worst = Largest force error
report-worst-walker = { $walker }; mean { $mean }
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
report-idle-force = The scene gives no mass, spring or preload: force shown for a 1 kg follower.
report-idle-moment = The scene gives no inertia, spring or preload: moment shown for a follower of 1 kg·m².
report-scroll = Scroll sideways for the whole diagram →
report-alt-animation = The cam turning under its follower
report-alt-force = Target and achieved force over the cam angle: { $low } to { $high }, force error { $rms } RMS
report-alt-force-alone = Force over the cam angle: { $low } to { $high }
report-alt-law = Lift, velocity, acceleration and jerk over the cam angle: stroke { $stroke }, acceleration { $acceleration }
report-alt-cam = The cam at θ = 0 with its follower: { $base }, minimum radius of curvature { $radius }
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
report-no-active-limits = No active limits.
report-times = Points
report-multiplier = Largest multiplier (SI)
report-multiplier-note = Lagrange multiplier of the objective; the largest indicates the most restrictive limit.
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
report-roller-radius = roller radius
report-found-at = at
report-concave-radius = minimum concave radius
report-pressure-angle = pressure angle
report-loads = Torque, power and pressure
report-load-factors = Dynamic load factors (harmonics of the force as parts of { $weight } N, phase of sin(kθ − φ))
report-harmonic = harmonic
report-frequency = frequency
report-factor-target = target
report-factor-achieved = achieved
report-hertz-allowable = allowable Hertz pressure
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
report-certified = No law of the family has an objective lower by more than one part in a million.
report-uncertified = Not certified as the optimum: { $why }.
report-certificate = Relative duality gap { $gap }; KKT residual { $stationarity }; constraint violation { $violation }.
report-remarks = Remarks
report-footer = Lengths in millimetres, angles in degrees, θ counter-clockwise from the start of the cycle. Extrema are computed on the continuous law.
report-footer-straight = Lengths in millimetres, angles in degrees, travel from the start of the pass. Extrema are computed on the continuous law.
report-footer-sweep = SI units unless stated. Extrema are computed on the continuous law.

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
report-radius-at-contact = radius at contact
report-phi = pressure angle φ
report-inverted = Shown with the shaft fixed; in the machine the plate is fixed and the shaft rises.

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
report-steady-within = within the turns simulated
report-period-one = period: 1 turn
report-period = period: { $turns } turns
report-alt-simulation = Force, torque and gap of the simulation over the turn: force { $low } to { $high }
report-impacts = Impacts
report-leaves = Lift-off at
report-lands = Contact at
report-impact-speed = Speed
report-impact-gap = Gap
report-impulse = Impulse
report-more-impacts = { $count } more in simulation.json; angles continue over successive turns.
report-next-model = Next richer model: { $difference }.

# Axes and keys of the pictures.
figure-angle = cam angle θ, °
figure-travel = travel, mm
figure-law = law of motion
figure-force = force, N
figure-moment = moment, N·m
figure-error = error, N
figure-error-moment = error, N·m
figure-vertical-force = vertical force
figure-arm-moment = moment on the arm
figure-inertia = inertia, no load given
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
figure-walkers = Force of all walkers, and of the cam for the worst of them
figure-walkers-force = force, % of the mean force
figure-walkers-band = all walkers
figure-walkers-worst = worst: { $name }
figure-walkers-cam = cam, error { $error } RMS
figure-floor = Peak acceleration of the floor, comfort classes
figure-floor-wanted = under the target force
figure-floor-cam = under this cam at other speeds
figure-floor-acceleration = acceleration, m/s²
figure-speeds = the cam as manufactured at other speeds
figure-cam-rpm = speed of the cam, rpm
figure-cam-travel = speed of the cam, m/s
figure-error-rms = error RMS, N
figure-load-factors = load factors
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
figure-curvature = curvature and contact
figure-rho = radius ρ, mm
figure-contact-travel = contact, mm
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
figure-foot-unknown = foot not known
figure-time = time, s
figure-mean-cycle = mean cycle
figure-body-weight = body weight
figure-body-weights = BW
figure-no-stance = no stance is used
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
laws-use-constant-velocity = Between two laws that run at the same velocity, for example the working stroke of a feed. Alone between dwells it makes the velocity jump: use it only with semiharmonic or semicycloidal ends.
laws-use-parabolic = The smallest peak acceleration of all laws for a given lift and time. The acceleration jumps at both ends and in the middle, so it vibrates: low speed only.
laws-use-cubic = Linear acceleration: the simplest polynomial at rest at both ends. The acceleration jumps at the ends: low speed only.
laws-use-simple-harmonic = Low peaks and a smooth middle. Suitable where an equal return follows a rise directly. Beside a dwell the acceleration jumps.
laws-use-double-harmonic = A rise from a dwell that is followed at once by its return: at rest below, with its return of equal acceleration above.
laws-use-cycloidal = Rise between dwells at moderate and high speed: the acceleration is continuous and the jerk finite. Its peak acceleration is high.
laws-use-semiharmonic-start = From rest to a constant velocity with a small peak acceleration; joins a return of equal acceleration at its slow end.
laws-use-semiharmonic-end = From a constant velocity to rest with a small peak acceleration; joins a return of equal acceleration at its slow end.
laws-use-semicycloidal-start = From a dwell to a constant velocity without a jump of the acceleration.
laws-use-semicycloidal-end = From a constant velocity to a dwell without a jump of the acceleration.
laws-use-modified-trapezoid = Small peak acceleration with a continuous acceleration: light followers that are limited by inertia force.
laws-use-modified-sine = Small peak velocity and torque with a continuous acceleration: heavy rotating tables and large masses.
laws-use-scca = The family between modified trapezoid, modified sine and cycloidal: choose the shares b, c, d to trade acceleration against velocity.
laws-use-3-4-5 = The usual polynomial between dwells: smooth acceleration, moderate peaks, easy to cut.
laws-use-4-5-6-7 = Between dwells where the jerk has to start and end at zero: quieter at high speed, with a higher peak acceleration.
laws-use-5-6-7-8-9 = Between dwells where the snap is zero at the ends as well: stiff, fast machines. The peak acceleration is the highest of the three polynomials.
laws-use-polynomial-5 = Joins whatever stands beside it in lift, velocity and acceleration: the piece between two laws that do not fit together.
laws-use-polynomial-7 = As polynomial-5, and the jerk is continuous too.
laws-use-berzak-d = A polynomial of small peak acceleration between dwells (Bautista Morelos 2018); the jerk at its ends is not zero.
laws-use-gutman-1-3 = Two harmonics: smaller peak acceleration than the cycloidal law, with no higher harmonics to excite the follower.
laws-use-freudenstein-1-3 = As commonly printed: its ends are not at rest (v = −1/56), so it joins no dwell. Use freudenstein-1-3-at-rest.
laws-use-freudenstein-1-3-at-rest = Two harmonics with a small peak acceleration, at rest at both ends.
laws-use-freudenstein-1-3-5 = Three harmonics: close to the smallest peak acceleration that a sum of three allows.
laws-use-eccentric = Half a turn of an eccentric disc: the cheapest cam to make. Followed by its own return.

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
report-largest-cutter = largest cutter
report-cutter-fits = R { $radius }, the smallest concave radius
report-any-cutter = any: the profile is convex
report-hollow-and-roller = smallest concave radius
report-times-roller = { $ratio } times the roller radius
report-wall = wall at the bore
report-wall-enough = { $wall } (at least { $least })
report-wall-thin = { $wall }: thinner than { $least }; increase the base radius or reduce the bore

# The table of a run.
simulation-model = model
simulation-why = why
simulation-contact = contact
simulation-contact-kept = kept over the whole turn
simulation-contact-lost = lost for { $percent } % of the motion
simulation-force = force
simulation-error = error to target
simulation-bearings = loads
simulation-bearings-values = normal force at most { $normal } N, side thrust at most { $side } N
simulation-torque = torque
simulation-push = push
simulation-torque-values = { $least } … { $most }, mean { $mean }, RMS { $rms }
simulation-pressure = pressure
simulation-pressure-values = { $pressure } at { $at }, half-width { $width }, largest shear { $depth } deep
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
simulation-starts = from rest at the lowest lift the shaft completes the first turn
simulation-stops = from rest at the lowest lift the shaft stops after { $degrees }°
simulation-any-inertia = it keeps turning with any inertia
simulation-least-inertia = it keeps turning from { $inertia } kg·m² on
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
simulation-unsettled = not within the turns run
simulation-impacts = impacts
simulation-impact-values = { $count } in the run, fastest { $speed } at { $at }, highest bounce { $bounce }
simulation-next-model = next model
simulation-next-failed = { $model } could not be run: { $fault }
simulation-next-rms = , the RMS error by { $rms } N
simulation-next-same = { $model } gives the same to four decimals
simulation-next-changes = { $model } would change the smallest force by { $least } N, the largest by { $most } N{ $error }, the part without contact by { $lost } %
simulation-note = note

# What a log shows of a machine.
identify-head = { $name }: { $cycles } cycles at { $speed }; noise { $noise } N RMS, repeatable force that no parameter explains { $repeats } N RMS
identify-logs = { $name }: { $cycles } cycles of several logs; noise { $noise } N RMS, repeatable force that no parameter explains { $repeats } N RMS
identify-known = { $key } { $value } (95 %: { $low } … { $high })
identify-unknown = { $key } not identified: { $value } (95 %: { $low } … { $high })
identify-scale = no log shows the scale of its load cell: the values hold for a calibrated one
identify-no-angle = without a cam angle the phase of a log is the one at which the model fits best; a delay cannot be separated from it
identify-next = a further log at { $value } ({ $times } times the speed of the first) would identify { $keys }
