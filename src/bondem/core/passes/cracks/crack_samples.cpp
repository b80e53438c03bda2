// Laws of cracks and of yielding cells, evaluated for arrays of samples that do not depend on each other.
#include "../../laws/crack.hpp"
#include "../../laws/plasticity.hpp"
#include "../../laws/softening.hpp"
#include "../../laws/stress.hpp"
#include "../../registered.hpp"
#include "../../tables/crack_sample_tables.hpp"
#include "crack_groups.hpp"
#include "softening_cracks.hpp"

namespace bondem {
namespace {

// Reads and writes the columns of a table at sample e, one after the other.
template <class T> struct ReadColumns {
    const Array<const double, 2> &table;
    const Index e;
    Index column = 0;

    ReadColumns(const Array<const double, 2> &table, Index e) : table(table), e(e) {}
    T number() { return bondem::number<T>(&table(column++, e), 0); }
    Vector3<T> vector() {
        const T x = number(), y = number(), z = number();
        return {x, y, z};
    }
    Quaternion<T> quaternion() {
        const T w = number(), x = number(), y = number(), z = number();
        return {w, x, y, z};
    }
    Symmetric3<T> tensor() {
        const Vector3<T> a = vector(), b = vector();
        return {a.x, a.y, a.z, b.x, b.y, b.z};
    }
};
template <class T> struct WriteColumns {
    const Array<double, 2> &table;
    const Index e;
    Index column = 0;

    WriteColumns(const Array<double, 2> &table, Index e) : table(table), e(e) {}
    void operator()(T a) {
        if constexpr (sizeof(T) == sizeof(double))
            table(column++, e) = a;
        else
            store(&table(column++, e), a);
    }
    void operator()(Vector3<T> a) {
        (*this)(a.x);
        (*this)(a.y);
        (*this)(a.z);
    }
};

template <class T> void soften(const SofteningSamples &samples, Index e) {
    ReadColumns<T> given(samples.given, e);
    const FacetTraction<T> load = {given.vector(), given.vector(), given.number()};
    const Symmetric3<T> mean = given.tensor();
    const Softening<T> tension = {given.number(), given.number()};
    const PlaneStrength<T> plane = {given.number(), given.number(), given.number()};
    const Mask<T> isotropic = given.number() > all<T>(0.5);
    CrackFaces<T> at = {};
    at.at = {{given.vector(), given.vector(), given.vector()}};
    at.left = {{given.number(), given.number(), given.number()}, given.number()};
    const Vector3<T> slip = given.vector();
    const auto apart = [of = given.number()] { return of; };
    const FacesMoved<T, decltype(apart)> moved = {slip, apart};
    const CurveShape curve = {samples.kink, samples.steep};
    const auto all_at_once = [] { return Vector3<T>{all<T>(1.0), all<T>(1.0), all<T>(1.0)}; };
    const CrackStrength<T> by = {tension, plane, isotropic};
    Softened<T> found = soften_along(at, load, mean, all_at_once, tension, moved, curve, all<T>(1.0) < T{});
    const T one = integrity_left(at.left.s[0], load, by, curve);
    WriteColumns<T> left(samples.left, e);
    left(select(isotropic, one, found.left.s[0])), left(found.left.s[1]), left(found.left.s[2]);
    left(select(isotropic, one, found.left.grip));
    const T steep = most(absolute(dot(load.normal, at.at.e[0])), all<T>(least_slope));
    left(select(isotropic, unsoftened_below(at.left.s[0], by),
                softens_at(at.left.s[0], T(tension.strength * steep), tension.brittleness, curve)));
}

template <class T> void load_crack(const CrackSamples &samples, Index e) {
    ReadColumns<T> of(samples.given, e);
    const Ends<T> ends = {of.vector(), of.quaternion(), of.quaternion()};
    const FacetShape<T> shape = {of.vector(), of.vector(), of.vector(), of.vector()};
    const Vector3<T> normal = of.vector();
    const Symmetric3<T> H = of.tensor();
    const FacetCompliance<T> facet = {of.number(), of.number()};
    const Quaternion<T> axes = of.quaternion();
    const CrackIntegrity<T> left = {{of.number(), of.number(), of.number()}, of.number()};
    const Mask<T> rubs = of.number() > all<T>(0.5);
    const OfCells<T> stress = {of.number(), of.number()};
    const Vector3<T> slip = of.vector();
    const T friction = of.number();
    const CrackIntegrity<T> before = {{of.number(), of.number(), of.number()}, of.number()};
    const CrackRoots<T> roots_before = {{of.number(), of.number(), of.number()}, of.number()};
    const Vector3<T> rub_before = of.vector();
    const CrackFaces<T> at = crack_faces(ends, shape, normal, axes, left, rubs, slip);
    const CrackHalves<T> half = crack_halves(facet, at, stress);
    const Vector3<T> turned = turned_by(ends.i, slip);
    const CrackLoads<T> loads = crack_loads(facet, at, half, stress, turned, friction);
    const FacetBending<T> bending = facet_bending(ends, H);
    const CrackEnergy<T> energy = crack_energy(facet, at, half, loads.friction.force);
    const CrackRoots<T> roots = crack_roots(facet, half, bending.energy);
    const CrackStep<T> step = {before, left, roots_before, roots, rub_before, loads.friction.force,
                               loads.friction.slip - turned};
    const CrackLosses<T> lost = crack_losses(facet.k, step);
    WriteColumns<T> found(samples.found, e);
    found(loads.force), found(loads.on_i), found(loads.on_j), found(loads.friction.force), found(loads.friction.slip);
    for (int d = 0; d < 3; d++) found(roots.along[d]);
    found(bending.energy), found(bending.torque), found(energy.across), found(energy.along);
    found(lost.cracked), found(lost.rubbed);
    found(swelling_of(swelling_half(facet.k, facet.part, at, at.share_i), stress.i).swelling);
    found(swelling_of(swelling_half(facet.k, T(1.0 - facet.part), at, at.share_j), stress.j).swelling);
}

template <class T> void flow(const YieldSamples &samples, Index e) {
    ReadColumns<T> stress(samples.stress, e), of(samples.strength, e);
    const Symmetric3<T> s = stress.tensor();
    const YieldStrength<T> by = {of.number(), of.number(), of.number(), of.number(), of.number()};
    const StressInvariants<T> at = invariants(s);
    const PrincipalStress<T> p = principal(s);
    const PlasticStep<T> step = samples.cone ? cone_step(p, at, by) : slip_step(p, by);
    const Symmetric3<T> strain = plastic_strain(p, step);
    WriteColumns<T> found(samples.found, e);
    found(yield_bound(at, by, samples.cone != 0)), found(step.gamma), found(step.carry);
    found(Vector3<T>{strain.xx, strain.yy, strain.zz}), found(Vector3<T>{strain.xy, strain.xz, strain.yz});
    found(Vector3<T>{p.stress[0], p.stress[1], p.stress[2]});
    found(yield_load(p, at, by.slope, samples.cone != 0));
}

template <class T> void bound(const StressBoundSamples &samples, Index e) {
    const Symmetric3<T> s = ReadColumns<T>(samples.stress, e).tensor();
    const T bent = number<T>(samples.bent.data, e);
    const PrincipalBounds<T> of = principal_bounds(s);
    WriteColumns<T> found(samples.found, e);
    found(of.largest), found(of.least);
    found(positive(T(bent - largest_pressure(principal(s))))), found(opened_at_most(bent, s));
}

// Calls on(number, e) for each sample, or with lanes for groups of them; samples after the last whole group one by
// one.
template <class On> void over(Index count, Index wide, On on) {
    Index e = 0;
    if (wide)
        for (; e + lanes <= count; e += lanes) on(Lanes{}, e);
    for (; e < count; e++) on(0.0, e);
}

}  // namespace

// Evaluates the softening of facets in samples, by single numbers or by lanes.
Index evaluate_softening(Index, const SofteningSamples &samples) {
    over(samples.given.shape[1], samples.wide, [&](auto number, Index e) { soften<decltype(number)>(samples, e); });
    return 0;
}
BONDEM_CALL(evaluate_softening, "")

// Evaluates the law of cracks in samples, by single numbers or by lanes.
Index evaluate_cracks(Index, const CrackSamples &samples) {
    over(samples.given.shape[1], samples.wide,
         [&](auto number, Index e) { load_crack<decltype(number)>(samples, e); });
    return 0;
}
BONDEM_CALL(evaluate_cracks, "")

// Evaluates the flow of yielding cells in samples, by single numbers or by lanes.
Index evaluate_yielding(Index, const YieldSamples &samples) {
    over(samples.stress.shape[1], samples.wide, [&](auto number, Index e) { flow<decltype(number)>(samples, e); });
    return 0;
}
BONDEM_CALL(evaluate_yielding, "")

// Evaluates bounds of principal stresses in samples, by single numbers or by lanes.
Index evaluate_stress_bounds(Index, const StressBoundSamples &samples) {
    over(samples.bent.size(), samples.wide, [&](auto number, Index e) { bound<decltype(number)>(samples, e); });
    return 0;
}
BONDEM_CALL(evaluate_stress_bounds, "")

}  // namespace bondem
