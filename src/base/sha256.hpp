#pragma once
// SHA-256 (FIPS 180-4), to tell whether two model texts are the same.
#include <string>
#include <string_view>

namespace shmoo::base {

// The 64 lower-case hexadecimal digits of the text's SHA-256.
std::string sha256(std::string_view text);

}  // namespace shmoo::base
