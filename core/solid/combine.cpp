#include "core/solid/combine.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/row_of_id.h"
#include "core/cells/labels.h"
#include "core/tree/tree_shape.h"

#include <optional>

namespace solid {

using base::Vec3d;
using cells::Label;
using cells::Meeting;

std::span<const OperationRow> operationTable() {
    static constexpr OperationRow rows[] = {{"union", "Union", Operation::Union},
                                            {"difference", "Difference", Operation::Difference},
                                            {"intersection", "Intersection", Operation::Intersection}};
    return rows;
}

Operation operation(std::string_view id) {
    return base::rowOf(operationTable(), id, {"unknown operation \"%\"", "", "known are %"}, &OperationRow::id)
        .operation;
}

namespace {

/// Does a surfel of the model stay? `side`: of the operand, as sidesOf tells it. What coincides stays once where both
/// bound the result from the same side, and else not at all.
bool staysOfModel(Operation operation, std::int8_t side) {
    switch (operation) {
    case Operation::Union:
        return side == 1 || side == 2;
    case Operation::Difference:
        return side == 1 || side == -2;
    default:
        return side == -1 || side == 2;
    }
}

bool staysOfOperand(Operation operation, std::int8_t side) {
    return side == (operation == Operation::Union ? 1 : -1);
}

/// A version with labels: as it is, or all of one cell.
tree::SurfelTree labelled(const tree::SurfelTree& tree) {
    if (cells::LabelLayout::of(*tree.layout()))
        return tree;
    surfel::SurfelList list = tree.surfels();
    cells::setLabels(list, std::vector<Label>(list.size()));
    return tree::SurfelTree::build(list, tree.shape());
}

/// Words of one layout as those of another: attributes of the same name, others zero.
class Translation {
  public:
    Translation(const surfel::AttributeLayout& from, const surfel::AttributeLayout& to) : m_words(to.words(), 0) {
        for (const surfel::Attribute& target : to.attributes())
            if (const surfel::Attribute* source = from.find(target.name))
                m_pairs.push_back({*source, target});
    }
    std::span<std::uint32_t> operator()(std::span<const std::uint32_t> words) {
        for (const auto& [source, target] : m_pairs)
            surfel::write(target, m_words, surfel::read(source, words));
        return m_words;
    }

  private:
    std::vector<std::pair<surfel::Attribute, surfel::Attribute>> m_pairs;
    std::vector<std::uint32_t> m_words;
};

/// The foot on the seam of both surfaces (cells/README 5, (4)); nothing where it is not found, or they do not cross.
std::optional<Vec3d> seamFoot(const Side& a, const Side& b, const Vec3d& x) {
    constexpr int steps = 12;
    constexpr double leastSine = 0.1; // squared sine 0.01, as there
    Vec3d y = x;
    for (int step = 0; step < steps; ++step) {
        const SideValue f = a.at(y), g = b.at(y);
        if (!f.near || !g.near)
            return {};
        const double c = dot(f.gradient, g.gradient), det = 1 - c * c;
        if (det < leastSine * leastSine)
            return {};
        const double u = f.value + dot(f.gradient, x - y), v = g.value + dot(g.gradient, x - y);
        const Vec3d next = x - f.gradient * ((u - c * v) / det) - g.gradient * ((v - c * u) / det);
        const double moved = distance(next, y);
        y = next;
        if (moved < 1e-4 * distance(y, x) + 1e-12)
            return y;
    }
    return {};
}

/// Labels at the seam: each side's cells, and across it the nearest cell of the other side.
class SeamLabels {
  public:
    SeamLabels(const Side& model, const Side& operand, Operation operation)
        : m_model(model), m_operand(operand),
          m_meeting(operation == Operation::Union ? Meeting::Concave : Meeting::Convex) {}

    /// The surfel's label from now on, where it is within two spacings of the seam. `across`: cell of the other side
    /// nearest to a place.
    template <class Across>
    std::optional<Label> at(const Vec3d& x, float support, Label label, const Across& across) const {
        constexpr double reach = 2; // spacings: cells::partnerReach
        const double spacing = static_cast<double>(support) * surface::spacingOfUnit;
        if (!closer(m_model.at(x), 2 * reach * spacing) || !closer(m_operand.at(x), 2 * reach * spacing))
            return {};
        const std::optional<Vec3d> foot = seamFoot(m_model, m_operand, x);
        if (!foot || distance(*foot, x) > reach * spacing)
            return {};
        label.partner = across(*foot);
        label.meeting = m_meeting;
        label.sharpness = 255;
        return label;
    }

