# Fallos al leer escenas y registros y al colocar resultados en carpetas.
file-cannot-read = { $fault ->
        [missing] no existe tal archivo o carpeta
        [denied] este usuario no tiene permiso para leerlo
       *[other] no se puede leer ({ $fault })
    }
    .help = compruebe la ruta
file-missing = no hay ningún archivo «{ $file }»
file-cannot-place = no se pueden colocar los archivos en su sitio ({ $fault })
file-foreign = no es un archivo de gaitcam, pero tiene el nombre de uno
    .help = quítelo, o elija otra carpeta
file-held = otro gaitcam{ $process ->
        [none] {""}
       *[other] {" "}(proceso { $process })
    } está escribiendo aquí
    .help = espere a que termine, deténgalo, o elija otro --out
file-folder = es una carpeta
    .help = indique un archivo
file-device = es una tubería o un dispositivo, no un archivo
    .help = indique un archivo, o - para la entrada estándar
file-too-large = supera { $mib } MiB
file-not-utf8 = no es texto UTF-8
    .help = una escena es un archivo TOML, `gaitcam scenes footbridge` muestra una
file-not-toml = el analizador de TOML dice: { $fault }
    .help = una escena es un archivo TOML, `gaitcam scenes footbridge` muestra una
file-not-json = no es JSON ({ $fault })
file-measured-columns = ninguna columna de puntos medidos entre: { $found }
    .help = llámelas x_mm,y_mm o angle_deg,radius_mm (o m, in, rad)
file-measured-field = "{ $typed }" no es un número finito
    .help = cada línea necesita dos números con punto decimal
file-not-csv = no es una tabla CSV ({ $fault })
file-no-scene-in-summary = no contiene ninguna escena
    .help = indique un summary.json de gaitcam o un archivo de escena
file-replaced = se sustituiría { $file }
    .help = un archivo de entrada nunca se sobrescribe; elija otra carpeta
file-another-sweep = es otro barrido: { $differences }
    .help = repita el barrido tal como era, o elija otro lugar
file-not-sweep-folder = contiene { $file }, que no es un bloque de un barrido
    .help = indique una carpeta vacía o la de este barrido
file-no-table = no se encontró ninguna tabla de números
    .help = el archivo empieza con «{ $start }»; { $purpose ->
        [motor] la curva de par de un motor tiene el encabezado speed_rad_per_s,torque_n_m
       *[table] un movimiento tiene un encabezado como angle_deg,lift_mm
    } y debajo filas de números
file-motor-column = la curva de par no tiene la columna { $column } (columnas: { $columns })
    .help = su encabezado es speed_rad_per_s,torque_n_m
file-motion-column = no hay columna { $column } (columnas: { $columns })
    .help = nómbrela con su unidad en el encabezado, por ejemplo { $example }
file-motion-unit = columna { $column }: falta su unidad o es de otra clase
    .help = nómbrela con su unidad en el encabezado, por ejemplo { $example }
file-motion-value = columna { $column }: "{ $typed }" no es un número
    .help = cada fila necesita un número finito
file-motion-order = columna { $column }: { $x } después de { $before }
    .help = debe crecer de fila en fila
file-motion-many-rows = más de { $most } filas
    .help = dé una de cada dos filas o menos
file-motion-differs = la columna { $column } abarca { $covered }, pero { $key } es { $typed }
    .help = corrija uno de los dos, u omita { $key }: entonces se toma del archivo
file-walkers = { $count ->
        [one] 1 ciclo no puede
       *[other] { $count } ciclos no pueden
    } tomarse en la población.{ $unreadable ->
        [none] {""}
       *[other] {" "}Sin ciclo en { $unreadable }.
    }{ $weight ->
        [none] {""}
       *[other] {" "}La fuerza media no es el peso: { $weight }.
    }{ $unit ->
        [none] {""}
       *[other] {" "}Otra unidad de fuerza: { $unit }.
    }{ $feet ->
        [none] {""}
       *[other] {" "}Un pie entre ambos, o al revés: { $feet }.
    }{ $cycle ->
        [none] {""}
       *[other] {" "}Un paso entre zancadas, o al revés: { $cycle }.
    }{ $kind ->
        [none] {""}
       *[other] {" "}Otro tipo de movimiento: { $kind }.
    }
    .help = corríjalos o exclúyalos por su nombre, una fila de una tabla también por su línea: gait.leave_out = ["NOMBRE", "ARCHIVO:LÍNEA", …]
