"""Captions of the figures of a report, with the drawn quantities and their units."""

#: Captions of the figures, by name.
CAPTIONS = {
    "specimen": """The specimen: its elements on one half, coloured by radius over mean radius [-]; its bonds alone
        on the other.""",
    "geode": """Directions of the bonds, counted on the 320 faces of a geode and divided by what an isotropic fabric
        would have there [-]. Inside, a good packing shows noise and no pattern; next to the walls elements line
        up.""",
    "contacts": """First panel: share of elements [%] with a number of bonds, and their mean, the coordination number
        z. Second panel: share of elements [%] with a radius over the mean radius [-].""",
    "layering": """Solid fraction [-] over the distance from each wall in mean diameters [-]. Walls order spheres
        into layers, which die out within some two diameters; what lies beyond is the same as deep inside.""",
    "distribution": """Radial distribution function g(r) [-] over the distance of centres in mean diameters [-]: how
        often centres lie at a distance from each other, over what chance would do. Spheres in touch are at one
        diameter, a second shell follows (in two parts where all are of one size), and ever less order further
        out. Sharp peaks there would be a crystal.""",
    "calibration": """Calibration: Poisson's ratio [-] depends on one parameter of the bonds [-], and the modulus
        [Pa] is proportional to that of the bonds; so one root and one division do.""",
    "tension": """Tension of the free specimen. First panel: stress [MPa] over strain [10⁻⁶] along and across the
        pull, every packing. Second panel: displacement [nm] of every element of the first over its place
        [mm]; E and ν are read from the affine field (line) that fits the middle half best.""",
    "profiles": """Motion of the cross-sections of the clamped specimen, over that of its end in Euler–Bernoulli
        theory [-], along its length [-]: under an axial force, a transverse force and a torque.""",
    "cells": """The body under a transverse force: its cells as polyhedra, which move as rigid pieces, and a section
        along the axis [mm], coloured by the mean axial stress of each cell [MPa].""",
    "modes": """First natural modes of the clamped specimen with their frequencies [Hz], exaggerated; bright
        elements move farthest.""",
    "vibration": """Free vibration after release from a combined load. First panel: mean motion of the free end over
        its largest [-] in time [µs]. Second panel: its spectrum [-] over frequency [kHz], with the frequency
        of the mode and those of theory.""",
    "wave": """Impact: mean velocity of both end faces [m/s] in time [µs]. One face is pushed at a held velocity;
        the wave has arrived when the far face, free and so twice as fast, passes half of its plateau.""",
    "strength": """The curve of every specimen, the strength that was entered [MPa] where it has a closed form in
        the test, and the range of the measured peaks where the study names it.""",
    "broken": """The first specimen as it broke: cells as polyhedra, coloured by the damage of their facets [-], 0
        intact to 1 broken, or by their plastic slip [%].""",
    "pieces": """First panel: pieces and crumbs in a colour each. Second panel: surfaces of
        the cracks, coloured by their opening [µm].""",
    "cut_open": """Sections of the first specimen [mm]: aggregates in grey, matrix in sand. Red: facets that have
        cracked, the wider the more of their strength is lost.""",
    "energies": """Energies [J] of the first specimen along its curve: what the work of the load (dashed) has turned
        into.""",
    "errors": """Tests against theory at a glance: measured over theory, less one [%], means over the packings with
        scatter.""",
}

#: Captions of the same figures where they differ for a body of cells.
OF_CELLS = {
    "specimen": """The specimen: its cells, coloured by size over mean size [-]; one half is cut open along the
        axis.""",
    "geode": """Directions of the lines between neighbouring cells, counted on the 320 faces of a geode and divided
        by what an isotropic fabric would have there [-].""",
    "contacts": """First panel: share of cells [%] with a number of neighbours, and their mean. Second panel: share
        of cells [%] that were cut from a sphere of a radius over the mean radius [-].""",
    "layering": """Solid fraction [-] of the spheres the cells were cut from, over the distance from each wall in
        mean diameters [-].""",
    "distribution": """Radial distribution function g(r) [-] of the spheres the cells were cut from, over the
        distance of their centres in mean diameters [-].""",
}
