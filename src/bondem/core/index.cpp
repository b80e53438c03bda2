// Functions by which Python reads what the library contains: tables, passes, and the level of CPU instructions.
#include "described_tables.hpp"
#include "exported.hpp"
#include "gpu/for_each.hpp"
#include "gpu/index_passes.hpp"
#include "instructions.hpp"
#include "lanes.hpp"
#include "registered.hpp"

namespace bondem {

namespace {

const TableDescription tables[] = {BONDEM_TABLES};

// Name and tables of a pass over an index. Its loop on the CPU is in `loops.cpp`.
template <class... Tables> PassDescription of_index(const char *name, void (*)(Index, const Tables &...)) {
    static_assert(sizeof...(Tables) <= tables_of_index_pass);
    return {name, "", 0, nullptr, TableNames<Tables...>::names, Index(sizeof...(Tables)), nullptr};
}

#define X(pass) of_index(#pass, function_of(pass)),
const PassDescription index_passes[] = {BONDEM_INDEX_PASSES(X)};
#undef X

}  // namespace
}  // namespace bondem

BONDEM_EXPORT const bondem::TableDescription *bondem_tables(bondem::Index *count) {
    *count = sizeof(bondem::tables) / sizeof(bondem::tables[0]);
    return bondem::tables;
}
// The last pass that registered itself; each pass refers to the pass registered before it.
BONDEM_EXPORT const bondem::PassDescription *bondem_passes() { return bondem::Registered::first(); }
BONDEM_EXPORT const bondem::PassDescription *bondem_index_passes(bondem::Index *count) {
    *count = sizeof(bondem::index_passes) / sizeof(bondem::index_passes[0]);
    return bondem::index_passes;
}
// Number of lanes, which is the number of bonds in a group; tables of fewer bonds are padded to a group.
BONDEM_EXPORT bondem::Index bondem_lanes() { return bondem::lanes; }
// The instruction level that this library was compiled for: 2, 3 or 4 of x86-64, else 0.
BONDEM_EXPORT bondem::Index bondem_compiled_level() { return bondem::compiled_level; }
