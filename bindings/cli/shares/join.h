#pragma once

#include <string>

#include "model/library.h"

namespace halfspace::cli {

/// The whole world of the shares in a directory. @throws LibraryError, std::runtime_error
World joined(const Context& context, const std::string& directory);

}  // namespace halfspace::cli
