"""Speed: the same bonds in bondem and in other codes."""

from collections.abc import Sequence

from book.chapters.cost import KRATOS, PEERS
from book.forms import Form
from book.quoting import Quoted

RATIO = Form(style=".0f")
_NAMES = {"lammps": "LAMMPS bpm/rotational", "yade": "Yade CohFrictMat", "kratos": "Kratos DEM_KDEM"}


def quoted() -> Sequence[Quoted]:
    """All quoted speeds."""
    found = []
    for record, place in ((PEERS, 0), (KRATOS, 0)):
        specimen = record.at("specimens", place)
        size = f"{specimen['elements']} spheres, {specimen['bonds']} bonds, one thread"
        for code, words in _NAMES.items():
            if code not in specimen["codes"] or (record is KRATOS and code != "kratos"):
                continue
            one = specimen["codes"][code]
            found.append(Quoted(
                name=f"speed.{code}", says=f"speed of bondem over that of {words}", size=size, record=record,
                form=RATIO, values=(one["ratio_median"],),
            ))  # fmt: skip
        if record is KRATOS:
            own = specimen["codes"]["kratos"]["ratio_median"] / specimen["codes"]["non-local"]["ratio_median"]
            found.append(Quoted(
                name="speed.kratos_non_local", says="speed of the non-local law of bondem over that of Kratos",
                size=size, record=record, form=RATIO, values=(own,),
            ))  # fmt: skip
    return found
