# Curvas de fuerza, modelos de carga, registros y su ciclo medio.

force-few-samples = un ciclo de fuerza de { $samples } muestras es demasiado corto
    .help = dé al menos 4 muestras por ciclo
force-lengths = se dan { $times } tiempos para { $forces } fuerzas
    .help = dé una fuerza para cada tiempo
force-sample-not-finite = la muestra de fuerza { $sample } no es un número finito
    .help = cada muestra debe ser un número finito de newtons
force-period-not-positive = período no válido { $period }
    .help = el período debe ser positivo
force-unknown-feet = valor no válido «{ $word }» para feet
    .help = use both, one, left, right o total
force-unknown-kind = «{ $word }» no es un tipo de movimiento
    .help = los tipos son walking, running, standing, jumping, sit-to-stand y other; el ciclo medio se calcula para walking (marcha) y running (carrera)
force-unknown-doubt = «{ $word }» no es una propiedad que se pueda aceptar
    .help = indique solo las propiedades del registro que ha comprobado: kind (tipo), clock (tiempo), mass (masa)
force-no-joint-mean = { $trials ->
        [one] el registro no da
       *[other] ninguno de los { $trials } registros da
    } un ciclo para una media conjunta
    .help = la tabla contiene los motivos; indique en gait.file un solo ciclo
force-unknown-unit = «{ $word }» no es una unidad de fuerza
    .help = las unidades son N, daN, kN, lbf, kgf, N/kg, BW y %BW
force-unknown-model = «{ $name }» no es un modelo de carga
    .help = los modelos de carga son { $known }
force-misspelt-model = «{ $name }» no es un modelo de carga
    .help = ¿quiso decir «{ $near }»?
force-weight-not-positive = peso corporal no válido { $weight }
    .help = debe ser positivo, por ejemplo "700 N"
force-frequency-out-of-range = { $model } no está definido para una frecuencia de paso de { $frequency }
    .help = dé un valor de { $low } a { $high }
force-frequency-missing = { $model } requiere una frecuencia de paso
    .help = indique por ejemplo step_frequency = "1.85 Hz"
force-both-feet-only = { $model } da la fuerza total de ambos pies, no la de un pie
    .help = use feet = "both" o un modelo de un solo pie: li-2010, iso-22675
force-clock-implausible = con la columna de tiempo en milisegundos una zancada dura { $period }, lo que no es verosímil al caminar
    .help = la columna puede contar muestras: indique la frecuencia de muestreo (opción rate)
force-running = el registro de { $duration } muestra carrera (contactos cortos con fases de vuelo entre ellos)
    .help = use kind = "running" para un ciclo de carrera, o dé un registro de marcha
force-not-walking = el registro de { $duration } no muestra marcha: { $movement ->
        [standing] la carga apenas cambia, como al estar de pie
        [jumping] ambos pies dejan el suelo o caen a la vez
        [sit-to-stand] la carga sube desde el peso de los pies hasta el peso corporal
       *[other] la marcha no es periódica
    }
    .help = dé un registro de marcha o carrera; para pasos muy lentos use kind = "walking"; para cualquier otra fuerza periódica use gait.period
force-total-of-both-feet = el registro de { $duration } no contiene ningún apoyo completo de un pie: la columna es la fuerza total de ambos pies, que no vuelve a cero
    .help = use feet = "both"
force-no-stance = el registro de { $duration } no contiene ningún apoyo completo de marcha
    .help = { $contacts ->
        [one] se encontró un contacto, de { $from } a { $to }
       *[other] se encontraron { $contacts } contactos, el primero de { $from } a { $to }
    }; motivo de rechazo más frecuente: { $reason }
force-no-stance-file-cut = el registro de { $duration } no contiene ningún apoyo completo de marcha: la cabecera indica { $announced } filas, pero el archivo tiene { $found }
    .help = exporte el ensayo completo; motivo de rechazo más frecuente: { $reason }
force-force-too-low = ningún canal lleva carga en el registro de { $duration }: la fuerza máxima es { $peak }
    .help = si la fuerza está en N/kg o en pesos corporales, indique su unidad (opción unit) y la masa (opción mass)
