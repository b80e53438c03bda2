// Sums without rounding: a sum of doubles has the same bits in any order of its terms, and on any number of threads.
//
// A sum is an integer multiple of 2^-1074, the smallest positive double, in 67 digits of 32 bits (limbs), which
// exceed the range of doubles by a factor 2^46. Each limb is stored in a signed word of 64 bits. A term changes three
// words without carries, so that 2^31 terms fit. Carries are made when the sum is read. Reading rounds once, to the
// nearest double with ties to even, as `math.fsum` does. Terms that are not finite are stored separately, as flags.
#pragma once
#include "array.hpp"
#include "scalars.hpp"
#include "tables/columns.hpp"

namespace bondem {

struct ExactSum {
    static constexpr Index limbs = exact_word::flags;
    enum Flag : Index { positive_infinity = 1, negative_infinity = 2, not_a_number = 4 };

    Index limb[limbs];  // of 2^(32 k - 1074)
    Index flags;

    BONDEM_INLINE void add(double term) {
        give(term, [&](Index k, Index part) { limb[k] += part; }, [&](Index flag) { flags |= flag; });
    }
    BONDEM_INLINE void subtract(double term) { add(-term); }
    // Adds a number, or a sum, where other threads may add to this sum.
    BONDEM_INLINE void add_shared(double term) {
        give(term, [&](Index k, Index part) { add_to_shared(limb[k], part); },
             [&](Index flag) { set_in_shared(flags, flag); });
    }
    inline void add_shared(const ExactSum &other) {
        for (Index k = 0; k < limbs; k++)
            if (other.limb[k] != 0) add_to_shared(limb[k], other.limb[k]);
        if (other.flags != 0) set_in_shared(flags, other.flags);
    }

    // Returns the sum, rounded once.
    inline double value() const {
        if (flags != 0) return flags == positive_infinity ? infinity : flags == negative_infinity ? -infinity : undefined;
        Index begin = 0, end = limbs;
        while (begin < end && limb[begin] == 0) begin++;
        while (end > begin && limb[end - 1] == 0) end--;
        end = least(end + 1, limbs);  // with room for what is carried
        uint32_t digit[limbs + 4];
        for (Index k = most(begin - 2, Index(0)); k < begin; k++) digit[k] = 0;
        for (Index k = end; k < end + 4; k++) digit[k] = 0;
        const bool negative = carry_into(digit, begin, end, 1) < 0;
        if (negative) carry_into(digit, begin, end, -1);
        Index last = end - 1;
        while (last >= begin && digit[last] == 0) last--;
        if (last < begin) return 0.0;
        Index top = 32 * last;
        for (uint32_t rest = digit[last] >> 1; rest != 0; rest >>= 1) top++;
        // bits 0 … 52 of doubles below 2^-1021 are those of the sum
        const Index below = most(top - 52, Index(0)), first = below >> 5, off = below & 31;
        const auto two = [&](Index k) { return uint64_t(digit[k]) | uint64_t(digit[k + 1]) << 32; };
        uint64_t mantissa = two(first);
        if (off != 0) mantissa = mantissa >> off | two(first + 2) << (64 - off);
        if (below > 0 && rounds_up(digit, begin, below - 1, mantissa & 1)) mantissa++;
        uint64_t bits = (uint64_t(below) << 52) + mantissa;
        if (bits > bits_of(infinity)) bits = bits_of(infinity);
        return __builtin_bit_cast(double, bits | uint64_t(negative) << 63);
    }
    // Returns the sum, and empties it.
    inline double take() {
        const double sum = value();
        *this = {};
        return sum;
    }

  private:
    static BONDEM_INLINE uint64_t bits_of(double a) { return __builtin_bit_cast(uint64_t, a); }

    // Calls to(k, part) for the limbs of a term, or flag(f) for a term that is not finite.
    template <class To, class Set> static BONDEM_INLINE void give(double term, To to, Set flag) {
        const uint64_t bits = bits_of(term), exponent = bits >> 52 & 2047, fraction = bits & ((uint64_t(1) << 52) - 1);
        if (__builtin_expect(exponent == 2047, 0))
            return flag(fraction != 0 ? not_a_number : bits >> 63 ? negative_infinity : positive_infinity);
        const bool normal = exponent != 0;
        const uint64_t mantissa = fraction | uint64_t(normal) << 52, below = exponent - normal, off = below & 31;
        const Index sign = -Index(bits >> 63), k = Index(below >> 5);
        const auto signed_part = [&](uint64_t part) { return (Index(part) ^ sign) - sign; };
        const uint64_t low = mantissa << off;
        to(k, signed_part(low & 0xffffffff));
        to(k + 1, signed_part(low >> 32));
        to(k + 2, signed_part(mantissa >> 32 >> (32 - off)));
    }
    // Writes the digits of the sum times a sign; returns the carry beyond them, below 0 if this product is negative.
    inline Index carry_into(uint32_t *digit, Index begin, Index end, Index sign) const {
        Index carry = 0;
        for (Index k = begin; k < end; k++) {
            carry += sign * limb[k];
            digit[k] = uint32_t(uint64_t(carry));
            carry >>= 32;
        }
        return carry;
    }
    // True if a number is rounded up where bits are cut off from `bit` down; digits before `begin` are zero.
    static inline bool rounds_up(const uint32_t *digit, Index begin, Index bit, bool odd) {
        const Index k = bit >> 5;
        if (k < begin || (digit[k] >> (bit & 31) & 1) == 0) return false;
        bool more = odd || (digit[k] & ((uint32_t(1) << (bit & 31)) - 1)) != 0;
        for (Index below = begin; below < k; below++) more |= digit[below] != 0;
        return more;
    }
};
static_assert(sizeof(ExactSum) == exact_word::count * sizeof(Index));

// Sum k of a table with one sum per row.
inline ExactSum &exact_sum(const Array<Index, 2> &sums, Index k) { return sums.row<ExactSum>(k); }

}  // namespace bondem
