"""`bondem export FILE.h5 OTHER`: write a file for another program."""

from pathlib import Path

import click
import numpy as np

from bondem.errors import InputError, RunFileError
from bondem.io.exporting import export
from bondem.io.importing import read_lattice
from bondem.io.run_contents import read_contents
from bondem.io.runfile import read_run


@click.command("export")
@click.argument("file", metavar="FILE.h5", type=click.Path(path_type=Path))
@click.argument("other", metavar="OTHER", type=click.Path(path_type=Path))
@click.option("--density", type=float, metavar="RHO",
              help="Density of the elements of a packing [kg/m³], for LAMMPS; not for run files.")  # fmt: skip
def command(file: Path, other: Path, density: float | None) -> None:
    """Write the last checkpoint of a run file, or a packing with its bonds, for another program.

    The format follows from the suffix of OTHER: .csv, .data (LAMMPS), .dump (OVITO), .vtu, .vtk, .xdmf or .msh.
    """
    try:
        read_contents(file)
    except RunFileError as reason:
        if "not a run file" not in str(reason):
            raise
        export(other, read_lattice(file), density=density)
        return
    if density is not None:
        raise InputError("--density: a run file has the density of its model; leave out --density")
    run = read_run(file)
    lattice = run.model.lattice
    export(other, lattice, state=run.state, density=float(np.median(run.model.mass / lattice.element_volume)))
