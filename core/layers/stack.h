// The layers of a model as a list: names, strengths, order, and which of them strokes act on. What a layer did to each
// surfel stands in the surfel's further attributes (layer_words.h); both together are a model with layers
// (layers/README 1).
//
// A value. A model without layers has an empty stack and none of those attributes. In files the stack is comment lines:
//
//     pointclay-layer 3 strength 0.5 visible 1 active 0 name Wrinkles        lowest first
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace layers {

/// Range of strengths.
constexpr float leastStrength = -1, mostStrength = 2;
/// Strokes act on layers that show at least this much of what they hold, of either sign.
constexpr float leastRecording = 0.05f;

struct Layer {
    std::uint32_t id = 0; ///< > 0, never the same for two layers of a model; names its attributes
    std::string name;
    float strength = 1;
    bool visible = true;

    /// How much of what it holds is shown.
    float weight() const { return visible ? strength : 0; }
    bool operator==(const Layer&) const = default;
};

struct Stack {
    std::vector<Layer> layers; ///< lowest first
    std::uint32_t active = 0;  ///< id of the layer that strokes act on; 0: the surface below all of them

    bool empty() const { return layers.empty(); }
    /// Place of a layer from below; -1 where there is no such layer.
    int indexOf(std::uint32_t id) const;
    int indexOf(std::string_view name) const;
    /// Place of the layer that strokes act on; -1: below all of them.
    int target() const { return indexOf(active); }
    /// Adds a layer on top of all others and makes it the active one.
    Layer& add(const std::string& name);
    bool operator==(const Stack&) const = default;
};

/// Names that files can keep: not empty, no control characters, no blanks at the ends, at most 64 bytes.
bool isName(std::string_view name);

/// The comment lines of a stack, and the stack that comment lines tell of; these are taken out. Lines that are not
/// understood, or name a layer twice, stay what they are.
std::vector<std::string> linesOf(const Stack& stack);
Stack takeLines(std::vector<std::string>& comments);

} // namespace layers
