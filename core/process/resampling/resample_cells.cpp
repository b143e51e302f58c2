#include "core/process/resampling/resample_cells.h"

#include "core/base/cancel_scope.h"
#include "core/base/cells.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/resampling/resample_set.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace process {

using base::Vec3f;

namespace {

constexpr float openLimit = 0.3f;        ///< off-centre limit at which a cell by itself ends, in h
constexpr std::size_t fewestOfCell = 12; ///< smaller ones keep their surfels when a whole model is resampled
constexpr float acrossReach =
    2.5f; ///< how far from the partner's nearest surfel its plane still ends a cell, in spacings
constexpr float aheadReach = 4.5f;    ///< the same for what a cell has no surfels beside yet
constexpr float roomAtCrease = 0.15f; ///< spacings: what is born nearer to a crease may be across it after the next dab
constexpr float leastTowards = 0.1f;  ///< sine of the way to a crease with the plane across

/// Where labels are among the words of a surfel.
struct LabelWords {
    std::size_t cell = 0, partner = 0, sign = 0;

    static std::optional<LabelWords> of(const surfel::AttributeLayout& layout) {
        LabelWords out;
        for (const auto& [name, word] :
             {std::pair{"cell", &out.cell}, std::pair{"partner", &out.partner}, std::pair{"sign", &out.sign}}) {
            const surfel::Attribute* attribute = layout.find(name);
            if (!attribute || surfel::isReal(attribute->type))
                return std::nullopt;
            *word = attribute->firstWord;
        }
        return layout.normals && layout.oriented ? std::optional(out) : std::nullopt;
    }
};

std::uint32_t wordOf(const surfel::SurfelBlock& block, int slot, std::size_t word) {
    return block.words(slot / surfel::clusterSize, surfel::Extra + static_cast<int>(word))[slot % surfel::clusterSize];
}

/// A surfel of the version.
struct Origin {
    std::uint32_t number = 0; ///< of its block
    surfel::BlockPtr block;
    int slot = 0;
    bool touched = false;
};

class CellResampler {
  public:
    CellResampler(const surface::Surface& version, const tree::Selection& touched, const ResampleOptions& options,
                  const LabelWords& words)
        : m_version(version), m_options(options), m_words(words), m_count(version.tree().layout()->words()) {
        auto layout = std::make_shared<surfel::AttributeLayout>(*version.tree().layout());
        layout->add(" origin", surfel::ScalarType::UInt32);
        m_layout = std::move(layout);
        collect(touched);
    }

    bool severalCells() const { return m_byCell.size() > 1; }

    tree::Edit run() {
        m_edit.inserted.layout = m_version.tree().layout();
        for (const auto& [cell, members] : m_byCell)
            m_alone.emplace(cell, aloneFrom(listOf(members)));
        for (const auto& [cell, members] : m_byCell) {
            base::CancelScope::check();
            if (std::any_of(members.begin(), members.end(), [&](std::size_t i) { return m_all[i].touched; }))
                resampleCell(cell);
        }
        for (auto& [number, change] : m_changes) {
            if (change.content) {
                change.content->seal();
                change.edit.changed = change.content;
            }
            m_edit.blocks.push_back(std::move(change.edit));
        }
        return std::move(m_edit);
    }

    /// Each cell as `one` resamples it.
    template <class One>
    ResampleResult whole(const One& one, const base::Progress& progress) const {
        ResampleResult out{m_version, 0, true};
        surfel::SurfelList all;
        all.layout = m_version.tree().layout();
        std::size_t done = 0;
        for (const auto& [cell, members] : m_byCell) {
            const double from = static_cast<double>(done) / static_cast<double>(m_all.size());
            done += members.size();
            const double to = static_cast<double>(done) / static_cast<double>(m_all.size());
            surfel::SurfelList list;
            list.layout = all.layout;
            std::vector<std::uint32_t> words(m_count);
            for (const std::size_t i : members) {
                m_all[i].block->extra(m_all[i].slot, words);
                list.append(m_all[i].block->surfel(m_all[i].slot), words);
            }
            const bool anew = members.size() >= fewestOfCell;
            if (anew) {
                const ResampleResult found = one(aloneFrom(list), part(progress, from, to));
                out.rounds = std::max(out.rounds, found.rounds);
                out.settled = out.settled && found.settled;
                list = found.surface.tree().surfels();
            }
            for (std::size_t i = 0; i < list.size(); ++i)
                if (!anew || !across(cell, list.items[i].position, list.items[i].support))
                    all.append(list.items[i], list.extraOf(i));
        }
        out.surface = {tree::SurfelTree::build(all), m_version.definition()};
        return out;
    }

