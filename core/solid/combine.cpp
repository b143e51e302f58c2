#include "core/solid/combine.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"
#include "core/solid/grade_beside.h"
#include "core/solid/seam_labels.h"
#include "core/solid/slivers.h"
#include "core/solid/stays.h"
#include "core/solid/whole_parts.h"
#include "core/surfel/shape.h"

#include <optional>

namespace solid {

using base::Vec3d;
using cells::Label;
using cells::Meeting;

namespace {

class Combining {
  public:
    Combining(const surface::Surface& model, const Operand& operand, Operation operation, const CombineOptions& options)
        : m_definition(model.definition()), m_operation(operation), m_options(options),
          m_other(operand.surfels.size() > 0 ? tree::SurfelTree::build(operand.surfels) : tree::SurfelTree()),
          m_labels(options.creases && (!(options.fillet > 0) || options.chamfer > 0 || hasLabels(model.tree()) ||
                                       (!m_other.empty() && hasLabels(m_other)))),
          m_tree(m_labels ? labelled(model.tree(), m_other) : model.tree()),
          m_modelSide(surface::Surface(m_tree, m_definition)), m_operandSide(operand.side), m_ofModel(operand.sides),
          m_trimmed(operand.trimmed) {}

    /// Which surfels stay, and their feet on the seam.
    void findSides(const base::Progress& progress) {
        progress.step(0, "Telling inside from outside");
        if (m_ofModel.empty())
            m_ofModel = sidesOf(m_tree, m_operandSide);
        progress.step(0.3, "Telling inside from outside");
        m_ofOperand = m_trimmed ? std::vector<std::int8_t>(m_other.size(), m_operation == Operation::Union ? 1 : -1)
                                : sidesOf(m_other, m_modelSide);
        if (!m_trimmed || m_options.creases || m_options.seams || m_options.ball() > 0)
            findFeet();
        progress.step(0.6, "Joining");
    }
    /// After findSides: both versions, if one is far coarser beside the seam.
    bool grade(surface::Surface& model, surfel::SurfelList& other) const {
        const auto ofModel = m_trimmed ? std::nullopt : gradedBeside(model, m_operandFeet);
        const auto ofOther =
            m_trimmed || m_other.empty() ? std::nullopt : gradedBeside({m_other, m_definition}, m_modelFeet);
        if (ofModel)
            model = *ofModel;
        if (ofOther)
            other = ofOther->tree().surfels();
        return ofModel || ofOther;
    }
    /// After findSides.
    Combined run(const base::Progress& progress) {
        Combined out;
        if (m_labels)
            m_offset = firstFree(m_tree);
        if (m_options.seams || m_options.ball() > 0)
            out.seams = traceSeams(m_sides, seeds());
        if (m_options.ball() > 0 && !out.seams.empty())
            round(out.seams);
        progress.step(0.8, "Joining");
        tree::Edit edit;
        take(edit, out);
        edit.inserted.layout = m_tree.layout();
        insert(edit, out);
        insertFillet(edit, out);
        insertSlivers(edit, out);
        if (m_tree.size() - out.removed + out.inserted < 4)
            throw base::Error("nothing would be left", "", "move the other one, or choose another operation");
        progress.step(0.9, "Joining");
        if (m_options.parts) {
            out.partsGone = partsThatGo(m_tree, edit);
            if (!m_trimmed) // what coincides with the model is there all the same
                out.otherPartsGone = partsWhere(m_other, [&](std::size_t i) {
                    return std::abs(m_ofOperand[i]) == 1 && !staysOfOperand(m_operation, m_ofOperand[i]);
                });
        }
        out.surface = {m_tree.apply(edit), m_definition};
        return out;
    }

  private:
    static bool hasLabels(const tree::SurfelTree& tree) { return cells::LabelLayout::of(*tree.layout()).has_value(); }
    bool sharpSeam() const { return m_labels && !m_fillet; }
    bool chamfers() const { return m_fillet && m_options.chamfer > 0; }
    Label beside(const Label& label, std::uint32_t across) const {
        return besideSeam(label, across, m_operation == Operation::Union ? Meeting::Concave : Meeting::Convex);
    }
    bool edgeOfChamfer(bool ofOperand, const Vec3d& x, const Vec3d& normal) const {
        return chamfers() && m_labels && m_fillet->besideEdge(ofOperand, x, normal);
    }

    using Foot = SeamFoot;

