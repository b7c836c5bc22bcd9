# Errores en movimientos, programas y polinomios de condiciones de contorno.
law-segment = segmento { $number } ({ $motion })
law-no-segment = un programa necesita al menos un segmento
    .help = dé [[law.segment]] con motion, lift y angle
law-extent = un programa no puede tener una extensión de { $length }
    .help = dé un número de vueltas o una longitud de recorrido mayor que 0
law-segment-not-finite = la elevación y la extensión de { $segment } deben ser números finitos
    .help = dé ambas como números finitos
law-segment-length = la longitud de { $segment } es { $length }, pero debe ser positiva
    .help = dé una longitud mayor que 0, o quite el segmento
law-dwell-lift = { $segment } tiene una elevación de { $lift }
    .help = en un detenimiento la elevación es constante: elija un movimiento o ponga la elevación a 0
law-uncovered = los segmentos cubren { $covered } de { $wanted }: faltan { $missing }
    .help = añada un detenimiento, o cambie el ángulo o la longitud de un segmento
law-overfull = los segmentos cubren { $covered }, { $excess } más que { $wanted }
    .help = cambie el ángulo o la longitud de un segmento
law-general-neighbours = los polinomios generales { $first } y { $second } son contiguos, así que sus condiciones extremas no están determinadas
    .help = cambie el movimiento de un segmento, o una los dos segmentos
law-lift-jump = { $before } no puede unirse a { $after } en { $at }: la elevación cambia ahí en { $jump }
    .help = las elevaciones de todos los segmentos deben sumar 0
law-velocity-jump = { $before } no puede unirse a { $after } en { $at }: la velocidad salta { $jump } (de { $from } a { $to })
    .help = { $cure }
law-let-cover = ponga la extensión de { $segment } a { $length }, o intercale un polynomial-5 entre los dos segmentos
law-put-between = { $segment } no está ahí en reposo, así que intercale entre los dos segmentos un semimovimiento (semicycloidal) o un polynomial-5
law-below-base-circle = { $segment } baja { $depth } por debajo del círculo base, en { $at }
    .help = empiece el programa en la posición más baja del seguidor, o aumente la elevación antes de este segmento
law-table-below-base-circle = { $segment } baja { $depth } por debajo del círculo base entre las filas { $first } y { $second } de su tabla, en { $at }; se admite como máximo media unidad del último decimal
    .help = añada filas entre esas dos, o corríjalas
law-breadth-angle = los segmentos de una leva de anchura constante cubren { $covered } en lugar de media vuelta
    .help = los segmentos deben sumar 180°; la otra mitad se deduce de la anchura
law-breadth-polynomial = el segmento { $segment } de la media vuelta es un polinomio general cuyo vecino aún no está determinado
    .help = use 3-4-5 o 4-5-6-7
law-breadth-lift = la media vuelta de una leva de anchura constante debe ir de 0 a su elevación máxima, pero termina en { $lift } y varía de { $low } a { $high }
    .help = mantenga la elevación entre 0 y la elevación a 180°
law-no-condition = un polinomio necesita al menos una condición
    .help = dé [[law.point]] con angle y lift
law-interval = intervalo no válido de un polinomio: de { $start } a { $end } rad
    .help = el inicio debe ser menor que el final
law-many-conditions = { $conditions } condiciones requieren un polinomio de grado { $degree }
    .help = como máximo se resuelven con precisión { $most }; use una spline para más puntos
law-condition-not-finite = la condición { $condition } no es un número finito
    .help = dé su ángulo y su valor como números finitos
law-condition-outside = la condición { $condition } está en { $at }, fuera de { $start } … { $end }
    .help = desplace la condición al intervalo
law-condition-order = la condición { $condition } prescribe la derivada { $order }, demasiado alta para un polinomio de grado { $degree }
    .help = dé más condiciones de orden inferior
law-condition-twice = las condiciones { $first } y { $second } prescriben ambas la derivada { $order } en { $at }
    .help = quite una de ellas
law-not-fixed = estas { $conditions } condiciones no determinan un polinomio de grado { $degree }
    .help = dé al menos una elevación y, en cada punto, las derivadas inferiores antes que las superiores
law-parameter = `{ $word }` después de `{ $motion }` no es un número
    .help = escriba los parámetros como en `scca 0.25 0.25 0.5`
law-parameters = `{ $motion }` no admite { $given } parámetros
    .help = solo scca (b, c, d) y eccentric (razón) tienen parámetros
law-unknown-motion = movimiento desconocido `{ $motion }`
    .help = { $nearest ->
        [none] el catálogo contiene { $catalogue }
       *[other] ¿quiso decir `{ $nearest }`?
    }
law-motion-type = `{ $motion }` es un tipo de movimiento de VDI 2143, no una ley
    .help = { $laws ->
        [none] ninguna ley del catálogo tiene estos extremos; use polynomial-5 o polynomial-7, que se unen a cualquier vecino
       *[other] leyes con estos extremos: { $laws }
    }
law-motion-needs-points = el movimiento `{ $motion }` necesita puntos
    .help = escriba parejas de ángulo y elevación como fracciones del segmento, motion = "table 0 0 0.5 0.3 1 1", o nombre un archivo CSV, motion = "table lift.csv"
law-motion-file = el movimiento `{ $motion }` nombra el archivo { $file }, que aquí no se puede leer
    .help = nombre archivos solo en la escena o tras --set; para un barrido, escriba las filas mismas: motion = "table 0 0 0.5 0.3 1 1"
law-general-degree = las condiciones de un polinomio general de grado { $degree } no se pueden repartir por igual entre ambos extremos
    .help = use grado 5 (une s, v, a) o 7 (también j)
law-scca-shares = las fracciones b = { $b }, c = { $c }, d = { $d } de una ley SCCA no suman 1
    .help = b, c y d deben ser 0 o mayores y sumar 1, por ejemplo 0.25, 0.25, 0.5
law-eccentric-ratio = una excéntrica de razón { $ratio } no contiene su eje
    .help = la razón (radio del disco + radio del rodillo)/excentricidad debe ser mayor que 1, por ejemplo 3
law-table-pairs = los { $numbers } números de una tabla no forman parejas
    .help = alterne x y s, por ejemplo motion = "table 0 0 0.5 0.3 1 1"
law-table-rows = { $table }: { $rows } filas no son suficientes
    .help = dé al menos dos filas de x y s
law-table-not-finite = { $table }: la fila { $row } no es un número finito
    .help = dé x y s como números finitos
law-table-order = { $table }: la fila { $row } tiene x = { $x } después de { $before }
    .help = x debe aumentar de fila en fila
law-table-level = { $table }: la última elevación es igual a la primera
    .help = un movimiento va de una elevación a otra distinta: divida la tabla por su elevación máxima
law-table-spacing = { $table }: el espaciado de sus filas es demasiado desigual para una spline
    .help = reparta las filas con más regularidad

# Vecinos posibles del extremo de una ley.
joins-dwell = detenimiento
joins-return-of-equal-acceleration = retorno de igual aceleración
joins-constant-velocity = velocidad constante
joins-nothing-but-a-general-polynomial = solo un polinomio general
