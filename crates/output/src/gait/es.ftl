# Rótulos de las tablas de registros.
gait-format = formato
gait-kind = tipo
gait-kind-unknown = no reconocido
gait-rate = muestreo
gait-mass = masa
gait-mass-unknown = no conocida
gait-note = nota
gait-channel = canal
gait-channel-columns = pie        lín. base N  apoyos  rechazos
gait-stance-columns = pie        inicio s   fin s     P1 N     @ %   V N     @ %   P2 N     @ %
gait-rejected = rechazado
gait-feet-columns = pie        n          P1 BW           V BW          P2 BW  apoyo %
gait-double-support = doble apoyo
gait-cadence = cadencia
gait-symmetry = índice de simetría del impulso
gait-no-cycle = sin ciclo medio
gait-cycle = ciclo
gait-period = período
gait-mean = media
gait-warning = aviso
gait-spread = dispers.
gait-repeatability = repetib.
gait-varies = varía
gait-variability = { $strides } zancadas consecutivas{ $runs ->
        [one] {""}
       *[other] {" "}en { $runs } series
    }: duración del paso ± { $time } %{ $single ->
        [true] {" "}(la mitad de la zancada: se registró un solo pie)
       *[other] {""}
    }, amplitud a la frecuencia de paso ± { $amplitude } %, correlación de pasos consecutivos { $autocorrelation }
gait-pace = la duración de la zancada cambia un { $change } % del primer al último cuarto de las zancadas; en resonancia esto tiene el mismo efecto que la variabilidad
gait-samples = muestras
gait-doubt = abierto
gait-unacceptable = El registro no se puede usar: { $list }. { $others ->
        [0] Registre de nuevo con un rango mayor.
       *[other] Registre de nuevo con un rango mayor, o excluya la columna recortada (--force).
    }
gait-doubts = Compruebe { $list }. Indique después { $count ->
        [0] otro registro
        [one] el valor correcto (opción { $options })
       *[other] el valor correcto (opciones { $options })
    }, o acepte con gait.accept = "{ $names }".
gait-trial-columns = archivo  tipo  usados  rechazados  zancada s  masa kg  media N  notas  media conjunta
gait-used = usado
gait-left-out = excluido: { $reason }
gait-joint-mean = { $trials ->
        [one] media conjunta de un registro
       *[other] media conjunta de { $trials } registros
    }, { $cycles ->
        [one] un ciclo
       *[other] { $cycles } ciclos
    }: { $movement ->
        [running] { kind-running }
       *[walking] { kind-walking }
    }
gait-no-joint-mean = sin media conjunta
gait-as-given = un ciclo
gait-several-sources = de varias fuentes
gait-one-cycle = un ciclo de fuerza, usado sin cambios (sin detección de apoyos)
