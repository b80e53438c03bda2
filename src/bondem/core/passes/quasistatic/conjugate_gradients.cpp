// Conjugate gradients for successive equilibria, with the diagonal of Sᵀ K S equal to one and a coarse correction.
//
// The memory that a round reads decides its time. The residual of the guess is exact; corrections, which are much
// smaller than the solution, are found with a matrix in single precision.
#include "conjugate_gradients.hpp"

namespace bondem {
namespace {

// Sums run in this many parts, which are independent of each other.
constexpr Index parts = 8;
// Reduction of r · z by the rounded matrix, beyond which the exact residual is computed again.
constexpr double rounded = 1e6;

double dot(const double *a, const double *b, Index n) {
    double sums[parts] = {};
    Index k = 0;
    for (; k + parts <= n; k += parts)
        for (Index l = 0; l < parts; l++) sums[l] += a[k + l] * b[k + l];
    double sum = 0.0;
    for (; k < n; k++) sum += a[k] * b[k];
    for (Index l = 0; l < parts; l++) sum += sums[l];
    return sum;
}

// Six numbers of a cell, in registers.
struct Six {
    double part[6];
};
Six six(const double *x) { return {{x[0], x[1], x[2], x[3], x[4], x[5]}}; }
void add(Six s, double *y) {
    for (Index a = 0; a < 6; a++) y[a] += s.part[a];
}
// `sum` += A x, and returns Aᵀ s, of a block.
template <class T> Six both_products(const T *A, Six x, Six s, Six &sum) {
    Six turned = {};
    for (Index a = 0; a < 6; a++)
        for (Index b = 0; b < 6; b++) {
            const double entry = A[6 * a + b];
            sum.part[a] += entry * x.part[b];
            turned.part[b] += entry * s.part[a];
        }
    return turned;
}
template <class T> double dot(const T *form, Six x) {
    return (form[0] * x.part[0] + form[1] * x.part[1] + form[2] * x.part[2]) +
           (form[3] * x.part[3] + form[4] * x.part[4] + form[5] * x.part[5]);
}

template <class T>
void multiply(const ScaledMatrix &matrix, const Array<const T, 3> &block, const Array<const T, 2> &form, const double *x,
              double *y, const Array<double, 1> &stress) {
    const Index n = matrix.weight.size();
    for (Index k = 0; k < 6 * n; k++) y[k] = 0.0;
    for (Index p = 0; p < n; p++) {
        const Index middle = matrix.diagonal(p), end = matrix.start(p + 1);
        const Six own = six(x + 6 * p);
        Six mine = {};
        double swelling = 0.0;
        both_products(&block(middle, 0, 0), own, Six{}, mine);
        for (Index e = matrix.start(p); e < middle; e++) swelling += dot(&form(e, 0), six(x + 6 * matrix.column(e)));
        swelling += dot(&form(middle, 0), own);
        for (Index e = middle + 1; e < end; e++) {
            const Index q = 6 * matrix.column(e);
            const Six there = six(x + q);
            add(both_products(&block(e, 0, 0), there, own, mine), y + q);
            swelling += dot(&form(e, 0), there);
        }
        add(mine, y + 6 * p);
        stress(p) = matrix.weight(p) * swelling;
    }
    for (Index p = 0; p < n; p++)
        for (Index e = matrix.start(p); e < matrix.start(p + 1); e++) {
            const T *own = &form(e, 0);
            double *there = y + 6 * matrix.column(e);
            for (Index b = 0; b < 6; b++) there[b] += own[b] * stress(p);
        }
}

// v becomes (L Lᵀ)⁻¹ v.
void solve_coarse(const Array<const double, 2> &factor, double *v) {
    const Index c = factor.shape[0], w = factor.shape[1];
    for (Index j = 0; j < c; j++) {
        const double *column = &factor(j, 0);
        const double value = v[j] /= column[0];
        const Index rows = w < c - j ? w : c - j;
        for (Index k = 1; k < rows; k++) v[j + k] -= column[k] * value;
    }
    for (Index j = c - 1; j >= 0; j--) {
        const double *column = &factor(j, 0);
        const Index rows = w < c - j ? w : c - j;
        v[j] = (v[j] - dot(column + 1, v + j + 1, rows - 1)) / column[0];
    }
}

// Takes rigid motions out of z, and forces that drive them out of those of a rounded matrix.
void remove_rigid(const ClumpCorrection &clumps, double *v) {
    const Index size = clumps.rigid.shape[1];
    for (Index m = 0; m < clumps.rigid.shape[0]; m++) {
        const double *rigid = clumps.rigid.data + m * size;
        const double along = dot(rigid, v, size);
        for (Index k = 0; k < size; k++) v[k] -= along * rigid[k];
    }
}

void precondition(const ClumpCorrection &clumps, const double *r, double *z) {
    const Index n = clumps.place.size(), c = clumps.coarse.size();
    double *coarse = clumps.coarse.data;
    for (Index k = 0; k < c; k++) coarse[k] = 0.0;
    for (Index p = 0; p < n; p++)
        for (Index a = 0; a < 6; a++)
            for (Index b = 0; b < 6; b++)
                coarse[clumps.order(clumps.place(p) + b)] += clumps.basis(p, a, b) * r[6 * p + a];
    solve_coarse(clumps.factor, coarse);
    for (Index p = 0; p < n; p++) {
        double own[6];
        for (Index b = 0; b < 6; b++) own[b] = coarse[clumps.order(clumps.place(p) + b)];
        for (Index a = 0; a < 6; a++) {
            double sum = r[6 * p + a];
            for (Index b = 0; b < 6; b++) sum += clumps.basis(p, a, b) * own[b];
            z[6 * p + a] = sum;
        }
    }
    remove_rigid(clumps, z);
}

}  // namespace

Index conjugate_gradients(Index, const ScaledMatrix &matrix, const ClumpCorrection &clumps,
                          const ConjugateGradients &search) {
    const Index size = search.residual.size();
    double *r = search.residual.data, *x = search.found.data;
    double *z = search.work.data, *p = z + size, *product = p + size, *load = product + size;
    for (Index k = 0; k < size; k++) load[k] = r[k];
    bool begins = true;
    double rho = 1.0, begun = 0.0;
    search.first(0) = 0.0;
    for (Index round = 0; round < search.most; round++) {
        if (begins) {
            multiply(matrix, matrix.block, matrix.form, x, product, search.stress);
            for (Index k = 0; k < size; k++) {
                r[k] = load[k] - product[k];
                p[k] = 0.0;
            }
        }
        search.rounds(0) = round;
        const bool small = dot(r, r, size) <= search.limits(0) * search.limits(0);
        if (small && begins) return 0;
        precondition(clumps, r, z);
        const double before = rho;
        rho = dot(r, z, size);
        if (begins) begun = rho;
        if (round == 0) search.first(0) = rho;
        if (small || (rho > 0.0 && rho <= search.limits(1))) {
            if (begins || begun <= rounded * rho) return 0;
            begins = true;
            continue;
        }
        begins = false;
        const double further = rho / before;
        for (Index k = 0; k < size; k++) p[k] = further * p[k] + z[k];
        multiply(matrix, matrix.rounded_block, matrix.rounded_form, p, product, search.stress);
        remove_rigid(clumps, product);
        const double curvature = dot(p, product, size);
        if (!(curvature > 0.0)) return 1;
        const double step = rho / curvature;
        for (Index k = 0; k < size; k++) {
            x[k] += step * p[k];
            r[k] -= step * product[k];
        }
    }
    return 1;
}

}  // namespace bondem
