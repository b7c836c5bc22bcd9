# Errores en una magnitud con unidad.
units-no-number = «{ $text }» no empieza por un número
    .help = escriba por ejemplo { $example }
units-grouped = «{ $text }» contiene un separador de millares
    .help = escriba «{ $plain }»
units-no-unit = «{ $text }» no tiene unidad
    .help = escriba por ejemplo { $example }
units-bare-share = «{ $text }» no tiene unidad
    .help = escriba «{ $text } %», o «{ $percent } %» si se trata de la razón
units-wrong-dimension = «{ $text }» tiene una dimensión incorrecta («{ $unit }» no es una unidad de { $dimension })
    .help = escriba por ejemplo { $example }
units-out-of-range = «{ $text }» supera 1e30 en unidades SI
units-exponent = «{ $factor }» tiene un exponente que no es un entero pequeño
units-unknown-unit = unidad desconocida «{ $unit }»
    .help = { $nearest ->
        [none] se admiten unidades del SI, in, ft, lb, lbf, psi, deg, rpm, Hz, bar y sus productos
       *[other] ¿quiso decir «{ $nearest }»?
    }
