# Errores al escribir los archivos de un diseño.
write-folder-refuses = { $fault ->
        [missing] la carpeta no existe y no se puede crear
        [denied] no hay permiso de escritura aquí
        [read-only] el sistema de archivos es de solo lectura
        [full] no queda espacio en el dispositivo
       *[other] no se puede escribir en esta carpeta ({ $fault })
    }
    .help = elija otra carpeta con --out DIR
write-file-refuses = { $fault ->
        [missing] la carpeta no existe y no se puede crear
        [denied] no hay permiso de escritura aquí
        [read-only] el sistema de archivos es de solo lectura
        [full] no queda espacio en el dispositivo
       *[other] no se puede escribir ({ $fault })
    }
write-not-put-together = no se pudo crear el archivo: { $fault }
write-plate-thickness = espesor de placa no válido: { $thickness }
    .help = indique un espesor positivo
write-too-few-points = { $points } puntos del perfil no son suficientes para una placa
    .help = indique al menos { $least }
write-barrel-solid = una leva cilíndrica no tiene sólido STEP, solo archivos STL de las paredes de la ranura
write-open-profile = el perfil es abierto: no encierra una placa
    .help = use una leva de disco con una ley cerrada
write-undercut-profile = el perfil tiene rebaje y se corta a sí mismo
    .help = fije un cam.base_radius mayor o un cam.roller_radius menor
write-profile-folds = un rayo desde el centro de giro corta el perfil más de una vez, así que no es posible una placa alrededor de ese centro
    .help = fije un cam.base_radius mayor
write-bore-too-large = un agujero de { $bore } no es posible: la distancia mínima del perfil al centro es { $free }
    .help = indique un agujero positivo menor que el doble de esa distancia
write-cutter-radius = radio de fresa no válido: { $radius }
    .help = indique un radio de herramienta positivo
write-depth-of-pass = profundidad de pasada no válida: { $pass }
    .help = indique una profundidad de { $least } o más (una milésima del espesor)
write-no-cutter-path = una trayectoria de fresa requiere la ranura de una leva cilíndrica, o un perfil exterior suave en cuyas partes cóncavas quepa la fresa
write-groove-cutter = la ranura es exacta solo si la fresa tiene el radio del rodillo, { $roller }, no { $radius }
    .help = fije --tool al radio del rodillo
write-wire-too-thick = el hilo con su separación tiene un radio de { $radius } y no cabe en el chavetero
write-too-sharp = el perfil es demasiado agudo para una spline suave
    .help = fije limits.curvature para que el perfil no tenga cúspide
write-ecam-intervals = este control no admite { $asked } puntos
    .help = indique de { $least } a { $most }, u omita --points
write-ecam-points = con { $points } puntos el error RMS de fuerza de { $dialect } es el { $error } de la fuerza media (máximo { $allowed })
    .help = indique --points { $better } ({ $to }), u omita --points
write-ecam-law = el error RMS de fuerza de { $dialect } es como mínimo el { $error } de la fuerza media, con { $points } puntos (máximo { $allowed })
    .help = elija codesys, twincat o segments, o una ley de aceleración continua
write-ecam-of-motor = la ley está diseñada para un eje de velocidad variable, pero el maestro de una leva electrónica gira a velocidad constante
    .help = ponga law.shaft = "constant"
write-ecam-name = { $name } no es un nombre que acepte un control
    .help = use letras sin acentos, cifras y guiones bajos sueltos, { $longest } caracteres como máximo, con una letra al principio, por ejemplo --name tacon
