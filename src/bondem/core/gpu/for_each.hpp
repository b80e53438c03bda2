// Calls of a pass for each index, such as each bond, by threads of a GPU. In tests loops on the CPU simulate the GPU.
#pragma once
#include "../steps.hpp"

namespace bondem {

// Largest number of tables of a pass.
constexpr Index tables_of_index_pass = 8;

// A pass that is another function. NVRTC compiles every function whose address a constant contains, needed or not;
// `As` contains the address in its type instead.
template <auto pass> struct As {
    constexpr auto function() const { return pass; }
};
template <auto pass> constexpr As<pass> as;
// The function of a pass, which is that function itself or `As`.
template <class... Arguments> constexpr auto function_of(void (*pass)(Arguments...)) { return pass; }
template <class Pass> constexpr auto function_of(const Pass &pass) -> decltype(pass.function()) {
    return pass.function();
}

template <auto pass> struct ForEach;
template <class... Tables, void (*pass)(Index, const Tables &...)> struct ForEach<pass> {
    // Tables are read once, because no pass writes the tables themselves.
    template <Index... n> static void with(Index k, const void *const *tables, Numbers<n...>) {
        on(k, Tables(*static_cast<const Tables *>(tables[n]))...);
    }
    static void on(Index k, const Tables... tables) { pass(k, tables...); }
    static void at(Index k, const void *const *tables) {
        with(k, tables, typename CountTo<sizeof...(Tables)>::type{});
    }
    // Loops over all indices, unless a flag is given and not 0. A count below 0 runs from the last index to the
    // first, by which tests find passes that depend on the order.
    static Index on_host(Index count, const Index *halted, const void *const *tables) {
        if (halted && *halted) return 0;
        for (Index k = 0; k < count; k++) at(k, tables);
        for (Index k = -count - 1; k >= 0; k--) at(k, tables);
        return 0;
    }
};

}  // namespace bondem
