"""Passes over an index as programs of a GPU: NVRTC compiles them without a device, and a device is asked in order."""

import ctypes
import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem._core import index_loop, pass_tables
from bondem._device import DeviceTables, HostCall, Launch
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.on_device import beam_counterparts, counterparts
from bondem.dynamics.on_device.translation import Translation
from bondem.dynamics.plan import Plan
from bondem.errors import InputError
from tests.bits import assert_same_bits
from tests.device_cases import GAUGES, bar, moving

_cuda = pytest.importorskip("bondem._cuda", reason="needs cuda-core and NVRTC: pip install -e '.[gpu]'")


def has_nvrtc() -> bool:
    try:
        return bool(_cuda.nvrtc.nvrtcVersion())
    except Exception:  # the library is not there: the kind of the error depends on the version
        return False


@pytest.mark.skipif(not has_nvrtc(), reason="needs NVRTC: pip install -e '.[gpu]'")
@pytest.mark.parametrize("name", ["load_beam", "load_uniform_beam", "move_gathered", "dilate_facet", "load_facet"])
def test_passes_of_every_step_keep_their_registers(name: str) -> None:
    """All bonds or elements go through them in every step."""
    cubin, found = _cuda.compiled_passes("sm_90", name)
    assert cubin[:4] == b"\x7fELF"
    assert set(found) == {name}
    assert found[name].spilled == 0
    assert found[name].registers <= 96


def test_no_constant_contains_the_address_of_a_pass() -> None:
    """NVRTC would compile these passes with every other one: ten times the time of a pass."""
    sources = {path.name: path.read_text() for path in (_cuda.SOURCES / "gpu").glob("*.hpp")}
    address = re.compile(r"^.*constexpr auto \w+(?:##name)? = &.*$", re.MULTILINE)
    found = {name: address.findall(text) for name, text in sources.items()}
    assert {name: lines for name, lines in found.items() if lines} == {}
    assert sum(len(re.findall(r"constexpr auto \w+(?:##name)? = \w+<", text)) for text in sources.values()) > 40


@pytest.mark.skipif(not has_nvrtc(), reason="needs NVRTC: pip install -e '.[gpu]'")
@pytest.mark.validate
@pytest.mark.parametrize("architecture", ["sm_80", "sm_90"])
def test_all_passes_over_an_index_compile_without_a_device(architecture: str) -> None:
    cubin, found = _cuda.compiled_passes(architecture)
    assert cubin[:4] == b"\x7fELF"
    assert set(found) == set(pass_tables("kernels"))
    assert {name for name, thread in found.items() if thread.spilled} == set()
    # 168 registers leave three blocks of 128 threads a multiprocessor, 255 two: a cap per pass, which may only fall.
    large = {
        "load_crack": 246, "press_pair_or_faces": 224, "soften_crack": 224, "press_walls_on_element": 202,
        "begin_faces_of_pair": 192, "write_facet_failure": 174, "sum_portion_of_cracks": 170,
    }  # fmt: skip
    assert {name: thread.registers for name, thread in found.items() if thread.registers > large.get(name, 168)} == {}


