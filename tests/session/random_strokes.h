// Strokes on any model, as session lines: along the surface from one surfel to another near it, by any tool, with
// options that people use. What is drawn follows from the random numbers and the model alone.
#pragma once

#include "core/base/random.h"
#include "core/sculpt/stroke/stroke_settings.h"
#include "core/session/document.h"

#include <nlohmann/json.hpp>

namespace test {

class RandomStrokes {
  public:
    RandomStrokes(const session::Document& document, base::Random& random) : m_document(document), m_random(random) {}

    nlohmann::json next() {
        std::vector<const char*> tools;
        for (const sculpt::ToolRow& row : sculpt::toolTable())
            if (!row.needs.layer)
                tools.push_back(row.id);
        return next(tools[m_random.below(tools.size())]);
    }
    nlohmann::json next(const std::string& tool) {
        const float size = m_document.surface().tree().bounds().diagonal();
        nlohmann::json out{{"op", "stroke"}, {"tool", tool}, {"radius", double(size) * m_random.uniform(0.02, 0.08)}};
        out["strength"] = m_random.uniform(0.2, 1);
        out["invert"] = m_random.below(4) == 0;
        out["resample"] = m_random.below(5) != 0;
        if (m_random.below(4) == 0)
            out["symmetry"] = nlohmann::json::array({sculpt::axisTable()[m_random.below(3)].id});
        if (m_random.below(4) == 0)
            out["method"] = sculpt::methodTable()[m_random.below(sculpt::methodTable().size())].id;
        if (m_random.below(8) == 0)
            out["auto-smooth"] = m_random.uniform(0, 0.5);
        if (m_random.below(8) == 0)
            out["accumulate"] = m_random.below(2) == 0;
        if (tool == "clone") // from beside itself
            out["x"] = double(size) * m_random.uniform(0.05, 0.2);
        out["samples"] = samples(double(size));
        return out;
    }

  private:
    /// Rays from outside onto the way between two surfels of one block.
    nlohmann::json samples(double size) {
        const tree::SurfelTree& tree = m_document.surface().tree();
        const surfel::BlockPtr block = tree.block(static_cast<std::uint32_t>(m_random.below(tree.blockCount())));
        const auto slot = [&] { return static_cast<int>(m_random.below(static_cast<std::size_t>(block->size()))); };
        const int from = slot(), to = slot();
        const std::size_t count = 2 + m_random.below(7);
        nlohmann::json out = nlohmann::json::array();
        for (std::size_t k = 0; k < count; ++k) {
            const double part = double(k) / double(count - 1), back = 0.3 * size;
            const auto between = [&](const base::Vec3f& a, const base::Vec3f& b) {
                return base::cast<double>(a) * (1 - part) + base::cast<double>(b) * part;
            };
            const base::Vec3d at = between(block->position(from), block->position(to));
            const base::Vec3d n = normalized(between(block->normal(from), block->normal(to)), base::Vec3d{0, 0, 1});
            const base::Vec3d eye = at + m_document.provenance().origin + n * back;
            out.push_back({eye.x, eye.y, eye.z, -n.x, -n.y, -n.z, m_random.uniform(0.3, 1), 0.03 * double(k)});
        }
        return out;
    }

    const session::Document& m_document;
    base::Random& m_random;
};

} // namespace test
