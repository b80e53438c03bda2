// How the tables of a step, and the passes that a step is composed of, describe themselves to Python.
#pragma once
#include "contact_descriptions.hpp"
#include "described_tables.hpp"
#include "passes/beams/beam_loads.hpp"
#include "passes/beams/beam_report.hpp"
#include "damage_descriptions.hpp"
#include "passes/boundary/rows.hpp"
#include "passes/motion/body_forces.hpp"
#include "passes/motion/move.hpp"
#include "passes/motion/sums.hpp"
#include "passes/record/record.hpp"
#include "steps.hpp"

namespace bondem {

struct StepPassDescription {
    const char *name;
    Index kind;
    void *address;  // of a function of a turn and of pointers to its tables
    const char *const *tables;
    Index count;
};

template <class... Tables>
StepPassDescription described(const char *name, PassKind kind, PassFunction call, void (*)(const Turn &, const Tables &...)) {
    return {name, kind, reinterpret_cast<void *>(call), TableNames<Tables...>::names, Index(sizeof...(Tables))};
}

}  // namespace bondem
