#include "core/reduce/by_cells.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/cells/labels.h"
#include "core/process/estimation/part_progress.h"
#include "core/reduce/assemble.h"
#include "core/reduce/counts.h"
#include "core/reduce/coverage.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

namespace reduce {

namespace {

/// What a cell keeps beside the fewest for each cell that it meets.
constexpr std::size_t perPartner = 6;
/// Spacings of cells differ by at most this factor, each way, from what one spacing for all would be: a search for
/// cells around a place would find far ones everywhere.
constexpr double widest = 2;

struct Cell {
    surfel::SurfelList surfels;
    std::size_t partners = 0;

    std::size_t size() const { return surfels.size(); }
    std::size_t least() const { return std::min(size(), fewest + perPartner * partners); }
};

std::vector<Cell> cellsOf(const surface::Surface& model) {
    const surfel::SurfelList all = model.tree().surfels();
    const cells::LabelLayout labels = *cells::LabelLayout::of(*all.layout);
    std::map<std::uint32_t, Cell> byLabel;
    std::map<std::uint32_t, std::set<std::uint32_t>> partners;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const cells::Label label = labels.at(all.extraOf(i));
        Cell& cell = byLabel[label.cell];
        cell.surfels.layout = all.layout;
        cell.surfels.append(all.items[i], all.extraOf(i));
        if (label.partner != label.cell)
            partners[label.cell].insert(label.partner);
    }
    std::vector<Cell> out;
    for (auto& [label, cell] : byLabel) {
        cell.partners = partners[label].size();
        out.push_back(std::move(cell));
    }
    return out;
}

/// Of its surfels alone, without an end of its own.
surface::Surface surfaceOf(const surface::Surface& model, const surfel::SurfelList& surfels) {
    surface::SurfaceDefinition definition = model.definition();
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return {tree::SurfelTree::build(surfels), definition};
}

/// The spacing that a support stands for, of an ellipsoid that along its long axis.
float spacingOf(const surfel::Surfel& s) {
    return s.support * std::sqrt(std::numbers::pi_v<float> / supportsOver);
}

/// Surfels of a reduced cell are further apart, so creases have theirs within another reach: those of the cell's
/// surfels beside a crease that are nearest, within two spacings, tell all five words of the label.
void label(const Cell& cell, surfel::SurfelList& reduced) {
    const cells::LabelLayout from = *cells::LabelLayout::of(*cell.surfels.layout);
    surfel::SurfelList beside;
    beside.layout = cell.surfels.layout;
    for (std::size_t i = 0; i < cell.size(); ++i)
        if (const cells::Label l = from.at(cell.surfels.extraOf(i)); l.partner != l.cell)
            beside.append(cell.surfels.items[i], cell.surfels.extraOf(i));
    if (beside.items.empty())
        return;
    const tree::SurfelTree creases = tree::SurfelTree::build(beside);
    const cells::LabelLayout at = *cells::LabelLayout::of(*reduced.layout);
    std::vector<cells::Label> labels(reduced.size());
    std::vector<tree::Neighbour> near;
    for (std::size_t i = 0; i < reduced.size(); ++i) {
        const surfel::Surfel& s = reduced.items[i];
        constexpr float reach = 2;
        labels[i] = at.at(reduced.extraOf(i));
        near.clear();
        creases.nearest(s.position, 1, near);
        const cells::Label l = from.at(*near.front().block, near.front().slot);
        if (distance(near.front().block->position(near.front().slot), s.position) <= reach * spacingOf(s))
            labels[i] = l;
        else
            labels[i].partner = labels[i].cell, labels[i].meeting = cells::Meeting::None;
    }
    cells::setLabels(reduced, labels);
}

/// With shapes as the last words, balls where there were none.
surfel::SurfelList withShapes(const surfel::SurfelList& list) {
    surfel::SurfelList out = surfel::withoutShape(list);
    auto layout = std::make_shared<surfel::AttributeLayout>(*out.layout);
    const std::size_t before = layout->words();
    surfel::addShape(*layout);
    const std::size_t words = layout->words(), first = surfel::shapeWord(*layout);
    const bool shaped = surfel::shapeChannel(*list.layout) > 0;
    std::vector<std::uint32_t> extra(list.size() * words);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto own = std::span(extra).subspan(i * words, words);
        std::copy_n(out.extra.begin() + static_cast<std::ptrdiff_t>(i * before), before, own.begin());
        surfel::putShape(own, first,
                         shaped ? surfel::shapeIn(list.extraOf(i), surfel::shapeWord(*list.layout)) : base::Vec3f{});
    }
    out.layout = std::move(layout);
    out.extra = std::move(extra);
    return out;
}

