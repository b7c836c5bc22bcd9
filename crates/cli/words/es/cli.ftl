# Errores que solo la orden encuentra: archivos, opciones, carpetas.
cli-negative-ball = el radio de una bola palpadora es 0 o más, no { $typed }
cli-cannot-open = no se puede abrir ({ $fault })
cli-scene-name = "{ $shown }" { $fault ->
        [blank] está en blanco
        [dash] empieza por un guion
        [control] contiene un carácter de control o una marca invisible
       *[not-plain] no es un nombre de archivo simple
    }
    .help = los resultados van a out/NOMBRE: use letras, cifras, - y _, o indique la carpeta
cli-few-rows = valor no válido { $rows }
    .help = se necesitan al menos { $least } puntos, menos solo con --front
cli-not-stances = { $file } no es ni un archivo .csv nuevo ni una tabla de apoyos
    .help = una tabla de apoyos solo reemplaza a otra anterior; dé otro nombre terminado en .csv
cli-stances-of-several = { $table } es el lugar de una sola tabla, pero se nombran varios registros
    .help = nombre un registro, o léalos uno por uno
cli-cycle-ending = { $file } no es ni un archivo .csv o .mot ni una carpeta
    .help = el ciclo se escribe como .csv o .mot, con figuras .svg y .png a su lado
cli-table-changed = la tabla terminada se modificó después de que el barrido la escribiera
    .help = muévala a otro lugar para calcularla de nuevo
cli-cams = "{ $typed }" no es un número de levas
    .help = escriba un número, o el primero y el último: 3, 1:6; como mucho { $most }
cli-among-recordings = los resultados quedarían entre los registros de { $folder }
    .help = dé otra carpeta
cli-not-cover = esto no es una tabla de gaitcam cover
    .help = dé la carpeta que escribió gaitcam cover
cli-scene-not-recording = es una escena, no un registro
    .help = gaitcam synth diseña su leva y gaitcam doctor la revisa; gaitcam gait lee el registro que nombra su gait.file
cli-no-key-contains = ninguna clave contiene "{ $pattern }"
cli-input-time = la entrada no se leyó en { $limit } s
    .help = termine la entrada, o dé más tiempo
cli-no-model = "{ $typed }" no es un modelo
    .help = escriba auto, rigid, flexible o contact
cli-speeds = { $typed } no es un intervalo de velocidades
    .help = escriba la primera, la última y el número de velocidades, de 2 a { $most }: --speeds '1.4 Hz:2.3 Hz:10'
cli-cam-is-made = el perfil de este resultado está terminado: cambiar { $key } exige un diseño nuevo
    .help = dé solo claves de drive y machine, o diseñe la otra leva con gaitcam synth SUMMARY.json --set …
cli-broken-table = { $fault }
    .help = escríbala de nuevo con gaitcam synth
cli-field-not-number = un campo no es un número
    .help = escríbala de nuevo con gaitcam synth
cli-empty-table = la tabla no tiene filas
cli-no-blocks = esta carpeta no contiene bloques de filas de un barrido; indique la tabla que escribió gaitcam sweep, o la carpeta de sus bloques (gaitcam sweep --shard)
cli-not-sweep-table = no es la tabla de un barrido: no tiene la columna "{ $column }"
    .help = indique el archivo que escribió gaitcam sweep
cli-no-parquet = este gaitcam se compiló sin Parquet (la opción "parquet")
    .help = use una tabla .csv, o compile con --features parquet
cli-table-ending = { $file } no es ni .csv ni .parquet
    .help = dé a la tabla una de estas extensiones
cli-no-base-scene = no nombra la escena base de la fila
cli-row-not-number = fila { $row }: "{ $cell }" no es un número
cli-nothing-varies = rejilla vacía: no varía ninguna clave
    .help = escriba --vary 'limits.stroke=20 mm:60 mm:5', --list ARCHIVO.csv o --recordings CARPETA
cli-list-value = { $fault }
cli-list-cell = falta un valor
    .help = cada fila necesita todas las claves
