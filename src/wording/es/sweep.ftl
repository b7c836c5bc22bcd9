# Errores de un barrido: sus ejes, su plan, sus tolerancias y sus tablas.
sweep-no-assignment = «{ $typed }» no tiene la forma CLAVE=VALORES
    .help = escriba CLAVE=VALORES, por ejemplo limits.stroke=20 mm:60 mm:5 o law.family=spline,harmonic
sweep-no-values = la rejilla está vacía: no se da ningún valor
    .help = escriba valores separados por comas, o INICIO:FIN:N
sweep-sampled-count = un intervalo que se muestrea no lleva cantidad
    .help = escriba INICIO:FIN
sweep-no-count = el intervalo de una rejilla no tiene cantidad
    .help = escriba INICIO:FIN:CANTIDAD, o sortee valores con --sample
sweep-not-count = «{ $typed }» no es un número entero de valores
    .help = escriba INICIO:FIN:CANTIDAD
sweep-different-units = el primer y el último valor del intervalo tienen unidades distintas («{ $first }» y «{ $last }»)
    .help = dé ambos en la misma unidad
sweep-not-number = «{ $typed }» no empieza por un número
sweep-no-rows = la rejilla está vacía: no hay filas que calcular
sweep-too-many-rows = { $rows } combinaciones son demasiadas para calcularlas
    .help = use menos valores, o una muestra
sweep-list-lengths = la lista tiene { $values } valores de «{ $key }», pero { $first } valores de la primera clave
    .help = dé a cada clave de una lista el mismo número de valores
sweep-not-carried = este archivo no está entre los registros de este barrido
sweep-scatter-alone = las tolerancias no se pueden combinar con otra variación, porque se aplican a un solo diseño
sweep-no-design = la escena no tiene una leva factible, así que no se pueden aplicar tolerancias
    .help = relaje sus límites como se sugiere en el resumen del diseño
sweep-out-of-time = el límite de tiempo terminó la búsqueda de este diseño
    .help = fije un --time-limit mayor
sweep-fixed = «{ $key }» no se puede variar
    .help = se pueden variar las claves { $known }; las entradas de una lista se numeran, como en law.segment.2.lift
sweep-key-twice = «{ $key }» aparece dos veces
sweep-nothing-to-sample = no varía ninguna clave, así que no hay nada que muestrear
    .help = varíe una clave en un intervalo: CLAVE=INICIO:FIN
sweep-sobol-axes = las secuencias de Sobol están disponibles hasta { $most } claves
    .help = use el hipercubo latino (latin)
sweep-no-scene = la escena base { $scene } no existe
sweep-no-tolerance-value = «{ $typed }» no tiene la forma PARTE=VALOR
    .help = escriba PARTE=VALOR, por ejemplo profile=0.02 mm
sweep-no-tolerance = «{ $typed }» no admite tolerancia
    .help = estas partes tienen tolerancia: profile, base_radius, mass, speed
sweep-negative-tolerance = la tolerancia de { $part } es negativa: { $typed }
    .help = dé la semianchura de la tolerancia, 0 o más
sweep-no-force-error = la escena no tiene fuerza objetivo, así que no tiene error de fuerza
sweep-scatter-of-arm = las tolerancias solo se calculan para seguidores de traslación; para un seguidor sobre un brazo, mida una leva fabricada con gaitcam inspect
sweep-front-without-moving-axis = un límite de fuerza fija la velocidad de pérdida de contacto solo en un eje móvil; use gaitcam sweep y gaitcam front --maximise liftoff_speed
sweep-front-without-size = el límite de presión determina el tamaño de esta leva, pero este compromiso requiere un tamaño dado
    .help = indique cam.base_radius o cam.prime_radius
sweep-no-column = «{ $typed }» no es una columna de números
    .help = { $nearest ->
        [none] por ejemplo { $known }
       *[other] ¿quiso decir «{ $nearest }»?
    }
sweep-arrow = Arrow: { $fault }
sweep-parquet = Parquet: { $fault }

# Diferencias entre dos planes.
differs-value = { $path }: antes { $old ->
        [none] nada
       *[other] { $old }
    }, ahora { $new ->
        [none] nada
       *[other] { $new }
    }
differs-long = { $path }: el texto es distinto
differs-only-old = { $path }: solo la primera ejecución contiene «{ $text }»
differs-only-new = { $path }: solo esta ejecución contiene «{ $text }»
