// Hard spheres that fly, collide and grow: event-driven molecular dynamics (Lubachevsky and Stillinger, J. Stat.
// Phys. 60, 1990), with one event per sphere (Lubachevsky, J. Comput. Phys. 94, 1991).
//
// All radii grow in proportion at a constant rate. Between collisions a sphere flies straight. The next event of each
// sphere is stored in a heap ordered by time. One thread computes all events, because each depends on those before.
#include "../../registered.hpp"
#include "../../tables/columns.hpp"
#include "../../tables/packing_tables.hpp"
#include "../../vector3.hpp"
#include "periodic.hpp"

namespace bondem {
namespace {

enum Grown : Index { grown, list_out_of_date, too_many_events };

// Kinds of the next event of a sphere, other than the number of a sphere; the axis of a flat wall is subtracted.
constexpr Index nothing = -1, leave = -2, check = -3, round_wall = -4, lower_wall = -10, upper_wall = -20;

struct Event {
    double time;
    Index kind;
};

// First time from now at which a t² + 2 b t + c, which is positive now, falls to 0; infinite without one.
double first_root(double a, double b, double c) {
    if (b < 0.0) {
        if (c <= 0.0) return 0.0;
        const double inside = b * b - a * c;
        return inside >= 0.0 ? c / (root(inside) - b) : infinity;
    }
    if (a < 0.0) return (b + root(b * b - a * most(c, 0.0))) / -a;
    return infinity;
}

struct Flying {
    const Spheres &spheres;
    const PackingWalls &walls;
    const Near &near;
    const Growing &growing;
    const Flight &flight;
    Period period;

    Vector &position(Index i) const { return spheres.sphere.row<Vector>(i); }
    Vector &velocity(Index i) const { return spheres.velocity.row<Vector>(i); }

    // Restores the order of the heap after the time of the sphere at `k` has changed.
    void sift(Index k) const {
        const Index i = flight.heap(k), n = flight.heap.size();
        while (k > 0 && flight.when(i) < flight.when(flight.heap((k - 1) / 2))) {
            put(k, flight.heap((k - 1) / 2));
            k = (k - 1) / 2;
        }
        while (2 * k + 1 < n) {
            Index child = 2 * k + 1;
            if (child + 1 < n && flight.when(flight.heap(child + 1)) < flight.when(flight.heap(child))) child++;
            if (flight.when(flight.heap(child)) >= flight.when(i)) break;
            put(k, flight.heap(child));
            k = child;
        }
        put(k, i);
    }
    void put(Index k, Index i) const {
        flight.heap(k) = i;
        flight.place(i) = k;
    }
    void schedule(Index i, Event event) const {
        flight.when(i) = event.time;
        flight.what(i) = event.kind;
        sift(flight.place(i));
    }

    // The earlier of an event and of the collision of a sphere of radius r with the walls.
    Event at_walls(Vector x, Vector v, double r, double grow, Event best) const {
        for (Index a = 0; a < 3; a++) {
            if (grow - v[a] > 0.0) {
                const double t = most(x[a] - walls.lower(a) - r, 0.0) / (grow - v[a]);
                if (t < best.time) best = {t, lower_wall - a};
            }
            if (grow + v[a] > 0.0) {
                const double t = most(walls.upper(a) - x[a] - r, 0.0) / (grow + v[a]);
                if (t < best.time) best = {t, upper_wall - a};
            }
        }
        if (walls.radius < infinity) {
            const Vector weight = {walls.weight(0), walls.weight(1), walls.weight(2)}, p = each(weight, x);
            const double room = walls.radius - r;
            const double grow_square = grow * grow;
            const double a = grow_square - weight.x * v.x * v.x - weight.y * v.y * v.y - weight.z * v.z * v.z;
            const double b = -(p.x * v.x + p.y * v.y + p.z * v.z) - room * grow;
            const double t = first_root(a, b, room * room - p.x * p.x - p.y * p.y - p.z * p.z);
            if (t < best.time) best = {t, round_wall};
        }
        return best;
    }

    // The next event of sphere i.
    Event next_event(Index i, double now) const {
        const Vector x = position(i), v = velocity(i), moved = x - near.listed.row<const Vector>(i);
        const double scale = growing.scale + growing.rate * now;
        const double r = spheres.unit(i) * scale, grow = spheres.unit(i) * growing.rate;
        const double speed = dot(v, v), along = dot(moved, v), slack = near.slack * near.slack;
        const double inside = most(slack - moved.x * moved.x - moved.y * moved.y - moved.z * moved.z, 0.0);
        Event best = {(root(along * along + speed * inside) - along) / most(speed, 1e-300), leave};
        best = at_walls(x, v, r, grow, best);
        for (Index k = near.start(i); k < near.start(i + 1); k++) {
            const Index j = near.neighbour(k);
            const double late = now - flight.since(j);
            const Vector u = velocity(j), d = period.nearest_image(plus(position(j), late, u) - x), w = u - v;
            const double both = r + spheres.unit(j) * scale, widen = grow + spheres.unit(j) * growing.rate;
            const double a = w.x * w.x + w.y * w.y + w.z * w.z - widen * widen;
            const double b = d.x * w.x + d.y * w.y + d.z * w.z - both * widen;
            const double t = first_root(a, b, d.x * d.x + d.y * d.y + d.z * d.z - both * both);
            if (t < best.time && now + t < flight.when(j)) best = {t, j};
        }
        return {now + best.time, best.kind};
    }