/// What several reports of different samples say together.
class Sum {
  public:
    void add(const Report& r, std::size_t samples) {
        const double n = double(samples);
        m_samples += n;
        m_out.count += r.count;
        m_rms += n * r.rms * r.rms, m_dense += n * r.denseRms * r.denseRms,
            m_surface += n * r.surfaceRms * r.surfaceRms;
        m_normals += n * r.normalsDeg * r.normalsDeg;
        m_out.p999 = std::max(m_out.p999, r.p999), m_out.max = std::max(m_out.max, r.max);
        m_out.surfaceMax = std::max(m_out.surfaceMax, r.surfaceMax);
        m_out.leastSupports = m_any ? std::min(m_out.leastSupports, r.leastSupports) : r.leastSupports;
        m_out.holes += r.holes, m_out.strays += r.strays;
        m_out.ellipsoids = m_out.ellipsoids || r.ellipsoids;
        m_any = true;
    }
    void keep(std::size_t samples) { m_out.count += samples, m_samples += double(samples); }
    Report report() const {
        Report out = m_out;
        const auto mean = [&](double sum) { return m_samples > 0 ? std::sqrt(sum / m_samples) : 0; };
        out.rms = mean(m_rms), out.denseRms = mean(m_dense), out.surfaceRms = mean(m_surface);
        out.normalsDeg = mean(m_normals);
        return out;
    }

  private:
    Report m_out;
    double m_samples = 0, m_rms = 0, m_dense = 0, m_surface = 0, m_normals = 0;
    bool m_any = false;
};

/// Counts for the cells by their weights, within what each may have.
std::vector<std::size_t> countsFor(const std::vector<Cell>& cells, const std::vector<double>& weights, double size,
                                   std::size_t count) {
    std::vector<std::size_t> least, most;
    for (const Cell& cell : cells) {
        const double even = double(count) * double(cell.size()) / size;
        const auto floor = static_cast<std::size_t>(even / (widest * widest));
        least.push_back(std::clamp(floor, cell.least(), cell.size()));
        most.push_back(
            std::clamp(static_cast<std::size_t>(std::ceil(even * widest * widest)), least.back(), cell.size()));
    }
    const std::size_t sum = std::accumulate(least.begin(), least.end(), std::size_t(0));
    if (sum > count)
        for (std::size_t i = 0; i < cells.size(); ++i)
            least[i] = cells[i].least();
    const std::size_t fewestOfAll = std::accumulate(least.begin(), least.end(), std::size_t(0));
    if (fewestOfAll > count)
        throw base::Error(std::to_string(count) + " surfels do not keep the edges between " +
                              std::to_string(cells.size()) + " cells",
                          "reduce", "choose a count of at least " + std::to_string(fewestOfAll));
    if (std::accumulate(most.begin(), most.end(), std::size_t(0)) < count)
        for (std::size_t i = 0; i < cells.size(); ++i)
            most[i] = cells[i].size();
    return apportion(weights, least, most, count);
}

/// Nothing where the cell is to stay as it is: all of it is asked for, it is too small, or no count keeps the error.
std::optional<Reduced> reducedCell(const surface::Surface& model, const Cell& cell, const Wish& wish,
                                   const base::Progress& progress) {
    if (wish.count >= cell.size() || cell.size() <= fewest + 1)
        return std::nullopt;
    try {
        const surface::Surface own = surfaceOf(model, cell.surfels);
        return wish.count > 0 ? reduceToCount(own, wish.count, wish.shapes, progress)
                              : reduceToError(own, wish.error, wish.shapes, progress);
    } catch (const base::Error&) {
        return std::nullopt;
    }
}

