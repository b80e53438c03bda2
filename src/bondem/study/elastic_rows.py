"""The elastic constants of one packing with one bond law, as a row of a study.

A periodic cell gives its bulk moduli, a bar those of a tension test: the affine fit, and the paper's eqs (12)–(15).
"""

import hashlib
from dataclasses import asdict, dataclass
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import bondem.labtests
from bondem.io.packing_cache import key
from bondem.labtests.bulk import bulk_moduli
from bondem.labtests.tension import static_tension
from bondem.laws.bond import BondLaw
from bondem.specimen.lattice import Lattice
from bondem.study.packing_rows import PackingRequest, kept_lattice
from bondem.study.request import Request

#: What is measured in every packing, and in bars only.
MEASURED = ("E", "nu", "stiffness_ratio", "E_paper", "nu_paper", "axial_share", "seconds")

# To be raised when rows hold something else than before.
_SCHEMA = 1


@dataclass(frozen=True)
class ElasticRequest(Request):
    """Elastic constants of a packing with a law.

    Attributes:
        packing: the packing, made before.
        law: its bonds.
    """

    packing: PackingRequest
    law: BondLaw

    @property
    def name(self) -> str:
        """See `Request`."""
        request = {"packing": self.packing.name, "law": self.law, "row": _SCHEMA, "measuring": _measuring()}
        where = "periodic" if self.packing.periodic else self.packing.form
        law = type(self.law).__name__
        return f"{law}_{where}_n{self.packing.count}_seed{self.packing.seed}_{key(request)[:16]}"

    @property
    def weight(self) -> float:
        """See `Request`."""
        return float(self.packing.count)

    @property
    def needs(self) -> PackingRequest:
        """See `Request`."""
        return self.packing

    @property
    def asked(self) -> dict[str, Any]:
        """See `Request`; E_mu [Pa], nu_mu and the other parameters of the law [-]."""
        law = asdict(self.law)
        named = {"law": type(self.law).__name__, "E_mu": law.pop("E"), "nu_mu": law.pop("nu")}
        return asdict(self.packing) | named | {name: law.get(name) for name in ("radius_ratio", "kappa", "alpha_s")}

    def whole(self, folder: Path) -> bool:
        """See `Request`."""
        return True

    def measured(self, folder: Path) -> dict[str, Any]:
        """Solve: E [Pa], ν, E/E_μ; of bars also eqs (14), (15) and the share of the energy in bonds' elongation."""
        lattice = _lattice(self.packing, folder)
        if self.packing.periodic:
            bulk = bulk_moduli(lattice, self.law)
            return {"E": bulk.E, "nu": bulk.nu, "stiffness_ratio": bulk.E / self.law.E,
                    "E_paper": None, "nu_paper": None, "axial_share": None}  # fmt: skip
        tension = static_tension(lattice, self.law)
        energy = tension.solution.energy
        return {
            "E": tension.E,
            "nu": tension.nu,
            "stiffness_ratio": tension.E / self.law.E,
            "E_paper": tension.E_paper,
            "nu_paper": tension.nu_paper,
            "axial_share": energy.normal / energy.total,
        }


@lru_cache(maxsize=2)
def _lattice(packing: PackingRequest, folder: Path) -> Lattice:
    """The packing of a row; several laws in turn ask for the same."""
    return kept_lattice(packing, folder)


@cache
def _measuring() -> str:
    """A hash of the code that measures; that which packs and solves is in `key`."""
    digest = hashlib.sha256()
    for source in sorted(Path(bondem.labtests.__path__[0]).glob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()
