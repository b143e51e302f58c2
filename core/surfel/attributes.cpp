#include "core/surfel/attributes.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace surfel {

std::size_t AttributeLayout::add(const std::string& name, ScalarType type) {
    assert(!find(name));
    m_attributes.push_back({name, type, m_words});
    m_words += wordsOf(type);
    return m_attributes.size() - 1;
}

const Attribute* AttributeLayout::find(const std::string& name) const {
    const auto found = std::find_if(m_attributes.begin(), m_attributes.end(),
                                    [&](const Attribute& attribute) { return attribute.name == name; });
    return found == m_attributes.end() ? nullptr : &*found;
}

std::vector<std::string> AttributeLayout::names() const {
    std::vector<std::string> out{"position"};
    if (normals)
        out.push_back("normal");
    if (colours)
        out.push_back("colour");
    if (masks)
        out.push_back("mask");
    for (const Attribute& attribute : m_attributes)
        out.push_back(attribute.name);
    return out;
}

const AttributeLayoutPtr& AttributeLayout::none() {
    static const AttributeLayoutPtr empty = std::make_shared<const AttributeLayout>();
    return empty;
}

double read(const Attribute& attribute, std::span<const std::uint32_t> words) {
    const std::uint32_t word = words[attribute.firstWord];
    switch (attribute.type) {
    case ScalarType::Int8:
    case ScalarType::Int16:
    case ScalarType::Int32:
        return static_cast<std::int32_t>(word);
    case ScalarType::UInt8:
    case ScalarType::UInt16:
    case ScalarType::UInt32:
        return word;
    case ScalarType::Float32:
        return std::bit_cast<float>(word);
    case ScalarType::Float64:
        break;
    }
    return std::bit_cast<double>(static_cast<std::uint64_t>(words[attribute.firstWord + 1]) << 32 | word);
}

template <class Integer>
static std::uint32_t rounded(double value) {
    using Limits = std::numeric_limits<Integer>;
    if (std::isnan(value))
        return 0;
    const double clamped = std::clamp(std::nearbyint(value), double(Limits::min()), double(Limits::max()));
    return static_cast<std::uint32_t>(static_cast<Integer>(clamped));
}

void write(const Attribute& attribute, std::span<std::uint32_t> words, double value) {
    std::uint32_t& word = words[attribute.firstWord];
    switch (attribute.type) {
    case ScalarType::Int8:
        word = rounded<std::int8_t>(value);
        break;
    case ScalarType::UInt8:
        word = rounded<std::uint8_t>(value);
        break;
    case ScalarType::Int16:
        word = rounded<std::int16_t>(value);
        break;
    case ScalarType::UInt16:
        word = rounded<std::uint16_t>(value);
        break;
    case ScalarType::Int32:
        word = rounded<std::int32_t>(value);
        break;
    case ScalarType::UInt32:
        word = rounded<std::uint32_t>(value);
        break;
    case ScalarType::Float32:
        word = std::bit_cast<std::uint32_t>(static_cast<float>(value));
        break;
    case ScalarType::Float64: {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        word = static_cast<std::uint32_t>(bits);
        words[attribute.firstWord + 1] = static_cast<std::uint32_t>(bits >> 32);
        break;
    }
    }
}

} // namespace surfel
