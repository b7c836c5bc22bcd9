# Ayuda de la línea de órdenes. Cada mensaje es una orden, o ORDEN-ARGUMENTO; "all-…" vale para varias órdenes.
label-usage = Uso:
label-commands = Órdenes
label-arguments = Argumentos
label-options = Opciones
label-files = Archivos
label-printed-output = Salida en pantalla
label-manufacturing-files = Archivos de fabricación
label-examples = Ejemplos:
label-values = valores:
label-default = por defecto:

value-file = ARCHIVO
value-files = ARCHIVOS
value-scene = ESCENA
value-scenes = ESCENAS
value-dir = CARPETA
value-key = CLAVE
value-value = VALOR
value-values = VALORES
value-seconds = SEGUNDOS
value-radius = RADIO
value-column = COLUMNA
value-columns = COLUMNAS
value-curve = CURVA
value-depth = PROFUNDIDAD
value-feet = PIES
value-unit = UNIDAD
value-rate = FRECUENCIA
value-mass = MASA
value-kind = TIPO
value-model = MODELO
value-ratio = RAZÓN
value-angle = ÁNGULO
value-path = RUTA
value-design = MÉTODO
value-seed = SEMILLA
value-part = PARTE
value-band = BANDA
value-folder = CARPETA
value-list = LISTA
value-table = TABLA
value-period = PERÍODO
value-span = ÁNGULO
value-folders = CARPETAS
value-pattern = TEXTO
value-name = NOMBRE
value-machine = MÁQUINA
value-shell = INTÉRPRETE
value-lang = IDIOMA
value-command = ORDEN
value-result = RESULTADO
value-recording = REGISTRO
value-acceleration = ACELERACIÓN
value-speed = VELOCIDAD

gaitcam = Diseña levas que reproducen una fuerza dada, como la fuerza vertical de una persona al caminar
synth = Diseña una leva: curva de fuerza o programa → ley → leva → comprobaciones → archivos
gait = Lee un registro: formato, canales, apoyos, ciclo medio
identify = Identifica la máquina a partir de registros de su funcionamiento: masa, rigidez, amortiguamiento, rozamiento, con intervalos
recut = Diseña la leva siguiente, que corrige los errores de fuerza repetibles de los registros de la máquina
inspect = Ajusta los puntos medidos de una leva fabricada a su diseño: desviaciones y fuerza de esta leva
ecam = Escribe un diseño como leva electrónica para un control de movimiento y calcula el error de fuerza con este control
points = Escribe el perfil como puntos para «curva por puntos» de un programa de CAD
walk = Calcula el programa de velocidad con el que una leva tiene las duraciones de paso de una marcha registrada
simulate = Simula la leva acabada: fuerza, par, pérdida de contacto, vibración, con el modelo suficiente más simple
sweep = Diseña miles de escenas (una rejilla, una lista o una muestra de valores) en una sola tabla
front = Calcula el frente de Pareto de un barrido: tabla, figuras y el mejor diseño
cover = Busca el número de levas para una población de caminantes y asigna una leva a cada caminante
compare = Compara varios resultados: tabla y diagramas superpuestos
studio = Abre el estudio, una página en el navegador que actualiza la leva con cada cambio
keys = Enumera las claves de una escena: valores, valor por defecto y significado
scenes = Enumera las escenas incorporadas, o muestra una
laws = Enumera el catálogo de leyes de subida con sus factores de pico
init = Escribe una escena comentada para una máquina
doctor = Explica los errores de una escena o un registro y cómo corregirlos
completions = Escribe el guion de autocompletado de un intérprete de órdenes
help = Muestra esta ayuda o la de una orden

all-lang = Idioma de mensajes e informes (por defecto: LC_ALL, LANG o, si no, inglés)
all-help = Muestra la ayuda
all-version = Muestra la versión
all-scene = Archivo de escena, nombre de una escena incorporada (gaitcam scenes), o - para la entrada estándar; por defecto footbridge
all-set = Cambia un valor: --set 'limits.stroke=40 mm' (se puede repetir)
all-time_limit = Termina la búsqueda pasado este tiempo de procesador y conserva el mejor resultado (por defecto 60 s, en barridos 5 s por diseño)
all-json = Escribe JSON
all-out = Carpeta de los archivos (por defecto out/NOMBRE)

