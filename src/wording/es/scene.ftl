# Errores en una escena (src/scene/error.rs) y claves sin efecto (src/scene/notes.rs).
scene-not-toml = error de sintaxis TOML en la línea { $line } (mensaje en inglés: { $fault })
scene-output-name = «{ $typed }» no es un nombre válido de carpeta de salida
    .help = use letras, cifras, - y _
scene-no-such-key = clave desconocida
    .help = { $nearest ->
        [none] las claves de esta sección son { $known }
       *[other] ¿quiso decir «{ $nearest }»?
    }
scene-not-of-follower = esta clave no se aplica a este seguidor ({ $follower })
    .help = quítela o elija otro cam.follower
scene-not-of-drive = esta clave no se aplica a este accionamiento ({ $drive })
    .help = quítela o elija otro drive.kind
scene-mass-of-arm = un seguidor oscilante tiene momento de inercia en lugar de masa
    .help = dé su momento de inercia respecto al pivote: inertia = "0.02 kg m^2"
scene-not-table = { $typed } no es una tabla
    .help = escríbalo como tabla, [{ $section }]
scene-not-list = { $typed } no es una lista de tablas
    .help = escriba cada una como [[{ $list }]]
scene-not-text = { $typed } no es un texto
    .help = escríbalo entre comillas
scene-not-hardness = «{ $typed }» no es una dureza con su escala
    .help = escriba por ejemplo "58 HRC", "650 HV" o "240 HB": 20 … 64 HRC, 105 … 800 HV, 100 … 722 HB
scene-not-robust = «{ $typed }» no es una medida de los errores de varios caminantes
    .help = escriba "mean", "worst" o por ejemplo "cvar 0.9"
scene-not-frequencies = «{ $typed }» no contiene frecuencias de paso
    .help = escriba una frecuencia, "1.85 Hz", un intervalo con el número de valores, "1.4 Hz:2.4 Hz:11", o una distribución normal, "normal 1.87 Hz 0.19 Hz"
scene-not-texts = { $typed } no es un texto
    .help = escriba un texto entre comillas, o una lista de ellos
scene-not-flag = { $typed } no es true ni false
    .help = escriba true o false
scene-not-count = { $typed } no es un número entero de { $low } a { $high }
    .help = escriba un número entero de { $low } a { $high }, o "auto"
scene-not-spans = { $typed } no es un número entero de { $low } a { $high }
    .help = escriba de 8 a 60 para la mayoría de las levas, o "auto" para el mínimo que alcanza la precisión; más de { $high } tramos pueden impedir un óptimo certificado
scene-not-quantity = { $typed } no es un número con su unidad
    .help = escriba un número con su unidad entre comillas, por ejemplo { $example }
scene-unknown-word = valor no válido «{ $word }»
    .help = { $nearest ->
        [none] los valores válidos son { $known }
       *[other] ¿quiso decir «{ $nearest }»? Los valores válidos son { $known }
    }
scene-not-positive = { $typed } no es positivo
    .help = escriba por ejemplo { $example }
scene-negative = { $typed } es negativo
    .help = escriba por ejemplo { $example }
scene-outside = { $typed } está fuera de { $low } … { $high }
    .help = dé un valor de { $low } a { $high }
scene-not-acute = el límite { $typed } del ángulo de presión no es menor que 90°
    .help = fije un límite menor que 90°; lo habitual es de 30° a 45°
scene-needed-by-follower = este seguidor ({ $follower }) requiere esta clave
    .help = escriba por ejemplo { $example }
scene-needed-by-drive = este accionamiento ({ $drive }) requiere esta clave
    .help = escriba por ejemplo { $example }
scene-needed-in-entry = cada entrada de la lista requiere esta clave
    .help = escriba por ejemplo { $example }
scene-no-assignment = «{ $typed }» no tiene la forma CLAVE=VALOR
    .help = escriba CLAVE=VALOR, por ejemplo limits.stroke=40 mm
scene-no-entry = no existe { $list }.{ $number }; { $given ->
        [0] no se da ninguna entrada
        [one] se da una entrada
       *[other] se dan { $given } entradas
    }
    .help = las entradas se cuentan desde 1: { $list }.1
scene-list-without-number = { $list } es una lista de { $given } entradas
    .help = escriba { $list }.1 para la primera
scene-value-not-table = { $part } es un valor, no una tabla
    .help = quite lo que sigue a { $part }
scene-file-and-model = solo se puede dar uno de file, model y harmonics
    .help = conserve uno: file = "walk.mot", model = "young" o harmonics = ["0.4", "0.1 at -90 deg"]
scene-not-harmonic = «{ $typed }» no es un factor de carga con su fase
    .help = escriba un texto por armónico con su amplitud (fracción del peso, cero o mayor) y la fase de su seno: ["0.4", "0.1 at -90 deg"]
scene-not-learned-force = «{ $typed }» no es una fuerza con su fase
    .help = escriba un texto para la fuerza media y uno para cada armónico con su amplitud y la fase de su seno: ["0 N", "3.2 N at -90 deg"]
