# Errores en las dimensiones de una leva y su seguidor.
cam-not-positive = valor no válido de { $length ->
        [roller-radius] radio del rodillo
        [arc-radius] radio del arco
        [pivot-distance] distancia al pivote
        [arm] longitud del brazo
        [base-height] altura base
        [barrel-radius] radio de la leva cilíndrica
       *[prime-radius] radio primario
    }: { $value }
    .help = { $length ->
        [roller-radius] debe ser 0 (seguidor puntual) o mayor
       *[other] debe ser mayor que 0
    }
cam-not-finite = { $length ->
        [face-offset] la distancia de la cara al pivote
       *[offset] la excentricidad
    } no es un número finito
cam-roller-fills-cam = el radio del rodillo o del arco, { $radius }, no es menor que el radio primario, { $prime }
    .help = el radio primario es la suma del radio base y el del rodillo; debe superar el radio del rodillo
cam-offset = la excentricidad de { $offset } no es menor que el radio primario, { $prime }
    .help = el seguidor no puede tocar el círculo primario: use una excentricidad menor que { $prime } o aumente el radio primario
cam-below-centre = la ley baja a { $lift }, por debajo del centro de la leva, que está { $height } por debajo de la posición inicial del seguidor
    .help = el radio primario debe superar { $least }
cam-face-reach = una cara plana a distancia { $offset } no puede tocar un círculo base de radio { $base } con su pivote a { $pivot }
    .help = la distancia al pivote debe superar { $least }
cam-arm-reach = el brazo de { $arm } { $fault ->
        [short] es demasiado corto para alcanzar
        [long] es demasiado largo para tocar
       *[apart] no puede tocar
    } el círculo primario de radio { $prime } desde un pivote a { $pivot }
    .help = la longitud del brazo debe estar entre { $least } y { $most }
cam-swing = el brazo oscila de { $from } a { $to }, más allá de sus puntos muertos en { $dead }
    .help = desde su inicio en { $start }, el brazo debe subir menos de { $rise } y bajar menos de { $fall }
cam-face-speed = en { $at } la velocidad angular del brazo es { $speed } rad/rad, no menor que la de la leva
    .help = una cara plana no tiene ahí punto de contacto: reparta este movimiento en un ángulo de leva mayor
cam-pivot-inside = el pivote a { $pivot } queda dentro de la leva, cuyo radio de perfil es { $reach } en { $at }
    .help = use una distancia al pivote mayor que { $reach }
cam-arms-by-distance = los seguidores oscilantes conjugados no se definen por una distancia
    .help = indique el ángulo entre los brazos o el segundo radio base
cam-slides-by-angle = los seguidores de traslación conjugados no se definen por un ángulo
    .help = indique la distancia entre caras o centros de rodillo, o el segundo radio base
cam-no-conjugate-of = no existe leva conjugada para este seguidor ({ $follower })
    .help = la ranura ya guía este seguidor por ambos lados
cam-second-cam = la leva conjugada no existe: { $because }
cam-no-conjugate = no existe leva conjugada para una distancia o un ángulo de { $total } entre ambos seguidores: el primer seguidor por sí solo alcanza { $reach }
    .help = { $least ->
        [none] la distancia o el ángulo debe ser mucho mayor que { $reach }
       *[other] use al menos { $least } (segundo radio base { $base }) para evitar el rebaje de la leva conjugada
    }
cam-translating-height = la altura base de una leva de traslación no influye en la curvatura ni en el ángulo de presión
    .help = aumente la longitud del recorrido (cam.travel) o use un rodillo más pequeño (cam.roller_radius)
cam-no-size = ningún radio base cumple los límites con este seguidor ({ $follower })
    .help = admita un ángulo de presión mayor o un radio de curvatura menor, reparta el movimiento en un ángulo mayor o aumente la distancia al pivote
cam-groove-depth = una ranura con radio de fondo { $floor } y radio de superficie { $surface } no tiene profundidad
    .help = el radio de fondo debe ser mayor que 0 y menor que el de la superficie
cam-groove-rollers = unos rodillos de radio { $radius } con excentricidad { $eccentricity } no caben en una ranura
    .help = el radio debe ser mayor que 0 y la excentricidad no negativa
cam-groove-floor = el radio del rodillo, { $radius }, no es menor que el radio de fondo de la ranura, { $floor }
    .help = use un rodillo más pequeño o un radio de fondo mayor
cam-measured-few = { $points } puntos medidos no son suficientes
    .help = mida al menos { $least }, repartidos por todo el perfil, mejor 360 o más
cam-measured-not-finite = el punto medido { $row } no es finito
    .help = omítalo o mídalo de nuevo
cam-measured-unrolled = solo se puede ajustar el perfil de una leva que gira, no el de este seguidor ({ $follower })
cam-measured-circle = el perfil es un círculo dentro de la dispersión de los puntos medidos, así que estos no determinan su ángulo cero
    .help = mida el agujero y el chavetero, que fijan centro y ángulo
cam-measured-mirror = los puntos corresponden a la imagen especular de esta leva: su distancia RMS al perfil es { $distance }, y { $mirrored } después de reflejarlos
    .help = la leva se midió por el otro lado: cambie el signo de x
cam-measured-other = los puntos no corresponden a esta leva: su distancia RMS al perfil (radios de { $low } a { $high }) es { $distance } tras el mejor ajuste
    .help = compruebe las unidades de las columnas, el radio de la bola palpadora (--ball) y qué leva se midió
