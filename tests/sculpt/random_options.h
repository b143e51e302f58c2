// Values of a stroke's options, whatever kind they are, drawn from the rows of their table.
#pragma once

#include "core/base/random.h"
#include "core/sculpt/stroke/stroke_options.h"

#include <cmath>

namespace test {

/// Where in its range a number is wanted. Choices and switches take their first, their last or any value.
enum class Part { Low, High, Within };

namespace detail {

inline double numberIn(const sculpt::OptionRange& range, base::Random& random, Part part) {
    if (part != Part::Within)
        return part == Part::Low ? range.min : range.max;
    return range.max < 1e6 ? random.uniform(range.min, range.max) : std::pow(10.0, random.uniform(-30, 30));
}

struct Draw {
    const sculpt::StrokeOption& option;
    base::Random& random;
    Part part;

    bool flag() const { return part == Part::Low ? false : part == Part::High || random.below(2); }
    void operator()(float& out) const { out = sculpt::storedOf(option, numberIn(option.range, random, part)); }
    void operator()(int& out) const { out = static_cast<int>(std::round(numberIn(option.range, random, part))); }
    void operator()(bool& out) const { out = flag(); }
    void operator()(std::string& out) const {
        out = part == Part::Low ? "" : "/a folder/ö" + std::to_string(random.below(99)) + ".png";
    }
    void operator()(sculpt::CurvePoints& out) const {
        const std::size_t most = sculpt::BrushCurve::maxPoints;
        const std::size_t count = part == Part::Low ? 2 : part == Part::High ? most : 2 + random.below(most - 1);
        out.clear();
        for (std::size_t k = 0; k < count; ++k)
            out.push_back({float((double(k) + random.uniform(0, 0.9)) / double(count)), float(random.uniform())});
    }
    void operator()(sculpt::MirrorPlanes& out) const { out = {flag(), flag(), flag()}; }
    template <class Choice>
    void operator()(Choice& out) const {
        const auto rows = sculpt::choicesOf<Choice>();
        out = (part == Part::Low    ? rows.front()
               : part == Part::High ? rows.back()
                                    : rows[random.below(rows.size())])
                  .value;
    }
};

} // namespace detail

inline void draw(const sculpt::StrokeOption& option, base::Random& random, Part part, sculpt::StrokeSettings& out) {
    std::visit([&](auto field) { detail::Draw{option, random, part}(at(out, field)); }, option.field);
}

/// Every option of these scopes.
inline void drawAll(std::initializer_list<sculpt::Scope> scopes, base::Random& random, Part part,
                    sculpt::StrokeSettings& out) {
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        if (std::find(scopes.begin(), scopes.end(), option.scope) != scopes.end())
            draw(option, random, part, out);
}

/// A value outside of the range of a number, as it is shown; nothing where the option is no number.
inline std::vector<double> outside(const sculpt::StrokeOption& option) {
    const bool number = std::holds_alternative<float sculpt::StrokeSettings::*>(option.field) ||
                        std::holds_alternative<int sculpt::Symmetry::*>(option.field);
    const sculpt::OptionRange& range = option.range;
    if (!number)
        return {};
    std::vector<double> out{range.min - 1};
    if (range.max < sculpt::OptionRange::largest)
        out.push_back(range.max + 1);
    return out;
}

} // namespace test
