// What is known of the pixels of one view: the rays cast so far by pixel, and which pixels need none. The lattice goes
// on beyond the right and the lower edge of the image, to whole start cells. One thread writes, any number read.
#pragma once

#include "core/raycast/cast_pixels.h"

namespace raycast {

class Lattice {
  public:
    /// Forgets everything.
    void reset(int columns, int rows) {
        m_columns = columns, m_rows = rows;
        m_code.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), unknown);
        m_rays.clear();
    }
    int columns() const { return m_columns; }
    int rows() const { return m_rows; }

    /// Neither a ray nor anything else is known.
    bool open(Pixel p) const { return code(p) == unknown; }
    /// The pixel's own ray; null where none was cast.
    const Sample* ray(Pixel p) const {
        const std::uint32_t c = code(p);
        return c < firstRay ? nullptr : &m_rays[c - firstRay];
    }
    /// Holds a sample that was redrawn from earlier views; the picture has it.
    bool redrawn(Pixel p) const { return code(p) == fromPicture; }

    void setRedrawn(Pixel p) { code(p) = fromPicture; }
    void setBackground(Pixel p) { code(p) = background; }
    /// Marks an open pixel as asked for: not open any more. Either set() or reopen() follows.
    void ask(Pixel p) { code(p) = asked; }
    void reopen(Pixel p) { code(p) = unknown; }
    void set(Pixel p, const Sample& sample) {
        code(p) = firstRay + static_cast<std::uint32_t>(m_rays.size());
        m_rays.push_back(sample);
    }

  private:
    static constexpr std::uint32_t unknown = 0, background = 1, fromPicture = 2, asked = 3, firstRay = 4;

    std::uint32_t code(Pixel p) const { return m_code[index(p)]; }
    std::uint32_t& code(Pixel p) { return m_code[index(p)]; }
    std::size_t index(Pixel p) const {
        return static_cast<std::size_t>(p.row) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(p.column);
    }

    int m_columns = 0, m_rows = 0;
    std::vector<std::uint32_t> m_code;
    std::vector<Sample> m_rays;
};

} // namespace raycast
