#include "core/process/scalar_field.h"

#include "core/base/parallel.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/surface/curvature.h"
#include "core/surface/evaluation/self.h"
#include "core/surface/evaluation/weights.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_set>

namespace process {

using base::Vec3f;
using surface::Surface;
using Blocks = std::span<const surfel::BlockPtr>;

namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// Blocks between two looks at the progress.
constexpr std::size_t blocksPerStep = 128;
/// Blocks that an automatic range looks at.
constexpr std::uint32_t sampledBlocks = 512;

bool oriented(const Surface& surface) {
    const surfel::AttributeLayoutPtr& layout = surface.tree().layout();
    return layout->normals && layout->oriented;
}

// --- at positions ---

float pick(Quantity quantity, surface::Curvature c, bool sided) {
    if (!c.ok())
        return unknown;
    if (!sided && c.mean() < 0)
        c.k1 = -std::exchange(c.k2, -c.k1);
    switch (quantity) {
    case Quantity::MeanCurvature:
        return static_cast<float>(c.mean());
    case Quantity::GaussianCurvature:
        return static_cast<float>(c.gauss());
    case Quantity::LargestCurvature:
        return static_cast<float>(c.k1);
    default:
        return static_cast<float>(c.k2);
    }
}

void curvatureAt(const FieldQuestion& q, std::span<const Vec3f> x, std::span<float> out) {
    std::vector<surface::Curvature> found(x.size());
    surface::curvature(q.surface, x, found);
    const bool sided = oriented(q.surface);
    std::transform(found.begin(), found.end(), out.begin(), [&](const auto& c) { return pick(q.quantity, c, sided); });
}

void offCentreAt(const FieldQuestion& q, std::span<const Vec3f> x, std::span<float> out) {
    std::vector<surface::Evaluationf> found(x.size());
    q.surface.evaluate(x, surface::Need::Value, found);
    std::transform(found.begin(), found.end(), out.begin(), [](const surface::Evaluationf& e) {
        return e.ok() || e.status == surface::Status::BeyondBoundary ? e.offCentre / e.unit : unknown;
    });
}

/// Null where there is none of that name.
const surfel::Attribute* attributeOf(const FieldQuestion& q) {
    return q.surface.tree().layout()->find(q.attribute);
}

/// What a surfel without the attribute has: nothing was ever selected there.
float absent(const FieldQuestion& q) {
    return q.attribute == "selection" ? 0.0f : unknown;
}

float attributeAt(const surfel::Attribute& attribute, const surfel::SurfelBlock& block, int slot) {
    std::array<std::uint32_t, 2> words{};
    for (std::size_t k = 0; k < surfel::wordsOf(attribute.type); ++k)
        words[k] = std::bit_cast<std::uint32_t>(
            block.channel(slot / surfel::clusterSize,
                          surfel::Extra + static_cast<int>(attribute.firstWord + k))[slot % surfel::clusterSize]);
    const surfel::Attribute own{{}, attribute.type, 0};
    return static_cast<float>(surfel::read(own, words));
}

/// Blended like colours and masks; numbers of kinds (a class, a scan) are not mixed, the nearest surfel's counts.
float attributeAt(const FieldQuestion& q, const surfel::Attribute& attribute, const Vec3f& x) {
    float sum = 0, total = 0, most = 0, heaviest = absent(q);
    surface::forWeights(q.surface, x, [&](const surfel::SurfelBlock& block, int slot, float theta) {
        const float value = attributeAt(attribute, block, slot);
        sum += theta * value;
        total += theta;
        if (theta > most)
            most = theta, heaviest = value;
    });
    return surfel::isReal(attribute.type) && total > 0 ? sum / total : heaviest;
}

/// From the reference to positions of the surface.
void deviationAt(const FieldQuestion& q, std::span<const Vec3f> x, std::span<float> out) {
    if (q.reference.tree().empty()) {
        std::fill(out.begin(), out.end(), unknown);
        return;
    }
    std::vector<surface::Projection<float>> feet(x.size());
    surface::project(q.reference, x, {}, feet);
    const bool sided = oriented(q.reference);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3f away = x[i] - feet[i].foot;
        const bool behind = sided && dot(away, feet[i].at.gradient) < 0;
        out[i] = feet[i].ok() ? (behind ? -length(away) : length(away)) : unknown;
    }
}

