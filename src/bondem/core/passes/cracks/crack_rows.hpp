// Rows of the tables of cracks. Each row is one cache line, because passes read a few numbers of each of many cracks.
// Four bytes per number store levers, shares and H (`laws/cell.hpp`) exactly.
#pragma once
#include "../../laws/crack.hpp"
#include "../../laws/softening.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Reference geometry of a cracked facet.
struct CrackShapeRow {
    int32_t lever_i[3], lever_j[3];  // [pitch]
    float share_i[3], share_j[3];  // [m²]
    double k;  // [N/m]
    double top;  // force below which it does not soften [N]; once faces have parted, distance at which cells touch [m]
};
struct CrackFaceRow {
    double normal[3];  // in the reference [-]
    double part, area, friction, k;  // part of cell i in the compliance, [m²], μ, [N/m]
    double slips;  // 1 while it may slip
};
struct CrackStateRow {
    double slip[3];  // of the faces, or of the spring of friction, in the frame of cell i [m]
    double rub[3];  // friction force a step ago [N], or by how much the faces slip in this step, in that frame [m]
    double fresh;  // 1 for a crack that becomes active in this step
    double kind;  // `crack::CrackKind`
};
struct CrackFrameRow {
    double axes[4];  // quaternion in the frame of cell i
    double left[4];  // s_1, s_2, s_3, and the grip
};
struct CrackPastRow {
    double left[4], root[4];  // a step ago; roots of energies along the axes and by bending [√J]
};
struct CrackSofteningRow {
    float H[6], plane, unused;  // [N·m]; 1 for facets of material planes
    double bends, brittleness, fastest;  // 4 k / A², 1 / T_l, largest loss per step of facets that break at once
    double strength;  // [Pa], 0 where a cell had no cohesion
};
struct CrackHistoryRow {
    double status, spent;  // `crack::CrackStatus`, energy dissipated [J]
    double cohesion, slip_brittleness, friction;  // of facets of material planes [Pa, 1/Pa, -]
    double began;  // step in which it began, below 0 for those of a state, in their order
    double onset_step;  // step in which it began, also for those of a state
    double unused;
};
static_assert(sizeof(CrackShapeRow) == 64 && sizeof(CrackFaceRow) == 64 && sizeof(CrackStateRow) == 64 &&
              sizeof(CrackSofteningRow) == 64 && sizeof(CrackHistoryRow) == 64 && sizeof(CrackFrameRow) == 64 &&
              sizeof(CrackPastRow) == 64);

inline CrackShapeRow &shape_of(const CohesiveCracks &cracks, Index c) { return cracks.shape.row<CrackShapeRow>(c); }
inline CrackFaceRow &face_of(const CohesiveCracks &cracks, Index c) { return cracks.face.row<CrackFaceRow>(c); }
inline CrackStateRow &state_of(const CohesiveCracks &cracks, Index c) { return cracks.state.row<CrackStateRow>(c); }
inline CrackFrameRow &frame_of(const CohesiveCracks &cracks, Index c) { return cracks.frame.row<CrackFrameRow>(c); }
inline CrackPastRow &past_of(const CohesiveCracks &cracks, Index c) { return cracks.past.row<CrackPastRow>(c); }
inline CrackSofteningRow &softening_of(const CohesiveCracks &cracks, Index c) {
    return cracks.softening.row<CrackSofteningRow>(c);
}
inline CrackHistoryRow &history_of(const CohesiveCracks &cracks,
                                   Index c) { return cracks.history.row<CrackHistoryRow>(c); }

// Number of the half of facet k on cell i (0) or j (1), and the facet of a half. There is no half 0.
inline Index half_of(Index k, Index side) { return 2 * k + 1 + side; }
inline Index facet_of(Index half) { return (half - 1) >> 1; }

namespace crack {
// Change of a crack in a step: none; it loses integrity; it becomes resting; its faces part; it becomes active again.
enum Flag : Byte { unchanged, fell, calmed, parts, wakes };
// Columns of the loads of a half: force on its cell, energy lost to friction, torque, and its part of N
// (`slides.hpp`); then its parts of R, K, Σ ± ω P f and C.
enum LoadColumn : Index { force = 0, slides = 8 };
// Column of `CrackLists.slip` with the state of a cell: no slip in this step and the one before, slip in the step
// before only, or slip in this step.
constexpr Index slipping = 3;
enum Slipping : int { sticks, slipped, slips };
// Number of places in a portion of a list.
constexpr Index of_portion = 256;
}  // namespace crack

}  // namespace bondem
