// Function that returns the highest level of instructions of this CPU (`instructions.hpp`). This file is part of
// every library, and is also compiled by itself to a small library that any CPU can load.
#include "exported.hpp"
#include "instructions.hpp"

// The highest level of instructions that this CPU and its system offer: 2, 3 or 4 of x86-64, else 0.
BONDEM_EXPORT bondem::Index bondem_level() { return bondem::instruction_level(); }
