#pragma once

#include <string>

namespace handhold {

/// The whole file; throws InputError if it cannot be read or is a folder.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// "grab" of "recordings/grab.json.lz".
[[nodiscard]] std::string stem_of(const std::string& path);

}  // namespace handhold
