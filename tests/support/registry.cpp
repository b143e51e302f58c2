#include "support/registry.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <QMetaMethod>
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

namespace {

/// What the words of the command line ask of a class: all of it, some functions, or nothing.
struct Wish {
    bool whole = false;
    QStringList functions;
};

/// Words are classes or Class.function; a bare word after a single class is a function of it.
Wish wishFor(const QString& name, const QStringList& words) {
    if (words.isEmpty())
        return {true, {}};
    Wish out;
    for (const QString& word : words) {
        const QStringList parts = word.split('.');
        if (parts[0] == name && parts.size() == 1)
            out.whole = true;
        else if (parts[0] == name)
            out.functions << parts[1];
    }
    if (words[0] == name && words.size() > 1 && words[1][0].isLower())
        return {false, words.mid(1)};
    return out;
}

#ifdef __SANITIZE_ADDRESS__
constexpr bool looksAtMemory = true;
#else
constexpr bool looksAtMemory = false;
#endif

/// The functions of a class but the laws of threads, which cost a twelfth of the time: the optimised build compares the
/// bits, and TSan looks for races. Empty where there is none of these.
QStringList withoutThreads(const QMetaObject& meta) {
    QStringList out;
    bool any = false;
    for (int i = meta.methodOffset(); i < meta.methodCount(); ++i) {
        const QMetaMethod method = meta.method(i);
        const QString name = QString::fromLatin1(method.name());
        const bool special = name.startsWith("init") || name.startsWith("cleanup") || name.endsWith("_data");
        if (method.methodType() != QMetaMethod::Slot || method.parameterCount() > 0 || special)
            continue;
        if (name.contains("thread", Qt::CaseInsensitive)) {
            std::printf("SKIP   : %s::%s() threads are for the other builds, not under a sanitizer of memory\n",
                        meta.className(), qPrintable(name));
            any = true;
        } else {
            out << name;
        }
    }
    return any ? out : QStringList();
}

} // namespace

int main(int argc, char** argv) {
    std::unique_ptr<QCoreApplication> application(makeApplication(argc, argv));
    QStringList words, options;
    for (int i = 1; i < argc; ++i)
        (options.isEmpty() && argv[i][0] != '-' ? words : options) << argv[i];
    const bool listing = options.value(0) == "-list";
    int failed = 0, run = 0, functions = 0, wanted = 0;
    for (const QString& word : words)
        wanted += word.contains('.') ? 1 : 0;
    for (const auto& make : test::factories()) {
        const std::unique_ptr<QObject> object(make());
        const QMetaObject& meta = *object->metaObject();
        if (listing) {
            std::puts(meta.className());
            continue;
        }
        Wish wish = wishFor(meta.className(), words);
        if (!wish.whole && wish.functions.isEmpty())
            continue;
        ++run;
        functions += static_cast<int>(wish.functions.size());
        const QStringList chosen = !wish.whole ? wish.functions : looksAtMemory ? withoutThreads(meta) : QStringList();
        failed += QTest::qExec(object.get(), QStringList{argv[0]} + chosen + options);
    }
    if (!listing && (run == 0 || functions < wanted)) {
        std::fprintf(stderr, "a test that was asked for is not there\n");
        return 1;
    }
    return failed;
}
