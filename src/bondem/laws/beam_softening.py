"""Beams that lose their integrity: one energy, a fracture energy for opening and one for shear.

A beam of integrity s, 1 whole … 0 broken, stores

    U = s U0 + (1 - s) ½ kn <L - ℓ>²,      <x> = x where positive, else 0

with U0 the energy of the whole beam (`bondem.laws.beam_energy`). All its stiffnesses fall alike, but compression is
carried as by the whole beam. Forces are the exact gradient at fixed s; softening dissipates

    Y = -∂U/∂s = U0 - ½ kn <L - ℓ>² ≥ 0

Its root λ = √Y is the opening: along any straight path it grows with the path. Integrity falls where λ grows beyond
its previous maximum. The product s λ, proportional to the force, falls on a line from λ0, where the criterion is
reached, to λf, where it is zero. In between the beam is unloaded to its origin:

    s = λ0 (λf - λ) / (λ (λf - λ0)),      ∫ Y (-ds) = λ0 λf = G A

on every path along which λ grows. G is determined where softening begins, by the shares of opening (elongation and
bending) and sliding (shear and twisting) in Y: G_I/G_f + G_II/G_II,c = 1 at the end, with constant shares,

    G = 1 / (share_I / G_f + share_II / G_II,c)

A beam that stores G A or more at the beginning breaks over the last twentieth of its opening. Linear softening:
Hillerborg, Modéer and Petersson (1976); the linear rule of mixed mode, Wu and Reuter (1965), as in
Camanho and Dávila (2002).
"""

from bondem._compile import device

# Opening where nothing is left of a beam that holds more than its fracture energy, over that where it begins.
SNAP = 1.05


@device
def opened_and_slid(parts, extension):
    """Return the energies of opening and of sliding of a whole beam [J]; their sum is Y.

    Args:
        parts: normal, shear, bending and twisting energy, from `bond_energy`.
        extension: ℓ - L [m].
    """
    opening = parts[2]
    if extension > 0.0:
        opening += parts[0]
    return max(opening, 0.0), max(parts[1] + parts[3], 0.0)


@device
def last_opening(opening, sliding, tear, shear, first):
    """Return λf [√J] of a beam that begins to soften at λ0 = `first`.

    Args:
        opening, sliding: energies of opening and sliding at that moment [J].
        tear, shear: G_f A and G_II A [J].
        first: λ0 [√J].
    """
    energy = (opening + sliding) / (opening / tear + sliding / shear)
    return max(energy / first, SNAP * first)
