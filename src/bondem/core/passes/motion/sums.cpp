// Sums of loads and of forces of dashpots on elements with bonds in several domains. A domain is the part of a body
// that one thread computes.
#include "../../registered.hpp"
#include "elements.hpp"

namespace bondem {
namespace {

void collect(const Range &range, const StepBlocks &blocks, double *sums) {
    for (Index e = range.first; e < range.last; e++)
        for (Index q = blocks.parts + blocks.part(e); q < blocks.parts + blocks.part(e + 1); q++)
            for (Index c = 0; c < 8; c++) {
                sums[8 * range.row[e] + c] += sums[8 * q + c];
                sums[8 * q + c] = 0.0;
            }
}

}  // namespace

// Adds loads of bonds of other domains to the sums of shared elements, and sets their rows to zero.
void collect_sums(const Range &range, const StepBlocks &blocks) { collect(range, blocks, blocks.sums.data); }
BONDEM_PASS(collect_sums, parts_of_shared, "changes sums")

// Adds loads of dashpots of other domains to the sums of shared elements, and sets their rows to zero.
void collect_dashpots(const Range &range, const StepBlocks &blocks, const Dashpots &dashpots) {
    collect(range, blocks, dashpots.sums.data);
}
BONDEM_PASS(collect_dashpots, parts_of_shared, "changes Dashpots.sums")

// Adds the forces of dashpots to those of springs; the former are kept, because their power is found later.
void add_dashpots(const Range &range, const StepBlocks &blocks, const Dashpots &dashpots) {
    for (Index e = range.first; e < range.last; e++)
        for (Index c = 0; c < 8; c++) blocks.sums(range.row[e], c) += dashpots.sums(range.row[e], c);
}
BONDEM_PASS(add_dashpots, elements_of_blocks, "own Dashpots.sums; changes StepBlocks.sums")

}  // namespace bondem
