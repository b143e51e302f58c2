// A part of a model (solid/README 4.4). Inside this room only.
#pragma once

#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <algorithm>

namespace solid {

/// A part of a model, as a list of flags and a surface of its own.
class Part {
  public:
    Part(const surface::Surface& surface, const tree::Selection& selected)
        : m_surface(surface), m_in(surface.tree().size(), 0) {
        const std::vector<std::size_t> first = surface.tree().firstSurfels();
        for (const tree::SelectedBlock& each : selected)
            for (std::size_t slot = 0; slot < each.slots.size(); ++slot)
                if (each.slots[slot])
                    m_in[first[each.block] + slot] = 1;
    }
    std::size_t size() const { return static_cast<std::size_t>(std::count(m_in.begin(), m_in.end(), 1)); }
    bool holds(std::size_t number) const { return m_in[number] != 0; }
    void put(std::size_t number, bool in) { m_in[number] = in ? 1 : 0; }

    /// The part, or what is beside it.
    surfel::SurfelList surfels(bool in) const {
        surfel::SurfelList out;
        out.layout = m_surface.tree().layout();
        std::vector<std::uint32_t> words(out.layout->words());
        std::size_t number = 0;
        m_surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot, ++number)
                if (holds(number) == in) {
                    block.extra(slot, words);
                    out.append(block.surfel(slot), words);
                }
        });
        return out;
    }

  private:
    const surface::Surface& m_surface;
    std::vector<std::uint8_t> m_in;
};

} // namespace solid