    void findFeet() {
        m_modelFeet = seamFeetOf(m_tree, m_sides, m_operandSide,
                                 [&](std::size_t i) { return staysOfModel(m_operation, m_ofModel[i]); });
        m_operandFeet = seamFeetOf(m_other, m_sides, m_modelSide,
                                   [&](std::size_t i) { return staysOfOperand(m_operation, m_ofOperand[i]); });
    }
    std::vector<SeamSeed> seeds() const {
        std::vector<SeamSeed> out;
        for (const auto* feet : {&m_modelFeet, &m_operandFeet})
            for (const std::vector<Foot>& block : *feet)
                for (const Foot& foot : block)
                    out.push_back({foot.place, foot.spacing});
        return out;
    }
    static double spacingAt(const tree::SurfelTree& tree, const Vec3d& x) {
        std::vector<tree::Neighbour> near;
        tree.nearest(base::cast<float>(x), 1, near);
        const float ball = surfel::ballOf(*near[0].block, near[0].slot, surfel::shapeChannel(*tree.layout()));
        return static_cast<double>(ball) * surface::spacingOfUnit;
    }
    void round(const std::vector<SeamCurve>& seams) {
        const FilletSides sides{m_modelSide, m_operandSide, m_operation == Operation::Union,
                                m_operation != Operation::Intersection, m_options.chamfer > 0};
        m_fillet.emplace(sides, m_options.ball(), seams, [&](const Vec3d& x) { return spacingAt(m_tree, x); });
        if (!m_labels)
            return;
        if (chamfers()) {
            m_chamferCell = m_offset + firstFree(m_other);
            return;
        }
        m_faces.emplace(m_tree, m_other, m_offset, m_offset + firstFree(m_other), m_fillet->contacts());
        m_tree = m_faces->in(m_tree);
    }

    void take(tree::Edit& edit, Combined& out) {
        const auto layout = cells::LabelLayout::of(*m_tree.layout());
        struct Changed {
            tree::BlockEdit edit;
            std::size_t atSeam = 0;
            std::vector<Vec3d> beside;
        };
        std::vector<Changed> changed(m_tree.blockCount());
        const std::vector<std::size_t> first = m_tree.firstSurfels();
        base::parallelFor(changed.size(), 1, [&](std::size_t b) {
            const surfel::BlockPtr block = m_tree.block(static_cast<std::uint32_t>(b));
            Changed& here = changed[b];
            here.edit.block = static_cast<std::uint32_t>(b);
            for (int slot = 0; slot < block->size(); ++slot) {
                bool stays = staysOfModel(m_operation, m_ofModel[first[b] + static_cast<std::size_t>(slot)]);
                if (stays && m_fillet) {
                    const Vec3d x = base::cast<double>(block->position(slot));
                    const Fillet::Cover cover = m_fillet->cover(false, x, base::cast<double>(block->normal(slot)));
                    stays = cover != Fillet::Cover::Taken;
                    if (cover == Fillet::Cover::Beside)
                        here.beside.push_back(x);
                }
                here.edit.removed[static_cast<std::size_t>(slot)] = !stays;
            }
            RelabelledBlock relabelled(*block, *m_tree.layout());
            if (chamfers() && m_labels)
                labelChamferEdge(*block, *layout, here.edit, relabelled);
            else if (sharpSeam())
                for (const Foot& foot : m_modelFeet[b]) {
                    const auto slot = static_cast<int>(foot.index - first[b]);
                    const std::uint32_t across = m_offset + nearestLabel(m_other, foot.place).cell;
                    relabelled.put(slot, beside(layout->at(*block, slot), across));
                }
            here.atSeam = relabelled.giveTo(here.edit);
        });
        for (Changed& each : changed) {
            out.removed += each.edit.removed.count();
            out.atSeam += each.atSeam;
            m_beside.insert(m_beside.end(), each.beside.begin(), each.beside.end());
            if (each.edit.changed || each.edit.removed.any())
                edit.blocks.push_back(std::move(each.edit));
        }
    }

    /// Of the model's surfels that stay beside a chamfer.
    void labelChamferEdge(const surfel::SurfelBlock& block, const cells::LabelLayout& layout,
                          const tree::BlockEdit& edit, RelabelledBlock& relabelled) const {
        for (int slot = 0; slot < block.size(); ++slot)
            if (!edit.removed[static_cast<std::size_t>(slot)] &&
                edgeOfChamfer(false, base::cast<double>(block.position(slot)), base::cast<double>(block.normal(slot))))
                relabelled.put(slot, beside(layout.at(block, slot), m_chamferCell));
    }

