# SPDX-License-Identifier: MIT
"""Scale factors, adhesion and similarity checks for DEM of cohesive powders (docs/python.md).

scale, simulate, predict, calibrate and diagnose take a case (a folder or its case.json) and give what the verb
of that name gives with --json, as a dict. SI throughout; a quantity goes in as text with its unit.
"""

import html as _html
import inspect as _inspect
import os as _os

from . import _core
from ._core import InvalidInput, __version__

__all__ = ["Calibration", "Curves", "Diagnosis", "Heap", "InvalidInput", "Pile", "Result", "Scale", "calibrate", "diagnose", "predict", "scale", "simulate"]


def _command(function, case, options):
    """The call as one would type it, what is left at its default left out."""
    parameters = _inspect.signature(function).parameters
    words = [repr(_os.fspath(case))] + [f"{k}={v!r}" for k, v in options.items() if v != parameters[k].default]
    return f"similitude.{function.__name__}({', '.join(words)})"


def _in_frame(page):
    """A whole page inside a notebook: neither its style nor the notebook's reaches the other."""
    return f'<iframe srcdoc="{_html.escape(page)}" style="width:100%;height:36rem;border:0;resize:vertical"></iframe>'


class Result(dict):
    """A dict with the keys of the command line's JSON; str() is the command line's text."""

    _table = None  # what .table() shows unless told

    def __init__(self, answer, data=None):
        super().__init__(answer.data() if data is None else data)
        self._answer = answer

    def __str__(self):
        return self._answer.text

    def __reduce__(self):  # a page is not kept: what was pickled comes back as a plain dict
        return dict, (dict(self),)

    def page(self):
        """The report as one self-contained HTML page."""
        return self._answer.html()

    def save(self, path):
        """Writes page() to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.page())

    def _repr_html_(self):
        return _in_frame(self.page())

    def table(self, name=None):
        """One part as a pandas DataFrame: an object of objects by its keys, a list of objects by its rows."""
        import pandas

        name = name or self._table
        rows = self.get(name)
        if isinstance(rows, dict) and rows and all(isinstance(row, dict) for row in rows.values()):
            return pandas.DataFrame.from_dict(rows, orient="index")
        if isinstance(rows, list) and all(isinstance(row, dict) for row in rows):
            return pandas.DataFrame(rows)
        raise InvalidInput(f"table: got {name!r}, must be one of {', '.join(self._tables())} (a list or object of objects)")

    def _tables(self):
        parts = {k: list(v.values()) if isinstance(v, dict) else v for k, v in self.items()}
        return [k for k, v in parts.items() if isinstance(v, list) and v and all(isinstance(row, dict) for row in v)]


class Scale(Result):
    """What `similitude scale` says: format similitude-scale/1 of docs/scale.md."""

    _table = "factors"


class Heap(Result):
    """What `similitude simulate` says of a pile under runs[].result."""

    _table = "angle_of_repose"


class Diagnosis(Result):
    """What `similitude diagnose` says: format similitude-verdict/1 of docs/diagnose.md."""

    _table = "hypotheses"


class Calibration(Result):
    """What `similitude calibrate` says: format similitude-calibration/1, docs/calibrate.md."""

    _table = "factors"


class Curves(Result):
    """Channel -> numpy array (branch: list of words), the ordinate first. `units`: channel -> SI unit."""

    def __init__(self, columns, answer):
        super().__init__(answer, {name: values for name, _, values in columns})
        self.units = {name: unit for name, unit, _ in columns}

    __str__ = dict.__repr__

    def table(self, name=None):
        """All channels, headed as in the CSV files: `z [m]`."""
        import pandas

        if name is not None:
            return super().table(name)
        return pandas.DataFrame({f"{k} [{self.units[k]}]" if self.units[k] else k: v for k, v in self.items()})


class Pile(_core.Pile):
    """A pile between two steps. advance(steps) and run() go on; Ctrl-C stops them between two steps and they may
    be called again.

    x y z (m), vx vy vz (m/s), wx wy wz (rad/s), radius (m), mass (kg), id, material are
    read-only views of the core's own arrays, [grains there now]. One that is kept shows its own instant: the pile
    then goes on with a copy of that array. The core sorts its grains: id, the order of birth, says who is who."""

    def __init__(self, case, experiment="", *, seed=1, threads=0, sleep=False, yes=False):
        options = dict(experiment=experiment, seed=seed, threads=threads, sleep=sleep, yes=yes)
        super().__init__(_os.fspath(case), command=_command(simulate, case, options), **options)

    def result(self):
        """The Heap that lies there. RuntimeError before the end."""
        return Heap(self.answer())

    def table(self):
        """The grains now as a pandas DataFrame by id, glued ones marked as fixed. A copy."""
        import pandas

        names = ["id", "x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "radius", "mass", "material", "fixed"]
        grains = pandas.DataFrame({name: getattr(self, name) for name in names}, copy=True)
        return grains.set_index("id").sort_index()

    def __repr__(self):
        return f"<similitude.Pile {self.status}>"

    def _repr_html_(self):
        if self.finished:
            return self.result()._repr_html_()
        return f"<p>{_html.escape(self.status)}</p>"


def scale(case, *, h=None, scheme="", keep=(), distorted=False, softening=None, invariant="", work_of_adhesion="",
          surface_energy="", of="", experiment="", apparatus="", threads=0):
    """Scale factors, groups kept and broken, predicted adhesion, cost: `similitude scale`, its options by the same
    names (docs/scale.md). An answer outside validity is an answer: see ["adhesion"]["physically_usable"]."""
    options = dict(h=h, scheme=scheme, keep=tuple(keep), distorted=distorted, softening=softening, invariant=invariant,
                   work_of_adhesion=work_of_adhesion, surface_energy=surface_energy, of=of, experiment=experiment,
                   apparatus=apparatus, threads=threads)
    return Scale(_core.scale(_os.fspath(case), command=_command(scale, case, options), **options))


def simulate(case, experiment="", *, seed=1, threads=0, sleep=False, yes=False):
    """Pours a pile to its end and returns it: `similitude simulate` (docs/simulate.md) without files. The case's
    first pile unless told. `yes`: whatever it costs."""
    pile = Pile(case, experiment, seed=seed, threads=threads, sleep=sleep, yes=yes)
    pile.run()
    return pile


def predict(case, experiment="", *, parameters={}, at=None):
    """What a single grain would do (rigs drop, incline, impact, pull_off), at the recording's own rows unless `at`,
    SI. `parameters`: values in place of the case's, written as there, "0.2 J/m^2"; of a pull-off, `at` is on the approach."""
    options = dict(experiment=experiment, parameters=dict(parameters), at=None if at is None else [float(a) for a in at])
    return Curves(*_core.predict(_os.fspath(case), command=_command(predict, case, options), **options))


def calibrate(case, *, experiment="", road="surrogate", budget=34, confirm=6, estimator="", bulk_density=False, seed=1, threads=0, out="", resume=False, yes=False):
    """Free parameters from a recorded angle of repose: `similitude calibrate` (docs/calibrate.md). Heaps are poured here,
    so it may take hours; Ctrl-C stops it. With a folder `out` and resume=True it goes on where it was stopped."""
    options = dict(experiment=experiment, road=road, budget=budget, confirm=confirm, estimator=estimator, bulk_density=bulk_density, seed=seed, threads=threads, out=_os.fspath(out), resume=resume, yes=yes)
    return Calibration(_core.calibrate(_os.fspath(case), command=_command(calibrate, case, options), **options))


def diagnose(case, *, seed=1, threads=0, alpha=0.05):
    """Which physics was left out: `similitude diagnose` (docs/diagnose.md). A minute or so; Ctrl-C stops it."""
    options = dict(seed=seed, threads=threads, alpha=alpha)
    return Diagnosis(_core.diagnose(_os.fspath(case), command=_command(diagnose, case, options), **options))