  private:
    struct Change {
        tree::BlockEdit edit;
        surfel::MutableBlockPtr content;
    };

    void collect(const tree::Selection& touched) {
        const tree::SurfelTree& tree = m_version.tree();
        std::map<std::uint32_t, std::bitset<surfel::blockCapacity>> slots;
        std::set<std::uint32_t> numbers;
        for (const tree::SelectedBlock& each : touched) {
            slots[each.block] = each.slots;
            const surfel::BlockPtr block = tree.block(each.block);
            base::Box3f box;
            for (int slot = 0; slot < block->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)])
                    box.extend(block->position(slot));
            tree.forBlocksInSupport(
                box.inflated(farReach * m_options.spacing + block->maxSupport()),
                [&](std::uint32_t number, const surfel::SurfelBlock&) { numbers.insert(number); },
                m_version.supportScale());
        }
        for (const std::uint32_t number : numbers) {
            const surfel::BlockPtr block = tree.block(number);
            const auto asked = slots.find(number);
            for (int slot = 0; slot < block->size(); ++slot) {
                const std::uint32_t cell = wordOf(*block, slot, m_words.cell);
                m_byCell[cell].push_back(m_all.size());
                if (wordOf(*block, slot, m_words.partner) != cell)
                    m_beside.at(placeOf(block->position(slot))).push_back(static_cast<std::uint32_t>(m_all.size()));
                m_all.push_back(
                    {number, block, slot, asked != slots.end() && asked->second[static_cast<std::size_t>(slot)]});
            }
        }
    }

    float reach() const { return acrossReach * m_options.spacing; }
    float ahead() const { return aheadReach * m_options.spacing; }
    base::Cell placeOf(const Vec3f& x) const {
        return base::cellOf(base::cast<double>(x), base::Vec3d(), 1 / static_cast<double>(ahead()));
    }

    const Origin& originOf(const surfel::SurfelBlock& block, int slot) const {
        return m_all[wordOf(block, slot, m_count)];
    }

    /// Surfels with where they come from.
    surfel::SurfelList listOf(const std::vector<std::size_t>& members) const {
        surfel::SurfelList list;
        list.layout = m_layout;
        std::vector<std::uint32_t> words(m_count + 1);
        for (const std::size_t i : members) {
            m_all[i].block->extra(m_all[i].slot, std::span(words).first(m_count));
            words[m_count] = static_cast<std::uint32_t>(i);
            list.append(m_all[i].block->surfel(m_all[i].slot), words);
        }
        return list;
    }

    void resampleCell(std::uint32_t cell) {
        const surface::Surface& alone = m_alone.at(cell);
        ResampleOptions options = m_options;
        if (m_options.targetOf)
            options.targetOf = [&](const surfel::SurfelBlock& block, int slot) {
                const Origin& origin = originOf(block, slot);
                return m_options.targetOf(*origin.block, origin.slot);
            };
        if (m_options.drawnApart)
            options.drawnApart = [&](const surfel::SurfelBlock& block, int slot) {
                const Origin& origin = originOf(block, slot);
                return m_options.drawnApart(*origin.block, origin.slot);
            };
        options.goesOn = [&](const Vec3f& place, const Vec3f& centroid) { return goesOn(cell, place, centroid); };
        take(cell, alone, resample(alone, touchedOf(alone.tree()), options, alone));
    }

    /// A cell as a model of its own.
    surface::Surface aloneFrom(const surfel::SurfelList& list) const {
        surface::SurfaceDefinition definition = m_version.definition();
        definition.boundaryLimit = std::min(definition.boundaryLimit, openLimit);
        definition.knownRims = false; // it ends at creases
        return {tree::SurfelTree::build(list), definition};
    }

    tree::Selection touchedOf(const tree::SurfelTree& tree) const {
        tree::Selection out;
        tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            tree::SelectedBlock some{number, {}};
            for (int slot = 0; slot < block.size(); ++slot)
                some.slots.set(static_cast<std::size_t>(slot), originOf(block, slot).touched);
            if (some.slots.any())
                out.push_back(some);
        });
        return out;
    }

    /// What happens to the cell by itself, as edits of the version.
    void take(std::uint32_t cell, const surface::Surface& alone, const tree::Edit& edit) {
        std::vector<std::uint32_t> words(m_count + 1);
        for (const tree::BlockEdit& each : edit.blocks) {
            const surfel::BlockPtr before = alone.tree().block(each.block);
            for (int slot = 0; slot < before->size(); ++slot) {
                const Origin& origin = originOf(*before, slot);
                if (each.removed[static_cast<std::size_t>(slot)]) {
                    changeOf(origin).edit.removed.set(static_cast<std::size_t>(origin.slot));
                } else if (each.changed && !(each.changed->surfel(slot) == before->surfel(slot)) &&
                           !across(cell, each.changed->position(slot))) {
                    Change& change = changeOf(origin);
                    if (!change.content)
                        change.content = origin.block->clone();
                    change.content->set(origin.slot, each.changed->surfel(slot));
                    each.changed->extra(slot, words);
                    change.content->setExtra(origin.slot, std::span(words).first(m_count));
                }
            }
        }
        for (std::size_t i = 0; i < edit.inserted.size(); ++i)
            if (!across(cell, edit.inserted.items[i].position))
                m_edit.inserted.append(edit.inserted.items[i], edit.inserted.extraOf(i).first(m_count));
    }
    Change& changeOf(const Origin& origin) {
        Change& out = m_changes[origin.number];
        out.edit.block = origin.number;
        return out;
    }

    /// fn(nearest surfel, sign) of the cells that a cell meets within `within` of a place, until one is true; the sign
    /// as most labels tell it, convex > 0. Where points stand closer than the spacing that all of it is looked at with,
    /// planes tell less far: `support` is that of a surfel there.
    template <class Fn>
    bool anyMet(std::uint32_t cell, const Vec3f& x, float within, float support, const Fn& fn) const {
        std::map<std::uint32_t, std::pair<float, const Origin*>> nearest; // by other cell
        std::map<std::uint32_t, int> signs;                               // convex > 0
        base::forCellsAround(placeOf(x), [&](const base::Cell& around) {
            const std::vector<std::uint32_t>* there = m_beside.find(around);
            if (!there)
                return;
            for (const std::uint32_t i : *there) {
                const Origin& each = m_all[i];
                const float farSq = distanceSq(each.block->position(each.slot), x);
                const std::uint32_t own = wordOf(*each.block, each.slot, m_words.cell);
                const std::uint32_t partner = wordOf(*each.block, each.slot, m_words.partner);
                const std::uint32_t sign = wordOf(*each.block, each.slot, m_words.sign);
                const float near = 2 * std::max(support, each.block->support(each.slot));
                if (!(farSq < within * within) || !(farSq < near * near) || (own != cell && partner != cell))
                    continue;
                signs[own == cell ? partner : own] += sign == 1 ? 1 : sign == 2 ? -1 : 0;
                if (own == cell)
                    continue;
                auto& best = nearest[own];
                if (!best.second || farSq < best.first)
                    best = {farSq, &each};
            }
        });
        return std::any_of(nearest.begin(), nearest.end(), [&](const auto& each) {
            const auto sign = signs.find(each.first);
            return sign != signs.end() && sign->second != 0 && fn(*each.second.second, sign->second);
        });
    }

    /// Is a place of a cell beyond a crease of it: on the wrong side of a cell that it meets nearby?
    bool across(std::uint32_t cell, const Vec3f& x, float support = std::numeric_limits<float>::infinity()) const {
        return anyMet(cell, x, reach(), support, [&](const Origin& other, int sign) { return ends(other, sign, x); });
    }
    /// Does the cell of a surfel end another one, which it meets so, before a place or less than `ahead` behind it?
    bool ends(const Origin& other, int sign, const Vec3f& x, float ahead = 0) const {
        const float above = heightOver(other, x);
        return (sign > 0 ? above : -above) > -ahead;
    }

    /// Of a place over the cell of a surfel near it: as the local Boolean has it, or where that cell by itself tells
    /// nothing, over the surfel's plane.
    float heightOver(const Origin& other, const Vec3f& x) const {
        const Vec3f n = other.block->normal(other.slot);
        const auto alone = m_alone.find(wordOf(*other.block, other.slot, m_words.cell));
        if (alone != m_alone.end())
            if (const surface::Evaluationf at = alone->second.evaluate(x, surface::Need::Value, {n}); told(at))
                return at.value;
        return dot(x - other.block->position(other.slot), n);
    }
    static bool told(const surface::Evaluationf& at) {
        return (at.status == surface::Status::Ok || at.status == surface::Status::BeyondBoundary) &&
               at.offCentre <= static_cast<float>(surface::maxOffCentre) * at.unit;
    }

    /// Does a cell go on at a place, off the centre of its samples there, as far as a crease? Else what a stroke draws
    /// apart along a crease leaves room on both sides of it that nothing fills.
    bool goesOn(std::uint32_t cell, const Vec3f& x, const Vec3f& centroid) const {
        constexpr float anySupport = std::numeric_limits<float>::infinity();
        const Vec3f way = x - centroid;
        const auto nearer = [&](const Origin& other, int sign) {
            const float along = dot(way, other.block->normal(other.slot));
            return (sign > 0 ? along : -along) > leastTowards * length(way);
        };
        const float room = roomAtCrease * m_options.spacing;
        const auto isBefore = [&](const Origin& other, int sign) { return ends(other, sign, x, room); };
        return anyMet(cell, x, reach(), anySupport, nearer) && !anyMet(cell, x, ahead(), anySupport, isBefore);
    }

    const surface::Surface& m_version;
    const ResampleOptions& m_options;
    LabelWords m_words;
    std::size_t m_count;                 ///< words of a surfel
    surfel::AttributeLayoutPtr m_layout; ///< with where a surfel comes from
    std::vector<Origin> m_all;
    base::CellMap<std::vector<std::uint32_t>> m_beside; ///< creases, by place
    std::map<std::uint32_t, std::vector<std::size_t>> m_byCell;
    std::map<std::uint32_t, surface::Surface> m_alone; ///< each cell as a model of its own
    std::map<std::uint32_t, Change> m_changes;
    tree::Edit m_edit;
};

} // namespace

