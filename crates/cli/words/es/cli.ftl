# Errores de la orden: archivos, opciones, carpetas.
cli-negative-ball = el radio de una bola palpadora debe ser 0 o más, no { $typed }
cli-cannot-open = no se puede abrir ({ $fault })
cli-scene-name = «{ $shown }» { $fault ->
        [blank] está en blanco
        [dash] empieza por un guion
        [control] contiene un carácter de control o una marca invisible
       *[not-plain] no es un nombre de archivo simple
    }
    .help = use letras, cifras, - y _, porque los resultados se escriben en out/NOMBRE, o indique otra carpeta con --out
cli-few-rows = valor no válido { $rows }
    .help = se necesitan al menos { $least } puntos; menos solo son posibles con --front
cli-not-stances = { $file } no es ni un archivo .csv nuevo ni una tabla de apoyos
    .help = solo se puede reemplazar una tabla de apoyos existente; dé otro nombre terminado en .csv
cli-stances-of-several = se nombran varios registros, pero { $table } solo puede contener una tabla
    .help = nombre un registro, o lea los registros uno por uno
cli-cycle-ending = { $file } no es ni un archivo .csv o .mot ni una carpeta
    .help = el ciclo se escribe como .csv o .mot, con figuras .svg y .png en la misma carpeta
cli-table-changed = la tabla se modificó después de terminar el barrido
    .help = muévala para calcularla de nuevo
cli-cams = «{ $typed }» no es un número de levas
    .help = escriba un número, o el primero y el último, como 3 o 1:6; el máximo es { $most }
cli-among-recordings = los resultados se escribirían entre los registros de { $folder }
    .help = dé otra carpeta
cli-not-cover = esto no es una tabla de gaitcam cover
    .help = dé la carpeta de resultados de gaitcam cover
cli-recording-not-scene = esta opción cambia una escena, pero el archivo es un registro
    .help = use las opciones de gaitcam gait
cli-scene-not-recording = el archivo es una escena, no un registro
    .help = use gaitcam synth o gaitcam doctor para la escena, o indique el registro de su clave gait.file
cli-no-key-contains = ninguna clave contiene «{ $pattern }»
cli-input-time = la entrada no se leyó en { $limit } s
    .help = termine la entrada, o fije un --time-limit mayor
cli-no-model = «{ $typed }» no es un modelo
    .help = escriba auto, rigid, flexible o contact
cli-no-walk = el diseño no tiene un registro con ocho o más zancadas consecutivas
    .help = indique el registro de una marcha: gaitcam walk RESULTADO REGISTRO
cli-nothing-to-walk = un programa de velocidad requiere la fuerza objetivo de un caminante y una leva que gire una vez por ciclo de fuerza
    .help = dé una escena con un modelo de carga o un registro
cli-varies-too-much = el coeficiente de variación debe estar entre 0 y { $most }
    .help = la duración del paso de personas sanas varía del 1 al 4 %
cli-strides-missing = se piden { $count } zancadas, pero solo hay { $recorded } zancadas consecutivas registradas
    .help = indique un número menor o use un registro con más zancadas; menos de ocho zancadas consecutivas no se usan
cli-few-strides = el registro solo tiene { $strides } zancadas consecutivas de ambos pies; se requieren al menos { $needed }
    .help = registre una marcha más larga en cinta o con plantillas; gaitcam gait --stances enumera los contactos rechazados
cli-clipped-walk = la fuerza está recortada, así que no se conoce su amplitud
    .help = registre de nuevo con un rango mayor del amplificador
cli-programme-column = el programa de velocidad no tiene la columna { $column }
    .help = escriba los nombres de las columnas en la primera línea: time_s,speed_rad_per_s
cli-speeds = { $typed } no es un intervalo de velocidades
    .help = escriba la primera velocidad, la última y el número de velocidades (de 2 a { $most }): --speeds '1.4 Hz:2.3 Hz:10'
