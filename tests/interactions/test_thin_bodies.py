"""Bodies of cells that are one cell thick: what walls hold of them, how they bend, and what is said of it."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import ThinBodyWarning
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.statics.linear import System
from tests.models import clamped
from tests.specimens import crooked_cells, cubes

LAW = bd.CellBond(E=1.0, nu=0.25)


def softened(length, thickness, modulus):
    """First frequency of a slender clamped beam of unit density [Hz]: 1.8751² / 2π √(E t² / 12 L⁴)."""
    return 1.8751**2 / (2.0 * np.pi) * np.sqrt(modulus / 12.0) * thickness / length**2


@pytest.mark.filterwarnings("ignore::bondem.errors.ThinBodyWarning")
@pytest.mark.parametrize(("width", "rotation"), [(3, "bending"), (1, "bending"), (3, "full"), (1, "full")])
def test_a_wall_holds_a_body_one_cell_thick_against_rotation(width, rotation):
    """A clamp is no hinge. Facets alone bend with 2 G = E / (1 + ν), with the gradient of θ across them with E."""
    law = bd.CellBond(E=1.0, nu=0.25, facet_rotation=rotation)
    body = cubes((24, width, 1))
    frequency = bd.solve_modes(clamped(body, law), count=4).frequency
    modulus = 1.0 if rotation == "bending" else 1.0 / 1.25
    wanted = softened(24.0, 1.0, modulus)
    # shear and rotary inertia take 0.5 % at this slenderness
    assert np.abs(frequency / wanted - 1.0).min() < 0.01
    static = bd.solve_static(clamped(body, law, force=(0.0, 0.0, 1e-6)))
    tip = static.displacement[-width:, 2].mean() / 1e-6
    assert tip == pytest.approx(2.0 * 23.5**2 * (3.0 * 24.0 - 23.5) / width / modulus, rel=0.01)
    assert static.reaction[:, :3].sum(axis=0) == pytest.approx([0.0, 0.0, -1e-6], abs=1e-14)


@pytest.mark.parametrize(("thick", "error"), [(2, 0.04), (4, 0.01)])
def test_a_clamped_beam_of_some_cells_bends_as_theory_says(thick, error):
    """Tip of a cantilever by Timoshenko: 2 cells 2.8 %, 4 cells 0.2 % too soft, the order being the second."""
    length = 6 * thick
    static = bd.solve_static(clamped(crooked_cells((length, thick, thick), jitter=0.15), LAW, force=(0.0, 0.0, 1e-6)))
    area, inertia = thick**2, thick**4 / 12.0
    wanted = length**3 / (3.0 * inertia) + length / (5.0 / 6.0 * LAW.G * area)
    assert 2.0 * static.energy.total / 1e-12 == pytest.approx(wanted, rel=error)


def test_a_smooth_platen_leaves_rotation_about_its_normal_free():
    """Held along x alone, a face resists rotation about y and z and not about x; four rigid motions less than six."""
    body = crooked_cells((8, 2, 2), jitter=0.15)
    model = bd.Model(body, LAW, 1.0, boundary=[bd.Fix(bd.Face("x_min"), translation="x", rotation="")])
    frequency = bd.solve_modes(model, count=3).frequency
    assert (frequency > 1e-3).all()  # three motions of the whole are taken out: y, z and about x
    assert System.of(model).loose.shape[1] == 3


@pytest.mark.filterwarnings("ignore::bondem.errors.ThinBodyWarning")
def test_one_held_facet_leaves_only_what_its_platen_leaves():
    for translation, loose in (("x", 3), ("y", 5), ("xyz", 0)):
        held = [bd.Fix(bd.Face("x_min"), translation=translation, rotation="")]
        assert System.of(bd.Model(cubes((8, 1, 1)), LAW, 1.0, boundary=held)).loose.shape[1] == loose


def test_a_body_one_cell_thick_is_a_warning():
    sheet, column = crooked_cells((8, 4, 1), jitter=0.15), crooked_cells((12, 1, 1), jitter=0.15)
    too_soft = r"one cell thick .* E / \(1 \+ ν\)"
    with pytest.warns(ThinBodyWarning, match=f"{too_soft}.*failure="):
        bd.Model(sheet, LAW, 1.0, failure=bd.Rankine(tension=1.0))
    with pytest.warns(ThinBodyWarning, match=f"{too_soft}.*nu >= 0"):
        clamped(sheet, bd.CellBond(E=1.0, nu=-0.2))
    with pytest.warns(ThinBodyWarning, match=f'{too_soft}.*"none" lacks'):
        clamped(sheet, bd.CellBond(E=1.0, nu=0.3, facet_rotation="none"))
    with pytest.warns(ThinBodyWarning, match="both ways, and twists 2.4 times too stiffly"):
        clamped(column, bd.CellBond(E=1.0, nu=0.0, facet_rotation="full"))
    for body in (sheet, column, crooked_cells((8, 2, 2), jitter=0.15)):
        clamped(body, LAW)
    bd.Model(sheet, bd.CellBond(E=1.0, nu=0.0), 1.0, failure=bd.Rankine(tension=1.0))


def test_a_layer_bends_in_two_directions_as_a_plate_does():
    """Two equal curvatures κ store E t³ κ² / 12 (1 - ν) per area; facets alone store E t³ κ² / 12 (1 + ν)."""
    nu, curvature = 0.3, 1e-4
    body = cubes((8, 8, 1))
    model = bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0)
    x = body.centre - body.centre.mean(axis=0)
    motion = np.zeros((len(x), 6))
    motion[:, 2] = -0.5 * curvature * (x[:, 0] ** 2 + x[:, 1] ** 2)
    motion[:, 3], motion[:, 4] = -curvature * x[:, 1], curvature * x[:, 0]
    strain = CellStrain.of(body, model.cell_constants, motion[:, :3], motion[:, 3:])
    constants = model.cell_constants
    bent = constants.gradients.bends(strain.turn, motion[:, 3:])[:, 0]
    inside = (np.abs(x[:, :2]) < 3.0).all(axis=1)
    np.testing.assert_allclose(np.abs(bent[inside]), 2.0 * curvature, rtol=1e-12)  # V χ = V tr κ, V = 1
    across = 0.5 * constants.gradients.weight[inside, 0] * bent[inside] ** 2
    facets = curvature**2 / 12.0 / (1.0 + nu)
    np.testing.assert_allclose(facets + across, curvature**2 / 12.0 / (1.0 - nu), rtol=1e-12)


def test_an_uneven_layer_bends_as_an_even_one():
    """A cantilever strip whose facets lie askew: without their twist it bends 40 % too much."""
    even, uneven = cubes((20, 6, 1)), crooked_cells((20, 6, 1), jitter=0.25)
    tips = []
    for body in (even, uneven):
        static = bd.solve_static(clamped(body, bd.CellBond(E=1.0, nu=0.0), force=(0.0, 0.0, 1e-6)))
        tips.append(2.0 * static.energy.total / 1e-12)
    assert tips[0] == pytest.approx(20.0**3 / (3.0 * 6.0 / 12.0), rel=0.02)
    assert tips[1] == pytest.approx(tips[0], rel=0.05)


def test_a_column_one_cell_wide_resists_twist():
    """By Saint-Venant's 0.1406 G h⁴, and no mode of zero frequency."""
    column = cubes((12, 1, 1))
    law = bd.CellBond(E=1.0, nu=0.0)
    twisted = bd.solve_static(clamped(column, law, moment=(1e-6, 0.0, 0.0)))
    wanted = 11.5 / (law.G * 0.1406)  # half a cell at the loaded end is rigid
    assert 2.0 * twisted.energy.total / 1e-12 == pytest.approx(wanted, rel=1e-3)
    assert bd.solve_modes(clamped(column, law), count=4).frequency.min() > 1e-4


@pytest.mark.parametrize(("nu", "stiffness"), [(0.25, 0.4), (0.45, 2.0 / 2.9)], ids=["λ", "2 G"])
def test_springs_between_cells_store_the_energy_of_a_gradient_within_cells(nu, stiffness):
    """½ λ j |∇θ|² with j = a² / 12 of cubes of edge a, λ at most 2 G, over the cells between facets across z."""
    edge = 1e-2
    i, j, spring = bd.Model(cubes((3, 4, 5), edge), bd.CellBond(E=1.0, nu=nu), 1.0).cell_constants.gradients.springs()
    law, slope = bd.CellBond(E=1.0, nu=nu), 0.3
    stress = law.lame * slope * cubes((3, 4, 5), edge).centre[:, 2]
    stored = 0.5 * (spring * (stress[i] - stress[j]) ** 2).sum()
    volume = 3 * 4 * 4 * edge**3
    assert stored == pytest.approx(0.5 * stiffness * edge**2 / 12.0 * slope**2 * volume, rel=1e-9)
