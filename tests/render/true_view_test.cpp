#include "core/render/cast/true_view.h"

#include "core/render/cast/raycast_image.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <atomic>
#include <QTest>

using namespace render;

class TrueViewTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void lastLevelIsTheSurface();
    void levelsNeverKnowLess();
    void onlyTheViewThatWasRefinedIsKnown();
    void editForgetsOnlyWhatItTouches_data();
    void editForgetsOnlyWhatItTouches();
    void measuredNumbersColourTheSurface();
    void lightComesLastAndStays();
    void outlinesAreSmoothAtLast();
    void cancelledRefinementGoesOn();
};

namespace {

TrueView::Subject subjectOf(tree::SurfelTree model) {
    TrueView::Subject out;
    out.surface = surface::Surface(std::move(model), {});
    out.camera.width = 160, out.camera.height = 120;
    return out;
}
TrueView::Subject sphere(std::size_t surfels = 6000) {
    return subjectOf(test::built(test::sphere({0, 0, 0}, 0.9, surfels)));
}

std::size_t unknown(const ShadedLayer& layer) {
    return static_cast<std::size_t>(
        std::count_if(layer.pixels.begin(), layer.pixels.end(),
                      [](const ShadedLayer::Pixel& p) { return p.kind == PixelKind::Unknown; }));
}

std::vector<TrueView::Level> refined(TrueView& view, const TrueView::Subject& subject) {
    std::vector<TrueView::Level> out;
    view.refine(subject, [&](const TrueView::Level& level) { out.push_back(level); }, {});
    return out;
}

Image castOf(const TrueView::Subject& subject) {
    Image out;
    RenderOptions options;
    options.shading = subject.options.shading;
    RayCounts counts;
    rayCast(subject.surface, subject.camera, options, out, counts, {}, {subject.measured.get(), {}, false});
    return out;
}

/// Pixels whose colours are more than `step` of 255 apart, or that are surface in one alone.
std::size_t apart(const ShadedLayer& layer, const Image& cast, int step) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < layer.pixels.size(); ++i) {
        const bool hit = std::isfinite(cast.depth[i]);
        int most = 0;
        for (int k = 0; k < 24; k += 8)
            most = std::max(most, std::abs(static_cast<int>(layer.pixels[i].colour >> k & 255u) -
                                           static_cast<int>(cast.colour[i] >> k & 255u)));
        out += (layer.pixels[i].kind == PixelKind::Surface) != hit || (hit && most > step);
    }
    return out;
}

/// Mean over the pixels and channels, of 255.
double difference(const ShadedLayer& a, const ShadedLayer& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int k = 0; k < 24; k += 8)
            sum += std::abs(static_cast<int>(a.pixels[i].colour >> k & 255u) -
                            static_cast<int>(b.pixels[i].colour >> k & 255u));
    return sum / (3 * static_cast<double>(a.pixels.size()));
}

/// One surfel of the front a little further out.
tree::SurfelTree edited(const tree::SurfelTree& model) {
    tree::Edit edit;
    edit.inserted.layout = model.layout();
    model.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size() && edit.blocks.empty(); ++slot)
            if (block.position(slot).z > 0.85f) {
                edit.blocks.push_back({number, nullptr, {}});
                edit.blocks.back().removed.set(static_cast<std::size_t>(slot));
                surfel::Surfel moved = block.surfel(slot);
                moved.position.z += 0.02f;
                edit.inserted.append(moved, {});
            }
    });
    return model.apply(edit);
}

} // namespace

void TrueViewTest::lastLevelIsTheSurface() {
    TrueView view;
    for (const double quality : {1.0, 0.0}) {
        auto subject = sphere();
        subject.quality = quality;
        const auto levels = refined(view, subject);
        QVERIFY(!levels.empty() && levels.back().complete && levels.back().quality <= quality);
        QCOMPARE(unknown(*levels.back().layer), std::size_t(0));
        // Two degrees of the normal are some steps of the light; every pixel its own ray is the same to the bit.
        const std::size_t wrong = apart(*levels.back().layer, castOf(subject), quality > 0 ? 12 : 0);
        QVERIFY2(wrong <= (quality > 0 ? 20u : 0u), qPrintable(QString::number(wrong)));
    }
}

void TrueViewTest::levelsNeverKnowLess() {
    TrueView view;
    const auto levels = refined(view, sphere());
    QVERIFY(levels.size() >= 2);
    for (std::size_t i = 1; i < levels.size(); ++i) {
        QVERIFY(unknown(*levels[i].layer) <= unknown(*levels[i - 1].layer));
        QVERIFY(levels[i].quality <= levels[i - 1].quality);
    }
}

void TrueViewTest::onlyTheViewThatWasRefinedIsKnown() {
    TrueView view;
    auto subject = sphere();
    QVERIFY(!view.known(subject));
    const auto levels = refined(view, subject);
    QVERIFY(view.known(subject) == levels.back().layer);
    auto turned = subject;
    turned.camera.eye.x += 0.1;
    QVERIFY(!view.known(turned));
    auto other = subject;
    other.options.shading = Shading::Normal;
    QVERIFY(!view.known(other));
}

