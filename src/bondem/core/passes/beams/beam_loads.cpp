// Passes that add loads of beams and dashpots to elements, in the order of the beams, and mark beams near failure.
#include "beam_passes.hpp"

#include "../../laws/damping.hpp"
#include "../../registered.hpp"
#include "../assembly/derivatives.hpp"
#include "../damage/pipeline.hpp"
#include "../damage/softening_beam.hpp"

namespace bondem {
namespace {

// Distance in bonds at which first elements are prefetched; second elements follow one another in memory.
constexpr Index ahead = 32;

// Marking of beams that cannot fail, without effect.
struct NoMarks {
    template <class Loads> BONDEM_INLINE void mark(Index, int, Loads &) const {}
    template <class T> BONDEM_INLINE void press(Index, Vector3<T>, T, BeamLoads<T> &) const {}
};
// Marking of beams whose loads reach their bounds.
struct BeamMarks {
    Marks marks;
    BONDEM_INLINE void press(Index, Vector3<Lanes>, Lanes, BeamLoads<Lanes> &) const {}
    BONDEM_INLINE void mark(Index k, int known, BeamLoads<Lanes> &loads) {
        const Vector3<Lanes> f = loads.force, a = loads.on_i, b = loads.on_j;
        marks.mark(k, known, dot(f, f), dot(a, a) + dot(b, b));
    }
};

// Marking of beams that begin to soften at their criterion, and the pressure of softened beams.
template <class Criterion> struct SofteningMarks {
    Marks marks;
    const Range &range;
    const Moving &all;
    const Beams &beams;
    const SofteningBounds &bounds;
    const Candidates &candidates;

    BONDEM_INLINE void press(Index k, Vector3<Lanes> branch, Lanes rest_length, BeamLoads<Lanes> &loads) const {
        loads.force = plus(loads.force, load(bounds.press.data + k), pressure_on(branch, rest_length));
    }
    BONDEM_INLINE void mark(Index k, int known, BeamLoads<Lanes> &loads) {
        const Vector3<Lanes> f = loads.force, a = loads.on_i, b = loads.on_j;
        marks.for_each_near(k, known, dot(f, f), dot(a, a) + dot(b, b), [&](int n) {
            Lanes left = Lanes{} + 1.0;
            left[n] = left_of(k + n);
            loads = {left * loads.force, left * loads.on_i, left * loads.on_j};
        });
    }

  private:
    // Integrity of beam k, which is near to its bound, under the present loads.
    __attribute__((noinline)) double left_of(Index k) {
        if (range.clock.first || !(beams.integrity(k) > 0.0)) return 1.0;
        const Verdict<double> verdict = begin_beam<Criterion>(all, beams, bounds, range.clock.dt, k);
        if (!(verdict.index >= 1.0)) return 1.0;
        candidates.mode(candidates.begin(range.block) + marks.count()) = Index(verdict.mode);
        marks.put(k);
        put_shared(candidates.any(0), Index(1));
        return beams.integrity(k);
    }
};

// Adds the loads of the beams first … last - 1; `to` has the rows of the sums, and the sums.
template <class Pose, class Sums, class Kind, class Marking>
BONDEM_INLINE void add_loads(Index first, const Index last, const Pose pose, const Beams &beams, const Sums &to,
                             const Kind kind, Marking &marking) {
    double *const __restrict sums = to.sums.data;
    const Short *const i = beams.i.data, *const j = beams.j.data;
    const Short *const row_i = to.row_i.data, *const row_j = to.row_j.data;
    double period[6];
    for (Index c = 0; c < 6; c++) period[c] = beams.period(c);
    const double *const X0 = beams.X0.data, *const Y0 = beams.Y0.data, *const Z0 = beams.Z0.data, *const L = beams.length.data;
    for_each_group(first, last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        prefetch(pose, i + least(k + ahead, last - lanes));
        const auto ends = ends_of(gather(pose, i + k, j + k), period);
        using T = decltype(ends.branch.x);
        const BeamShape<T> shape = {{number<T>(X0, k), number<T>(Y0, k), number<T>(Z0, k)}, number<T>(L, k)};
        BeamLoads<T> loads = beam_loads(ends, shape, kind.template stiffness<T>(k));
        marking.mark(k, group.known, loads);
        marking.press(k, ends.branch, shape.length, loads);
        add_loads_of(sums, row_i + k, row_j + k, loads, group.known);
    });
}
template <class Pose, class Sums, class Kind>
BONDEM_INLINE void add_loads(Index first, Index last, Pose pose, const Beams &beams, const Sums &to, Kind kind) {
    NoMarks none;
    add_loads(first, last, pose, beams, to, kind, none);
}
template <class Kind>
BONDEM_INLINE void add_marked_loads(const Range &range, const double *pose, const Beams &beams,
                                    const StepBlocks &blocks, Kind kind, const FailureBounds &bounds,
                                    const Candidates &candidates) {
    BeamMarks marked = {Marks(bounds, candidates, range)};
    add_loads(range.first, range.last, pose, beams, blocks, kind, marked);
    candidates.count(range.block) = marked.marks.count();
}

}  // namespace