cli-cam-is-made = el perfil de este resultado está terminado; un cambio de { $key } requiere un diseño nuevo
    .help = cambie solo claves de drive y machine, o diseñe una leva nueva con gaitcam synth SUMMARY.json --set …
cli-broken-table = { $fault }
    .help = escriba la tabla de nuevo con gaitcam synth
cli-field-not-number = un campo no es un número
    .help = escriba la tabla de nuevo con gaitcam synth
cli-empty-table = la tabla no tiene filas
cli-no-blocks = esta carpeta no contiene bloques de un barrido; indique la tabla de gaitcam sweep, o la carpeta de sus bloques (gaitcam sweep --shard)
cli-not-sweep-table = el archivo no es la tabla de un barrido, porque no tiene la columna «{ $column }»
    .help = indique el archivo de resultados de gaitcam sweep
cli-no-parquet = este gaitcam se compiló sin Parquet (la opción «parquet»)
    .help = use una tabla .csv, o compile gaitcam con --features parquet
cli-table-ending = { $file } no es ni .csv ni .parquet
    .help = use una de estas extensiones
cli-no-base-scene = el archivo no contiene la escena base de esta fila
cli-row-not-number = fila { $row }: «{ $cell }» no es un número
cli-nothing-varies = la rejilla está vacía: no se varía ninguna clave
    .help = escriba --vary 'limits.stroke=20 mm:60 mm:5', --list ARCHIVO.csv o --recordings CARPETA
cli-list-value = { $fault }
cli-list-cell = falta un valor
    .help = cada fila requiere un valor de cada clave
cli-empty-list = la rejilla está vacía: la lista no tiene filas
    .help = escriba las claves en la primera línea y sus valores en cada línea siguiente
cli-no-recordings = la carpeta no contiene ningún archivo
    .help = indique una carpeta con registros, cuyos nombres terminan en { $endings }
cli-not-recordings = ninguno de { $files } archivos tiene la extensión de un registro
    .help = indique una carpeta con registros, cuyos nombres terminan en { $endings }
cli-many-rows = la tabla tendría { $rows } filas
    .help = use menos valores o un --sample menor, o confirme el tamaño con --yes; --estimate predice el tiempo de cálculo
cli-scatter-csv = las muestras de --tolerance solo se pueden escribir como .csv
cli-too-many-samples = valor no válido { $count }
    .help = el máximo es { $most }
cli-no-sample = el número de muestras es cero
cli-partial-rows = la carpeta contiene { $rows } filas de un barrido interrumpido
    .help = continúe con --resume, o borre la carpeta para empezar de nuevo
cli-not-partial = la carpeta no es la tabla parcial de un barrido
    .help = mueva la carpeta, o elija otro --out
cli-rows-safe = no se puede escribir ({ $fault })
    .help = la tabla contiene { $rows } filas completas: libere espacio y continúe con --resume
cli-all-rows-safe = no se puede escribir ({ $fault })
    .help = todas las filas están guardadas en la misma carpeta: libere espacio y continúe con --resume
cli-cannot-repair = no se puede reparar ({ $fault })
cli-file-is-there = el archivo ya existe y no se sobrescribe
    .help = dé otro nombre con --out
cli-unknown-flag = opción desconocida
    .help = { $near ->
        [none] gaitcam ORDEN --help enumera las opciones
       *[other] ¿quería decir { $near }?
    }
cli-one-too-many = sobra un argumento
    .help = ponga entre comillas los valores que contienen espacios: --set 'limits.stroke=40 mm'
cli-unknown-verb = «{ $typed }» no es una orden
    .help = { $near ->
        [none] gaitcam --help enumera las órdenes; escriba la escena después de la orden: gaitcam synth ESCENA.toml
       *[other] ¿quería decir { $near }?
    }
cli-in-lab = «{ $typed }» está ahora en el laboratorio del repositorio: cargo run --release -p gaitcam-lab -- { $typed }
cli-flag-without-value = falta un valor
cli-flag-choice = «{ $typed }» no es una opción válida
    .help = escriba una de: { $choices }
