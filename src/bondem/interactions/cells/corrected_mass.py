"""Mass matrix for which pressure waves have their exact speed up to fourth order in the size of the cells.

Facets sample a sine over the distance L of two centres, and the dilatation of a cell is a central difference. A plane
pressure wave of frequency ω and wave number k has therefore, in an isotropic tessellation with facets of area A,

    ω² ρ / k² = 2 G (1 - k² L̄² / 20) + λ (1 - k² L̄² / 5) + κ k²,     L̄² = Σ A L³ / Σ A L

with κ of `gradient_stiffness`. The mass matrix M' = M - Θᵀ (ρ V β) Θ, with the dilatations θ = Θ u, corrects this by

    β = (L̄² (λ / 5 + 2 G / 20) - κ) / (λ + 2 G)
"""

import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import eigsh

from bondem._types import Floats, PerElement
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.dilatation_gradients import gradient_stiffness, mean_square_span
from bondem.specimen.lattice import Lattice


def correction_factors(body: Lattice, G: PerElement, lame: PerElement, density: PerElement) -> PerElement:
    """Return the factors ρ β / V of `corrected_mass` [kg/m⁶], (n,), with β of this module, but at least 0.

    Args:
        body: a lattice with facets and cells.
        G, lame: shear modulus and Lamé's λ of each cell [Pa], (n,).
        density: density of each cell [kg/m³], (n,).
    """
    _, cells = body_of(body)
    short = mean_square_span(body) * (lame / 5.0 + G / 10.0) - gradient_stiffness(body, G, lame)
    return np.asarray(density * np.maximum(short, 0.0) / (lame + 2.0 * G) / cells.volume, dtype=float)


def corrected_mass(mass: Floats, forms: csr_array, factor: PerElement) -> csr_array:
    """Return M' = M - Fᵀ (ρ β / V) F, (6 n, 6 n).

    Args:
        mass: diagonal of M [kg, kg·m²], (6 n,).
        forms: F, volume change V θ of each cell by unit motions [m², m³], (n, 6 n).
        factor: ρ β / V of each cell [kg/m⁶], (n,).
    """
    return csr_array(diags_array(mass) - forms.T @ (diags_array(factor) @ forms))


def largest_share(mass: Floats, forms: csr_array, factor: PerElement) -> float:
    """Return the largest eigenvalue μ of M⁻¹ Fᵀ (ρ β / V) F [-], for the arguments of `corrected_mass`.

    An explicit step uses the accelerations (1 + M⁻¹ Fᵀ (ρ β / V) F) M⁻¹ f, which raise squares of frequencies by a
    factor of at most 1 + μ.
    """
    scaled = diags_array(np.sqrt(factor)) @ forms @ diags_array(1.0 / np.sqrt(mass))
    square = csr_array(scaled @ scaled.T)
    if square.shape[0] < 3:
        return float(np.linalg.eigvalsh(square.toarray())[-1])
    found = eigsh(square, k=1, which="LA", tol=1e-3, v0=np.ones(len(factor)), return_eigenvectors=False)
    return 1.001 * float(found[0])
