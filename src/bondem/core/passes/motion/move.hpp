#pragma once
#include "../../steps.hpp"

namespace bondem {

// Elements that own no row of the boundary close the step, and open the next.
void move_elements(const Turn &turn, const Moving &all, const StepCut &cut);
// Elements that own no row of the boundary close the step against what resists their motion, and open the next.
void move_resisted(const Turn &turn, const Moving &all, const StepCut &cut, const Resistance &resistance);
// Elements that own rows of the boundary close the step, and open the next.
void move_rows(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows);
// Elements that own rows of the boundary close the step against what resists their motion, and open the next.
void move_resisted_rows(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows,
                        const Resistance &resistance);
// All elements open a step after a pause; none owns a row of the boundary.
void open_elements(const Turn &turn, const Moving &all);
// All elements open a step after a pause; some own rows of the boundary.
void open_elements_and_rows(const Turn &turn, const Moving &all, const Rows &rows);
// Elements of a list that own no row of the boundary open a step.
void reopen_elements(const Turn &turn, const Moving &all);
// Elements of a list that own rows of the boundary open a step.
void reopen_rows(const Turn &turn, const Moving &all, const Rows &rows);

}  // namespace bondem
