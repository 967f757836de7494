#pragma once

#include <string>

namespace halfspace::viewer {

/// The bytes as a zlib stream, which DecompressionStream("deflate") of a browser reads.
std::string deflated(const std::string& bytes);

/// The bytes as base64 text (RFC 4648).
std::string base64(const std::string& bytes);

/// The bytes as text of base 85: the digits of RFC 1924, with `,./` for the ones that HTML and JSON would
/// have to escape. A last group of n bytes has n + 1 digits.
std::string base85(const std::string& bytes);

/// A text as a JSON string, with its quotes.
std::string json(const std::string& text);

/// A number as JSON; null if it is not finite.
std::string json(double value);

}  // namespace halfspace::viewer
