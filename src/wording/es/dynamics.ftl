# Errores en los datos de una simulación y preguntas que sus modelos no pueden responder.
dynamics-machine = masa, rigidez del muelle, amortiguamiento, rozamiento y velocidad deben ser finitos, y los tres primeros no negativos
dynamics-friction = coeficiente de rozamiento no válido { $friction }
    .help = debe ser 0 o mayor
dynamics-contact-line = un contacto lineal necesita una longitud positiva y materiales con módulo de Young positivo y coeficiente de Poisson en [0; 0,5]
dynamics-target = la fuerza objetivo debe ser finita en todos los ángulos
dynamics-slide-backwards = una leva de traslación cuya ley no se repite solo avanza hacia delante
    .help = dé al accionamiento una velocidad positiva
dynamics-second-cam = una segunda leva en el eje requiere un seguidor apoyado en la primera y una ley de una vuelta
    .help = omita la segunda leva
dynamics-restitution = coeficiente de restitución no válido { $restitution }
    .help = debe estar en [0, 1]: 0 para un choque plástico, 1 para uno elástico
dynamics-few-rows = { $rows } puntos son muy pocos para un perfil
    .help = dé al menos 8 puntos, mejor 360 o más
dynamics-row-angle = la fila { $row } del perfil está en { $at } en lugar de { $expected }
    .help = una simulación necesita filas a intervalos iguales del ciclo de la leva
dynamics-row-reach = este seguidor no puede tocar la fila { $row } del perfil: { $follower }
    .help = sus coordenadas deben ser finitas y estar al alcance del seguidor
dynamics-concave = el perfil es cóncavo o presenta rebaje en { $at }: radio de curvatura { $radius }
    .help = una cara plana no puede tocarlo; aumente el radio base
dynamics-frequency = frecuencia natural no válida de { $frequency } Hz con razón de amortiguamiento { $ratio }
    .help = la frecuencia debe ser positiva y la razón de amortiguamiento no negativa
dynamics-frequency-without-mass = una frecuencia natural requiere una masa móvil
    .help = { $fluid ->
        [true] un accionamiento hidráulico no mueve ninguna; indique machine.stiffness, la de la columna de fluido, en lugar de la frecuencia
       *[other] indique drive.mass, con un seguidor oscilante drive.inertia
    }
dynamics-train = la rigidez del seguidor debe ser positiva y su amortiguamiento no negativo
dynamics-resonance = resonancia: el seguidor no amortiguado vibra { $cycles } veces por vuelta, en un armónico de la leva; no hay régimen permanente
    .help = indique una razón de amortiguamiento mayor que 0 u otra velocidad
dynamics-no-train = el modelo flexible necesita la rigidez del seguidor
    .help = indique machine.natural_frequency o machine.stiffness
dynamics-open-vibration = una leva de traslación cuya ley no se repite no tiene vibración en régimen permanente
    .help = use el modelo rígido
dynamics-held-by-groove = la ranura guía el rodillo por ambos lados: no puede haber pérdida de contacto
    .help = use el modelo rígido o el flexible, que indican el lado en contacto
dynamics-held-by-pair = un par conjugado guía el seguidor por ambos lados: no puede haber pérdida de contacto
    .help = use el modelo rígido o el flexible, que indican el lado en contacto
dynamics-not-one-turn = el modelo de contacto necesita una leva que gire una vuelta por ciclo
    .help = use el modelo rígido: su fuerza de contacto mínima indica si una leva de traslación mantiene el contacto
dynamics-motor = inercia y rozamiento del eje del motor no deben ser negativos, reductor y rendimiento positivos y la velocidad del eje distinta de 0
dynamics-motor-turns = un motor solo puede accionar una leva cuya ley abarque una vuelta
    .help = omita machine.motor o la segunda leva
dynamics-stalls = el eje no sigue girando: su inercia de { $inertia } no basta para superar la carga máxima
    .help = ponga machine.inertia = "{ $needed }" o más, o una recta de par más inclinada
dynamics-stalls-anyway = el eje no sigue girando con ninguna inercia: la recta de par del motor es demasiado débil para la carga
    .help = dé una recta de par más inclinada (machine.motor.slope, machine.motor.stall_torque)
dynamics-no-load-speed = la velocidad en vacío del motor, { $nominal }, es demasiado baja para una velocidad media de { $speed } del eje de la leva
    .help = ponga machine.motor.no_load_speed = "{ $needed }" o más, o un machine.motor.gear menor
dynamics-floor-resonance = el suelo no tiene movimiento estacionario: el armónico { $harmonic } de la fuerza está en su frecuencia sin amortiguar de { $frequency }
    .help = dé a este modo una razón de amortiguamiento mayor que 0, por ejemplo "0.005"
