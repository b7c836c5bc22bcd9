# Faults in a quantity with a unit.
units-no-number = "{ $text }" does not start with a number
    .help = write for example { $example }
units-grouped = "{ $text }" contains a thousands separator
    .help = write "{ $plain }"
units-no-unit = "{ $text }" has no unit
    .help = write for example { $example }
units-bare-share = "{ $text }" has no unit
    .help = write "{ $text } %", or "{ $percent } %" if { $text } is the ratio
units-wrong-dimension = "{ $text }" has the wrong dimension ("{ $unit }" is not a unit of { $dimension })
    .help = write for example { $example }
units-out-of-range = "{ $text }" exceeds 1e30 in SI units
units-exponent = "{ $factor }" has an exponent that is not a small integer
units-unknown-unit = unknown unit "{ $unit }"
    .help = { $nearest ->
        [none] valid units are SI units, in, ft, lb, lbf, psi, deg, rpm, Hz, bar and their products
       *[other] did you mean "{ $nearest }"?
    }