force-no-live-channel = el registro de { $duration } no contiene ningún apoyo completo de marcha, porque ningún canal lleva carga
    .help = indique la columna de fuerza (opción force)
force-no-contact = el registro de { $duration } no contiene ningún apoyo completo de marcha, porque ningún canal supera 20 N
    .help = compruebe la unidad de fuerza y la columna de fuerza (opciones unit y force)
force-no-stance-of-foot = el registro no contiene ningún apoyo completo del pie { $foot }
    .help = todos los apoyos son del otro pie; use feet = "one" o "both"
force-feet-not-named = el registro no contiene ningún apoyo completo del pie { $foot }
    .help = el archivo no identifica los pies; use feet = "one" o "both"

note-rows-differ = la cabecera indica { $announced } filas, pero el archivo tiene { $found }
note-frames-missing = la cabecera indica { $announced } cuadros, pero el archivo tiene { $found }
note-lines-skipped = se omitieron líneas sin una fila de números; la primera es la línea { $first-line }
note-insole-columns = las columnas { $left } y { $right } son las sumas de dos grupos iguales de sensores; se usan como plantilla izquierda y derecha
note-insole-beside-plate = la tabla contiene fuerzas de una plataforma ({ $plate }) y de una plantilla ({ $insole }), y se usa la plataforma; para usar la plantilla, indique sus columnas (opción force)
note-stance-per-row = la tabla tiene un apoyo por fila, { $rows } filas
note-masses-missing = la masa se conoce en { $known } de { $rows } apoyos; añada las demás a la tabla de sujetos (metadata)
note-durations-lost = todos los apoyos tienen { $samples } muestras, de modo que se desconoce su duración; se supone una duración de { $assumed }
note-rate-guessed = la tabla no tiene frecuencia de muestreo; la frecuencia supuesta de { $rate } da apoyos de { $stance }; si no son correctos, indique la frecuencia (opción rate)
note-rate-overrides-times = la frecuencia indicada, { $rate }, sustituye a la de la columna de tiempo, { $column }
note-time-unit-guessed = la columna de tiempo tiene incrementos de { $step }; la unidad supuesta es { $unit ->
        [ms] milisegundos
        [us] microsegundos
       *[ns] nanosegundos
    }
note-samples-missing = { $count ->
        [one] falta una muestra
       *[other] faltan { $count } muestras
    }, la primera cerca de { $first }; la frecuencia de muestreo se calcula con las muestras presentes
note-rates-differ = la cabecera da una frecuencia de { $header }, pero la columna de tiempo da { $column }; se usa la columna de tiempo
note-uneven-samples = las muestras no son equidistantes en el tiempo y se remuestrearon a intervalos constantes
note-unit-guessed = no se da la unidad de fuerza; el pico de { $peak } indica { $unit }
note-unit-label-rejected = un pico de { $peak } no es verosímil en { $label }; se supone la unidad { $unit }
note-low-force = ninguna fuerza supera { $peak }; si las fuerzas están en pesos corporales, indique la unidad BW y la masa (opciones unit y mass)
note-vertical-guessed = las componentes { $vertical } y { $other } son de magnitud similar; { $vertical } se usa como fuerza vertical
note-feet-guessed = ground_force se usa para el pie derecho y 1_ground_force para el izquierdo (convenio de los ejemplos de OpenSim)
note-no-plates = el archivo no describe ninguna plataforma de fuerza; los canales analógicos se eligen por sus etiquetas
note-plate-type-unknown = se omite la plataforma { $plate }, porque TYPE { $kind } no se admite (se admiten 1 a 7); para usarla, indique su canal de fuerza
note-plate-channel-missing = se omite la plataforma { $plate }, porque su canal { $channel } no está en el archivo
note-plate-matrix-missing = se omite la plataforma { $plate }: falta su matriz de calibración
note-plate-tilted = la plataforma { $plate } no es paralela a la plataforma 1: como máximo una de sus fuerzas normales es vertical
note-insole-mass = la masa de { $mass } se calcula con la fuerza total media de las plantillas, que rara vez están calibradas; indique la masa de la persona
note-clipped = { $column } está recortada: sus lecturas no superan unos { $level }, por debajo de los picos de la fuerza
note-missing-is-unloaded = faltan muestras de { $column } entre sus contactos; se supone que ahí la plataforma no tiene carga
note-spikes-removed = { $count ->
        [one] una muestra aislada de { $column } en { $first } difiere mucho de sus dos vecinas y se ha sustituido
       *[other] { $count } muestras aisladas de { $column } difieren mucho de sus dos vecinas (la primera en { $first }) y se han sustituido
    } por una línea recta
