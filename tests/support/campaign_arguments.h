// The command line of a campaign (tests/README.md): words that are needed, then numbers that may be left out. What is
// not like that, `--help` included, ends the program with the usage and code 2, before it takes an hour.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace test {

class CampaignArguments {
  public:
    CampaignArguments(int argc, char** argv, const char* usage, int least)
        : m_argc(argc), m_argv(argv), m_usage(usage) {
        if (argc <= least || (argc > 1 && std::string_view(argv[1]).starts_with("--")))
            leave();
    }

    const char* word(int i) const { return m_argv[i]; }
    bool has(int i) const { return i < m_argc; }

    template <class Number>
    Number number(int i, Number otherwise) const {
        if (!has(i))
            return otherwise;
        const std::string_view text = m_argv[i];
        Number out{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
        if (error != std::errc{} || end != text.data() + text.size() || out < Number{})
            leave();
        return out;
    }

  private:
    [[noreturn]] void leave() const {
        std::fprintf(stderr, "usage: %s\n", m_usage);
        std::exit(2);
    }

    int m_argc;
    char** m_argv;
    const char* m_usage;
};

} // namespace test
