// What `query` answers on complexes (core/complexes/complex.h), in double whatever the precision asked for.
#pragma once

#include "app/query_columns.h"
#include "core/complexes/complex.h"

namespace app {

/// In parallel.
void answerOnComplex(const complexes::Complex& complex, const Question& question, std::span<const base::Vec3d> x,
                     std::span<Answer> out);

} // namespace app