  private:
    static bool closer(const SideValue& at, double than) { return at.near && std::abs(at.value) < than; }

    const Side &m_model, &m_operand;
    Meeting m_meeting;
};

std::uint32_t nearestCell(const tree::SurfelTree& tree, const Vec3d& x, std::uint32_t offset) {
    const std::optional<cells::LabelLayout> layout = cells::LabelLayout::of(*tree.layout());
    std::vector<tree::Neighbour> near;
    tree.nearest(base::cast<float>(x), 1, near);
    return offset + (layout && !near.empty() ? layout->cellAt(*near[0].block, near[0].slot) : 0);
}

class Combining {
  public:
    Combining(const surface::Surface& model, const Operand& operand, Operation operation, const CombineOptions& options)
        : m_definition(model.definition()), m_operation(operation), m_creases(options.creases),
          m_tree(options.creases ? labelled(model.tree()) : model.tree()),
          m_modelSide(surface::Surface(m_tree, m_definition)), m_operandSide(operand.side),
          m_other(operand.surfels.size() > 0 ? tree::SurfelTree::build(operand.surfels) : tree::SurfelTree()) {}

    Combined run(const base::Progress& progress) {
        progress.step(0, "Telling inside from outside");
        const std::vector<std::int8_t> ofModel = sidesOf(m_tree, m_operandSide);
        progress.step(0.3, "Telling inside from outside");
        const std::vector<std::int8_t> ofOperand = sidesOf(m_other, m_modelSide);
        progress.step(0.6, "Joining");
        if (m_creases)
            m_offset = cellsOf(m_tree);
        Combined out;
        tree::Edit edit;
        edit.inserted.layout = m_tree.layout();
        takeAndLabel(ofModel, edit, out);
        insert(ofOperand, edit, out);
        if (m_tree.size() - out.removed + out.inserted < 4)
            throw base::Error("nothing would be left", "", "move the other one, or choose another operation");
        progress.step(0.9, "Joining");
        out.surface = {m_tree.apply(edit), m_definition};
        return out;
    }

  private:
    /// Number that no cell has.
    static std::uint32_t cellsOf(const tree::SurfelTree& tree) {
        std::uint32_t most = 0;
        if (const auto layout = cells::LabelLayout::of(*tree.layout()))
            tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
                for (int slot = 0; slot < block.size(); ++slot)
                    most = std::max(most, layout->cellAt(block, slot));
            });
        return most + 1;
    }

