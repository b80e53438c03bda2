// The operator N of balanced shares (`bondem/specimen/tessellation/balanced_shares.py`), with a symmetric tensor Y of
// each cell: N Y = Σ sym((Y_p - Y_q) b ⊗ b) over the facets of cell p, with the symmetric part sym. q is the cell
// behind the facet, and b the vector between both centres times a weight. One thread adds up the facets of a cell.
#include "../../registered.hpp"
#include "../../symmetric3.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "../../threads.hpp"

namespace bondem {
namespace {

constexpr Index cells_of_a_task = 256;
// Off-diagonal components are stored √2 times as large, which makes the inner product of rows that of tensors.
constexpr double root_half = 0.70710678118654752440;

Symmetric3<double> tensor(const double *row) {
    return {row[0], row[1], row[2], root_half * row[3], root_half * row[4], root_half * row[5]};
}

}  // namespace

// Applies the operator N of the balanced shares to the tensors of all cells.
Index apply_balance(Index threads, const CellBranches &branches, const BalanceField &field) {
    for_each_in_tasks(threads, field.given.size(), cells_of_a_task, [&](Index p) {
        const Symmetric3<double> own = tensor(&field.given(p, 0));
        Symmetric3<double> sum = {};
        for (Index e = branches.start(p); e < branches.start(p + 1); e++) {
            const Vector b = branches.branch.row<const Vector>(e);
            const Symmetric3<double> difference = own + -1.0 * tensor(&field.given(Index(branches.other(e)), 0));
            sum = sum + symmetric_product(difference * b, b);
        }
        for (Index c = 0; c < 6; c++) field.found(p, c) = c < 3 ? sum[c] : sum[c] / root_half;
    });
    return 0;
}
BONDEM_CALL(apply_balance, "")

}  // namespace bondem
