"""Kernel launches on a device for crack initiation by functions of the stress; those of users run on the CPU."""

import numpy as np

from bondem._device import DeviceTables, HostCall, Launch
from bondem._passes import kernels
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.crack_tables import CrackOnset, StressesOfCells
from bondem._tables.damage_tables import StressCandidates, StressFunction
from bondem._tables.step_tables import Moving
from bondem._tables.stress_onset_tables import CandidateFacets
from bondem.damage.stress_passes import stress_indices
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, Translation, over

_OF_CORE = {
    "mean_stress": (kernels.judge_cell_by_mean_stress, kernels.index_candidate_by_mean_stress),
    "cone": (kernels.judge_cell_by_cone, kernels.index_candidate_by_cone),
}
_LISTED = counts.length_of(StressCandidates, lambda candidates: candidates.bond)
_MARKED = counts.length_of(CandidateFacets, lambda onset: onset.bond)


def _find_candidates(
    run: Translation, moving: Moving, facets: ElasticFacets, stored: FacetForces, stresses: StressesOfCells,
    cracks: CrackOnset, onset: CandidateFacets,
) -> list[Launch]:  # fmt: skip
    run.scratch += [onset.bond, onset.stress, onset.found]
    tables = run.span, moving, facets, stored, stresses, cracks, onset
    return [(kernels.clear_candidates(onset), 1), (kernels.find_stress_candidate(*tables), run.span.m)]


def _call(_: Translation, candidates: StressCandidates, function: StressFunction) -> list[Launch]:
    """Return the launch that calls a user's function on the host, for all candidates in the order of the bonds."""

    def work(tables: DeviceTables) -> None:
        tables.fetch(candidates.number[:1])
        count = int(candidates.number[0])
        tables.fetch(candidates.bond[:count])
        chosen = np.flatnonzero(candidates.bond[:count] >= 0)
        if len(chosen) == 0:
            return
        tables.fetch(candidates.stress[:count])
        chosen = chosen[np.argsort(candidates.bond[chosen])]
        candidates.found[chosen] = stress_indices("function", candidates.stress[chosen], function)
        tables.send(candidates.found[:count])

    return [(HostCall(work), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    **{f"judge_cells_by_{name}": over(judge, counts.elements) for name, (judge, _) in _OF_CORE.items()},
    "judge_cells_by_size": over(kernels.judge_cell_by_size, counts.elements),
    "find_stress_candidates": _find_candidates,
    **{f"index_candidates_by_{name}": over(index, _LISTED) for name, (_, index) in _OF_CORE.items()},
    "index_candidates_by_function": _call,
    "mark_failing_facets": over(kernels.mark_failing_facet, _MARKED),
    "find_strengths_along": over(kernels.find_strength_along, _MARKED),
}
