"""Types of the compiled part; its docstrings say what each call does."""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gaitcam import Cover, Inspection, Svaj

__version__: str

_Path = str | PathLike[str]
_Verdict = Literal["acceptable", "not-for-high-speed", "unacceptable"]
_Language = Literal["en", "es"]
_Feet = Literal["both", "one", "left", "right", "total"]
_Kind = Literal["walking", "running", "standing", "jumping", "sit-to-stand", "other"]
_Log = _Path | Mapping[str, ArrayLike]
_Logs = _Log | Sequence[_Log]
_Question = Literal["kind", "clock", "mass", "clipped"]

class InputError(ValueError):
    key: str | None
    help: str | None
    code: str
    place: str

class NoSuchCam(RuntimeError): ...
class InternalError(RuntimeError): ...

class Scene:
    def __init__(self, sections: Mapping[str, Any] | None = None) -> None: ...
    @staticmethod
    def load(path: _Path) -> Scene: ...
    @staticmethod
    def builtin(name: str) -> Scene: ...
    @staticmethod
    def builtins() -> list[str]: ...
    @staticmethod
    def from_toml(text: str, folder: _Path | None = None, file: _Path | None = None) -> Scene: ...
    def set(self, changes: Mapping[str, Any]) -> Scene: ...
    def to_dict(self) -> dict[str, Any]: ...
    def to_toml(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def recording(self) -> PathLike[str] | None: ...
    def __eq__(self, other: object) -> bool: ...

class Force:
    def __init__(
        self,
        t_s: ArrayLike,
        f_n: ArrayLike,
        *,
        period_s: float | None = None,
        mass_kg: float | None = None,
        name: str | None = None,
    ) -> None: ...
    @staticmethod
    def from_recording(
        t_s: ArrayLike,
        f_n: ArrayLike,
        name: str | None = None,
        *,
        feet: _Feet | None = None,
        mass: str | None = None,
        mass_kg: float | None = None,
        unit: str | None = None,
        kind: _Kind | None = None,
        accept: str | None = None,
        period: str | None = None,
        period_s: float | None = None,
        span: str | None = None,
        span_rad: float | None = None,
    ) -> Force: ...
    @property
    def force_n(self) -> NDArray[np.float64]: ...
    @property
    def time_s(self) -> NDArray[np.float64]: ...
    @property
    def spread_n(self) -> NDArray[np.float64] | None: ...
    @property
    def period_s(self) -> float: ...
    @property
    def mean_n(self) -> float: ...
    @property
    def mass_kg(self) -> float | None: ...
    @property
    def name(self) -> str: ...
    @property
    def kind(self) -> _Kind | None: ...
    @property
    def open(self) -> list[_Question]: ...
    @property
    def stances(self) -> Table: ...
    @property
    def strides(self) -> Table: ...
    @property
    def warnings(self) -> list[str]: ...
    @overload
    def __call__(self, theta: float) -> float: ...
    @overload
    def __call__(self, theta: ArrayLike) -> NDArray[np.float64]: ...
    def __len__(self) -> int: ...

def read_gait(
    path: _Path | Sequence[_Path],
    name: str | None = None,
    *,
    feet: _Feet | None = None,
    rate: str | None = None,
    rate_hz: float | None = None,
    mass: str | None = None,
    mass_kg: float | None = None,
    unit: str | None = None,
    kind: _Kind | None = None,
    accept: str | None = None,
    time: str | None = None,
    force: str | Sequence[str] | None = None,
    period: str | None = None,
    period_s: float | None = None,
    span: str | None = None,
    span_rad: float | None = None,
) -> Force: ...

class Table:
    def __init__(self, columns: Mapping[str, Any], metadata: Sequence[tuple[str, str]] | None = None) -> None: ...
    @property
    def column_names(self) -> list[str]: ...
    def keys(self) -> list[str]: ...
    @property
    def num_rows(self) -> int: ...
    @property
    def units(self) -> dict[str, str]: ...
    @property
    def metadata(self) -> dict[str, str]: ...
    def __len__(self) -> int: ...
    def __contains__(self, name: str) -> bool: ...
    def __getitem__(self, name: str) -> Any: ...
    def _repr_html_(self) -> str: ...
    def to_pandas(self) -> Any: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...
    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...
    def __arrow_c_schema__(self) -> object: ...

class Law:
    def __init__(self, name: str) -> None: ...
    def __call__(self, theta: ArrayLike) -> Svaj: ...
    @property
    def name(self) -> str: ...
    @property
    def stroke(self) -> float: ...
    @property
    def extent(self) -> tuple[float, float]: ...
    @property
    def closed(self) -> bool: ...
    @property
    def breaks(self) -> NDArray[np.float64]: ...
    @property
    def factors(self) -> dict[str, float] | None: ...
    def extremes(self, order: int) -> tuple[tuple[float, float], tuple[float, float]]: ...

def laws() -> dict[str, Law]: ...
def program(segments: Sequence[tuple[str, float | str, float | str]]) -> Law: ...

class Design:
    @property
    def verdict(self) -> _Verdict: ...
    def reason(self, lang: _Language = "en") -> str: ...
    @property
    def summary(self) -> dict[str, Any]: ...
    @property
    def checks(self) -> list[dict[str, Any]]: ...
    @property
    def law(self) -> Table: ...
    @property
    def profile(self) -> Table: ...
    @property
    def walkers(self) -> Table: ...
    def tables(self, points: int) -> tuple[Table, Table]: ...
    @property
    def motion(self) -> Law: ...
    @property
    def scene(self) -> Scene: ...
    @property
    def name(self) -> str: ...
    def identify(
        self,
        logs: _Logs,
        *,
        time: str | None = None,
        angle: str | None = None,
        force: str | None = None,
        speed: str | None = None,
        torque: str | None = None,
        counts_per_turn: float | None = None,
    ) -> dict[str, Any]: ...
    def recut(
        self,
        logs: _Logs,
        *,
        time: str | None = None,
        angle: str | None = None,
        force: str | None = None,
        speed: str | None = None,
        torque: str | None = None,
        counts_per_turn: float | None = None,
    ) -> Design: ...
    def save(
        self,
        folder: _Path,
        *,
        points: int = 1440,
        png: bool = True,
        solid: bool = False,
        tool: float | str | None = None,
        wire: float | str | None = None,
        dxf: Literal["arcs", "splines"] = "arcs",
        cut_only: bool = False,
        lang: _Language = "en",
    ) -> PathLike[str]: ...
    def files(
        self,
        *,
        points: int = 1440,
        png: bool = False,
        solid: bool = False,
        tool: float | str | None = None,
        wire: float | str | None = None,
        dxf: Literal["arcs", "splines"] = "arcs",
        cut_only: bool = False,
        lang: _Language = "en",
    ) -> dict[str, bytes]: ...
    def ecam(
        self,
        dialect: Literal["codesys", "twincat", "segments", "rockwell", "csv"],
        points: int | None = None,
    ) -> dict[str, Any]: ...
    def plot(self, ax: Any = None, what: Literal["force", "law", "profile"] = "force") -> Any: ...
    def _repr_html_(self) -> str: ...

def synth(
    scene: Scene | None = None,
    *,
    force: Force | None = None,
    forces: Sequence[Force] | None = None,
    time_limit: float = 60.0,
) -> Design: ...

def cover(
    scene: Scene | None = None,
    *,
    forces: Sequence[Force] | None = None,
    cams: int = 6,
    time_limit: float = 60.0,
) -> Cover: ...
def doctor(given: Scene | _Path, *, time_limit: float = 60.0, lang: _Language = "en") -> list[dict[str, Any]]: ...
def identify(
    design: Design,
    logs: _Logs,
    *,
    time: str | None = None,
    angle: str | None = None,
    force: str | None = None,
    speed: str | None = None,
    torque: str | None = None,
    counts_per_turn: float | None = None,
) -> dict[str, Any]: ...
def recut(
    design: Design,
    logs: _Logs,
    *,
    time: str | None = None,
    angle: str | None = None,
    force: str | None = None,
    speed: str | None = None,
    torque: str | None = None,
    counts_per_turn: float | None = None,
) -> Design: ...
def inspect(design: Design, points: _Path | ArrayLike, *, ball: float | str | None = None) -> Inspection: ...

class Run:
    @property
    def model(self) -> Literal["rigid", "flexible", "contact"]: ...
    def why(self, lang: _Language = "en") -> str: ...
    @property
    def verdict(self) -> _Verdict: ...
    @property
    def contact_lost(self) -> bool: ...
    @property
    def summary(self) -> dict[str, Any]: ...
    @property
    def table(self) -> Table: ...
    def _repr_html_(self) -> str: ...

def simulate(
    design: Design,
    model: Literal["auto", "rigid", "flexible", "contact"] = "auto",
    *,
    machine: Mapping[str, Any] | None = None,
    force: Force | None = None,
) -> Run: ...

class Sweep:
    def __init__(
        self,
        scene: Scene | Sequence[Scene] | None = None,
        *,
        force: Force | None = None,
        vary: Mapping[str, Any] | None = None,
        rows: Mapping[str, Any] | Table | None = None,
        recordings: Sequence[_Path] | None = None,
        sample: int | None = None,
        method: Literal["latin", "sobol"] = "latin",
        seed: int = 1,
        tolerance: Mapping[str, str] | None = None,
        time_limit: float = 5.0,
    ) -> None: ...
    def run(
        self,
        start: int = 0,
        stop: int | None = None,
        *,
        jobs: int | None = None,
        progress: Callable[[int, int], object] | None = None,
    ) -> Table: ...
    def begin(self, folder: _Path, block_rows: int = 131072) -> list[tuple[int, int, PathLike[str]]]: ...
    def _repr_html_(self) -> str: ...
    @property
    def fingerprint(self) -> str: ...
    @property
    def description(self) -> dict[str, Any]: ...
    def __len__(self) -> int: ...

class Front:
    @property
    def positions(self) -> NDArray[np.int64]: ...
    @property
    def values(self) -> NDArray[np.float64]: ...
    @property
    def objectives(self) -> list[str]: ...
    @property
    def best(self) -> int | None: ...
    @property
    def left_out(self) -> int: ...
    def _repr_html_(self) -> str: ...
    def __len__(self) -> int: ...

def front(
    table: Any,
    minimise: str | Sequence[str] | None = None,
    maximise: str | Sequence[str] | None = None,
    *,
    low_speed: bool = False,
    all: bool = False,
) -> Front: ...
def keys() -> list[dict[str, Any]]: ...
