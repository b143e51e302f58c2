// Resampling of a whole model to a spacing.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing.h"
#include "core/process/resampling/resample_cells.h"
#include "core/process/resampling/resample_fit.h"
#include "core/process/resampling/resample_set.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace process {

/// The spacing changes by at most this factor at a time: fill looks for room one spacing away, not ten.
constexpr float largestChange = 1.5f;
/// Pairs closer than this part of the spacing lose one to begin with: as far as a scan sees them.
constexpr float thinning = 1.38f;
/// An even sampling passes as good enough though it is finer, or up to two fifths coarser: a few of the holes of a
/// lattice that is 1.3 times too wide are filled, and what they push together leaves no room in the others. Then it has
/// to be thinned before it is filled. What has the spacing already stays.
static bool passesUnseen(float ratio) {
    return ratio < 1.42f && std::abs(ratio - 1) > 0.05f;
}

/// More surfels than this are asked for by mistake.
constexpr double mostSurfels = 2e8;

static void check(const surface::Surface& surface, float spacing, float present) {
    if (!(spacing > 0) || !std::isfinite(spacing))
        throw base::Error("spacing must be a length greater than 0", "resample");
    const double ratio = double(present) / double(spacing);
    const double count = double(surface.tree().size()) * ratio * ratio;
    if (count > mostSurfels)
        throw base::Error("that spacing would make about " + std::to_string(std::llround(count / 1e6)) +
                              " million surfels",
                          "resample", "choose a larger one");
}

/// The same surfels with supports by their places, balls all of them.
template <class SupportAt>
static tree::SurfelTree withSupports(const tree::SurfelTree& tree, const SupportAt& supportAt) {
    const int shape = surfel::shapeChannel(*tree.layout());
    tree::Edit edit;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock&) {
        edit.blocks.push_back({number, {}, {}});
    });
    base::parallelFor(edit.blocks.size(), 16, [&](std::size_t i) {
        const surfel::MutableBlockPtr changed = tree.block(edit.blocks[i].block)->clone();
        for (int slot = 0; slot < changed->size(); ++slot)
            surfel::setBall(*changed, slot, shape, supportAt(changed->position(slot)));
        changed->seal();
        edit.blocks[i].changed = changed;
    });
    edit.inserted.layout = tree.layout();
    return tree.apply(edit);
}

/// Rounds at one spacing, or field, until nothing changes.
static void rounds(ResampleResult& out, const surface::Surface& ground, ResampleOptions options, bool thin,
                   int maxRounds, const std::function<void(double)>& step) {
    out.settled = false;
    for (int round = 0; round < maxRounds && !out.settled; ++round) {
        step(double(round) / maxRounds);
        options.merge = round == 0 && thin ? thinning : mergeDistance;
        const tree::Edit edit = resample(out.surface, selectAll(out.surface.tree()), options, ground);
        out.settled = edit.empty();
        out.surface = {out.surface.tree().apply(edit), ground.definition()};
        ++out.rounds;
    }
}

/// What has another surface by its support or by where it lies is fitted to the one before.
template <class SpacingAt>
static void fitAll(ResampleResult& out, const surface::Surface& ground, Fit fit, const SpacingAt& spacingAt) {
    if (fit == Fit::On)
        out.surface = {fitted(out.surface.tree(), ground, spacingAt), ground.definition()};
}

/// Supports by place, and the fit.
template <class SupportAt, class SpacingAt>
static void finish(ResampleResult& out, const surface::Surface& ground, Fit fit, const SupportAt& supportAt,
                   const SpacingAt& spacingAt) {
    out.surface = {withSupports(out.surface.tree(), supportAt), ground.definition()};
    fitAll(out, ground, fit, spacingAt);
}

static int changesFor(double ratio) {
    return std::max(1, static_cast<int>(std::ceil(std::abs(std::log(ratio)) / std::log(double(largestChange)) - 0.01)));
}

ResampleResult resampleAll(const surface::Surface& surface, float spacing, int maxRounds,
                           const base::Progress& progress, Fit fit) {
    ResampleResult out{surface, 0, false};
    if (surface.tree().empty())
        return out;
    progress.step(0, "Measuring spacing");
    const float present = summarise(spacings(surface.tree().surfels().items, progress)).median;
    check(surface, spacing, present);
    if (auto byCells = resampleEachCell(surface, std::max(present, spacing), progress,
                                        [&](const surface::Surface& one, const base::Progress& step) {
                                            return resampleAll(one, spacing, maxRounds, step, fit);
                                        }))
        return std::move(*byCells);
    const int changes = changesFor(double(spacing) / double(present));
    float was = present;
    for (int change = 1; change <= changes; ++change) {
        ResampleOptions options;
        options.fitRounds = 0; // once, at the end
        const float share = static_cast<float>(change) / static_cast<float>(changes);
        options.spacing = change == changes ? spacing : present * std::pow(spacing / present, share);
        options.support = supportOf(surface.definition(), options.spacing);
        rounds(out, surface, options, passesUnseen(was / options.spacing), maxRounds,
               [&](double done) { progress.step((double(change - 1) + done) / changes, "Resampling"); });
        was = options.spacing;
    }
    const float support = supportOf(surface.definition(), spacing);
    finish(
        out, surface, fit, [&](const base::Vec3f&) { return support; }, [&](const base::Vec3f&) { return spacing; });
    progress.step(1, "Resampling");
    return out;
}

