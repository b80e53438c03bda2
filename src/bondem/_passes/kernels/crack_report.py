"""Passes over an index, for devices, of `core/gpu/crack_report.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import CellDilatation, ElasticFacets
from bondem._tables.crack_tables import CohesiveCracks, FacetStrengths
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import DeviceSpan
from bondem._tables.step_tables import HistoryRows, Ledger, Moving


def sum_portion_of_cracks(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    ledger: Ledger
) -> Kernel:
    """Sums the energies of the active cracks [J].

    Over one index.
    """
    return Kernel("sum_portion_of_cracks", (device_span, moving, elastic_facets, cohesive_cracks, ledger))


def sum_portion_of_crushing(
    device_span: DeviceSpan, facet_strengths: FacetStrengths, cohesive_cracks: CohesiveCracks, ledger: Ledger
) -> Kernel:
    """Launched for `write_crushing_of_facets`: writes the energy that facets have released beyond their fracture
    energy in this run [J].

    Over one index.
    """
    return Kernel("sum_portion_of_crushing", (device_span, facet_strengths, cohesive_cracks, ledger))


def sum_stressed_portion(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, ledger: Ledger
) -> Kernel:
    """Sums the energy of dilatation of a portion of cells by their stresses [J].

    Over one index.
    """
    return Kernel("sum_stressed_portion", (device_span, moving, cell_dilatation, ledger))


def write_all_crushing_of_facets(
    device_span: DeviceSpan, ledger: Ledger, event_log: EventLog, history_rows: HistoryRows
) -> Kernel:
    """Launched for `write_crushing_of_facets`: writes the energy that facets have released beyond their fracture
    energy in this run [J].

    Over one index.
    """
    return Kernel("write_all_crushing_of_facets", (device_span, ledger, event_log, history_rows))
