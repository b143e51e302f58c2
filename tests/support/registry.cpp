#include "support/registry.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <QTest>
#include <vector>

namespace test {

static std::vector<Factory>& factories() {
    static std::vector<Factory> list;
    return list;
}

void add(Factory factory) {
    factories().push_back(std::move(factory));
}

std::string dataFolder() {
    const char* folder = std::getenv("POINTCLAY_DATA");
    return folder ? folder : "";
}

unsigned long long seed() {
    const char* text = std::getenv("POINTCLAY_SEED");
    return text ? std::strtoull(text, nullptr, 10) : 20260101ULL;
}

} // namespace test

/// Window tests need a QApplication; they define this function, other rooms leave it out.
[[gnu::weak]] QCoreApplication* makeApplication(int& argc, char** argv) {
    return new QCoreApplication(argc, argv);
}

int main(int argc, char** argv) {
    std::unique_ptr<QCoreApplication> application(makeApplication(argc, argv));
    const QString only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
    QStringList arguments{argv[0]};
    for (int i = only.isEmpty() ? 1 : 2; i < argc; ++i)
        arguments << argv[i];
    int failed = 0;
    int run = 0;
    for (const auto& make : test::factories()) {
        std::unique_ptr<QObject> object(make());
        if (!only.isEmpty() && only != object->metaObject()->className())
            continue;
        if (arguments.size() > 1 && arguments[1] == "-list") {
            std::puts(object->metaObject()->className());
            continue;
        }
        ++run;
        failed += QTest::qExec(object.get(), arguments);
    }
    if (run == 0 && !(arguments.size() > 1 && arguments[1] == "-list")) {
        std::fprintf(stderr, "no test class ran\n");
        return 1;
    }
    return failed;
}
