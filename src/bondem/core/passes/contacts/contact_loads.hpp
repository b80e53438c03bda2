#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// Finds forces and memory of the pairs of a portion of elements; lists those that may touch where elements have moved
// too far since that was done.
void press_pairs(const Turn &turn, const Moving &all, const ContactConstants &law, const ContactPairs &pairs,
                 const NearPairs &near, const Travel &travel);
// Finds forces and memory of the pairs of a portion of cells with cracks, which touch by faces too.
void press_pairs_and_faces(const Turn &turn, const Moving &all, const ContactConstants &law, const ContactPairs &pairs,
                           const NearPairs &near, const Travel &travel, const FacePairs &faces);
// Adds what pairs do to the elements of a range, in the order of the pairs.
void add_pair_loads(const Turn &turn, const ContactConstants &c, const ContactPairs &pairs,
                    const NearPairs &near, const ContactSums &to);
// Adds forces of contacts to the sums of elements, and losses to theirs, and leaves them at zero.
void add_contact_loads(const Turn &turn, const Moving &all, const StepCut &cut, const ContactSums &contacts);
// Sums the elastic energy of the pairs of a portion [J].
void sum_pair_energies(const Turn &turn, const Moving &all, const ContactConstants &law, const ContactPairs &pairs,
                       const ContactEnergies &energies);
// Adds the energy of contacts to a record.
void write_contact_energy(const Turn &turn, const ContactEnergies &energies, const HistoryRows &history);

}  // namespace bondem
