#pragma once
#include "../../tables/quasistatic_tables.hpp"

namespace bondem {

// Solves Sᵀ K S x = f by conjugate gradients from a guess, preconditioned by the clumps; 0 where they end, 1 where they do not.
Index conjugate_gradients(Index threads, const ScaledMatrix &matrix, const ClumpCorrection &clumps,
                          const ConjugateGradients &search);

}  // namespace bondem
