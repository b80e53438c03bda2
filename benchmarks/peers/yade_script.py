"""Runs inside Yade: `yade -n -x -j1 yade_script.py FOLDER CHECK STEPS`.

This folder must be on PYTHONPATH, because a script in Yade cannot find its own place.
"""
# ruff: noqa: F821  Yade puts its names into the script

import sys
import time
from pathlib import Path

import numpy as np
from outcome import Outcome
from specimen import DENSITY, POISSON, YOUNG, Specimen

folder = Path(sys.argv[1])
check, steps = (int(word) for word in sys.argv[2:4])
specimen = Specimen.load(folder / "specimen.npz")
material = CohFrictMat(
    young=YOUNG, poisson=POISSON, density=DENSITY, frictionAngle=0.0, isCohesive=True, momentRotationLaw=True,
    normalCohesion=1e30, shearCohesion=1e30, etaRoll=-1, etaTwist=-1, alphaKr=1.0, alphaKtw=1.0,
)  # fmt: skip
O.materials.append(material)
for x, r, v in zip(specimen.position, specimen.radius, specimen.velocity):  # noqa: B905
    body = O.bodies[O.bodies.append(sphere(x, r, material=material))]
    body.state.vel = v

loop = InteractionLoop(
    [Ig2_Sphere_Sphere_ScGeom6D()],
    [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=False, setCohesionOnNewContacts=False)],
    [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True)],
)
# There is no collider, as there are no other interactions than bonds. Elements move first: shear
# adds up from velocities, and in the usual order it would begin with a step that was not made.
O.engines = [NewtonIntegrator(damping=0.0), ForceResetter(), loop]
O.dt = float(specimen.dt)
bonds = []
for k, (i, j) in enumerate(specimen.pairs):
    bond = createInteraction(int(i), int(j))
    bonds.append(bond)
    bond.phys.kn, bond.phys.ks = float(specimen.kn[k]), float(specimen.ks[k])
    bond.phys.kr, bond.phys.ktw = float(specimen.kb[k]), float(specimen.kt[k])
    # Yade's bonds have no rest length: without this offset overlaps would strain the bonds
    bond.phys.unp = bond.geom.penetrationDepth
    bond.phys.cohesionBroken = False
    bond.phys.fragile = False
    bond.phys.normalAdhesion = bond.phys.shearAdhesion = 1e30
O.run(check, True)
position = np.array([body.state.pos for body in O.bodies])
start = time.perf_counter()
O.run(steps, True)
seconds = time.perf_counter() - start
Outcome(
    seconds=seconds,
    bonds=sum(1 for bond in bonds if bond.isReal and not bond.phys.cohesionBroken),
    position=position,
    velocity=np.array([body.state.vel for body in O.bodies]),
    spin=np.array([body.state.angVel for body in O.bodies]),
    version="Yade " + str(yade.config.version),
).save(folder / "outcome.npz")
