// The passes over an index: what a thread of a device does, by number. `X(pass)` is called for each.
#pragma once
#include "beams.hpp"
#include "boundary.hpp"
#include "motion.hpp"
#include "record.hpp"

#define BONDEM_INDEX_PASSES(X)    \
    X(set_clock)                  \
    X(count_record)               \
    X(clear_row)                  \
    X(follow_loads_of_row)        \
    X(follow_all_couples)         \
    X(follow_drive)               \
    X(follow_body_group)          \
    X(open_element)               \
    X(open_element_or_row)        \
    X(open_work_of_body)          \
    X(load_beam)                  \
    X(load_alike_beam)            \
    X(load_dashpot)               \
    X(gather_loads)               \
    X(gather_dashpots)            \
    X(add_body_force)             \
    X(add_work_of_body)           \
    X(move_gathered)              \
    X(move_gathered_resisted)     \
    X(move_gathered_row)          \
    X(move_gathered_resisted_row) \
    X(move_summed)                \
    X(move_summed_resisted)       \
    X(move_summed_row)            \
    X(move_summed_resisted_row)   \
    X(check_portion)              \
    X(sum_portion_of_beams)       \
    X(sum_portion_of_elements)    \
    X(sum_portion_of_works)       \
    X(fold_portions)              \
    X(write_sum)                  \
    X(read_part_of_gauge)         \
    X(write_gauge)
