#include "core/sculpt/stroke/stroke_dabs.h"

#include "core/base/error.h"
#include "core/layers/layer_edits.h"
#include "core/process/resampling/refine_under.h"
#include "core/sculpt/brush_connected.h"
#include "core/sculpt/keep_apart.h"
#include "core/sculpt/stroke/stroke_accumulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sculpt {

using base::Vec3f;

/// Neighbours of a connected surface are this many spacings apart at most: the widest that resampling leaves, with
/// room.
constexpr float connectedReach = 2.2f;
/// A drag's weights are taken half a step ahead; what it may touch is known that far.
constexpr float connectedMargin = 1.1f;
/// Radius under the lightest pressure, as a part of the settings': a brush never vanishes.
constexpr float leastRadius = 0.01f;

namespace {

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }

  private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// What a person calls up: the upright axis as it is seen; from straight above, away from the viewer.
Vec3f seenUpwards(const Vec3f& view, base::UpAxis axis) {
    const Vec3f upright = base::cast<float>(upRow(axis).up), up = upright - view * dot(view, upright);
    if (length(up) > 1e-3f)
        return normalized(up);
    return base::cast<float>(fromStanding(axis, {0, 0, dot(view, upright) < 0 ? -1.0 : 1.0}));
}

} // namespace

Dabs::Dabs(surface::Surface start, StrokeSettings settings, const base::Vec3d& origin,
           std::shared_ptr<const BrushStamp> stamp, const std::atomic<bool>* cancel)
    : m_first(start), m_surface(start), m_base(std::move(start)), m_settings(std::move(settings)),
      m_row(tool(m_settings.tool)), m_accumulate(m_settings.accumulate || m_row.motion != Motion::Along),
      m_images(mirrors(m_settings.symmetry, origin)),
      m_pressureStrength(m_settings.pressureStrength, "pressure-strength"),
      m_pressureRadius(m_settings.pressureRadius, "pressure-radius"), m_anchors(m_images.size()),
      m_places(m_images.size()), m_cancel(cancel) {
    m_pattern.radius = m_settings.radius;
    m_pattern.falloff = m_settings.falloff;
    if (m_settings.falloff == Falloff::Custom)
        m_pattern.curve = std::make_shared<BrushCurve>(m_settings.falloffCurve, "falloff-curve");
    m_pattern.strength = m_settings.invert ? -m_settings.strength : m_settings.strength;
    m_smoothing = movesSurfaces(m_row) ? m_settings.autoSmooth : 0;
    const bool spaced = m_settings.method == StrokeMethod::Space || m_settings.method == StrokeMethod::Line;
    if (m_row.motion == Motion::Along && spaced && m_accumulate) {
        const float share = std::min(1.0f, m_settings.spacing / usualSpacing);
        m_pattern.strength *= share, m_smoothing *= share;
    }
    m_pattern.oriented = m_first.tree().layout()->oriented;
    m_pattern.frontFacing = m_settings.frontFacing;
    m_pattern.stamp = std::move(stamp);
    m_pattern.footprints = !m_settings.resample;
    for (const ToolParameter& parameter : m_row.parameters)
        m_pattern.parameters[parameter.id] = parameter.fallback;
    for (const auto& [id, value] : m_settings.parameters)
        m_pattern.parameters[id] = value;
}

Dabs::Form Dabs::form(const StrokeSample& sample) const {
    const bool addsUp = m_accumulate && m_row.motion == Motion::Along;
    return {m_settings.radius * std::max(leastRadius, m_pressureRadius.value(sample.pressure)),
            m_pressureStrength.value(sample.pressure) * (addsUp ? sample.stride : 1.0f),
            {}};
}

Dabs::Contacts Dabs::contactsOf(const base::Rayf& ray, const Contact& own) const {
    Contacts out{own}; // the first image is the identity
    for (std::size_t i = 1; i < m_images.size(); ++i)
        out.push_back(contact(m_images[i].ray(ray)));
    return out;
}

std::vector<float> Dabs::shares(const Contacts& contacts, float radius) {
    std::vector<float> share(contacts.size(), 0.0f);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!contacts[i])
            continue;
        float overlap = 0;
        for (const auto& other : contacts)
            if (other)
                overlap += std::max(0.0f, 1 - distance(contacts[i]->position, other->position) / (2 * radius));
        share[i] = 1 / overlap;
    }
    return share;
}

Dab Dabs::dabOf(const Contact& at, std::size_t index, const Vec3f& view, const Form& form) {
    Dab dab = m_pattern;
    dab.radius = form.radius;
    const Area area = areaAround(touched(), at, m_settings.normalRadius * form.radius);
    const bool one = m_settings.planeRadius == m_settings.normalRadius;
    dab.centre = at.position;
    dab.normal = at.normal;
    dab.areaNormal = area.normal;
    dab.areaCentre = one ? area.centre : areaAround(touched(), at, m_settings.planeRadius * form.radius).centre;
    dab.view = m_images[index].direction(view);
    dab.strength = std::clamp(dab.strength * form.strength, -1.0f, 1.0f);
    if (!m_anchors[index])
        m_anchors[index] = {at.position, area.normal};
    dab.anchor = m_anchors[index]->position, dab.anchorNormal = m_anchors[index]->normal;
    dab.image = m_images[index].matrix();
    if (m_places[index])
        dab.travel = at.position - *m_places[index];
    m_places[index] = at.position;
    aim(dab, m_images[index], view, form);
    return dab;
}

