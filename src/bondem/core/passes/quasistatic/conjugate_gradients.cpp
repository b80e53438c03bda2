// Conjugate gradients for successive equilibria, preconditioned by a coarse correction in which clumps of cells move
// rigidly. A scaling S of the unknowns makes the diagonal blocks of Sᵀ K S unit matrices, with K the stiffness.
//
// Memory traffic determines the time of an iteration. The residual of a guess is computed in double precision.
// Corrections are much smaller than the solution, so that a matrix in single precision is accurate enough for them.
#include "../../registered.hpp"
#include "../../tables/quasistatic_tables.hpp"

namespace bondem {
namespace {

// Largest reduction of r · z by the rounded matrix alone; after more, the exact residual is computed again.
constexpr double rounded = 1e6;

// Eight numbers in one register: the six of a cell and two zeros.
typedef double Eight __attribute__((vector_size(64)));

template <class T> Eight eight(const T *x, Index count = 8) {
    typedef T Loaded __attribute__((vector_size(8 * sizeof(T))));
    Loaded loaded = {};
    __builtin_memcpy(&loaded, x, static_cast<unsigned long>(count) * sizeof(T));
    return __builtin_convertvector(loaded, Eight);
}
template <class T> Eight six(const T *x) { return eight(x, 6); }
void add(Eight s, double *y) {
    const Eight sum = six(y) + s;
    __builtin_memcpy(y, &sum, 6 * sizeof(double));
}
double sum_of(Eight s) { return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7])); }

template <class T> double dot(const T *a, const double *b, Index n) {
    Eight one = {}, other = {};
    Index k = 0;
    for (; k + 16 <= n; k += 16) {
        one += eight(a + k) * eight(b + k);
        other += eight(a + k + 8) * eight(b + k + 8);
    }
    double rest = 0.0;
    for (; k < n; k++) rest += a[k] * b[k];
    return sum_of(one + other) + rest;
}
// Product Aᵀ x of a 6 × 6 block A.
template <class T> Eight turned_product(const T *A, const double *x) {
    return (six(A) * x[0] + six(A + 6) * x[1] + six(A + 12) * x[2]) +
           (six(A + 18) * x[3] + six(A + 24) * x[4] + six(A + 30) * x[5]);
}

// Computes y = (B + Fᵀ W F) x. As B is symmetric, a block A in row p and column q adds Aᵀ x_p to y_q.
template <class T>
void multiply(const ScaledMatrix &matrix, const Array<const T, 3> &block, const Array<const T, 2> &form, const double *x,
              double *y, const Array<double, 1> &stress) {
    const Index n = matrix.weight.size();
    for (Index k = 0; k < 6 * n; k++) y[k] = 0.0;
    for (Index p = 0; p < n; p++) {
        Eight swelling = {};
        for (Index e = matrix.start(p); e < matrix.start(p + 1); e++) {
            const Index q = 6 * matrix.column(e);
            add(turned_product(&block(e, 0, 0), x + 6 * p), y + q);
            swelling += six(&form(e, 0)) * six(x + q);
        }
        stress(p) = matrix.weight(p) * sum_of(swelling);
    }
    for (Index p = 0; p < n; p++)
        for (Index e = matrix.start(p); e < matrix.start(p + 1); e++)
            add(six(&form(e, 0)) * stress(p), y + 6 * matrix.column(e));
}

// Solves L Lᵀ x = v in place.
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

// Removes rigid motions from displacements v, or from forces v the part that drives them.
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
    for (Index p = 0; p < n; p++) {
        const Eight moved = turned_product(&clumps.basis(p, 0, 0), r + 6 * p);
        for (Index b = 0; b < 6; b++) coarse[clumps.order(clumps.place(p) + b)] += moved[b];
    }
    solve_coarse(clumps.factor, coarse);
    for (Index p = 0; p < n; p++) {
        Eight own = {};
        for (Index b = 0; b < 6; b++) own[b] = coarse[clumps.order(clumps.place(p) + b)];
        for (Index a = 0; a < 6; a++) z[6 * p + a] = r[6 * p + a] + sum_of(six(&clumps.basis(p, a, 0)) * own);
    }
    remove_rigid(clumps, z);
}

}  // namespace

// Solves Sᵀ K S x = f by conjugate gradients from a guess, preconditioned by clumps; returns 0 if converged, else 1.
Index conjugate_gradients(Index, const ScaledMatrix &matrix, const ClumpCorrection &clumps,
                          const ConjugateGradients &search) {
    const Index size = search.residual.size();
    double *r = search.residual.data, *x = search.found.data;
    double *z = search.work.data, *p = z + size, *product = p + size, *load = product + size;
    for (Index k = 0; k < size; k++) load[k] = r[k];
    bool begins = true;
    double rho = 1.0, rho_first = 0.0;
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
        if (begins) rho_first = rho;
        if (round == 0) search.first(0) = rho;
        if (small || (rho > 0.0 && rho <= search.limits(1))) {
            if (begins || rho_first <= rounded * rho) return 0;
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
BONDEM_CALL(conjugate_gradients, "converged stuck")

}  // namespace bondem