cli-flag-value = valor no válido «{ $typed }»
    .help = { $fault }
cli-flag-whole = valor no válido «{ $typed }»
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
run-no-command = No se da ninguna orden, así que se diseña la leva de la escena incorporada footbridge. `gaitcam --help` muestra las órdenes.
run-stdout = la salida no se puede escribir en la salida estándar ({ $fault })
run-files = Los archivos están en { $folder }; abra primero { $first }.

# synth: rótulos de las filas del resumen.
label-failed = FALLA
label-ok = cumple
label-force = fuerza
label-law = ley
label-drive = accionamiento
label-cam = leva
label-machine = máquina
label-floor = suelo
label-resonance = resonancia
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
    }, { $worst } % en el peor caminante ({ $who })
synth-walkers-n = { $count }: error de fuerza de { $mean } N en promedio, { $cvar } N en { $tail ->
        [tenth] la peor décima parte
       *[other] el peor { $tail } %
    }, { $worst } N en el peor caminante ({ $who })
synth-shaft = { $low } … { $high } rad/s, oscilación { $ripple } %; motor: velocidad en vacío { $noload } rad/s, par { $rms } N·m RMS, máximo { $most } N·m
synth-shaft-error = error de fuerza en el tiempo { $own } % de la media; { $before } % con la ley para velocidad constante{ $rounds ->
        [0] {""}
        [one] {"; "}una iteración
       *[other] {"; "}{ $rounds } iteraciones
    }
synth-shaft-sensitivity = con un 10 % menos o más de { $list }
synth-shaft-differs = { $key }: { $less } %, { $more } %
synth-active = límite { $limit } { $points ->
        [1] en { $at }
       *[other] en { $points } puntos, multiplicador máximo en { $at }
    }
synth-relaxing = { $limit } un 1 % hasta { $to }: { $name } { $after } { $unit } en lugar de { $before } { $unit }
synth-solved = método { $tier }, { $solve } ms de { $total } ms: { $status }
synth-certified = { $family ->
        [spline] demostrado: ninguna spline de este grado con estos tramos es mejor con estos límites
       *[other] demostrado: ninguna ley de esta familia es mejor con estos límites
    }
synth-uncertified = no se certifica como óptimo: { $why }
synth-optimum = brecha de dualidad relativa { $gap }, error de optimalidad { $kkt }, violación de restricciones { $violation }
synth-no-sequence = no fue necesaria
synth-sequence = { $count } programas convexos
synth-step-head = paso radio primario           objetivo    holgura relativa      longitud
synth-ended = detenida: { $why }
synth-no-solid = no se escribió el sólido: { $fault }
synth-no-step = no se escribió el archivo STEP: { $fault }
synth-no-program = no se escribió el programa para la máquina: { $fault }
synth-gouge-hollow = el radio de la fresa es demasiado grande para el perfil cóncavo en { $at }; el máximo es { $radius }
synth-gouge-elsewhere = mientras la fresa corta el perfil en { $at }, penetra { $depth } en el perfil en { $damaged }
synth-gouge-undercut = el perfil tiene rebaje en { $at } y no se puede mecanizar

# synth --front.
trade-stopped = El límite de tiempo terminó la búsqueda y faltan puntos del frente. Fije un --time-limit mayor.
trade-none = ningún punto del frente tiene una leva factible
trade-title = { $name }: error de fuerza mínimo para cada { $quantity }

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
simulate-speeds-none = el eje se para: { $why }
simulate-no-target = no hay objetivo a esta velocidad: { $why }
simulate-as-made = la leva fabricada, a { $rpm } rpm
simulate-designed-again = la leva se diseñó para este drive.speed; use --speed para simularla a otra velocidad

# sweep.
sweep-skipped = se omiten { $count } archivos de la carpeta que no son registros ({ $first }{ $count ->
        [1] {""}
       *[other] {" …"}
    })
