// Elements with failing bonds: their motion is postponed until the failed bonds are removed (`pipeline.hpp`). These
// passes list the elements, and keep the sums of their forces.
#include "../../registered.hpp"
#include "../motion/elements.hpp"
#include "../../tables/columns.hpp"
#include "pipeline.hpp"

namespace bondem {
namespace {

// A list of elements that is being written: those without a row of the boundary, then those with a row.
struct Filling {
    Index first, first_owner, last;

    ElementList list(const Postponed &postponed) const {
        return {first, last, first_owner, postponed.element.data, postponed.row.data};
    }
};

void put(const Postponed &postponed, Index place, Short element, Short row) {
    postponed.element(place) = element;
    postponed.row(place) = row;
}

}  // namespace

// Divides the elements of a block, or shared ones, into those that continue and those that are postponed.
void postpone_elements(const Range &range, const StepBlocks &blocks, const Candidates &candidates,
                       const Postponed &postponed) {
    if (!any_fails(candidates)) return;
    Index free = 0, own = 0;  // postponed elements that own no row, and that own one
    for (Index e = range.first; e < range.last; e++)
        if (is_postponed(postponed, range.element[e])) (e < range.first_owner ? free : own)++;
    if (free + own == 0) return;
    // shared elements have their places behind those of the blocks
    const Index first = range.first + (range.block < blocks.first_owner.size() ? 0 : blocks.ready.size());
    const Index middle = first + (range.last - range.first) - free - own;
    const Filling going = {first, middle - (range.last - range.first_owner - own), middle};
    const Filling late = {middle, middle + free, middle + free + own};
    Index next[4] = {going.first, late.first, going.first_owner, late.first_owner};
    for (Index e = range.first; e < range.last; e++) {
        const Index list = (e < range.first_owner ? 0 : 2) + (is_postponed(postponed, range.element[e]) ? 1 : 0);
        put(postponed, next[list]++, range.element[e], range.row[e]);
    }
    *range.division = {going.list(postponed), late.list(postponed)};
}
BONDEM_PASS(postpone_elements, divides_elements, "")

// Copies the sums of postponed elements, which are kept until failed bonds are removed.
void keep_sums(const Range &range, const StepBlocks &blocks, const Postponed &postponed) {
    for (Index e = range.first; e < range.last; e++)
        row_at(postponed.sum.data, range.element[e]) = row_at(blocks.sums.data, range.row[e]);
}
BONDEM_PASS(keep_sums, postponed_of_blocks, "own flag sums; changes sum")

// Keeps the sums of the dashpots of postponed elements.
void keep_dashpots(const Range &range, const Dashpots &dashpots, const Postponed &postponed) {
    for (Index e = range.first; e < range.last; e++)
        row_at(dashpots.sums.data, Short(postponed.first_row + range.element[e])) = row_at(dashpots.sums.data, range.row[e]);
}
BONDEM_PASS(keep_dashpots, postponed_of_blocks, "own flag; changes sums")

// Lists all postponed elements, those with rows of the boundary last, and ends the failures of the step.
void list_postponed(const Range &range, const Rows &rows, const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates)) return;
    Index count = 0, free = 0;
    for (Index own = 0; own < 2; own++) {
        for (Index p = 0; p < postponed.flag.size(); p++)
            if (postponed.flag(p) != 0 && (rows.of(p) >= 0) == (own == 1)) {
                postponed.flag(p) = 0;
                put(postponed, count++, Short(p), Short(postponed.first_row + p));
            }
        if (own == 0) free = count;
    }
    range.division->postponed = {0, count, free, postponed.element.data, postponed.row.data};
    end_failures(candidates);
}
BONDEM_PASS(list_postponed, divides_elements, "writes flag")

// Writes the energy released into a record.
void write_released(const Range &range, const EventLog &log, const HistoryRows &history) {
    history.record(range.clock.record, history_column::released) = log.released(0);
}
BONDEM_PASS(write_released, single, "")

}  // namespace bondem
