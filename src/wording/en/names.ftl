# Names of followers, limits, families and laws where people read them; without a row they show as typed.

# Followers.
name-flat-translating = flat-translating
name-roller-translating = roller-translating
name-knife-translating = knife-translating
name-mushroom-translating = mushroom-translating
name-roller-oscillating = roller-oscillating
name-knife-oscillating = knife-oscillating
name-mushroom-oscillating = mushroom-oscillating
name-flat-oscillating = flat-oscillating
name-translating-cam = translating-cam
name-barrel = barrel

# Materials.
name-steel = steel
name-cast-iron = cast iron
name-bronze = bronze
name-aluminium = aluminium
name-pom = POM
name-pa66 = PA66
name-pla = PLA
name-petg = PETG

# Drives.
name-moving-axis = moving-axis
name-fixed-axis = fixed-axis
name-hydraulic = hydraulic

# Limits and checks.
name-lift = lift
name-second-curvature = second_curvature
name-second-diameter = second_diameter
name-concave = concave
name-interference = interference
name-second-interference = second_interference
name-gait-step-frequency = step frequency
name-cam-prime-radius = cam.prime_radius
name-machine-inertia = machine.inertia
name-cam-base-radius = cam.base_radius
name-base-circle = base_circle
name-bore = bore
name-base-outside-bore = base_outside_bore
name-accuracy-rms = accuracy.rms
name-rms-error = rms_error
name-band = band
name-monotone = monotone
name-peak = peak
name-upper-wall = upper_wall
name-lower-wall = lower_wall
name-second-concave = second_concave
name-second-pressure-angle-rise = second_pressure_angle_rise
name-second-pressure-angle-fall = second_pressure_angle_fall

# Families of laws.
name-spline = spline
name-polynomial = polynomial
name-harmonic = harmonic
name-double-harmonic = double-harmonic
name-inverse-by-harmonics = the inverse solution by harmonics
name-program = program

# Rise laws.
name-dwell = dwell
name-constant-velocity = constant-velocity
name-parabolic = parabolic
name-cubic = cubic
name-simple-harmonic = simple-harmonic
name-cycloidal = cycloidal
name-semiharmonic-start = semiharmonic-start
name-semiharmonic-end = semiharmonic-end
name-semicycloidal-start = semicycloidal-start
name-semicycloidal-end = semicycloidal-end
name-modified-trapezoid = modified-trapezoid
name-modified-sine = modified-sine
name-scca = scca
name-3-4-5 = 3-4-5
name-4-5-6-7 = 4-5-6-7
name-5-6-7-8-9 = 5-6-7-8-9
name-polynomial-5 = polynomial-5
name-polynomial-7 = polynomial-7
name-berzak-d = berzak-d
name-gutman-1-3 = gutman-1-3
name-freudenstein-1-3 = freudenstein-1-3
name-freudenstein-1-3-at-rest = freudenstein-1-3-at-rest
name-freudenstein-1-3-5 = freudenstein-1-3-5
name-eccentric = eccentric

# Size of a law.
name-spans = spans
name-harmonics = harmonics

# Objectives and verdicts.
name-rms-error-n = force error (RMS)
name-weighted-rms-error-n = weighted force error (RMS)
name-max-error-n = force error (maximum)
name-radius-m = radius
name-rms-derivative-2 = acceleration (RMS)
name-rms-derivative-3 = jerk (RMS)
name-rms-derivative-4 = snap (RMS)
name-peak-derivative-2 = peak acceleration
name-peak-derivative-3 = peak jerk
name-peak-derivative-4 = peak snap
name-acceptable = acceptable
name-not-for-high-speed = not-for-high-speed
name-unacceptable = unacceptable

# Choices of a model.
name-family = family
name-solver = solver
name-dynamics = dynamics
name-points = points

# Tiers of the solver.
name-spectral = spectral
name-equality = equality
name-qp = qp
name-socp = socp
name-scp = scp

# Models of a run.
name-rigid = rigid
name-flexible = flexible
name-contact = contact

# Values of keys.
name-or = or
name-number = number
name-text = text
name-text-or-list = text or list of texts
