#include "core/reduce/fit.h"

#include "core/base/parallel.h"
#include "core/reduce/fit_steps.h"

namespace reduce {

namespace {

constexpr int rounds = 3, roundsAgain = 2, steps = 40;
constexpr std::size_t rowsOfPiece = 2048;
/// Towards where the sites began, in parts of the diagonal and of its mean (reduce/README 4.3).
constexpr double ridge = 0.1, meanShare = 0.05;

/// What may change; all of all sites where nothing is marked.
class Freedom {
  public:
    explicit Freedom(std::span<const std::uint8_t> marked) : m_marked(marked) {}
    int rounds() const { return m_marked.empty() ? reduce::rounds : roundsAgain; }
    /// Offsets and tilts alone, of marked sites.
    void hold(std::span<FitTerm> terms, std::span<const FitSite> sites) const {
        if (m_marked.empty())
            return;
        for (FitTerm& t : terms)
            std::fill(t.d->begin() + (m_marked[std::size_t(t.site - sites.data())] ? 3 : 0), t.d->end(), 0.0F);
    }

  private:
    std::span<const std::uint8_t> m_marked;
};

template <int unknowns>
void fitAll(const Places& places, const Freedom& freedom, Sites& sites, const base::Progress& progress) {
    std::vector<FitSite> moving = fitSites(sites);
    std::vector<FitPiece<unknowns>> pieces(base::chunkCount(places.size(), rowsOfPiece));
    for (int round = 0; round < freedom.rounds(); ++round) {
        progress.step(double(round) / freedom.rounds(), "Fitting");
        const NumberedTree tree(sites.position, sites.normal, sites.support, sites.shape);
        base::parallelChunks(places.size(), rowsOfPiece, [&](std::size_t begin, std::size_t end, std::size_t k) {
            pieces[k] = pieceOf<unknowns>(places.position, tree, begin, end);
            linearise(moving, pieces[k], [&](std::size_t i, std::span<FitTerm> terms) {
                const FitRow row = fitRow(base::cast<double>(places.position[i]), base::cast<double>(places.normal[i]),
                                          places.oriented, terms);
                freedom.hold(terms, moving);
                return row;
            });
        });
        NormalEquations<unknowns> equations(pieces, sites.size());
        move<unknowns>(moving, equations.solve(movedSoFar<unknowns>(moving), ridge, meanShare, steps));
        store(moving, sites);
    }
}

void fitAll(const Places& places, const Freedom& freedom, Sites& sites, const base::Progress& progress) {
    if (sites.shape.empty())
        fitAll<unknownsOfBalls>(places, freedom, sites, progress);
    else
        fitAll<unknownsOfEllipsoids>(places, freedom, sites, progress);
}

} // namespace

void fit(const Places& places, Sites& sites, const base::Progress& progress) {
    fitAll(places, Freedom({}), sites, progress);
}

void fitAgain(const Places& places, std::span<const std::uint8_t> marked, Sites& sites,
              const base::Progress& progress) {
    fitAll(places, Freedom(marked), sites, progress);
}

} // namespace reduce
