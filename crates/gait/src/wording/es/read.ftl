# Errores en archivos de fuerza.

read-empty = el archivo está vacío
    .help = use un archivo con un encabezado y filas de números
read-foreign = { $kind ->
        [zip] es un libro de Excel u otro archivo comprimido zip
        [old-office] es un archivo antiguo de Excel o Word
        [matlab] es un archivo de MATLAB que no es de nivel 5 (save -v7)
        [hdf5] es un archivo HDF5 o de MATLAB 7.3 (guárdelo con -v7)
        [parquet] es un archivo Parquet
        [gzip] es un archivo gzip
        [pdf] es un PDF
        [xml] es un archivo XML
        [numpy] es un archivo de NumPy
        [picture] es una imagen
       *[binary] es un archivo binario de tipo desconocido
    }, que no se admite
    .help = exporte el ensayo como C3D o como texto (csv, txt, mot)
read-rate-not-positive = frecuencia de muestreo no válida { $rate }
    .help = debe ser positiva, por ejemplo "1000 Hz"
read-mass-not-positive = masa no válida { $mass }
    .help = debe ser positiva, por ejemplo "70 kg"

read-no-table = el archivo no contiene ninguna tabla de números
    .help = el archivo empieza con «{ $start }»; un registro es una tabla con una columna de tiempo o una frecuencia, y columnas de fuerza
read-header-without-rows = la cabecera tiene una columna de fuerza («{ $column }»), pero no siguen filas de números
    .help = exporte también las muestras; cada fila debe empezar por un tiempo o un número
read-no-force-column = el archivo no contiene ninguna columna de fuerza vertical
    .help = las columnas son { $columns }; indique la columna de fuerza (opción force)
read-many-forces = el archivo contiene { $found } columnas de fuerza, más de las habituales en un pasillo de marcha
    .help = indique las columnas que se usan (opción force)
read-single-sensors = las { $sensors } columnas numeradas son lecturas de sensores sueltos, como las presiones de una plantilla, y no fuerzas
    .help = exporte la fuerza total de cada plantilla en newtons, porque de las presiones no se obtiene una fuerza sin el área de cada sensor
read-long-table = la tabla con { $cycles ->
        [one] un ciclo
       *[other] { $cycles } ciclos
    } contiene la fase, pero no el tiempo
    .help = indique la duración del ciclo (opción period); se usa entonces la media de los ciclos. Las fuerzas en pesos corporales requieren también la masa (opción mass)
read-long-tasks = los ciclos de esta tabla son de varias tareas: { $tasks }
    .help = conserve las filas de una sola tarea
read-long-forces = la tabla contiene varias fuerzas ({ $columns }), pero solo se puede usar una
    .help = nombre la fuerza que se usa (opción force)
read-nameless-columns = las columnas no tienen nombre y ninguna se parece a una fuerza vertical
    .help = indique el número de la columna de fuerza (opción force), y el de la columna de tiempo si la hay (opción time)
read-no-column = la columna «{ $column }» no existe
    .help = las columnas son { $columns }
read-misspelt-column = la columna «{ $column }» no existe
    .help = ¿quiso decir «{ $near }»? Las columnas son { $columns }
read-no-column-number = la columna «{ $column }» no existe
    .help = las columnas no tienen nombre; indique un número de 1 a { $count }
read-no-force-unit = la unidad de la columna «{ $column }» es { $unit }, que no es una unidad de fuerza
    .help = exporte fuerzas calibradas, o indique la unidad de las lecturas (opción unit)
read-force-is-time = la columna indicada como fuerza es la de tiempo
    .help = indique otra columna de fuerza, o la columna de tiempo (opción time)
read-time-backwards = el tiempo disminuye ({ $time } después de { $after })
    .help = dé un registro por archivo, con tiempos crecientes
read-short-rows = las filas tienen muchos menos campos que la cabecera
    .help = cada fila debe tener { $fields } campos
read-commas-twice = la cabecera tiene { $columns } columnas, pero una fila tiene { $fields } campos: las comas sirven de coma decimal y de separador
    .help = exporte con punto y coma o tabuladores como separadores, o con punto decimal
read-few-samples = { $samples ->
        [0] el registro no tiene muestras
        [one] el registro tiene una muestra
       *[other] el registro tiene { $samples } muestras
    }
    .help = dé al menos un apoyo completo
read-time-stands-still = el tiempo no aumenta después de { $at }
    .help = indique la columna de tiempo (opción time) o la frecuencia de muestreo (opción rate)
read-mostly-gaps = faltan muestras en { $lost } de { $whole }
    .help = divida el registro por sus huecos
read-counts-without-mass = el archivo contiene cuentas del convertidor sin calibración
    .help = indique la masa de la persona (opción mass) o la unidad de las cuentas (opción unit), o use el archivo .c3d del ensayo
