#include "core/session/commands/scans/clean_steps.h"

#include "core/base/error.h"
#include "core/base/unit_normal.h"
#include "core/process/cleaning/denoise.h"
#include "core/process/cleaning/find_outliers.h"
#include "core/process/cleaning/list_change.h"
#include "core/process/cleaning/normal_ways.h"
#include "core/process/cleaning/take_out.h"
#include "core/process/cleaning/thin.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/duplicates.h"
#include "core/process/estimation/orientation/global_orientation.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/prepare.h"
#include "core/session/commands/scans/viewpoints.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace session::clean {

using base::Vec3d, base::Vec3f;
using nlohmann::json;
using surface::Surface;

namespace {

/// "12 of 3400 points".
std::string countOf(std::size_t count, std::size_t all) {
    return std::to_string(count) + " of " + std::to_string(all) + (all == 1 ? " point" : " points");
}

std::string textOf(double value) {
    std::ostringstream out;
    out.precision(4);
    out << value;
    return out.str();
}

std::string percent(double share) {
    return textOf(std::round(share * 1e4) / 100) + " %";
}

/// Surfels with full masks are protected from tools, and from this.
bool isMasked(const surfel::SurfelList& points, std::size_t i) {
    return points.layout->masks && points.items[i].mask >= 1;
}

void refuseCurve(const Surface& surface) {
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) + " has no such thing", {},
                          "use it on surfaces");
}

Vec3d viewpointOf(const Context& context, const json& value) {
    Vec3d out;
    if (!value.is_null()) {
        if (!value.is_array() || value.size() != 3)
            throw base::Error("\"viewpoint\" is not a place", {}, "write three numbers: [x,y,z]");
        for (std::size_t k = 0; k < 3; ++k) {
            if (!value[k].is_number() || !std::isfinite(value[k].get<double>()))
                throw base::Error("\"viewpoint\" is not a place", {}, "write three numbers: [x,y,z]");
            out[k] = value[k].get<double>();
        }
    }
    return out - context.document.provenance().origin;
}

surfel::AttributeLayoutPtr layoutWith(const surfel::AttributeLayoutPtr& layout, bool oriented) {
    auto out = std::make_shared<surfel::AttributeLayout>(*layout);
    out->normals = true;
    out->oriented = oriented;
    return out;
}

std::vector<Vec3f> normalsIn(const process::Cloud& cloud, const surfel::SurfelList& points) {
    std::vector<Vec3f> out(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        out[cloud.places()[i]] += points.items[i].normal;
    for (std::size_t i = points.size(); i-- > 0;) { // where they cancel, the first one's
        Vec3f& n = out[cloud.places()[i]];
        if (!(length(n) > 0.1f))
            n = points.items[i].normal;
    }
    for (Vec3f& n : out)
        n = base::normalized(n, {0, 0, 1});
    return out;
}

/// The version with its surfels' normals turned and flagged. Everything that hangs on sides is made anew.
Surface withNormals(Context& context, const Surface& surface, process::ListChange change, bool oriented) {
    change.layout = layoutWith(surface.tree().layout(), oriented);
    const Surface out(process::changed(surface.tree(), change), surface.definition());
    return process::redefine(out, surface.definition(), context.progress);
}

std::size_t flippedBetween(const surfel::SurfelList& points, const std::vector<Vec3f>& normals) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        out += dot(points.items[i].normal, normals[i]) < 0;
    return out;
}

} // namespace

void commit(Context& context, Surface next, const std::string& label, layers::How how) {
    const Surface& now = context.document.surface();
    if (!(next.tree() == now.tree()) || !(*next.tree().layout() == *now.tree().layout()) ||
        !(next.definition() == now.definition()))
        context.document.commit(std::move(next), label, how);
}

