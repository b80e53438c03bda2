// Loops on the CPU that call a pass of a GPU for all indices, where one thread of a GPU computes one index. With
// these loops the CPU simulates a GPU in tests. The libraries of wheels do not contain these loops.
#include "exported.hpp"
#include "gpu/for_each.hpp"
#include "gpu/index_passes.hpp"

namespace bondem {
namespace {

#define X(pass) &ForEach<function_of(pass)>::on_host,
using Loop = Index(Index, const Index *, const void *const *);
Loop *const loops[] = {BONDEM_INDEX_PASSES(X)};
#undef X

}  // namespace
}  // namespace bondem

// Loops in the order in which `bondem_index_passes` describes the passes.
BONDEM_EXPORT const void *bondem_index_loops() { return bondem::loops; }
