// What a model's surfels carry beside the fixed channels, and which of the fixed channels came with meaning.
//
// Unknown properties of a file ("scan", "confidence", "intensity") become further attributes: kept bit for bit in
// 32-bit words beside the surfel, written back under their names and types, interpolated where a new surfel is born. A
// layout is immutable and shared by all blocks and versions of a model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace surfel {

/// The scalar types of PLY; 8-byte types take two words (low first), smaller integers are widened to one.
enum class ScalarType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

constexpr std::size_t wordsOf(ScalarType type) {
    return type == ScalarType::Float64 ? 2 : 1;
}
constexpr bool isReal(ScalarType type) {
    return type >= ScalarType::Float32;
}

struct Attribute {
    std::string name;
    ScalarType type = ScalarType::Float32;
    std::size_t firstWord = 0;

    bool operator==(const Attribute&) const = default;
};

class AttributeLayout;
using AttributeLayoutPtr = std::shared_ptr<const AttributeLayout>;

class AttributeLayout {
  public:
    bool normals = false;  ///< surfels have unit normals
    bool oriented = false; ///< and their signs agree over the surface
    bool colours = false;  ///< the colour channel came from a file or a tool
    bool masks = false;    ///< the mask channel came from a file or a tool

    bool operator==(const AttributeLayout&) const = default;

    const std::vector<Attribute>& attributes() const { return m_attributes; }
    std::size_t words() const { return m_words; }
    /// Appends an attribute and returns its index. REQUIRES: no other of that name.
    std::size_t add(const std::string& name, ScalarType type);
    /// The attribute of that name, or null.
    const Attribute* find(const std::string& name) const;
    /// Names of all that a surfel carries: the fixed channels with meaning, then the further attributes.
    std::vector<std::string> names() const;

    /// The shared layout without anything.
    static const AttributeLayoutPtr& none();

  private:
    std::vector<Attribute> m_attributes;
    std::size_t m_words = 0;
};

/// Value of one attribute in a surfel's words; float32 and all integers are exact in double.
double read(const Attribute& attribute, std::span<const std::uint32_t> words);
/// Stores `value`, rounded and clamped to the attribute's type.
void write(const Attribute& attribute, std::span<std::uint32_t> words, double value);

} // namespace surfel
