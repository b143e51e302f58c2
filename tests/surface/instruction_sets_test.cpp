// The vectorised kernel on the instruction sets of this machine.
#include "core/surface/definition_text.h"
#include "shapes.h"
#include "support/registry.h"

#include <cstring>
#include <hwy/targets.h>
#include <QtTest>

using namespace surface;

class InstructionSetsTest : public QObject {
    Q_OBJECT
  private slots:
    void avx2AndAvx512GiveTheSameBits();
};

static std::vector<Evaluationf> answers(const Surface& surface) {
    std::vector<base::Vec3f> x;
    for (const surfel::Surfel& s : surface.tree().surfels().items)
        x.push_back(s.position * 1.01f);
    std::vector<Evaluationf> out(x.size());
    surface.evaluate(x, Need::Gradient, out);
    return out;
}

static bool same(const base::Vec3f& a, const base::Vec3f& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void InstructionSetsTest::avx2AndAvx512GiveTheSameBits() {
    if ((hwy::SupportedTargets() & HWY_AVX3) == 0)
        QSKIP("this machine has no AVX-512");
    for (const auto& frame : frameNames())
        for (const auto& weight : weightNames())
            for (const bool oriented : {true, false}) {
                surfel::SurfelList list = shapes::jittered(
                    shapes::torus(1, 0.4, 0.06, weight.value == Weight::Gaussian ? 0.35 : 0.21), 0.01, 7);
                list.layout = shapes::layout(true, oriented);
                SurfaceDefinition definition;
                definition.frame = frame.value;
                definition.weight = weight.value;
                const Surface surface = shapes::surfaceOf(list, definition);
                const std::vector<Evaluationf> wide = answers(surface);
                hwy::DisableTargets(HWY_AVX3 | HWY_AVX3_DL);
                hwy::GetChosenTarget().DeInit();
                QVERIFY((hwy::SupportedTargets() & HWY_AVX3) == 0);
                const std::vector<Evaluationf> narrow = answers(surface);
                hwy::DisableTargets(0);
                hwy::GetChosenTarget().DeInit();
                for (std::size_t i = 0; i < wide.size(); ++i) {
                    const Evaluationf &a = wide[i], &b = narrow[i];
                    QVERIFY2(a.status == b.status && a.samples == b.samples && a.value == b.value &&
                                 same(a.normal, b.normal) && same(a.gradient, b.gradient) &&
                                 same(a.centroid, b.centroid),
                             qPrintable(QString("%1 %2, position %3").arg(frame.name, weight.name).arg(i)));
                }
            }
}

static const test::Registered<InstructionSetsTest> registered;
#include "instruction_sets_test.moc"