synth-json = Escribe summary.json en lugar del resumen; sin --out no se escribe ningún archivo
all-no_png = No escribe figuras PNG
synth-verbose = Muestra cada paso de una secuencia de programas convexos
synth-explain = Explica la elección de cada modelo y el descarte de otros
synth-points = Número de filas de law.csv y profile.csv (por defecto 1440), o de puntos del frente (por defecto 20)
synth-front = Calcula un frente de Pareto en lugar de una leva: force_error:prime_radius, o :jerk, :acceleration, :velocity, :stroke, :torque, :power, :hertz_pressure, :liftoff_speed
synth-solid = Escribe además los archivos de taller: plano (PDF), sólido (STEP, STL, 3MF), libro (XLSX)
synth-cut_only = Omite en los dibujos DXF las líneas de referencia: círculos, marcas, curva de paso (capas REF_*)
synth-dxf = Traza los bordes de profile.dxf como arcos (R12), como splines (R2000) o como segmentos a menos de 0,002 mm (R12)
synth-ecam = Escribe además una leva electrónica: programa o tabla de puntos para un control de movimiento
synth-tool = Escribe además la trayectoria de una fresa de este radio: --tool '6 mm'
synth-pass = Profundidad de pasada de la fresa; cutter.nc contiene entonces Z, husillo y avances
synth-units = Unidad de las longitudes en el DXF, el plano y los programas, y en mensajes, informes y figuras
synth-wire = Escribe además la trayectoria de un hilo de corte de este radio, separación incluida: --wire '0.14 mm'

gait-files = Registros, o carpetas con registros: texto, OpenSim .mot/.sto, C3D, plantillas instrumentadas. Varios registros dan una tabla y su media conjunta
gait-out = Escribe el ciclo medio, o la media conjunta de varios registros, en csv o para OpenSim (.mot), con figuras (svg, png). En una carpeta se escribe también el ciclo de cada registro
gait-feet = Pies cuya fuerza se usa: both, one, left, right; total si la columna es la suma de ambos
gait-time = Nombre o número de la columna de tiempo
gait-force = Nombre o número de una columna de fuerza vertical (se puede repetir)
gait-unit = Unidad de las columnas de fuerza: N, daN, kN, lbf, kgf, N/kg, BW, %BW
gait-rate = Frecuencia de muestreo, si el archivo no la da: "1000 Hz"
gait-mass = Masa de quien camina: "72.6 kg"
gait-kind = Movimiento del registro, si no se reconoce: walking, running
gait-period = El archivo contiene exactamente un ciclo de esta duración, para cualquier máquina: "0.5 s"
gait-span = Parte de la vuelta que cubre el archivo; en el resto la fuerza es cero: "256 deg"
gait-stances = Enumera cada apoyo y cada contacto rechazado de un registro, o los escribe como tabla
gait-against = Asigna al caminante una leva de una carpeta de resultados de gaitcam cover, con el error de fuerza
gait-accept = Incluye un registro en la media conjunta a pesar de estas cuestiones abiertas: kind, clock, mass

simulate-speed = Simula la leva fabricada a esta velocidad del eje: --speed '96 rpm'
simulate-speeds = Simula la leva fabricada a varias velocidades (primera, última, número): --speeds '1.4 Hz:2.3 Hz:10'
simulate-speed_programme = Simula la leva según diseño a una velocidad que varía en el tiempo, con el motor si la escena lo tiene: speed.csv con time_s,speed_rad_per_s
simulate-model = Modelo dinámico: auto (el modelo suficiente más simple) | rigid | flexible | contact
simulate-out = Carpeta de dynamics.csv, dynamics.xlsx, simulation.json y report.html (por defecto out/NOMBRE)
simulate-natural_frequency = Primera frecuencia natural del tren del seguidor: "60 Hz"
simulate-damping_ratio = Razón de amortiguamiento del tren del seguidor (por defecto el valor de la escena, o 0.05)
simulate-friction = Coeficiente de rozamiento entre leva y seguidor (por defecto el valor de la escena, o 0)
simulate-restitution = Coeficiente de restitución de un impacto, 0 … 1 (por defecto el valor de la escena, o 0)
simulate-second_cam = Ángulo de una segunda leva igual detrás de la primera en el mismo eje: "180 deg"
simulate-units = Unidad de las longitudes en mensajes, informes y figuras