void Dabs::aim(Dab& dab, const Mirror& image, const Vec3f& view, const Form& form) const {
    Vec3f up = image.direction(seenUpwards(view, m_settings.stampUpright));
    if (form.upwards != Vec3f{})
        up = image.direction(form.upwards);
    else if (m_settings.stampFollows && dab.travel != Vec3f{})
        up = dab.travel;
    const Vec3f& n = dab.areaNormal;
    up = normalized(up - n * dot(n, up), perpendicular(n));
    const Vec3f right = image.reflects() ? cross(n, up) : cross(up, n);
    const float c = std::cos(m_settings.stampAngleRad), s = std::sin(m_settings.stampAngleRad);
    dab.stampUp = up * c - right * s;
    dab.stampRight = right * c + up * s;
    if (dab.stamp && m_sampling.started())
        dab.stampLevel = dab.stamp->levelFor(m_sampling.spacing() / dab.radius);
}

void Dabs::begin(const Contact& first) {
    if (!m_depth)
        m_depth = first.distance;
    if (m_sampling.started())
        return;
    refineUnder(first.position, m_settings.radius);
    m_sampling.start(touched(), first.position, m_settings.graded, m_layers);
}

/// Contacts and areas of all images are found before any of them is applied, so that a symmetric model keeps symmetric
/// contacts.
void Dabs::dabAt(const StrokeSample& sample, const Contact& own, const Form& form) {
    begin(own);
    const Contacts contacts = contactsOf(sample.ray, own);
    const std::vector<float> share = shares(contacts, form.radius);
    std::vector<Dab> all;
    for (std::size_t i = 0; i < m_images.size(); ++i)
        if (contacts[i]) {
            Form shared = form;
            shared.strength *= share[i];
            all.push_back(dabOf(*contacts[i], i, sample.ray.direction, shared));
        }
    apply(all);
}

double Dabs::overlap(float spacing) const {
    if (!m_accumulate || m_row.motion != Motion::Along || m_row.writes == Writes::Count)
        return 1;
    double sum = 1; // the centre's own
    for (int k = 1; static_cast<float>(k) * spacing < 1; ++k) {
        const float r[] = {static_cast<float>(k) * spacing};
        float weight[1], slope[1];
        weights(m_pattern.falloff, 0, r, weight, slope, m_pattern.curve.get());
        sum += 2 * double(weight[0]);
    }
    return sum;
}

/// Each dab touches what the one before has left, as in a stroke.
void Dabs::pile(const StrokeSample& sample, const Contact& own, Form form, double dabs) {
    const double strongest = std::abs(double(m_pattern.strength) * double(form.strength));
    const int count = std::max(1, static_cast<int>(std::ceil(dabs * strongest - 1e-6)));
    form.strength *= static_cast<float>(dabs / count);
    dabAt(sample, own, form);
    for (int k = 1; k < count; ++k)
        if (const auto touched = contact(sample.ray))
            dabAt(sample, *touched, form);
}

void Dabs::checkCancelled() const {
    if (m_cancel && m_cancel->load(std::memory_order_relaxed))
        throw base::Cancelled();
}

void Dabs::apply(std::span<const Dab> images) {
    const Stopwatch watch;
    for (const Dab& dab : images) {
        checkCancelled();
        applyOne(dab);
    }
    if (m_settings.resample && m_accumulate && m_sampling.due())
        m_surface = m_sampling.resampleDue(m_surface);
    ++m_count;
    m_seconds.push_back(watch.seconds());
}

surface::Surface Dabs::preview(std::span<const Dab> images) const {
    surface::Surface out = m_surface;
    for (Dab dab : images) {
        checkCancelled();
        if (refines())
            out = process::refinedUnder(out, dab.centre, dab.radius).value_or(out);
        complete(dab, out);
        out = {out.tree().apply(edited(out, dab)), out.definition()};
        out = {out.tree().apply(smoothing(out, dab)), out.definition()};
    }
    return out;
}

void Dabs::join(Dab& dab, const surface::Surface& version) const {
    if (m_settings.connected && m_sampling.started())
        dab.connected =
            std::make_shared<Connected>(version.tree(), Contact{dab.centre, dab.normal, 0},
                                        connectedMargin * dab.radius, connectedReach * m_sampling.spacing());
}

void Dabs::complete(Dab& dab, const surface::Surface& version) const {
    join(dab, version);
    dab.first = &m_first;
    dab.past = m_past;
}

