# Fallos al leer escenas y registros y al colocar resultados en carpetas.
file-cannot-read = { $fault ->
        [missing] el archivo o la carpeta no existe
        [denied] no hay permiso de lectura
       *[other] no se puede leer ({ $fault })
    }
    .help = compruebe la ruta
file-missing = el archivo «{ $file }» no existe
file-cannot-place = no se pueden colocar los archivos en su sitio ({ $fault })
file-foreign = este archivo tiene el nombre de un archivo de gaitcam, pero gaitcam no lo escribió
    .help = quítelo, o elija otra carpeta
file-held = otro proceso de gaitcam{ $process ->
        [none] {""}
       *[other] {" "}({ $process })
    } está escribiendo en esta carpeta
    .help = espere a que termine, deténgalo, o elija otro --out
file-folder = es una carpeta, no un archivo
    .help = indique un archivo
file-device = es una tubería o un dispositivo, no un archivo
    .help = indique un archivo, o - para la entrada estándar
file-too-large = el archivo supera { $mib } MiB
file-not-utf8 = el archivo no es texto UTF-8
    .help = una escena es un archivo TOML; `gaitcam scenes footbridge` muestra un ejemplo
file-not-toml = error de sintaxis TOML (mensaje en inglés: { $fault })
    .help = una escena es un archivo TOML; `gaitcam scenes footbridge` muestra un ejemplo
file-not-json = el archivo no es JSON (mensaje en inglés: { $fault })
file-measured-columns = no hay columnas de puntos medidos; las columnas son { $found }
    .help = llámelas x_mm,y_mm o angle_deg,radius_mm (o m, in, rad)
file-measured-field = «{ $typed }» no es un número finito
    .help = cada línea necesita dos números con punto decimal
file-not-csv = el archivo no es una tabla CSV (mensaje en inglés: { $fault })
file-no-scene-in-summary = el archivo no contiene ninguna escena
    .help = indique un summary.json de gaitcam o un archivo de escena
file-replaced = se sustituiría el archivo de entrada { $file }
    .help = los archivos de entrada nunca se sobrescriben; elija otra carpeta
file-another-sweep = la carpeta contiene un barrido distinto: { $differences }
    .help = repita el barrido sin cambios, o elija otra carpeta
file-not-sweep-folder = la carpeta contiene { $file }, que no es un bloque de un barrido
    .help = indique una carpeta vacía o la de este barrido
file-no-table = el archivo no contiene ninguna tabla de números
    .help = el archivo empieza con «{ $start }»; { $purpose ->
        [motor] la curva de par de un motor tiene el encabezado speed_rad_per_s,torque_n_m
       *[table] un movimiento tiene un encabezado como angle_deg,lift_mm
    }, seguido de filas de números
file-motor-column = la curva de par no tiene la columna { $column } (columnas: { $columns })
    .help = su encabezado es speed_rad_per_s,torque_n_m
file-motion-column = la columna { $column } no existe (columnas: { $columns })
    .help = nómbrela con su unidad en el encabezado, por ejemplo { $example }
file-motion-unit = columna { $column }: la unidad falta o tiene una dimensión incorrecta
    .help = nómbrela con su unidad en el encabezado, por ejemplo { $example }
file-motion-value = columna { $column }: «{ $typed }» no es un número
    .help = cada fila necesita un número finito
file-motion-order = la columna { $column } no crece: { $x } después de { $before }
    .help = debe crecer de fila en fila
file-motion-many-rows = el archivo tiene más de { $most } filas
    .help = reduzca el número de filas, por ejemplo a una de cada dos
file-motion-differs = la columna { $column } abarca { $covered }, pero { $key } es { $typed }
    .help = corrija uno de los dos, u omita { $key } para usar el valor del archivo
file-walkers = { $count ->
        [one] 1 ciclo no puede
       *[other] { $count } ciclos no pueden
    } usarse en la población.{ $unreadable ->
        [none] {""}
       *[other] {" "}Archivos sin ciclo: { $unreadable }.
    }{ $weight ->
        [none] {""}
       *[other] {" "}Fuerza media distinta del peso: { $weight }.
    }{ $unit ->
        [none] {""}
       *[other] {" "}Unidad de fuerza distinta: { $unit }.
    }{ $feet ->
        [none] {""}
       *[other] {" "}Fuerza de un pie y de ambos mezcladas: { $feet }.
    }{ $cycle ->
        [none] {""}
       *[other] {" "}Pasos y zancadas mezclados: { $cycle }.
    }{ $kind ->
        [none] {""}
       *[other] {" "}Tipo de movimiento distinto: { $kind }.
    }{ $open ->
        [none] {""}
       *[other] {" "}Preguntas abiertas: { $open }.
    }
    .help = corríjalos, o exclúyalos por su nombre: gait.leave_out = ["NOMBRE", "ARCHIVO:LÍNEA", …] (ARCHIVO:LÍNEA para una fila de una tabla); las preguntas abiertas se pueden aceptar con gait.accept
file-no-such-walker = ningún caminante y ningún archivo tiene el nombre «{ $name }»
    .help = { $nearest ->
        [none] los nombres son { $known }
       *[other] ¿quiso decir «{ $nearest }»?
    }
