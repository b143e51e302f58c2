// The readers and writers behind the rows of the format table; see formats.h for what they promise.
#pragma once

#include "core/io/file_bytes.h"
#include "core/io/formats.h"

namespace io {

using std::filesystem::path;

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
