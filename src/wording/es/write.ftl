# Errores al entregar un diseño.
write-folder-refuses = { $fault ->
        [missing] no existe tal carpeta y no se puede crear
        [denied] este usuario no tiene permiso para escribir aquí
        [read-only] el sistema de archivos es de solo lectura
        [full] no queda espacio en el dispositivo
       *[other] no se puede escribir en esta carpeta ({ $fault })
    }
    .help = elija otra con --out DIR
write-file-refuses = { $fault ->
        [missing] no existe tal carpeta y no se puede crear
        [denied] este usuario no tiene permiso para escribir aquí
        [read-only] el sistema de archivos es de solo lectura
        [full] no queda espacio en el dispositivo
       *[other] no se puede escribir ({ $fault })
    }
write-not-put-together = no se pudo componer el archivo: { $fault }
write-plate-thickness = espesor de placa no válido: { $thickness }
    .help = indique un espesor positivo
write-too-few-points = { $points } puntos del perfil son muy pocos para una placa
    .help = indique al menos { $least }
write-barrel-solid = una leva cilíndrica no tiene sólido STEP, solo las paredes de su ranura en STL
write-open-profile = el perfil es abierto: no encierra una placa
    .help = solo una leva de disco cuya ley se cierra da una placa
write-undercut-profile = el perfil tiene rebaje: se corta a sí mismo
    .help = amplíe el círculo base o reduzca el rodillo
write-profile-folds = un rayo desde el centro de giro corta el perfil más de una vez: no hay placa alrededor de ese centro
    .help = amplíe el círculo base
write-bore-too-large = un agujero de { $bore } no cabe: el perfil llega a { $free } del centro
    .help = indique un agujero positivo menor que el doble de esa distancia
write-cutter-radius = radio de fresa no válido: { $radius }
    .help = indique un radio de herramienta positivo
write-depth-of-pass = profundidad de pasada no válida: { $pass }
    .help = indique una profundidad de { $least } o más: una milésima del espesor
write-no-cutter-path = solo existe trayectoria de fresa para el exterior de una leva suave, con una fresa que quepa en sus huecos, y para la ranura de una leva cilíndrica
write-groove-cutter = la ranura es exacta solo con una fresa del radio del rodillo, { $roller }, no { $radius }
    .help = dé ese radio a --tool
write-wire-too-thick = el hilo con su separación, { $radius }, no cabe en el chavetero
write-too-sharp = el perfil es demasiado agudo para una spline suave
    .help = fije limits.curvature para que el perfil no tenga cúspide
write-ecam-intervals = { $asked } puntos son demasiado pocos o demasiados para este control
    .help = indique de { $least } a { $most }, o quite --points
write-ecam-points = con { $points } puntos el error de fuerza de { $dialect } es el { $error } de la media, RMS (máximo { $allowed })
    .help = indique --points { $better } ({ $to }), o quítelo
write-ecam-law = el menor error de fuerza de { $dialect } es el { $error } de la media, RMS, con { $points } puntos (máximo { $allowed })
    .help = elija codesys, twincat o segments, o una ley cuya aceleración no salte
write-ecam-of-motor = la ley es para un eje cuya velocidad varía con su motor; el maestro de una leva electrónica gira uniformemente
    .help = ponga law.shaft = "constant"