sweep-complete = { $file } ya está completa.
sweep-stopped = detenido tras { $done } de { $rows } filas; las filas calculadas están guardadas; continúe con --resume
sweep-counts = { $rows } filas en { $file }: { $built } construidas ({ $acceptable } aceptables, { $slow } no para alta velocidad), { $infeasible } no factibles, { $errors } errores
sweep-estimate = { $rows } diseños tardan unos { $time } con { $threads } hilos ({ $core } horas de núcleo): { $rate } por segundo y núcleo, medidos con { $computed } diseños
sweep-rate = { $designs } diseños en { $seconds } s, { $rate } por segundo
sweep-first-error = Primer error, fila { $row }: { $fault }
sweep-damaged = { $file } está dañado, así que sus filas se calculan de nuevo
sweep-no-design = no se pueden aplicar tolerancias sin un diseño: { $why }
sweep-samples = { $name }: { $count } muestras fabricadas; error de fuerza según diseño { $own } % de la media
sweep-spread = dispersión media { $mean } %, desviación típica { $deviation } %, 5 % a 95 %: { $p5 } % … { $p95 } %, mediana { $median } %, máximo { $largest } %
sweep-yield = rendimiento { $within } % de las levas tiene un error de fuerza de { $band } % como máximo
sweep-scatter-files = Las muestras están en { $file }, las figuras en { $page }.
sweep-shard = escriba I/N con I de 1 a N, por ejemplo 3/16 para la tercera de dieciséis partes (0/16 equivale a 16/16)
sweep-shard-done = { $folder }: { $rows } filas calculadas, { $left ->
        [0] todos los bloques están completos
        [one] falta un bloque
       *[other] faltan { $left } bloques
    }
sweep-designs = diseños
sweep-progress = { $done }/{ $total } { $what }, { $rate }/s, faltan { $left }

# sweep --tolerance: el informe.
scatter-title = { $name }: dispersión de fabricación
scatter-how = Cada muestra es la leva con errores aleatorios distribuidos uniformemente en las tolerancias. Se calcula el error de fuerza de cada muestra.
scatter-heading = Error de fuerza de las muestras fabricadas
scatter-picture = { $name }: error de fuerza de las muestras fabricadas
scatter-axis = error de fuerza RMS, % de la media
scatter-own = según diseño
scatter-band = banda
scatter-by-design = Según diseño
scatter-of-mean = de la fuerza media, RMS
scatter-median = Mediana de las muestras
scatter-below = El 95 % de las muestras queda por debajo de
scatter-largest = Máximo
scatter-yield = Rendimiento
scatter-within = dentro de { $band } %
scatter-tolerances = Tolerancias
scatter-tolerance = tolerancia

# front.
front-none-built = { $file }: no se construyó ningún diseño
front-none-feasible = { $file }: ningún diseño es aceptable (--all incluye los inaceptables)
front-counts = { $file }: { $candidates } de { $seen } diseños son admisibles; { $front } de ellos son no dominados
front-missing = { $count ->
        [one] la fila { $list } falta en la carpeta y en el frente
       *[other] { $count } filas faltan en la carpeta y en el frente ({ $list })
    }. Inicie de nuevo el mismo barrido para calcular las filas que faltan
front-low-speed = { $count ->
        [one] se omite un diseño que no es
       *[other] se omiten { $count } diseños que no son
    } para alta velocidad; --low-speed los incluye
front-row = fila
front-best = mejor compromiso
front-more = … { $count } más en front.csv; mejor compromiso: fila { $row }
front-page-title = Barrido { $name }
front-page-counts = { $seen } diseños, { $candidates } de ellos admisibles; { $front } son no dominados en { $text }. El mejor compromiso es la fila { $row }.
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
cover-bound-worst = minimizado: el peor error; cota: cota inferior para este número de levas; otros: error de caminantes nuevos, por validación cruzada en cinco grupos
cover-bound-mean = minimizado: el RMS de los errores; cota: cota inferior para este número de levas; otros: error de caminantes nuevos, por validación cruzada en cinco grupos
cover-bound-tail = minimizado: el RMS de los errores de los peores caminantes; cota: cota inferior para este número de levas; otros: error de caminantes nuevos, por validación cruzada en cinco grupos
cover-stopped = El límite de tiempo terminó la búsqueda antes de examinar todos los números de levas. Fije un --time-limit mayor.
cover-cut = El límite de tiempo terminó la búsqueda; puede haber asignaciones mejores. Fije un --time-limit mayor.
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
against-reason = mayor componente del error

