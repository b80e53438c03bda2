// Program of a GPU, compiled by NVRTC. The program has a kernel for each pass that computes one index, such as one
// bond, or only for the pass that BONDEM_ONLY names. Sources of passes of the CPU that kernels call are included.
#include "../passes/beams/beam_report.cpp"
#include "../passes/boundary/couples.cpp"
#include "../passes/cells/cell_report.cpp"
#include "../passes/cells/cell_strains.cpp"
#include "../passes/cells/cell_stress.cpp"
#include "../passes/cells/corrected_mass.cpp"
#include "../passes/cells/dilatation_gradients.cpp"
#include "../passes/cells/facet_failure.cpp"
#include "../passes/contacts/adhesion.cpp"
#include "../passes/contacts/contact_loads.cpp"
#include "../passes/contacts/face_contacts.cpp"
#include "../passes/contacts/handover.cpp"
#include "../passes/contacts/rigid_walls.cpp"
#include "../passes/contacts/rolling.cpp"
#include "../passes/cracks/crack_loads.cpp"
#include "../passes/cracks/opening.cpp"
#include "../passes/cracks/stress_state.cpp"
#include "../passes/damage/beam_softening.cpp"
#include "../passes/incremental/stored_beams.cpp"
#include "../passes/motion/body_forces.cpp"
#include "../passes/non_local/non_local_bonds.cpp"
#include "../passes/non_local/touch_moments.cpp"
#include "../passes/record/record.cpp"
#include "for_each.hpp"
#include "index_passes.hpp"

using bondem::Index;

#define BONDEM_KERNEL(pass)                                                                                              \
    extern "C" __global__ void pass(Index count, const Index *halted, const void *a, const void *b, const void *c,       \
                                    const void *d, const void *e, const void *f, const void *g, const void *h) {         \
        const Index k = Index(blockIdx.x) * blockDim.x + threadIdx.x;                                                    \
        const void *const tables[bondem::tables_of_index_pass] = {a, b, c, d, e, f, g, h};                               \
        if (k < count && !(halted && *halted)) bondem::ForEach<bondem::function_of(bondem::pass)>::at(k, tables);                             \
    }
#if defined(BONDEM_ONLY)
BONDEM_KERNEL(BONDEM_ONLY)
#else
BONDEM_INDEX_PASSES(BONDEM_KERNEL)
#endif
