# Errores en los datos de una simulación y preguntas que sus modelos no pueden responder.
dynamics-machine = la masa, la rigidez del muelle, el amortiguamiento, el rozamiento y la velocidad deben ser finitos; los tres primeros no deben ser negativos
dynamics-friction = coeficiente de rozamiento no válido { $friction }
    .help = debe ser 0 o mayor
dynamics-contact-line = un contacto lineal necesita una longitud positiva y materiales con módulo de Young positivo y coeficiente de Poisson en [0; 0,5]
dynamics-target = la fuerza objetivo debe ser finita en todos los ángulos
dynamics-slide-backwards = una leva de traslación con una ley que no se repite solo avanza hacia delante
    .help = fije un drive.speed positivo
dynamics-second-cam = una segunda leva en el eje requiere una ley de una vuelta y un seguidor apoyado en la primera
    .help = omita la segunda leva (machine.second_cam)
dynamics-restitution = coeficiente de restitución no válido { $restitution }
    .help = debe estar en [0, 1]: 0 para un impacto plástico, 1 para uno elástico
dynamics-few-rows = { $rows } puntos no son suficientes para un perfil
    .help = dé al menos 8 puntos, mejor 360 o más
dynamics-row-angle = la fila { $row } del perfil está en { $at } en lugar de { $expected }
    .help = una simulación necesita filas a intervalos iguales del ciclo de la leva
dynamics-row-reach = este seguidor ({ $follower }) no puede tocar la fila { $row } del perfil
    .help = sus coordenadas deben ser finitas y estar al alcance del seguidor
dynamics-concave = en { $at } el perfil es cóncavo o presenta rebaje, con un radio de curvatura de { $radius }
    .help = una cara plana no puede tocarlo; fije un cam.base_radius mayor
dynamics-frequency = frecuencia natural no válida de { $frequency } Hz con razón de amortiguamiento { $ratio }
    .help = la frecuencia debe ser positiva y la razón de amortiguamiento no negativa
dynamics-frequency-without-mass = una frecuencia natural requiere una masa móvil
    .help = { $fluid ->
        [true] un accionamiento hidráulico no tiene masa móvil; en lugar de la frecuencia indique la rigidez de la columna de fluido (machine.stiffness)
       *[other] indique drive.mass, o drive.inertia con un seguidor oscilante
    }
dynamics-train = la rigidez del seguidor debe ser positiva y su amortiguamiento no negativo
dynamics-resonance = resonancia: el seguidor no amortiguado vibra { $cycles } veces por vuelta, en un armónico de la leva, y no hay régimen permanente
    .help = fije machine.damping_ratio mayor que 0 u otro drive.speed
dynamics-no-train = el modelo flexible necesita la rigidez del seguidor
    .help = indique machine.natural_frequency o machine.stiffness
dynamics-open-vibration = una leva de traslación con una ley que no se repite no tiene vibración en régimen permanente
    .help = use el modelo rígido
dynamics-held-by-groove = la ranura guía el rodillo por ambos lados, así que no puede haber pérdida de contacto
    .help = use el modelo rígido o el flexible, que indican el lado en contacto
dynamics-held-by-pair = un par conjugado guía el seguidor por ambos lados, así que no puede haber pérdida de contacto
    .help = use el modelo rígido o el flexible, que indican el lado en contacto
dynamics-not-one-turn = el modelo de contacto requiere una leva que gire una vuelta por ciclo
    .help = use el modelo rígido: su fuerza de contacto mínima indica si una leva de traslación mantiene el contacto
dynamics-motor = la inercia y el rozamiento del eje del motor deben ser cero o positivos, la relación del reductor y el rendimiento deben ser positivos, y la velocidad del eje no debe ser cero
dynamics-motor-turns = un motor solo puede accionar una leva cuya ley abarque una vuelta
    .help = omita machine.motor o la segunda leva (machine.second_cam)
dynamics-stalls = el eje se para: su inercia de { $inertia } no basta para superar la carga máxima
    .help = ponga machine.inertia = "{ $needed }" o más, o una recta de par más inclinada
dynamics-stalls-anyway = el eje se para con cualquier inercia: la recta de par del motor es demasiado baja para la carga
    .help = dé una recta de par más inclinada (machine.motor.slope, machine.motor.stall_torque)
dynamics-no-load-speed = la velocidad en vacío del motor, { $nominal }, es demasiado baja para una velocidad media de { $speed } del eje de la leva
    .help = ponga machine.motor.no_load_speed = "{ $needed }" o más, o un machine.motor.gear menor
dynamics-few-programme-rows = el programa de velocidad solo tiene { $rows } filas
    .help = indique al menos tres filas con las columnas time_s,speed_rad_per_s
dynamics-programme-row = la fila { $row } del programa de velocidad no es válida
    .help = los tiempos deben crecer y las velocidades deben ser positivas
dynamics-programme-turns = un programa de velocidad requiere una leva que gire y una ley que se repita después de una vuelta
    .help = use una leva de una vuelta por ciclo
dynamics-programme-acceleration = todo programa de velocidad de esta marcha supera el límite de aceleración de { $most }
    .help = permita una aceleración mayor (--max-acceleration)
dynamics-programme-contact = con cualquier programa de velocidad de esta marcha la fuerza de contacto baja a { $least }; el límite es { $limit }
    .help = diseñe la leva con un limits.force_min mayor
