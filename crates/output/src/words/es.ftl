# Informe e imágenes de un diseño: títulos, rótulos y leyendas. Los argumentos llegan como texto con sus unidades.

# Veredicto y resultado.
report-title = { $name }: informe de la leva
report-acceptable = Aceptable
report-not-for-high-speed = No apta para alta velocidad
report-unacceptable = Inaceptable
report-infeasible = No factible
report-conflict = Límites incompatibles
report-relaxations = Cada uno de estos cambios hace factible el diseño
report-no-relaxation = Ningún cambio de un solo límite hace factible el diseño
report-relaxation = de { $from } a
report-not-alone = { $limit }, { $from }: no basta por sí solo

# Cifras del encabezado.
report-force-error-worst = Error de fuerza máximo
report-worst-walker = { $walker }; media { $mean }
report-exact = exacto
report-of-mean = { $percent } % de la media
report-force = Fuerza
report-moment = Momento
report-mean = media { $value }
report-at = en { $place }

# Diagramas.
report-animation = Animación
report-force-section = Fuerza
report-recording-section = Registro
report-alt-recording = Registro { $file }: fuerza en el tiempo con { $used } contactos usados y { $rejected } rechazados, y los apoyos medios de los pies.
report-moment-section = Momento en el brazo
report-law-section = Ley de movimiento
report-cam-section = Leva y seguidor
report-curvature-section = Curvatura y contacto
report-target = Objetivo: { $name }. Error de fuerza { $rms } RMS, { $most } máximo.
report-variability = Variabilidad entre pasos del registro: { $spread } (RMS de la desviación típica).
report-variability-ratio = Variabilidad entre pasos del registro: { $spread } (RMS de la desviación típica), { $ratio } veces el error de fuerza.
report-idle-force = La escena no tiene masa, muelle ni precarga. Se muestra la fuerza de un seguidor de 1 kg.
report-idle-moment = La escena no tiene inercia, muelle ni precarga. Se muestra el momento de un seguidor de 1 kg·m².
report-scroll = Desplace lateralmente para ver el diagrama completo →
report-alt-animation = La leva girando bajo su seguidor
report-alt-force = Fuerza objetivo y obtenida según el ángulo de leva: { $low } a { $high }, error de fuerza { $rms } RMS
report-alt-force-alone = Fuerza según el ángulo de leva: { $low } a { $high }
report-alt-law = Elevación, velocidad, aceleración y sobreaceleración según el ángulo de leva: carrera { $stroke }, aceleración { $acceleration }
report-alt-cam = La leva en θ = 0 con su seguidor: { $base }, radio de curvatura mínimo { $radius }
report-alt-curvature = Radio de curvatura y contacto según el ángulo de leva: radio mínimo { $radius } en { $place }

# Comprobaciones y límites activos.
report-checks = Comprobaciones
report-check = Comprobación
report-state = Estado
report-worst = Valor más desfavorable
report-limit = Límite
report-margin = Margen
report-place = En
report-satisfied = cumplido
report-at-limit = en el límite
report-violated = incumplido
report-active-limits = Límites activos
report-no-active-limits = Ningún límite restringe la ley.
report-times = Puntos
report-multiplier = Multiplicador máximo (SI)
report-multiplier-note = Multiplicador de Lagrange del objetivo; el límite más restrictivo tiene el multiplicador máximo.
report-sensitivity = Sensibilidad: cada límite ampliado un 1 %
report-from = De
report-to = A
report-objective = Objetivo
report-now = Actual
report-predicted = Previsto

