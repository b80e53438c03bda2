"""Passes over an index, for devices, of `core/gpu/crack_report.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import CellDilatation, ElasticFacets
from bondem._tables.crack_tables import CohesiveCracks, CrackEnergies, FacetStrengths
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import CrackPortions, CrushingPortions, DeviceSpan, WallEnergy
from bondem._tables.step_tables import HistoryRows, Moving, Portions


def add_energies_of_cracks(
    wall_energy: WallEnergy, crack_energies: CrackEnergies, crack_portions: CrackPortions, portions: Portions
) -> Kernel:
    """Launched for `add_crack_energies`: adds the energies of cracks and walls to those of the first portion of
    facets.

    Over one index.
    """
    return Kernel("add_energies_of_cracks", (wall_energy, crack_energies, crack_portions, portions))


def sum_portion_of_cracks(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    crack_portions: CrackPortions
) -> Kernel:
    """Sums the energies of the cracks that are treated one by one [J].

    Over one index.
    """
    return Kernel("sum_portion_of_cracks", (device_span, moving, elastic_facets, cohesive_cracks, crack_portions))


def sum_portion_of_crushing(
    device_span: DeviceSpan, facet_strengths: FacetStrengths, cohesive_cracks: CohesiveCracks, crushing_portions:
    CrushingPortions
) -> Kernel:
    """Launched for `write_crushing_of_facets`: writes the energy that facets have released beyond their fracture
    energy.

    Over one index.
    """
    return Kernel("sum_portion_of_crushing", (device_span, facet_strengths, cohesive_cracks, crushing_portions))


def sum_stressed_portion(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, crack_energies: CrackEnergies
) -> Kernel:
    """Sums the energy of dilatation of a portion of cells by their stresses [J].

    Over one index.
    """
    return Kernel("sum_stressed_portion", (device_span, moving, cell_dilatation, crack_energies))


def write_all_crushing_of_facets(
    device_span: DeviceSpan, crushing_portions: CrushingPortions, event_log: EventLog, history_rows: HistoryRows
) -> Kernel:
    """Launched for `write_crushing_of_facets`: writes the energy that facets have released beyond their fracture
    energy.

    Over one index.
    """
    return Kernel("write_all_crushing_of_facets", (device_span, crushing_portions, event_log, history_rows))


def write_energy_of_yielding(
    device_span: DeviceSpan, crack_energies: CrackEnergies, history_rows: HistoryRows
) -> Kernel:
    """Writes the heat of yielding into a record.

    Over one index.
    """
    return Kernel("write_energy_of_yielding", (device_span, crack_energies, history_rows))
