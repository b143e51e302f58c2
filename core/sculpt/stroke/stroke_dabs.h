// The version that a stroke works on, and how one dab with all its images is done to it. What the ways of making dabs
// (stroke_methods.h) have in common.
//
//     contacts of all images, exact, on one version -> Dab each, complete with areas, stamp and factors -> tool
//       -> tool "smooth" where asked -> resampling where due
//
// Where mirrored brushes overlap they share the strength as Blender's feathering does: 1 / sum of (1 - distance / 2R).
#pragma once

#include "core/sculpt/brush_stamp.h"
#include "core/sculpt/contact.h"
#include "core/sculpt/mirror.h"
#include "core/sculpt/sampling.h"
#include "core/sculpt/stroke/stroke_sample.h"

#include <atomic>

namespace sculpt {

class Dabs {
  public:
    using Contacts = std::vector<std::optional<Contact>>; ///< one per image
    /// What may differ from dab to dab beside the place.
    struct Form {
        float radius = 0;
        float strength = 1;  ///< times the settings'
        base::Vec3f upwards; ///< where the stamp's upper edge points; zero: as the settings say
    };

    Dabs(surface::Surface start, StrokeSettings settings, const base::Vec3d& origin,
         std::shared_ptr<const BrushStamp> stamp, const std::atomic<bool>* cancel);

    /// The model has layers, which edits must keep up with. Before the first dab.
    void onLayers(std::shared_ptr<const layers::Stack> stack) {
        m_layers = std::move(stack), m_whole = m_base;
        m_pattern.layers = m_layers.get();
    }

    const StrokeSettings& settings() const { return m_settings; }
    const surface::Surface& surface() const { return m_surface; }
    const std::vector<Mirror>& images() const { return m_images; }
    /// The version that dabs touch: the present one, or where they do not accumulate the first.
    const surface::Surface& touched() const { return m_accumulate ? m_surface : m_base; }
    /// Tools that take surfels away stay on the surface that the stroke began on, and do not dig on through the hole.
    std::optional<Contact> contact(const base::Rayf& ray) const {
        checkCancelled();
        return sculpt::contact(m_row.writes == Writes::Count ? m_first : touched(), ray);
    }
    /// Do dabs touch what those before them have moved?
    bool touchesItsOwn() const { return m_accumulate && movesSurfaces(m_row); }
    /// On the version that the stroke began on; nothing where dabs touch that one anyway, or move no surface.
    std::optional<Contact> contactBefore(const base::Rayf& ray) const {
        return touchesItsOwn() ? sculpt::contact(m_first, ray) : std::nullopt;
    }
    /// Of the stroke's first dab, along its ray; stays at a restart.
    const std::optional<float>& depth() const { return m_depth; }

    /// Radius and strength at a sample, by its pressure and, where dabs add up, its stride.
    Form form(const StrokeSample& sample) const;
    /// How many dabs at one place are as much as a stroke leaves there that goes over it, with dabs this part of the
    /// radius apart: the weights of all that reach it. 1 where dabs do not add up, or make their own sampling.
    double overlap(float spacing) const;
    /// As much as `dabs` of this form in the same place, in as few as strength allows.
    void pile(const StrokeSample& sample, const Contact& own, Form form, double dabs);
    /// One dab with its images. `own`: the contact of the sample's ray on the present version, found before; only the
    /// other images' rays are cast here.
    void dabAt(const StrokeSample& sample, const Contact& own, const Form& form);

    // --- for those that hold what they touched first ---
    /// Of all images of a ray whose own contact is known.
    Contacts contactsOf(const base::Rayf& ray, const Contact& own) const;
    /// Shares of the strength where images overlap.
    static std::vector<float> shares(const Contacts& contacts, float radius);
    /// Of image `index` of a ray along `view`.
    Dab dabOf(const Contact& at, std::size_t index, const base::Vec3f& view, const Form& form);
    /// These dabs, of all images, as one place of the stroke. REQUIRES: begin.
    void apply(std::span<const Dab> images);
    /// What these would make, all images, without resampling; nothing is changed.
    surface::Surface preview(std::span<const Dab> images) const;
    /// Notes the first contact: spacing, depth.
    void begin(const Contact& first);

    /// Back to the first version, as if no dab had been.
    void restart();
    /// A slice of what dabs have left to the end, and of the last resampling; true when nothing is left of it.
    bool finishSlice();

    int count() const { return m_count; }
    std::span<const double> seconds() const { return m_seconds; }

  private:
    struct Anchor {
        base::Vec3f position, normal;
    };
    /// Throws base::Cancelled.
    void checkCancelled() const;
    void applyOne(Dab dab);
    bool refines() const { return m_settings.resample && movesSurfaces(m_row); }
    /// Samples that are large against the brush give way to finer ones on the same surface.
    void refineUnder(const base::Vec3f& centre, float radius);
    /// What the tool makes of the dab.
    tree::Edit edited(const surface::Surface& version, const Dab& dab) const;
    void pileUp(Dab dab);
    void holdBack(const Dab& dab);
    tree::Edit smoothing(const surface::Surface& version, Dab dab) const;
    void commit(tree::Edit edit, const Dab& dab);
    /// A slice of what the tool has left to the end. False: nothing is left.
    bool restSlice();
    void aim(Dab& dab, const Mirror& image, const base::Vec3f& view, const Form& form) const;
    void join(Dab& dab, const surface::Surface& version) const;
    /// With what a tool may ask of the stroke so far, for a dab that works on `version`.
    void complete(Dab& dab, const surface::Surface& version) const;

    surface::Surface m_first, m_surface;
    surface::Surface m_base; ///< what dabs that do not accumulate work on
    StrokeSettings m_settings;
    const ToolRow& m_row;
    bool m_accumulate;
    std::vector<Mirror> m_images;
    Dab m_pattern;         ///< what all dabs have in common
    float m_smoothing = 0; ///< strength of the smoothing after each
    BrushCurve m_pressureStrength, m_pressureRadius;
    Sampling m_sampling;
    std::optional<float> m_depth;
    std::vector<std::optional<Anchor>> m_anchors;     ///< of each image's first dab
    std::vector<std::optional<base::Vec3f>> m_places; ///< of each image's last dab
    std::vector<PastDab> m_past;
    std::unique_ptr<ToolMemory> m_memory;
    int m_count = 0;
    std::vector<double> m_seconds;
    std::shared_ptr<const layers::Stack> m_layers; ///< null: none
    surface::Surface m_whole; ///< where it has: m_surface of dabs that do not accumulate, before layers record them
    const std::atomic<bool>* m_cancel;
};

} // namespace sculpt
