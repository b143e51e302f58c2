// The vectorised kernels on the instruction sets of this machine.
#include "core/surface/definition_text.h"
#include "core/surface/evaluation/self.h"
#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "surface/definition_rows.h"
#include "surface/moving_axis.h"
#include "surface/shapes.h"

#include <cstring>
#include <hwy/targets.h>
#include <QTest>

using namespace surface;

class InstructionSetsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void avx2AndAvx512GiveTheSameBits_data();
    void avx2AndAvx512GiveTheSameBits();
    void sumsHaveTheSameBits();
    void selfEvaluationHasTheSameBits();
    void projectionsHaveTheSameBits();
    void referencesHaveTheSameBits();
};

namespace {

bool hasBoth() {
    return (hwy::SupportedTargets() & HWY_AVX3) != 0 && (hwy::SupportedTargets() & HWY_AVX2) != 0;
}

/// What fn gives on AVX2.
template <class Fn>
auto narrowly(const Fn& fn) {
    hwy::DisableTargets(HWY_AVX3 | HWY_AVX3_DL);
    hwy::GetChosenTarget().DeInit();
    if ((hwy::SupportedTargets() & HWY_AVX3) != 0)
        qFatal("AVX-512 would not go");
    auto out = fn();
    hwy::DisableTargets(0);
    hwy::GetChosenTarget().DeInit();
    return out;
}

Surface torus(Weight weight, SurfaceDefinition definition = {}, bool oriented = true) {
    surfel::SurfelList list =
        shapes::jittered(shapes::torus(1, 0.4, 0.08, weight == Weight::Gaussian ? 0.45 : 0.28), 0.01, 7);
    list.layout = shapes::layout(true, oriented);
    definition.weight = weight;
    return shapes::surfaceOf(list, definition);
}

std::vector<base::Vec3f> positions(const Surface& surface) {
    std::vector<base::Vec3f> out;
    const surfel::SurfelList list = surface.tree().surfels();
    for (std::size_t i = 0; i < list.size(); i += 10 / test::effort(10))
        out.push_back(list.items[i].position * 1.01f);
    return out;
}

std::vector<Evaluationf> answers(const Surface& surface, Need need) {
    const std::vector<base::Vec3f> x = positions(surface);
    std::vector<Evaluationf> out(x.size());
    surface.evaluate(x, need, out);
    return out;
}

template <class T>
bool same(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const Evaluationf& a, const Evaluationf& b) {
    return a.status == b.status && a.cause == b.cause && a.samples == b.samples && same(a.value, b.value) &&
           same(a.normal, b.normal) && same(a.gradient, b.gradient) && same(a.centroid, b.centroid) &&
           same(a.hessian, b.hessian) && same(a.normalGradient, b.normalGradient) && same(a.unit, b.unit) &&
           same(a.agreement, b.agreement);
}

} // namespace

void InstructionSetsTest::avx2AndAvx512GiveTheSameBits_data() {
    test::addDefinitionRows("oriented");
}

void InstructionSetsTest::avx2AndAvx512GiveTheSameBits() {
    QFETCH(int, frame);
    QFETCH(int, weight);
    QFETCH(bool, oriented);
    if (!hasBoth())
        QSKIP("this machine has no AVX-512");
    SurfaceDefinition definition;
    definition.frame = static_cast<Frame>(frame);
    for (const bool interpolating : {false, true}) {
        definition.interpolating = interpolating;
        const Surface surface = torus(static_cast<Weight>(weight), definition, oriented);
        for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
            if (need == Need::Hessian && (definition.frame != Frame::Normals || interpolating))
                continue; // no kernel in it
            const std::vector<Evaluationf> wide = answers(surface, need);
            const std::vector<Evaluationf> narrow = narrowly([&] { return answers(surface, need); });
            for (std::size_t i = 0; i < wide.size(); ++i)
                QVERIFY2(same(wide[i], narrow[i]), qPrintable(QString("position %1").arg(i)));
        }
    }
}

/// All sums of order 2 with the products of two, in every way that surfels are taken.
static std::vector<Moments<float, 2>> allSums(const Surface& surface, const SumOptions& options) {
    std::vector<Moments<float, 2>> out;
    for (const base::Vec3f& x : positions(surface)) {
        out.emplace_back();
        sum(ScratchClusters(surface.tree(), x, options.scale).span(), x, options, out.back());
    }
    return out;
}