/// Dabs that do not add up begin anew from there, as where surfels come or go otherwise.
void Dabs::refineUnder(const Vec3f& centre, float radius) {
    if (!refines())
        return;
    const auto along = [&](const tree::SurfelTree& tree, tree::Edit edit) {
        return m_layers ? layers::carried(tree, std::move(edit), *m_layers) : std::move(edit);
    };
    const std::optional<surface::Surface> finer = process::refinedUnder(m_surface, centre, radius, along);
    if (!finer)
        return;
    m_sampling.refined(m_surface.tree(), *finer, centre, radius);
    m_surface = *finer;
    m_base = m_whole = m_surface;
}

void Dabs::applyOne(Dab dab) {
    refineUnder(dab.centre, dab.radius);
    complete(dab, touched());
    dab.memory = &m_memory;
    if (m_accumulate)
        pileUp(dab);
    else
        holdBack(dab);
    m_past.push_back({dab.centre, dab.radius, dab.strength});
}

tree::Edit Dabs::edited(const surface::Surface& version, const Dab& dab) const {
    tree::Edit edit = m_row.apply(version, dab);
    return movesSurfaces(m_row) ? keptApart(version, std::move(edit), m_sampling.spacing()) : edit;
}

void Dabs::pileUp(Dab dab) {
    const tree::Edit edit = edited(m_surface, dab);
    commit(edit, dab);
    if (m_smoothing == 0)
        return;
    commit(smoothing(m_surface, dab), dab);
}

tree::Edit Dabs::smoothing(const surface::Surface& version, Dab dab) const {
    if (m_smoothing == 0 || m_pattern.strength == 0)
        return {};
    static const ToolRow& smooth = tool("smooth");
    dab.strength = std::min(1.0f, m_smoothing * std::abs(dab.strength / m_pattern.strength));
    dab.parameters.clear();
    dab.memory = nullptr;
    for (const ToolParameter& parameter : smooth.parameters)
        dab.parameters[parameter.id] = parameter.fallback;
    return smooth.apply(version, dab);
}

/// A dab on the first version, of which only what goes farther than the dabs before is kept.
void Dabs::holdBack(const Dab& dab) {
    tree::Edit edit = edited(m_base, dab);
    if (restructures(edit)) { // slots lose their first versions: begin anew from here
        commit(edit, dab);
        m_base = m_whole = m_surface;
        return;
    }
    const surface::Surface dabbed{m_base.tree().apply(edit), m_base.definition()};
    for (const tree::BlockEdit& smoothed : smoothing(dabbed, dab).blocks) {
        const auto at = std::lower_bound(edit.blocks.begin(), edit.blocks.end(), smoothed.block,
                                         [](const tree::BlockEdit& each, std::uint32_t n) { return each.block < n; });
        if (at != edit.blocks.end() && at->block == smoothed.block)
            at->changed = smoothed.changed;
        else
            edit.blocks.insert(at, smoothed);
    }
    if (!m_layers)
        return commit(farthest(m_base.tree(), m_surface.tree(), edit), dab);
    // what a layer's own mask hides in part is shown nearer than it was taken, and would be taken on and on
    tree::Edit next = farthest(m_base.tree(), m_whole.tree(), edit);
    m_whole = {m_whole.tree().apply(next), m_whole.definition()};
    commit(std::move(next), dab);
}

void Dabs::commit(tree::Edit edit, const Dab& dab) {
    if (edit.empty())
        return;
    if (m_layers && m_row.writes == Writes::Count)
        edit = layers::carried(m_surface.tree(), std::move(edit), *m_layers);
    else if (m_layers)
        edit = layers::recorded(m_surface.tree(), std::move(edit), *m_layers);
    if (m_row.writes == Writes::Count) // those make the sampling that they want
        m_sampling.noteCount(edit, dab);
    else if (m_settings.resample)
        m_sampling.note(m_surface.tree(), edit, dab);
    m_surface = {m_surface.tree().apply(edit), m_surface.definition()};
}

void Dabs::restart() {
    m_surface = m_base = m_whole = m_first;
    m_sampling = {};
    std::fill(m_anchors.begin(), m_anchors.end(), std::nullopt);
    std::fill(m_places.begin(), m_places.end(), std::nullopt);
    m_past.clear();
    m_memory.reset();
    m_count = 0;
    m_seconds.clear();
}

bool Dabs::restSlice() {
    if (!m_row.rest || !m_memory)
        return false;
    tree::Edit edit = m_row.rest(m_surface, *m_memory);
    if (edit.empty())
        return false;
    base::Box3f box;
    for (const tree::BlockEdit& each : edit.blocks)
        box.extend(m_surface.tree().block(each.block)->box());
    for (const surfel::Surfel& each : edit.inserted.items)
        box.extend(each.position);
    Dab dab = m_pattern;
    dab.centre = box.centre();
    dab.radius = 0.5f * box.diagonal();
    commit(std::move(edit), dab);
    m_base = m_whole = m_surface;
    return true;
}

bool Dabs::finishSlice() {
    checkCancelled();
    if (restSlice())
        return false;
    if (m_sampling.pending())
        m_surface = m_base = m_whole = m_sampling.resampleSlice(m_surface);
    return !m_sampling.pending();
}

} // namespace sculpt
