// The steps of a run on the CPU. A step is a list of passes, called for ranges of bonds or elements (`steps.hpp`).
#include "steps.hpp"

#include "registered.hpp"
#include "scalars.hpp"
#include "threads.hpp"

namespace bondem {
namespace {

constexpr Index tables_of_pass = 6;
// Return value of `take_steps` for lists out of date; smaller values are the endings that the guard finds.
constexpr Index out_of_date = 3;
// Steps between two passes of the guard.
constexpr Index guard_interval = 100;

// An entry of a list, as Python writes it.
struct Entry {
    PassFunction call;
    PassKind kind;
    const void *tables[tables_of_pass];
};
static_assert(sizeof(Entry) == 8 * (2 + tables_of_pass));

struct List {
    const Entry *entry;
    Index count;

    explicit List(const Array<const Index, 2> &words)
        : entry(reinterpret_cast<const Entry *>(words.data)), count(words.size()) {}
};

bool goes_by_blocks(const Entry &entry) {
    const PassKind kind = entry.kind;
    return !called_once(kind) && kind != of_elements && kind != of_bonds && kind != of_ranges;
}

// Calls of passes over the elements of a block, or over shared ones, and the division that postpones some of them.
class ElementPasses {
  public:
    ElementPasses(const Clock &clock, const ElementList &all, Index block)
        : clock(clock), late(clock), block(block), all(all), division{all, {0, 0, 0, nullptr, nullptr}} {
        late.goes_on = 0;
    }
    void call(const Entry &entry) {
        if (entry.kind == divides_elements || entry.kind == parts_of_shared)
            entry.call(range(clock, all), entry.tables);
        else if (entry.kind == elements_of_blocks)
            entry.call(range(clock, division.going), entry.tables);
        if (division.postponed.first < division.postponed.last &&
            (entry.kind == elements_of_blocks || entry.kind == postponed_of_blocks))
            entry.call(range(late, division.postponed), entry.tables);
    }
    // Resumes postponed elements: passes of one list find their acceleration, those of another open the next step.
    void resume(const List &acceleration, const List &opening) {
        Clock still = late;
        still.dt = still.finish = still.begin = still.extra = 0.0;
        for (Index p = 0; p < acceleration.count; p++) {
            const Entry &entry = acceleration.entry[p];
            const bool divides = entry.kind == divides_elements;
            if (!divides && division.postponed.first == division.postponed.last) return;
            entry.call(range(still, divides ? all : division.postponed), entry.tables);
        }
        if (clock.goes_on)
            for (Index p = 0; p < opening.count; p++)
                opening.entry[p].call(range(clock, division.postponed), opening.entry[p].tables);
    }

  private:
    Range range(const Clock &at, const ElementList &list) {
        return {at, list.first, list.last, list.first_owner, list.element, list.row, block, &division};
    }
    const Clock &clock;
    Clock late;
    const Index block;
    const ElementList all;
    ElementDivision division;
};

// True if bonds follow elements in a list: they need the results of all elements, not only of their block.
bool begins_anew(const Entry *entry, Index p) {
    return entry[p].kind == bonds_of_blocks && entry[p - 1].kind != bonds_of_blocks;
}

class StepDriver {
  public:
    StepDriver(Index threads, const StepBlocks &blocks, const StepSpan &span)
        : threads(threads), blocks(blocks), span(span) {}

    // Calls the passes of a list in their order.
    void through(const List &list, const Clock &clock) const {
        for (Index p = 0; p < list.count;) {
            const Entry *first = list.entry + p;
            if (goes_by_blocks(*first)) {
                Index last = p;
                do last++;
                while (last < list.count && goes_by_blocks(list.entry[last]) && !begins_anew(list.entry, last));
                by_blocks(first, list.entry + last, clock);
                p = last;
            } else {
                p++;
                if (called_once(first->kind))
                    first->call(Range{clock, 0, 0, 0, nullptr, nullptr, 0, nullptr, threads}, first->tables);
                else if (first->kind == of_elements)
                    by_portions(*first, clock, span.n, elements_of_portion);
                else if (first->kind == of_ranges)
                    by_portions(*first, clock, span.n, most(portions(span.n, threads), elements_of_portion));
                else
                    by_portions(*first, clock, span.m, bonds_of_portion);
            }
        }
    }

    // Resumes the elements that failures have postponed.
    void resume(const List &acceleration, const List &opening, const Clock &clock) const {
        ElementPasses(clock, {0, 0, 0, nullptr, nullptr}, 0).resume(acceleration, opening);
    }