note-drop-outs = las lecturas de { $column } son cero bajo carga { $count ->
        [one] una vez, en { $first }
       *[other] { $count } veces, la primera en { $first }
    } (muestras perdidas); los apoyos con esos huecos no se usan
note-unloaded-differs = la lectura sin carga de { $column } es { $level } entre contactos, pero { $at-ends } en ambos extremos del registro. La diafonía o un cambio de la lectura sin carga hace incierta la masa. Indique la masa (opción mass)
note-stance-fills-span = { $stances ->
        [one] el apoyo de { $from } a { $to } ocupa la parte de la vuelta
       *[other] la media de { $stances } apoyos, el primero de { $from } a { $to }, ocupa la parte de la vuelta
    }; en el resto no hay carga
note-cross-talk-removed = mientras { $column } está sin carga, muestra un { $share } de la fuerza de { $of } (diafonía); esta parte se restó
note-column-repeats = { $column } repite { $original } (sin filtrar y filtrada, o una copia) y se ha omitido
note-drift-removed = la lectura sin carga de { $column } deriva { $rise } por segundo; la deriva se ha eliminado
note-stride-varies = la duración de la zancada es { $period } ± { $spread }, propia de varias velocidades o de una marcha no estable; indique un registro a una sola velocidad
note-stride-from-one = la duración de la zancada, { $period }, se mide en un solo paso o zancada y tiene una incertidumbre de { $error }; la incertidumbre resultante de la carrera es { $stroke }
note-one-foot-for-both = { $stances ->
        [one] un apoyo de un pie se repite
       *[other] { $stances } apoyos de un pie se promedian y se repiten
    } con medio ciclo de diferencia para el otro pie (gait.feet = "both"); gait.feet = "one" da la fuerza de un pie
note-stride-assumed = el registro no contiene la duración de la zancada; se supone { $period }, con un apoyo del { $duty } de la zancada. Indique la masa, la duración de la zancada o el ángulo del apoyo (opciones mass, period y span)
note-stride-implausible = la zancada de { $period } no es verosímil en este movimiento (intervalo de { $low } a { $high }): compruebe la frecuencia de muestreo y el tipo (opciones rate y kind)
note-duty-implausible = un apoyo de { $duty } de la zancada no es verosímil en este movimiento (intervalo de { $low } a { $high }): compruebe el tipo y la frecuencia de muestreo (opciones kind y rate)
note-peak-implausible = una fuerza máxima de { $ratio } pesos corporales no es verosímil en este movimiento (intervalo de { $low } a { $high }): compruebe masa, unidad y tipo (opciones mass, unit y kind)
note-mean-force-not-weight = la fuerza media de una zancada es { $ratio } veces { $share ->
        [half] la mitad del
       *[whole] el
    } peso de { $mass }, pero la razón esperada es 1: la masa, la unidad de fuerza o su calibración es incorrecta, o falta un pie
note-mass-implausible = una fuerza media de { $mean } en una zancada corresponde a una persona de { $mass }: la unidad de fuerza o su calibración es incorrecta, o falta un pie
note-unit-unconfirmed = no se da la unidad de fuerza, y { $unit } daría una masa inverosímil de { $mass }: indique la unidad o la masa (opciones unit y mass)
note-left-open = el archivo es el ciclo medio de un registro para el que no se respondió esta pregunta
note-clock-differs = la columna de tiempo abarca { $clock }, pero el período dado es { $period }: los tiempos se escalan al período dado
note-count-or-milliseconds = la columna de tiempo no tiene unidad y aumenta de 1 en 1. Cuenta muestras, o está en milisegundos y una zancada dura { $stride }. Indique la frecuencia de muestreo (opción rate)
note-kind-differs = se indica kind { $typed }, pero los contactos muestran { $movement ->
        [running] { kind-running }
        [standing] { kind-standing }
        [jumping] { kind-jumping }
        [sit-to-stand] { kind-sit-to-stand }
        [walking] { kind-walking }
       *[other] { kind-other }
    }
