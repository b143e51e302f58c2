// What is said at the surfels under a brush by the surface of their own cells (cells/README 2), where others have
// weight there, too: the rounded surface that all of them make together is not what tools are to draw a side of an edge
// to.
//
//     OwnCells own(surface, blocks);                 one for a dab; empty where one cell is alone
//     OwnCells::Evaluator evaluator(own);            one per thread
//     evaluator.replace(block, clusters, at);        of what SelfEvaluator has found, where another cell is in support
#pragma once

#include "core/cells/cell_source_float.h"
#include "core/sculpt/tools/brush.h"
#include "core/surface/evaluation/self.h"

#include <set>

namespace sculpt {

class OwnCells {
  public:
    OwnCells(const surface::Surface& surface, std::span<const BrushBlock> blocks);

    class Evaluator {
      public:
        explicit Evaluator(const OwnCells& own) : m_own(own) {
            if (own.m_near)
                m_source.emplace(*own.m_near);
        }
        /// Status, value, gradient and unit of the clusters named by bits.
        void replace(const BrushBlock& in, unsigned clusters, std::span<surface::SelfLanes> at);

      private:
        const OwnCells& m_own;
        std::optional<cells::CellSourcef> m_source;
    };

  private:
    std::optional<cells::LabelLayout> m_labels;
    std::set<std::uint32_t> m_mixed;          ///< blocks with several cells in support
    std::optional<cells::CellSurface> m_near; ///< of what has weight there
};

} // namespace sculpt