sweep-scenes = Archivos de escena (por defecto, la escena incorporada footbridge)
sweep-set = Cambia un valor en todas las escenas: --set 'limits.stroke=40 mm' (se puede repetir)
sweep-vary = Varía un valor: 'gait.step_frequency=1.5 Hz:2.4 Hz:10' o law.family=spline,harmonic (se puede repetir)
sweep-list = Lista de valores combinados: un csv con claves en su cabecera
sweep-recordings = Un diseño por registro: archivos o carpetas (se puede repetir)
sweep-sample = Toma una muestra de N puntos de los intervalos ('CLAVE=INICIO:FIN') en lugar de una rejilla
sweep-design = Método de muestreo
sweep-seed = Semilla de los números aleatorios de la muestra
sweep-out = Tabla de resultados: ARCHIVO.csv o ARCHIVO.parquet
sweep-shard = Calcula una de N partes iguales, en bloques de filas. --out es la carpeta común de todas; solo se calculan los bloques que faltan
sweep-block_rows = Número de filas de un bloque (por defecto 131072)
sweep-resume = Continúa un barrido interrumpido
sweep-jobs = Número de hilos (por defecto, uno por núcleo)
sweep-estimate = Solo estima la duración del barrido a partir de la de algunas filas; no se escribe nada
sweep-progress = Escribe cada 10 s una línea con ritmo y tiempo restante si la salida de errores no es un terminal
sweep-yes = Permite más de 100 millones de filas
sweep-tolerance = Tolerancia de fabricación de un diseño: 'profile=0.02 mm', 'base_radius=…', 'mass=…', 'speed=…' (se puede repetir)
sweep-band = Error de fuerza máximo de una leva fabricada, para el rendimiento: '2 %' de la media

front-file = Tabla de gaitcam sweep, o la carpeta de sus bloques
front-minimise = Columnas que se minimizan, separadas por comas: force_error,torque_max (por defecto force_error,prime_radius)
front-maximise = Columnas que se maximizan, separadas por comas: liftoff_speed
front-low_speed = Incluye diseños que no sirven a alta velocidad
front-best = Escribe además el mejor diseño como resultado de synth, en CARPETA/best
front-all = Incluye los diseños inaceptables
front-out = Carpeta de front.csv, figuras y report.html (por defecto out/NOMBRE-front)

cover-walkers = Carpeta de registros, o una tabla de caminantes (por defecto, los caminantes de la escena)
cover-cams = Primer y último número de levas, o un solo número; la búsqueda empieza siempre en 1
cover-scene = Escena con la máquina, sus límites y law.robust; por defecto footbridge
cover-out = Carpeta de tablas, figuras y escenas de las levas (por defecto out/NOMBRE_cover)

compare-folders = Carpetas de resultados de gaitcam synth
compare-out = Carpeta de la tabla y los diagramas
compare-units = Unidad de las longitudes en mensajes, informes y figuras
compare-json = Escribe los resúmenes en JSON

studio-open = Archivo de escena, carpeta con escenas y registros, o nombre de una escena incorporada
studio-port = Puerto de la página (por defecto, uno libre)
studio-no_open = Solo escribe la dirección; no abre el navegador

keys-pattern = Solo las claves que contienen este texto
keys-schema = Escribe un JSON Schema del archivo de escena, para editores
keys-markdown = Escribe la página de referencia en Markdown
scenes-name = Muestra esta escena en TOML

laws-name = Solo esta ley

init-machine = Máquina; si se omite, se enumeran
init-out = Archivo que se escribe, o - para la salida estándar (por defecto MÁQUINA.toml)

doctor-file = Archivo de escena, nombre de una escena incorporada, o registro
doctor-set = Cambia un valor de la escena: --set 'limits.stroke=40 mm' (se puede repetir)


completions-shell = El intérprete de órdenes


