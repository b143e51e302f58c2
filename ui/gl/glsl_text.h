// Pieces of shader source that carry numbers of ours, written without the locale: a decimal comma would be a syntax
// error that the driver alone hears of.
#pragma once

#include "core/render/shared_constant.h"

#include <span>
#include <string>

namespace render {

/// A float literal that reads back to the same bits, as "0.07" or "3.0".
std::string glslFloat(float value);
/// "const float NAME = VALUE;"
std::string glslConstant(const SharedConstant& constant);
std::string glslConstants(std::span<const SharedConstant> constants);
std::string glslConstant(const char* name, const float (&colour)[3]);

} // namespace render