// Adds forces and torques of the beams of a block to the sums of their elements.
void add_beam_loads(const Range &range, const Moving &all, const Beams &beams, const StepBlocks &blocks) {
    add_loads(range.first, range.last, all.pose.data, beams, blocks, Own{beams});
}
BONDEM_PASS(add_beam_loads, bonds_of_blocks, "ends pose; adds sums")

// Adds forces and torques of beams that differ in length only.
void add_uniform_beam_loads(const Range &range, const Moving &all, const Beams &beams, const UniformBeams &uniform,
                            const StepBlocks &blocks) {
    add_loads(range.first, range.last, all.pose.data, beams, blocks, all_uniform(uniform));
}
BONDEM_PASS(add_uniform_beam_loads, bonds_of_blocks, "ends pose; adds sums")

// Adds forces and torques of the beams of a block, and marks beams near to failure.
void add_marked_beam_loads(const Range &range, const Moving &all, const Beams &beams, const StepBlocks &blocks,
                           const FailureBounds &bounds, const Candidates &candidates) {
    add_marked_loads(range, all.pose.data, beams, blocks, Own{beams}, bounds, candidates);
}
BONDEM_PASS(add_marked_beam_loads, bonds_of_blocks, "ends pose; adds sums")

// Adds forces and torques of beams that differ in length only, and marks beams near to failure.
void add_marked_uniform_beam_loads(const Range &range, const Moving &all, const Beams &beams,
                                   const UniformBeams &uniform, const StepBlocks &blocks, const FailureBounds &bounds,
                                   const Candidates &candidates) {
    add_marked_loads(range, all.pose.data, beams, blocks, all_uniform(uniform), bounds, candidates);
}
BONDEM_PASS(add_marked_uniform_beam_loads, bonds_of_blocks, "ends pose; adds sums")

namespace {

template <class Criterion, class Kind>
BONDEM_INLINE void add_softening_loads(const Range &range, const Moving &all, const Beams &beams,
                                       const StepBlocks &blocks, Kind kind, const SofteningBounds &bounds,
                                       const Candidates &candidates) {
    SofteningMarks<Criterion> marked = {Marks(bounds, candidates, range), range, all, beams, bounds, candidates};
    add_loads(range.first, range.last, all.pose.data, beams, blocks, kind, marked);
    candidates.count(range.block) = marked.marks.count();
}

// Adds forces and torques of beams that may soften, with the pressure on softened beams.
//
// Beams that reach their criterion lose integrity before their loads are added, and are listed as failed.
template <class Criterion>
void add_softening(const Range &range, const Moving &all, const Beams &beams, const StepBlocks &blocks,
                   const SofteningBounds &bounds, const Candidates &candidates) {
    add_softening_loads<Criterion>(range, all, beams, blocks, Own{beams}, bounds, candidates);
}
// Adds forces and torques of beams that may soften and differ in length only, with the pressure on softened beams.
template <class Criterion>
void add_uniform_softening(const Range &range, const Moving &all, const Beams &beams, const UniformBeams &uniform,
                           const StepBlocks &blocks, const SofteningBounds &bounds, const Candidates &candidates) {
    add_softening_loads<Criterion>(range, all, beams, blocks, all_uniform(uniform), bounds, candidates);
}

}  // namespace