std::optional<tree::Edit> resampleByCells(const surface::Surface& version, const tree::Selection& touched,
                                          const ResampleOptions& options) {
    const auto words = LabelWords::of(*version.tree().layout());
    if (!words || touched.empty() || !(options.spacing > 0))
        return std::nullopt;
    CellResampler resampler(version, touched, options, *words);
    if (!resampler.severalCells())
        return std::nullopt;
    return resampler.run();
}

std::optional<ResampleResult>
resampleEachCell(const surface::Surface& surface, float reach, const base::Progress& progress,
                 const std::function<ResampleResult(const surface::Surface&, const base::Progress&)>& one) {
    const auto words = LabelWords::of(*surface.tree().layout());
    if (!words || surface.tree().empty() || !(reach > 0))
        return std::nullopt;
    ResampleOptions options;
    options.spacing = reach;
    const CellResampler resampler(surface, selectAll(surface.tree()), options, *words);
    if (!resampler.severalCells())
        return std::nullopt;
    return resampler.whole(one, progress);
}

bool hasCells(const surface::Surface& surface) {
    const auto words = LabelWords::of(*surface.tree().layout());
    if (!words || surface.tree().empty())
        return false;
    bool out = false;
    const surfel::BlockPtr first = surface.tree().block(0);
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            out = out || wordOf(block, slot, words->cell) != wordOf(*first, 0, words->cell);
    });
    return out;
}

bool oneCellAround(const surface::Surface& surface, const Vec3f& centre, float radius) {
    const auto words = LabelWords::of(*surface.tree().layout());
    if (!words)
        return true;
    std::set<std::array<std::uint32_t, 3>> met;
    surface.tree().forBlocksInBall(centre, radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (distanceSq(block.position(slot), centre) < radius * radius)
                met.insert({wordOf(block, slot, words->cell), wordOf(block, slot, words->partner),
                            wordOf(block, slot, words->sign)});
    });
    return met.size() <= 1;
}

} // namespace process
