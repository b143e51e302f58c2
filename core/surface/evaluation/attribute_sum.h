// Weighted means of what surfels carry beside their place: colours, masks and further attributes. Attributes that are
// whole numbers, such as labels, are those of the surfel that weighs most. Shapes of supports are no property of a
// place: what is born has a ball.
#pragma once

#include "core/surfel/surfel_block.h"

#include <vector>

namespace surface {

/// One thread's. Asking for a mean REQUIRES any().
class AttributeSum {
  public:
    /// Of the attributes that `layout` names, which must outlive this: that of the surfels, or none.
    explicit AttributeSum(const surfel::AttributeLayout& layout);

    void add(const surfel::SurfelBlock& block, int slot, float weight);

    bool any() const { return m_weight > 0; }
    surfel::Colour colour() const; ///< with its alpha
    float mask() const { return static_cast<float>(m_mask / m_weight); }
    /// REQUIRES: room for the words of the layout.
    void further(std::span<std::uint32_t> out) const;

  private:
    void addFurther(const surfel::SurfelBlock& block, int slot, float weight);

    const surfel::AttributeLayout& m_layout;
    double m_weight = 0, m_mask = 0, m_channels[4] = {};
    std::vector<double> m_numbers;                  ///< sums of each further attribute
    std::vector<std::uint32_t> m_words, m_heaviest; ///< of the surfel being added; of the one that weighs most
    float m_most = 0;
};

} // namespace surface
