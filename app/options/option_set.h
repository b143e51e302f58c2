// What a subcommand takes: arguments, options and flags, each with the sentence of its help and the variable that it is
// written to. CLI11 does the work behind it; its header takes longer to compile than most of the files that need it, so
// that only few read it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace app {

/// What a value has to be.
struct Check {
    std::function<std::string(const std::string& value)> fault; ///< "" where the value will do, else a sentence
    std::string wanted = {};                                    ///< for help
};

/// A row of help. A handle that is copied freely and lives no longer than its set.
class Option {
  public:
    explicit Option(CLI::Option* option) : m_option(option) {}

    Option& required(bool needed = true);
    /// What stands behind the name in help: "FILE".
    Option& typeName(const std::string& name);
    /// All that stands behind the name in help.
    Option& text(const std::string& text);
    /// Help tells the present value of the variable.
    Option& showDefault();
    Option& group(const std::string& heading);
    Option& check(Check check);
    Option& excludes(Option other);
    Option& needs(Option other);
    /// So many values at once.
    Option& values(int least, int most);
    /// Given more than once, each time with one value.
    Option& oneAtATime();

  private:
    CLI::Option* m_option;
};

/// A handle that is copied freely and lives no longer than the parser.
class OptionSet {
  public:
    OptionSet(CLI::App& app) : m_app(&app) {}

    /// `names` are "-o,--output", or "MODEL" for an argument. `value` has to outlive the parser. For the types that
    /// option_set.cpp names.
    template <class T>
    Option add(const std::string& names, T& value, const std::string& tip);
    Option addTo(const std::string& names, std::function<void(const std::string& value)> take, const std::string& tip);
    Option addFlag(const std::string& names, bool& value, const std::string& tip);
    /// `take` is told whether it is on: "--grid,!--no-grid" can say both.
    Option addFlag(const std::string& names, std::function<void(bool on)> take, const std::string& tip);

    /// Whether the arguments have it.
    bool has(const std::string& name) const;
    /// The options that the arguments have, as they would be written again; arguments without a name are left out.
    std::vector<std::string> given() const;
    /// `text` is made when help is asked for, and without a last line's end.
    void addFooter(std::function<std::string()> text);

  private:
    CLI::App* m_app;
};

} // namespace app