@pytest.mark.skipif(not has_nvrtc(), reason="needs NVRTC: pip install -e '.[gpu]'")
def test_what_is_compiled_is_kept(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(_cuda, "cache_folder", lambda: tmp_path)
    _cuda._cached.cache_clear()
    try:
        first = _cuda._cubin("load_beam", "sm_80")
        monkeypatch.setenv("BONDEM_CUDA_FMA", "off")
        unfused = _cuda._cubin("load_beam", "sm_80")
        assert unfused != first
        monkeypatch.setattr(_cuda, "compiled_passes", None)
        assert _cuda._cubin("load_beam", "sm_80") == unfused
        monkeypatch.delenv("BONDEM_CUDA_FMA")
        assert _cuda._cubin("load_beam", "sm_80") == first
    finally:
        _cuda._cached.cache_clear()


# ---- a device of which only the memory and the order are real


class FakeBuffer:
    """Memory of a device: bytes of this process."""

    def __init__(self, address: int, size: int, kept: object = None) -> None:
        self.handle, self.size, self._kept = address, size, kept

    @staticmethod
    def from_handle(address: int, size: int) -> "FakeBuffer":
        return FakeBuffer(address, size)

    def fill(self, value: int, *, stream: Any) -> None:
        ctypes.memset(self.handle, value, self.size)

    def copy_from(self, source: "FakeBuffer", *, stream: Any) -> None:
        assert source.size == self.size
        assert stream.calls == []  # on a stream copies come behind launches
        ctypes.memmove(self.handle, source.handle, self.size)


class FakeStream:
    """Launches that wait until somebody asks."""

    def __init__(self) -> None:
        self.calls: list[Any] = []

    def sync(self) -> None:
        for call in self.calls:
            call()
        self.calls.clear()


class FakeDevice:
    """The calls of `cuda.core` that a run needs."""

    arch, name = "90", "a device"
    graphs = 0

    def set_current(self) -> None: ...

    def create_stream(self) -> FakeStream:
        return FakeStream()

    def allocate(self, size: int, *, stream: FakeStream) -> FakeBuffer:
        memory = np.zeros(size + 256, dtype=np.uint8)
        return FakeBuffer(memory.ctypes.data + (-memory.ctypes.data) % 256, size, memory)

    def create_graph_builder(self) -> Any:
        builder = FakeStream()

        def complete() -> SimpleNamespace:
            FakeDevice.graphs += 1
            return SimpleNamespace(launch=lambda stream: stream.calls.extend(builder.calls))

        return SimpleNamespace(
            calls=builder.calls, begin_building=lambda: None, end_building=lambda: SimpleNamespace(complete=complete)
        )


def fake_launch(stream: Any, config: Any, kernel: Any, count: Any, halted: Any, *tables: Any) -> None:
    assert config.grid * config.block >= count > (config.grid - 1) * config.block
    assert len(tables) == 8
    on_host, names = index_loop(kernel), pass_tables("kernels")[kernel]
    assert all((int(table) != 0) == (k < len(names)) for k, table in enumerate(tables))
    addresses = np.array([int(table) for table in tables], dtype=np.int64)
    stream.calls.append(lambda: on_host(int(count), int(halted), addresses.ctypes.data))


@pytest.fixture
def fake_cuda(monkeypatch) -> None:
    """`cuda.core` whose kernels are the passes of the CPU."""
    loaded = SimpleNamespace(from_cubin=lambda _, name: SimpleNamespace(get_kernel=lambda kernel: kernel))
    fakes = {
        "Device": FakeDevice, "Buffer": FakeBuffer, "launch": fake_launch, "ObjectCode": loaded,
        "LaunchConfig": lambda grid, block: SimpleNamespace(grid=grid, block=block),
    }  # fmt: skip
    monkeypatch.setattr(_cuda, "core", SimpleNamespace(**fakes))
    monkeypatch.setattr(_cuda, "_cubin", lambda name, architecture: b"")
    monkeypatch.setattr(FakeDevice, "graphs", 0)


def test_a_run_asks_a_device_in_order(monkeypatch, fake_cuda) -> None:
    gpu = pytest.importorskip("bondem.dynamics.gpu_loop")
    model, dt = bar(), 2e-3
    plan = Plan(duration=250 * dt, dt=dt, damping=bd.LocalDamping(0.1), gauges=GAUGES, every=40)
    monkeypatch.setattr(_cuda.CudaDevice, "fetch", _synchronous(_cuda.CudaDevice.fetch))
    monkeypatch.setattr(_cuda.CudaDevice, "send", _synchronous(_cuda.CudaDevice.send))
    cpu, device = (integrate(model, plan, state=moving(model), loop_of=loop) for loop in (CoreLoop, gpu.loop_on_gpu))
    assert_same_bits(cpu, device)
    np.testing.assert_array_equal(cpu.history.records, device.history.records)
    assert FakeDevice.graphs > 2
    monkeypatch.setenv("BONDEM_CUDA_GRAPHS", "off")
    monkeypatch.setattr(FakeDevice, "graphs", 0)
    assert_same_bits(cpu, integrate(model, plan, state=moving(model), loop_of=gpu.loop_on_gpu))
    assert FakeDevice.graphs == 0


def test_steps_with_work_of_the_cpu_are_no_graphs(monkeypatch, fake_cuda) -> None:
    """Such as a criterion of a user, which reads what the passes of this step have written."""
    gpu = pytest.importorskip("bondem.dynamics.gpu_loop")
    model, dt, seen = bar(), 2e-3, list[float]()
    plan, load = Plan(duration=7 * dt, dt=dt, every=0), beam_counterparts.COUNTERPARTS["add_beam_loads"]

    def watched(run: Translation, *tables: Any) -> list[Launch]:
        def work(of_run: DeviceTables) -> None:
            of_run.fetch(run.loads.load)
            seen.append(float(np.abs(run.loads.load).max()))

        return [*load(run, *tables), (HostCall(work), 1)]

    monkeypatch.setattr(_cuda.CudaDevice, "fetch", _synchronous(_cuda.CudaDevice.fetch))
    monkeypatch.setattr(_cuda.CudaDevice, "send", _synchronous(_cuda.CudaDevice.send))
    monkeypatch.setitem(counterparts.COUNTERPARTS, "add_beam_loads", watched)
    cpu, device = (integrate(model, plan, state=moving(model), loop_of=loop) for loop in (CoreLoop, gpu.loop_on_gpu))
    assert_same_bits(cpu, device)
    assert FakeDevice.graphs == 0
    assert len(np.unique(seen)) == 7 + 1  # with the forces at the start


def _synchronous(copy: Any) -> Any:
    """A copy behind all launches, as the stream of a device has it."""

    def behind(self: Any, *arguments: Any) -> None:
        self._stream.sync()
        copy(self, *arguments)

    return behind


def test_a_user_without_a_device_learns_what_is_missing(monkeypatch) -> None:
    gpu = pytest.importorskip("bondem.dynamics.gpu_loop")
    monkeypatch.setattr(_cuda, "lacks_gpu", lambda: "no CUDA device or driver was found: …")
    with pytest.raises(InputError, match="device='gpu': no CUDA device"):
        gpu.require_gpu(bar())
    with pytest.raises(InputError, match="no CUDA device"):
        bd.solve_explicit(bar(), duration=1e-6, device="gpu")
