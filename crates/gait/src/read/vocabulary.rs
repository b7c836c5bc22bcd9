//! Words in the column names of laboratory software, in several languages. Each list is in lower case and separated by spaces.

pub(super) const LEFT: &str = "left l lfx lfy lfz lf lt lgr lgrf links linker linke gauche izquierda izquierdo \
    lhs lfs sinistra sinistro esquerda esquerdo";
pub(super) const RIGHT: &str = "right r rfx rfy rfz rf rt rgr rgrf rechts rechter rechte droit droite derecha derecho \
    destra destro direita direito rhs rfs";
/// Words for a side that may be the whole name of a column of an insole or a belt.
pub(super) const SIDE: &str = "left l right r";
/// Words that denote a force regardless of the other words.
pub(super) const STRONG_FORCE: &str = "force forces grf vgrf grfs reaction kraft fuerza forza força forca \
    bodenreaktionskraft load lgrf rgrf";
/// Words that denote a force if the rest of the name is only a number or a side.
pub(super) const WEAK_FORCE: &str = "for f";
pub(super) const VERTICAL: &str = "vertical vert vertikal verticale v normal up";
pub(super) const VERTICAL_FORCE: &str = "vgrf fv grfv fvert vforce";
/// Words for the total force of a plate or foot.
pub(super) const WHOLE: &str = "total gesamt sum plate";
/// Words for pressure insoles, and names of insole systems.
pub(super) const INSOLE: &str = "insole insoles pedar loadsol opengo moticon fscan plantilla plantillas \
    einlegesohle einlegesohlen sohle sohlen semelle semelles soletta palmilha";
pub(super) const TIME: &str = "time zeit temps tiempo tempo";
/// Words for a time, if they are at the start of a name.
pub(super) const WEAK_TIME: &str = "t timestamp sec secs seconds";
pub(super) const FRAME: &str =
    "frame frames sample samples field bild index nr no item row point framenumber";
/// Words that denote a percentage.
pub(super) const PERCENT: &str = "percent percentage pct perc prozent porcentaje pourcentage";
pub(super) const CYCLE: &str =
    "gait cycle gc stride gang gangzyklus zyklus ciclo marcha zancada marche";
pub(super) const STANCE: &str = "stance apoyo stand standphase appui";
/// Words for the phase of a cycle.
pub(super) const PHASE: &str = "phase fase";
/// Words that show that a column is not a force, regardless of the other words.
pub(super) const OTHER: &str = "m mx my mz moment moments mom torque torques tx ty tz free cop cofp copx copy copz \
    px py pz ax ay az cx cy cz center centre pressure position pos acceleration acc angular gyro angle velocity emg \
    power temperature cadence trigger sync event coefficient friction rate impulse normalised normalized ml ap";

/// Whether a list contains a word.
pub(super) fn is(word: &str, list: &str) -> bool {
    list.split(' ').any(|w| w == word)
}
