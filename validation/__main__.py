"""`python -m validation NAME --out DIR`: carry out a study, or go on with one in the same folder."""

import importlib
import inspect
import sys
import warnings
from types import ModuleType

import click

import bondem as bd
from bondem.cli import leave_with
from validation.frame.command import command_of, recording
from validation.frame.study import Study

#: Studies whose rows are made over several processes, into a folder.
STUDIES = (
    "abacus", "assembly", "beam_bonds", "branching", "celigueta", "coverage", "crack_paths", "dispersion", "fracture",
    "granite", "influence", "kalthoff", "protocol", "quasistatic", "refinement", "ring", "section", "size_effect",
    "spall", "surface", "toughness", "vibration", "wave", "weibull",
)  # fmt: skip
#: Those that write one record.
RECORDS = (
    "any_specimen", "beam_bodies", "bending_energy", "bonded_granite", "brazilian", "cell_bodies", "cell_figures",
    "cell_hole", "cell_inertia", "cell_moduli", "cell_rayleigh", "cell_reflection", "cell_waves", "chen",
    "chen_damping", "chen_tables", "chen_unbonded", "cmod", "concrete", "concrete_beams", "disc_finite_elements",
    "energy_drift", "every_facet", "fem_clamped", "glass", "incremental_drift", "joint_slip", "kinds_of_loss",
    "laws_side_by_side", "load_factors", "loading_paths", "mass_moments", "mesoscale", "mka3d", "non_local",
    "non_local_noise", "non_local_reach", "notched_bars", "opening_energy", "paper_parameters", "plate_forces",
    "second_order", "shattering", "shear_bands", "strength", "strength_calibration", "stress_waves",
    "time_to_accuracy", "turning_energy", "uniform_stress", "yield_surfaces",
)  # fmt: skip


def module_of(name: str) -> ModuleType:
    """The module of a study."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.UnitWarning)  # some shapes are metres long
        return importlib.import_module(f"validation.studies.{name}")


def study_of(name: str) -> type[Study]:
    """The study of a name that makes rows over several processes."""
    module = module_of(name)
    (found,) = (
        kind for kind in vars(module).values()
        if inspect.isclass(kind) and issubclass(kind, Study) and kind.__module__ == module.__name__
    )  # fmt: skip
    return found


def command(name: str) -> click.Command:
    """The command of any study."""
    if name in STUDIES:
        return command_of(study_of(name))
    return recording("validation", name, module_of(name))


class _Studies(click.Group):
    """The studies, each loaded when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return sorted((*STUDIES, *RECORDS))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return command(cmd_name) if cmd_name in (*STUDIES, *RECORDS) else None


@click.group("python -m validation", cls=_Studies, no_args_is_help=False, invoke_without_command=True,
             context_settings={"help_option_names": ["-h", "--help"]})  # fmt: skip
@click.pass_context
def validation(context: click.Context) -> None:
    """The papers' tests done again. A study goes on where it was stopped when started again with the same DIR."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


def main() -> None:
    """Run the command line and leave with its exit status, as `bondem` does."""
    leave_with(validation)


if __name__ == "__main__":
    sys.exit(main())