dynamics-contact-under-motor = el modelo de contacto necesita una velocidad constante, y el motor la hace variar
    .help = use --model rigid, u omita [machine.motor]
dynamics-floor-not-rigid = solo el modelo rígido tiene un suelo que se mueve
    .help = use --model rigid o auto sin seguidor flexible, u omita [machine.floor]
dynamics-floor-and-shaft = el eje y el suelo no encuentran un movimiento estacionario común
    .help = use un machine.inertia mayor o un machine.floor.damping mayor
dynamics-open-polydyne = una leva polidina necesita una ley que se repita: si no, no hay régimen permanente
dynamics-polydyne-jump = la { $derivative ->
        [lift] elevación
        [velocity] velocidad
        [acceleration] aceleración
        [jerk] sobreaceleración
       *[other] cuarta derivada
    } de la ley es discontinua en { $at }; la elevación de una leva polidina contiene la fuerza, de modo que la aceleración de la propia leva sería discontinua ahí
    .help = use una ley con cuatro derivadas continuas: una spline de grado 5 o mayor, armónicos o segmentos 5-6-7-8-9

# Por qué se eligió un modelo.
model-asked-for = elegido
model-low-force = la carga de contacto del modelo rígido baja a { $force }, menos del { $part } de su media { $mean }; { $liftoff }
model-near-liftoff = cerca de la pérdida de contacto: { $liftoff }
model-two-cams = donde una leva releva a la otra hay impactos, que solo incluye el modelo de contacto
model-nothing-vibrates = { $margin }; no se da frecuencia natural ni rigidez, así que nada puede vibrar
model-vibration-loses-contact = { $vibration }; con vibración la carga de contacto baja a { $force } y se pierde el contacto; el modelo de contacto no incluye la vibración
model-vibrates = { $vibration }, más del { $allowed }; { $margin }
model-hardly-vibrates = { $vibration }, no más del { $allowed }; { $margin }
model-held-from-both-sides = sujeto por ambos lados, el seguidor no puede despegarse
model-no-liftoff = velocidad { $speed }, ninguna velocidad despega el seguidor
model-moving-floor = velocidad { $speed }; la velocidad de pérdida de contacto sobre un suelo que se mueve no se calcula
model-liftoff-at = velocidad { $speed }, pérdida de contacto a { $liftoff }
model-no-force = nada aprieta el seguidor contra la leva: el accionamiento no tiene masa, muelle ni precarga
model-inertia-only = ninguna carga media aprieta el seguidor contra la leva, la inercia da { $low } … { $high }; { $liftoff }
model-smallest-force = la carga de contacto mínima { $force } es el { $part } de la media; { $liftoff }
model-no-mass = la columna de fluido cede sin vibrar
model-harmonics = la primera frecuencia natural es { $frequency }, { $ratio } veces la frecuencia del eje; la vibración cambiaría la fuerza un { $part } de la media (RMS)

# Qué conviene saber de una simulación.
run-second-cam-bears = la segunda leva soporta la carga durante el { $part } del ciclo, hasta { $force }; en cada cambio se recorre el juego entre ambos lados
run-other-wall-bears = la otra pared de la ranura soporta la carga durante el { $part } del ciclo, hasta { $force }; en cada cambio se recorre el juego entre ambos lados
run-rigid-pulls = el modelo rígido tira donde la fuerza es negativa: el modelo de contacto sigue la pérdida de contacto
run-rigid-without-impacts = el modelo rígido no incluye los impactos donde una leva releva a la otra
run-flexible-pulls = el seguidor que vibra se separa de la leva: ahí el modelo flexible tira
run-escapes = la masa se separa de la leva y nada la devuelve
run-not-periodic = el movimiento no se repite en { $turns } vueltas y { $impacts } impactos
run-swings = el seguidor oscila: elevación y separación son ángulos en rad, la fuerza es el momento respecto al pivote en N·m (en los archivos, la fuerza en la palanca, en N), y la masa, el muelle y la precarga del accionamiento actúan respecto al pivote; la fuerza normal está en N
run-pair-distance = el par conjugado mantiene su distancia dentro de { $deviation }; donde la fuerza se vuelve negativa la soporta la segunda leva
run-steady-shaft = con su motor la velocidad oscilaría cerca de un { $ripple } y cambiaría la fuerza un { $change } de la media, no más del { $allowed }: basta la velocidad constante
run-shaft-varies = con su motor la velocidad oscila un { $found } (previsto de inercia y energía { $ripple }, que cambiaría la fuerza un { $change } de la media): la fuerza es la de la velocidad variable
run-flexible-at-mean-speed = el seguidor flexible se simula a la velocidad media del eje; la oscilación es la de un seguidor rígido
