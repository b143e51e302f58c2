#include "app/options/option_set.h"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace app {

Option& Option::required(bool needed) {
    m_option->required(needed);
    return *this;
}

Option& Option::typeName(const std::string& name) {
    m_option->type_name(name);
    return *this;
}

Option& Option::text(const std::string& text) {
    m_option->option_text(text);
    return *this;
}

Option& Option::showDefault() {
    m_option->capture_default_str();
    return *this;
}

Option& Option::group(const std::string& heading) {
    m_option->group(heading);
    return *this;
}

Option& Option::check(Check check) {
    m_option->check(CLI::Validator(std::move(check.fault), std::move(check.wanted)));
    return *this;
}

Option& Option::excludes(Option other) {
    m_option->excludes(other.m_option);
    return *this;
}

Option& Option::needs(Option other) {
    m_option->needs(other.m_option);
    return *this;
}

Option& Option::values(int least, int most) {
    m_option->expected(least, most);
    return *this;
}

Option& Option::oneAtATime() {
    m_option->allow_extra_args(false);
    return *this;
}

template <class T>
Option OptionSet::add(const std::string& names, T& value, const std::string& tip) {
    return Option(m_app->add_option(names, value, tip));
}

template Option OptionSet::add(const std::string&, std::string&, const std::string&);
template Option OptionSet::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option OptionSet::add(const std::string&, float&, const std::string&);
template Option OptionSet::add(const std::string&, double&, const std::string&);
template Option OptionSet::add(const std::string&, int&, const std::string&);
template Option OptionSet::add(const std::string&, std::size_t&, const std::string&);

Option OptionSet::addTo(const std::string& names, std::function<void(const std::string&)> take,
                        const std::string& tip) {
    return Option(m_app->add_option_function<std::string>(names, std::move(take), tip));
}

Option OptionSet::addFlag(const std::string& names, bool& value, const std::string& tip) {
    return Option(m_app->add_flag(names, value, tip));
}

Option OptionSet::addFlag(const std::string& names, std::function<void(bool)> take, const std::string& tip) {
    auto counted = [take = std::move(take)](std::int64_t count) { take(count > 0); };
    return Option(m_app->add_flag_function(names, std::move(counted), tip));
}

bool OptionSet::has(const std::string& name) const {
    return m_app->count(name) > 0;
}

std::vector<std::string> OptionSet::given() const {
    std::vector<std::string> out;
    for (const CLI::Option* option : m_app->get_options()) {
        if (option->count() == 0 || option->get_positional())
            continue;
        const std::string name =
            option->get_lnames().empty() ? "-" + option->get_snames()[0] : "--" + option->get_lnames()[0];
        if (option->get_items_expected_max() == 0) // a flag; "false" is one that was turned off by another name
            out.push_back(option->results().back() == "true" ? name : name + "=" + option->results().back());
        else if (option->get_items_expected_max() == 1)
            out.push_back(name + "=" + option->results().back());
        else {
            out.push_back(name);
            out.insert(out.end(), option->results().begin(), option->results().end());
        }
    }
    return out;
}

void OptionSet::addFooter(std::function<std::string()> text) {
    m_app->footer([before = m_app->get_footer(), text = std::move(text)] { return before + text(); });
    m_app->footer(std::string()); // which would follow
}

} // namespace app