/// Weighted like colours and masks.
float spacingAt(const Surface& surface, const Vec3f& x) {
    float sum = 0, total = 0;
    surface::forWeights(surface, x, [&](const surfel::SurfelBlock& block, int slot, float theta) {
        sum += theta * spacingAround(surface.tree(), block.position(slot));
        total += theta;
    });
    return total > 0 ? sum / total : unknown;
}

// --- at surfels ---

std::vector<Vec3f> positionsOf(Blocks blocks) {
    std::vector<Vec3f> out;
    for (const surfel::BlockPtr& block : blocks)
        for (int slot = 0; slot < block->size(); ++slot)
            out.push_back(block->position(slot));
    return out;
}

/// Where the surface is beside a surfel that noise has put off it. A foot that is far is another place's.
void feetOf(const Surface& surface, std::vector<Vec3f>& x) {
    std::vector<surface::Projection<float>> feet(x.size());
    surface::project(surface, x, {}, feet);
    for (std::size_t i = 0; i < x.size(); ++i)
        if (feet[i].ok() && distance(feet[i].foot, x[i]) < feet[i].at.unit)
            x[i] = feet[i].foot;
}

void carriedBy(const FieldQuestion& q, Blocks blocks, std::vector<float>& out) {
    const surfel::Attribute* attribute = attributeOf(q);
    auto next = out.begin();
    for (const surfel::BlockPtr& block : blocks)
        for (int slot = 0; slot < block->size(); ++slot)
            *next++ = attribute ? attributeAt(*attribute, *block, slot) : absent(q);
}

void valuesAt(const FieldQuestion& q, Blocks blocks, std::vector<float>& out) {
    std::vector<Vec3f> x = positionsOf(blocks);
    out.resize(x.size());
    if (q.quantity == Quantity::Spacing)
        return base::parallelFor(x.size(), 64, [&](std::size_t i) { out[i] = spacingAround(q.surface.tree(), x[i]); });
    if (q.quantity == Quantity::Attribute)
        return carriedBy(q, blocks, out);
    if (q.quantity == Quantity::Deviation)
        feetOf(q.surface, x);
    quantityAt(q, x, out);
}

/// How far beyond its supports, in supports, a changed surfel can matter.
float reachOf(const FieldQuestion& q) {
    switch (q.quantity) {
    case Quantity::Attribute:
        return 0;
    case Quantity::OffCentre:
    case Quantity::Spacing:
        return 2; // the second pass where sheets are near looks beyond the first's supports
    case Quantity::Deviation:
        return 3; // from the foot, a support away at most
    default:
        return 2 * q.surface.definition().curvatureScale();
    }
}

/// Blocks of `surface` whose numbers may differ from those of a version that lacks `changed`.
std::unordered_set<const surfel::SurfelBlock*> touched(const FieldQuestion& q, Blocks changed) {
    std::unordered_set<const surfel::SurfelBlock*> out;
    for (const surfel::BlockPtr& block : changed) {
        const float radius = 0.5f * block->box().diagonal() + reachOf(q) * block->maxSupport();
        q.surface.tree().forBlocksInBall(block->box().centre(), radius,
                                         [&](std::uint32_t, const surfel::SurfelBlock& near) { out.insert(&near); });
    }
    return out;
}

bool alike(const surfel::Attribute* a, const surfel::Attribute* b) {
    return a && b ? *a == *b : a == b;
}

bool comparable(const FieldQuestion& a, const FieldQuestion& b) {
    return a.quantity == b.quantity && a.surface.definition() == b.surface.definition() && a.attribute == b.attribute &&
           alike(attributeOf(a), attributeOf(b)) && a.reference.tree() == b.reference.tree() &&
           a.reference.definition() == b.reference.definition() &&
           a.surface.tree().layout()->oriented == b.surface.tree().layout()->oriented;
}

} // namespace