cli-empty-list = rejilla vacía: la lista no tiene filas
    .help = la primera línea nombra las claves, cada línea siguiente da sus valores
cli-no-recordings = no hay ningún archivo en la carpeta
    .help = los registros terminan en { $endings }
cli-not-recordings = ninguno de { $files } archivos tiene nombre de registro
    .help = los registros terminan en { $endings }
cli-many-rows = { $rows } combinaciones
    .help = tome menos valores, o --sample N, o confirme con --yes
    .help = fije la escena con --set
cli-scatter-csv = las muestras de --tolerance se escriben como .csv
cli-too-many-samples = valor no válido { $count }
    .help = como máximo { $most }
cli-no-sample = ninguna muestra
cli-partial-rows = contiene { $rows } filas de un barrido detenido
    .help = continúe con --resume, o bórrelo para empezar de nuevo
cli-not-partial = no es la tabla parcial de un barrido
    .help = muévalo a otro lugar, o elija otro --out
cli-rows-safe = no se puede escribir ({ $fault })
    .help = contiene { $rows } filas a salvo: libere espacio y continúe con --resume
cli-all-rows-safe = no se puede escribir ({ $fault })
    .help = todas las filas están a salvo a su lado: libere espacio y continúe con --resume
cli-cannot-repair = no se puede reparar ({ $fault })
cli-file-is-there = ya existe y no se sobrescribe
    .help = dé otro nombre con --out
cli-unknown-flag = opción desconocida
    .help = { $near ->
        [none] gaitcam ORDEN --help enumera las opciones
       *[other] ¿quería decir { $near }?
    }
cli-one-too-many = sobra un argumento
    .help = ponga entre comillas los valores que contienen espacios: --set 'limits.stroke=40 mm'
cli-unknown-verb = "{ $typed }" no es una orden
    .help = { $near ->
        [none] gaitcam --help enumera las órdenes; la escena sigue a la orden: gaitcam synth ESCENA.toml
       *[other] ¿quería decir { $near }?
    }
cli-in-lab = "{ $typed }" está ahora en el laboratorio del repositorio: cargo run --release -p gaitcam-lab -- { $typed }
cli-flag-without-value = falta su valor
cli-flag-choice = "{ $typed }" no es una de las opciones
    .help = escriba una de: { $choices }
cli-flag-value = valor no válido "{ $typed }"
    .help = { $fault }
cli-flag-whole = valor no válido "{ $typed }"
    .help = escriba un número entero
cli-flag-range = valor no válido { $typed }
    .help = debe estar en { $range }
cli-missing-arguments = falta: { $missing }
    .help = { $choices ->
        [none] vea --help
        [table] añada, por ejemplo, --out tabla.csv
       *[other] escriba uno de: { $choices }
    }
cli-flag-conflict = no se puede usar junto con { $other }
cli-flag-count = el número de valores no es correcto
cli-arguments = { $fault }

# Todas las órdenes.
run-internal-error = error interno; comuníquelo junto con { $file ->
        [none] la escena
       *[other] { $file }
    }
run-no-command = Sin orden: se diseña la pasarela incorporada. `gaitcam --help` muestra las órdenes.
run-stdout = la respuesta no se puede escribir en la salida estándar ({ $fault })
run-files = Archivos en { $folder }; abra primero { $first }.