    /// The operand's own label among the model's.
    Label moved(Label label) const {
        label = label.shifted(m_offset);
        if (m_faces)
            label.face = m_faces->of(label.face);
        if (m_operation == Operation::Difference)
            label.meeting = cells::opposite(label.meeting);
        return label;
    }
    /// What has no colours of its own, a cap or a ball, goes on in those beside it.
    surfel::Colour colourBeside(const base::Vec3f& place) const {
        std::vector<tree::Neighbour> nearest;
        m_tree.nearest(place, 1, nearest);
        return nearest.empty() ? surfel::white : nearest[0].block->surfel(nearest[0].slot).colour;
    }
    void insert(tree::Edit& edit, Combined& out) {
        const surfel::SurfelList all = m_other.surfels();
        std::vector<std::uint8_t> stays(all.size());
        base::parallelFor(all.size(), 256, [&](std::size_t i) {
            stays[i] = staysOfOperand(m_operation, m_ofOperand[i]);
            if (!stays[i] || !m_fillet)
                return;
            const Fillet::Cover cover = m_fillet->cover(true, base::cast<double>(all.items[i].position),
                                                        base::cast<double>(all.items[i].normal));
            stays[i] = cover == Fillet::Cover::Taken ? 0 : cover == Fillet::Cover::Beside ? 2 : 1;
        });
        const auto own = cells::LabelLayout::of(*all.layout);
        std::vector<Label> labels(m_labels ? all.size() : 0);
        for (std::size_t i = 0; i < labels.size(); ++i)
            labels[i] = moved(own ? own->at(all.extraOf(i)) : Label{});
        for (std::size_t i = 0; i < labels.size() && chamfers(); ++i)
            if (stays[i] &&
                edgeOfChamfer(true, base::cast<double>(all.items[i].position), base::cast<double>(all.items[i].normal)))
                labels[i] = beside(labels[i], m_chamferCell);
        if (sharpSeam())
            for (const std::vector<Foot>& block : m_operandFeet)
                for (const Foot& foot : block)
                    labels[foot.index] = beside(labels[foot.index], nearestLabel(m_tree, foot.place).cell);
        Translation translation(*all.layout, *m_tree.layout());
        // Into a model of balls ellipsoids come as balls, too.
        const int shape = surfel::shapeChannel(*m_tree.layout()) > 0 ? 0 : surfel::shapeChannel(*all.layout);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!stays[i])
                continue;
            surfel::Surfel s = all.items[i];
            if (shape > 0)
                s.support *= surfel::meanAxis(surfel::shapeIn(all.extraOf(i), surfel::shapeWord(*all.layout)));
            if (stays[i] == 2)
                m_beside.push_back(base::cast<double>(s.position));
            if (m_operation == Operation::Difference)
                s.normal = -s.normal;
            if (m_tree.layout()->colours && !all.layout->colours)
                s.colour = colourBeside(s.position);
            const std::span<std::uint32_t> words = translation(all.extraOf(i));
            if (m_labels)
                writeLabel(*m_tree.layout(), labels[i], words);
            edit.inserted.append(s, words);
            ++out.inserted;
        }
    }

    /// A surfel of a version's own, in the words of the result.
    void append(const Sliver& sliver, bool ofOperand, Translation& translation, surfel::SurfelList& to) const {
        const tree::Neighbour& like = sliver.like;
        surfel::Surfel s = like.block->surfel(like.slot);
        s.position = base::cast<float>(sliver.position);
        s.normal =
            base::cast<float>(ofOperand && m_operation == Operation::Difference ? -sliver.normal : sliver.normal);
        std::vector<std::uint32_t> own(like.block->extraWords());
        like.block->extra(like.slot, own);
        const Label label = cells::LabelLayout::of(ofOperand ? *m_other.layout() : *m_tree.layout())->at(own);
        const std::span<std::uint32_t> words = ofOperand ? translation(own) : std::span<std::uint32_t>(own);
        writeLabel(*m_tree.layout(),
                   beside(ofOperand ? moved(label) : label, ofOperand ? sliver.across : sliver.across + m_offset),
                   words);
        to.append(s, words);
    }
    /// Without any surfel of its own a face would not be, and those beside it went on to where they meet.
    void insertSlivers(tree::Edit& edit, Combined& out) const {
        if (!sharpSeam() || m_other.empty())
            return;
        Translation translation(*m_other.layout(), *m_tree.layout());
        const bool joins = m_operation == Operation::Union;
        for (const bool ofOperand : {false, true})
            for (const Sliver& each :
                 ofOperand ? sliversOf(m_other, m_operandSide, m_modelSide, !joins, m_operandFeet, m_modelFeet)
                           : sliversOf(m_tree, m_modelSide, m_operandSide, m_operation == Operation::Intersection,
                                       m_modelFeet, m_operandFeet)) {
                append(each, ofOperand, translation, edit.inserted);
                ++out.inserted;
            }
    }

