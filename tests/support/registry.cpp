#include "support/registry.h"

#include "support/crash.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <QMetaMethod>
#include <QTest>
#include <sys/resource.h>
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

/// The laws of a class, in the order in which they run.
QStringList functionsOf(const QMetaObject& meta) {
    QStringList out;
    for (int i = meta.methodOffset(); i < meta.methodCount(); ++i) {
        const QMetaMethod method = meta.method(i);
        const QString name = QString::fromLatin1(method.name());
        const bool special = name.startsWith("init") || name.startsWith("cleanup") || name.endsWith("_data");
        if (method.methodType() == QMetaMethod::Slot && method.parameterCount() == 0 && !special)
            out << name;
    }
    return out;
}

/// The functions of a class but the laws of threads, which cost a twelfth of the time: the optimised build compares the
/// bits, and TSan looks for races. Empty where there is none of these.
QStringList withoutThreads(const QMetaObject& meta) {
    QStringList out;
    bool any = false;
    for (const QString& name : functionsOf(meta)) {
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

/// Processor time in seconds so far, of this process and of those that it started and that have ended.
double processorTime() {
    double out = 0.0;
    for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(whose, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime})
            out += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    return out;
}

/// Runs the functions one by one, each with what its class begins and ends with, and prints what each has cost.
int timed(QObject& object, const QStringList& functions, const char* program) {
    int failed = 0;
    for (const QString& function : functions) {
        const double before = processorTime();
        failed += QTest::qExec(&object, {program, function, "-silent", "-nocrashhandler"});
        std::printf("TIME   : %8.2f s %s::%s()\n", processorTime() - before, object.metaObject()->className(),
                    qPrintable(function));
        std::fflush(stdout);
    }
    return failed;
}

} // namespace

int main(int argc, char** argv) {
    test::tellCrashes();
    std::unique_ptr<QCoreApplication> application(makeApplication(argc, argv));
    QStringList words, options;
    for (int i = 1; i < argc; ++i)
        (options.isEmpty() && argv[i][0] != '-' ? words : options) << argv[i];
    const bool listing = options.value(0) == "-list", timing = options.value(0) == "-times";
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
        if (timing)
            failed += timed(*object, chosen.isEmpty() ? functionsOf(meta) : chosen, argv[0]);
        else
            failed += QTest::qExec(object.get(), QStringList{argv[0], "-nocrashhandler"} + chosen + options);
    }
    if (!listing && (run == 0 || functions < wanted)) {
        std::fprintf(stderr, "a test that was asked for is not there\n");
        return 1;
    }
    return failed;
}
