# Nombres de seguidores, límites, familias y leyes tal como se leen; sin entrada aparecen como se escriben.

# Seguidores.
name-flat-translating = seguidor de traslación de cara plana
name-roller-translating = seguidor de traslación de rodillo
name-knife-translating = seguidor puntual de traslación
name-mushroom-translating = seguidor de traslación de hongo
name-roller-oscillating = seguidor oscilante de rodillo
name-knife-oscillating = seguidor puntual oscilante
name-mushroom-oscillating = seguidor oscilante de hongo
name-flat-oscillating = seguidor oscilante de cara plana
name-translating-cam = rodillo sobre leva de traslación
name-barrel = rodillo en leva cilíndrica

# Materiales.
name-steel = acero
name-cast-iron = fundición
name-bronze = bronce
name-aluminium = aluminio
name-pom = POM
name-pa66 = PA66
name-pla = PLA
name-petg = PETG

# Accionamientos.
name-moving-axis = eje móvil
name-fixed-axis = eje fijo
name-hydraulic = hidráulico

# Límites y comprobaciones.
name-lift = elevación
name-second-curvature = radio de curvatura de la segunda leva
name-second-diameter = diámetro de la segunda leva
name-concave = radio de curvatura cóncavo
name-interference = interferencia
name-second-interference = interferencia de la segunda leva
name-gait-step-frequency = frecuencia de paso
name-cam-prime-radius = radio primario
name-machine-inertia = inercia del eje
name-cam-base-radius = radio base
name-base-circle = círculo base
name-bore = agujero
name-base-outside-bore = radio base fuera del agujero
name-accuracy-rms = error de fuerza admitido
name-rms-error = error de fuerza
name-band = banda de fuerza
name-monotone = monotonía
name-peak = valor máximo
name-upper-wall = radio de la pared superior
name-lower-wall = radio de la pared inferior
name-second-concave = radio de curvatura cóncavo de la segunda leva
name-second-pressure-angle-rise = ángulo de presión en la subida de la segunda leva
name-second-pressure-angle-fall = ángulo de presión en la bajada de la segunda leva

# Familias de leyes.
name-spline = spline
name-polynomial = polinomio
name-harmonic = armónica
name-double-harmonic = doble armónica
name-inverse-by-harmonics = la solución inversa por armónicos
name-program = programa

# Leyes de subida.
name-dwell = detenimiento
name-constant-velocity = velocidad constante
name-parabolic = parabólica
name-cubic = cúbica
name-simple-harmonic = armónica simple
name-cycloidal = cicloidal
name-semiharmonic-start = semiarmónica inicial
name-semiharmonic-end = semiarmónica final
name-semicycloidal-start = semicicloidal inicial
name-semicycloidal-end = semicicloidal final
name-modified-trapezoid = trapezoidal modificada
name-modified-sine = sinusoidal modificada
name-scca = SCCA
name-3-4-5 = 3-4-5
name-4-5-6-7 = 4-5-6-7
name-5-6-7-8-9 = 5-6-7-8-9
name-polynomial-5 = polinómica de grado 5
name-polynomial-7 = polinómica de grado 7
name-berzak-d = Berzak D
name-gutman-1-3 = Gutman 1-3
name-freudenstein-1-3 = Freudenstein 1-3
name-freudenstein-1-3-at-rest = Freudenstein 1-3 en reposo
name-freudenstein-1-3-5 = Freudenstein 1-3-5
name-eccentric = excéntrica

# Tamaño de la ley.
name-spans = tramos
name-harmonics = armónicos

# Objetivos y veredictos.
name-rms-error-n = error de fuerza (RMS)
name-weighted-rms-error-n = error de fuerza ponderado (RMS)
name-max-error-n = error de fuerza (máximo)
name-radius-m = radio
name-rms-derivative-2 = aceleración (RMS)
name-rms-derivative-3 = sobreaceleración (RMS)
name-rms-derivative-4 = cuarta derivada (RMS)
name-peak-derivative-2 = aceleración máxima
name-peak-derivative-3 = sobreaceleración máxima
name-peak-derivative-4 = cuarta derivada máxima
name-acceptable = aceptable
name-not-for-high-speed = no apta para alta velocidad
name-unacceptable = inaceptable

# Elecciones de un modelo.
name-family = familia
name-solver = método
name-dynamics = dinámica
name-points = puntos

# Niveles del método.
name-spectral = espectral
name-equality = de igualdades
name-qp = QP
name-socp = SOCP
name-scp = SCP

# Modelos de una simulación.
name-rigid = rígido
name-flexible = flexible
name-contact = contacto

# Lo que admite una clave.
name-or = o
name-number = número
name-text = texto
name-text-or-list = texto o lista de textos