# synth: rótulos de las filas del resumen.
label-failed = FALLA
label-ok = cumple
label-force = fuerza
label-law = ley
label-drive = accionamiento
label-cam = leva
label-machine = máquina
label-floor = suelo
label-walkers = caminantes
label-shaft = eje
label-active = activo
label-relaxing = relajar
label-note = nota
label-solved = cálculo
label-optimum = óptimo
label-sequence = secuencia
more-failed = { $count } comprobaciones fallidas más en summary.json
more-passed = { $count } comprobaciones cumplidas más en summary.json
more-active = { $count } límites activos más en summary.json
more-relaxing = { $count } sensibilidades más en summary.json
more-notes = { $count } notas más en summary.json
time-limit-seconds = escriba un número de segundos mayor que 0, como 20
synth-searching = diseñando (como máximo { $limit } s)
synth-check = { $name } { $value } (límite { $limit }) en { $at }
synth-check-none = { $name }: ninguna
synth-check-overall = { $name } { $value } (límite { $limit })
synth-force-error = error { $rms } RMS ({ $percent } % de la media), máximo { $most }
synth-force-range = { $range }, media { $mean }
synth-load-factors = factores de carga dinámica 1 a 4: { $list }
synth-walkers = { $count }: error de fuerza del { $mean } % de la fuerza media en promedio, { $cvar } % en { $tail ->
        [tenth] la peor décima parte
       *[other] el peor { $tail } %
    }, { $worst } % en el peor ({ $who })
synth-walkers-n = { $count }: error de fuerza de { $mean } N en promedio, { $cvar } N en { $tail ->
        [tenth] la peor décima parte
       *[other] el peor { $tail } %
    }, { $worst } N en el peor ({ $who })
synth-shaft = { $low } … { $high } rad/s, oscilación { $ripple } %; motor: velocidad en vacío { $noload } rad/s, par { $rms } N·m RMS, máximo { $most } N·m
synth-shaft-error = error de fuerza en el tiempo { $own } % de la media; de la ley para velocidad constante { $before } %{ $rounds ->
        [0] {""}
        [one] {"; "}una iteración
       *[other] {"; "}{ $rounds } iteraciones
    }
synth-shaft-sensitivity = con un 10 % menos o más de { $list }
synth-shaft-differs = { $key }: { $less } %, { $more } %
synth-active = límite { $limit } { $points ->
        [1] en { $at }
       *[other] en { $points } puntos, mayor multiplicador en { $at }
    }
synth-relaxing = { $limit } un 1 % hasta { $to }: { $name } { $after } { $unit } en lugar de { $before } { $unit }
synth-solved = método { $tier }, { $solve } ms de { $total } ms: { $status }
synth-certified = { $family ->
        [spline] demostrado: ninguna spline de este grado con estos tramos es mejor con estos límites
       *[other] demostrado: ninguna ley de esta familia es mejor con estos límites
    }
synth-uncertified = no se certifica como óptimo: { $why }
synth-optimum = brecha de dualidad relativa { $gap }, residuo KKT { $kkt }, violación de restricciones { $violation }
synth-no-sequence = no fue necesaria
synth-sequence = { $count } programas convexos
synth-step-head = paso radio primario           objetivo    holgura relativa      longitud
synth-ended = detenida: { $why }
synth-no-solid = sin sólido: { $fault }
synth-no-step = sin archivo STEP: { $fault }
synth-no-program = sin programa para la máquina: { $fault }
synth-gouge-hollow = la fresa es demasiado grande para el perfil cóncavo en { $at }: radio máximo { $radius } mm
synth-gouge-elsewhere = al cortar en { $at }, la fresa penetra { $depth } mm en el perfil en { $damaged }
synth-gouge-undercut = el perfil tiene rebaje en { $at }: ninguna fresa lo mecaniza

# synth --front.
trade-stopped = El límite de tiempo terminó la búsqueda: faltan puntos del frente. Dé un --time-limit mayor.
trade-none = no se puede construir ningún punto del frente
trade-title = { $name }: menor error de fuerza para cada { $quantity }

# gait.
gait-cycle-of = ciclo de { $file }
gait-joint-mean-of = media conjunta de { $file }
gait-mean-cycle-of = ciclo medio de { $file }

# simulate.
simulate-no-cam = no hay ninguna leva que simular: { $why }
simulate-speeds-error = error, N RMS
simulate-speeds-torque = par, N·m
simulate-speeds-ripple = oscilación, %
simulate-speeds-factors = factores de carga 1 a 4
simulate-speeds-lost = contacto perdido
simulate-speeds-none = el eje no gira: { $why }
simulate-no-target = sin objetivo a esta velocidad: { $why }
simulate-as-made = la leva fabricada, a { $rpm } rpm
simulate-designed-again = la leva se diseñó para este drive.speed; --speed hace girar una misma leva a otra velocidad

