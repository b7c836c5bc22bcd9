# Limits: what the key means, the name in reports and the label on the page.

key-limits-stroke = Maximum stroke.
name-stroke = stroke
label-limits-stroke = Stroke

key-limits-velocity = Maximum velocity |ds/dt|.
name-velocity = velocity
label-limits-velocity = Velocity

key-limits-acceleration = Maximum acceleration |d²s/dt²|.
name-acceleration = acceleration
label-limits-acceleration = Acceleration

key-limits-jerk = Maximum jerk |d³s/dt³|.
name-jerk = jerk
label-limits-jerk = Jerk

key-limits-force_min = Minimum contact force. Default: 0 if the contact is force-closed. "none": the contact force is not checked.
name-force-min = force_min
label-limits-force_min = Minimum force

key-limits-force_max = Maximum contact force.
name-force-max = force_max
label-limits-force_max = Maximum force

key-limits-curvature = Minimum convex radius of curvature of the finished cam.
name-curvature = curvature
label-limits-curvature = Minimum radius

key-limits-pressure_angle = Maximum pressure angle during rise and fall. Default: the bounds of the verdict (30°, for an arm 35°; up to 45° for low speed only). "none" switches this check off.
name-pressure-angle = pressure_angle
label-limits-pressure_angle = Pressure angle

key-limits-pressure_angle_rise = Maximum pressure angle during the rise.
name-pressure-angle-rise = pressure_angle_rise
label-limits-pressure_angle_rise = Pressure angle, rise

key-limits-pressure_angle_fall = Maximum pressure angle during the fall.
name-pressure-angle-fall = pressure_angle_fall
label-limits-pressure_angle_fall = Pressure angle, fall

key-limits-prime_radius = Maximum prime radius (flat faces: base radius) of a cam whose size is free.
name-prime-radius = prime_radius
label-limits-prime_radius = Maximum prime radius

key-limits-diameter = Maximum diameter of the finished cam: twice the maximum radius of its profile about the shaft.
name-diameter = diameter
label-limits-diameter = Diameter

key-limits-face_width = Maximum length of the flat face.
name-face-width = face_width
label-limits-face_width = Face width

key-limits-torque = Maximum shaft torque, without friction.
name-torque = torque
label-limits-torque = Torque

key-limits-power = Maximum shaft power, driving or braking, without friction.
label-limits-power = Power

key-limits-power_mean = Maximum mean power of the shaft, without friction: the power dissipated by damping.
name-power-mean = power_mean
label-limits-power_mean = Mean power

key-limits-torque_rate = Maximum rate of change of the shaft torque with respect to the cam angle.
name-torque-rate = torque_rate
label-limits-torque_rate = Torque rate

key-limits-hertz_pressure = Maximum Hertz pressure of the line contact, for the materials of cam and follower.
name-hertz-pressure = hertz_pressure
label-limits-hertz_pressure = Hertz pressure

key-limits-residual = Maximum amplitude of the residual vibration of the follower at the start of a dwell. The return spring and the damping are included.
name-residual = residual
label-limits-residual = Residual vibration
