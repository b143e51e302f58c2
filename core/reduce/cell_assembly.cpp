#include "core/reduce/cell_assembly.h"

#include "core/reduce/assemble.h"
#include "core/reduce/coverage.h"
#include "core/surfel/shape.h"

namespace reduce {

namespace {

Sites sitesOf(const surfel::SurfelList& list) {
    Sites out;
    const bool shaped = surfel::shapeChannel(*list.layout) > 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const surfel::Surfel& s = list.items[i];
        out.position.push_back(s.position), out.normal.push_back(s.normal), out.support.push_back(s.support);
        if (shaped)
            out.shape.push_back(surfel::shapeIn(list.extraOf(i), surfel::shapeWord(*list.layout)));
    }
    return out;
}

void putSites(const Sites& sites, surfel::SurfelList& list) {
    const std::size_t words = list.layout->words();
    for (std::size_t i = 0; i < list.size(); ++i) {
        surfel::Surfel& s = list.items[i];
        s.position = sites.position[i], s.normal = sites.normal[i], s.support = sites.support[i];
        if (!sites.shape.empty())
            surfel::putShape(std::span(list.extra).subspan(i * words, words), surfel::shapeWord(*list.layout),
                             sites.shape[i]);
    }
}

} // namespace

CellAssembly::CellAssembly(const surface::Surface& model, const base::Progress& progress)
    : m_model(model), m_rims(rimsOf(model, progress)) {}

void CellAssembly::fit(const Cell& cell, const Places& places, const Reduced& reduced) {
    m_sum.add(reduced.report, cell.size());
    surfel::SurfelList list = reduced.surface.tree().surfels();
    label(cell, list);
    if (!m_rims.empty()) {
        m_besideRims.push_back(placesBeside(m_rims, places, sitesOf(list)));
        m_fitted.push_back({m_size, m_size + list.size(), &m_besideRims.back()});
    }
    add(cell, std::move(list));
}

void CellAssembly::keep(const Cell& cell, double denseRms) {
    m_sum.keep(cell.size(), cell.size(), denseRms);
    add(cell, cell.surfels);
}

void CellAssembly::pick(const Cell& cell, std::size_t count) {
    m_sum.keep(count, cell.size(), 0);
    m_sum.pick(count);
    add(cell, reduce::thinned(cell, count));
}

void CellAssembly::add(const Cell& cell, surfel::SurfelList list) {
    for (const surfel::Surfel& s : cell.surfels.items)
        m_places.position.push_back(s.position);
    m_size += list.size();
    m_lists.push_back(std::move(list));
}

Reduced CellAssembly::result(const base::Progress& progress) {
    surfel::SurfelList list = joined(std::move(m_lists));
    float limit = 0;
    if (!m_fitted.empty()) {
        const surfel::AttributeLayout& layout = *m_model.tree().layout();
        Sites sites = sitesOf(list);
        limit = fitRims(m_rims, m_fitted, layout.normals && layout.oriented, sites, {{}, progress.cancel});
        putSites(sites, list);
    }
    Reduced out{
        {tree::SurfelTree::build(list), reducedDefinition(m_model.definition(), static_cast<int>(supportsOver))},
        m_sum.report()};
    out.surface = m_fitted.empty() ? bounded(m_model, out.surface, m_places, 0, progress)
                                   : endingAtRims(m_model, out.surface, m_places, m_rims, limit, progress);
    return out;
}

} // namespace reduce
