// What is seen of a scene: its models in the coordinates of the active one, so that who draws, frames or picks works in
// one frame, and that is the one in which commands and tools work.
#pragma once

#include "core/session/scene/scene.h"

namespace session {

/// A model that is seen beside the active one.
struct ShownModel {
    std::uint32_t id = 0;
    std::string name;
    bool locked = false;
    surface::Surface surface; ///< in stored coordinates of the active model; of a curve, the tube around it
};

/// Keeps what has not changed from one version to the next. One thread at a time.
class ShownScene {
  public:
    /// The visible models but the active one. What stands too far away to be held in the active one's coordinates is
    /// left out.
    const std::vector<ShownModel>& beside(const Scene& scene, const base::Progress& progress = {});

    /// All of them as one tree, `model` being what is shown of the active one, or nothing where that is hidden: for
    /// pictures by splats, and for framing. Attributes are those of `model`. Cost: the number of models, unless these
    /// have other attributes than before. REQUIRES: a call of `beside` for the scene.
    tree::SurfelTree whole(const tree::SurfelTree& model);

  private:
    struct Known {
        tree::SurfelTree from; ///< that `shown` was made of
        process::Rigid motion;
        ShownModel shown;
    };
    std::vector<Known> m_known;
    std::vector<ShownModel> m_shown;
    surfel::AttributeLayout m_layout; ///< of m_trees
    std::vector<tree::SurfelTree> m_trees;
};

} // namespace session
