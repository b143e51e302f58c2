#include "core/base/large_memory.h"

#include "support/registry.h"

#include <cstdint>
#include <cstring>
#include <new>
#include <QTest>

class LargeMemoryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void allOfItMayBeWritten();
    void impossibleSizesThrow();
};

void LargeMemoryTest::allOfItMayBeWritten() {
    for (const std::size_t bytes :
         {std::size_t(1), std::size_t(5000), std::size_t(3) << 21, (std::size_t(1) << 21) + 1}) {
        void* memory = base::allocateLarge(bytes);
        QVERIFY(memory && reinterpret_cast<std::uintptr_t>(memory) % 4096 == 0);
        std::memset(memory, 7, bytes);
        QCOMPARE(static_cast<const unsigned char*>(memory)[bytes - 1], static_cast<unsigned char>(7));
        base::freeLarge(memory);
    }
}

void LargeMemoryTest::impossibleSizesThrow() {
    for (const std::size_t bytes : {SIZE_MAX, SIZE_MAX - 100})
        QVERIFY_EXCEPTION_THROWN(base::freeLarge(base::allocateLarge(bytes)), std::bad_alloc);
}

static const test::Registered<LargeMemoryTest> registered;
#include "large_memory_test.moc"
