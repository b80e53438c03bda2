// Descriptions of the fields of tables (`tables/*.hpp`), written by `python -m tests.core.tables`.
#pragma once
#include "described.hpp"
#include "tables/beam_softening_tables.hpp"
#include "tables/cell_tables.hpp"
#include "tables/columns.hpp"
#include "tables/contact_tables.hpp"
#include "tables/crack_sample_tables.hpp"
#include "tables/crack_tables.hpp"
#include "tables/damage_tables.hpp"
#include "tables/device_tables.hpp"
#include "tables/incremental_tables.hpp"
#include "tables/non_local_tables.hpp"
#include "tables/packing_tables.hpp"
#include "tables/quasistatic_tables.hpp"
#include "tables/statics_tables.hpp"
#include "tables/step_tables.hpp"
#include "tables/stiffness_tables.hpp"
#include "tables/stress_onset_tables.hpp"
#include "tables/surface_tables.hpp"
#include "tables/tessellation_tables.hpp"
#include "tables/wall_rows.hpp"

namespace bondem {

#define F BONDEM_FIELD
BONDEM_TABLE(SofteningBounds, F(limit, "m"), F(of_force, ""), F(of_moment, ""), F(coefficient, "bonds 4"), F(station, "bonds"), F(tear, "bonds"), F(slide, "bonds"), F(integrity, "m"), F(per_length, "*"), F(press, "m"), F(onset, "bonds 4"))
BONDEM_TABLE(SofteningBeams, F(row, "bonds 7"), F(rows, "1"), F(listed, "bonds"), F(number, "bond_portions"), F(parted, "bond_portions"), F(lost, "1 68"))
BONDEM_TABLE(ElasticFacets, F(i, "m"), F(j, "m"), F(integrity, "m"), F(k, "m"), F(pitch, "3"), F(lever_i, "3 m"), F(lever_j, "3 m"), F(share_i, "3 m"), F(share_j, "3 m"), F(H, "6 m"), F(normal, "3 m"), F(period, "6"))
BONDEM_TABLE(CellDilatation, F(weight, "n"), F(given, "n"), F(swelling, "*"), F(to_i, "m"))
BONDEM_TABLE(DilatationGradients, F(start, "n+1"), F(other, "springs"), F(spring, "springs"), F(difference, "n"), F(layer, "layered+1"), F(next, "turns"), F(way, "turns 12"), F(wall_start, "layered+1"), F(wall, "layer_walls"), F(wall_way, "layer_walls 6"), F(weight, "layered 2"), F(bend, "layered 4"), F(torque, "layered 3"))
BONDEM_TABLE(CorrectedMass, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"), F(factor, "n"), F(wall_start, "n+1"), F(wall, "supports"), F(acceleration, "n 6"), F(inertia, "n"), F(force, "n 6"))
BONDEM_TABLE(CellEnergies, F(energy, "4"))
BONDEM_TABLE(CellPoses, F(pose, "n 8"), F(rest, "n 3"))
BONDEM_TABLE(FacetForces, F(bends, "m"), F(force, "3 m"), F(moment, "n 7"), F(sums, "* 8"))
BONDEM_TABLE(FacetsOfCells, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"))
BONDEM_TABLE(FacetRelease, F(whole, "n"), F(weight, "n"), F(given, "n"), F(slack_i, "bonds"), F(slack_j, "bonds"), F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "bonds"), F(wall_start, "n+1"), F(wall, "supports"), F(changed, "n"), F(changes, "1"))
BONDEM_TABLE(WallConstraints, F(cell, "supports"), F(row, "supports"), F(k, "supports"), F(lever, "supports 3"), F(arm, "supports 3"), F(share, "supports 3"), F(H, "supports 6"), F(base, "supports 7"), F(axes, "supports 3"), F(drive, "supports 3"), F(rate, "support_schedules"), F(times, "support_times"), F(values, "support_times"), F(start, "support_schedules+1"), F(wall, "supports 3"), F(increment, "supports 3"), F(load, "supports 6"), F(friction, "supports"), F(inward, "supports 3"))
BONDEM_TABLE(FacetTractions, F(value, "tractions n"), F(schedule, "tractions"), F(factor, "tractions"), F(increment, "tractions"))
BONDEM_TABLE(CellStrains, F(schedule, "strains"), F(base_i, "3 strained"), F(base_j, "3 strained"), F(still, "strained"), F(part, "strains strained"), F(wall_base, "supports 3"), F(wall_still, "supports"), F(wall_part, "strains supports"), F(place, ""), F(factor, "4 strains"), F(power, "strains 68"), F(due, "2"))
BONDEM_TABLE(WallTime, F(time, ""))
BONDEM_TABLE(TurnedVectors, F(quaternion, "vectors 4"), F(vector, "vectors 3"), F(turned, "vectors 3"))
BONDEM_TABLE(MomentsOfForces, F(moment, "* 6"), F(owner, "vectors"), F(arm, "vectors 3"), F(force, "vectors 3"), F(sign, ""))
BONDEM_TABLE(ContactRow, F(modulus, ""), F(soft, ""), F(friction, ""), F(damping, ""), F(rolling, ""), F(twisting, ""), F(deep, ""), F(strength, ""), F(reach, ""))
BONDEM_TABLE(ContactConstants, F(between, "kinds kinds 9"), F(at_walls, "kinds walls 9"), F(kind, "n"), F(hertzian, ""), F(radius, "n"))
BONDEM_TABLE(ContactPairs, F(first, "pairs"), F(second, "pairs"), F(start, "n+1"), F(reach, "pairs"), F(whole, "pairs"), F(own, "pairs"), F(memory, "pairs 8"), F(touch, "pairs"), F(bond, "pairs"), F(joined, "*"), F(of_bond, "*"), F(period, "6"))
BONDEM_TABLE(NearPairs, F(near, "pairs+1"), F(close, "pairs+1"), F(output, "pairs 8"), F(counts, "element_portions 2"), F(width, ""), F(beyond, ""))
BONDEM_TABLE(AdheringPairs, F(force, "pairs 3"))
BONDEM_TABLE(RolledPairs, F(rolled, "pairs 3"), F(output, "pairs 4"))
BONDEM_TABLE(RolledWalls, F(rolled, "wall_contacts 3"))
BONDEM_TABLE(FacePairs, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"), F(lever_i, "3 m"), F(lever_j, "3 m"), F(pitch, "3"), F(normal, "3 m"), F(j, "m"), F(k, "m"), F(area, "m"), F(listed, "m"), F(plane, "m"), F(open, "m"), F(faced, "n"), F(outer, "n"), F(earlier_start, "n+1"), F(earlier, "pairs"), F(chosen, "pairs"), F(close, "pairs"), F(output, "pairs 12"), F(gained, "pairs"), F(gained_sum, "1 68"), F(count, "element_portions"))
BONDEM_TABLE(Travel, F(listed, "n 3"), F(measured, "n 3"), F(portion, "element_portions 3"), F(far, "2"), F(reach, ""))
BONDEM_TABLE(ContactSums, F(sums, "n 8"))
BONDEM_TABLE(WallContacts, F(start, "n+1"), F(element, "wall_contacts"), F(wall, "wall_contacts"), F(gap, "wall_contacts"), F(memory, "wall_contacts 6"), F(touch, "wall_contacts"), F(output, "wall_contacts 7"), F(sums, "* 68"))
BONDEM_TABLE(Walls, F(shape, "walls 12"), F(body, "walls 27"), F(inertia, "walls 8"), F(listed, "walls 8"))
BONDEM_TABLE(WallMotions, F(times, "wall_times"), F(values, "wall_times"), F(start, "wall_schedules+1"), F(drive_wall, "wall_drives"), F(drive_component, "wall_drives"), F(drive_schedule, "wall_drives"), F(drive_rate, "wall_drives"), F(drive_axis, "wall_drives 3"), F(servo_wall, "servos"), F(servo_schedule, "servos"), F(servo_speed, "servos"), F(servo_mass, "servos"), F(servo_damping, "servos"), F(free_wall, "free_walls"), F(free_mass, "free_walls"), F(free_force, "free_walls 3"), F(free_torque, "free_walls 3"))
BONDEM_TABLE(PairSources, F(bond_start, "n+1"), F(bond_first, "m"), F(wanted, "m"), F(rest_start, "n+1"), F(rest_first, "rest"), F(rest_gap, "rest"), F(touching_start, "n+1"), F(touching_first, "touching"), F(touching_memory, "touching 8"))
BONDEM_TABLE(FoundPairs, F(first, "room"), F(second, "room"), F(bond, "room"), F(start, "n+1"), F(gap, "room"), F(memory, "room 8"), F(touch, "room"))
BONDEM_TABLE(WallSources, F(radius, "n"), F(rest_start, "n+1"), F(rest_wall, "rest"), F(rest_gap, "rest"), F(touching_start, "n+1"), F(touching_wall, "touching"), F(touching_memory, "touching 6"), F(skin, ""), F(start, "n+1"))
BONDEM_TABLE(FoundWalls, F(element, "room"), F(wall, "room"), F(gap, "room"), F(now, "room"), F(memory, "room 6"), F(touch, "room"))
BONDEM_TABLE(SofteningSamples, F(given, "36 m"), F(kink, ""), F(steep, ""), F(wide, ""), F(left, "5 m"))
BONDEM_TABLE(CrackSamples, F(given, "60 m"), F(wide, ""), F(found, "28 m"))
BONDEM_TABLE(YieldSamples, F(stress, "6 m"), F(strength, "5 m"), F(cone, ""), F(wide, ""), F(found, "13 m"))
BONDEM_TABLE(StressBoundSamples, F(stress, "6 m"), F(bent, "m"), F(wide, ""), F(found, "4 m"))
BONDEM_TABLE(StressesOfCells, F(volume, "n"), F(tensor, "n 8"), F(carried, "n 12"), F(pressed, "* n 6"))
BONDEM_TABLE(YieldingCells, F(cone, ""), F(cohesion, "n"), F(slope, "n"), F(dilation, "n"), F(stiffness, "n"), F(fade, "n"), F(near_start, "n+1"), F(near, "*"), F(slipped, "n"), F(carry, "n"), F(plastic, "n 17"), F(base_i, "3 m"), F(base_j, "3 m"), F(base_wall, "supports 3"))
BONDEM_TABLE(FacetStrengths, F(area, "m"), F(strength, "m"), F(absorbed, "m"), F(brittleness, "m"), F(part, "m"), F(fastest, "m"), F(friction, "m"), F(plane, "m"), F(cohesion, "m"), F(slip_brittleness, "m"), F(planes, "*"), F(kink, ""), F(steep, ""), F(hot, ""))
BONDEM_TABLE(CrackOnset, F(cracked, "n"), F(judged, "n"), F(marked, "m"), F(listed, "m"), F(found, "bond_portions+1"))
BONDEM_TABLE(CohesiveCracks, F(shape, "facets 8"), F(face, "facets 8"), F(state, "facets 8"), F(frame, "facets 8"), F(past, "facets 8"), F(softening, "facets 8"), F(history, "facets 8"), F(pull, "facets 4"), F(lever, "facets 8"), F(pitch, "3"), F(order, "facets"), F(listed, "m"), F(integrity, "facets"), F(size, "2"), F(slide, ""))
BONDEM_TABLE(CellSlack, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"), F(slack_i, "m"), F(slack_j, "m"), F(weight, "n"))
BONDEM_TABLE(CrackLists, F(size, "4"), F(treated, "places"), F(resting, "places"), F(treated_i, "places"), F(treated_j, "places"), F(resting_i, "places"), F(resting_j, "places"), F(parted, "places"), F(cell, "*"), F(head, "n"), F(next, "halves"), F(flag, "places"), F(waking, "places"), F(flagged, "crack_portions"), F(woken, "crack_portions"), F(outdated, "n"), F(leader, "n"), F(base, "n"), F(half, "halves 16"), F(sum, "n 8"), F(slip, "n 4"), F(lost, "1 68"))
BONDEM_TABLE(PartedReach, F(apart, "*"))
BONDEM_TABLE(FailureBounds, F(limit, "m"), F(of_force, ""), F(of_moment, ""))
BONDEM_TABLE(Strengths, F(coefficient, "bonds 4"), F(station, "bonds"))
BONDEM_TABLE(Candidates, F(begin, "blocks+1"), F(marked, "bonds"), F(mode, "bonds"), F(count, "blocks"), F(any, "1"))
BONDEM_TABLE(Postponed, F(flag, "n"), F(element, "n"), F(row, "n"), F(first_row, ""), F(sum, "n 8"))
BONDEM_TABLE(EventLog, F(event, "bonds 10"), F(pressed, "bonds"), F(written, "2"), F(released, "1"), F(crushed, "1"))
BONDEM_TABLE(BeamIntegrity, F(integrity, "m"), F(per_length, "*"))
BONDEM_TABLE(FailureIndices, F(index, "m"))
BONDEM_TABLE(LoadedTractions, F(normal, "m 3"), F(traction, "m 3"), F(area, "m"))
BONDEM_TABLE(StressCandidates, F(bond, "candidates"), F(stress, "candidates 3 3"), F(found, "candidates"), F(number, "bond_portions"), F(total, "1"))
BONDEM_TABLE(StressFunction, F(address, ""), F(parameter, "parameters"))
BONDEM_TABLE(DeviceSpan, F(clock, "9"), F(postponed, "*"), F(halted, "1"), F(n, ""), F(m, ""))
BONDEM_TABLE(Tick, F(ahead, ""), F(goes_on, ""), F(still, ""), F(first, ""))
BONDEM_TABLE(LoadsOfBonds, F(load, "9 *"))
BONDEM_TABLE(BondMarks, F(mark, "bonds"), F(failing, "bonds"), F(mode, "bonds"))
BONDEM_TABLE(BondsOfElements, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"))
BONDEM_TABLE(EarlierPairs, F(start, "n+1"), F(pair, "pairs"))
BONDEM_TABLE(RowOrder, F(start, "*"), F(load, "*"))
BONDEM_TABLE(FallenCracks, F(fallen, "*"), F(number, "1"))
BONDEM_TABLE(FacetArms, F(arm, "7 *"))
BONDEM_TABLE(GaugeParts, F(each, ""), F(sums, "* 68"), F(largest, "* 3"))
BONDEM_TABLE(StoredLoads, F(kb, "m"), F(history, "6 m"))
BONDEM_TABLE(LoadsOfEach, F(found, "9 m"))
BONDEM_TABLE(NonLocalBonds, F(area, "m"), F(kn, "m"), F(kt, "m"), F(normal, "3 m"), F(lever_i, "3 m"), F(lever_j, "3 m"), F(nu, ""), F(limited, ""), F(history, "7 m"), F(output, "9 m"))
BONDEM_TABLE(SmallPairs, F(pairs, "m 2"), F(area, "m"), F(kt, "m"), F(nu, ""), F(limited, ""), F(normal, "m 3"), F(stress, "n 6"), F(gap, "m 3"))
BONDEM_TABLE(SmallSprings, F(kn, "m"), F(lever_i, "m 3"), F(lever_j, "m 3"), F(along, "m"), F(across, "m"))
BONDEM_TABLE(SmallSteps, F(dt, ""), F(gamma, ""), F(weight, "n 6"), F(volume, "n"), F(motion, "n 6"), F(speed, "n 6"), F(load, "n 6"), F(moment, "n 6"), F(stress, "n 6"), F(gap, "m 3"), F(size, "steps"))
BONDEM_TABLE(ExtraForces, F(force, "m 3"))
BONDEM_TABLE(Spheres, F(sphere, "n 4"), F(unit, "n"), F(velocity, "n 3"), F(force, "n 3"), F(period, "3"), F(ease, "n"))
BONDEM_TABLE(PackingWalls, F(lower, "3"), F(upper, "3"), F(weight, "3"), F(radius, ""), F(corner, "3"), F(spacing, ""), F(depth, "grid_x grid_y grid_z"))
BONDEM_TABLE(Near, F(start, "n+1"), F(neighbour, "neighbours"), F(listed, "n 3"), F(slack, ""))
BONDEM_TABLE(Relaxing, F(tolerance, ""), F(loose, ""), F(steps, ""), F(fire, "3"), F(part, "blocks 8"), F(report, "5"))
BONDEM_TABLE(Growing, F(scale, ""), F(rate, ""), F(duration, ""), F(events, ""), F(report, "3"))
BONDEM_TABLE(Flight, F(since, "n"), F(when, "n"), F(what, "n"), F(heap, "n"), F(place, "n"))
BONDEM_TABLE(SphereGrid, F(sphere, "n 4"), F(lower, "3"), F(edge, "3"), F(period, "3"), F(cells, "3"), F(skin, ""), F(cell, "n"), F(first, "cells+1"), F(member, "n"), F(place, "4 n+8"), F(start, "n+1"))
BONDEM_TABLE(NeighbourLists, F(neighbour, "neighbours"))
BONDEM_TABLE(WeakenedFacets, F(i, "m"), F(j, "m"), F(k, "m"), F(area, "m"), F(part, "m"), F(lever_i, "m 3"), F(lever_j, "m 3"), F(share_i, "m 3"), F(share_j, "m 3"), F(normal, "m 3"), F(H, "m 3 3"), F(integrity, "m"), F(closed, "m 2"), F(across, "m 3"))
BONDEM_TABLE(SmallMotions, F(displacement, "n 3"), F(rotation, "n 3"), F(gap, "m 3"), F(swelling, "n"))
BONDEM_TABLE(FacetLoading, F(stress, "n"), F(traction, "m 3"), F(bending, "m"), F(opening, "m 3"), F(opened, "m"), F(turned, "m 2"), F(moment, "n 6"))
BONDEM_TABLE(ScaledMatrix, F(start, "n+1"), F(column, "b"), F(diagonal, "n"), F(block, "b 6 6"), F(form, "b 6"), F(rounded_block, "b 6 6"), F(rounded_form, "b 6"), F(weight, "n"))
BONDEM_TABLE(ClumpCorrection, F(place, "n"), F(order, "c"), F(basis, "n 6 6"), F(factor, "c w"), F(rigid, "r x"), F(coarse, "c"))
BONDEM_TABLE(ConjugateGradients, F(limits, "2"), F(most, ""), F(residual, "x"), F(found, "x"), F(work, "4 x"), F(stress, "n"), F(rounds, "1"), F(first, "1"))
BONDEM_TABLE(DynamicRelaxation, F(pose, "n 8"), F(velocity, "n 6"), F(before, "n 6"), F(load, "n 6"), F(inverse, "n 2"), F(free, "n 6"), F(motion, "n 6"), F(memory, "2"), F(ramp, ""), F(length, ""), F(tolerance, ""), F(noise, ""))
BONDEM_TABLE(RelaxationSpan, F(first, ""), F(steps, ""), F(done, "1"), F(ratio, "1"))
BONDEM_TABLE(Moving, F(pose, "n 8"), F(motion, "n 8"), F(acceleration, "n 6"), F(loss, "n 3"), F(rest, "n 3"))
BONDEM_TABLE(Beams, F(i, "m"), F(j, "m"), F(X0, "m"), F(Y0, "m"), F(Z0, "m"), F(length, "m"), F(kn, "m"), F(A, "m"), F(B, "m"), F(C, "m"), F(kt, "m"), F(ks, "m"), F(lever, "m"), F(integrity, "m"), F(period, "6"))
BONDEM_TABLE(UniformBeams, F(per_length, "m"), F(knL, ""), F(AL, ""), F(BL, ""), F(ktL, ""))
BONDEM_TABLE(Poses, F(pose, "n 8"))
BONDEM_TABLE(BeamSums, F(row_i, "m"), F(row_j, "m"), F(sums, "sums 8"))
BONDEM_TABLE(BeamEnergies, F(energy, "4"))
BONDEM_TABLE(BeamTurns, F(found, "3"))
BONDEM_TABLE(Dashpots, F(c, "4 m"), F(share, "m"), F(sums, "* 8"))
BONDEM_TABLE(StepBlocks, F(domain, "domains+1"), F(bond, "blocks+1"), F(move, "blocks+1"), F(first_owner, "blocks"), F(ready, "ready"), F(ready_row, "ready"), F(row_i, "m"), F(row_j, "m"), F(shared, "shared"), F(shared_row, "shared"), F(shared_first_owner, ""), F(part, "shared+1"), F(parts, ""), F(sums, "sums 8"))
BONDEM_TABLE(StepScheme, F(dt, ""), F(finish, ""), F(begin, ""), F(extra, ""), F(gamma, ""), F(origin, ""))
BONDEM_TABLE(Rows, F(of, "n"), F(fixed, "rows 6"), F(force, "rows 6"), F(half, "rows 6"), F(full, "rows 6"), F(reaction, "rows 6"), F(support, "* 6"), F(work, "works"))
BONDEM_TABLE(Timeline, F(times, "times"), F(values, "times"), F(start, "schedules+1"))
BONDEM_TABLE(Drives, F(row, "drives"), F(dof, "drives"), F(schedule, "drives"), F(rate, "drives"))
BONDEM_TABLE(RowLoads, F(row, "loads"), F(schedule, "loads"), F(value, "loads 6"), F(turns, "loads"))
BONDEM_TABLE(CoupleTable, F(start, "couples+1"), F(schedule, "couples"), F(moment, "couples 3"), F(element, "points"), F(row, "points"), F(arm, "points 3"), F(share, "points"))
BONDEM_TABLE(BodyForces, F(group, "n"), F(member, "groups bodies"), F(pull, "bodies 3"), F(schedule, "bodies"), F(present, "groups 3"), F(factor, "bodies"), F(work, "n 1"))
BONDEM_TABLE(Resistance, F(gamma, ""), F(alpha, ""), F(viscous, ""), F(dashed, "* 8"), F(absorbing, "* 6"))
BONDEM_TABLE(Strain, F(schedule, "strains"), F(bond, "strained"), F(part, "strains strained"), F(still, "strained"), F(length, "strained"), F(shear, "strained"), F(lever, "strained"), F(factor, "4 strains"), F(power, "strains 68"), F(due, "2"), F(place, ""))
BONDEM_TABLE(Ledger, F(sums, "15 68"), F(turned, "3"), F(budget, "2"), F(found, "4"))
BONDEM_TABLE(Gauges, F(start, "gauges+1"), F(element, "gauged"), F(quantity, "gauges"), F(reduction, "gauges"))
BONDEM_TABLE(HistoryRows, F(record, "* columns"))
BONDEM_TABLE(StepPasses, F(present, "* 8"), F(opening, "* 8"), F(travel, "* 8"), F(forces, "* 8"), F(resume, "* 8"), F(reopening, "* 8"), F(guard, "* 8"), F(record, "* 8"))
BONDEM_TABLE(StepSpan, F(step, ""), F(steps, ""), F(every, ""), F(records_present, ""), F(stale, ""), F(moved, ""), F(n, ""), F(m, ""), F(done, "4"))
BONDEM_TABLE(LaggedStresses, F(inverse, "n"), F(stress, "n 6"), F(space, "n 8"), F(moment, "* 8"), F(to_i, "m"))
BONDEM_TABLE(BeamRows, F(i, "m"), F(j, "m"), F(direction, "3 m"), F(length, "m"), F(lever, "m"), F(kn, "m"), F(ks, "m"), F(kb, "m"), F(kt, "m"))
BONDEM_TABLE(FacetRows, F(i, "m"), F(j, "m"), F(k, "m"), F(lever_i, "m 3"), F(lever_j, "m 3"), F(H, "m 3 3"), F(share_i, "m 3"), F(share_j, "m 3"))
BONDEM_TABLE(BlockRows, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "m"), F(indptr, "n+1"), F(indices, "blocks"), F(data, "blocks 6 6"))
BONDEM_TABLE(StiffnessProduct, F(given, "n 6"), F(found, "n 6"), F(motion, "n 8"), F(sums, "n 8"))
BONDEM_TABLE(BondTangents, F(tangent, "12 12 m"))
BONDEM_TABLE(DilatationRows, F(forms, "blocks 1 6"))
BONDEM_TABLE(CandidateFacets, F(scale, "m"), F(area, "m"), F(tension, ""), F(least, ""), F(hot, ""), F(along, "m"), F(bond, "candidates"), F(stress, "candidates 3 3"), F(found, "candidates"), F(number, "bond_portions"), F(total, "1"))
BONDEM_TABLE(LoadedFacets, F(i, "m"), F(j, "m"), F(normal, "m 3"), F(traction, "m 3"), F(bending, "m"), F(tensor, "n 6"))
BONDEM_TABLE(OnsetSearch, F(whole, "whole"), F(below, ""), F(spread, ""), F(factor, "whole"))
BONDEM_TABLE(SofteningSearch, F(facet, "listed"), F(traction, "listed 3"), F(integrity, "listed"), F(across, "listed 3"), F(factor, "listed 3"), F(line, "listed 3 3"), F(direction, "listed 3 3"), F(ended, "listed"))
BONDEM_TABLE(SofteningTeeth, F(onset, ""), F(last, ""), F(kink, ""), F(steep, ""), F(ripple, ""), F(now, ""), F(left, "teeth"), F(limit, "teeth"), F(beyond, "teeth"), F(number, "1"))
BONDEM_TABLE(TriangleTree, F(lower, "boxes 3"), F(upper, "boxes 3"), F(owner, "pieces"), F(corner, "triangles 3 3"), F(side, "triangles 3 3"), F(normal, "triangles 3"))
BONDEM_TABLE(Nearest, F(points, "points 3"), F(triangle, "points"))
BONDEM_TABLE(Bins, F(position, "n 3"), F(radius, "n"), F(lower, "3"), F(upper, "3"), F(period, "3"), F(boxes, "3"), F(start, "boxes+1"), F(member, "n"), F(bound, "n"), F(first, "n"), F(reach, ""), F(tolerance, ""))
BONDEM_TABLE(Solids, F(cell, "solids"), F(face, "solids+1"), F(tag, "faces"), F(plane, "faces 4"), F(corner, "faces+1"), F(vertex, "corners 3"))
BONDEM_TABLE(PolygonBuffer, F(what, "* 4"), F(plane, "* 4"), F(vertex, "* 3"), F(used, "3"))
BONDEM_TABLE(CellRequest, F(chosen, "cells"), F(half, "cells"), F(found, "room"), F(offset, "room 4"), F(order, "room"), F(end, "cells+1"), F(done, "2"))
BONDEM_TABLE(CellRoom, F(plane, "402 4"), F(tag, "402"), F(size, "402"), F(vertex, "205824 3"), F(work, "512 3"), F(other, "512 3"))
BONDEM_TABLE(WallTree, F(corner, "triangles 3 3"), F(plane, "triangles 4"), F(lower, "boxes 3"), F(upper, "boxes 3"), F(owner, "leaves"))
BONDEM_TABLE(Splitting, F(position, "n 3"), F(tolerance, ""), F(found, "*"), F(below, "*"), F(lid, "512 3"), F(work, "512 3"), F(other, "512 3"), F(cell, "pieces"), F(end, "pieces"), F(done, "2"))
BONDEM_TABLE(Dividing, F(sphere, "n 4"), F(near, "claims"), F(start, "solids+1"), F(tolerance, ""), F(lid, "512 3"), F(work, "512 3"), F(cell, "parts"), F(owner, "parts"), F(end, "parts"), F(done, "2"))
BONDEM_TABLE(FaceGroups, F(of_face, "faces"), F(plus, "forth"), F(first, "groups+1"), F(minus, "back"), F(second, "groups+1"), F(shift, "groups 3"), F(tolerance, ""), F(work, "512 3"), F(other, "512 3"), F(done, "1"))
BONDEM_TABLE(PolygonMeasures, F(corner, "polygons+1"), F(vertex, "corners 3"), F(area, "polygons"), F(centroid, "polygons 3"), F(moment, "polygons 3 3"))
BONDEM_TABLE(Bulk, F(volume, "solids"), F(first, "solids 3"), F(second, "solids 3 3"), F(middle, "solids 3"), F(farthest, "solids"), F(beyond, "solids"))
BONDEM_TABLE(CellBranches, F(start, "n+1"), F(other, "sides"), F(branch, "sides 3"))
BONDEM_TABLE(BalanceField, F(given, "n 6"), F(found, "n 6"))
BONDEM_TABLE(WallRow, F(displacement, "3"), F(growth, ""), F(velocity, "3"), F(growth_rate, ""), F(force, "3"), F(growth_force, ""), F(work, ""), F(normal_force, ""), F(orientation, "4"), F(spin, "3"), F(torque, "3"), F(momentum, "3"))
BONDEM_TABLE(WallShape, F(point, "3"), F(axis, "3"), F(radius, ""), F(kind, ""), F(hole, ""), F(about, "3"))
BONDEM_TABLE(WallInertia, F(inverse_mass, ""), F(inverse_moment, "3"), F(principal, "4"))
BONDEM_TABLE(WallListed, F(point, "3"), F(axis, "3"), F(growth, ""), F(farthest, ""))
BONDEM_TABLE(WallLoad, F(force, "3"), F(normal, ""), F(torque, "3"))
#undef F

#define BONDEM_TABLES \
    described<SofteningBounds>(), \
    described<SofteningBeams>(), \
    described<ElasticFacets>(), \
    described<CellDilatation>(), \
    described<DilatationGradients>(), \
    described<CorrectedMass>(), \
    described<CellEnergies>(), \
    described<CellPoses>(), \
    described<FacetForces>(), \
    described<FacetsOfCells>(), \
    described<FacetRelease>(), \
    described<WallConstraints>(), \
    described<FacetTractions>(), \
    described<CellStrains>(), \
    described<WallTime>(), \
    described<TurnedVectors>(), \
    described<MomentsOfForces>(), \
    described<ContactRow>(), \
    described<ContactConstants>(), \
    described<ContactPairs>(), \
    described<NearPairs>(), \
    described<AdheringPairs>(), \
    described<RolledPairs>(), \
    described<RolledWalls>(), \
    described<FacePairs>(), \
    described<Travel>(), \
    described<ContactSums>(), \
    described<WallContacts>(), \
    described<Walls>(), \
    described<WallMotions>(), \
    described<PairSources>(), \
    described<FoundPairs>(), \
    described<WallSources>(), \
    described<FoundWalls>(), \
    described<SofteningSamples>(), \
    described<CrackSamples>(), \
    described<YieldSamples>(), \
    described<StressBoundSamples>(), \
    described<StressesOfCells>(), \
    described<YieldingCells>(), \
    described<FacetStrengths>(), \
    described<CrackOnset>(), \
    described<CohesiveCracks>(), \
    described<CellSlack>(), \
    described<CrackLists>(), \
    described<PartedReach>(), \
    described<FailureBounds>(), \
    described<Strengths>(), \
    described<Candidates>(), \
    described<Postponed>(), \
    described<EventLog>(), \
    described<BeamIntegrity>(), \
    described<FailureIndices>(), \
    described<LoadedTractions>(), \
    described<StressCandidates>(), \
    described<StressFunction>(), \
    described<DeviceSpan>(), \
    described<Tick>(), \
    described<LoadsOfBonds>(), \
    described<BondMarks>(), \
    described<BondsOfElements>(), \
    described<EarlierPairs>(), \
    described<RowOrder>(), \
    described<FallenCracks>(), \
    described<FacetArms>(), \
    described<GaugeParts>(), \
    described<StoredLoads>(), \
    described<LoadsOfEach>(), \
    described<NonLocalBonds>(), \
    described<SmallPairs>(), \
    described<SmallSprings>(), \
    described<SmallSteps>(), \
    described<ExtraForces>(), \
    described<Spheres>(), \
    described<PackingWalls>(), \
    described<Near>(), \
    described<Relaxing>(), \
    described<Growing>(), \
    described<Flight>(), \
    described<SphereGrid>(), \
    described<NeighbourLists>(), \
    described<WeakenedFacets>(), \
    described<SmallMotions>(), \
    described<FacetLoading>(), \
    described<ScaledMatrix>(), \
    described<ClumpCorrection>(), \
    described<ConjugateGradients>(), \
    described<DynamicRelaxation>(), \
    described<RelaxationSpan>(), \
    described<Moving>(), \
    described<Beams>(), \
    described<UniformBeams>(), \
    described<Poses>(), \
    described<BeamSums>(), \
    described<BeamEnergies>(), \
    described<BeamTurns>(), \
    described<Dashpots>(), \
    described<StepBlocks>(), \
    described<StepScheme>(), \
    described<Rows>(), \
    described<Timeline>(), \
    described<Drives>(), \
    described<RowLoads>(), \
    described<CoupleTable>(), \
    described<BodyForces>(), \
    described<Resistance>(), \
    described<Strain>(), \
    described<Ledger>(), \
    described<Gauges>(), \
    described<HistoryRows>(), \
    described<StepPasses>(), \
    described<StepSpan>(), \
    described<LaggedStresses>(), \
    described<BeamRows>(), \
    described<FacetRows>(), \
    described<BlockRows>(), \
    described<StiffnessProduct>(), \
    described<BondTangents>(), \
    described<DilatationRows>(), \
    described<CandidateFacets>(), \
    described<LoadedFacets>(), \
    described<OnsetSearch>(), \
    described<SofteningSearch>(), \
    described<SofteningTeeth>(), \
    described<TriangleTree>(), \
    described<Nearest>(), \
    described<Bins>(), \
    described<Solids>(), \
    described<PolygonBuffer>(), \
    described<CellRequest>(), \
    described<CellRoom>(), \
    described<WallTree>(), \
    described<Splitting>(), \
    described<Dividing>(), \
    described<FaceGroups>(), \
    described<PolygonMeasures>(), \
    described<Bulk>(), \
    described<CellBranches>(), \
    described<BalanceField>(), \
    described<WallRow>(), \
    described<WallShape>(), \
    described<WallInertia>(), \
    described<WallListed>(), \
    described<WallLoad>()

}  // namespace bondem
