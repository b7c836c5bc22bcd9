# Razones del veredicto sobre un diseño.
reason-out-of-time = El límite de tiempo terminó la búsqueda; esta es la mejor leva hallada. Permita más tiempo con --time-limit.
reason-all-hold = Se cumplen todos los límites; elevación, velocidad y aceleración son continuas en todo el ciclo.
reason-mean-force = La fuerza objetivo media es { $mean }, pero el peso de la masa es { $weight }. Una leva no puede cambiar la fuerza media de una vuelta, de modo que el error de fuerza es como mínimo { $error } RMS. Fije drive.mass = "auto" o gait.scale = "to-mass".
reason-recording-kind = No está claro qué movimiento contiene el registro: { $because }. Indique { $keys }, o gait.accept = "kind" si el movimiento es correcto.
reason-recording-clock = La escala de tiempo del registro no está clara: { $because }. Indique { $keys }, o gait.accept = "clock" si la escala es correcta.
reason-recording-mass = La masa de la persona y la escala de las fuerzas no están claras: { $because }. Indique { $keys }, o gait.accept = "mass" si masa y escala son correctas.
reason-recording-clipped = El registro está recortado: { $because }. Sus picos y la masa son demasiado bajos, y gait.accept no permite un registro recortado. Registre de nuevo con un rango mayor, o excluya la columna ({ $keys }).
reason-lift-jumps = La elevación es discontinua en { $at }; ningún seguidor puede seguirla. Prescriba la misma elevación a ambos lados.
reason-velocity-jumps = La velocidad es discontinua en { $at }, lo que causa aceleración infinita y un impacto del seguidor. Prescriba la misma velocidad a ambos lados (law.point.N.velocity).
reason-acceleration-jumps = La aceleración es discontinua en { $at }, lo que causa sobreaceleración infinita y vibración a alta velocidad.
reason-lifts-off = La fuerza de contacto mínima es −{ $pull } en { $at }, así que el seguidor pierde el contacto por encima de { $speed }. Fije limits.force_min = "0 N" para mantener el contacto.
reason-lifts-off-as-prescribed = La fuerza de contacto mínima es −{ $pull } en { $at }, así que el seguidor pierde el contacto por encima de { $speed }. Haga girar la leva más despacio o prescriba una deceleración menor en ese punto.
reason-contact-lost = La fuerza de contacto mínima es −{ $pull } en { $at }, así que el seguidor pierde el contacto. Fije un drive.spring_rate o un drive.preload mayor, o un drive.speed menor.
reason-contact-lost-in-run = En este ensayo el seguidor está sin contacto con la leva durante { $share } del movimiento. Fije un drive.spring_rate o un drive.preload mayor, o un drive.speed menor.
reason-cusp = El perfil tiene una cúspide (radio de curvatura nulo) en { $at }. Fije limits.curvature.
reason-undercut = El perfil presenta rebaje en { $at }; su radio de curvatura convexo sería { $radius }.
reason-too-sharp = El radio de curvatura en { $at } es { $radius }; el mínimo es { $allowed }.
reason-second-too-sharp = El radio de curvatura de la segunda leva en { $at } es { $radius }; el mínimo es { $allowed }. Aleje su seguidor del eje.
reason-base-radius-works = Esta ley necesita un radio base de { $radius }.
reason-enlarge-base-circle = Aumente el círculo base (cam.base_radius) o use un rodillo más pequeño (cam.roller_radius).
reason-lengthen-travel = Aumente la longitud del recorrido (cam.travel) o use un rodillo más pequeño (cam.roller_radius).
reason-interference = En { $at } el seguidor interfiere con otra parte de la leva en { $depth }. Use un rodillo más pequeño (cam.roller_radius) o aumente el círculo base (cam.base_radius).
reason-sharp-wall = El radio de curvatura de una pared de la ranura en { $at } es { $radius }; el mínimo es { $allowed }. Use un rodillo más pequeño (cam.roller_radius) o un cilindro mayor (cam.base_radius).
reason-roller-too-large = El rodillo no cabe en el perfil cóncavo en { $at }: el radio del rodillo es { $roller } y el de curvatura { $hollow }. Fije un cam.roller_radius menor.
reason-pressure-angle = El ángulo de presión alcanza { $angle } en { $at }; el máximo es { $allowed }. El seguidor puede acuñarse en su guía. Aumente el círculo primario (cam.prime_radius o cam.base_radius).
reason-large-pressure-angle = El ángulo de presión alcanza { $angle } en { $at }; los ángulos de más de { $usual } solo valen a baja velocidad. Aumente el círculo primario (cam.prime_radius o cam.base_radius) o fije limits.pressure_angle.
reason-force-error-in-run = En este ensayo el error de fuerza es { $error } RMS; el máximo es { $allowed } (accuracy.rms).
reason-force-error = El error de fuerza es { $error } RMS; el máximo es { $allowed }. Amplíe los límites activos, fije más law.spans o fije en accuracy.rms el error admisible.
reason-preload-above-target = El error de fuerza es { $error } RMS; el máximo es { $allowed }. La fuerza no puede ser menor que la precarga de { $preload }, pero el mínimo del objetivo es { $least }. Fije drive.preload en { $least } o menos.
reason-below-base-circle = La ley baja { $depth } por debajo del círculo base en { $at }.
reason-prime-radius = El radio primario de esta leva es { $needed }; el máximo es { $allowed }. Admita un ángulo de presión (limits.pressure_angle) o un error de fuerza (accuracy.rms) mayores.
reason-outside-band = La fuerza queda fuera de su banda en { $excess } en { $at }. Fije una gait.band más ancha o más law.spans.
reason-limit-unbounded = La magnitud «{ $limit }» es infinita en { $at }, porque la derivada de orden inferior es discontinua en ese punto. Ningún valor de este límite es suficiente. Use una ley sin esa discontinuidad o elimine el límite.
reason-pressure-unbounded = La presión de contacto es infinita en { $at }, porque el radio de curvatura convexo del perfil es nulo o negativo en ese punto.
reason-limit-broken = No se cumple el límite «{ $limit }» en { $at }: el valor es { $value }, pero el límite es { $allowed }.

