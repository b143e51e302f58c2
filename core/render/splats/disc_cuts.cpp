#include "core/render/splats/disc_cuts.h"

#include "core/base/parallel.h"
#include "core/render/splats/boundary_cuts.h"
#include "core/render/splats/complex_cuts.h"
#include "core/render/splats/label_cuts.h"
#include "core/render/splats/sharp_cuts.h"

#include <algorithm>
#include <bit>
#include <numbers>
#include <optional>
#include <unordered_set>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// A tangential direction that the angle of a code counts from.
Vec3f zeroAngle(const Vec3f& n, bool yAxis) {
    return normalized(yAxis ? Vec3f{n.z, 0, -n.x} : Vec3f{0, -n.z, n.y}, Vec3f{});
}

/// In how many steps of `count` a turn about the normal leads from there to a direction.
unsigned angleSteps(const Vec3f& n, bool yAxis, const Vec3f& direction, int count) {
    const Vec3f u = zeroAngle(n, yAxis), v = cross(n, u);
    const float turns = std::atan2(dot(direction, v), dot(direction, u)) / (2 * std::numbers::pi_v<float>);
    return static_cast<unsigned>(std::lround(turns * static_cast<float>(count))) & static_cast<unsigned>(count - 1);
}

Vec3f directionAt(const Vec3f& n, bool yAxis, unsigned steps, int count) {
    const Vec3f u = zeroAngle(n, yAxis), v = cross(n, u);
    const float angle = static_cast<float>(steps) * (2 * std::numbers::pi_v<float> / static_cast<float>(count));
    return u * std::cos(angle) + v * std::sin(angle);
}

bool countsFromY(const Vec3f& n) {
    return std::abs(n.x) > 0.8f;
}

constexpr int oneAngles = 128, twoAngles = 64;
constexpr float twoParts = 20;

} // namespace

Vec3f discAxis(const Vec3f& n) {
    return zeroAngle(n, countsFromY(n));
}

CutCode cutCode(const Vec3f& n, const Vec3f& direction, float part, Beside beside) {
    long steps = std::max(1l, std::lround(part * 32));
    if (beside == Beside::Edge && steps > 31)
        return wholeDisc;
    if (beside != Beside::Edge) // farther off than what is left of the radius
        steps = std::min(steps, 15l) + (beside == Beside::Tip ? 16 : 0);
    const bool yAxis = countsFromY(n);
    return (yAxis ? 1u << 13 : 0u) | (beside != Beside::Edge ? 1u << 12 : 0u) |
           angleSteps(n, yAxis, direction, oneAngles) << 5 | static_cast<unsigned>(steps);
}

float roughSupport(float support) {
    constexpr std::uint32_t mask = (1u << twoCutBits) - 1;
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(support) + mask / 2) & ~mask);
}

CutCode twoCutsCode(const Vec3f& n, float support, const CutLine& first, const CutLine& second) {
    const bool yAxis = countsFromY(n);
    const float scale = twoParts * support / roughSupport(support);
    const auto steps = [&](const CutLine& line) {
        return static_cast<unsigned>(std::clamp(std::lround(line.part * scale), 1l, 16l)) - 1;
    };
    return twoCuts | (yAxis ? 1u << 20 : 0u) | angleSteps(n, yAxis, first.direction, twoAngles) << 14 |
           angleSteps(n, yAxis, second.direction, twoAngles) << 8 | steps(first) << 4 | steps(second);
}

DiscCut discCut(const Vec3f& n, float support, CutCode code) {
    if ((code & twoCuts) != 0) {
        const float rough = roughSupport(support) / support;
        const auto line = [&](int angleAt, int stepsAt) {
            return CutLine{directionAt(n, (code >> 20 & 1u) != 0, code >> angleAt & 63u, twoAngles),
                           static_cast<float>((code >> stepsAt & 15u) + 1) / twoParts * rough};
        };
        return {line(14, 4), cutRadius * rough, line(8, 0)};
    }
    const unsigned steps = code & 31u;
    if (steps == 0) {
        const float radius = code == acrossDisc ? acrossRadius : code == loneDisc ? loneRadius : 1;
        return {{}, code == noDisc ? 0 : radius, {}};
    }
    const Vec3f direction = directionAt(n, (code >> 13 & 1u) != 0, code >> 5 & 127u, oneAngles);
    if ((code >> 12 & 1u) == 0)
        return {{direction, static_cast<float>(steps) / 32}, cutRadius, {}};
    return {{direction, static_cast<float>(steps & 15u) / 32}, steps > 16 ? tipRadius : cornerRadius, {}};
}