note-speed-changes = la velocidad cambia durante el registro; la media se calcula con { $used } de { $stances } apoyos o pasos que duran de { $low } a { $high }, el mayor grupo de una misma velocidad
note-few-alike = solo { $used } de { $stances } contactos de una marcha regular tienen una duración similar; los demás se excluyen (contactos parciales o de ambos pies)
note-stances-differ = los apoyos difieren en { $share }; se espera como máximo { $most } (parte del peso corporal, o del impulso medio de ambos pies). Causas posibles: contactos parciales, diafonía, dos pies en una plataforma o pies distintos. Indique la masa (opción mass) o las columnas de apoyos enteros (opción force)
note-total-column = la columna se usa como la fuerza total de ambos pies
note-plates-summed = los pies pasan de una plataforma a otra, así que el ciclo medio se calcula con la suma de { $plates } plataformas, que siempre soportan a la persona
note-several-masses = los registros muestran personas con masas de { $low } a { $high }: las fuerzas se promedian en pesos corporales y se escalan a { $mean }
note-counts-scaled = las lecturas son cuentas del convertidor sin calibración; se escalan de modo que la fuerza media sea el peso de { $mass }

cycle-whole-strides = { $strides ->
        [one] una zancada completa
       *[other] { $strides } zancadas completas
    } de ambos pies{ $from ->
        [left] , desde el contacto del talón izquierdo
        [right] , desde el contacto del talón derecho
       *[none] {""}
    }
cycle-right-and-left = fuerza de ambos pies juntos, de { $right ->
        [one] un apoyo derecho
       *[other] { $right } apoyos derechos
    } y { $left ->
        [one] uno izquierdo
       *[other] { $left } izquierdos
    }, separados media zancada; duración de la zancada: { $period }
cycle-two-feet = fuerza de ambos pies juntos, de { $one ->
        [one] un apoyo
       *[other] { $one } apoyos
    } de un pie y { $other } del otro, separados media zancada; duración de la zancada: { $period }
cycle-any-foot = fuerza de ambos pies juntos, de { $stances ->
        [one] un apoyo, repetido
       *[other] { $stances } apoyos, repetidos
    } a media zancada; duración de la zancada: { $period }
cycle-one-foot = { $stances ->
        [one] un apoyo
       *[other] { $stances } apoyos
    } de un pie; duración de la zancada: { $period }
cycle-total-force = { $strides ->
        [one] una zancada
       *[other] { $strides } zancadas
    } de la fuerza total de ambos pies, entre cruces ascendentes de la fuerza media

kind-walking = marcha
kind-running = carrera
kind-standing = de pie
kind-jumping = salto
kind-sit-to-stand = levantarse de la silla
kind-other = otro movimiento

open-kind = el tipo de movimiento
open-clock = la escala de tiempo
open-mass = la masa y la unidad de fuerza
open-clipped = lecturas recortadas por debajo de los picos de la fuerza

left-out-open = abierto: { $questions }
left-out-kind = { open-kind }
left-out-clock = { open-clock }
left-out-mass = { open-mass }
left-out-clipped = { open-clipped }
left-out-other-kind = { $movement ->
        [running] { kind-running }
       *[walking] { kind-walking }
    }, pero la mayoría de los registros son de { $most ->
        [running] { kind-running }
       *[walking] { kind-walking }
    }
left-out-other-speed = otra velocidad: la zancada dura { $period }, pero de { $low } a { $high } en la mayoría de los registros
left-out-mean-already = ya es un ciclo medio, no un registro
left-out-no-cycle = sin ciclo

