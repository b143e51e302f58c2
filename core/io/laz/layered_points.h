// How LASzip codes points of formats 6 to 10: each group of fields in a layer of its own bytes, with probabilities and
// last values for each of the four channels that a scanner may have (io/README 2.13).
#pragma once

#include "core/io/laz/point_models.h"

#include <optional>

namespace io::laz {

/// The layers in the order in which a chunk has them; then one for each extra byte.
enum Layer : unsigned { Place, Height, Class, Flags, Intensity, Angle, User, Source, Time, fixedLayers };

/// What the records of a file are made of, behind the 30 bytes of POINT14.
struct LayeredItems {
    std::size_t rgb = 0, nir = 0, wave = 0; ///< offsets; 0: none
    std::size_t extra = 0, extraCount = 0;
    /// Version 3 of the items takes, for the first point after a change of the channel, the last point of all as the
    /// last one of the channel: a fault that files have.
    bool mendsChannels = true;

    std::size_t layers() const {
        return fixedLayers + (rgb > 0 ? 1 : 0) + (nir > 0 ? 1 : 0) + (wave > 0 ? 1 : 0) + extraCount;
    }
};

/// The points of one chunk, one after the other. A layer without bytes says that its fields stay those of the first
/// point.
template <class Coder>
class LayeredPoints {
  public:
    /// One coder for each layer, null where the layer has no bytes; they must outlive the object.
    LayeredPoints(const LayeredItems& items, const char* first, std::vector<Coder*> coders);
    ~LayeredPoints();
    LayeredPoints(const LayeredPoints&) = delete;
    LayeredPoints& operator=(const LayeredPoints&) = delete;
    /// Reads the record in one direction, writes it in the other.
    void code(char* record);

  private:
    struct Channel;
    Channel& channel(unsigned number, const char* first);
    Coder* layer(std::size_t k) const { return m_coders[k]; }
    unsigned changes(const Channel& last, const Channel& before, const char* record) const;
    unsigned codeReturns(Channel& c, unsigned changed, const char* record);
    void codePlace(Channel& c, unsigned returns, bool newTime, const char* record);
    void codeFields(Channel& c, unsigned changed, unsigned kind, const char* record);
    void codeFurther(Channel& c, bool switched, char* record);
    char* lastOfFurther(Channel& c, std::size_t item, bool switched);

    LayeredItems m_items;
    std::vector<Coder*> m_coders;
    std::unique_ptr<Channel> m_channels[4];
    unsigned m_current = 0, m_previous = 0;
};

} // namespace io::laz
