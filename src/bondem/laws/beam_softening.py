"""Beams that lose their integrity: one energy, a fracture energy for opening and one for shear.

A beam of integrity s, 1 whole … 0 broken, holds

    U = s U0 + (1 - s) ½ kn <L - ℓ>²,      <x> = x where positive, else 0

with U0 the energy of the whole beam (`bondem.laws.beam_energy`): all its stiffnesses fall alike, but what presses is
borne as by the whole beam. Forces are the exact gradient at fixed s; what softening dissipates is

    Y = -∂U/∂s = U0 - ½ kn <L - ℓ>² ≥ 0

Its root λ = √Y is the opening: along any straight way it grows with the way. Integrity falls where λ grows beyond
what it was, so that s λ, in proportion to the force, falls on a line from λ0, where the criterion is reached, to
λf, where nothing is left; in between the beam is unloaded to its origin:

    s = λ0 (λf - λ) / (λ (λf - λ0)),      ∫ Y (-ds) = λ0 λf = G A

on every way along which λ grows. G is found where softening begins, by the shares that opening (elongation and
bending) and sliding (shear and twisting) have in Y: G_I/G_f + G_II/G_II,c = 1 at the end, with these shares kept,

    G = 1 / (share_I / G_f + share_II / G_II,c)

A beam that holds G A or more already where it begins breaks over the last twentieth of its opening. Linear softening:
Hillerborg, Modéer and Petersson (1976); the linear rule of mixed mode, Wu and Reuter (1965), as in
Camanho and Dávila (2002).
"""

from bondem._compile import device

# Opening where nothing is left of a beam that holds more than its fracture energy, over that where it begins.
SNAP = 1.05


@device
def opened_and_slid(parts, extension):
    """What opens and what slides of the energies of a whole beam [J]; their sum is Y.

    Args:
        parts: normal, shear, bending and twisting energy, as `bond_energy` has them.
        extension: ℓ - L [m].
    """
    opening = parts[2]
    if extension > 0.0:
        opening += parts[0]
    return max(opening, 0.0), max(parts[1] + parts[3], 0.0)


@device
def last_opening(opening, sliding, tear, shear, first):
    """λf [√J] of a beam that begins to soften at λ0 = `first`.

    Args:
        opening, sliding: what opens and slides then [J].
        tear, shear: G_f A and G_II A [J].
        first: λ0 [√J].
    """
    energy = (opening + sliding) / (opening / tear + sliding / shear)
    return max(energy / first, SNAP * first)
