// Files and models for the tests of this room.
#pragma once

#include "core/base/random.h"
#include "core/io/formats.h"

#include <bit>
#include <fstream>
#include <iterator>
#include <QTemporaryDir>
#include <QTest>
#include <string>

namespace test {

/// A folder of its own that goes away with the object.
class Folder {
  public:
    std::filesystem::path path(const std::string& name) const {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    std::filesystem::path write(const std::string& name, const std::string& content) const {
        std::ofstream(path(name), std::ios::binary) << content;
        return path(name);
    }
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path("")), {}));
    }

  private:
    QTemporaryDir m_folder;
};

inline std::string contentOf(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The message of the base::Error that reading throws; empty where it does not.
inline std::string refusal(const std::filesystem::path& path) {
    try {
        io::read(path);
    } catch (const base::Error& error) {
        return error.message();
    }
    return {};
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline bool anyContains(const std::vector<std::string>& texts, const std::string& part) {
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) { return contains(text, part); });
}

inline bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
inline bool sameBits(const base::Vec3f& a, const base::Vec3f& b) {
    return sameBits(a.x, b.x) && sameBits(a.y, b.y) && sameBits(a.z, b.z);
}
inline bool sameBits(const surfel::Surfel& a, const surfel::Surfel& b) {
    return sameBits(a.position, b.position) && sameBits(a.normal, b.normal) && sameBits(a.support, b.support) &&
           a.colour == b.colour && sameBits(a.mask, b.mask);
}

/// Whether surfels, attributes, layout and origin are the same to the last bit.
inline bool sameBits(const io::FileModel& a, const io::FileModel& b) {
    if (a.points.size() != b.points.size() || !(*a.points.layout == *b.points.layout) || !(a.origin == b.origin) ||
        a.points.extra != b.points.extra || a.hasSupports != b.hasSupports)
        return false;
    for (std::size_t i = 0; i < a.points.size(); ++i)
        if (!sameBits(a.points.items[i], b.points.items[i]))
            return false;
    return true;
}

/// Some finite float of any size, zero and negative zero among them.
inline float anyFloat(base::Random& random) {
    if (random.below(10) == 0)
        return random.below(2) == 0 ? 0.0f : -0.0f;
    return static_cast<float>(random.uniform(-1, 1) * std::pow(10.0, random.uniform(-12, 3)));
}

inline base::Vec3f anyVector(base::Random& random) {
    const float x = anyFloat(random), y = anyFloat(random);
    return {x, y, anyFloat(random)};
}

constexpr surfel::ScalarType allTypes[] = {
    surfel::ScalarType::Int8,  surfel::ScalarType::UInt8,  surfel::ScalarType::Int16,   surfel::ScalarType::UInt16,
    surfel::ScalarType::Int32, surfel::ScalarType::UInt32, surfel::ScalarType::Float32, surfel::ScalarType::Float64};

/// Some value that the type holds exactly.
inline double anyValue(surfel::ScalarType type, base::Random& random) {
    switch (type) {
    case surfel::ScalarType::Int8:
        return static_cast<std::int8_t>(random.next());
    case surfel::ScalarType::UInt8:
        return static_cast<std::uint8_t>(random.next());
    case surfel::ScalarType::Int16:
        return static_cast<std::int16_t>(random.next());
    case surfel::ScalarType::UInt16:
        return static_cast<std::uint16_t>(random.next());
    case surfel::ScalarType::Int32:
        return static_cast<std::int32_t>(random.next());
    case surfel::ScalarType::UInt32:
        return static_cast<std::uint32_t>(random.next());
    case surfel::ScalarType::Float32:
        return anyFloat(random);
    case surfel::ScalarType::Float64:
        break;
    }
    return random.uniform(-1, 1) * std::pow(10.0, random.uniform(-200, 200));
}

/// A model with random channels, attributes of random types, and random values in all of them.
inline io::FileModel randomModel(base::Random& random, std::size_t count) {
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = random.below(2) == 0;
    layout->oriented = layout->normals && random.below(2) == 0;
    layout->colours = random.below(2) == 0;
    layout->masks = random.below(2) == 0;
    const std::size_t attributes = random.below(6);
    for (std::size_t a = 0; a < attributes; ++a)
        layout->add("attribute_" + std::to_string(a), allTypes[random.below(8)]);
    model.points.layout = layout;
    model.hasSupports = random.below(2) == 0;
    if (random.below(2) == 0)
        model.origin = {random.uniform(-1e7, 1e7), std::round(random.uniform(-1e6, 1e6)), random.uniform(-1e3, 1e3)};
    for (std::size_t i = 0; i < count; ++i) {
        surfel::Surfel s;
        s.position = anyVector(random);
        if (layout->normals && random.below(20) != 0)
            s.normal = base::cast<float>(random.unitVector());
        if (layout->colours)
            s.colour = static_cast<surfel::Colour>(random.next());
        if (layout->masks)
            s.mask = static_cast<float>(random.uniform());
        if (model.hasSupports)
            s.support = static_cast<float>(random.uniform(1e-3, 1e3));
        std::vector<std::uint32_t> words(layout->words());
        for (const surfel::Attribute& attribute : layout->attributes())
            surfel::write(attribute, words, anyValue(attribute.type, random));
        model.points.append(s, words);
    }
    return model;
}

} // namespace test