# compare.
compare-diagrams = Diagramas en { $folder }
compare-title = Comparación de { $name }
compare-figures = Valores
compare-verdict = veredicto
compare-outcome = resultado
compare-law = ley
compare-follower = seguidor
compare-built = construida
compare-infeasible = no factible
compare-over-angle = ángulo de leva θ, grados
compare-over-travel = recorrido de la leva x, { $unit }
compare-over-both = ángulo de leva θ, grados; para una leva de traslación su recorrido, { $unit }
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
explain-motor = la velocidad del eje con el motor
explain-forecast = la inercia y la energía alterna dan una oscilación estimada de { $ripple } % y un cambio de la fuerza de { $change } % de la media (RMS); se desprecia un cambio de hasta { $neglected } %{ $enough ->
        [true] {": "}basta la velocidad constante
       *[other] {""}
    }

# keys.
keys-default = por defecto { $text }

init-shaker = Una masa sobre la leva que excita una pasarela como un caminante: F = M (g + d²s/dt²).
init-walk = Una leva para su propio registro de marcha, reproducido por una masa sobre la leva.
init-heel-tester = Una ensayadora de tacones: la elevación comprime aceite o aire en un cilindro, y la fuerza crece con la elevación. Para un registro propio, escriba file = "walk.csv" en lugar de model, step_frequency y body_weight.
init-spring-bench = Un banco de ensayo con muelle para pies protésicos, calzado o articulaciones: F = F₀ + k s + m d²s/dt².
init-programme = Una leva clásica de un programa de subidas, bajadas y detenimientos, sin fuerza objetivo.
init-written = se ha escrito { $file }
init-how = Diseñe la leva con gaitcam synth { $file }. Muestre todas las claves con gaitcam keys. Las líneas que empiezan por «# clave =» son opciones inactivas.
doctor-toml = { $file }: { $keys } valores
doctor-keys-right = todas las claves existen y todos los valores están en su intervalo
doctor-faults = { $count ->
        [one] Hay un fallo. Corríjalo y ejecute la orden de nuevo.
       *[other] Hay { $count } fallos. Corríjalos y ejecute la orden de nuevo.
    }
doctor-one-cycle = { $file }: un ciclo de { $period } s
doctor-recording = { $file }: { $columns ->
        [one] una columna de fuerza
       *[other] { $columns } columnas de fuerza
    }, { $used ->
        [one] un apoyo utilizado
       *[other] { $used } apoyos utilizados
    }, { $rejected } descartados
doctor-unacceptable = El registro no se puede usar: { $sentence }. Indique otro registro u otra columna.
doctor-doubt = No es seguro: { $sentence }. Compruébelo. Indique después la clave con el dato que falta, o acepte lo supuesto con gait.accept = "{ $name }".
doctor-recording-options = Los datos que faltan se pueden indicar con gait.time, gait.force, gait.unit, gait.rate, gait.mass, gait.kind, gait.period (véase gaitcam keys gait).

# inspect.
inspect-no-cam = no hay leva con que comparar: { $why }
inspect-fit = { $points } puntos; la leva está girada { $turn }°, con su centro en x { $x }, y { $y }
inspect-alike = la leva es simétrica, así que ajusta igual de bien después de un giro de { $others }
inspect-deviation = desviación según la normal: { $rms } µm RMS, de { $least } µm en { $below } a { $most } µm en { $above }
inspect-outliers = { $count } { $count ->
        [one] punto se excluye, porque difiere
       *[other] puntos se excluyen, porque difieren
    } en hasta { $most } µm de los demás (líneas { $lines })
