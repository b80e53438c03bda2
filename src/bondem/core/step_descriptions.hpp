// How the tables of a step, and the passes that a step is composed of, describe themselves to Python.
#pragma once
#include "contact_descriptions.hpp"
#include "described.hpp"
#include "passes/beams/beam_loads.hpp"
#include "passes/beams/beam_report.hpp"
#include "damage_descriptions.hpp"
#include "passes/boundary/rows.hpp"
#include "passes/motion/body_forces.hpp"
#include "passes/motion/move.hpp"
#include "passes/motion/sums.hpp"
#include "passes/record/record.hpp"
#include "steps.hpp"

namespace bondem {

struct StepPassDescription {
    const char *name;
    Index kind;
    void *address;  // of a function of a turn and of pointers to its tables
    const char *const *tables;
    Index count;
};

template <class... Tables>
StepPassDescription described(const char *name, PassKind kind, PassFunction call, void (*)(const Turn &, const Tables &...)) {
    return {name, kind, reinterpret_cast<void *>(call), TableNames<Tables...>::names, Index(sizeof...(Tables))};
}

#define F BONDEM_FIELD

BONDEM_TABLE(Moving, F(pose, "n 8"), F(motion, "n 8"), F(acceleration, "n 6"), F(loss, "n 3"), F(rest, "n 3"))
BONDEM_TABLE(Beams, F(i, "m"), F(j, "m"), F(X0, "m"), F(Y0, "m"), F(Z0, "m"), F(length, "m"), F(kn, "m"), F(A, "m"),
             F(B, "m"), F(C, "m"), F(kt, "m"), F(ks, "m"), F(lever, "m"), F(integrity, "m"), F(period, "6"))
BONDEM_TABLE(AlikeBeams, F(hold, "m"), F(knL, ""), F(AL, ""), F(BL, ""), F(ktL, ""))
BONDEM_TABLE(Poses, F(pose, "n 8"))
BONDEM_TABLE(BeamSums, F(row_i, "m"), F(row_j, "m"), F(sums, "sums 8"))
BONDEM_TABLE(BeamEnergies, F(energy, "4"))
BONDEM_TABLE(BeamTurns, F(found, "3"))
BONDEM_TABLE(Dashpots, F(c, "4 m"), F(share, "m"), F(sums, "* 8"))
BONDEM_TABLE(StepCut, F(domain, "domains+1"), F(bond, "blocks+1"), F(move, "blocks+1"), F(held, "blocks"),
             F(ready, "ready"), F(ready_row, "ready"), F(row_i, "m"), F(row_j, "m"), F(shared, "shared"),
             F(shared_row, "shared"), F(shared_held, ""), F(part, "shared+1"), F(parts, ""), F(sums, "sums 8"))
BONDEM_TABLE(StepScheme, F(dt, ""), F(finish, ""), F(begin, ""), F(extra, ""), F(gamma, ""), F(origin, ""))
BONDEM_TABLE(Rows, F(of, "n"), F(fixed, "rows 6"), F(force, "rows 6"), F(half, "rows 6"), F(full, "rows 6"),
             F(reaction, "rows 6"), F(grip, "* 6"), F(work, "works"))
BONDEM_TABLE(Timeline, F(times, "times"), F(values, "times"), F(start, "schedules+1"))
BONDEM_TABLE(Drives, F(row, "drives"), F(dof, "drives"), F(schedule, "drives"), F(rate, "drives"))
BONDEM_TABLE(RowLoads, F(row, "loads"), F(schedule, "loads"), F(value, "loads 6"), F(turns, "loads"))
BONDEM_TABLE(CoupleTable, F(start, "couples+1"), F(schedule, "couples"), F(moment, "couples 3"), F(element, "points"),
             F(row, "points"), F(arm, "points 3"), F(share, "points"))
BONDEM_TABLE(BodyForces, F(group, "n"), F(member, "groups bodies"), F(pull, "bodies 3"), F(schedule, "bodies"),
             F(present, "groups 3"), F(factor, "bodies"), F(work, "n 1"))
BONDEM_TABLE(Resistance, F(gamma, ""), F(alpha, ""), F(viscous, ""), F(dashed, "* 8"), F(absorbing, "* 6"))
BONDEM_TABLE(Strain, F(schedule, "strains"), F(bond, "strained"), F(part, "strains strained"), F(still, "strained"),
             F(length, "strained"), F(shear, "strained"), F(lever, "strained"), F(factor, "4 strains"), F(place, ""))
BONDEM_TABLE(Portions, F(elements, "element_portions 4"), F(bonds, "bond_portions 4"), F(turned, "bond_portions 3"),
             F(budget, "3"), F(found, "4"))
BONDEM_TABLE(Gauges, F(start, "gauges+1"), F(element, "gauged"), F(quantity, "gauges"), F(reduction, "gauges"))
BONDEM_TABLE(HistoryRows, F(record, "* columns"))
BONDEM_TABLE(StepPasses, F(present, "* 8"), F(opening, "* 8"), F(travel, "* 8"), F(forces, "* 8"), F(resume, "* 8"),
             F(reopening, "* 8"), F(guard, "* 8"), F(record, "* 8"))
BONDEM_TABLE(StepSpan, F(step, ""), F(steps, ""), F(every, ""), F(looks, ""), F(stale, ""), F(moved, ""), F(n, ""),
             F(m, ""), F(done, "4"))

#undef F

}  // namespace bondem