# Tablas del diseño.
report-data = Datos del diseño
report-drive = Accionamiento
report-law = Ley
report-cam = Leva
report-machine = máquina
report-one-turn = una vuelta
report-one-pass = una pasada
report-force-at-rest = fuerza estática
report-moment-at-rest = momento estático
report-spring = rigidez del muelle
report-column = rigidez de la columna de fluido
report-damping = amortiguamiento
report-family = familia
report-pieces = tramos
report-degree = grado
report-velocity = velocidad
report-velocity-time = velocidad (por segundo)
report-acceleration = aceleración
report-acceleration-time = aceleración (por segundo)
report-jerk = sobreaceleración
report-jerk-time = sobreaceleración (por segundo)
report-follower = seguidor
report-profile-radii = radios del perfil
report-roller-radius = radio del rodillo
report-found-at = en
report-concave-radius = radio cóncavo mínimo
report-pressure-angle = ángulo de presión
report-loads = Par, potencia y presión
report-load-factors = Factores de carga dinámica (armónicos de la fuerza relativos a { $weight } N, fase de sen(kθ − φ))
report-harmonic = armónico
report-frequency = frecuencia
report-factor-target = objetivo
report-factor-achieved = obtenido
report-hertz-allowable = presión de Hertz admisible
report-material-borne = { $pressure } MPa, margen { $margin }
report-hertz-borne = { $pressure } MPa ({ $hardness }, 10⁸ contactos), margen { $margin }

# Solución.
report-solution = Solución
report-attempt = Solución intentada
report-spectral = Solución espectral en forma cerrada
report-equality = Mínimos cuadrados con restricciones de igualdad
report-qp = Programa cuadrático convexo
report-socp = Programa cónico de segundo orden
report-scp = Secuencia de programas convexos
report-solved = { $how }: { $time }, { $iterations ->
        [one] { $iterations } iteración
       *[other] { $iterations } iteraciones
    }.
report-verified = Todos los límites están verificados en la ley continua.
report-certified = Ninguna ley de la familia reduce el objetivo en más de una parte en un millón.
report-uncertified = La ley no se certifica como óptima: { $why }.
report-certificate = Brecha de dualidad relativa { $gap }, error de optimalidad { $stationarity }, violación de restricciones { $violation }.
report-remarks = Observaciones
report-footer = Las longitudes están en { $unit ->
        [in] pulgadas
       *[mm] milímetros
    } y los ángulos en grados. θ se mide en sentido antihorario desde el inicio del ciclo. Los extremos se calculan en la ley continua.
report-footer-straight = Las longitudes están en { $unit ->
        [in] pulgadas
       *[mm] milímetros
    } y los ángulos en grados. El recorrido se mide desde el inicio de la pasada. Los extremos se calculan en la ley continua.
report-footer-sweep = Cada valor lleva su unidad. Los extremos se calculan en la ley continua.

# Animación.
report-play = Reproducir
report-pause = Pausa
report-pace = velocidad
report-full-speed = velocidad real
report-of-full-speed = de la velocidad real
report-angle = ángulo de leva
report-travel = recorrido de la leva
report-lift = elevación s
report-now-force = fuerza F
report-now-moment = momento en el brazo
report-torque = par en el eje T
report-push = fuerza a lo largo del recorrido
report-gap = separación
report-radius-at-contact = radio de curvatura en el contacto
report-phi = ángulo de presión φ
report-inverted = El eje se muestra fijo; en la máquina la placa está fija y el eje sube.

# Simulación.
report-simulation = Simulación
report-simulated = Simulado con el modelo { $model ->
        [rigid] rígido
        [flexible] flexible
        [contact] de contacto
       *[other] { $model }
    }: { $why }.
report-contact = Contacto
report-contact-lost = perdido
report-contact-kept = mantenido
report-lost-share = { $percent } % del movimiento
report-kept-share = durante todo el ciclo
report-contact-force = Fuerza de contacto
report-error-of-target = error de fuerza { $rms } RMS
report-shaft-torque = Par en el eje
report-cam-push = Fuerza a lo largo del recorrido
report-rms = RMS { $value }
report-liftoff = Velocidad de pérdida de contacto
report-liftoff-none = ninguna
report-runs-at = velocidad de funcionamiento { $speed }
report-steady = Régimen permanente
report-steady-first = en la primera vuelta
report-steady-after = tras { $turns ->
        [one] { $turns } vuelta
       *[other] { $turns } vueltas
    }
