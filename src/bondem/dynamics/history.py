"""Records of a run over time."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bondem._extras import needed
from bondem._tables.columns import HistoryColumn
from bondem._types import Floats
from bondem.errors import InputError

#: Names of the kinetic and elastic energies.
STORED_ENERGIES = ("translation", "rotation", "normal", "shear", "bending", "twisting", "contact")
_ENERGIES = (*STORED_ENERGIES, "work", "loss", "friction", "non-local work", "released", "plastic", "crushing")


@dataclass(frozen=True, eq=False)
class History:
    """Records of a run over time.

    `history["name"]` returns the records of a gauge, (s, 3). An unknown name raises InputError.

    Attributes:
        records: columns time [s], fourteen energies [J], three components per gauge, shape (s, 15 + 3 g), a
            row per `every` steps of `bd.solve_explicit`. The last row is the end of a run that was completed.
        gauges: names of the gauges, in the order of their columns.
    """

    records: Floats
    gauges: tuple[str, ...] = ()

    @classmethod
    def empty(cls, gauges: tuple[str, ...]) -> "History":
        """Return a history of the named gauges without records."""
        return cls(np.zeros((0, HistoryColumn.COUNT + 3 * len(gauges))), gauges)

    def extended(self, records: Floats) -> "History":
        """Return a history with further rows of `records`, (s, 15 + 3 g), appended."""
        return History(np.concatenate([self.records, records]), self.gauges)

    def __len__(self) -> int:
        return len(self.records)

    def __getitem__(self, name: str) -> Floats:
        if name not in self.gauges:
            own = f"; did you mean history.{name}?" if isinstance(name, str) and name in ("time", "energy") else ""
            raise InputError(f"no gauge '{name}' was recorded; choose from: {', '.join(self.gauges) or 'none'}{own}")
        first = HistoryColumn.COUNT + 3 * self.gauges.index(name)
        return self.records[:, first : first + 3]

    @property
    def time(self) -> Floats:
        """Times of the records [s], shape (s,)."""
        return self.records[:, 0]

    @property
    def energy(self) -> dict[str, Floats]:
        """Energy balance [J], a dict of arrays (s,).

        Its entries are the kinetic energies "translation" and "rotation"; the elastic energies "normal", "shear",
        "bending", "twisting" and that of "contact"; the "work" of loads, drives and walls; the "loss" to damping and
        dashpots; the loss to "friction" of contacts, walls and closed cracks; and five more:

        - "non-local work": work of the extra forces of the non-local law, which have no potential;
        - "fracture": energy that bonds and facets released as they broke or softened; with a fracture energy, at most
          G_f times the area of each;
        - "crushing": energy that bonds and facets released beyond that limit, and all energy released by facets of
          cells without cohesion;
        - "plastic": energy that cells dissipated as they yielded;
        - "balance": kinetic + elastic + loss + friction + non-local work + fracture + crushing + plastic - work, less
          its value in the first record. It should be zero.

        Bonds and facets without a fracture energy release their stored energy as "fracture". In run files before
        schema 10, "fracture" also contains "crushing". See docs/decisions/0049-kinds-of-loss.md.
        """
        ledger = {name: self.records[:, 1 + k] for k, name in enumerate(_ENERGIES)}
        released, crushing = ledger.pop("released"), ledger.pop("crushing")
        total = sum(ledger[name] for name in STORED_ENERGIES) - ledger["work"]
        total = total + ledger["loss"] + ledger["friction"] + ledger["non-local work"] + released
        total = total + ledger["plastic"]
        return ledger | {"fracture": released - crushing, "crushing": crushing, "balance": total - total[:1]}

    @property
    def released(self) -> Floats:
        """Energy that bonds and facets have released, "fracture" and "crushing" together [J], shape (s,)."""
        return self.records[:, HistoryColumn.RELEASED]

    @property
    def parts(self) -> dict[str, Floats]:
        """Work of loads, elastic and kinetic energy, and dissipated energies by name [J], (s,) each."""
        energy = self.energy
        return {
            "work": energy["work"],
            "elastic": sum((energy[name] for name in STORED_ENERGIES[2:]), np.zeros(len(self))),
            "kinetic": energy["translation"] + energy["rotation"],
            **{name: energy[name] for name in ("fracture", "crushing", "plastic", "friction")},
            "damping": energy["loss"],
        }  # fmt: skip

    def to_pandas(self) -> Any:
        """Return the records as a pandas.DataFrame over time [s].

        Columns are the energies [J] by name, and the gauges as name_x, name_y, name_z.

        Raises:
            MissingDependencyError: pandas is not installed.
        """
        pandas = needed("pandas", "exchange")
        gauges = {f"{name}_{end}": self[name][:, k] for name in self.gauges for k, end in enumerate("xyz")}
        return pandas.DataFrame(self.energy | gauges, index=pandas.Index(self.time, name="time"))

    def to_xarray(self) -> Any:
        """Return the records as an xarray.Dataset over time [s].

        The dataset contains the energies [J], and gauges with the dimension "component".

        Raises:
            MissingDependencyError: xarray is not installed.
        """
        energies = {name: ("time", values) for name, values in self.energy.items()}
        gauges = {name: (("time", "component"), self[name]) for name in self.gauges}
        place = {"time": self.time, "component": list("xyz")}
        return needed("xarray", "exchange").Dataset(energies | gauges, coords=place)

    @property
    def imbalance(self) -> float:
        """Largest error of the energy balance over its largest entry [-]; NaN without records, 0 without energy."""
        if len(self) == 0:
            return np.nan
        ledger = self.energy
        balance = float(np.abs(ledger.pop("balance")).max())
        largest = max(float(np.abs(values).max()) for values in ledger.values())
        return balance / largest if largest > 0.0 else 0.0


class GrowingHistory:
    """Records of a run to which further rows are appended, in a time proportional to these rows on average."""

    def __init__(self, history: History) -> None:
        """Begin with the records of `history`."""
        self._rows, self._count, self._gauges = history.records, len(history), history.gauges

    def append(self, records: Floats) -> None:
        """Append rows with the columns of the history, (s, 15 + 3 g)."""
        count = self._count + len(records)
        if count > len(self._rows):
            larger = np.zeros((max(count, 2 * len(self._rows)), self._rows.shape[1]))
            larger[: self._count] = self.so_far.records
            self._rows = larger
        self._rows[self._count : count] = records
        self._count = count

    @property
    def so_far(self) -> History:
        """History of all records so far."""
        return History(self._rows[: self._count], self._gauges)
