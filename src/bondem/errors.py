"""Everything bondem raises: one family, and every message ends with what to do."""


class BondemError(Exception):
    """Base of all errors raised on purpose by bondem."""


class InputError(BondemError, ValueError):
    """A value the user gave cannot be used."""


class EmptyRegionError(InputError):
    """A region selects no connected element."""


class DisconnectedError(InputError):
    """The bonded specimen falls into more than one large piece."""


class PackingError(BondemError):
    """A packing did not reach what was asked for."""


class UnreachableTargetError(BondemError):
    """A calibration target lies outside what the bond law can reach on this lattice."""


class ConvergenceError(BondemError):
    """An iterative solver stopped before its tolerance."""


class UnstableStepError(InputError):
    """A time step above the stability limit of the assembled lattice was asked for."""


class StepWarning(UserWarning):
    """A time step so close to the stability limit that large strains may take the run across it."""


class ContactWarning(UserWarning):
    """Contacts that their law does not describe: overlaps too deep, motion too fast for the step, or none given."""


class ImbalanceWarning(UserWarning):
    """An explicit run whose energy ledger misses more than a small share of its energies."""


class FaceWarning(UserWarning):
    """A face of particles without a shape has far fewer elements than lie near it."""


class StageWarning(UserWarning):
    """A schedule of a run that goes on from a state is over before the run begins."""


class PrestressWarning(UserWarning):
    """Modes of the reference of a model with loads, whose stresses would change them."""


class UnitWarning(UserWarning):
    """A value that is possible, but so far off that its unit may be another one."""


class StrengthWarning(UserWarning):
    """Strengths that mean a fracture energy which no such material has, so that nothing will break as it does."""


class FillingWarning(UserWarning):
    """Particles that do not fill the shape they are said to fill, or stick out of it."""


class StressFreeWarning(UserWarning):
    """Bonds of a strained body are read from a file without their lengths at rest, and become free of stress."""


class ThinBodyWarning(UserWarning):
    """A body of cells that is one cell thick somewhere: there it bends too softly or resists no twist."""


class RaggedInterfaceWarning(UserWarning):
    """Two materials meet along facets that zigzag about the surface between them, as cells do not end on it."""


class IncompressibleWarning(UserWarning):
    """Cells of a Poisson's ratio so near to ½ that a body that cannot bulge is too soft."""


class UnprotectedClusterWarning(UserWarning):
    """A Dask scheduler on another machine is used without TLS, so that anyone in its network can send it code."""


class UnstableRunError(BondemError):
    """A run on which a result depends became unstable."""


class ForkError(BondemError):
    """A process forked after bondem had used threads asks for a threaded loop, which cannot run there."""


class StudyError(InputError):
    """A study file names something unknown or leaves out something needed."""


class RunFileError(BondemError):
    """A run file cannot be written, read or resumed."""


class MissingDependencyError(BondemError, ImportError):
    """A library that only some commands need is not installed; the message says how to get it."""