# sweep.
sweep-skipped = se omiten { $count } archivos junto a los registros ({ $first }{ $count ->
        [1] {""}
       *[other] {" …"}
    })
sweep-complete = { $file } ya está completa.
sweep-stopped = detenido tras { $done } de { $rows } filas; las filas calculadas están guardadas, continúe con --resume
sweep-counts = { $rows } filas en { $file }: { $built } construidas ({ $acceptable } aceptables, { $slow } no para alta velocidad), { $infeasible } no factibles, { $errors } errores
sweep-rate = { $designs } diseños en { $seconds } s, { $rate } por segundo
sweep-first-error = Primer error, fila { $row }: { $fault }
sweep-damaged = { $file } está dañado; sus filas se calculan de nuevo
sweep-no-design = no hay ningún diseño al que aplicar tolerancias: { $why }
sweep-samples = { $name }: { $count } muestras fabricadas; error de fuerza del diseño { $own } % de la media
sweep-spread = dispersión media { $mean } %, desviación típica { $deviation } %, 5 % a 95 %: { $p5 } % … { $p95 } %, mediana { $median } %, máximo { $largest } %
sweep-yield = rendimiento { $within } % queda dentro de { $band } %
sweep-scatter-files = Muestras en { $file }, figuras en { $page }.
sweep-shard = escriba I/N, por ejemplo 3/16: la tercera de dieciséis partes, contadas desde 1 (o desde 0: 0/16 es 16/16)
sweep-shard-done = { $folder }: { $rows } filas calculadas, { $left ->
        [0] están todos los bloques
        [one] falta un bloque
       *[other] faltan { $left } bloques
    }
sweep-designs = diseños
sweep-progress = { $done }/{ $total } { $what }, { $rate }/s, faltan { $left } s

# sweep --tolerance: el informe.
scatter-title = { $name }: dispersión de fabricación
scatter-how = Cada muestra es la leva con errores distribuidos uniformemente en las tolerancias; de ellos se calcula su error de fuerza.
scatter-heading = Error de fuerza de las muestras fabricadas
scatter-picture = { $name }: error de fuerza de las muestras fabricadas
scatter-axis = error de fuerza RMS, % de la media
scatter-own = diseño
scatter-band = banda
scatter-by-design = Del diseño
scatter-of-mean = de la fuerza media, RMS
scatter-median = Mediana de las muestras
scatter-below = El 95 % queda por debajo de
scatter-largest = Máximo
scatter-yield = Rendimiento
scatter-within = dentro de { $band } %
scatter-tolerances = Tolerancias
scatter-tolerance = tolerancia

# front.
front-none-built = { $file }: no se construyó ningún diseño
front-none-feasible = { $file }: ningún diseño es aceptable (--all incluye los demás)
front-counts = { $file }: { $candidates } de { $seen } diseños admisibles, { $front } de ellos no dominados
front-missing = { $count ->
        [one] la fila { $list } no está en la carpeta
       *[other] { $count } filas no están en la carpeta ({ $list })
    }: el frente es el de las demás. El mismo barrido, iniciado de nuevo, calcula lo que falta
front-low-speed = { $count ->
        [one] se omite un diseño que no es
       *[other] se omiten { $count } diseños que no son
    } para alta velocidad; --low-speed los incluye
front-row = fila
front-best = mejor compromiso
front-more = … { $count } más en front.csv; mejor compromiso: fila { $row }
front-page-title = Barrido { $name }
front-page-counts = { $seen } diseños, de ellos admisibles { $candidates }; { $front } son no dominados en { $text }. El mejor compromiso es la fila { $row }.
front-page-low-speed = { $count ->
        [one] Se omite un diseño que no es
       *[other] Se omiten { $count } diseños que no son
    } para alta velocidad.
