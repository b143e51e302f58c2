// What the columns of a text file are where no name says x, y and z: numbers and other names tell (io/README 2.4).
#pragma once

#include "core/surfel/attributes.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace io {

/// What all values of one column have in common.
struct ColumnFacts {
    bool integers = true; ///< every value is a whole number
    double least = 0, most = 0;
    bool isByte() const { return integers && least >= 0 && most <= 255; }
    bool isShare() const { return least >= 0 && most <= 1; }
};

/// Facts about each of `columns` columns of `n` rows of doubles. Values that are not finite are passed over.
std::vector<ColumnFacts> columnFacts(const double* values, std::size_t n, std::size_t columns);

/// Whole numbers are int or uint; reals are float; both are double where that would lose units or fractions (large
/// counters, GPS times).
surfel::ScalarType typeOf(const ColumnFacts& facts);

/// The largest value of columns that hold whole numbers of 0..255, not of 0 and 1 alone; else 0.
int mostLikeColours(std::span<const ColumnFacts> facts);

/// Names for columns: x y z first; then, from the left, three columns are a normal where the rows have unit length,
/// colours where they are whole numbers of 0..255 or reals of 0..1; any other is "intensity" (the first, in files of 4
/// or 7 columns) or "column_N", counted from 1. Of four columns after x y z the last three are tried first, because
/// Leica writes intensity before the colours. Where the first column counts the rows, it is "number", and all of this
/// holds of those behind it. REQUIRES: facts.size() >= 3.
std::vector<std::string> guessNames(const double* values, std::size_t n, std::span<const ColumnFacts> facts);

/// Whether the first of at least four columns counts the rows: whole numbers in steps of one, or rising by any steps
/// where there are many rows (some were taken out). Points whose x does that are a curve of one point for each unit.
bool firstCounts(const double* values, std::size_t n, std::span<const ColumnFacts> facts);

/// Which of the columns are x, y and z by names that surveyors and other programs use: East, North, Height; X [m];
/// Points:0. In any case of letters, units in brackets aside. Nothing unless all three are there.
std::optional<std::array<std::size_t, 3>> coordinatesAmong(std::span<const std::string> names);

} // namespace io