Surface duplicates(Context& context, const Surface& surface) {
    surfel::SurfelList points = surface.tree().surfels();
    const process::Cloud cloud(points.items, process::part(context.progress, 0, 0.3));
    const process::CloudNeighbours near = process::neighboursOf(cloud, 0, process::part(context.progress, 0.3, 0.7));
    const std::vector<std::uint32_t> first =
        process::firstOfDuplicates(cloud, near, process::part(context.progress, 0.7, 0.9));
    std::vector<std::uint8_t> removed(points.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < first.size(); ++i) { // none where there is no duplicate
        removed[i] = first[i] != i;
        count += removed[i];
    }
    context.figures["duplicates"] = static_cast<double>(count);
    context.messages.push_back("Duplicates: " + countOf(count, removed.size()) +
                               " stood in the place of others and were merged with them.");
    if (count == 0)
        return surface;
    process::ListChange change;
    for (const surfel::Surfel& s : points.items)
        change.normals.push_back(s.normal);
    process::mergeDuplicates(points, first);
    for (std::size_t i = 0, kept = 0; i < removed.size(); ++i)
        if (!removed[i])
            change.normals[i] = points.items[kept++].normal;
    change.removed = std::move(removed);
    return {process::changed(surface.tree(), change), surface.definition()};
}

Surface mixed(Context& context, const Surface& surface, const json& viewpoint, double limit) {
    refuseCurve(surface);
    const surfel::SurfelList points = surface.tree().surfels();
    const std::optional<process::Eyes> eyes =
        viewpoint.is_null() ? eyesOf(context.document, points) : process::Eyes{{viewpointOf(context, viewpoint)}, {}};
    if (!eyes)
        throw base::Error("mixed pixels are told by the line of sight, and the file does not tell where the scanner "
                          "stood",
                          {}, "give the viewpoint, or take out what is off its surface (outliers, surface)");
    std::vector<std::uint8_t> removed =
        process::findMixedPixels(points, *eyes, {limit}, process::part(context.progress, 0, 0.5));
    for (std::size_t i = 0; i < removed.size(); ++i)
        removed[i] = removed[i] && !isMasked(points, i);
    const auto count = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 1));
    context.figures["mixed"] = static_cast<double>(count);
    context.figures["viewpoints"] = static_cast<double>(eyes->places.size());
    context.messages.push_back(
        "Mixed pixels: " + countOf(count, points.size()) + " removed, " +
        percent(static_cast<double>(count) / static_cast<double>(points.size())) + ", seen from " +
        (!viewpoint.is_null()       ? "the viewpoint told."
         : eyes->places.size() == 1 ? "the file's viewpoint."
                                    : "the file's " + std::to_string(eyes->places.size()) + " viewpoints."));
    return process::takenOut(surface, std::move(removed), process::Supports::WhereChanged,
                             process::part(context.progress, 0.5, 1));
}

Surface outliers(Context& context, const Surface& surface, const std::string& way, const json& limit) {
    process::OutlierQuestion question;
    question.way = way == "radius"    ? process::OutlierWay::Radius
                   : way == "islands" ? process::OutlierWay::Islands
                   : way == "surface" ? process::OutlierWay::Surface
                                      : process::OutlierWay::Statistical;
    if (!limit.is_null())
        question.limit = limit.get<double>();
    const surfel::SurfelList points = surface.tree().surfels();
    const process::Cloud cloud(points.items, process::part(context.progress, 0, 0.1));
    const std::vector<std::uint8_t> found =
        process::findOutliers(cloud, question, process::part(context.progress, 0.1, 0.5));
    std::vector<std::uint8_t> removed(points.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < removed.size(); ++i) {
        removed[i] = found[cloud.places()[i]] && !isMasked(points, i);
        count += removed[i];
    }
    context.figures["outliers"] = static_cast<double>(count);
    context.messages.push_back("Outliers (" + way + "): " + countOf(count, points.size()) + " removed, " +
                               percent(static_cast<double>(count) / static_cast<double>(points.size())) + ".");
    return process::takenOut(surface, std::move(removed), process::Supports::WhereChanged,
                             process::part(context.progress, 0.5, 1));
}