    void fly(Index i, double now) const {
        position(i) = plus(position(i), now - flight.since(i), velocity(i));
        flight.since(i) = now;
    }

    // Collides two spheres elastically, with surfaces that grow; adds distance times exchanged momentum [m²].
    void collide(Index i, Index j, double swell, double &virial) const {
        const Vector apart = period.nearest_image(position(j) - position(i));
        const double distance = length(apart);
        const Vector normal = apart / distance;
        const double push = swell - dot(normal, velocity(j) - velocity(i));
        const Vector exchanged = push * normal;  // rounded once, so that momentum is conserved
        velocity(i) = velocity(i) - exchanged;
        velocity(j) = velocity(j) + exchanged;
        virial += push * distance;
    }

    // Reflects a sphere at a wall; returns true if the event was one with a wall.
    bool bounce(Index i, Index kind, double swell) const {
        Vector &v = velocity(i);
        if (kind == round_wall) {
            const Vector p = each({walls.weight(0), walls.weight(1), walls.weight(2)}, position(i));
            const double d = length(p), out = 2.0 * (dot(p, v) / d + spheres.unit(i) * growing.rate);
            v = v - (out * p) / d;
        } else if (kind <= upper_wall) {
            v[upper_wall - kind] = -v[upper_wall - kind] - 2.0 * swell;
        } else if (kind <= lower_wall) {
            v[lower_wall - kind] = -v[lower_wall - kind] + 2.0 * swell;
        } else {
            return false;
        }
        return true;
    }

    // Chooses the next event of sphere p; spheres whose event was with it or with its new partner choose again.
    void predict(Index p, double now) const {
        const Event event = next_event(p, now);
        const Index other = flight.what(p);
        if (other >= 0) {  // scheduled just before by the prediction of the other sphere
            if (event.time >= flight.when(p)) return;
            flight.what(other) = check;
        }
        flight.when(p) = event.time;
        flight.what(p) = event.kind;
        if (event.kind >= 0) {
            const Index left = flight.what(event.kind);
            if (left >= 0) flight.what(left) = check;
            schedule(event.kind, {event.time, p});
        }
        sift(flight.place(p));
    }
};

}  // namespace

// Advances spheres that fly and grow to the end of a duration, or until neighbour lists are out of date or the
// collisions are too many; all end at the same time. Returns the outcome; after `list_out_of_date` make new lists and
// call again. Walls on a grid of depths are ignored.
Index fly_and_grow(Index, const Spheres &spheres, const PackingWalls &walls, const Near &near, const Growing &growing,
                   const Flight &flight) {
    const Flying flying{spheres, walls, near, growing, flight, Period(spheres.period)};
    const Index n = spheres.unit.size();
    for (Index i = 0; i < n; i++) {  // at time 0 every sphere predicts its first event
        flight.since(i) = flight.when(i) = 0.0;
        flight.what(i) = check;
        flight.heap(i) = flight.place(i) = i;
    }
    Grown status = grown;
    double now = 0.0, virial = 0.0;
    Index collisions = 0;
    for (;;) {
        const Index i = flight.heap(0), kind = flight.what(i);
        if (flight.when(i) > growing.duration) {
            now = growing.duration;
            break;
        }
        now = flight.when(i);
        if (kind == leave || collisions >= growing.events) {
            status = kind == leave ? list_out_of_date : too_many_events;
            break;
        }
        flying.fly(i, now);
        if (kind >= 0) {
            flying.fly(kind, now);
            const double swell = spheres.unit(i) * growing.rate;
            flying.collide(i, kind, swell + spheres.unit(kind) * growing.rate, virial);
            collisions++;
            flying.schedule(kind, {infinity, nothing});
        } else if (flying.bounce(i, kind, spheres.unit(i) * growing.rate)) {
            collisions++;
        }
        flying.schedule(i, {infinity, nothing});
        flying.predict(i, now);
        if (kind >= 0) flying.predict(kind, now);
    }
    for (Index i = 0; i < n; i++) {
        flying.fly(i, now);
        spheres.sphere(i, 3) = spheres.unit(i) * (growing.scale + growing.rate * now);
    }
    growing.report(growth_report::time) = now;
    growing.report(growth_report::virial) = virial;
    growing.report(growth_report::collisions) = double(collisions);
    return status;
}
BONDEM_CALL(fly_and_grow, "grown list_out_of_date too_many_events")

}  // namespace bondem
