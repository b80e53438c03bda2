// Angle φ between two directions from its sine and cosine, for one angle or for one angle per SIMD lane.
//
// The core has its own polynomial, because arctangents of different system libraries differ in their last bits. The
// error is at most two units in the last place. With t = tan φ, φ = t - t³ P(t²) up to t = tan π/8, where P has the
// coefficients of fdlibm (Sun Microsystems, 1993). From there to t = 1, φ = π/4 + atan((t - 1) / (t + 1)).
#pragma once
#include "../lanes.hpp"

namespace bondem {

// Angle atan t for t in [0, 1].
template <class T> BONDEM_INLINE T first_octant_angle(T t) {
    constexpr double eighth = 0.41421356237309503, quarter_turn = 0.78539816339744828;
    const T one = T{} + 1.0, zero = {};
    const T steep = t > T{} + eighth ? one : zero;
    const T x = steep > zero ? (t - 1.0) / (t + 1.0) : t;
    const T z = x * x, w = z * z;
    const T odd = z * (3.33333333333329318027e-01 + w * (1.42857142725034663711e-01 + w * (9.09088713343650656196e-02
                  + w * (6.66107313738753120669e-02 + w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
    const T even = w * (-1.99999999998764832476e-01 + w * (-1.11111104054623557880e-01 + w * (-7.69187620504482999495e-02
                   + w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
    return steep * quarter_turn + (x - x * (odd + even));
}

// Angle in [0, π] from its sine and cosine, both multiplied by one positive number; `sine` ≥ 0.
template <class T> BONDEM_INLINE T angle_of(T sine, T cosine) {
    constexpr double right = 1.5707963267948966, straight = 3.1415926535897931;
    const T zero = {}, along = absolute(cosine);
    const T low = sine > along ? along : sine, high = sine > along ? sine : along;
    const T acute = first_octant_angle(high > zero ? low / high : zero);
    const T folded = sine > along ? right - acute : acute;
    return cosine < zero ? straight - folded : folded;
}

}  // namespace bondem