front-heading-front = Frente
front-heading-heat = Mapa de calor
front-heading-parallel = Coordenadas paralelas
front-picture-front = { $name }: frente
front-picture-least = { $name }: mínimo de { $text }
front-picture-largest = { $name }: máximo de { $text }
front-picture-parallel = { $name }: diseños, el frente en azul
front-table = El frente
front-best-table = El mejor compromiso
front-column = columna
front-value = valor

# Columnas de la tabla de un barrido.
column-time = tiempo
column-row = fila

# cover y gait --against.
cover-head = { $name }: { $cycles } ciclos; error de fuerza en % de cada fuerza media
cover-head-n = { $name }: { $cycles } ciclos; error de fuerza en N
cover-cams = levas
cover-mean = media
cover-worst = peor
cover-objective = minimizado
cover-bound = cota
cover-others-mean = otros, media
cover-others-worst = otros, peor
cover-who = peor caso (componente principal del error)
cover-weight = fuerza media
cover-speed = tamaño a esta velocidad
cover-shape = forma
cover-bound-worst = minimizado: el peor error; cota: ningún conjunto de este número de levas tiene un peor error menor. otros: caminantes excluidos del diseño (cinco partes por turno)
cover-bound-mean = minimizado: la media cuadrática de los errores; cota: ningún conjunto de este número de levas tiene una menor. otros: caminantes excluidos del diseño (cinco partes por turno)
cover-bound-tail = minimizado: la media cuadrática de los errores de la peor parte de los caminantes; cota: ningún conjunto de este número de levas tiene una menor. otros: caminantes excluidos del diseño (cinco partes por turno)
cover-stopped = El límite de tiempo terminó la búsqueda: faltan números de levas. Dé un --time-limit mayor.
cover-cut = El límite de tiempo terminó la búsqueda: puede haber mejores repartos. Dé un --time-limit mayor.
cover-error = error de fuerza RMS, % de la fuerza media
cover-error-n = error de fuerza RMS, N
cover-number = número de levas
cover-what = Error según el número de levas
against-head = Levas de { $folder }
against-walker = caminante
against-cams = levas
against-cam = leva asignada
against-error = error %
against-error-n = error, N
against-reason = mayor parte del error

# compare.
compare-diagrams = Diagramas en { $folder }
compare-verdict = veredicto
compare-outcome = resultado
compare-law = ley
compare-follower = seguidor
compare-built = construida
compare-infeasible = no factible
compare-over-angle = ángulo de leva θ, grados
compare-over-travel = recorrido de la leva x, mm
compare-over-both = ángulo de leva θ, grados; de una leva de traslación su recorrido, mm
compare-laws = Leyes
compare-lifts = elevación y sus derivadas
compare-profiles = Perfiles
compare-scale = a la misma escala
compare-forces = Fuerzas
compare-force = fuerza, N
compare-target = objetivo de { $name }

# laws.
laws-head = Subida de 1 en tiempo 1: máximos de velocidad Cv, aceleración Ca, sobreaceleración Cj, par Ct = max|a·v|
laws-law = ley
laws-joins = enlaza con

# synth --explain.
explain-title = { $name }: selección del modelo
explain-because = porque { $reason }
explain-none-passed-over = es la familia más sencilla de las probadas
explain-family-degree = { $family } de grado { $degree }
explain-constant-speed = velocidad constante
explain-motor = la velocidad que da el motor
explain-forecast = la inercia y la energía que oscila prevén una oscilación de { $ripple } % y un cambio de la fuerza de { $change } % de la media (RMS); se desprecia { $neglected } %{ $enough ->
        [true] {": "}basta la velocidad constante
       *[other] {""}
    }

# keys.
keys-default = por defecto { $text }

