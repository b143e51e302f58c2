#include "core/render/depth_exr.h"

#include "core/base/error.h"
#include "core/io/safe_file.h"

#include <cstring>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

namespace render {

namespace {

/// A file in memory, as the library writes it.
class Bytes : public Imf::OStream {
  public:
    Bytes() : Imf::OStream("depth") {}
    void write(const char* data, int count) override {
        const auto n = static_cast<std::size_t>(count);
        if (m_at + n > m_bytes.size())
            m_bytes.resize(m_at + n);
        std::memcpy(m_bytes.data() + m_at, data, n);
        m_at += n;
    }
    std::uint64_t tellp() override { return m_at; }
    void seekp(std::uint64_t at) override { m_at = at; }
    const std::string& all() const { return m_bytes; }

  private:
    std::string m_bytes;
    std::size_t m_at = 0;
};

} // namespace

void saveExr(const Image& image, const std::filesystem::path& path) {
    Bytes bytes;
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        Imf::FrameBuffer buffer;
        // the library takes memory to be changed, and only reads it
        char* depth = const_cast<char*>(reinterpret_cast<const char*>(image.depth.data()));
        buffer.insert("Z", Imf::Slice(Imf::FLOAT, depth, sizeof(float), sizeof(float) * std::size_t(image.width)));
        Imf::OutputFile file(bytes, header, 1);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    } catch (const std::exception& error) {
        throw base::Error(std::string("the depth could not be encoded as EXR: ") + error.what(), path.string(),
                          "choose a smaller size");
    }
    io::writeFile(path, bytes.all());
}

} // namespace render