scene-learned-forces = la fuerza aprendida tiene { $given } armónicos, que son demasiados
    .help = dé la media y los primeros armónicos, como máximo { $most } textos
scene-harmonics = { $given ->
        [one] el único factor de carga es cero
       *[other] los { $given } factores de carga son todos cero o demasiados
    }
    .help = dé de 1 a { $most } factores, al menos uno mayor que cero, por ejemplo ["0.4", "0.1 at -90 deg"]
scene-no-force-named = no se da ni un registro ni un modelo de carga
    .help = dé file = "walk.mot", model = "young" o harmonics = ["0.4", "0.1 at -90 deg"]; quite [gait] para una ley dada por segmentos o puntos
scene-no-phases = el intervalo de fases de { $from } a { $to } no es válido
    .help = las fases van de 0 a 360 deg; en un intervalo que pasa por el final del ciclo, to es menor que from
scene-nothing-weighed = todas las fases del ciclo tienen peso 0
    .help = dé al menos a un intervalo un peso mayor que 0
scene-weigh-removed = law.weigh se ha eliminado
    .help = ejecute gaitcam synth --front force_error:prime_radius, elija un punto del compromiso y fije sus límites
scene-no-force-to-follow = no se da ninguna fuerza objetivo
    .help = añada [gait] o minimice "jerk", "peak-acceleration" …
scene-size-not-free = el tamaño de esta leva no es libre
    .help = quite esta clave; solo se aplica a levas de disco sin radio dado, salvo con seguidores oscilantes de hongo
scene-spline-degree = grado de spline no válido { $typed }
    .help = escriba un número entero de 3 a 9, o "auto"
scene-degree-below-objective = la derivada de orden { $order } de una ley de grado { $degree } es cero entre los nudos y no se puede minimizar
    .help = use grado { $order } o mayor, u otro law.minimise
scene-only-splines = una ley de esta familia ({ $family }) no admite esta clave
    .help = use law.family = "spline"
scene-program-without-segments = el programa no tiene segmentos
    .help = escriba para cada segmento: [[law.segment]] motion = "cycloidal" lift = "10 mm" angle = "90 deg"
scene-polynomial-without-points = un polinomio necesita al menos dos puntos
    .help = escriba para cada punto: [[law.point]] angle = "0 deg" lift = "0" velocity = "0"
scene-nothing-asked = la ley no tiene fuerza objetivo ni puntos ni segmentos
    .help = añada [gait] con una fuerza, entradas [[law.point]], o family = "program" con segmentos
scene-no-speed = "auto" requiere una fuerza objetivo, porque su período determina la velocidad
    .help = escriba por ejemplo "60 rpm"
scene-no-mass = "auto" requiere una fuerza objetivo, porque su media determina la masa
    .help = escriba por ejemplo "70 kg"
scene-base-and-prime = se dan base_radius y prime_radius, pero cada uno determina el otro
    .help = quite uno de los dos
scene-radius-and-breadth = la anchura determina el radio base: (anchura − elevación) / 2
    .help = quite base_radius y prime_radius
scene-breadth-without-program = la anchura constante requiere un programa de la primera media vuelta, que determina la segunda
    .help = ponga law.family = "program" con segmentos
scene-roller-fills-prime = con el radio del rodillo o del arco, { $roller }, el radio base sería { $base }
    .help = el radio primario debe superar el radio del rodillo
scene-base-in-bore = el radio base de { $base } queda dentro del agujero de { $bore }
    .help = use un radio base mayor que { $least }
scene-keyway-without-bore = un chavetero necesita un agujero
    .help = dé cam.bore, por ejemplo "20 mm"
scene-no-keyway-for-bore = DIN 6885-1 no tiene chavetero para un agujero de { $bore }
    .help = la norma abarca agujeros de más de 6 mm hasta 150 mm; dé una anchura, u omita el chavetero
scene-no-keyway-of-width = DIN 6885-1 no tiene chavetero de { $width }
    .help = las anchuras normalizadas son { $widths } mm
scene-keyway-too-wide = un chavetero de { $width } no cabe en un agujero de { $bore }
    .help = escriba "auto" para la anchura de DIN 6885-1
scene-offset-reaches-prime = la excentricidad de { $offset } no es menor que el radio primario, { $prime }
    .help = reduzca cam.offset o aumente el radio primario
scene-force-needs-turn = una fuerza objetivo requiere una ley de una vuelta, pero esta leva ({ $follower }) se traslada o tiene una ley de varias vueltas
    .help = use un seguidor sobre una leva de disco, o quite [gait] y dé un programa
scene-length-needs-program = una ley sobre una longitud debe darse como programa
    .help = ponga law.family = "program" con segmentos
scene-turns-need-program = una ley de varias vueltas debe darse como programa
    .help = ponga law.family = "program" con segmentos
scene-arm-on-moving-axis = una leva de eje móvil descansa sobre un seguidor de traslación, pero este seguidor oscila alrededor de un pivote fijo
    .help = use kind = "hydraulic", o kind = "fixed-axis" con inertia, spring_rate y preload respecto al pivote