    /// What the ball leaves, where none of those that stay stands already.
    void insertFillet(tree::Edit& edit, Combined& out) const {
        if (!m_fillet)
            return;
        std::vector<FilletPlace> places = m_fillet->places();
        double widest = 0;
        for (const FilletPlace& each : places)
            widest = std::max(widest, each.spacing);
        base::Box3d box;
        box.extend(places[0].position);
        std::vector<process::PointGrid::Entry> entries;
        for (const Vec3d& x : m_beside) {
            box.extend(x);
            entries.push_back({base::cast<float>(x), static_cast<std::uint32_t>(entries.size())});
        }
        process::PointGrid stay(base::cast<float>(box.lo), static_cast<float>(std::max(widest, 1e-5 * box.diagonal())));
        stay.build(entries);
        Translation translation(*m_other.layout(), *m_tree.layout());
        for (const FilletPlace& each : places) {
            constexpr double apart = 0.65; // of a spacing, as in 1.4
            bool free = true;
            stay.forNear(base::cast<float>(each.position), static_cast<float>(apart * each.spacing),
                         [&](const auto& entry) {
                             free = free && distance(m_beside[entry.index], each.position) >= apart * each.spacing;
                         });
            if (free)
                append(each, translation, edit.inserted), ++out.rounded;
        }
        out.inserted += out.rounded;
    }
    /// A surfel of the fillet takes after what the ball touches.
    void append(const FilletPlace& place, Translation& translation, surfel::SurfelList& to) const {
        std::vector<tree::Neighbour> model, operand;
        m_tree.nearest(base::cast<float>(place.onModel), 1, model);
        m_other.nearest(base::cast<float>(place.onOperand), 1, operand);
        const bool nearModel = place.across < 0.5;
        const tree::Neighbour& from = nearModel ? model[0] : operand[0];
        surfel::Surfel s = from.block->surfel(from.slot);
        s.position = base::cast<float>(place.position);
        s.normal = base::cast<float>(place.normal);
        s.support = process::supportOf(m_definition, static_cast<float>(place.spacing));
        s.mask = 0;
        std::vector<std::uint32_t> own(from.block->extraWords());
        from.block->extra(from.slot, own);
        const std::span<std::uint32_t> words = nearModel ? std::span<std::uint32_t>(own) : translation(own);
        if (surfel::shapeChannel(*m_tree.layout()) > 0)
            surfel::putShape(words, surfel::shapeWord(*m_tree.layout()), {});
        if (m_labels) {
            Label label =
                nearModel ? nearestLabel(m_tree, place.onModel) : moved(nearestLabel(m_other, place.onOperand));
            if (chamfers()) {
                const double toEdge = place.chord() * (nearModel ? place.across : 1 - place.across);
                const std::uint32_t side = label.cell;
                label.cell = label.face = m_chamferCell;
                label = toEdge < 2 * place.spacing
                            ? beside(label, side)
                            : Label{m_chamferCell, m_chamferCell, Meeting::None, 255, m_chamferCell};
            } else {
                label.partner = label.cell;
                label.meeting = Meeting::None;
            }
            writeLabel(*m_tree.layout(), label, words);
        }
        to.append(s, words);
    }

    surface::SurfaceDefinition m_definition;
    Operation m_operation;
    CombineOptions m_options;
    tree::SurfelTree m_other;
    bool m_labels; ///< surfels carry labels of cells
    tree::SurfelTree m_tree;
    SurfaceSide m_modelSide;
    const Side& m_operandSide;
    TwoSides m_sides{[this](const Vec3d& x) { return m_modelSide.at(x); },
                     [this](const Vec3d& x) { return m_operandSide.at(x); }};
    std::vector<std::int8_t> m_ofModel, m_ofOperand;
    bool m_trimmed;
    SeamFeet m_modelFeet, m_operandFeet;
    std::uint32_t m_offset = 0;
    std::optional<Fillet> m_fillet;
    std::uint32_t m_chamferCell = 0;
    std::optional<JoinedFaces> m_faces;
    std::vector<Vec3d> m_beside; ///< places of surfels that stay beside a fillet
};

} // namespace

Combined combine(const surface::Surface& model, const Operand& operand, Operation operation,
                 const CombineOptions& options, const base::Progress& progress) {
    requireSolid(model);
    const base::CancelScope scope(progress.cancel);
    Combining combining(model, operand, operation, options);
    combining.findSides(progress);
    surface::Surface finer = model;
    Operand other{operand.side, operand.surfels, {}, operand.trimmed};
    if (!combining.grade(finer, other.surfels))
        return combining.run(progress);
    Combining again(finer, other, operation, options);
    again.findSides(progress);
    Combined out = again.run(progress);
    const auto more = [](std::size_t after, std::size_t before) { return after > before ? after - before : 0; };
    out.finer = more(finer.tree().size(), model.tree().size());
    out.inserted += out.finer;
    out.removed += more(model.tree().size(), finer.tree().size());
    out.finer += more(other.surfels.size(), operand.surfels.size());
    return out;
}

} // namespace solid