inspect-part = el perfil no se midió entre { $from } y { $to }, así que la fuerza y el movimiento de la leva fabricada no se conocen
inspect-waves = { $waves } armónicos de la vuelta describen la desviación; el ruido es { $left } RMS
inspect-rms = error de fuerza RMS: según diseño { $before }, fabricada { $after } { $unit }
inspect-max = error de fuerza máximo: según diseño { $before }, fabricada { $after } { $unit }
inspect-least-force = fuerza mínima: según diseño { $before }, fabricada { $after } { $unit }
inspect-most-force = fuerza máxima: según diseño { $before }, fabricada { $after } { $unit }
inspect-acceleration = aceleración máxima: según diseño { $before }, fabricada { $after } { $unit }
inspect-liftoff = velocidad de pérdida de contacto: según diseño { $before }, fabricada { $after } { $unit }
inspect-lifts-off = esta leva pierde el contacto a la velocidad de la escena
# Levas electrónicas.
synth-no-ecam = no se escribió la leva electrónica: { $fault }
# walk: el programa de velocidad de una marcha registrada.
walk-no-cam = no hay leva para el programa de velocidad: { $why }
walk-strides = { $strides } zancadas registradas, { $duration } s, duración del paso ± { $time } %; el programa tiene las duraciones registradas con { $error } ms
walk-generated = { $strides } zancadas generadas, { $duration } s, duración del paso ± { $time } %; el programa tiene las duraciones generadas con { $error } ms
walk-misfit = amortiguamiento, %: { $dampings }; desajuste de la respuesta: { $misfit }; máximo respecto de la marcha: { $peak }
walk-constant = a velocidad constante: desajuste { $misfit }; máximo { $peak }
walk-motion = velocidad { $low } … { $high } rad/s, aceleración hasta { $acceleration } rad/s², par hasta { $torque } N·m
walk-force = fuerza { $low } … { $high } N; diferencia RMS respecto a la fuerza de la marcha { $error } N
walk-amplitude = la amplitud a la frecuencia de paso varía ± { $own } % con el programa y ± { $recorded } % en la marcha; una leva solo la varía junto con la duración del paso
walk-pace = la duración de la zancada cambia un { $change } % del primer al último cuarto de las zancadas; registre una marcha uniforme o recorte el registro
walk-file = El programa está en { $file }. Ejecútelo con gaitcam simulate RESULTADO --speed-programme.
programme-kept = la leva mantiene el contacto y todos los límites de fuerza y par
programme-lost = la leva pierde el contacto
programme-broken = la leva incumple un límite
programme-force = fuerza { $low } … { $high } N
programme-limit = { $limit }: { $worst }, límite { $bound } (SI)

ecam-no-strides = no hay leva electrónica: { $why }
ecam-strides = las zancadas se repiten tras { $duration } s; amortiguamiento, %: { $dampings }; desajuste de la respuesta: { $misfit }; máximo respecto de la marcha: { $peak }
ecam-no-cam = no hay ninguna leva que simular: { $why }
points-file = { $count } puntos en { $unit }: { $file }
ecam-file = Archivo { $file }.
ecam-quintic = quíntica
ecam-cubic = spline cúbica
ecam-below = menos de { $least }
ecam-force = { $file }: { $points } intervalos, { $curve }, { $number }; error de fuerza con este control { $error } N RMS; desviación RMS respecto a la fuerza diseñada { $added } % de la media
ecam-law = { $file }: { $points } intervalos, { $curve }, { $number }; desviación RMS respecto a la fuerza diseñada { $error } N con este control ({ $added } % de la fuerza máxima)
ecam-acceleration = { $file }: { $points } intervalos, { $curve }, { $number }; desviación RMS respecto a la aceleración diseñada { $added } % de su máximo

# identify, recut.
identify-no-cam = la escena de este registro no tiene leva: { $why }
recut-error = error de fuerza medido antes { $before } N RMS, previsto con la nueva leva { $after } N RMS
