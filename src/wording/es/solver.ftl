# Cómo se obtuvo la ley.
method-programme = el movimiento está prescrito y no se optimiza
method-interpolation = un sistema lineal con tantas condiciones como coeficientes
method-spectral = { $harmonics } armónicos; error de truncamiento { $rest } RMS
method-harmonics = { $harmonics } armónicos, { $rounds ->
        [one] una iteración de intercambio
       *[other] { $rounds } iteraciones de intercambio
    }; violación de restricciones { $violation }
method-search = subida de { $rise } desde { $from }, bajada de { $fall }, obtenidas en { $steps } pasos de búsqueda; error de fuerza { $error } RMS
method-no-limit-active = el óptimo sin restricciones cumple todos los límites
method-exchange = { $rounds ->
        [one] una iteración de intercambio
       *[other] { $rounds } iteraciones de intercambio
    }; violación de restricciones { $violation }
method-sequence = { $programs ->
        [one] un programa convexo
       *[other] { $programs } programas convexos sucesivos
    } para los límites no convexos; parada: { $ended ->
        [out-of-time] { ended-out-of-time }
        [most-steps] { ended-most-steps }
        [no-solution] { ended-no-solution }
        [no-improvement] { ended-no-improvement }
       *[small-gain] { ended-small-gain }
    }; violación de restricciones { $violation }
ended-out-of-time = límite de tiempo alcanzado
ended-most-steps = se alcanzó el número máximo de pasos
ended-no-solution = el programa linealizado no tiene solución cerca de la última ley
ended-no-improvement = ninguna fracción del último paso mejora el objetivo
ended-small-gain = los pasos mejoran el objetivo en menos de una parte en diez millones

# Por qué no se certifica que la ley sea el óptimo.
doubt-limits = un límite se supera en más de la tolerancia del método
doubt-gap = no se pudo cerrar la brecha de dualidad hasta una parte en un millón
doubt-touching-angle = el ángulo en que la ley toca el círculo base se obtuvo por búsqueda, sin demostrar que sea el mejor
doubt-left-out = esta ley no tiene en cuenta los límites no convexos, porque no se encontró ninguna ley que los cumpla
doubt-fixed-motion = es el óptimo para un movimiento dado del eje y del suelo; no se compararon leyes que causan otro movimiento
doubt-local = el problema no es convexo y solo se obtiene un óptimo local; la brecha se refiere a la mejor cota inferior conocida

# Por qué se descartó una familia más sencilla.
passed-over-accuracy = { $family }: supera el error de fuerza admitido en { $excess }
passed-over-check = { $family }: incumple «{ $check }» (valor { $value }, límite { $limit })
passed-over-fault = { $family }: no es posible: { $fault }

# Por qué se detuvo sin resultado un algoritmo de programas convexos.
name-singular-objective = matriz del objetivo singular
name-singular-equalities = matriz de las restricciones de igualdad singular
name-out-of-time = límite de tiempo alcanzado
name-iteration-limit = se alcanzó el límite de iteraciones
name-no-progress = no hay más progreso
name-unbounded = objetivo no acotado inferiormente
name-numerical-error = pérdida de precisión numérica
name-refused = el método de punto interior rechazó el programa