# Notas sobre el problema y el diseño, además del veredicto.
design-scene = { $note }
design-recording = { $note }
design-stretched = Una vuelta dura { $turn }, pero el ciclo de fuerza dura { $cycle }. La curva de fuerza se adapta a la vuelta.
design-rounded-table = Las elevaciones de la tabla del segmento { $segment } están redondeadas. Los errores de redondeo pueden causar hasta el { $share } de la aceleración máxima del segmento. Dé elevaciones con más decimales.
design-not-judged = { $key } = "none": desactiva el límite habitual.
design-mean-force = La fuerza objetivo media es { $mean }, pero el peso de la masa es { $weight }. Una leva no puede cambiar la fuerza media de una vuelta, de modo que el error de fuerza es como mínimo { $error } RMS. Fije drive.mass = "auto" o gait.scale = "to-mass".
design-free-fall = La fuerza objetivo es casi nula durante { $share } de la vuelta ({ $duration }). Ahí la masa debe estar en caída libre, lo que por sí solo requiere una elevación de unos { $lift }. Al caminar, la fuerza total de ambos pies (feet = "both") no llega a cero. Un accionamiento hidráulico (drive.kind = "hydraulic") reproduce una fuerza nula sin caída libre.
design-largest-stroke = La fuerza objetivo acelera la masa como máximo a { $acceleration }. Por eso la carrera h es como máximo { $stroke }, porque 16 h/T² ≤ máx|a| en una vuelta de duración T{ $idle ->
        [true] ; el límite de carrera no puede estar activo
       *[other] {""}
    }.