    void takeAndLabel(const std::vector<std::int8_t>& sides, tree::Edit& edit, Combined& out) {
        const SeamLabels seam(m_modelSide, m_operandSide, m_operation);
        const auto layout = cells::LabelLayout::of(*m_tree.layout());
        struct Changed {
            tree::BlockEdit edit;
            std::size_t atSeam = 0;
        };
        std::vector<Changed> changed(m_tree.blockCount());
        std::vector<std::size_t> first(m_tree.blockCount() + 1, 0);
        for (std::uint32_t b = 0; b < m_tree.blockCount(); ++b)
            first[b + 1] = first[b] + static_cast<std::size_t>(m_tree.block(b)->size());
        base::parallelFor(changed.size(), 1, [&](std::size_t b) {
            const surfel::BlockPtr block = m_tree.block(static_cast<std::uint32_t>(b));
            Changed& here = changed[b];
            here.edit.block = static_cast<std::uint32_t>(b);
            for (int slot = 0; slot < block->size(); ++slot)
                if (!staysOfModel(m_operation, sides[first[b] + static_cast<std::size_t>(slot)]))
                    here.edit.removed.set(static_cast<std::size_t>(slot));
            if (!m_creases || m_other.empty() || !nearOperand(*block))
                return;
            surfel::MutableBlockPtr copy;
            for (int slot = 0; slot < block->size(); ++slot) {
                if (here.edit.removed[static_cast<std::size_t>(slot)])
                    continue;
                const auto label =
                    seam.at(base::cast<double>(block->position(slot)), block->support(slot), layout->at(*block, slot),
                            [&](const Vec3d& foot) { return nearestCell(m_other, foot, m_offset); });
                if (!label)
                    continue;
                if (!copy)
                    copy = block->clone();
                std::vector<std::uint32_t> words(block->extraWords());
                block->extra(slot, words);
                write(*m_tree.layout(), *label, words);
                copy->setExtra(slot, words);
                ++here.atSeam;
            }
            if (copy) {
                copy->seal();
                here.edit.changed = copy;
            }
        });
        for (Changed& each : changed) {
            out.removed += each.edit.removed.count();
            out.atSeam += each.atSeam;
            if (each.edit.changed || each.edit.removed.any())
                edit.blocks.push_back(std::move(each.edit));
        }
    }
    bool nearOperand(const surfel::SurfelBlock& block) const {
        const base::Box3f box = block.box().inflated(2 * block.maxSupport());
        return m_operandSide.meets({base::cast<double>(box.lo), base::cast<double>(box.hi)});
    }
    static void write(const surfel::AttributeLayout& layout, const Label& label, std::span<std::uint32_t> words) {
        const std::pair<const char*, double> values[] = {{"cell", label.cell},
                                                         {"partner", label.partner},
                                                         {"sign", static_cast<int>(label.meeting)},
                                                         {"sharpness", label.sharpness},
                                                         {"face", label.face}};
        for (const auto& [name, value] : values)
            if (const surfel::Attribute* attribute = layout.find(name))
                surfel::write(*attribute, words, value);
    }

    void insert(const std::vector<std::int8_t>& sides, tree::Edit& edit, Combined& out) {
        const surfel::SurfelList all = m_other.surfels();
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < sides.size(); ++i)
            if (staysOfOperand(m_operation, sides[i]))
                kept.push_back(i);
        std::vector<std::optional<Label>> labels(kept.size());
        const auto own = cells::LabelLayout::of(*all.layout);
        const SeamLabels seam(m_modelSide, m_operandSide, m_operation);
        if (m_creases)
            base::parallelFor(kept.size(), 64, [&](std::size_t k) {
                const surfel::Surfel& s = all.items[kept[k]];
                Label label = own ? own->at(all.extraOf(kept[k])) : Label{};
                label.cell += m_offset, label.partner += m_offset, label.face = label.cell;
                if (m_operation == Operation::Difference)
                    label.meeting = cells::opposite(label.meeting);
                const auto atSeam = seam.at(base::cast<double>(s.position), s.support, label,
                                            [&](const Vec3d& foot) { return nearestCell(m_tree, foot, 0); });
                labels[k] = atSeam ? atSeam : label;
            });
        Translation translation(*all.layout, *m_tree.layout());
        for (std::size_t k = 0; k < kept.size(); ++k) {
            surfel::Surfel s = all.items[kept[k]];
            if (m_operation == Operation::Difference)
                s.normal = -s.normal;
            const std::span<std::uint32_t> words = translation(all.extraOf(kept[k]));
            if (labels[k])
                write(*m_tree.layout(), *labels[k], words);
            edit.inserted.append(s, words);
        }
        out.inserted = kept.size();
    }

    surface::SurfaceDefinition m_definition;
    Operation m_operation;
    bool m_creases;
    tree::SurfelTree m_tree;
    SurfaceSide m_modelSide;
    const Side& m_operandSide;
    tree::SurfelTree m_other;
    std::uint32_t m_offset = 0;
};

} // namespace

Combined combine(const surface::Surface& model, const Operand& operand, Operation operation,
                 const CombineOptions& options, const base::Progress& progress) {
    if (model.definition().manifold == surface::Manifold::Curve)
        throw base::Error("a curve bounds no solid", "", "open the model as a surface");
    if (!model.tree().layout()->normals || !model.tree().layout()->oriented)
        throw base::Error("the points have no normals that tell inside from outside", "",
                          "give them some first, with \"normals\" and \"orient\"");
    return Combining(model, operand, operation, options).run(progress);
}

} // namespace solid
