"""Product of a block-sparse matrix and a vector, rows in parallel; each row sums in a fixed order."""

from bondem._compile import kernel, prange


@kernel(parallel=True)
def block_matvec(indptr, indices, data, x, y):
    """y = K x for blocks `data` (…, 6, 6) in sparse rows and x, y of shape (n, 6)."""
    for p in prange(len(indptr) - 1):
        y0 = y1 = y2 = y3 = y4 = y5 = 0.0
        for s in range(indptr[p], indptr[p + 1]):
            q = indices[s]
            for c in range(6):
                v = x[q, c]
                y0 += data[s, 0, c] * v
                y1 += data[s, 1, c] * v
                y2 += data[s, 2, c] * v
                y3 += data[s, 3, c] * v
                y4 += data[s, 4, c] * v
                y5 += data[s, 5, c] * v
        y[p, 0], y[p, 1], y[p, 2] = y0, y1, y2
        y[p, 3], y[p, 4], y[p, 5] = y3, y4, y5