design-first-walker = La máquina cuenta como el primer caminante, con el peso { $weight } (primer valor de { $key }).
design-phase = El ángulo 0 de la leva está en { $phase } del ciclo de fuerza. Esta fase da el error de fuerza mínimo.
design-out-of-time = La búsqueda terminó en su límite de tiempo. El resultado es el mejor hallado, y no se probaron todas las relajaciones. Permita más tiempo con --time-limit.
design-noise = El número de { $size } se elige para un error de fuerza de { $error } RMS, la quinta parte de la desviación típica entre pasos del registro. Un número mayor ajustaría el ruido del registro. Fije accuracy.rms para cambiarlo.
design-sensor-noise = Las muestras de la fuerza contienen un ruido de sensor de { $noise } RMS. La exactitud automática y el número de { $size } corresponden a un error de fuerza de { $error } RMS. Fije gait.noise o accuracy.rms para cambiarlo.
design-many-spans-in-band = El número automático de tramos es { $spans }; con menos tramos la fuerza sale de gait.band. Fije una banda más ancha o menos law.spans.
design-many-spans = El número automático de tramos es { $spans }, porque el error de fuerza debe ser como máximo { $error } RMS. Fije gait.noise si la fuerza es ruidosa, un accuracy.rms mayor o menos law.spans.
design-thin-wall = La pared entre el agujero y el círculo base es de { $wall }; un cubo suele tener { $usual }. Fije un cam.base_radius mayor o un cam.bore menor.
design-large-roller = El radio del rodillo, { $roller }, supera el de la leva, { $cam }. Compruebe cam.roller_radius y su unidad.
design-thin-shaft = El círculo base tiene un diámetro de { $circle }, pero un eje de acero para el par de { $torque } requiere { $shaft } (tensión tangencial de 40 MPa). Agrande la leva, o deje abierto su tamaño y fije cam.bore con el diámetro del eje.
design-large-bore = El agujero tiene un diámetro de { $bore }, pero un eje de acero para el par de { $torque } solo requiere { $shaft } (tensión tangencial de 40 MPa). Compruebe cam.bore y su unidad.
design-inertia-for-accuracy = Con este motor el error de fuerza en el tiempo es { $error } de la media; el máximo es { $allowed }. Una inercia de { $inertia } (machine.inertia) es suficiente. Si la familia de la ley lo permite, law.shaft = "motor" diseña la ley para este motor.
design-no-base-circle = El radio base mínimo es cero, de modo que el perfil pasa por el eje. Fije cam.bore o cam.base_radius.
design-usual-pressure-angle = No se da límite para el ángulo de presión; la leva se dimensiona para el máximo habitual, { $angle }. Fije limits.pressure_angle para cambiarlo.
design-polydyne = La leva es polidina: a { $speed } el extremo de salida de un seguidor de rigidez { $stiffness } sigue la ley. Elevación, velocidad, aceleración, sobreaceleración y sus límites se refieren a la leva; la fuerza, al extremo de salida.
design-polydyne-miss = Con su seguidor flexible, esta leva tiene un error de fuerza de { $own } RMS. Una leva sin la corrección polidina tendría { $plain } RMS.

# Errores en los datos de un diseño.
synth-shaft-diverges = la iteración de ley y velocidad del eje no converge: la oscilación de velocidad es del { $ripple } o más
    .help = fije machine.inertia = "{ $inertia }" (oscilación de cerca del { $calm }), una recta de par del motor más inclinada o law.shaft = "constant"
synth-adjusts-given = se da { $key }, pero gait.adjust lo fija para cada caminante
    .help = omita { $key }, o quítelo de gait.adjust
synth-mass-not-adjustable = la masa de este accionamiento no soporta el peso del caminante
    .help = quite "mass" de gait.adjust, o fije drive.kind = "moving-axis"
synth-speed-not-adjustable = la fuerza de este accionamiento no cambia con la velocidad por un solo factor, porque las fuerzas del muelle, del amortiguamiento y de inercia tienen factores distintos
    .help = quite "speed" de gait.adjust y dé drive.speed
synth-not-of-population = este ajuste no está disponible para varios caminantes
    .help = dé un solo ciclo u omita el ajuste; law.robust requiere el objetivo force-error y law.family = "spline" o "harmonic", o ningún law.family
synth-machine-of-population = una leva para varios caminantes se diseña sin motor ni suelo
    .help = omita aquí este ajuste y simule con él la leva terminada: gaitcam simulate DIR --set CLAVE=VALOR --speeds INICIO:FIN:N
synth-one-walker = no se pueden elegir levas para un solo caminante
    .help = dé una carpeta, una lista o una tabla de varios caminantes
synth-force-not-read = no se leyó la curva de fuerza
synth-no-lift-changes-force = la fuerza no depende de la elevación: la rigidez, el amortiguamiento y la masa son cero
    .help = indique al menos spring_rate, damping o mass
