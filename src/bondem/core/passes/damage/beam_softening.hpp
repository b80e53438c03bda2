#pragma once
#include "../../laws/criteria/bond_criteria.hpp"
#include "../../tables/beam_softening_tables.hpp"
#include "../../steps.hpp"

namespace bondem {

// Beams of a portion lose integrity; before the forces.
void soften_beams(const Turn &turn, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                  const SofteningBounds &bounds, const SofteningBeams &soft);
// Adds up what all portions have dissipated, and logs beams that have broken.
void log_softened_beams(const Turn &turn, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                        const EventLog &log);
// Finds which of the marked beams of a block begin to soften, and keeps their energies.
#define BONDEM_DECLARED(_, name, Criterion)                                                                             \
    void find_softening_by_##name(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,  \
                                  const Candidates &candidates, const SofteningBeams &soft);
BONDEM_SOFTENING_CRITERIA(BONDEM_DECLARED, )
#undef BONDEM_DECLARED
// Writes the rows of beams that begin to soften.
void begin_softening(const Turn &turn, const Candidates &candidates, const SofteningBounds &bounds, const SofteningBeams &soft);
// Adds the energy of the pressure on softened beams of a portion to their normal energy.
void sum_pressed_energies(const Turn &turn, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                          const Portions &portions);

}  // namespace bondem
