#include "core/surface/evaluation/attribute_sum.h"

#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>

namespace surface {

AttributeSum::AttributeSum(const surfel::AttributeLayout& layout)
    : m_layout(layout), m_numbers(layout.attributes().size(), 0), m_words(layout.words()), m_heaviest(m_words) {}

void AttributeSum::add(const surfel::SurfelBlock& block, int slot, float weight) {
    const int cluster = slot / surfel::clusterSize, lane = slot % surfel::clusterSize;
    const surfel::Colour colour = block.words(cluster, surfel::ColourWord)[lane];
    const double w = weight;
    m_weight += w;
    m_mask += w * double(block.mask(slot));
    for (int c = 0; c < 4; ++c)
        m_channels[c] += w * double(colour >> (8 * c) & 255u);
    if (!m_words.empty())
        addFurther(block, slot, weight);
}

void AttributeSum::addFurther(const surfel::SurfelBlock& block, int slot, float weight) {
    block.extra(slot, m_words);
    for (std::size_t a = 0; a < m_numbers.size(); ++a)
        m_numbers[a] += double(weight) * surfel::read(m_layout.attributes()[a], m_words);
    if (weight > m_most) {
        m_most = weight;
        m_heaviest = m_words;
    }
}

surfel::Colour AttributeSum::colour() const {
    surfel::Colour out = 0;
    for (int c = 0; c < 4; ++c)
        out |= static_cast<surfel::Colour>(std::lround(m_channels[c] / m_weight)) << (8 * c);
    return out;
}

void AttributeSum::further(std::span<std::uint32_t> out) const {
    std::copy(m_heaviest.begin(), m_heaviest.end(), out.begin());
    for (std::size_t a = 0; a < m_numbers.size(); ++a)
        if (const surfel::Attribute& attribute = m_layout.attributes()[a]; isReal(attribute.type))
            surfel::write(attribute, out, m_numbers[a] / m_weight);
    if (surfel::shapeChannel(m_layout) > 0)
        surfel::putShape(out, surfel::shapeWord(m_layout), {});
}

} // namespace surface