synth-value-missing = se requiere un valor si no se da ninguna fuerza
synth-mean-force-negative = la fuerza media es { $mean }, pero una masa sobre la leva requiere una positiva
    .help = las fuerzas de compresión deben ser positivas: compruebe el signo y la columna
synth-not-scalable = una fuerza media de { $mean } no se puede escalar a { $weight }
synth-no-spread = el objetivo es un solo ciclo y no tiene dispersión
    .help = use un registro de varios pasos, o una anchura: band = "20 N"
synth-pair-incomplete = «{ $pair }» no es un par de magnitudes
    .help = escriba force_error:prime_radius; en lugar de prime_radius puede usar { $known }
synth-pair-without-force-error = una de las dos magnitudes debe ser force_error
    .help = escriba force_error:prime_radius; en lugar de prime_radius puede usar { $known }
synth-pair-unknown = valor no válido «{ $typed }»
    .help = escriba force_error:prime_radius; en lugar de prime_radius puede usar { $known }
synth-no-target = el compromiso requiere una fuerza objetivo
synth-only-splines = el compromiso solo está disponible para splines
    .help = use law.family = "spline", o gaitcam sweep y gaitcam front
synth-size-fixed = la escena fija el tamaño de la leva
    .help = omita base_radius y prime_radius
synth-no-law = { $reason }
synth-search-failed = la búsqueda falló: { $fault }
synth-too-many-harmonics = { $samples } muestras determinan como máximo { $most } armónicos
synth-resonance = el armónico { $harmonic } de la fuerza está en la resonancia del accionamiento, donde las fuerzas del muelle y de inercia se anulan
    .help = fije un drive.damping mayor, o cambie drive.mass, drive.spring_rate o drive.speed
synth-no-constant-breadth = la ley no tiene una anchura constante: la suma de las elevaciones en θ y θ + 180° es { $sum } en θ = 0°, pero cambia en { $miss } en θ = { $at }
    .help = indique solo los segmentos de los primeros 180°; la otra mitad resulta de ellos
synth-breadth-too-small = una anchura de { $breadth } es demasiado pequeña para una elevación de { $lift }
    .help = la anchura es el doble del radio base (rodillo: radio primario) más la elevación
synth-no-prime-circle = ningún círculo primario es lo bastante grande
    .help = elimine la discontinuidad de la velocidad, porque da al perfil una esquina con cualquier radio base
synth-follower-needs = este seguidor requiere esta clave
synth-no-range = el intervalo de { $start } a { $end } no es válido dentro de una vuelta
    .help = los ángulos van de 0 a 360 deg
synth-degree-too-low = { $conditions } condiciones fijan un polinomio de grado { $fixed }, no { $degree }
    .help = escriba degree = { $fixed }, o elimine { $excess } condiciones
synth-degree-too-high = { $conditions } condiciones fijan un polinomio de grado { $fixed }, no { $degree }
    .help = escriba degree = { $fixed }, o añada { $missing } condiciones
synth-many-demands = los puntos y los detenimientos dan { $given } condiciones a una sola ley; se resuelven como máximo { $most }
    .help = dé una curva medida como fuerza o como banda, u omita puntos
synth-law-open = la ley termina { $rise } por encima de su inicio y no está cerrada
    .help = fije en el último punto la elevación del primero
synth-force-gives-no-lift = con este accionamiento una fuerza no determina una elevación
    .help = indique la elevación del punto, o fije drive.kind = "hydraulic"
synth-points-empty = los puntos no dan ninguna condición
    .help = indique elevación, fuerza, velocidad, aceleración o sobreaceleración
synth-family-needs-force = esta familia requiere una fuerza objetivo
    .help = añada [gait], o fije law.family = "spline", "polynomial" o "program"
synth-no-double-harmonic = la búsqueda no encontró ninguna ley armónica doble
synth-double-harmonic-useless = ninguna ley armónica doble reproduce esta fuerza mejor que una fuerza constante
    .help = use family = "spline"
synth-dwells-overlap = dos detenimientos se solapan
    .help = únalos en uno solo
synth-dwells-fill-turn = los detenimientos cubren toda la vuelta
    .help = acorte un detenimiento
synth-point-outside = { $at } está fuera de la vuelta
    .help = los ángulos van de 0 a 360 deg
