#include "core/session/document.h"

#include <cassert>

namespace session {

Document::Document(SceneModel model) {
    Scene alone;
    alone.models = {std::move(model)};
    reset(std::move(alone), {});
}

base::Hash128 Document::hash() const {
    return contentHash(m_scene);
}

void Document::commit(surface::Surface next, const std::string& label, layers::How how) {
    layers::Stack stack = layers();
    if (!stack.empty() && !layers::Channels::of(*next.tree().layout(), stack))
        stack = {};
    if (!stack.empty()) {
        if (how == layers::How::Record && !layers::takesStrokes(stack))
            how = layers::How::Keep;
        next = {layers::reconciled(surface().tree(), next.tree(), stack, how), next.definition()};
    }
    restack(std::move(next), std::move(stack), label);
}

void Document::commitMoved(surface::Surface next, const base::Vec3d& origin, const std::string& label) {
    commit(std::move(next), label, layers::How::Keep);
    if (origin == provenance().origin)
        return;
    const auto own = std::make_shared<Provenance>(provenance());
    own->origin = origin;
    active().provenance = own;
}

void Document::restack(surface::Surface next, layers::Stack layers, const std::string& label) {
    Scene scene = m_scene;
    scene.models[scene.active].surface = std::move(next);
    scene.models[scene.active].layers = std::move(layers);
    step(std::move(scene), label);
}

void Document::turnUp(base::UpAxis up, const std::string& label) {
    Scene scene = m_scene;
    scene.models[scene.active].up = up;
    step(std::move(scene), label);
}

void Document::rearrange(Scene next, const std::string& label) {
    number(next);
    step(std::move(next), label);
}

void Document::amend(Scene now) {
    assert(canUndo() && m_future.empty());
    m_scene = std::move(now);
}

void Document::number(Scene& scene) {
    assert(scene.active < scene.models.size());
    for (SceneModel& each : scene.models)
        if (each.id == 0)
            each.id = ++m_lastModel;
}

void Document::step(Scene next, const std::string& label) {
    m_future.clear();
    const std::size_t bytes = unsharedBytes(m_scene, next);
    m_past.push_back({std::exchange(m_scene, std::move(next)), label, bytes, m_revision});
    m_revision = ++m_lastRevision;
    enforceBudget();
}

void Document::reset(surface::Surface surface, Provenance provenance, base::UpAxis up, layers::Stack layers) {
    Scene scene;
    SceneModel& model = scene.models.front();
    model.name = nameOf(provenance.path);
    model.surface = std::move(surface);
    model.up = up;
    model.layers = std::move(layers);
    const std::filesystem::path path = provenance.path;
    model.provenance = std::make_shared<Provenance>(std::move(provenance));
    reset(std::move(scene), path);
}

void Document::reset(Scene scene, const std::filesystem::path& path) {
    m_past.clear();
    m_future.clear();
    number(scene);
    m_scene = std::move(scene);
    m_path = path;
    m_savedRevision = m_revision = ++m_lastRevision;
}

void Document::saved(const std::filesystem::path& path) {
    m_path = path;
    m_savedRevision = m_revision;
}

/// The nearest step of `from` becomes the present, and the present the nearest step of `to`.
void Document::shift(std::deque<Step>& from, std::deque<Step>& to) {
    assert(!from.empty());
    Step step = std::move(from.back());
    from.pop_back();
    const std::size_t bytes = unsharedBytes(m_scene, step.scene);
    to.push_back({std::exchange(m_scene, std::move(step.scene)), std::move(step.label), bytes, m_revision});
    m_revision = step.revision;
}

std::vector<std::string> Document::pastLabels() const {
    std::vector<std::string> out;
    for (const Step& step : m_past)
        out.push_back(step.label);
    return out;
}

std::vector<std::string> Document::futureLabels() const {
    std::vector<std::string> out;
    for (auto step = m_future.rbegin(); step != m_future.rend(); ++step)
        out.push_back(step->label);
    return out;
}

void Document::undo() {
    shift(m_past, m_future);
}

void Document::redo() {
    shift(m_future, m_past);
}

void Document::setHistoryBudget(std::size_t bytes) {
    m_budget = bytes;
    enforceBudget();
}

std::size_t Document::historyBytes() const {
    std::size_t sum = 0;
    for (const auto* steps : {&m_past, &m_future})
        for (const Step& step : *steps)
            sum += step.bytes;
    return sum;
}

void Document::enforceBudget() {
    std::size_t held = historyBytes();
    for (auto* steps : {&m_past, &m_future})
        while (held > m_budget && !steps->empty() && m_past.size() + m_future.size() > 1) {
            held -= steps->front().bytes;
            steps->pop_front();
        }
}

io::FileModel Document::fileModel() const {
    return session::fileModel(active());
}

} // namespace session