#define BONDEM_SOFTEN(_, name, Criterion)                                                               \
    BONDEM_PASS_AS(add_beam_loads_softening_by_##name, bonds_of_blocks, "ends motion pose; adds sums", add_softening<Criterion>)       \
    BONDEM_PASS_AS(add_uniform_beam_loads_softening_by_##name, bonds_of_blocks, "ends motion pose; adds sums", add_uniform_softening<Criterion>)
BONDEM_SOFTENING_CRITERIA(BONDEM_SOFTEN, )
#undef BONDEM_SOFTEN

Index load_beams(Index, const Poses &all, const Beams &beams, const BeamSums &to) {
    add_loads(0, beams.i.size(), all.pose.data, beams, to, Own{beams});
    return 0;
}
BONDEM_CALL(load_beams, "")

Index load_uniform_beams(Index, const Poses &all, const Beams &beams, const UniformBeams &uniform, const BeamSums &to) {
    add_loads(0, beams.i.size(), all.pose.data, beams, to, all_uniform(uniform));
    return 0;
}

// Multiplies small motions by the stiffness of beams in given poses.
Index multiply_beams(Index, const Poses &all, const StiffnessProduct &by, const Beams &beams) {
    const BeamSums to = {beams.i, beams.j, by.sums};
    multiply(all.pose.data, by, [&](const MovedPoses &moved) { add_loads(0, beams.i.size(), moved, beams, to, Own{beams}); });
    return 0;
}
BONDEM_CALL(multiply_beams, "")

// Sets the second derivative of the energy of each beam by the motions of its elements.
Index differentiate_beams(Index, const Poses &all, const Beams &beams, const BondTangents &to) {
    using T = Dual<Lanes>;
    differentiate(all.pose.data, beams, to, [&](Index k, const PairOfRows<T> &rows) __attribute__((always_inline)) {
        return beam_loads(ends_of(rows, beams.period.data), shape_of<T>(beams, k), Own{beams}.stiffness<T>(k));
    });
    return 0;
}
BONDEM_CALL(differentiate_beams, "")

// Adds forces and torques of the dashpots of beams to sums of their own.
void add_dashpot_loads(const Range &range, const Moving &all, const Beams &beams, const Dashpots &dashpots,
                       const StepBlocks &blocks) {
    const Short *const i = beams.i.data, *const j = beams.j.data;
    const double *const c = dashpots.c.data;
    const Index m = dashpots.c.shape[1];
    for_each_group(range.first, range.last, [&](Group group) {
        const Index k = group.first;
        const Vector3<Lanes> apart = branch(gather(all.pose.data, i + k), gather(all.pose.data, j + k), beams.period.data);
        const Motion<Lanes> a(gather(all.motion.data, i + k)), b(gather(all.motion.data, j + k));
        const Lanes s = load(beams.integrity.data + k);
        const BeamDashpots<Lanes> dashpot = {s * load(c + k), s * load(c + m + k), s * load(c + 2 * m + k),
                                             s * load(c + 3 * m + k)};
        add_loads_of(dashpots.sums.data, blocks.row_i.data + k, blocks.row_j.data + k,
                     dashpot_loads(apart, {b.v - a.v, a.w, b.w}, load(dashpots.share.data + k), dashpot), group.known);
    });
}
BONDEM_PASS(add_dashpot_loads, bonds_of_blocks, "ends motion pose; adds Dashpots.sums")

}  // namespace bondem