void DiscCuts::use(const surface::SurfaceDefinition& definition, float radiusOfSupport) {
    if (definition == m_definition && radiusOfSupport == m_radiusOfSupport)
        return;
    m_codes.clear();
    m_complexKnown = false;
    m_definition = definition;
    m_radiusOfSupport = radiusOfSupport;
}

const ComplexCuts* DiscCuts::complexCuts() {
    if (!std::exchange(m_complexKnown, true)) {
        const auto made = ComplexCuts::of(m_model, m_definition, m_radiusOfSupport);
        m_complex = made ? std::make_shared<const ComplexCuts>(*made) : nullptr;
    }
    return m_complex.get();
}

DiscCuts::Found DiscCuts::look(std::span<const SurfelBlock* const> blocks) {
    std::optional<BoundarySubject> bounded;
    if (std::isfinite(m_definition.boundaryLimit))
        bounded.emplace(m_model, m_definition, m_radiusOfSupport);
    const auto labels = cells::LabelLayout::of(*m_model.layout());
    const ComplexCuts* const complex = complexCuts();
    Found out(blocks.size());
    base::parallelChunks(blocks.size(), 4, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::optional<BoundaryCuts> boundary;
        if (bounded)
            boundary.emplace(*bounded);
        SharpCuts sharp(m_model, m_radiusOfSupport);
        std::optional<LabelCuts> creases;
        if (labels)
            creases.emplace(m_model, *labels, m_radiusOfSupport);
        for (std::size_t b = begin; b < end; ++b) {
            CutCodes codes{};
            if (complex) {
                if (complex->cut(*blocks[b], codes))
                    out[b] = std::make_unique<CutCodes>(codes);
                continue;
            }
            bool any = boundary && boundary->cut(*blocks[b], codes);
            any |= creases ? creases->cut(*blocks[b], codes) : sharp.cut(*blocks[b], codes);
            if (any)
                out[b] = std::make_unique<CutCodes>(codes);
        }
    });
    return out;
}

void DiscCuts::prepare(std::span<const SurfelBlock* const> blocks) {
    std::vector<const SurfelBlock*> fresh;
    for (const SurfelBlock* block : blocks)
        if (!m_codes.contains(block))
            fresh.push_back(block);
    if (fresh.empty())
        return;
    Found found = look(fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i)
        m_codes.try_emplace(fresh[i], Kept{surfel::BlockPtr(fresh[i]), std::move(found[i])});
}

std::vector<const SurfelBlock*> DiscCuts::follow(const tree::SurfelTree& to) {
    std::vector<const SurfelBlock*> changed;
    const tree::SurfelTree from = std::exchange(m_model, to);
    if (from == to)
        return changed;
    m_complexKnown = false;
    if (m_codes.empty())
        return changed;
    const tree::Diff diff = tree::diff(from, to);
    for (const surfel::BlockPtr& block : diff.removed)
        m_codes.erase(block.get());
    if (m_codes.empty())
        return changed;
    std::unordered_set<const SurfelBlock*> near;
    forBlocksBeside(diff, to, m_radiusOfSupport, [&](const SurfelBlock& each) {
        if (m_codes.contains(&each))
            near.insert(&each);
    });
    std::vector<const SurfelBlock*> all(near.begin(), near.end());
    Found found = look(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::unique_ptr<CutCodes>& codes = m_codes.at(all[i]).codes;
        const bool same = codes && found[i] ? *codes == *found[i] : !codes && !found[i];
        if (!same)
            changed.push_back(all[i]);
        codes = std::move(found[i]);
    }
    return changed;
}

} // namespace render
