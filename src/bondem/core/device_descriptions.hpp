// How the tables and the passes of a device describe themselves to Python.
#pragma once
#include "cell_descriptions.hpp"
#include "contact_descriptions.hpp"
#include "crack_descriptions.hpp"
#include "damage_descriptions.hpp"
#include "gpu/for_each.hpp"
#include "gpu/index_passes.hpp"
#include "step_descriptions.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(DeviceSpan, F(clock, "9"), F(postponed, "*"), F(halted, "1"), F(n, ""), F(m, ""))
BONDEM_TABLE(Tick, F(ahead, ""), F(goes_on, ""), F(still, ""), F(first, ""))
BONDEM_TABLE(LoadsOfBonds, F(load, "9 *"))
BONDEM_TABLE(BondMarks, F(mark, "bonds"), F(failing, "bonds"), F(mode, "bonds"))
BONDEM_TABLE(SofteningLosses, F(lost, "bonds"))
BONDEM_TABLE(BondsOfElements, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"))
BONDEM_TABLE(EarlierPairs, F(start, "n+1"), F(pair, "pairs"))
BONDEM_TABLE(RowOrder, F(start, "*"), F(load, "*"))
BONDEM_TABLE(WorkPortions, F(works, "work_portions 2"))
BONDEM_TABLE(StrainPortions, F(due, "2"), F(power, "* *"))
BONDEM_TABLE(WallEnergy, F(energy, "wall_portions"))
BONDEM_TABLE(LossesOfCracks, F(lost, "*"), F(portion, "loss_portions"), F(group, "loss_groups"), F(fallen, "*"), F(number, "1"))
BONDEM_TABLE(BegunFaces, F(gained, "element_portions"))
BONDEM_TABLE(FacetArms, F(arm, "7 *"))
BONDEM_TABLE(CrackPortions, F(energy, "* 3"))
BONDEM_TABLE(CrushingPortions, F(energy, "*"))
BONDEM_TABLE(FoldedPortions, F(sums, "folds 13"))
BONDEM_TABLE(GaugeParts, F(each, ""), F(parts, "* 3"))

#undef F

#define BONDEM_DEVICE_TABLES                                                                                          \
    described<DeviceSpan>(), described<Tick>(), described<BondMarks>(), described<SofteningLosses>(), \
        described<LoadsOfBonds>(), described<BondsOfElements>(), described<EarlierPairs>(), \
        described<RowOrder>(), described<WorkPortions>(), described<StrainPortions>(), \
        described<WallEnergy>(), described<FoldedPortions>(), described<GaugeParts>(), \
        described<LossesOfCracks>(), described<BegunFaces>(), described<FacetArms>(), described<CrackPortions>(), \
        described<CrushingPortions>()

// Name and tables of a pass over an index. Its loop on the CPU is in `loops.cpp`.
template <auto pass> struct IndexPass;
template <class... Tables, void (*pass)(Index, const Tables &...)> struct IndexPass<pass> {
    static PassDescription described(const char *name) {
        static_assert(sizeof...(Tables) <= tables_of_index_pass);
        return {name, "", nullptr, TableNames<Tables...>::names, Index(sizeof...(Tables))};
    }
};

}  // namespace bondem