ResampleResult resampleToCount(const surface::Surface& surface, std::size_t count, int maxRounds,
                               const base::Progress& progress, Fit fit) {
    constexpr int tries = 8;
    constexpr double close = 0.01;
    if (count < 4)
        throw base::Error("a surface needs at least 4 points", "resample", "ask for more");
    const surfel::SurfelList list = surface.tree().surfels();
    ResampleResult best{surface, 0, true};
    if (list.items.empty())
        return best;
    // how many more there are than asked for, as a logarithm: falls with the spacing's, with a slope of about -2
    struct Try {
        double spacing, excess;
    };
    const auto excessOf = [&](std::size_t size) {
        return std::log(static_cast<double>(std::max<std::size_t>(size, 1)) / static_cast<double>(count));
    };
    const double present = double(summarise(spacings(list.items, part(progress, 0, 0.05))).median);
    const bool again = fit == Fit::On && hasCells(surface); // each is fitted to its own surface
    Try now{std::log(present) + 0.5 * excessOf(list.size()), 0};
    double chosen = now.spacing;
    std::optional<Try> fine, coarse;
    for (int attempt = 0; attempt < tries; ++attempt) {
        const double whole = again ? 0.8 : 0.95, from = 0.05 + whole * attempt / tries;
        ResampleResult found = resampleAll(surface, static_cast<float>(std::exp(now.spacing)), maxRounds,
                                           part(progress, from, from + whole / tries), Fit::Off);
        now.excess = excessOf(found.surface.tree().size());
        if (attempt == 0 || std::abs(now.excess) < std::abs(excessOf(best.surface.tree().size())))
            best = std::move(found), chosen = now.spacing;
        if (std::abs(now.excess) < close)
            break;
        (now.excess > 0 ? fine : coarse) = now;
        if (fine && coarse) { // between both, not too near to either
            const double share = std::clamp(fine->excess / (fine->excess - coarse->excess), 0.2, 0.8);
            now.spacing = fine->spacing + share * (coarse->spacing - fine->spacing);
        } else {
            now.spacing += 0.5 * now.excess;
        }
    }
    if (again)
        return resampleAll(surface, static_cast<float>(std::exp(chosen)), maxRounds, part(progress, 0.85, 1), fit);
    fitAll(best, surface, fit,
           [spacing = static_cast<float>(std::exp(chosen))](const base::Vec3f&) { return spacing; });
    return best;
}

/// Where the spacing was `present` and shall be the field's, what it is on the way, after a share of it.
static std::shared_ptr<const SpacingField> onTheWay(const surfel::SurfelList& list, const SpacingField& field,
                                                    float present, float share) {
    std::vector<float> targets(list.size());
    base::parallelFor(targets.size(), 256, [&](std::size_t i) {
        targets[i] = present * std::pow(field.at(list.items[i].position) / present, share);
    });
    return std::make_shared<SpacingField>(list, std::move(targets));
}

ResampleResult resampleByCurvature(const surface::Surface& surface, const CurvatureSpacing& by, int maxRounds,
                                   const base::Progress& progress, Fit fit) {
    ResampleResult out{surface, 0, false};
    if (surface.tree().empty())
        return out;
    if (!(by.tolerance > 0) || !(by.finest > 0) || !(by.coarsest >= by.finest) || !std::isfinite(by.coarsest))
        throw base::Error("spacing by curvature needs a tolerance and limits greater than 0", "resample",
                          "the finest must not be wider than the coarsest");
    const surfel::SurfelList list = surface.tree().surfels();
    const float present = summarise(spacings(list.items, progress)).median;
    check(surface, by.finest, present);
    if (auto byCells = resampleEachCell(surface, std::max(present, by.coarsest), progress,
                                        [&](const surface::Surface& one, const base::Progress& step) {
                                            return resampleByCurvature(one, by, maxRounds, step, fit);
                                        }))
        return std::move(*byCells);
    const auto field = std::make_shared<const SpacingField>(SpacingField::byCurvature(surface, by, progress));
    const int changes = std::max(changesFor(double(field->finest()) / double(present)),
                                 changesFor(double(field->coarsest()) / double(present)));
    for (int change = 1; change <= changes; ++change) {
        ResampleOptions options;
        options.fitRounds = 0; // once, at the end
        options.field = change == changes
                            ? field
                            : onTheWay(list, *field, present, static_cast<float>(change) / static_cast<float>(changes));
        options.spacing = options.field->coarsest();
        rounds(out, surface, options, change == changes, maxRounds,
               [&](double done) { progress.step((double(change - 1) + done) / changes, "Resampling"); });
    }
    const auto supportAt = [&](const base::Vec3f& p) { return supportOf(surface.definition(), field->at(p)); };
    finish(out, surface, fit, supportAt, [&](const base::Vec3f& p) { return field->at(p); });
    progress.step(1, "Resampling");
    return out;
}

} // namespace process
