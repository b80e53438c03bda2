"""Errors and warnings of bondem. Every message ends with advice."""

import difflib
from typing import TYPE_CHECKING, Any


class BondemError(Exception):
    """Base of all errors that bondem raises deliberately."""


class InputError(BondemError, ValueError):
    """Error for an input value that cannot be used."""


class ArgumentError(InputError, TypeError):
    """Error for an argument that a function or class does not accept; the message lists those that it accepts."""


class EmptyRegionError(InputError):
    """Error for a region that selects no element, or no connected one where these are needed."""


class DisconnectedError(InputError):
    """Error for a bonded specimen that consists of more than one large piece."""


class FloatingBodyError(InputError):
    """Error for one of several bodies that nothing supports in a static problem."""


class PackingError(BondemError):
    """Error for a packing that did not reach its target."""


class UnreachableTargetError(BondemError):
    """Error for a Poisson's ratio that a bond law on its lattice, or any bond law, cannot reach in calibration."""


class ConvergenceError(BondemError):
    """Error for a solver or calibration that did not reach its target, such as a load that nothing resists."""


class UnstableStepError(InputError):
    """Error for a time step that is above the stability limit or not positive, or a lattice without any stiffness."""


class StepWarning(UserWarning):
    """Warning of a run that its step or lack of damping may make unstable, or of dashpots that need small steps."""


class ContactWarning(UserWarning):
    """Warning of contacts outside the range of their law, or without a law, and of walls on the wrong side.

    Overlaps may be too deep, motions too fast for the step, or friction beyond the tangential spring. A wall may face
    away from the body, or elements may begin behind it. Plane faces of bodies of cells do not slide on each other.
    """


class ImbalanceWarning(UserWarning):
    """Warning of an explicit run whose energy balance has an error of more than a small share of its energies."""


class NotQuasistaticWarning(UserWarning):
    """Warning of a run meant to be quasi-static, with inertia in its forces or an unreached force of a servo wall."""


class TurnedPressureWarning(UserWarning):
    """Warning of a pressure that keeps its direction although the elements under it have turned."""


class UnstableRunWarning(UserWarning):
    """Warning of an explicit run that ended early because it became unstable or lost its energy balance."""


class FaceWarning(UserWarning):
    """Warning of a bounding-box face that selects few of the elements near it, or of a patch with too few facets."""


class StageWarning(UserWarning):
    """Warning of a schedule that began before its run, or of loads other than those of the initial equilibrium."""


class PrestressWarning(UserWarning):
    """Warning of modes about the reference of a model with loads, whose stresses would change the modes."""


class UnitWarning(UserWarning):
    """Warning of a possible value that is so unusual that its unit may be wrong."""


class StrengthWarning(UserWarning):
    """Warning of a strength or implied fracture energy that no solid has, or of a test or path without a peak."""


class FillingWarning(UserWarning):
    """Warning of particles that do not fill their shape, extend beyond it, or have hardly a bond."""


class StressFreeWarning(UserWarning):
    """Warning of a body that moves, is strained or has damage in a file, and is free of all these when read."""


class ThinBodyWarning(UserWarning):
    """Warning of a body of cells that is one cell thick somewhere, where its bending or twist is inaccurate."""


class ShortSpecimenWarning(UserWarning):
    """Warning of a tension test on a specimen of beams so short that its ends govern the measured E and ν."""


class RaggedInterfaceWarning(UserWarning):
    """Warning of facets that zigzag about an interface or a joint, because the cells do not end on it."""


class FractureEnergyWarning(UserWarning):
    """Warning of work that is not a fracture energy: of several cracks, or of cracks beside a pressure."""


class UnresolvedOpeningWarning(FractureEnergyWarning):
    """Warning of a run whose cracks open in so few time steps that their fracture energy depends on the step."""


class ReportWarning(UserWarning):
    """Warning of a figure or report that could not be written, although the results could."""


class AuxeticWarning(UserWarning):
    """Warning of a negative Poisson's ratio too low for a positive energy of uneven cells."""


class UnprotectedClusterWarning(UserWarning):
    """Warning of a Dask scheduler on another machine without TLS, to which anyone in its network can send code."""


class UnstableRunError(BondemError):
    """Error for a run whose result is needed, but which became unstable or lost its energy balance."""


class RunInterrupted(KeyboardInterrupt):
    """Interrupt of a run or test by Ctrl-C.

    Attributes:
        result: result of the run or test so far; None for a test that was too short to be evaluated.
    """

    def __init__(self, message: str, result: Any = None) -> None:
        """Store the message and the result."""
        super().__init__(message)
        self.result = result


class StudyError(InputError):
    """Error for a study file that cannot be read, or with an entry that is unknown, missing or invalid."""


class RunFileError(BondemError):
    """Error for a run file that cannot be read or resumed, or for a failure to write any file, as on a full disk."""


class MissingDependencyError(BondemError, ImportError):
    """Error for an optional library that is not installed; the message states how to install it."""


if not TYPE_CHECKING:  # type checkers shall find wrong names themselves

    def __getattr__(name: str) -> None:
        near = difflib.get_close_matches(name, __dir__(), n=1)
        hint = f"; did you mean '{near[0]}'?" if near else ""
        raise AttributeError(f"bd.errors has no attribute '{name}'{hint}", name=name)


def __dir__() -> list[str]:
    return sorted(
        name for name, thing in globals().items() if isinstance(thing, type) and issubclass(thing, BaseException)
    )