report-steady-not = no alcanzado
report-steady-within = en las vueltas simuladas
report-period-one = período: 1 vuelta
report-period = período: { $turns } vueltas
report-alt-simulation = Fuerza, par y separación de la simulación en la vuelta: fuerza { $low } a { $high }
report-impacts = Impactos
report-leaves = Pérdida de contacto en
report-lands = Contacto en
report-impact-speed = Velocidad
report-impact-gap = Separación
report-impulse = Impulso
report-more-impacts = simulation.json contiene { $count } impactos más. Los ángulos se cuentan de forma continua en las vueltas sucesivas.
report-next-model = Modelo siguiente, más detallado: { $difference }.

# Ejes y leyendas de las imágenes.
figure-angle = ángulo de leva θ, °
figure-travel = recorrido, { $unit }
figure-law = ley de movimiento
figure-force = fuerza, N
figure-moment = momento, N·m
figure-error = error, N
figure-error-moment = error, N·m
figure-vertical-force = fuerza vertical
figure-arm-moment = momento en el brazo
figure-inertia = fuerza de inercia sin carga
figure-target = objetivo
figure-achieved = obtenida
figure-force-alone = fuerza
figure-moment-alone = momento
figure-force-of-unit = fuerza de un seguidor de 1 kg
figure-moment-of-unit = momento de un seguidor de 1 kg·m²
figure-difference = error
figure-difference-rms = error, RMS { $rms } ({ $percent } % de la media)
figure-tolerance-band = banda de tolerancia
figure-step-band = ± DT, entre pasos
figure-rigid = rígido
figure-constant-speed = a velocidad constante
figure-walkers = Fuerza de todos los caminantes, y de la leva para el peor caminante
figure-walkers-force = fuerza, % de la fuerza media
figure-walkers-band = todos los caminantes
figure-walkers-worst = peor caminante: { $name }
figure-walkers-cam = leva, error { $error } RMS
figure-floor = Aceleración máxima del suelo, clases de confort
figure-floor-wanted = con la fuerza objetivo
figure-floor-cam = con esta leva a otras velocidades
figure-floor-acceleration = aceleración, m/s²
figure-resonance = Respuesta de un modo con { $damping } % de amortiguamiento
figure-resonance-recorded = marcha registrada
figure-resonance-generated = marcha generada
figure-resonance-cam = leva a velocidad constante
figure-resonance-strides = { $count } zancadas, repetidas
figure-resonance-programme = leva con programa
figure-resonance-acceleration = aceleración RMS, modo de 1 kg, m/s²
figure-resonance-frequency = frecuencia del modo, Hz
resonance-severity = En resonancia con { $damping } % de amortiguamiento, esta leva a velocidad constante es { $ratio } veces tan severa como la marcha registrada.
resonance-severity-few = En resonancia con { $damping } % de amortiguamiento, esta leva a velocidad constante es al menos { $ratio } veces tan severa como la marcha registrada. El registro tiene { $strides } zancadas, pero este amortiguamiento requiere { $needed }.
report-resonance-section = Marcha registrada y leva en resonancia
report-resonance-damping = amortiguamiento
report-resonance-recorded = marcha registrada, m/s²
report-resonance-cam = esta leva, m/s²
report-resonance-ratio = cociente
report-resonance-note = La tabla contiene la máxima aceleración RMS de un modo con una masa modal de 1 kg en vibración estacionaria. La frecuencia natural es de 0,9 a 1,1 veces la frecuencia de paso. La marcha registrada son { $strides } zancadas consecutivas ({ $frequency } Hz), repetidas periódicamente. La leva gira a velocidad constante. Los pasos de una persona varían, pero los de una leva no. gaitcam walk calcula un programa de velocidad que varía los pasos de la leva.
figure-speeds = la leva fabricada, a otras velocidades
figure-cam-rpm = velocidad de la leva, rpm
figure-cam-travel = velocidad de la leva, m/s
figure-error-rms = error RMS, N
figure-first-factor = factor de carga 1
figure-higher-factors = factores 2 a 4
figure-torque-largest = par, N·m
figure-ripple = oscilación, %
figure-harmonic = armónico { $number }
figure-contact-lost = contacto perdido
figure-step-frequency = frecuencia de paso, Hz
figure-shaft-speed = ω, rad/s
figure-simulated = simulado
figure-torque = par, N·m
figure-push = fuerza, N
figure-gap = separación, { $unit }
figure-pressure = presión de contacto { $range } MPa
figure-curvature = curvatura y contacto
figure-rho = radio ρ, { $unit }
figure-contact-travel = contacto, { $unit }
figure-pressure-angle = ángulo de presión, °
figure-limit = límite { $value }
figure-cam = la leva en θ = 0
figure-profile = perfil de la leva
figure-second-profile = segunda leva del par
figure-walls = paredes de la ranura, desarrolladas
figure-base-circle = círculo base R { $radius }
figure-prime-circle = círculo primario R { $radius }
figure-pitch-curve = curva de paso
figure-contact = contacto en θ = 0
figure-sharpest = radio mínimo
figure-stance-share = fracción del apoyo, % (media { $seconds } s)
figure-one-stance = un apoyo
figure-mean-of-stances = media de { $count } apoyos
figure-sd = ± 1 DT
figure-left = izquierdo
figure-right = derecho
figure-foot-unknown = pie desconocido
figure-time = tiempo, s
figure-mean-cycle = ciclo medio
figure-body-weight = peso corporal
figure-body-weights = PC
figure-no-stance = no se usa ningún apoyo
figure-joint-mean = media conjunta de { $count } registros
figure-joint-facts = { $cycles } ciclos · zancada { $seconds } s · masa { $mass } kg
figure-each-recording = cada registro
figure-more-notes = { $count ->
        [one] y una nota más
       *[other] y { $count } notas más
    }
