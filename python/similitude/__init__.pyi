# SPDX-License-Identifier: MIT
from os import PathLike
from typing import Any, Iterable, Mapping, Optional, Union

import numpy as np
import pandas
from numpy.typing import NDArray

from . import _core
from ._core import InvalidInput as InvalidInput

__version__: str
__all__: list[str]

_Case = Union[str, PathLike[str]]

class Result(dict[str, Any]):
    def page(self) -> str: ...
    def save(self, path: _Case) -> None: ...
    def table(self, name: Optional[str] = None) -> pandas.DataFrame: ...
    def _repr_html_(self) -> str: ...

class Scale(Result): ...
class Heap(Result): ...
class Calibration(Result): ...
class Diagnosis(Result): ...

class Curves(Result):
    units: dict[str, str]

class Pile(_core.Pile):
    def __init__(
        self, case: _Case, experiment: str = "", *, seed: int = 1, threads: int = 0, sleep: bool = False, yes: bool = False
    ) -> None: ...
    def result(self) -> Heap: ...
    def table(self) -> pandas.DataFrame: ...
    def _repr_html_(self) -> str: ...

def scale(
    case: _Case,
    *,
    h: Optional[float] = None,
    scheme: str = "",
    keep: Iterable[str] = (),
    distorted: bool = False,
    softening: Optional[float] = None,
    invariant: str = "",
    work_of_adhesion: str = "",
    surface_energy: str = "",
    of: str = "",
    experiment: str = "",
    apparatus: str = "",
    threads: int = 0,
) -> Scale: ...
def simulate(
    case: _Case, experiment: str = "", *, seed: int = 1, threads: int = 0, sleep: bool = False, yes: bool = False
) -> Pile: ...
def predict(
    case: _Case,
    experiment: str = "",
    *,
    parameters: Mapping[str, Union[float, str]] = {},
    at: Optional[Union[Iterable[float], NDArray[np.float64]]] = None,
) -> Curves: ...
def calibrate(
    case: _Case,
    *,
    experiment: str = "",
    road: str = "surrogate",
    budget: int = 34,
    confirm: int = 6,
    estimator: str = "",
    bulk_density: bool = False,
    seed: int = 1,
    threads: int = 0,
    out: _Case = "",
    resume: bool = False,
    yes: bool = False,
) -> Calibration: ...
def diagnose(case: _Case, *, seed: int = 1, threads: int = 0, alpha: float = 0.05) -> Diagnosis: ...
