# Faults in a quantity with a unit.
units-no-number = "{ $text }" does not start with a number
    .help = write for example { $example }
units-grouped = "{ $text }" contains a thousands separator
    .help = write "{ $plain }"
units-no-unit = "{ $text }" has no unit
    .help = write for example { $example }
units-bare-share = "{ $text }" has no unit
    .help = write "{ $text } %", or "{ $percent } %" if the plain ratio is meant
units-wrong-dimension = "{ $text }" has the wrong dimension ("{ $unit }" is not a unit of { $dimension })
    .help = write for example { $example }
units-out-of-range = "{ $text }" is larger than 1e30 in SI units
units-exponent = "{ $factor }" has an exponent that is not a small integer
units-unknown-unit = unknown unit "{ $unit }"
    .help = { $nearest ->
        [none] units are SI, in, ft, lb, lbf, psi, deg, rpm, Hz, bar and their products
       *[other] did you mean "{ $nearest }"?
    }