  private:
    void by_portions(const Entry &entry, const Clock &clock, Index count, Index size) const {
        for_each_task(threads, portions(count, size), [&](Index task) {
            const Index first = task * size, last = least(first + size, count);
            entry.call(Range{clock, first, last, last, nullptr, nullptr, task, nullptr}, entry.tables);
        });
    }

    void by_blocks(const Entry *first, const Entry *last, const Clock &clock) const {
        const Index domains = blocks.domain.size() - 1, count = blocks.first_owner.size();
        for_each_task(threads, domains, [&](Index d) {
            for (Index b = blocks.domain(d); b < blocks.domain(d + 1); b++) {
                const Index end = blocks.bond(b + 1);
                const Range bonds = {clock, blocks.bond(b), end, end, nullptr, nullptr, b, nullptr};
                const ElementList list = {blocks.move(b), blocks.move(b + 1), blocks.first_owner(b), blocks.ready.data,
                                          blocks.ready_row.data};
                ElementPasses elements(clock, list, b);
                for (const Entry *entry = first; entry < last; entry++)
                    if (entry->kind == bonds_of_blocks)
                        entry->call(bonds, entry->tables);
                    else if (entry->kind != parts_of_shared)
                        elements.call(*entry);
            }
        });
        const Index shared = blocks.shared.size();
        if (shared == 0) return;
        for_each_task(threads, domains, [&](Index d) {
            const Index begin = shared * d / domains, end = shared * (d + 1) / domains;
            const Index first_owner = within(blocks.shared_first_owner, begin, end);
            ElementPasses elements(clock, {begin, end, first_owner, blocks.shared.data, blocks.shared_row.data}, count);
            for (const Entry *entry = first; entry < last; entry++)
                if (entry->kind != bonds_of_blocks) elements.call(*entry);
        });
    }

    const Index threads;
    const StepBlocks &blocks;
    const StepSpan &span;
};

Clock clock_at(const StepScheme &scheme, Index step) {
    return {scheme.origin + double(step) * scheme.dt, scheme.dt, scheme.finish, scheme.begin, scheme.extra, step, 0, 0, 0};
}

}  // namespace

// Takes the steps of a span, or records the present state without a step; returns how the call has ended.
//
// The acceleration is that of the present state on entry and on return. Where no record and no guard comes between
// two steps, the end of one and the start of the next are one pass over the elements.
Index take_steps(Index threads, const StepPasses &passes, const StepBlocks &blocks, const StepScheme &scheme,
                 const StepSpan &span, const Ledger &ledger) {
    const StepDriver driver(threads, blocks, span);
    const List present(passes.present), opening(passes.opening), travel(passes.travel), forces(passes.forces),
        resume(passes.resume), reopening(passes.reopening), guard(passes.guard), record(passes.record);
    for (Index k = 0; k < span.done.size(); k++) span.done(k) = 0;
    Clock clock = clock_at(scheme, span.step);
    clock.first = 1;
    if (!span.moved) driver.through(present, clock);
    if (span.records_present) {
        if (span.stale) {
            Clock still = clock;
            still.dt = still.finish = still.begin = still.extra = 0.0;
            driver.through(forces, still);
        }
        driver.through(record, clock);
        span.done(step_count::records) = 1;
        return 0;
    }
    Index &done = span.done(step_count::steps), &written = span.done(step_count::records);
    Index &wide = span.done(step_count::wide);
    for (bool paused = true, moved = span.moved; done < span.steps; moved = false) {
        if (!moved) {
            if (paused) driver.through(opening, clock);
            driver.through(travel, clock);
            if (ledger.found(guard_number::out_of_date) != 0) return out_of_date;
        }
        done++;
        clock = clock_at(scheme, span.step + done);
        const bool recorded = span.every > 0 && clock.step % span.every == 0;
        const bool guarded = clock.step % guard_interval == 0 || done == span.steps;
        paused = recorded || guarded;
        clock.goes_on = !paused;
        clock.record = written;
        driver.through(present, clock);
        driver.through(forces, clock);
        driver.resume(resume, reopening, clock);
        if (guarded) {
            driver.through(guard, clock);
            wide = most(wide, ledger.found(guard_number::wide));
            span.done(step_count::lost) = ledger.found(guard_number::lost);
            const Index ending = ledger.found(guard_number::ending);
            if (span.done(step_count::lost) > 0 || ending != 0) return ending;
        }
        if (recorded) {
            driver.through(record, clock);
            written++;
        }
    }
    return 0;
}
BONDEM_CALL(take_steps, "sound not_finite runaway out_of_date")

}  // namespace bondem