figure-stride = zancada { $seconds } s ({ $from })
figure-stride-spread = zancada { $seconds } ± { $spread } s ({ $from })
figure-mass = masa { $mass } kg ({ $from })
figure-contacts = contactos: { $used } usados, { $rejected } rechazados
figure-designs = diseños
figure-non-dominated = no dominados
figure-best = mejor compromiso

# La hoja de la leva en el libro de cálculo.
sheet-title = Leva de disco, { $follower }
sheet-base-radius = Radio base { $value }
sheet-prime-radius = Radio primario { $value }
sheet-roller-radius = Radio del rodillo { $value }
sheet-offset = Excentricidad { $value }
sheet-speed = Velocidad { $value }
sheet-travel = Recorrido, mm
sheet-angle = Ángulo de la leva, °
sheet-lift = Elevación, { $unit }
sheet-velocity = Velocidad, { $unit }/s
sheet-acceleration = Aceleración, { $unit }/s²
sheet-jerk = Sobreaceleración, { $unit }/s³
sheet-curvature = Radio de curvatura, mm
sheet-contour-radius = Contorno, radio, mm
sheet-contour-angle = Contorno, ángulo, °
sheet-contour-x = Contorno, x, mm
sheet-contour-y = Contorno, y, mm
sheet-contact-left = Contacto a la izquierda del centro, mm
sheet-contact-right = Contacto a la derecha del centro, mm
sheet-pressure-angle = Ángulo de presión, °
sheet-pitch-radius = Curva de paso, radio, mm
sheet-pitch-angle = Curva de paso, ángulo, °
sheet-pitch-x = Curva de paso, x, mm
sheet-pitch-y = Curva de paso, y, mm

