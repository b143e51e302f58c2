// Numbers measured at a surface's surfels, kept block by block, for pictures that show them as colours.
//
//     ScalarField now = evaluateField({Quantity::MeanCurvature, surface, {}});
//     ... an edit ...
//     ScalarField next = evaluateField({Quantity::MeanCurvature, edited, {}}, &now);   blocks near the edit alone
//
// A field is a value of shared blocks: a later version's field shares the numbers of all blocks that the edit could not
// touch, bit for bit as an evaluation from scratch gives them. NaN where the surface has no answer.
//
// Threads: evaluated in parallel, the same bits at any thread count; const afterwards.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <memory>
#include <string>
#include <unordered_map>

namespace process {

/// Curvatures (surface/README) in 1/length, Gaussian in 1/length squared; where the surfels have no common side, the
/// side is the one with mean >= 0. OffCentre is o/h (process/README 3), without unit. Spacing and Deviation are
/// lengths: the latter from the reference surface to this one, positive on the side where the reference's normals
/// point, without sign where it has no sides. Attribute is what the surfels carry under a name, in the unit it was
/// written in; no numbers where they carry none, but of the selection, which is 0 then.
enum class Quantity {
    MeanCurvature,
    GaussianCurvature,
    LargestCurvature,
    SmallestCurvature,
    OffCentre,
    Spacing,
    Deviation,
    Attribute
};

struct FieldQuestion {
    Quantity quantity = Quantity::MeanCurvature;
    surface::Surface surface;
    surface::Surface reference; ///< of Deviation; an empty one gives no numbers
    std::string attribute = {}; ///< the name, of Attribute
};

class ScalarField {
  public:
    using Values = std::shared_ptr<const std::vector<float>>; ///< one per surfel of the block

    const FieldQuestion& question() const { return m_question; }
    /// Null for a block of another version.
    Values of(const surfel::SurfelBlock* block) const {
        const auto found = m_values.find(block);
        return found != m_values.end() ? found->second : nullptr;
    }
    /// How many blocks the evaluation looked at; the others' numbers were there.
    std::size_t evaluatedBlocks() const { return m_evaluated; }

  private:
    friend ScalarField evaluateField(const FieldQuestion&, const ScalarField*, const base::Progress&);
    FieldQuestion m_question; ///< keeps its blocks alive, so that their addresses name them
    std::unordered_map<const surfel::SurfelBlock*, Values> m_values;
    std::size_t m_evaluated = 0;
};

/// `before` may be another version's field; only what it can give is taken from it. Throws base::Cancelled.
ScalarField evaluateField(const FieldQuestion& question, const ScalarField* before = nullptr,
                          const base::Progress& progress = {});

/// The same quantity at positions on the surface, best when neighbours in the list are neighbours in space. Spacing is
/// the surfels', blended like their positions.
void quantityAt(const FieldQuestion& question, std::span<const base::Vec3f> x, std::span<float> out);

/// Values of surfels spread evenly through the tree, at most some 60000 of them, NaN left out: what an automatic range
/// looks at, the same whether a whole field is at hand or not. Throws base::Cancelled.
std::vector<float> sampleField(const FieldQuestion& question, const ScalarField* field = nullptr,
                               const base::Progress& progress = {});

} // namespace process
