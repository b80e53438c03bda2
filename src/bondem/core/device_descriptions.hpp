// How the tables and the passes of a device describe themselves to Python.
#pragma once
#include "cell_descriptions.hpp"
#include "contact_descriptions.hpp"
#include "crack_descriptions.hpp"
#include "damage_descriptions.hpp"
#include "gpu/for_each.hpp"
#include "gpu/index_passes.hpp"
#include "step_descriptions.hpp"

namespace bondem {

// Name and tables of a pass over an index. Its loop on the CPU is in `loops.cpp`.
template <auto pass> struct IndexPass;
template <class... Tables, void (*pass)(Index, const Tables &...)> struct IndexPass<pass> {
    static PassDescription described(const char *name) {
        static_assert(sizeof...(Tables) <= tables_of_index_pass);
        return {name, "", nullptr, TableNames<Tables...>::names, Index(sizeof...(Tables))};
    }
};

}  // namespace bondem