clock-user = indicada
clock-times = columna de tiempo
clock-guessed-times = columna de tiempo, unidad supuesta
clock-header = de la cabecera
clock-guessed-rate = supuesta

name-heel-strikes = contactos de talón consecutivos de un pie
name-marked-strikes = contactos marcados consecutivos de un pie
name-heel-markers = marcadores de los talones
name-doubled-steps = el doble de la duración media del paso
name-impulse = balance de impulso con la masa corporal
name-usual-duty = parte supuesta del apoyo en la zancada (no consta en el registro)
name-total-force = cruces ascendentes de la fuerza total media

mass-from-user = indicada
mass-from-file = del archivo
mass-from-subjects = media de la tabla de sujetos
mass-from-mean-force = fuerza media de la zancada

channel-never-loaded = nunca con carga
channel-constant = constante en { $level }
channel-mostly-empty = casi vacío: faltan { $missing } de { $samples } muestras
channel-empty = vacío

contact-cut-at-start = truncado: el registro empieza durante el apoyo
contact-cut-at-end = truncado: el registro termina durante el apoyo
contact-edge-fragment = contacto parcial en el borde del registro, no se usa
contact-never-unloaded = nunca sin carga: de pie, o ambos pies en una plataforma
contact-missing-samples = faltan muestras durante el apoyo
contact-too-short = demasiado corto para un paso
contact-running = contacto de carrera
contact-jumping = despegue o caída de ambos pies
contact-cross-talk = diafonía de un pie en otra plataforma
contact-other-speed = apoyo completo a otra velocidad
contact-unlike = su duración, pico o impulso difiere de los demás apoyos
contact-standing = demasiado largo para un paso: de pie
contact-cross-over = demasiado largo para un pie: ambos pies en una plataforma
contact-two-plates = el pie pisa dos plataformas
contact-partial-contact = contacto parcial: fuerza demasiado baja para un paso completo

name-cut-at-start = { contact-cut-at-start }
name-cut-at-end = { contact-cut-at-end }
name-edge-fragment = { contact-edge-fragment }
name-never-unloaded = { contact-never-unloaded }
name-missing-samples = { contact-missing-samples }
name-too-short = { contact-too-short }
name-running = { contact-running }
name-jumping = { contact-jumping }
name-cross-talk = { contact-cross-talk }
name-other-speed = { contact-other-speed }
name-unlike = { contact-unlike }
name-standing = { contact-standing }
name-cross-over = { contact-cross-over }
name-two-plates = { contact-two-plates }
name-partial-contact = { contact-partial-contact }

format-c3d = C3D, { $processor } { $storage }
format-export = exportación de { $program }
format-stance-table = tabla de apoyos, uno por fila
format-text = texto separado por { $separator ->
        [tab] tabuladores
        [semicolon] punto y coma
        [bar] barras
        [comma] comas
       *[blank] espacios
    }{ $decimal ->
        [comma] , coma decimal
       *[point] {""}
    }
format-headerless-text = texto separado por { $separator ->
        [tab] tabuladores
        [semicolon] punto y coma
        [bar] barras
        [comma] comas
       *[blank] espacios
    }{ $decimal ->
        [comma] , coma decimal
       *[point] {""}
    }, sin cabecera

# Pies y almacenamiento.
name-left = izquierdo
name-right = derecho
name-vertical = vertical
name-integers = con enteros
name-floats = con coma flotante
force-no-walkers = la población no contiene ningún caminante
    .help = dé al menos un ciclo
force-walker-impossible = el caminante { $walker } no tiene un peso o una fuerza media positivos
    .help = corrija el ciclo o exclúyalo
force-walker-column-missing = la tabla de caminantes no tiene la columna { $column }
    .help = la tabla necesita las columnas walker, period_s y f_000 a f_100 (N en pasos iguales del ciclo); speed_m_per_s, mass_kg y weight son opcionales
force-walker-value = valor no válido «{ $value }» en la columna { $column }
    .help = dé un número, positivo en period_s y weight; solo speed_m_per_s, mass_kg y weight pueden estar vacías
