// Columns of a record before the gauges: time [s], and the energy ledger [J].
#pragma once
#include "../../scalars.hpp"

namespace bondem::column {

enum Name : Index {
    time, translation, rotation, normal, shear, bending, twisting, contact, work, loss, friction, non_local, fracture, plastic,
    fixed_columns
};

}  // namespace bondem::column
