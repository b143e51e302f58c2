#include "core/reduce/by_cells.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/cells/labels.h"
#include "core/process/estimation/part_progress.h"
#include "core/reduce/cell_assembly.h"
#include "core/reduce/cell_parts.h"
#include "core/reduce/counts.h"
#include "core/reduce/ground.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

namespace reduce {

namespace {

/// What a cell keeps beside the fewest for each cell that it meets.
constexpr std::size_t perPartner = 6;
/// Spacings of cells differ by at most this factor, each way, from what one spacing for all would be: a search for
/// cells around a place would find far ones everywhere.
constexpr double widest = 2;
/// Steps in which that for partners is given up where the count does not do, all but the last.
constexpr int leastSteps = 6;

/// A cell, and what is known of it.
struct Part {
    Cell cell;
    std::optional<Ground> ground; ///< nothing where its surfels define hardly any surface of their own
    std::size_t fixed = 0;        ///< a count that it is to have; 0: any

    std::size_t size() const { return cell.size(); }
    /// With `share` of what each cell that it meets asks for.
    std::size_t least(double share) const {
        const auto more = static_cast<std::size_t>(share * double(perPartner * cell.partners));
        return size() <= fewest + 1 ? size() : std::min(size(), fewest + more);
    }
};

std::size_t sumOf(const std::vector<std::size_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

std::vector<std::size_t> leastCounts(const std::vector<Part>& parts, double share) {
    std::vector<std::size_t> out;
    for (const Part& part : parts)
        out.push_back(part.least(share));
    return out;
}

/// What each cell keeps at least, of few samples less for each cell that it meets.
std::vector<std::size_t> leastCounts(const std::vector<Part>& parts, std::size_t count) {
    std::vector<std::size_t> out;
    for (int step = leastSteps; step > 0; --step)
        if (out = leastCounts(parts, double(step) / leastSteps); sumOf(out) <= count)
            return out;
    throw base::Error(std::to_string(count) + " surfels do not keep the edges between " + std::to_string(parts.size()) +
                          " cells",
                      "reduce", "choose a count of at least " + std::to_string(sumOf(out)));
}

/// Counts for the cells by their weights, within what each may have.
std::vector<std::size_t> countsFor(const std::vector<Part>& parts, const std::vector<double>& weights, double size,
                                   std::size_t count) {
    const std::vector<std::size_t> keeps = leastCounts(parts, count);
    std::vector<std::size_t> least, most;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double even = double(count) * double(parts[i].size()) / size;
        const auto floor = static_cast<std::size_t>(even / (widest * widest));
        least.push_back(std::clamp(floor, keeps[i], parts[i].size()));
        most.push_back(
            std::clamp(static_cast<std::size_t>(std::ceil(even * widest * widest)), least.back(), parts[i].size()));
        if (parts[i].fixed > 0)
            least.back() = most.back() = parts[i].fixed;
    }
    if (sumOf(least) > count)
        least = keeps;
    if (sumOf(most) < count)
        for (std::size_t i = 0; i < parts.size(); ++i)
            most[i] = parts[i].size();
    return apportion(weights, least, most, count);
}

/// What may lie beside a cell's samples.
Rims rimsBeside(const Rims& rims, const base::Box3f& cell) {
    Rims out;
    for (std::size_t i = 0; i < rims.position.size(); ++i)
        if (cell.distanceSq(rims.position[i]) < lengthSq(cell.hi - cell.lo))
            out.position.push_back(rims.position[i]), out.normal.push_back(rims.normal[i]),
                out.outward.push_back(rims.outward[i]);
    return out;
}

/// Looks at each cell once, for as many samples.
void findGrounds(const surface::Surface& model, const Rims& rims, const std::vector<std::size_t>& counts,
                 std::vector<Part>& parts, const base::Progress& progress) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        progress.step(double(i) / double(parts.size()), "Measuring the surface");
        if (counts[i] >= parts[i].size() || parts[i].size() <= fewest + 1)
            continue;
        try {
            const surface::Surface own = surfaceOf(model, parts[i].cell);
            parts[i].ground = groundFor(own, counts[i], rimsBeside(rims, own.tree().bounds()), {{}, progress.cancel});
        } catch (const base::Error&) { // its surfels are few, on one line, or rough
        }
    }
}

/// Nothing where the cell stays as it is, or no samples can be fitted to it.
std::optional<Reduced> fitted(Part& part, std::size_t count, Shapes shapes, bool last, const base::Progress& progress) {
    if (count >= part.size() || !part.ground)
        return std::nullopt;
    try {
        return reduced(*part.ground, count, shapes, !last, progress);
    } catch (const base::Error&) { // too few of its surfels have feet
        return std::nullopt;
    }
}

/// fn(i, progress of its own) for each of the cells in their order.
template <class Fn>
void forParts(const std::vector<Part>& parts, const base::Progress& progress, const Fn& fn) {
    double size = 0, done = 0;
    for (const Part& part : parts)
        size += double(part.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double until = done + double(parts[i].size()) / size;
        fn(i, process::part(progress, done, until));
        done = until;
    }
}