/// Each cell by its own wish, in the order of the cells.
std::vector<std::optional<Reduced>> reducedCells(const surface::Surface& model, const std::vector<Cell>& cells,
                                                 const std::vector<Wish>& wishes, const base::Progress& progress) {
    std::vector<std::optional<Reduced>> out;
    double done = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double until = done + double(cells[i].size()) / double(model.tree().size());
        out.push_back(reducedCell(model, cells[i], wishes[i], process::part(progress, done, until)));
        done = until;
    }
    return out;
}

std::vector<Wish> wishesFor(const std::vector<std::size_t>& counts, Shapes shapes) {
    std::vector<Wish> out;
    for (const std::size_t count : counts)
        out.push_back({count, 0, 0, shapes});
    return out;
}

/// By what balls of an even spacing err: where another sample takes as much from the sum of squared errors, it is
/// least.
std::vector<Wish> wishesByResult(const surface::Surface& model, const std::vector<Cell>& cells, const Wish& wish,
                                 const base::Progress& progress) {
    const double size = double(model.tree().size());
    std::vector<double> weights;
    for (const Cell& cell : cells)
        weights.push_back(double(cell.size()));
    const auto tried =
        reducedCells(model, cells, wishesFor(countsFor(cells, weights, size, wish.count), Shapes::Spheres), progress);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Report report = tried[i] ? tried[i]->report : Report{.count = cells[i].size()};
        weights[i] = std::max(1e-30, std::pow(double(cells[i].size()) * report.surfaceRms * report.surfaceRms *
                                                  std::pow(double(report.count), 2 * fall),
                                              1 / (2 * fall + 1)));
    }
    return wishesFor(countsFor(cells, weights, size, wish.count), wish.shapes);
}

/// All surfels in one list, which has shapes where any of them has.
surfel::SurfelList joined(std::vector<surfel::SurfelList> lists) {
    const bool shaped = std::any_of(lists.begin(), lists.end(),
                                    [](const auto& list) { return surfel::shapeChannel(*list.layout) > 0; });
    surfel::SurfelList out;
    for (surfel::SurfelList& list : lists) {
        if (shaped)
            list = withShapes(list);
        out.layout = list.layout;
        out.items.insert(out.items.end(), list.items.begin(), list.items.end());
        out.extra.insert(out.extra.end(), list.extra.begin(), list.extra.end());
    }
    return out;
}

} // namespace

bool hasCells(const surface::Surface& model) {
    return model.definition().manifold == surface::Manifold::Surface &&
           cells::LabelLayout::of(*model.tree().layout()).has_value();
}

Reduced reduceCells(const surface::Surface& model, const Wish& wish, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    const std::vector<Cell> cells = cellsOf(model);
    const double tried = wish.error > 0 ? 0 : 0.4;
    const std::vector<Wish> wishes = wish.error > 0
                                         ? std::vector(cells.size(), wish)
                                         : wishesByResult(model, cells, wish, process::part(progress, 0, tried));
    const auto reduced = reducedCells(model, cells, wishes, process::part(progress, tried, 0.95));
    Sum sum;
    std::vector<surfel::SurfelList> lists;
    Places places;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const surfel::Surfel& s : cells[i].surfels.items)
            places.position.push_back(s.position);
        if (!reduced[i]) {
            sum.keep(cells[i].size());
            lists.push_back(cells[i].surfels);
            continue;
        }
        sum.add(reduced[i]->report, cells[i].size());
        lists.push_back(reduced[i]->surface.tree().surfels());
        label(cells[i], lists.back());
    }
    Reduced out{{tree::SurfelTree::build(joined(std::move(lists))),
                 reducedDefinition(model.definition(), static_cast<int>(supportsOver))},
                sum.report()};
    out.surface = bounded(model, out.surface, places, 0, process::part(progress, 0.95, 1));
    return out;
}

} // namespace reduce
