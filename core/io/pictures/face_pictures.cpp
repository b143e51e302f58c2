#include "core/io/pictures/face_pictures.h"

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/pictures/colour_image.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace io {

namespace fs = std::filesystem;

constexpr std::size_t mostPixels = std::size_t(1) << 28;

fs::path besideModel(const fs::path& folder, std::string_view name) {
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    fs::path wanted(text);
    if (wanted.is_absolute() || (text.size() > 1 && text[1] == ':'))
        wanted = wanted.filename();
    wanted = wanted.lexically_normal();
    if (wanted.empty() || wanted == "." || *wanted.begin() == "..")
        return {};
    return folder / wanted;
}

/// Null where it cannot be read; then `trouble` has why.
static std::shared_ptr<const mesh::Picture> pictureOf(const PictureName& name, const fs::path& folder,
                                                      std::size_t& left, std::vector<std::string>& trouble) {
    const auto leaveOut = [&](const std::string& why) {
        trouble.push_back("The picture " + inQuotes(name.file) + " of faces was left out: " + why);
        return nullptr;
    };
    const bool inside = name.inside;
    if (inside && name.bytes.empty())
        return leaveOut("it is not in the file");
    if (left == 0)
        return leaveOut("all pictures together have too many pixels");
    const fs::path path = besideModel(folder, name.file);
    std::error_code none;
    if (!inside && path.empty())
        return leaveOut("it is outside of the model's folder");
    if (!inside && !fs::is_regular_file(path, none))
        return leaveOut("there is no such file beside the model");
    try {
        auto out = std::make_shared<mesh::Picture>(inside ? readPicture(name.bytes, name.file) : readPicture(path));
        if (out->pixels.empty() || out->pixels.size() > left) {
            left = 0; // or each of the others would be decoded for nothing
            return leaveOut("all pictures together have too many pixels");
        }
        left -= out->pixels.size();
        out->clamped = name.clamped;
        return out;
    } catch (const base::Error& error) {
        return leaveOut(error.message());
    }
}

void readPictures(FileModel& model, const fs::path& folder, const std::vector<PictureName>& names,
                  const base::Progress& progress) {
    mesh::Polygons& faces = model.polygons;
    faces.pictures.assign(names.size(), nullptr);
    std::vector<bool> used(names.size());
    for (const std::uint32_t number : faces.pictureOf)
        if (number < names.size())
            used[number] = true;
    // those inside are told apart by where they are
    std::map<std::tuple<std::string, const char*, std::size_t, bool>, std::shared_ptr<const mesh::Picture>> read;
    std::vector<std::string> trouble;
    std::size_t left = mostPixels;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!used[i] || names[i].file.empty())
            continue;
        progress.step(0.45, "Reading");
        const PictureName& name = names[i];
        const auto [at, fresh] = read.try_emplace(
            {name.inside ? std::string() : name.file, name.bytes.data(), name.bytes.size(), name.clamped});
        if (fresh)
            at->second = pictureOf(names[i], folder, left, trouble);
        faces.pictures[i] = at->second;
    }
    if (!trouble.empty()) {
        const std::size_t more = trouble.size() - 1;
        model.messages.push_back(trouble.front() + (more > 0 ? "; and " + std::to_string(more) + " more." : "."));
    }
    if (std::all_of(faces.pictures.begin(), faces.pictures.end(), [](const auto& p) { return !p; })) {
        faces.pictures.clear();
        faces.pictureOf.clear();
        faces.places.clear();
    }
}

} // namespace io
