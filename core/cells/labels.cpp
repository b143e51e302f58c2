#include "core/cells/labels.h"

#include "core/base/error.h"
#include "core/surfel/widen.h"

#include <algorithm>
#include <cassert>

namespace cells {

/// The word of an attribute of whole numbers; nothing where there is none of that name.
static std::optional<std::size_t> wordOf(const surfel::AttributeLayout& layout, const char* name) {
    const surfel::Attribute* attribute = layout.find(name);
    if (!attribute || surfel::isReal(attribute->type))
        return std::nullopt;
    return attribute->firstWord;
}

static Meeting meetingOf(std::uint32_t word) {
    return word == 1 ? Meeting::Convex : word == 2 ? Meeting::Concave : Meeting::None;
}

std::optional<LabelLayout> LabelLayout::of(const surfel::AttributeLayout& layout) {
    const auto cell = wordOf(layout, "cell"), partner = wordOf(layout, "partner"), sign = wordOf(layout, "sign");
    if (!layout.normals || !layout.oriented || !cell || !partner || !sign)
        return std::nullopt;
    LabelLayout out;
    out.m_cell = *cell;
    out.m_partner = *partner;
    out.m_sign = *sign;
    out.m_sharpness = wordOf(layout, "sharpness");
    out.m_face = wordOf(layout, "face");
    return out;
}

Label LabelLayout::at(const surfel::SurfelBlock& block, int slot) const {
    Label out;
    out.cell = word(block, slot, m_cell);
    out.partner = word(block, slot, m_partner);
    out.meeting = out.partner == out.cell ? Meeting::None : meetingOf(word(block, slot, m_sign));
    if (m_sharpness)
        out.sharpness = static_cast<std::uint8_t>(std::min<std::uint32_t>(word(block, slot, *m_sharpness), 255));
    out.face = m_face ? word(block, slot, *m_face) : out.cell;
    return out;
}

Label LabelLayout::at(std::span<const std::uint32_t> words) const {
    Label out;
    out.cell = words[m_cell];
    out.partner = words[m_partner];
    out.meeting = out.partner == out.cell ? Meeting::None : meetingOf(words[m_sign]);
    if (m_sharpness)
        out.sharpness = static_cast<std::uint8_t>(std::min<std::uint32_t>(words[*m_sharpness], 255));
    out.face = m_face ? words[*m_face] : out.cell;
    return out;
}

void requireNames(const surfel::AttributeLayout& layout) {
    for (const char* name : {"cell", "partner", "sign", "sharpness", "face"})
        if (const surfel::Attribute* found = layout.find(name); found && surfel::isReal(found->type))
            throw base::Error(std::string("the model has an attribute called ") + name + " that holds other numbers",
                              {}, "rename it in the file");
}

void setLabels(surfel::SurfelList& surfels, std::span<const Label> labels, bool whole) {
    assert(labels.size() == surfels.size());
    const bool faded = std::any_of(labels.begin(), labels.end(), [](const Label& l) { return l.sharpness != 255; });
    const bool faces = std::any_of(labels.begin(), labels.end(), [](const Label& l) { return l.face != l.cell; });
    auto layout = std::make_shared<surfel::AttributeLayout>(*surfels.layout);
    const auto need = [&](const char* name, surfel::ScalarType type) {
        if (!layout->find(name))
            layout->add(name, type);
    };
    need("cell", surfel::ScalarType::UInt32);
    need("partner", surfel::ScalarType::UInt32);
    need("sign", surfel::ScalarType::UInt8);
    if (faded || whole)
        need("sharpness", surfel::ScalarType::UInt8);
    if (faces || whole)
        need("face", surfel::ScalarType::UInt32);
    surfel::widen(surfels, layout);
    const std::size_t words = layout->words();
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const std::span<std::uint32_t> own = std::span(surfels.extra).subspan(i * words, words);
        const auto put = [&](const char* name, std::uint32_t value) {
            if (const surfel::Attribute* attribute = layout->find(name))
                surfel::write(*attribute, own, value);
        };
        put("cell", labels[i].cell);
        put("partner", labels[i].partner);
        put("sign", static_cast<std::uint32_t>(labels[i].meeting));
        put("sharpness", labels[i].sharpness);
        put("face", labels[i].face);
    }
}

} // namespace cells
