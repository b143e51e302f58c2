#include "core/session/scene/joined_models.h"

#include "core/base/error.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/process/estimation/known_rims.h"
#include "core/surface/rims.h"

#include <algorithm>

namespace session {

using surfel::Attribute, surfel::AttributeLayout, surfel::ScalarType;

/// Numbers of different types under one name become float64, which holds them all.
std::shared_ptr<AttributeLayout> unitedLayout(const std::vector<SceneModel>& models) {
    std::vector<std::pair<std::string, ScalarType>> attributes;
    auto out = std::make_shared<AttributeLayout>();
    out->normals = out->oriented = true;
    for (const SceneModel& model : models) {
        const AttributeLayout& own = *model.surface.tree().layout();
        out->normals &= own.normals, out->oriented &= own.oriented;
        out->colours |= own.colours, out->masks |= own.masks;
        for (const Attribute& a : own.attributes()) {
            const auto known = std::ranges::find(attributes, a.name, &std::pair<std::string, ScalarType>::first);
            if (known == attributes.end())
                attributes.emplace_back(a.name, a.type);
            else if (known->second != a.type)
                known->second = ScalarType::Float64;
        }
    }
    for (const auto& [name, type] : attributes)
        out->add(name, type);
    return out;
}

void appendAs(surfel::SurfelList& out, const surfel::SurfelList& list) {
    std::vector<std::pair<const Attribute*, const Attribute*>> pairs;
    for (const Attribute& from : list.layout->attributes())
        if (const Attribute* to = out.layout->find(from.name))
            pairs.emplace_back(&from, to);
    std::vector<std::uint32_t> words(out.layout->words());
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::ranges::fill(words, 0u);
        for (const auto& [from, to] : pairs)
            surfel::write(*to, words, surfel::read(*from, list.extraOf(i)));
        out.append(list.items[i], words);
    }
}

static void refuse(const SceneModel& model, const SceneModel& first) {
    const surface::SurfaceDefinition& definition = model.surface.definition();
    const char* what = !model.layers.empty()                                        ? "has layers"
                       : definition.connectivity                                    ? "is a cell complex"
                       : definition.manifold != first.surface.definition().manifold ? "is of another dimension"
                       : model.surface.tree().layout()->oriented != first.surface.tree().layout()->oriented
                           ? "has other normals: those of one tell inside from outside, the other one's do not"
                           : nullptr;
    if (what)
        throw base::Error("\"" + model.name + "\" " + what + " and cannot be joined", {},
                          "merge its layers, orient its normals, or leave it a model of its own");
}

/// Cells of each model with numbers that no model before has.
static std::vector<cells::Label> labelsOf(const std::vector<SceneModel>& models, std::size_t surfels) {
    std::vector<cells::Label> out;
    std::uint32_t next = 0;
    for (const SceneModel& model : models) {
        const std::uint32_t offset = next;
        for (const cells::Label& own : cells::labelsOf(model.surface.tree())) {
            const cells::Label label = own.shifted(offset);
            next = std::max({next, label.cell + 1, label.partner + 1, label.face + 1});
            out.push_back(label);
        }
    }
    return out.size() == surfels ? out : std::vector<cells::Label>();
}

surface::Surface joined(const std::vector<SceneModel>& models) {
    const SceneModel& first = models.front();
    surfel::SurfelList out;
    out.layout = unitedLayout(models);
    bool labelled = false;
    for (const SceneModel& model : models) {
        refuse(model, first);
        labelled |= cells::LabelLayout::of(*model.surface.tree().layout()).has_value();
        appendAs(out, placed(model.surface, between(model, first)).tree().surfels());
    }
    if (labelled)
        cells::setLabels(out, labelsOf(models, out.size()));
    surface::SurfaceDefinition definition = first.surface.definition();
    std::vector<const surface::Surface*> parts;
    for (const SceneModel& model : models)
        parts.push_back(&model.surface);
    definition.knownRims = process::knowRimsTogether(parts);
    if (definition.knownRims && !surface::knowsRims(first.surface)) // the limit of the closed one is none
        definition.boundaryLimit =
            (*std::ranges::find_if(parts, [](const auto* each) { return surface::knowsRims(*each); }))
                ->definition()
                .boundaryLimit;
    return {tree::SurfelTree::build(out), std::move(definition)};
}

} // namespace session