void InstructionSetsTest::sumsHaveTheSameBits() {
    if (!hasBoth())
        QSKIP("this machine has no AVX-512");
    for (const auto& weight : weightNames()) {
        const Surface surface = torus(weight.value);
        for (const Facing facing : {Facing::All, Facing::Skip, Facing::Flip, Facing::Refit, Facing::Part})
            for (const Outer outer : {Outer::None, Outer::Normals, Outer::Offsets}) {
                SumOptions options;
                options.weight = weight.value;
                options.facing = facing;
                options.outer = outer;
                options.reference = base::normalized(base::Vec3d{1, 2, 3});
                base::Random random(7);
                const Axis axis = test::movingAxis(options.reference, random);
                options.axis = &axis;
                options.scale = 1.3f;
                options.interpolating = outer == Outer::Offsets;
                const auto wide = allSums(surface, options);
                const auto narrow = narrowly([&] { return allSums(surface, options); });
                for (std::size_t i = 0; i < wide.size(); ++i)
                    QVERIFY2(same(wide[i], narrow[i]), weight.name);
            }
    }
}

void InstructionSetsTest::selfEvaluationHasTheSameBits() {
    if (!hasBoth())
        QSKIP("this machine has no AVX-512");
    for (const auto& weight : weightNames()) {
        const Surface surface = torus(weight.value);
        const auto all = [&] {
            std::vector<std::vector<SelfLanes>> out(surface.tree().blockCount());
            evaluateSelf(surface, Need::Gradient,
                         [&](std::uint32_t number, const surfel::SurfelBlock& block, std::span<const SelfLanes> at) {
                             for (const SelfLanes& each : at) {
                                 SelfLanes kept{};
                                 const std::size_t first = out[number].size() * surfel::clusterSize;
                                 const std::size_t left = std::size_t(block.size()) - first;
                                 for (int i = 0; i < surfel::clusterSize && std::size_t(i) < left; ++i) {
                                     kept.value[i] = each.value[i], kept.weight[i] = each.weight[i];
                                     kept.status[i] = each.status[i];
                                     for (int k = 0; k < 3; ++k) {
                                         kept.centroid[k][i] = each.centroid[k][i];
                                         kept.normal[k][i] = each.normal[k][i];
                                         kept.gradient[k][i] = each.gradient[k][i];
                                     }
                                 }
                                 out[number].push_back(kept);
                             }
                         });
            return out;
        };
        const auto wide = all();
        const auto narrow = narrowly(all);
        for (std::size_t b = 0; b < wide.size(); ++b)
            for (std::size_t c = 0; c < wide[b].size(); ++c)
                QVERIFY2(same(wide[b][c], narrow[b][c]), weight.name);
    }
}

void InstructionSetsTest::projectionsHaveTheSameBits() {
    if (!hasBoth())
        QSKIP("this machine has no AVX-512");
    for (const auto& weight : weightNames()) {
        const Surface surface = torus(weight.value);
        const std::vector<base::Vec3f> x = positions(surface);
        const auto all = [&] {
            std::vector<Projection<float>> out(x.size());
            project(surface, x, {}, out);
            return out;
        };
        const auto wide = all(), narrow = narrowly(all);
        for (std::size_t i = 0; i < x.size(); ++i)
            QVERIFY(wide[i].iterations == narrow[i].iterations && same(wide[i].foot, narrow[i].foot) &&
                    same(wide[i].at, narrow[i].at));
    }
}

/// Sums in double are put into lanes in another way than those in float: on any machine, with bits of one by one.
void InstructionSetsTest::referencesHaveTheSameBits() {
    const Surface surface = torus(Weight::Wendland);
    const surfel::SurfelList plates = shapes::plates(8, 0.07, 0.24, 0.08);
    const Surface near = shapes::surfaceOf(plates);
    for (const Surface& each : {surface, near}) {
        const std::vector<base::Vec3f> x = positions(each);
        const auto all = [&] {
            std::vector<Evaluationd> out;
            for (const base::Vec3f& p : x)
                for (const Need need : {Need::Value, Need::Gradient, Need::Hessian})
                    out.push_back(each.evaluateReference(base::cast<double>(p), need));
            return out;
        };
        const auto wide = all(), narrow = narrowly(all);
        for (std::size_t i = 0; i < wide.size(); ++i)
            QVERIFY(same(wide[i].value, narrow[i].value) && same(wide[i].gradient, narrow[i].gradient) &&
                    same(wide[i].hessian, narrow[i].hessian) && same(wide[i].centroid, narrow[i].centroid) &&
                    wide[i].samples == narrow[i].samples);
    }
}

static const test::Registered<InstructionSetsTest> registered;
#include "instruction_sets_test.moc"
