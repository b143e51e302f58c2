// Random edits as tools make them and worse, done to a tree and to a plain map side by side.
#pragma once

#include "tree/fixtures.h"

namespace test {

class EditedModel {
  public:
    EditedModel(std::size_t count, std::uint64_t seed) : m_random(seed), m_count(count) {
        const surfel::SurfelList list = bumpySphere(count, m_random);
        m_nextNumber = static_cast<std::uint32_t>(count);
        m_tree = tree::SurfelTree::build(list);
        m_content = contentOf(list);
    }

    const tree::SurfelTree& tree() const { return m_tree; }
    const Content& content() const { return m_content; }
    base::Random& random() { return m_random; }

    /// One random edit, not yet applied; `content` becomes what the tree must hold afterwards.
    tree::Edit randomEdit() {
        m_edit = {};
        m_edit.inserted.layout = numberedLayout();
        if (m_content.size() < m_count / 2 && m_random.below(3) == 0) {
            refill();
            return m_edit;
        }
        const std::size_t kind = m_random.below(10);
        const base::Vec3d centre = m_random.unitVector();
        const double radius = std::pow(10.0, m_random.uniform(-2, 0));
        if (kind == 0)
            removeWholeBlocks(m_random.uniform());
        else if (kind == 1 && m_random.below(4) == 0)
            removeWhere([&](const base::Vec3d& p) { return base::dot(p, centre) > 0.3; });
        else if (kind <= 3)
            removeWhere([&](const base::Vec3d& p) { return base::distance(p, centre) < radius; });
        else if (kind <= 5)
            change(centre, radius, 0.0);
        else if (kind == 6)
            change(centre, radius, 0.3);
        if (kind >= 6 || m_content.empty())
            insert(centre, m_random.below(3) == 0 ? 0.0 : radius, m_random.below(m_random.below(8) == 0 ? 1500 : 60));
        return m_edit;
    }

    void apply(const tree::Edit& edit) { m_tree = m_tree.apply(edit); }

    /// An edit that leaves nothing, or with `centre` given, nothing further than `radius` from it.
    tree::Edit removeAllBut(const base::Vec3d& centre, double radius) {
        m_edit = {};
        removeWhere([&](const base::Vec3d& p) { return base::distance(p, centre) >= radius; });
        return m_edit;
    }

  private:
    template <class Predicate>
    void removeWhere(const Predicate& goes) {
        m_tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            tree::BlockEdit edit{number, {}, {}};
            for (int slot = 0; slot < block.size(); ++slot)
                if (goes(base::cast<double>(block.position(slot))))
                    remove(edit, block, slot);
            if (edit.removed.any())
                m_edit.blocks.push_back(edit);
        });
    }
    void removeWholeBlocks(double share) {
        m_tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            if (m_random.uniform() >= share * share)
                return;
            tree::BlockEdit edit{number, {}, {}};
            for (int slot = 0; slot < block.size(); ++slot)
                remove(edit, block, slot);
            m_edit.blocks.push_back(edit);
        });
    }
    void change(const base::Vec3d& centre, double radius, double removedShare) {
        const float reach = static_cast<float>(radius);
        m_tree.forBlocksInBall(base::cast<float>(centre), reach,
                               [&](std::uint32_t number, const surfel::SurfelBlock& block) {
                                   const surfel::MutableBlockPtr changed = block.clone();
                                   tree::BlockEdit edit{number, {}, {}};
                                   for (int slot = 0; slot < block.size(); ++slot) {
                                       move(*changed, slot, centre, radius);
                                       if (m_random.uniform() < removedShare)
                                           remove(edit, block, slot);
                                   }
                                   changed->seal();
                                   edit.changed = changed;
                                   m_edit.blocks.push_back(edit);
                               });
    }
    void move(surfel::SurfelBlock& block, int slot, const base::Vec3d& centre, double radius) {
        surfel::Surfel s = block.surfel(slot);
        const base::Vec3d p = base::cast<double>(s.position);
        const double share = 1 - base::distance(p, centre) / radius;
        if (share <= 0)
            return;
        s.position = base::cast<float>(p + centre * (0.3 * share * radius));
        s.mask = static_cast<float>(share);
        s.support *= 1.1f;
        block.set(slot, s);
        m_content[numberOf(block, slot)] = s;
    }
    void remove(tree::BlockEdit& edit, const surfel::SurfelBlock& block, int slot) {
        edit.removed.set(static_cast<std::size_t>(slot));
        m_content.erase(numberOf(block, slot));
    }
    void insert(const base::Vec3d& centre, double radius, std::size_t count) {
        for (std::size_t i = 0; i <= count; ++i) {
            const base::Vec3d p = centre + m_random.unitVector() * (radius * m_random.uniform());
            const surfel::Surfel s = surfelAt(p, 0.05, m_random);
            const std::uint32_t number = m_nextNumber++;
            m_edit.inserted.append(s, {&number, 1});
            m_content[number] = s;
        }
    }

    /// Many insertions all over, so that the model does not dwindle.
    void refill() {
        const surfel::SurfelList fresh = bumpySphere(m_count / 2, m_random);
        for (const surfel::Surfel& s : fresh.items) {
            const std::uint32_t number = m_nextNumber++;
            m_edit.inserted.append(s, {&number, 1});
            m_content[number] = s;
        }
    }

    base::Random m_random;
    std::size_t m_count;
    tree::SurfelTree m_tree;
    Content m_content;
    tree::Edit m_edit;
    std::uint32_t m_nextNumber = 0;
};

} // namespace test
