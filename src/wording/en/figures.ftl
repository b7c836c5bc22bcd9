# Figures of a design: the row of FIGURES whose column has the name. `movement` is that of the follower or of the cam.
figure-force-rms-error-n = RMS force error
figure-force-rms-error-percent = RMS force error relative to the mean
figure-force-max-error-n = maximum force error
figure-target-mean-n = mean target force
figure-force-mean-n = mean force
figure-force-min-n = minimum force
figure-force-max-n = maximum force
figure-mass-kg = { $movement ->
        [oscillating] moment of inertia
       *[other] moving mass
    }
figure-speed-rad-per-s = speed
figure-stroke-m = stroke
figure-velocity-max-m-per-s = maximum velocity
figure-acceleration-max-m-per-s2 = maximum acceleration
figure-jerk-max-m-per-s3 = maximum jerk
figure-base-radius-m = { $movement ->
        [straight] base height
        [barrel] barrel radius
       *[other] base radius
    }
figure-prime-radius-m = prime radius
figure-radius-min-m = minimum radius of the profile
figure-radius-max-m = maximum radius of the profile
figure-offset-m = offset
figure-rho-min-m = minimum convex radius
figure-pressure-angle-max-rad = maximum pressure angle
figure-face-width-m = face width
figure-torque-max-n-m = maximum torque
figure-torque-rms-n-m = RMS torque
figure-power-max-w = maximum power
figure-power-mean-w = mean power
figure-liftoff-speed-rad-per-s = lift-off speed
figure-hertz-pressure-max-pa = maximum Hertz pressure
figure-shaft-ripple = speed ripple of the shaft
figure-floor-acceleration-peak-m-per-s2 = maximum acceleration of the floor
figure-floor-acceleration-rms-m-per-s2 = RMS acceleration of the floor
figure-worst-walker-percent = force error of the worst walker