# El catálogo de leyes de subida.
laws-use-constant-velocity = Úsela entre dos leyes con la misma velocidad, por ejemplo para la carrera de trabajo de un avance. Junto a un detenimiento su velocidad es discontinua, así que intercale ahí extremos semiarmónicos o semicicloidales.
laws-use-parabolic = Tiene la mínima aceleración de pico de todas las leyes para una elevación y un tiempo dados. Úsela solo a baja velocidad, porque la aceleración es discontinua en los extremos y en el centro.
laws-use-cubic = Es el polinomio más simple con reposo en ambos extremos. Úselo solo a baja velocidad, porque la aceleración es discontinua en los extremos.
laws-use-simple-harmonic = Sus valores de pico son bajos. Úsela para una subida a la que sigue directamente un retorno igual. Junto a un detenimiento su aceleración es discontinua.
laws-use-double-harmonic = Úsela para una subida desde un detenimiento a la que sigue directamente su retorno. El inicio está en reposo; arriba, subida y retorno tienen la misma aceleración.
laws-use-cycloidal = Úsela entre detenimientos a velocidad media y alta. La aceleración es continua y la sobreaceleración finita. La aceleración de pico es alta.
laws-use-semiharmonic-start = Lleva del reposo a una velocidad constante con una aceleración de pico baja. Su aceleración inicial no es cero, de modo que puede seguir a una bajada que termine con la misma aceleración.
laws-use-semiharmonic-end = Lleva de una velocidad constante al reposo con una aceleración de pico baja. Su aceleración final no es cero, de modo que un retorno debe empezar con la misma aceleración.
laws-use-semicycloidal-start = Lleva de un detenimiento a una velocidad constante con aceleración continua.
laws-use-semicycloidal-end = Lleva de una velocidad constante a un detenimiento con aceleración continua.
laws-use-modified-trapezoid = Su aceleración es baja y continua. Úsela para seguidores ligeros limitados por la fuerza de inercia.
laws-use-modified-sine = Su velocidad y su par de pico son bajos, y su aceleración es continua. Úsela para mesas giratorias pesadas y grandes masas.
laws-use-scca = Esta familia incluye la trapezoidal modificada, la sinusoidal modificada y la cicloidal. Use las partes b, c y d para equilibrar aceleración y velocidad.
laws-use-3-4-5 = Es el polinomio habitual entre detenimientos. La aceleración es continua, los picos son moderados y la leva es fácil de fabricar.
laws-use-4-5-6-7 = Úselo entre detenimientos si la sobreaceleración debe ser cero en ambos extremos. Es más silencioso a alta velocidad, pero su aceleración de pico es mayor.
laws-use-5-6-7-8-9 = Úselo entre detenimientos si también la derivada de la sobreaceleración debe ser cero en los extremos, como en máquinas rígidas y rápidas. Su aceleración de pico es la mayor de los tres polinomios.
laws-use-polynomial-5 = Enlaza en elevación, velocidad y aceleración con ambos vecinos. Úselo entre dos leyes que no pueden unirse directamente.
laws-use-polynomial-7 = Enlaza en elevación, velocidad, aceleración y sobreaceleración con ambos vecinos. Úselo como polynomial-5 si también la sobreaceleración debe ser continua.
laws-use-berzak-d = Es un polinomio con poca aceleración de pico para usarlo entre detenimientos (Bautista Morelos 2018). La sobreaceleración en sus extremos no es cero.
laws-use-gutman-1-3 = Es una suma de dos armónicos. Su aceleración de pico es menor que la de la cicloidal, y no tiene armónicos superiores que exciten el seguidor.
laws-use-freudenstein-1-3 = Es la ley Freudenstein 1-3 como suele imprimirse. Sus extremos no están en reposo (v = −1/56), así que no enlaza con un detenimiento. Use freudenstein-1-3-at-rest.
laws-use-freudenstein-1-3-at-rest = Es una suma de dos armónicos con poca aceleración de pico y reposo en ambos extremos.
laws-use-freudenstein-1-3-5 = Es una suma de tres armónicos. Su aceleración de pico es casi la mínima con tres armónicos.
laws-use-eccentric = Es media vuelta de un disco excéntrico, la leva más barata de fabricar. El retorno debe seguir directamente, en la otra mitad del disco.

# La imagen de una leva medida.
figure-identification = máquina identificada
figure-measured = medida
figure-modelled = modelada
figure-residual = residuo
figure-inspection = perfil medido
figure-deviation = desviación según la normal, µm
figure-inspected-force = fuerza
figure-as-made = fabricada
figure-as-designed = según diseño
figure-exaggerated = fabricada, desviaciones × { $factor }

