// Which surfels of two solids stay when they are put together (solid/README 2.2). Inside this room only.
#pragma once

#include "core/solid/combine.h"

namespace solid {

/// Does a surfel of the model stay? `side`: of the operand, as sidesOf tells it. What coincides stays once where both
/// bound the result from the same side, and else not at all.
inline bool staysOfModel(Operation operation, std::int8_t side) {
    switch (operation) {
    case Operation::Union:
        return side == 1 || side == 2;
    case Operation::Difference:
        return side == 1 || side == -2;
    default:
        return side == -1 || side == 2;
    }
}

inline bool staysOfOperand(Operation operation, std::int8_t side) {
    return side == (operation == Operation::Union ? 1 : -1);
}

} // namespace solid
