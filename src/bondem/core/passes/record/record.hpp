#pragma once
#include "../../steps.hpp"

namespace bondem {

// Sums kinetic energies and losses of a portion [J].
void sum_element_energies(const Turn &turn, const Moving &all, const Portions &portions);

}  // namespace bondem
