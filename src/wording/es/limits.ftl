# Límites: qué significa la clave, el nombre en los informes y el rótulo en la página.

key-limits-stroke = Carrera máxima.
name-stroke = carrera
label-limits-stroke = Carrera

key-limits-velocity = Velocidad máxima |ds/dt|.
name-velocity = velocidad
label-limits-velocity = Velocidad

key-limits-acceleration = Aceleración máxima |d²s/dt²|.
name-acceleration = aceleración
label-limits-acceleration = Aceleración

key-limits-jerk = Sobreaceleración máxima |d³s/dt³|.
name-jerk = sobreaceleración
label-limits-jerk = Sobreaceleración

key-limits-force_min = Fuerza de contacto mínima. Por defecto: 0 si el contacto se mantiene por fuerza. "none": la fuerza de contacto no se comprueba.
name-force-min = fuerza mínima
label-limits-force_min = Fuerza mínima

key-limits-force_max = Fuerza de contacto máxima.
name-force-max = fuerza máxima
label-limits-force_max = Fuerza máxima

key-limits-curvature = Radio de curvatura convexo mínimo de la leva acabada.
name-curvature = radio de curvatura
label-limits-curvature = Radio mínimo

key-limits-pressure_angle = Ángulo de presión máximo en subida y bajada. Por defecto: los límites del veredicto (30°, con brazo 35°; hasta 45° solo a baja velocidad). "none" desactiva esta comprobación.
name-pressure-angle = ángulo de presión
label-limits-pressure_angle = Ángulo de presión

key-limits-pressure_angle_rise = Ángulo de presión máximo en la subida.
name-pressure-angle-rise = ángulo de presión en la subida
label-limits-pressure_angle_rise = Ángulo de presión, subida

key-limits-pressure_angle_fall = Ángulo de presión máximo en la bajada.
name-pressure-angle-fall = ángulo de presión en la bajada
label-limits-pressure_angle_fall = Ángulo de presión, bajada

key-limits-prime_radius = Radio primario máximo (caras planas: radio base) de una leva de tamaño libre.
name-prime-radius = radio primario
label-limits-prime_radius = Radio primario máximo

key-limits-diameter = Diámetro máximo de la leva terminada: el doble del radio máximo del perfil respecto al eje.
name-diameter = diámetro
label-limits-diameter = Diámetro

key-limits-face_width = Longitud máxima de la cara plana.
name-face-width = longitud de la cara
label-limits-face_width = Longitud de la cara

key-limits-torque = Par máximo en el eje, sin rozamiento.
name-torque = par
label-limits-torque = Par

key-limits-power = Potencia máxima en el eje, motriz o de freno, sin rozamiento.
label-limits-power = Potencia

key-limits-power_mean = Potencia media máxima en el eje, sin rozamiento: la potencia que disipa el amortiguamiento.
name-power-mean = potencia media
label-limits-power_mean = Potencia media

key-limits-torque_rate = Derivada máxima del par del eje respecto al ángulo de la leva.
name-torque-rate = variación del par
label-limits-torque_rate = Variación del par

key-limits-hertz_pressure = Presión de Hertz máxima del contacto lineal, para los materiales de leva y seguidor.
name-hertz-pressure = presión de Hertz
label-limits-hertz_pressure = Presión de Hertz

key-limits-residual = Amplitud máxima de la vibración residual del seguidor al principio de un detenimiento. Se incluyen el muelle y el amortiguamiento.
name-residual = vibración residual
label-limits-residual = Vibración residual
