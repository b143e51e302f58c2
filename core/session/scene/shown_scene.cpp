#include "core/session/scene/shown_scene.h"

#include "core/base/error.h"
#include "core/process/curve_tube.h"
#include "core/selection/hidden.h"
#include "core/session/scene/joined_models.h"

#include <algorithm>

namespace session {

const std::vector<ShownModel>& ShownScene::beside(const Scene& scene, const base::Progress& progress) {
    std::vector<Known> now;
    std::vector<ShownModel> shown;
    for (std::size_t k = 0; k < scene.models.size(); ++k) {
        const SceneModel& model = scene.models[k];
        if (k == scene.active || !model.visible)
            continue;
        const process::Rigid motion = between(model, scene.models[scene.active]);
        const auto same = std::ranges::find_if(m_known, [&](const Known& each) {
            return each.from == model.surface.tree() && each.motion == motion && each.shown.id == model.id;
        });
        Known known{model.surface.tree(), motion, {model.id, model.name, model.locked, {}}};
        try {
            known.shown.surface = same != m_known.end()
                                      ? same->shown.surface
                                      : process::shownAs(placed(selection::shownOf(model.surface), motion), progress);
        } catch (const base::Error&) { // too far away
            continue;
        }
        shown.push_back(known.shown);
        now.push_back(std::move(known));
    }
    const auto tree = [](const ShownModel& each) { return each.surface.tree(); };
    if (!std::ranges::equal(shown, m_shown, {}, tree, tree))
        m_trees.clear();
    m_known = std::move(now);
    m_shown = std::move(shown);
    return m_shown;
}

/// The same surfels with other attributes: those of the same names, others zero.
static tree::SurfelTree withAttributes(const tree::SurfelTree& tree, const surfel::AttributeLayoutPtr& layout) {
    if (tree.layout()->attributes() == layout->attributes())
        return tree;
    surfel::SurfelList list;
    list.layout = layout;
    appendAs(list, tree.surfels());
    return tree::SurfelTree::build(list);
}

tree::SurfelTree ShownScene::whole(const tree::SurfelTree& model) {
    if (m_shown.empty())
        return model;
    auto layout =
        std::make_shared<surfel::AttributeLayout>(*(model.empty() ? m_shown.front().surface.tree() : model).layout());
    for (const ShownModel& each : m_shown) {
        const surfel::AttributeLayout& own = *each.surface.tree().layout();
        layout->colours |= own.colours, layout->masks |= own.masks;
        layout->oriented &= own.oriented, layout->normals &= own.normals;
    }
    if (m_trees.size() != m_shown.size() || !(m_layout.attributes() == layout->attributes())) {
        m_trees.clear();
        m_layout = *layout;
        for (const ShownModel& each : m_shown)
            m_trees.push_back(withAttributes(each.surface.tree(), layout));
    }
    std::vector<tree::SurfelTree> trees{model};
    trees.insert(trees.end(), m_trees.begin(), m_trees.end());
    return tree::SurfelTree::beside(trees).withLayout(layout);
}

} // namespace session