dynamics-programme-motor = el motor no puede seguir el programa: en { $at } necesitaría { $torque } con el eje de la leva a { $speed }
    .help = use machine.inertia mayor, una recta de par más empinada (machine.motor.slope, machine.motor.stall_torque) o machine.motor.no_load_speed mayor
dynamics-programme-stops = el eje se detiene en { $at } del programa de velocidad: el motor es demasiado débil
    .help = use machine.inertia mayor o una recta de par más empinada (machine.motor.slope, machine.motor.stall_torque)
dynamics-floor-resonance = el suelo no tiene movimiento estacionario: el armónico { $harmonic } de la fuerza coincide con la frecuencia natural de un modo sin amortiguar, { $frequency }
    .help = dé a este modo una razón de amortiguamiento mayor que 0, por ejemplo "0.005"
dynamics-contact-under-motor = el modelo de contacto requiere una velocidad constante, pero el motor la hace variar
    .help = use --model rigid, u omita [machine.motor]
dynamics-floor-not-rigid = solo el modelo rígido incluye un suelo que se mueve
    .help = use --model rigid, use --model auto sin seguidor flexible, u omita [machine.floor]
dynamics-floor-and-shaft = la búsqueda no encontró un movimiento estacionario común del eje y del suelo
    .help = use un machine.inertia mayor o un machine.floor.damping mayor
dynamics-open-polydyne = una leva polidina requiere una ley que se repita, porque si no, no hay régimen permanente
dynamics-polydyne-jump = la { $derivative ->
        [lift] elevación
        [velocity] velocidad
        [acceleration] aceleración
        [jerk] sobreaceleración
       *[other] cuarta derivada
    } de la ley es discontinua en { $at }; la elevación de una leva polidina incluye la deformación por la fuerza, de modo que su aceleración sería discontinua ahí
    .help = use una ley con cuatro derivadas continuas: una spline de grado 5 o mayor, armónicos o segmentos 5-6-7-8-9

# Por qué se eligió un modelo.
model-asked-for = elegido por el usuario
model-low-force = la carga de contacto del modelo rígido baja a { $force }, menos del { $part } de su media { $mean }; { $liftoff }
model-near-liftoff = cerca de la pérdida de contacto: { $liftoff }
model-two-cams = hay impactos donde la carga pasa de una leva a la otra; solo los incluye el modelo de contacto
model-nothing-vibrates = { $margin }; no se da frecuencia natural ni rigidez, así que no se calcula la vibración
model-vibration-loses-contact = { $vibration }; con vibración la carga de contacto mínima es { $force } y se pierde el contacto, pero el modelo de contacto no incluye la vibración
model-vibrates = { $vibration }, más del { $allowed }; { $margin }
model-hardly-vibrates = { $vibration }, no más del { $allowed }; { $margin }
model-held-from-both-sides = el seguidor está guiado por ambos lados y no puede perder el contacto
model-no-liftoff = velocidad { $speed }; el seguidor no pierde el contacto a ninguna velocidad
model-moving-floor = velocidad { $speed }; la velocidad de pérdida de contacto sobre un suelo que se mueve no se calcula
model-liftoff-at = velocidad { $speed }, pérdida de contacto a { $liftoff }
model-no-force = ninguna fuerza aprieta el seguidor contra la leva: el accionamiento no tiene masa, muelle ni precarga
model-inertia-only = la carga media sobre el seguidor es cero; la fuerza de inercia es { $low } … { $high }; { $liftoff }
model-smallest-force = la carga de contacto mínima es { $force }, el { $part } de la media; { $liftoff }
model-no-mass = la columna de fluido se deforma sin vibrar
model-harmonics = la primera frecuencia natural es { $frequency }, { $ratio } veces la frecuencia del eje; la vibración cambiaría la fuerza un { $part } de la media (RMS)

# Qué conviene saber de una simulación.
run-second-cam-bears = la segunda leva soporta la carga, como máximo { $force }, durante el { $part } del ciclo; en cada cambio el seguidor recorre el juego
run-other-wall-bears = la pared opuesta de la ranura soporta la carga, como máximo { $force }, durante el { $part } del ciclo; en cada cambio el seguidor recorre el juego
run-rigid-pulls = el modelo rígido admite una fuerza de contacto negativa; use el modelo de contacto para calcular la pérdida de contacto
run-rigid-without-impacts = el modelo rígido no incluye los impactos donde la carga pasa de una leva a la otra
run-flexible-pulls = el seguidor que vibra pierde el contacto, pero el modelo flexible admite una fuerza de contacto negativa
run-escapes = la masa pierde el contacto con la leva y no vuelve
run-not-periodic = el movimiento no se repite en { $turns } vueltas y { $impacts } impactos
run-swings = el seguidor oscila: elevación y separación son ángulos en rad; la fuerza es el momento respecto al pivote en N·m. La masa, el muelle y la precarga se refieren al pivote. La fuerza en la palanca (en los archivos) y la fuerza normal están en N
run-pair-distance = la distancia del par conjugado es constante dentro de { $deviation }; la segunda leva soporta las fuerzas negativas
run-steady-shaft = con este motor la velocidad variaría cerca de un { $ripple } y la fuerza un { $change } de la media. La velocidad se toma como constante, porque este cambio de la fuerza no supera el { $allowed }
run-shaft-varies = el motor causa una oscilación de velocidad del { $found } (estimada: { $ripple }, con un cambio de fuerza del { $change } de la media), y la fuerza se calcula para esta velocidad variable
run-flexible-at-mean-speed = el seguidor flexible se simula a la velocidad media del eje; la oscilación de velocidad se calcula con un seguidor rígido
