// Test data: every frame with every weight, and with one thing more that is or is not.
#pragma once

#include "core/surface/definition_text.h"

#include <QTest>

namespace test {

/// Columns frame and weight, as int, and `flag`.
inline void addDefinitionRows(const char* flag) {
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("weight");
    QTest::addColumn<bool>(flag);
    for (const auto& frame : surface::frameNames())
        for (const auto& weight : surface::weightNames())
            for (const bool is : {true, false})
                QTest::addRow("%s %s %s%s", frame.name, weight.name, is ? "" : "not ", flag)
                    << static_cast<int>(frame.value) << static_cast<int>(weight.value) << is;
}

} // namespace test
