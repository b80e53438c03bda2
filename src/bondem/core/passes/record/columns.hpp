// Columns of a record of the history before the gauges.
#pragma once
#include "../../scalars.hpp"

namespace bondem::column {

enum : Index {
    time, translation, rotation, normal, shear, bending, twisting, contact, work, loss, friction, non_local, released, plastic,
    crushing, fixed_columns
};

}  // namespace bondem::column
