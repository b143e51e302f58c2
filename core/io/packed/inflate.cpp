#include "core/io/packed/inflate.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>
#include <zlib.h>

namespace io {

namespace {

/// Frees what zlib holds, whichever way the work ends.
class Stream {
  public:
    explicit Stream(Wrapping wrapping) {
        constexpr int largestWindow = 15, gzipOnly = 16;
        if (inflateInit2(&m_stream, wrapping == Wrapping::Gzip ? largestWindow + gzipOnly : -largestWindow) != Z_OK)
            throw std::bad_alloc();
    }
    ~Stream() { inflateEnd(&m_stream); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    z_stream& operator*() { return m_stream; }

  private:
    z_stream m_stream{};
};

} // namespace

Inflated inflate(std::string_view packed, Wrapping wrapping, std::size_t most, const base::Progress& progress,
                 const std::function<void(std::string_view)>& sink) {
    constexpr std::size_t piece = std::size_t(1) << 18;
    Stream stream(wrapping);
    z_stream& z = *stream;
    std::vector<unsigned char> out(piece);
    Inflated result;
    while (true) {
        progress.step(packed.empty() ? 0 : static_cast<double>(result.used) / static_cast<double>(packed.size()),
                      "Unpacking");
        const std::size_t offered = std::min<std::size_t>(packed.size() - result.used, std::numeric_limits<int>::max());
        z.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(packed.data() + result.used));
        z.avail_in = static_cast<uInt>(offered);
        z.next_out = out.data();
        z.avail_out = static_cast<uInt>(out.size());
        const int code = ::inflate(&z, Z_NO_FLUSH);
        const std::size_t made = out.size() - z.avail_out, used = offered - z.avail_in;
        result.used += used;
        if (made > most - result.made) {
            result.end = InflateEnd::TooLong;
            return result;
        }
        result.made += made;
        if (made > 0)
            sink({reinterpret_cast<const char*>(out.data()), made});
        if (code == Z_STREAM_END)
            result.end = InflateEnd::Whole;
        else if (code != Z_OK && code != Z_BUF_ERROR)
            result.end = InflateEnd::Damaged;
        if (code == Z_STREAM_END || result.end == InflateEnd::Damaged || (made == 0 && used == 0))
            return result; // without progress the bytes are at their end
    }
}

} // namespace io