void TrueViewTest::editForgetsOnlyWhatItTouches_data() {
    QTest::addColumn<double>("support");
    QTest::newRow("even") << 0.0;
    QTest::newRow("one far surfel reaches far") << 1.5;
}

void TrueViewTest::editForgetsOnlyWhatItTouches() {
    QFETCH(double, support);
    TrueView view;
    surfel::SurfelList list = test::sphere({0, 0, 0}, 0.9, 60000);
    if (support > 0) {
        list.items.push_back(list.items.front());
        list.items.back().position = {30, 0, 0};
        list.items.back().support = static_cast<float>(support);
    }
    auto subject = subjectOf(test::built(list));
    const auto before = refined(view, subject).back().layer;
    subject.surface = surface::Surface(edited(subject.surface.tree()), {});
    const auto known = view.known(subject);
    QVERIFY(known);
    const std::size_t forgotten = unknown(*known);
    QVERIFY2(forgotten > 0 && forgotten < known->pixels.size() / 2, qPrintable(QString::number(forgotten)));
    const auto after = refined(view, subject).back().layer;
    QCOMPARE(unknown(*after), std::size_t(0));
    std::size_t changed = 0;
    for (std::size_t i = 0; i < known->pixels.size(); ++i) {
        if (known->pixels[i].kind != PixelKind::Unknown)
            QVERIFY2(known->pixels[i] == before->pixels[i], "what is kept is what was");
        changed += !(after->pixels[i] == before->pixels[i]);
    }
    QVERIFY(changed > 0 && changed <= forgotten);
}

void TrueViewTest::measuredNumbersColourTheSurface() {
    TrueView view;
    auto subject = sphere();
    subject.options.shading = Shading::Curvature;
    const MeasureRow& row = *shadingRow(subject.options.shading).measure;
    subject.measured =
        std::make_shared<Measured>(Measured{{row.quantity, subject.surface, {}}, fixedScale(row, -2, 2)});
    const auto levels = refined(view, subject);
    QVERIFY(apart(*levels.back().layer, castOf(subject), 24) < 40);
}

/// Levels before it show no light; after an edit what is lit already is not seen without.
void TrueViewTest::lightComesLastAndStays() {
    TrueView view;
    auto subject = sphere(40000);
    const auto unlit = refined(view, subject).back().layer;
    subject.lighting.material = raycast::Material::Clay;
    subject.lighting.shadows = true;
    const auto levels = refined(view, subject);
    QVERIFY(levels.size() >= 4 && levels.back().complete);
    const auto lit = levels.back().layer;
    // The surface without light, coarse light that comes nearer, the light itself.
    QVERIFY(levels[levels.size() - 4].layer->pixels == unlit->pixels && lit->pixels != unlit->pixels);
    double before = std::numeric_limits<double>::infinity();
    for (std::size_t back = 4; back >= 1; --back) {
        const TrueView::Level& level = levels[levels.size() - back];
        QVERIFY(level.complete == (back == 1));
        const double now = difference(*level.layer, *lit);
        QVERIFY2(now < before, qPrintable(QString("%1, then %2").arg(before).arg(now)));
        before = now;
    }
    subject.surface = surface::Surface(edited(subject.surface.tree()), {});
    const auto known = view.known(subject);
    QVERIFY(known && unknown(*known) > 0);
    for (const TrueView::Level& level : refined(view, subject))
        if (!level.complete)
            for (std::size_t i = 0; i < lit->pixels.size(); ++i)
                if (known->pixels[i].kind != PixelKind::Unknown)
                    QVERIFY(level.layer->pixels[i] == lit->pixels[i]);
}

void TrueViewTest::outlinesAreSmoothAtLast() {
    TrueView view;
    auto subject = sphere();
    const auto plain = refined(view, subject).back().layer;
    subject.smooth = true;
    const auto levels = refined(view, subject);
    const auto& smooth = levels.back().layer->pixels;
    QVERIFY(levels.back().complete && !levels[levels.size() - 2].complete);
    std::size_t changed = 0, surface = 0;
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        changed += smooth[i].colour != plain->pixels[i].colour ? 1 : 0;
        surface += smooth[i].kind == PixelKind::Surface ? 1 : 0;
    }
    QVERIFY2(changed > 100 && changed < surface / 4, qPrintable(QString::number(changed)));
}

void TrueViewTest::cancelledRefinementGoesOn() {
    TrueView view;
    const auto subject = sphere();
    std::atomic<bool> stop = false;
    base::Progress progress;
    progress.cancel = &stop;
    const auto first = [&](const TrueView::Level&) {
        stop = true;
        progress.step(0, {});
    };
    QVERIFY_EXCEPTION_THROWN(view.refine(subject, first, progress), base::Cancelled);
    TrueView fresh;
    const auto expected = refined(fresh, subject).back().layer, got = refined(view, subject).back().layer;
    QVERIFY(expected->pixels == got->pixels);
}

static const test::Registered<TrueViewTest> registered;
#include "true_view_test.moc"
