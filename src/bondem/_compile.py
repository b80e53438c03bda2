"""The compiler boundary: how physics and loops become machine code.

Three decorators are all the rest of the package sees. `device` compiles a scalar function that is always
inlined into the loop that calls it: without forced inlining, and without the NumPy error model (which
spares the test for division by zero), LLVM silently stops vectorising. `kernel` compiles a loop that Python
calls, `loop` one that only compiled code calls, both with or without threads. Only contraction (fused
multiply-add) is allowed of the fast-math flags, because the full set deletes tests for NaN.

Compiled code is cached on disk. Numba notices an edit of the cached function, but not of the functions
it calls, and would run old physics; the cache directory is therefore named after a hash of every source
that can enter a kernel. It is set only while our own functions are decorated, so that other packages in
the same process keep theirs.
"""

import hashlib
import os
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar, cast

import llvmlite.binding as llvm
import numba
import numba.core.config
from numba import prange
from numba.core import event, types
from numba.core.compiler_lock import global_compiler_lock
from numba.core.registry import CPUDispatcher

from bondem._linking import InlinedOnly, LaunchingOnly, LinkedOnly, OwnCopies
from bondem._lock import alone

__all__ = [
    "LANES", "cache_directory", "compiled_before", "current_threads", "device", "kernel", "loop", "most_threads",
    "prange", "say_nothing", "threads",
]  # fmt: skip

# set by numba at import, so that type checkers do not know its attributes
config: Any = numba.core.config
F = TypeVar("F", bound=Callable[..., Any])
_PACKAGE = Path(__file__).parent
# How long a process waits for what another one compiles [s]; nothing takes a tenth of it.
_PATIENCE = 300.0


def _lanes() -> int:
    """Doubles of one register: 8 with AVX-512, else 4 (which a CPU with narrower registers takes as two).

    BONDEM_LANES, 4 or 8, overrules it, to measure one against the other; no result depends on it.
    """
    asked = os.environ.get("BONDEM_LANES", "")
    if asked in ("4", "8"):
        return int(asked)
    told = config.CPU_NAME is not None or config.CPU_FEATURES is not None  # what numba was told to compile for
    features = str(config.CPU_FEATURES or "") if told else llvm.get_host_cpu_features().flatten()
    return 8 if "+avx512dq" in features and "+avx512vl" in features else 4


LANES = _lanes()


def _source_hash() -> str:
    digest = hashlib.sha256(f"{numba.__version__} {LANES}".encode())
    for pattern in ("_compile.py", "_calls.py", "_linking.py", "_pruning.py", "laws/**/*.py", "kernels/*.py"):
        for source in sorted(_PACKAGE.glob(pattern)):
            digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def _cache_root() -> Path:
    asked = os.environ.get("BONDEM_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME")
    try:
        root = Path(asked) if asked else Path.home() / ".cache"
        (root / "bondem").mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=root / "bondem"):
            return root / "bondem"
    except (OSError, RuntimeError):  # not writable, or nobody's: a user without a home
        return Path(tempfile.gettempdir()) / f"bondem-{os.getuid() if hasattr(os, 'getuid') else 'cache'}"


cache_directory = _cache_root() / _source_hash()


def compiled_before() -> bool:
    """Whether there is compiled code on disk; without it the first use of each part takes some seconds more."""
    return any(cache_directory.rglob("*.nbi"))


# OpenMP has the cheapest launch; numba falls back by itself where libgomp is missing.
if "NUMBA_THREADING_LAYER" not in os.environ and "NUMBA_THREADING_LAYER_PRIORITY" not in os.environ:
    config.THREADING_LAYER_PRIORITY = ["omp", "tbb", "workqueue"]


# Threads that spin while they wait cost a factor of four as soon as anything else wants a core, and waking
# them costs a few µs a launch. libgomp reads this when the first threaded kernel loads it.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")
# Some microseconds of spinning are in order: they spare most of the waking between two loops of a step.
os.environ.setdefault("GOMP_SPINCOUNT", "1000")


_used: set[str] = set()


@contextmanager
def _own_cache() -> Iterator[None]:
    saved = config.CACHE_DIR
    config.CACHE_DIR = str(cache_directory)
    try:
        yield
    finally:
        config.CACHE_DIR = saved


class _Notice(event.Listener):
    """Tells people who look at a terminal or a notebook, once, why the first run waits."""

    said = False

    def on_start(self, event: Any) -> None:
        function = event.data["dispatcher"].py_func
        if self.said or not function.__module__.startswith("bondem.kernels"):
            return
        self.said = True
        if sys.stderr.isatty() or "ipykernel" in sys.modules:
            what = function.__module__.rpartition(".")[2].replace("_", " ")
            print(
                f"bondem: compiling its loops for this CPU ({what} first); a first run waits some 20 s for it, later"
                f" ones do not: {cache_directory}",
                file=sys.stderr,
            )

    def on_end(self, event: Any) -> None:
        """Nothing to say."""


_notice = _Notice()
event.register("numba:compile", _notice)


def say_nothing() -> None:
    """The caller tells people itself that code is compiled."""
    _notice.said = True


_FLAGS: dict[str, Any] = {"error_model": "numpy", "fastmath": {"contract"}, "no_cfunc_wrapper": True}