scene-pair-not-closed = dé esta clave o base_radius, solo una de las dos
    .help = dé la distancia entre caras o centros de rodillo (seguidores oscilantes: el ángulo entre los brazos), o base_radius de la segunda leva
scene-frequency-and-stiffness = natural_frequency ya define la rigidez del tren del seguidor
    .help = quite una de las dos
scene-motor-line = un motor necesita uno de slope, stall_torque, rated_torque y curve
    .help = escriba por ejemplo slope = "10 N m s/rad" en [machine.motor], la disminución del par por rad/s en el eje de la leva
scene-no-load-without-stall = una velocidad en vacío requiere un stall_torque
    .help = indique stall_torque y no_load_speed, o solo slope (la velocidad sin carga se calcula entonces)
scene-motor-curve = el par del motor debe disminuir con su velocidad
    .help = dé al menos dos filas con velocidades crecientes y pares decrecientes: un archivo con las columnas speed_rad_per_s y torque_n_m, o parejas como "0 50 10 20 12 -4"
scene-motor-without-inertia = un motor requiere el momento de inercia de su eje
    .help = escriba por ejemplo inertia = "0.5 kg m^2" en [machine] para volante y rotor, reducidos al eje de la leva
scene-points-of-fusion = Fusion lee los puntos en centímetros
    .help = omita --units
scene-half-nameplate = un motor de inducción requiere rated_torque y rated_speed
    .help = escriba por ejemplo rated_torque = "5.1 N m" y rated_speed = "1395 rpm" en [machine.motor]
scene-not-synchronous = la velocidad síncrona del motor debe ser mayor que su velocidad nominal
    .help = escriba por ejemplo synchronous_speed = "1500 rpm": 120 veces la frecuencia de la red entre el número de polos
scene-floor-lacks = un suelo que se mueve requiere masa modal, frecuencia y razón de amortiguamiento
    .help = escriba por ejemplo "{ $example }" en [machine.floor]
scene-floor-twice = el suelo se da como un modo y como una lista de modos
    .help = pase los números de [machine.floor] a un [[machine.floor.mode]]
scene-walker-phases = se requiere un ángulo para cada uno de los { $count } caminantes de machine.walkers.count
    .help = escriba { $count } ángulos, primero el excitador, como ["0 deg", "90 deg"] para 2; u omita la clave para sortear las fases
scene-walker-weights = se requiere un peso positivo para cada uno de los { $count } caminantes de machine.walkers.count
    .help = escriba { $count } pesos, primero el excitador, como ["700 N", "850 N"] para 2; u omita la clave para pesos iguales
scene-floor-alone = esta clave no está disponible con un suelo que se mueve
    .help = omita esta clave, u omita [machine.floor]
scene-floor-needs-shaker = un suelo que se mueve requiere drive.kind = "moving-axis" con [gait] y sin law.polydyne
    .help = omita [machine.floor], o use este accionamiento
scene-residual-without-frequency = el límite de vibración residual requiere esta clave
    .help = escriba por ejemplo "60 Hz" en [machine]
scene-force-range = { $low } no es menor que force_max = { $high }
    .help = reduzca force_min o aumente force_max
scene-polydyne-without-stiffness = una leva polidina necesita la rigidez del seguidor
    .help = escriba stiffness = "9 kN/m" o natural_frequency = "60 Hz" en [machine]
scene-polydyne-family = una leva polidina necesita una ley con cuatro derivadas continuas, que esta familia ({ $family }) no garantiza
    .help = use family = "spline" o "harmonic", o un programa de segmentos 5-6-7-8-9
scene-polydyne-degree = por debajo del grado 5 la aceleración de una leva polidina sería discontinua, porque su elevación incluye la deformación del seguidor
    .help = use grado 5 a 9
scene-polydyne-on-slide = una leva polidina debe girar, porque una ley que no se repite no tiene régimen permanente
    .help = quite law.polydyne o use otro seguidor
scene-polydyne-breadth = una leva polidina no puede tener anchura constante, porque la deformación del seguidor es distinta media vuelta después
    .help = quite law.polydyne o cam.breadth
scene-no-such-scene = la escena incorporada «{ $typed }» no existe
    .help = { $nearest ->
        [none] las escenas incorporadas son { $known }
       *[other] ¿quiso decir «{ $nearest }»?
    }

scene-no-effect = { $key } no tiene efecto: { $why ->
        [family] una ley de esta familia ({ $family }) no la usa
        [follower] este seguidor ({ $follower }) no la usa
        [drive] este accionamiento ({ $drive }) no la usa
        [no-force] no se da ninguna fuerza objetivo
        [recording] la fuerza es un registro
        [model] la fuerza es un modelo de carga
        [no-motor] sin machine.motor el eje gira a velocidad constante
        [stiff-floor] sin machine.floor el suelo no se mueve
        [no-dwell] la ley no tiene detenimientos
       *[rigid-follower] el seguidor es rígido sin machine.natural_frequency o machine.stiffness
    }
