#pragma once
#include "../../steps.hpp"

namespace bondem {

// Elements that own no row close the step, and open the next; with what resists their motion, or without.
void move_elements(const Turn &turn, const Moving &all, const StepCut &cut);
void move_resisted(const Turn &turn, const Moving &all, const StepCut &cut, const Resistance &resistance);
// Elements that own rows of the boundary do so.
void move_rows(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows);
void move_resisted_rows(const Turn &turn, const Moving &all, const StepCut &cut, const Rows &rows,
                        const Resistance &resistance);
// All elements open a step after a pause.
void open_elements(const Turn &turn, const Moving &all);
void open_elements_and_rows(const Turn &turn, const Moving &all, const Rows &rows);
// Elements of a list open a step: those that own no row, and those that do.
void reopen_elements(const Turn &turn, const Moving &all);
void reopen_rows(const Turn &turn, const Moving &all, const Rows &rows);

}  // namespace bondem