identify-design = El diseño: una carpeta o summary.json de synth, un archivo de escena o el nombre de una escena incorporada
identify-logs = Registros de la máquina en funcionamiento (csv, a cualquier velocidad): fuerza y tiempo o ángulo de la leva; velocidad y par son opcionales. Las columnas se reconocen por nombre y unidad
identify-time = Nombre o número de la columna de tiempo
identify-angle = Nombre o número de la columna del ángulo de la leva
identify-force = Nombre o número de la columna de fuerza de la célula de carga
identify-speed = Nombre o número de la columna de velocidad de la leva
identify-torque = Nombre o número de la columna de par en el eje de la leva
identify-counts_per_turn = Cuentas del encóder por vuelta de la leva, si el ángulo está en cuentas
identify-out = Carpeta de los archivos (por defecto out/NOMBRE_identified)
identify-json = Escribe identify.json en lugar del resumen; sin --out no se escribe ningún archivo
recut-design = El diseño: una carpeta o summary.json de synth, un archivo de escena o el nombre de una escena incorporada
recut-logs = Registros de la máquina en funcionamiento (csv, a cualquier velocidad): fuerza y tiempo o ángulo de la leva; velocidad y par son opcionales. Las columnas se reconocen por nombre y unidad
recut-time = Nombre o número de la columna de tiempo
recut-angle = Nombre o número de la columna del ángulo de la leva
recut-force = Nombre o número de la columna de fuerza de la célula de carga
recut-speed = Nombre o número de la columna de velocidad de la leva
recut-torque = Nombre o número de la columna de par en el eje de la leva
recut-counts_per_turn = Cuentas del encóder por vuelta de la leva, si el ángulo está en cuentas
recut-out = Carpeta de los archivos (por defecto out/NOMBRE_recut)
recut-json = Escribe summary.json en lugar del resumen; sin --out no se escribe ningún archivo
inspect-design = El diseño: una carpeta o summary.json de synth, un archivo de escena o el nombre de una escena incorporada
inspect-measured = Puntos medidos del perfil en las coordenadas de la máquina de medir: un csv con las columnas x_mm,y_mm o angle_deg,radius_mm (o m, in, rad), un punto por línea, en cualquier orden
inspect-ball = Los puntos son centros de una bola palpadora de este radio: --ball '1 mm'
inspect-set = Cambia un valor de la escena, o accionamiento y máquina de un resultado: --set 'drive.speed=60 rpm' (se puede repetir)
inspect-out = Carpeta de los archivos (por defecto la del diseño, o out/NOMBRE_inspected)
inspect-units = Unidad de las longitudes en mensajes, informes y figuras
inspect-json = Escribe inspection.json en lugar del resumen; sin --out no se escribe ningún archivo

points-design = El diseño: una carpeta o summary.json de synth, un archivo de escena o el nombre de una escena incorporada
points-cad = Programa de CAD: solidworks (x y z con tabuladores), inventor (libro con la unidad en la primera celda), fusion (centímetros), plain (con cabecera)
points-units = Unidad de las coordenadas (por defecto mm; fusion lee cm)
points-count = Número de puntos
points-out = Escribe en este archivo en lugar de la carpeta del diseño
ecam-design = El diseño: una carpeta o summary.json de synth, un archivo de escena o el nombre de una escena incorporada
ecam-dialect = Control: codesys, twincat (texto estructurado); segments (extremos de polinomios); rockwell (vector CAM); csv (posiciones)
ecam-points = Número de intervalos iguales por ciclo (por defecto el menor que reproduce la ley)
ecam-strides = Escribe la ley de este número de zancadas registradas consecutivas, para un servoeje, en lugar de una zancada media
ecam-out = Escribe en este archivo en lugar de la carpeta del diseño
ecam-name = Nombre de la leva en el programa del control, para una segunda leva en el mismo proyecto (por defecto gaitcam)
ecam-json = Escribe JSON
walk-design = El diseño: una carpeta o summary.json de synth, un archivo de escena o el nombre de una escena incorporada
walk-recording = Un registro con ocho o más zancadas consecutivas (por defecto el del diseño)
walk-generate = Genera este número de zancadas con la estadística de los pasos humanos, en lugar de un registro
walk-step_time_cv = Coeficiente de variación de las duraciones de paso generadas (por defecto "3 %")
walk-amplitude_cv = Coeficiente de variación de la amplitud de la fuerza generada (por defecto 0)
walk-seed = Semilla de los pasos generados
walk-out = Archivo del programa; las imágenes de la respuesta (svg, png) se escriben en la misma carpeta
walk-max_acceleration = Aceleración angular máxima del eje de la leva: "10 rad/s^2"
walk-json = Escribe JSON
