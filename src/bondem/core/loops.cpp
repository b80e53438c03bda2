// Loops that call each pass over an index for all indices on the CPU, which thereby simulates a device for tests.
// Libraries of source trees contain these loops, those of wheels do not.
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
