"""Crack initiation by a function of the stress, with tables of `core/tables/stress_onset_tables.hpp`."""

from dataclasses import dataclass

import numpy as np

from bondem._passes import StepEntry, steps
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.crack_tables import CrackOnset, FacetStrengths, StressesOfCells
from bondem._tables.damage_tables import StressCandidates
from bondem._tables.step_tables import Moving
from bondem._tables.stress_onset_tables import CandidateFacets
from bondem.damage.softening_table import SofteningTable
from bondem.damage.stress_passes import StressPasses, new_stress_candidates
from bondem.interactions.beams.bond_table import with_twins

_JUDGE_CELLS = {"mean_stress": steps.judge_cells_by_mean_stress, "cone": steps.judge_cells_by_cone}


@dataclass(frozen=True, eq=False)
class OnsetByStress:
    """Passes by which facets begin to crack where a function of the stress reaches 1.

    Attributes:
        passes: passes that evaluate the function.
        candidates: facets for which a step evaluates the function.
        onset: tables of the facets that may begin to crack.
        strengths: strengths of the facets; for a facet that cracks, that in the direction of its crack.
    """

    passes: StressPasses
    candidates: StressCandidates
    onset: CandidateFacets
    strengths: FacetStrengths

    @classmethod
    def of(cls, table: SofteningTable, strengths: FacetStrengths, portions: int) -> "OnsetByStress | None":
        """Return the passes of a body, or None if its criterion is the largest principal stress.

        `portions` is the number of groups of BONDS_OF_PORTION bonds.
        """
        if table.judge is None:
            return None
        passes, m = table.judge.passes, len(strengths.strength)
        candidates = new_stress_candidates(m)._replace(number=np.zeros(portions, dtype=np.int64))
        scale = with_twins(np.where(table.plane, 0.0, table.tension / table.strength))
        along = strengths.strength.copy()
        onset = CandidateFacets(scale, strengths.area, table.tension, table.least, table.hot, along, *candidates)
        return cls(passes, candidates, onset, strengths._replace(strength=along))

    def judge(self, stresses: StressesOfCells, cracks: CrackOnset) -> StepEntry:
        """Return the pass that selects the cells whose facets are evaluated."""
        if self.passes.name == "function":
            return steps.judge_cells_by_size(stresses, self.onset, cracks)
        return _JUDGE_CELLS[self.passes.name](stresses, self.passes.table, self.onset, cracks)

    def mark(
        self, moving: Moving, facets: ElasticFacets, stored: FacetForces, stresses: StressesOfCells,
        cracks: CrackOnset,
    ) -> list[StepEntry]:  # fmt: skip
        """Return the passes that mark facets that begin to crack, and find their strengths."""
        tables = moving, facets, stored, stresses, cracks, self.onset
        evaluate = self.passes.step_pass(self.candidates)
        return [
            steps.find_stress_candidates(*tables), evaluate,
            steps.mark_failing_facets(*tables), evaluate,
            steps.find_strengths_along(self.onset),
        ]  # fmt: skip