def _alone(what: str) -> AbstractContextManager[None]:
    """The only process at work on something, wherever the cache is shared."""
    name = hashlib.sha256(what.encode()).hexdigest()[:24]
    return alone(cache_directory / "locks" / name, patience=_PATIENCE)


def _warn_of_cache(error: OSError) -> None:
    if "cache" not in _used:
        _used.add("cache")
        warnings.warn(
            f"compiled code cannot be kept in '{cache_directory}' ({error.strerror}): make room, or set"
            " BONDEM_CACHE_DIR; every run compiles anew until then",
            RuntimeWarning,
            stacklevel=2,
        )


def _any_value(of: Any) -> Any:
    """The type of an argument, whatever its value: numba would compile a function once more for a constant."""
    if isinstance(of, types.BaseTuple) and not isinstance(of, types.BaseNamedTuple):
        return types.BaseTuple.from_types([_any_value(part) for part in cast(Any, of).types])
    return types.unliteral(of)


class _Shared(CPUDispatcher):
    """A function that one process compiles while all others wait for it, which would have to do the same.

    Numba itself lets all of them compile; and where two of them save at once what they compiled of one function for
    different arguments, it may later take the one for the other.
    """

    _cache: Any

    def get_call_template(self, args: Any, kws: Any) -> Any:
        return super().get_call_template([_any_value(a) for a in args], {k: _any_value(a) for k, a in kws.items()})

    def enable_caching(self) -> None:
        super().enable_caching()
        save = self._cache.save_overload

        def save_alone(sig: Any, data: Any) -> None:
            try:
                with _alone(f"{self.py_func.__module__}.{self.py_func.__qualname__}"):
                    save(sig, data)
            except OSError as error:  # a full disk: the code is there for this process
                _warn_of_cache(error)

        self._cache.save_overload = save_alone

    def compile(self, sig: Any) -> Any:
        # Code from the cache calls the threading layer by name, wherever a loop within is threaded. Numba starts that
        # layer only where such a loop was compiled in the same process as what calls it; where both had been in the
        # cache, the names stand for nothing, and the first call ends the process.
        numba.get_num_threads()
        # numba's own lock first, as in functions that are compiled for this one: no two threads wait for each other
        with global_compiler_lock, _alone(f"{self.py_func.__module__}.{self.py_func.__qualname__}{sig}"):
            return super().compile(sig)


class _Inlined(CPUDispatcher):
    """A function for other compiled ones only: called by Python it runs as plain Python.

    It gets no entry for Python in machine code, which is a fifth of the time of a first run.
    """

    def __call__(self, *args: Any, **named: Any) -> Any:
        return self.py_func(*args, **named)


def device(function: F) -> F:
    """Compile a scalar function, inlined wherever it is called; Python itself calls it uncompiled."""
    if config.DISABLE_JIT:
        return function
    options = {"nopython": True, "forceinline": True, "no_cpython_wrapper": True, **_FLAGS}
    return cast(F, _Inlined(function, targetoptions=options, pipeline_class=InlinedOnly))


class _Within(_Shared):
    """A loop for other compiled functions only: without an entry for Python, a fifth of the time of a first run."""

    def __call__(self, *args: Any, **named: Any) -> Any:
        raise TypeError(f"{self.py_func.__qualname__} is compiled for other loops only: decorate it as a kernel")


def _compiled(function: F, dispatcher: type[_Shared], *, parallel: bool, **more: bool) -> F:
    # the cache tells functions apart by name and line, not by flags: both kinds of one loop need two names
    twin = FunctionType(function.__code__, function.__globals__, function.__name__)
    twin.__doc__ = function.__doc__
    twin.__qualname__ = function.__qualname__ + ("_threaded" if parallel else "")
    if config.DISABLE_JIT:
        return cast(F, twin)
    options = {"nopython": True, "nogil": True, "parallel": parallel, **_FLAGS, **more}
    with _own_cache():
        within = LaunchingOnly if parallel else LinkedOnly
        compiler = within if dispatcher is _Within else OwnCopies
        shared = dispatcher(twin, targetoptions=options, pipeline_class=compiler)
        shared.enable_caching()
    return cast(F, shared)


def kernel(*, parallel: bool) -> Callable[[F], F]:
    """Compile a loop over arrays that Python calls, cached on disk.

    Args:
        parallel: its `prange` runs on all threads.
    """
    return lambda function: _compiled(function, _Shared, parallel=parallel)


def loop(*, parallel: bool) -> Callable[[F], F]:
    """Compile a loop over arrays that kernels and other loops call, cached on disk.

    Args:
        parallel: its `prange` runs on all threads.
    """
    return lambda function: _compiled(function, _Within, parallel=parallel, no_cpython_wrapper=True)


def current_threads() -> int:
    """How many threads kernels run on now."""
    return int(numba.get_num_threads())


def most_threads() -> int:
    """How many threads kernels can run on here."""
    return int(vars(config)["NUMBA_NUM_THREADS"])


@contextmanager
def threads(count: int | None) -> Iterator[None]:
    """Run kernels on `count` threads within the block (None: leave as it is)."""
    if count is None:
        yield
        return
    saved = numba.get_num_threads()
    numba.set_num_threads(count)
    try:
        yield
    finally:
        numba.set_num_threads(saved)