void quantityAt(const FieldQuestion& q, std::span<const Vec3f> x, std::span<float> out) {
    switch (q.quantity) {
    case Quantity::OffCentre:
        return offCentreAt(q, x, out);
    case Quantity::Deviation:
        return deviationAt(q, x, out);
    case Quantity::Attribute: {
        const surfel::Attribute* attribute = attributeOf(q);
        return base::parallelFor(
            x.size(), 64, [&](std::size_t i) { out[i] = attribute ? attributeAt(q, *attribute, x[i]) : absent(q); });
    }
    case Quantity::Spacing:
        return base::parallelFor(x.size(), 64, [&](std::size_t i) { out[i] = spacingAt(q.surface, x[i]); });
    default:
        return curvatureAt(q, x, out);
    }
}

ScalarField evaluateField(const FieldQuestion& question, const ScalarField* before, const base::Progress& progress) {
    const tree::SurfelTree& tree = question.surface.tree();
    ScalarField out;
    out.m_question = question;
    const bool useful = before && comparable(before->question(), question);
    // What the reference shares has not moved from it.
    const bool still = question.quantity == Quantity::Deviation && !question.reference.tree().empty() &&
                       question.reference.definition() == question.surface.definition();
    std::unordered_set<const surfel::SurfelBlock*> old;
    if (useful || still) {
        const tree::SurfelTree& from = useful ? before->question().surface.tree() : question.reference.tree();
        const tree::Diff change = tree::diff(from, tree);
        old = touched(question, change.added);
        old.merge(touched(question, change.removed));
    }
    std::vector<surfel::BlockPtr> wanted;
    for (std::uint32_t number = 0; number < tree.blockCount(); ++number) {
        const surfel::BlockPtr block = tree.block(number);
        ScalarField::Values& values = out.m_values[block.get()];
        if (useful && !old.contains(block.get()))
            values = before->of(block.get());
        else if (!useful && still && !old.contains(block.get()))
            values = std::make_shared<const std::vector<float>>(block->size(), 0.0f);
        if (!values)
            wanted.push_back(block);
    }
    std::vector<float> found;
    for (std::size_t begin = 0; begin < wanted.size(); begin += blocksPerStep) {
        progress.step(static_cast<double>(begin) / static_cast<double>(wanted.size()), "Measuring the surface");
        const Blocks some = Blocks(wanted).subspan(begin, std::min(blocksPerStep, wanted.size() - begin));
        valuesAt(question, some, found);
        auto next = found.begin();
        for (const surfel::BlockPtr& block : some) {
            out.m_values[block.get()] = std::make_shared<const std::vector<float>>(next, next + block->size());
            next += block->size();
        }
    }
    out.m_evaluated = wanted.size();
    return out;
}

std::vector<float> sampleField(const FieldQuestion& question, const ScalarField* field,
                               const base::Progress& progress) {
    const tree::SurfelTree& tree = question.surface.tree();
    const std::uint32_t count = std::min(tree.blockCount(), sampledBlocks);
    std::vector<surfel::BlockPtr> blocks;
    for (std::uint32_t k = 0; k < count; ++k)
        blocks.push_back(tree.block(static_cast<std::uint32_t>(std::uint64_t(k) * tree.blockCount() / count)));
    std::vector<float> out, found;
    for (std::size_t begin = 0; begin < blocks.size(); begin += blocksPerStep) {
        const Blocks some = Blocks(blocks).subspan(begin, std::min(blocksPerStep, blocks.size() - begin));
        if (!field) {
            progress.step(static_cast<double>(begin) / static_cast<double>(blocks.size()), "Choosing the range");
            valuesAt(question, some, found);
            out.insert(out.end(), found.begin(), found.end());
            continue;
        }
        for (const surfel::BlockPtr& block : some)
            if (const ScalarField::Values values = field->of(block.get()))
                out.insert(out.end(), values->begin(), values->end());
    }
    std::erase_if(out, [](float value) { return !std::isfinite(value); });
    return out;
}

} // namespace process
