// Says in a layout that one of the fixed channels means something.
#pragma once

#include "core/surfel/attributes.h"

namespace sculpt {

/// For tree::Edit::layout: a copy of `layout` with the flag set; null where it is set already.
inline surfel::AttributeLayoutPtr withFlag(const surfel::AttributeLayoutPtr& layout,
                                           bool surfel::AttributeLayout::*flag) {
    if ((*layout).*flag)
        return {};
    auto out = std::make_shared<surfel::AttributeLayout>(*layout);
    (*out).*flag = true;
    return out;
}

} // namespace sculpt