# Taller.
report-workshop = Taller
report-cutting = Mecanizado
report-largest-cutter = radio máximo de fresa
report-cutter-fits = R { $radius }, el radio cóncavo mínimo
report-any-cutter = cualquiera, porque el perfil es convexo
report-hollow-and-roller = radio cóncavo mínimo
report-times-roller = { $ratio } veces el radio del rodillo
report-wall = pared en el agujero
report-wall-enough = { $wall } (como mínimo { $least })
report-wall-thin = { $wall }, menos de { $least }: aumente el radio base o reduzca el agujero

# La tabla de una simulación.
simulation-model = modelo
simulation-why = motivo
simulation-contact = contacto
simulation-contact-kept = mantenido durante toda la vuelta
simulation-contact-lost = perdido durante el { $percent } % del movimiento
simulation-force = fuerza
simulation-error = error respecto al objetivo
simulation-bearings = cargas
simulation-bearings-values = fuerza normal hasta { $normal } N, empuje lateral hasta { $side } N
simulation-torque = par
simulation-push = empuje
simulation-torque-values = { $least } … { $most }, media { $mean }, RMS { $rms }
simulation-pressure = presión
simulation-pressure-values = { $pressure } en { $at }, semianchura { $width }, tensión cortante máxima a { $depth } bajo la superficie
simulation-floor = suelo
simulation-floor-values = máximo { $peak } m/s², { $rms } m/s² RMS; clase de confort { $class } (HiVoSS), confort { $setra ->
    [maximum] máximo
    [mean] medio
    [minimum] mínimo
   *[unacceptable] inaceptable
} (SETRA)
simulation-speed = velocidad del eje
simulation-speed-values = { $least } … { $most } rad/s, oscilación { $ripple } %
simulation-motor = motor
simulation-motor-values = velocidad en vacío { $noload } rad/s en el eje de la leva, par RMS { $rms } N·m, máximo { $most } N·m, potencia media { $power } W
simulation-start = arranque
simulation-starts = si arranca del reposo con elevación mínima, el eje completa la primera vuelta
simulation-stops = si arranca del reposo con elevación mínima, el eje se para a los { $degrees }°
simulation-any-inertia = el eje sigue girando con cualquier inercia
simulation-least-inertia = el eje sigue girando con al menos { $inertia } kg·m²
simulation-lift-off = pérdida de contacto
simulation-never = a ninguna velocidad
simulation-settles = régimen
simulation-settled = { $turns ->
        [0] en la primera vuelta
        [one] después de { $turns } vuelta
       *[other] después de { $turns } vueltas
    }; se repite cada { $period ->
        [one] vuelta
       *[other] { $period } vueltas
    }
simulation-unsettled = no alcanzado en las vueltas simuladas
simulation-impacts = impactos
simulation-impact-values = { $count } en este ensayo, velocidad máxima { $speed } en { $at }, rebote máximo { $bounce }
simulation-next-model = modelo siguiente
simulation-next-failed = la simulación con { $model } falló: { $fault }
simulation-next-rms = , el error RMS en { $rms } N
simulation-next-same = { $model } da los mismos resultados con cuatro decimales
simulation-next-changes = { $model } cambiaría la fuerza mínima en { $least } N, la máxima en { $most } N{ $error }, la fracción sin contacto en { $lost } %
simulation-note = nota

# Identificación de una máquina a partir de sus registros.
identify-head = { $name }: { $cycles } ciclos a { $speed }; ruido { $noise } N RMS, fuerza repetible no explicada { $repeats } N RMS
identify-logs = { $name }: { $cycles } ciclos de varios registros; ruido { $noise } N RMS, fuerza repetible no explicada { $repeats } N RMS
identify-known = { $key } { $value } (95 %: { $low } … { $high })
identify-unknown = { $key } no identificado: { $value } (95 %: { $low } … { $high })
identify-scale = los registros no determinan la escala de la célula de carga; los valores valen para una célula calibrada
identify-no-angle = en un registro sin ángulo de la leva se ajusta la fase, así que no se puede identificar un retardo
identify-next = otro registro a { $value } ({ $times } veces la primera velocidad) identificaría { $keys }