Surface denoise(Context& context, const Surface& surface, const json& sigma) {
    refuseCurve(surface);
    const surfel::SurfelList points = surface.tree().surfels();
    const process::Cloud cloud(points.items, process::part(context.progress, 0, 0.1));
    process::NoiseLevel noise;
    if (sigma.is_number()) {
        noise.middle = sigma.get<double>();
        noise.at.assign(cloud.size(), static_cast<float>(noise.middle));
    } else {
        noise = process::estimateNoise(cloud, process::part(context.progress, 0.1, 0.4));
    }
    const process::Denoised result = process::denoised(cloud, normalsIn(cloud, points), points.layout->oriented,
                                                       noise.at, process::part(context.progress, 0.4, 0.9));
    process::ListChange change;
    double sum = 0, most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const surfel::Surfel& s = points.items[i];
        const std::uint32_t place = cloud.places()[i];
        const float free = points.layout->masks ? 1 - std::clamp(s.mask, 0.0f, 1.0f) : 1;
        const bool alike = dot(result.normals[place], s.normal) >= 0;
        const Vec3f normal = alike ? result.normals[place] : -result.normals[place];
        change.positions.push_back(s.position + (result.positions[place] - s.position) * free);
        change.normals.push_back(free > 0 ? base::unitNormal(s.normal + (normal - s.normal) * free) : s.normal);
        const double moved = static_cast<double>(distance(change.positions.back(), s.position));
        sum += moved * moved, most = std::max(most, moved);
    }
    const double rms = std::sqrt(sum / static_cast<double>(points.size()));
    context.figures["sigma"] = noise.middle;
    context.figures["moved_rms"] = rms;
    context.figures["moved_max"] = most;
    context.messages.push_back("Denoise: noise of " + textOf(noise.middle) +
                               (sigma.is_number() ? " as told" : " found") + ", points moved by " + textOf(rms) +
                               " (rms), " + textOf(most) + " at most.");
    const Surface out(process::changed(surface.tree(), change), surface.definition());
    return process::redefine(out, surface.definition(), process::part(context.progress, 0.9, 1));
}

Surface thin(Context& context, const Surface& surface, float spacing) {
    const surfel::SurfelList points = surface.tree().surfels();
    std::vector<std::uint8_t> removed = process::thinned(points, spacing, process::part(context.progress, 0, 0.5));
    const auto count = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 1));
    context.figures["thinned"] = static_cast<double>(count);
    context.messages.push_back("Thin: " + countOf(count, points.size()) + " removed, " +
                               std::to_string(points.size() - count) + " left that are no closer than " +
                               textOf(static_cast<double>(spacing)) + ".");
    return process::takenOut(surface, std::move(removed), process::Supports::Everywhere,
                             process::part(context.progress, 0.5, 1));
}

/// That signs of normals are compared with.
constexpr std::size_t orientNeighbours = 12;

/// Towards the viewpoint, each by itself; how many of them see it at so flat an angle that noise decides.
static std::size_t turnTo(const Vec3d& viewpoint, const process::Cloud& cloud, std::vector<Vec3f>& normals) {
    constexpr double flat = 0.1; // cosine
    std::size_t doubtful = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vec3d way = base::normalized(viewpoint - base::cast<double>(cloud.positions()[i]));
        const double cosine = dot(way, base::cast<double>(normals[i]));
        doubtful += std::abs(cosine) < flat;
        if (cosine < 0)
            normals[i] = -normals[i];
    }
    return doubtful;
}

static std::vector<Vec3f> normalsBy(Context& context, const surfel::SurfelList& points, const process::Cloud& cloud,
                                    const std::string& way) {
    if (way == "jet")
        return process::quadricNormals(cloud, process::part(context.progress, 0.1, 0.7));
    std::vector<Vec3f> out = process::normalsOf(cloud, 18, process::part(context.progress, 0.1, 0.7));
    if (way != "grid")
        return out;
    const std::optional<std::vector<Vec3f>> grid = process::gridNormals(points, context.progress);
    if (!grid)
        throw base::Error("the points are no ordered grid: they have no attributes \"row\" and \"column\"", {},
                          "use plane or jet");
    for (std::size_t i = 0; i < points.size(); ++i)
        if ((*grid)[i] != Vec3f{})
            out[cloud.places()[i]] = (*grid)[i];
    return out;
}