read-mat-without-force = ninguna matriz del archivo de MATLAB se reconoce como fuerza; sus matrices son { $arrays }
    .help = nombre la fuerza (opción force); guarde el registro como matrices numéricas o estructuras, porque las tablas (table y timetable) de MATLAB no se pueden leer
read-mat-cut = el archivo está incompleto: su matriz { $array } tiene { $found } de { $announced } valores
    .help = copie o exporte el archivo de nuevo
read-phase-without-period = { $column } es la fase de un ciclo, no un tiempo
    .help = dé la duración del ciclo (opción period), por ejemplo "1.1 s"
read-phase-of-stance = { $column } es la fase de un apoyo, no del ciclo entero
    .help = dé la duración del ciclo (opción period) y el ángulo del apoyo (opción span), por ejemplo "1.1 s" y "223 deg"
read-cycle-in-c3d = un archivo C3D es un registro, no una tabla de un ciclo
    .help = omita el período; dé una parte de la vuelta solo si el archivo contiene un apoyo completo (opciones period y span)
read-cycle-forces = la tabla de un ciclo debe tener una sola columna de fuerza, pero tiene varias: { $columns }
    .help = nombre la fuerza que se usa (opción force)
read-no-rate = el archivo no contiene tiempos ni frecuencia de muestreo
    .help = indique la frecuencia (opción rate), por ejemplo "1000 Hz"
read-mass-missing = la fuerza está en { $unit }, pero no se conoce la masa corporal
    .help = indique la masa (opción mass), por ejemplo "70 kg"

read-stance-sample = la muestra { $sample } del apoyo no es un número: «{ $text }»
    .help = las muestras deben ser números; solo puede haber campos vacíos al final de la fila
read-no-stance-row = la tabla no contiene ningún apoyo
    .help = cada fila debe contener las muestras de un apoyo
read-row-mass-missing = la fuerza está en { $unit }, pero no se conoce la masa de la fila { $row }
    .help = indique la masa (opción mass) o ponga la tabla de sujetos en la carpeta del archivo

read-cycle-column-missing = falta la columna de { $column ->
        [time] tiempo
       *[force] fuerza
    }
    .help = las columnas son { $columns }
read-cycle-without-table = el archivo está marcado como ciclo pero no contiene ninguna tabla de números
    .help = dé las columnas time_s y force_n
read-cycle-row = esta fila no contiene un tiempo y una fuerza
    .help = cada fila de un ciclo requiere un tiempo y una fuerza
read-cycle-value = falta un valor o no es un número
    .help = cada fila de un ciclo requiere un tiempo y una fuerza
read-cycle-too-long = las muestras abarcan { $span }, más que el período de { $period }
    .help = corrija period_s o dé un solo ciclo
read-cycle-period-missing = no se da el período de los puntos críticos
    .help = escriba «# period_s = 0.5» encima de la tabla
read-points-not-rising = se requieren al menos dos puntos críticos con tiempos crecientes
    .help = ordene las filas por tiempo
read-point-beyond-period = el punto en { $at } está fuera del período de { $period }
    .help = corrija period_s o el punto

read-processor = tipo de procesador C3D desconocido { $code }
    .help = debe ser 84 (Intel), 85 (DEC) u 86 (SGI)
read-no-analog = el archivo no contiene muestras analógicas
    .help = las plataformas de fuerza se registran como canales analógicos; expórtelos con el ensayo
read-odd-analog = { $values } valores analógicos por cuadro no se pueden dividir en { $samples } muestras por canal
    .help = la cabecera está dañada: exporte de nuevo el ensayo
read-no-frame = el archivo no contiene ningún cuadro de datos completo
    .help = el archivo está truncado (un cuadro tiene { $bytes } bytes): cópielo o expórtelo de nuevo
read-no-frame-rate = el archivo no da la frecuencia de cuadros
    .help = POINT:RATE debe ser positivo
read-no-channel = el canal analógico «{ $channel }» no existe
    .help = los canales son { $channels }
read-no-plate = el archivo no contiene ninguna plataforma de fuerza ni canal analógico de fuerza
    .help = los canales analógicos son { $channels }
read-not-plates-of-one-trial = estos archivos no son las plataformas de un mismo ensayo
    .help = indique cada archivo una vez; los archivos solo se combinan si nombran su plataforma y tienen la misma marca de tiempo, el mismo número de muestras y la misma frecuencia
read-plate-uncalibrated = la plataforma { $plate } no tiene la matriz de calibración (FORCE_PLATFORM:CAL_MATRIX) que requiere su tipo
    .help = exporte el ensayo con esta matriz, o indique un canal de fuerza vertical calibrada (opción force). Los canales son { $channels }
read-plate-type-unknown = la plataforma de fuerza { $plate } tiene el TYPE { $kind }, que no se admite
    .help = se admiten los tipos 1 a 7; indique su canal de fuerza vertical (opción force). Los canales son { $channels }
