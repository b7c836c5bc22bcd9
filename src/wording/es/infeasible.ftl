# Por qué ninguna leva cumple todos los límites y cuáles son los menores cambios suficientes.
reason-demands-contradict = Condiciones contradictorias: { $demands }.
reason-demands-infeasible = Ninguna ley situada en el círculo base o por encima cumple a la vez estas condiciones: { $demands }.
reason-limit-infeasible = Ninguna ley que cumpla las condiciones cumple el límite «{ $limit }».
reason-nothing-presses = Ninguna fuerza aprieta el seguidor contra la leva, así que limits.force_min no se puede cumplir. Fije drive.spring_rate, drive.preload o, con un eje móvil, drive.mass.
reason-limits-infeasible = Límites incompatibles: { $limits }. Ninguna ley los cumple a la vez.
reason-no-law-found = No se encontró ninguna ley que cumpla las condiciones y estos límites: { $limits }. Esto no demuestra que no exista, porque no todos los límites son convexos.
reason-solver-stopped = El algoritmo se detuvo sin resultado ({ $stop }); esto no demuestra que no exista una ley.
reason-relaxation = Menor cambio suficiente: { $changes }.
reason-relaxations = Menores cambios suficientes (cada uno basta por sí solo): { $changes }.
reason-no-relaxation = No basta con ampliar uno solo de estos límites.
reason-all-together = No basta con ampliar uno solo de estos límites. Estos cambios juntos son suficientes: { $changes }.
reason-far-relaxations = Solo basta un cambio grande de un valor: { $changes }.
reason-far-together = Ningún cambio pequeño basta. Estos cambios juntos son suficientes: { $changes }.
reason-out-of-reach = Ningún cambio pequeño basta. Cada uno de estos límites no es factible ni siquiera sin los demás y tendría que cambiar: { $changes }. Estos cambios juntos tampoco bastan.
reason-not-the-limits = Ningún cambio de límites o tamaños basta: el diseño no es factible ni siquiera sin ellos. Cambie la velocidad, la masa, el muelle, la precarga o las condiciones de la ley.
reason-change = { $key } { $to } en lugar de { $from }

# Condiciones de la ley en un conflicto.
demand-at-point = { $given } en el punto { $point } ({ $at })
demand-in-dwell = detenimiento { $dwell }
demand-on-base-circle = contacto con el círculo base