Surface normals(Context& context, const Surface& surface, const std::string& way, const json& viewpoint) {
    refuseCurve(surface);
    const surfel::SurfelList points = surface.tree().surfels();
    const process::Cloud cloud(points.items, process::part(context.progress, 0, 0.1));
    std::vector<Vec3f> fresh = normalsBy(context, points, cloud, way);
    bool oriented = points.layout->normals && points.layout->oriented;
    if (way == "viewpoint") {
        turnTo(viewpointOf(context, viewpoint), cloud, fresh);
        oriented = true;
    } else if (oriented) {
        const std::vector<Vec3f> side = normalsIn(cloud, points);
        for (std::size_t i = 0; i < fresh.size(); ++i)
            fresh[i] = dot(fresh[i], side[i]) < 0 ? -fresh[i] : fresh[i];
    } else {
        const process::NeighbourTable links =
            process::nearestTable(cloud, orientNeighbours, process::part(context.progress, 0.7, 0.8));
        oriented = process::orientGlobally(cloud, links, fresh, process::part(context.progress, 0.8, 0.9));
    }
    process::ListChange change;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        change.normals.push_back(fresh[cloud.places()[i]]);
        const double cosine = std::abs(static_cast<double>(dot(points.items[i].normal, change.normals.back())));
        const double angle = std::acos(std::min(1.0, cosine));
        sum += angle * angle;
    }
    const double turned = std::sqrt(sum / static_cast<double>(points.size())) * 57.29577951308232;
    context.figures["turned_deg"] = turned;
    context.messages.push_back("Normals (" + way + "): " + std::to_string(points.size()) + " estimated, turned by " +
                               textOf(turned) + " degrees (rms)" +
                               (oriented ? "." : "; the surface has no two sides, they stay unoriented."));
    return withNormals(context, surface, std::move(change), oriented);
}

namespace {

/// Normals as a way to orient them turns them, nothing committed and nothing told.
struct Orientation {
    std::vector<Vec3f> normals; ///< of each surfel
    std::size_t flipped = 0;
    double doubtful = 0; ///< share
    bool sided = true;   ///< else the surface has no two sides
};

Orientation orientation(Context& context, const Surface& surface, const std::string& way, const json& viewpoint) {
    const surfel::SurfelList points = surface.tree().surfels();
    const process::Cloud cloud(points.items, process::part(context.progress, 0, 0.1));
    std::vector<Vec3f> turned = normalsIn(cloud, points);
    std::size_t flat = 0;
    Orientation out;
    const bool sided = points.layout->normals && points.layout->oriented;
    const auto given = sided ? process::Sides::Mostly : process::Sides::Unknown;
    const process::NeighbourTable links =
        process::nearestTable(cloud, orientNeighbours, process::part(context.progress, 0.1, 0.3));
    const base::Progress turning = process::part(context.progress, 0.3, 0.7);
    if (way == "viewpoint")
        flat = turnTo(viewpointOf(context, viewpoint), cloud, turned);
    else
        out.sided = way == "global" ? process::orientGlobally(cloud, links, turned, turning, given)
                                    : process::orient(cloud, links, turned, turning, given);
    const std::vector<std::uint8_t> doubts =
        process::doubtfulSigns(cloud, links, turned, process::part(context.progress, 0.7, 0.8));
    const auto contradicted = static_cast<std::size_t>(std::count(doubts.begin(), doubts.end(), 1));
    out.doubtful = static_cast<double>(std::max(contradicted, flat)) / static_cast<double>(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3f &was = points.items[i].normal, &side = turned[cloud.places()[i]];
        out.normals.push_back(dot(was, side) < 0 ? -was : was);
    }
    out.flipped = flippedBetween(points, out.normals);
    return out;
}

Surface withOrientation(Context& context, const Surface& surface, const std::string& way, Orientation found) {
    context.figures["flipped"] = static_cast<double>(found.flipped);
    context.figures["doubtful"] = found.doubtful;
    context.messages.push_back("Orientation (" + way + "): " + countOf(found.flipped, surface.tree().size()) +
                               " turned over, " + percent(found.doubtful) + " in doubt" +
                               (found.sided ? "." : "; the surface has no two sides, its normals stay unoriented."));
    process::ListChange change;
    if (found.sided)
        change.normals = std::move(found.normals);
    return withNormals(context, surface, std::move(change), found.sided);
}

} // namespace

Surface orient(Context& context, const Surface& surface, const std::string& way, const json& viewpoint) {
    refuseCurve(surface);
    return withOrientation(context, surface, way, orientation(context, surface, way, viewpoint));
}

Surface guessedAgain(Context& context, const Surface& surface, const json& viewpoint) {
    const Document& document = context.document;
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    if (surface.definition().manifold != surface::Manifold::Surface || !document.provenance().guessedSides ||
        document.canUndo() || !layout.normals || !layout.oriented ||
        surface.tree().size() == document.surface().tree().size())
        return surface;
    const std::string way = viewpoint.is_null() ? "global" : "viewpoint"; // the former as opening does
    Orientation found = orientation(context, surface, way, viewpoint);
    return found.flipped == 0 || !found.sided ? surface : withOrientation(context, surface, way, std::move(found));
}

} // namespace session::clean
