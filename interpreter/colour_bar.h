// The legend of a coloured shape in a scene: a strip beside it on which the attribute runs from its least to its greatest value.
#pragma once

#include <filesystem>

#include "files/geometry_file.h"

namespace udcp {

/// The strip, to the right of the shape and as high as it is, least value at the bottom. Throws Error{input, "E_ATTRIBUTE"}.
Surface<double> colour_bar(const Surface<double>& surface, const std::string& attribute);
/// The shape with its strip in a glTF or GLB file; the node of the strip is named "legend: gaussian from -0.25 to 2.5".
void save_with_legend(const Surface<double>& surface, const std::filesystem::path& file, const SaveOptions& options);

}  // namespace udcp
