#include "core/session/document.h"

#include <bit>
#include <cassert>

namespace session {

static void appendWords(std::vector<std::uint32_t>& words, std::string_view text) {
    words.push_back(static_cast<std::uint32_t>(text.size()));
    for (const char c : text)
        words.push_back(static_cast<unsigned char>(c));
}

static base::Hash128 layoutHash(const surfel::AttributeLayout& layout) {
    std::vector<std::uint32_t> words;
    for (const std::string& name : layout.names()) {
        appendWords(words, name);
        const surfel::Attribute* attribute = layout.find(name);
        words.push_back(attribute ? static_cast<std::uint32_t>(attribute->type) : ~0u);
    }
    return base::hashWords(words);
}

static base::Hash128 originHash(const base::Vec3d& origin) {
    std::vector<std::uint32_t> words;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto bits = std::bit_cast<std::uint64_t>(origin[k] + 0.0); // -0 and 0 are the same place
        words.push_back(static_cast<std::uint32_t>(bits));
        words.push_back(static_cast<std::uint32_t>(bits >> 32));
    }
    return base::hashWords(words);
}

static base::Hash128 layersHash(const layers::Stack& stack) {
    std::vector<std::uint32_t> words;
    for (const std::string& line : layers::linesOf(stack))
        appendWords(words, line);
    return base::hashWords(words);
}

base::Hash128 contentHash(const tree::SurfelTree& tree, const base::Vec3d& origin, const layers::Stack& stack) {
    base::Hash128 out = tree.contentHash();
    out += layoutHash(*tree.layout());
    out += originHash(origin);
    if (!stack.empty())
        out += layersHash(stack);
    return out;
}

base::Hash128 Document::hash() const {
    return contentHash(m_surface.tree(), m_provenance.origin, m_layers);
}

void Document::commit(surface::Surface next, const std::string& label, layers::How how) {
    layers::Stack stack = m_layers;
    if (!stack.empty() && !layers::Channels::of(*next.tree().layout(), stack))
        stack = {};
    if (!stack.empty()) {
        if (how == layers::How::Record && !layers::takesStrokes(stack))
            how = layers::How::Keep;
        next = {layers::reconciled(m_surface.tree(), next.tree(), stack, how), next.definition()};
    }
    restack(std::move(next), std::move(stack), label);
}

void Document::restack(surface::Surface next, layers::Stack layers, const std::string& label) {
    m_future.clear();
    const std::size_t bytes = tree::unsharedBytes(m_surface.tree(), next.tree());
    m_past.push_back({std::move(m_surface), m_up, std::move(m_layers), label, bytes, m_revision});
    m_surface = std::move(next);
    m_layers = std::move(layers);
    m_revision = ++m_lastRevision;
    enforceBudget();
}

void Document::turnUp(base::UpAxis up, const std::string& label) {
    commit(m_surface, label);
    m_up = up;
}

void Document::reset(surface::Surface surface, Provenance provenance, base::UpAxis up, layers::Stack layers) {
    m_past.clear();
    m_future.clear();
    m_surface = std::move(surface);
    m_provenance = std::move(provenance);
    m_up = up;
    m_layers = std::move(layers);
    m_savedRevision = m_revision = ++m_lastRevision;
}

void Document::saved(const std::filesystem::path& path) {
    m_provenance.path = path;
    m_savedRevision = m_revision;
}

/// The nearest step of `from` becomes the present, and the present the nearest step of `to`.
void Document::shift(std::deque<Step>& from, std::deque<Step>& to) {
    assert(!from.empty());
    Step step = std::move(from.back());
    from.pop_back();
    const std::size_t bytes = tree::unsharedBytes(m_surface.tree(), step.surface.tree());
    to.push_back({std::move(m_surface), m_up, std::move(m_layers), std::move(step.label), bytes, m_revision});
    m_surface = std::move(step.surface);
    m_up = step.up;
    m_layers = std::move(step.layers);
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
    io::FileModel out;
    out.points = m_surface.tree().surfels();
    out.shape = m_surface.tree().shape();
    out.origin = m_provenance.origin;
    out.up = m_up;
    out.definition = m_surface.definition();
    out.hasSupports = true;
    out.faces = m_provenance.faces;
    out.dropped = m_provenance.dropped;
    out.format = m_provenance.format;
    out.comments = m_provenance.comments;
    for (std::string& line : layers::linesOf(m_layers))
        out.comments.push_back(std::move(line));
    out.elements = m_provenance.elements;
    return out;
}

} // namespace session
