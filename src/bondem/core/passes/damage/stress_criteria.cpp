// Passes that evaluate a criterion of the core, or a function of the user, for many stresses (`stress_criteria.hpp`).
#include "stress_criteria.hpp"

#include "../../laws/criteria/cone.hpp"
#include "../../laws/criteria/mean_stress.hpp"
#include "../../registered.hpp"

namespace bondem {
namespace {

using UserFunction = void (*)(Index count, const double *stress, const double *parameter, double *index);

// Evaluates a criterion of the core for many stresses.
template <class Criterion> void evaluate(const StressCandidates &candidates, const StressFunction &by, Index count) {
    require(by.parameter.size() == Criterion::parameters);
    for (Index c = 0; c < count; c++)
        candidates.found(c) = Criterion::index(stress_in(candidates, c), by.parameter.data);
}
// Stands for a criterion by the function of a user.
struct OfUser {};
template <> void evaluate<OfUser>(const StressCandidates &candidates, const StressFunction &by, Index count) {
    if (count == 0) return;
    reinterpret_cast<UserFunction>(by.address)(count, candidates.stress.data, by.parameter.data, candidates.found.data);
}

// Moves the candidates of all portions together, in the order of the bonds; returns how many there are.
Index move_together(const StressCandidates &candidates) {
    Index total = 0;
    for (Index q = 0; q < candidates.number.size(); q++)
        for (Index e = q * bonds_of_portion; e < q * bonds_of_portion + candidates.number(q); e++, total++) {
            candidates.bond(total) = candidates.bond(e);
            for (Index c = 0; c < 9; c++) candidates.stress.data[9 * total + c] = candidates.stress.data[9 * e + c];
        }
    return candidates.total(0) = total;
}

// Finds the index of each candidate by a criterion on its stress.
template <class Criterion>
void index_candidates(const Range &, const StressCandidates &candidates, const StressFunction &by) {
    evaluate<Criterion>(candidates, by, move_together(candidates));
}
// Finds the index of each given stress; the counts of portions are not read.
template <class Criterion> Index index_stresses(Index, const StressCandidates &candidates, const StressFunction &by) {
    evaluate<Criterion>(candidates, by, candidates.bond.size());
    return 0;
}

}  // namespace

#define BONDEM_CRITERION(name, Criterion)                                                  \
    BONDEM_PASS_AS(index_candidates_by_##name, of_rows, "", index_candidates<Criterion>)       \
    BONDEM_CALL_AS(index_stresses_by_##name, "", index_stresses<Criterion>)
BONDEM_CRITERION(mean_stress, MeanStress)
BONDEM_CRITERION(cone, Cone)
BONDEM_CRITERION(function, OfUser)
#undef BONDEM_CRITERION

}  // namespace bondem
