// Softening beams in a step: events, new rows and energies, on the CPU and on a device.
#pragma once
#include "../../tables/beam_softening_tables.hpp"
#include "../../steps.hpp"

namespace bondem {

// Adds up the dissipation of all portions, and logs broken beams.
void log_softened_beams(const Range &range, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                        const EventLog &log);
// Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.
void begin_softening(const Range &range, const Candidates &candidates, const SofteningBounds &bounds, const SofteningBeams &soft,
                     const EventLog &log);
// Writes the energy that beams have released beyond their fracture energy in this run [J].
void write_crushing_of_beams(const Range &range, const SofteningBounds &bounds, const SofteningBeams &soft, const EventLog &log,
                             const HistoryRows &history);
// Adds the energy of the pressure on softened beams of a portion to their normal energy.
void sum_pressed_energies(const Range &range, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                          const Ledger &ledger);

}  // namespace bondem
