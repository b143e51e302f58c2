// The readers and writers behind the rows of the format table; see formats.h for what they promise.
#pragma once

#include "core/io/file_bytes.h"
#include "core/io/formats.h"

namespace io {

using std::filesystem::path;

/// How a file of text is read where it does not tell by itself, or not all of it.
struct TextReading {
    std::vector<std::string> columns; ///< a name for each, "-" for those that are left out; empty: the file tells
    bool head = false;                ///< only its first lines: fewer points than it promises are no fault
};
struct TextRead {
    FileModel model;
    std::vector<std::string> columns; ///< what each was taken for; "-": left out
    bool sure = true;                 ///< what tells x, y and z is more than that they come first below other names
    std::vector<std::vector<std::string>> rows; ///< of a head, the first ones as they stand there
};
/// Whether it is read as points in text.
bool isText(const FileBytes& file);
TextRead readTextAs(const FileBytes& file, const base::Progress& progress, const TextReading& how);

FileModel readPly(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readText(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readObj(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readOff(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readStl(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readPcd(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readLas(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readPtx(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readGltf(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel read3mf(const FileBytes& file, const base::Progress& progress, const path& folder);
FileModel readE57(const FileBytes& file, const base::Progress& progress, const path& folder);

void writePly(const path& file, const FileModel& model, const base::Progress& progress);
void writeText(const path& file, const FileModel& model, const base::Progress& progress);
void writeObj(const path& file, const FileModel& model, const base::Progress& progress);
void writePcd(const path& file, const FileModel& model, const base::Progress& progress);
void writeLas(const path& file, const FileModel& model, const base::Progress& progress);
void writeGltf(const path& file, const FileModel& model, const base::Progress& progress);
void writeE57(const path& file, const FileModel& model, const base::Progress& progress);
void writeLaz(const path& file, const FileModel& model, const base::Progress& progress);

} // namespace io
