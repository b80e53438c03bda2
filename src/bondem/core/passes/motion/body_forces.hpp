// Declarations of passes that add body forces and their work, on the CPU or a GPU.
#pragma once
#include "../../steps.hpp"

namespace bondem {

// Adds body forces to the sums, and their work over the half of the step that ends.
void add_body_forces(const Range &range, const Moving &all, const StepBlocks &blocks, const BodyForces &body);
// Adds the work of body forces over the half of the step that begins, by its velocities; none at a pause.
void add_body_work(const Range &range, const Moving &all, const BodyForces &body);
// Adds the work of body forces over the half of the step that begins after a pause.
void open_body_work(const Range &range, const Moving &all, const BodyForces &body);

}  // namespace bondem
