// Registration of passes where they are defined. The names of their tables follow from the types of the functions.
//
//     BONDEM_PASS(add_beam_loads, bonds_of_blocks, "ends pose; adds sums")    after a pass of a step
//     BONDEM_CALL(conjugate_gradients, "converged stuck")    after a pass that Python calls: names of outcomes, or ""
//
// A pass of a step states the parts of the step that it runs over (`PassKind`), and the columns of elements that it
// reads and writes (docs/decisions/0065-columns-that-passes-read-and-write.md). Each pass adds a node to a list as
// the library is loaded. Nodes are never destroyed and use nothing of the C++ library. Python reads the list and
// finds passes by their names, so that the order of the list does not matter. The program of a GPU has no such list.
#pragma once
#include "steps.hpp"
#include "table_names.hpp"

namespace bondem {

// Description of a pass that Python reads.
struct PassDescription {
    const char *name;
    const char *words;  // columns that a pass of a step reads and writes; outcomes of one that Python calls
    Index kind;  // of a pass of a step (`PassKind`); else -1
    void *address;
    const char *const *tables;
    Index count;
    const PassDescription *next;
};

template <class... Tables> struct TableNames {
    static constexpr const char *names[] = {TableName<Tables>::name..., nullptr};
};

// Returns the description of a pass of a step, which is called with a range and with pointers to its tables.
template <auto pass, class... Tables>
PassDescription described(const char *name, PassKind kind, const char *columns, void (*)(const Range &, const Tables &...)) {
    void *const address = reinterpret_cast<void *>(Called<pass>::call);
    return {name, columns, kind, address, TableNames<Tables...>::names, Index(sizeof...(Tables)), nullptr};
}
// Returns the description of another pass, which is called with the number of threads and a pointer to each table.
template <auto pass, class... Tables>
PassDescription described(const char *name, const char *outcomes, Index (*)(Index, const Tables &...)) {
    void *const address = reinterpret_cast<void *>(pass);
    return {name, outcomes, -1, address, TableNames<Tables...>::names, Index(sizeof...(Tables)), nullptr};
}

struct Registered {
    PassDescription pass;

    static const PassDescription *&first() {
        static const PassDescription *head = nullptr;
        return head;
    }
    explicit Registered(const PassDescription &given) : pass(given) {
        pass.next = first();
        first() = &pass;
    }
};

// The forms with _AS register instances of a template, whose names contain its argument.
#if defined(__CUDACC__)
#define BONDEM_PASS_AS(name, kind, columns, ...)
#define BONDEM_CALL_AS(name, outcomes, ...)
#else
#define BONDEM_PASS_AS(name, kind, columns, ...) \
    static const Registered registered_##name(described<&__VA_ARGS__>(#name, kind, columns, &__VA_ARGS__));
#define BONDEM_CALL_AS(name, outcomes, ...) \
    static const Registered registered_##name(described<&__VA_ARGS__>(#name, outcomes, &__VA_ARGS__));
#endif
#define BONDEM_PASS(name, kind, columns) BONDEM_PASS_AS(name, kind, columns, name)
#define BONDEM_CALL(name, outcomes) BONDEM_CALL_AS(name, outcomes, name)

}  // namespace bondem
