# Cifras de un diseño: la fila de FIGURES cuya columna lleva el nombre. `movement` es el del seguidor o el de la leva.
figure-force-rms-error-n = error de fuerza RMS
figure-force-rms-error-percent = error de fuerza RMS relativo a la media
figure-force-max-error-n = error de fuerza máximo
figure-target-mean-n = fuerza objetivo media
figure-force-mean-n = fuerza media
figure-force-min-n = fuerza mínima
figure-force-max-n = fuerza máxima
figure-mass-kg = { $movement ->
        [oscillating] momento de inercia
       *[other] masa móvil
    }
figure-speed-rad-per-s = velocidad
figure-stroke-m = carrera
figure-velocity-max-m-per-s = velocidad máxima
figure-acceleration-max-m-per-s2 = aceleración máxima
figure-jerk-max-m-per-s3 = sobreaceleración máxima
figure-base-radius-m = { $movement ->
        [straight] altura base
        [barrel] radio de la leva cilíndrica
       *[other] radio base
    }
figure-prime-radius-m = radio primario
figure-radius-min-m = radio mínimo del perfil
figure-radius-max-m = radio máximo del perfil
figure-offset-m = excentricidad
figure-rho-min-m = radio convexo mínimo
figure-pressure-angle-max-rad = ángulo de presión máximo
figure-face-width-m = longitud de la cara
figure-torque-max-n-m = par máximo
figure-torque-rms-n-m = par RMS
figure-power-max-w = potencia máxima
figure-power-mean-w = potencia media
figure-liftoff-speed-rad-per-s = velocidad de pérdida de contacto
figure-hertz-pressure-max-pa = presión de Hertz máxima
figure-shaft-ripple = oscilación de la velocidad del eje
figure-floor-acceleration-peak-m-per-s2 = aceleración máxima del suelo
figure-floor-acceleration-rms-m-per-s2 = aceleración RMS del suelo
figure-worst-walker-percent = error de fuerza del peor caminante