init-shaker = Una masa que descansa sobre la leva y excita una pasarela como quien camina: F = M (g + d²s/dt²).
init-walk = Una leva de su propio registro de la marcha, reproducida por una masa que descansa sobre ella.
init-heel-tester = Una ensayadora de tacones: la subida comprime aceite o aire en un cilindro, la fuerza crece con ella.
init-spring-bench = Un banco de ensayo con muelle: F = F₀ + k s + m d²s/dt²; para pies protésicos, calzado, articulaciones.
init-programme = Una leva clásica de un programa de subidas, bajadas y detenimientos, sin fuerza.
init-written = { $file } escrito
init-how = Diseñe la leva: gaitcam synth { $file }. Todas las claves: gaitcam keys. Las líneas que empiezan por "# clave =" se ofrecen y no se usan.
doctor-toml = { $file }: { $keys } valores
doctor-keys-right = todas las claves existen y todos los valores están en su intervalo
doctor-faults = { $count ->
        [one] Un fallo: corríjalo y ejecute esto de nuevo.
       *[other] { $count } fallos: corríjalos y ejecute esto de nuevo.
    }
doctor-one-cycle = { $file }: un ciclo de { $period } s
doctor-recording = { $file }: { $columns ->
        [one] una columna de fuerza
       *[other] { $columns } columnas de fuerza
    }, { $used ->
        [one] un apoyo utilizado
       *[other] { $used } apoyos utilizados
    }, { $rejected } descartados
doctor-unacceptable = Se encontró: { $sentence }. Indique otro registro u otra columna.
doctor-doubt = Abierto: { $sentence }. Compruébelo; indique después la clave que lo responde, o acepte lo supuesto con gait.accept = "{ $name }".
doctor-recording-options = Lo que falta se puede indicar: gait.time, gait.force, gait.unit, gait.rate, gait.mass, gait.kind, gait.period (véase gaitcam keys gait).

# inspect.
inspect-no-cam = no hay leva con que comparar: { $why }
inspect-fit = { $points } puntos; la leva está girada { $turn }° con su centro en x { $x } mm, y { $y } mm
inspect-alike = la leva se repite: ajusta igual de bien girada { $others }
inspect-deviation = desviación según la normal: { $rms } µm RMS, de { $least } µm en { $below } a { $most } µm en { $above }
inspect-outliers = { $count } { $count ->
        [one] punto queda
       *[other] puntos quedan
    } hasta { $most } µm fuera de los demás (líneas { $lines }) y no se cuentan
inspect-part = se midió una parte del perfil: ningún punto queda entre { $from } y { $to }; la fuerza y el movimiento reales no se conocen
inspect-waves = la explican { $waves } ondas por vuelta; quedan { $left } RMS como ruido
inspect-rms = error de fuerza RMS: según diseño { $before }, fabricada { $after } { $unit }
inspect-max = error de fuerza máximo: según diseño { $before }, fabricada { $after } { $unit }
inspect-least-force = fuerza mínima: según diseño { $before }, fabricada { $after } { $unit }
inspect-most-force = fuerza máxima: según diseño { $before }, fabricada { $after } { $unit }
inspect-acceleration = aceleración máxima: según diseño { $before }, fabricada { $after } { $unit }
inspect-liftoff = velocidad de pérdida de contacto: según diseño { $before }, fabricada { $after } { $unit }
inspect-lifts-off = esta leva pierde el contacto a la velocidad de la escena
# Electronic cams.
synth-no-ecam = sin leva electrónica: { $fault }
ecam-no-cam = no hay leva que ejecutar: { $why }
ecam-file = Archivo { $file }.
ecam-quintic = quíntica
ecam-cubic = spline cúbica
ecam-below = menos de { $least }
ecam-force = { $file }: { $points } intervalos, { $curve }, { $number }; error de fuerza con este control { $error } N RMS, de ellos el archivo añade un { $added } % de la media
ecam-law = { $file }: { $points } intervalos, { $curve }, { $number }; con este control la fuerza se aparta de la ley { $error } N RMS, un { $added } % de la mayor
ecam-acceleration = { $file }: { $points } intervalos, { $curve }, { $number }; la aceleración se aparta de la ley un { $added } % de la mayor, RMS

# identify, recut.
identify-no-cam = no hay leva que haya podido funcionar: { $why }
recut-error = error de fuerza medido antes { $before } N RMS, previsto después de este corte { $after } N RMS