/// By what balls of an even spacing err: where another sample takes as much from the sum of squared errors, it is
/// least. Cells that nothing can be fitted to keep what they had of the even ones.
std::vector<std::size_t> countsByResult(const surface::Surface& model, const Rims& rims, std::vector<Part>& parts,
                                        std::size_t count, const base::Progress& progress) {
    const double size = double(model.tree().size());
    std::vector<double> weights;
    for (const Part& part : parts)
        weights.push_back(double(part.size()));
    const std::vector<std::size_t> even = countsFor(parts, weights, size, count);
    findGrounds(model, rims, even, parts, process::part(progress, 0, 0.2));
    forParts(parts, process::part(progress, 0.2, 1), [&](std::size_t i, const base::Progress& own) {
        const std::optional<Reduced> tried = fitted(parts[i], even[i], Shapes::Spheres, false, own);
        if (!tried && even[i] < parts[i].size())
            parts[i].fixed = even[i];
        const Report report = tried ? tried->report : Report{.count = parts[i].size()};
        weights[i] = std::max(1e-30, std::pow(double(parts[i].size()) * report.surfaceRms * report.surfaceRms *
                                                  std::pow(double(report.count), 2 * fall),
                                              1 / (2 * fall + 1)));
    });
    return countsFor(parts, weights, size, count);
}

/// The error that cells may have of which fewer samples are taken, so that all samples together keep the one asked
/// for: those whose own samples are no nearer to their surface stay whole, and have a part in it.
double errorLeft(const std::vector<Part>& parts, double error, double size) {
    double left = error;
    for (std::size_t k = 0; k <= parts.size(); ++k) {
        double sum = size * error * error, samples = 0, own = 0;
        for (const Part& part : parts) {
            const double n = double(part.size()), d = part.ground ? part.ground->dense.rms : 0;
            own += n * d * d;
            if (part.ground && d < left)
                samples += n;
            else
                sum -= n * d * d;
        }
        if (!(sum > 0)) {
            std::ostringstream said;
            said << "no count keeps an error of " << error << ": the cells' own surfaces are " << std::sqrt(own / size)
                 << " from their points";
            throw base::Error(said.str(), "reduce", "choose a larger error");
        }
        const double next = samples > 0 ? std::min(error, std::sqrt(sum / samples)) : error;
        if (next >= left)
            return left;
        left = next;
    }
    return left;
}

Reduced toCount(const surface::Surface& model, std::vector<Part>& parts, const Wish& wish,
                const base::Progress& progress) {
    CellAssembly out(model, process::part(progress, 0, 0.05));
    const std::vector<std::size_t> counts =
        countsByResult(model, out.rims(), parts, wish.count, process::part(progress, 0.05, 0.4));
    forParts(parts, process::part(progress, 0.4, 0.95), [&](std::size_t i, const base::Progress& own) {
        Part& part = parts[i];
        if (const std::optional<Reduced> reduced = fitted(part, counts[i], wish.shapes, true, own))
            out.fit(part.cell, part.ground->dense.places, *reduced);
        else if (counts[i] >= part.size())
            out.keep(part.cell, part.ground ? part.ground->dense.rms : 0);
        else
            out.pick(part.cell, counts[i]);
        part.ground.reset();
    });
    return out.result(process::part(progress, 0.95, 1));
}

Reduced toError(const surface::Surface& model, std::vector<Part>& parts, const Wish& wish,
                const base::Progress& progress) {
    CellAssembly out(model, process::part(progress, 0, 0.05));
    std::vector<std::size_t> counts;
    for (const Part& part : parts)
        counts.push_back(part.size() / 10);
    findGrounds(model, out.rims(), counts, parts, process::part(progress, 0.05, 0.15));
    const double error = errorLeft(parts, wish.error, double(model.tree().size()));
    bool any = false;
    forParts(parts, process::part(progress, 0.15, 0.95), [&](std::size_t i, const base::Progress& own) {
        Part& part = parts[i];
        std::optional<Reduced> reduced;
        try {
            if (part.ground && part.ground->dense.rms < error)
                reduced = reducedToError(*part.ground, error, wish.shapes, own);
        } catch (const base::Error&) { // fewer surfels do not keep it
        }
        if (reduced)
            out.fit(part.cell, part.ground->dense.places, *reduced), any = true;
        else
            out.keep(part.cell, part.ground ? part.ground->dense.rms : 0);
        part.ground.reset();
    });
    if (!any)
        throw base::Error("fewer surfels than the model has do not keep that error", "reduce", "choose a larger error");
    return out.result(process::part(progress, 0.95, 1));
}

} // namespace

bool hasCells(const surface::Surface& model) {
    return model.definition().manifold == surface::Manifold::Surface &&
           cells::LabelLayout::of(*model.tree().layout()).has_value();
}

Reduced reduceCells(const surface::Surface& model, const Wish& wish, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    std::vector<Part> parts;
    for (Cell& cell : cellsOf(model))
        parts.push_back({std::move(cell), {}, 0});
    return wish.error > 0 ? toError(model, parts, wish, progress) : toCount(model, parts, wish, progress);
}

} // namespace reduce
