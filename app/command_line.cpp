#include "app/command_line.h"

#include "core/base/near_word.h"
#include "core/base/row_of_id.h"
#include "core/base/up_axis.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <unistd.h>

namespace app {

void addCommon(CLI::App& command, CommonOptions& options) {
    command.add_option("--threads", options.threads, "number of threads; 0: all cores. Results never depend on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command.add_flag("--quiet", options.quiet, "print errors only, no progress or messages");
}

void describe(CLI::App& program, CommonOptions& options) {
    program.description("Pointclay sculpts point-set surfaces. Without a subcommand it opens its window.\n"
                        "Lengths are in model units and angles in degrees unless stated otherwise.");
    program.footer("Example: pointclay bunny.ply\nEach subcommand has its own help: pointclay query --help");
    program.set_version_flag("--version", "pointclay " POINTCLAY_VERSION);
    addCommon(program, options);
    program.add_option("MODEL", options.models, "models to open, each in a window");
}

int fail(std::string_view message, int code) {
    std::fprintf(stderr, "pointclay: %.*s\n", static_cast<int>(message.size()), message.data());
    return code;
}

static int failWithoutMemory() {
    return fail("not enough memory; try a smaller model", 1);
}

static const std::terminate_handler usualEnd = std::get_terminate();

/// Destructors of JSON values allocate: where that fails, nobody can catch it.
[[noreturn]] static void terminated() {
    try {
        if (std::current_exception())
            throw;
    } catch (const std::bad_alloc&) {
        ::_exit(failWithoutMemory());
    } catch (...) {
    }
    usualEnd();
    std::abort();
}

int guarded(const std::function<int()>& work) {
    std::set_terminate(terminated);
    try {
        return work();
    } catch (const UsageError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return failWithoutMemory();
    } catch (const std::exception& error) { // base::Error, base::Cancelled and what libraries throw
        return fail(error.what(), 1);
    }
}

/// An axis such as "-z" looks like an option of its own; it becomes "--up=-z".
static std::vector<std::string> withAxes(int argc, char** argv) {
    std::vector<std::string> out;
    for (int k = 0; k < argc; ++k) {
        const std::string word = argv[k];
        if (!out.empty() && out.back() == "--up" && word.starts_with('-') && base::findRow(base::upTable(), word))
            out.back() += "=" + word;
        else
            out.push_back(word);
    }
    return out;
}

/// Long options of the program or the subcommand that was chosen, apart by blanks.
static std::string longOptions(const CLI::App& command) {
    std::string out;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            out += name + " ";
    return out;
}

/// What words that nobody expected may have meant, a line each.
static void suggest(const CLI::App& program) {
    const auto chosen = program.get_subcommands();
    const CLI::App& command = chosen.empty() ? program : *chosen.front();
    for (const std::string& word : program.remaining(true)) {
        if (!word.starts_with("--"))
            continue;
        const std::string name = word.substr(2, word.find('=') - 2);
        if (const std::string near = base::nearWord(name, longOptions(command)); !near.empty())
            std::fprintf(stderr, "Did you mean --%s?\n", near.c_str());
    }
}

/// CLI11's own message, but for words that nobody expected, which it tells last word first.
static std::string failureText(const CLI::App* program, const CLI::Error& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError))
        return CLI::FailureMessage::simple(program, error);
    const std::vector<std::string> words = program->remaining(true);
    return std::string("The following argument") + (words.size() == 1 ? " was" : "s were") +
           " not expected: " + CLI::detail::join(words, " ") + "\nRun with --help for more information.\n";
}

/// The name of an option or argument that was given nothing, as by a script whose variable is not set; else "". It
/// would count as left out: outputs would not be written, and nobody be told.
static std::string givenNothing(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        for (const std::string& value : option->results())
            if (value.empty())
                return option->get_name();
    for (const CLI::App* chosen : command.get_subcommands())
        if (const std::string name = givenNothing(*chosen); !name.empty())
            return name;
    return {};
}

std::optional<int> parse(CLI::App& program, int argc, char** argv) {
    const std::vector<std::string> words = withAxes(argc, argv);
    std::vector<const char*> texts;
    for (const std::string& word : words)
        texts.push_back(word.c_str());
    program.failure_message(failureText);
    try {
        program.parse(static_cast<int>(texts.size()), texts.data());
        const std::string name = givenNothing(program);
        return name.empty() ? std::optional<int>() : fail(name + " is empty; give it a value, or leave it out", 2);
    } catch (const CLI::ParseError& error) {
        if (program.exit(error) == 0)
            return 0;
        suggest(program); // also where the mistyped one is missed as required
        return 2;
    }
}

} // namespace app
