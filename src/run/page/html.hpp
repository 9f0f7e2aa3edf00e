#pragma once
// The few words of HTML that a page of results needs.
#include <filesystem>
#include <string>
#include <vector>

namespace shmoo::run::html {

std::string escaped(const std::string& text);

using Row = std::vector<std::string>;
// Cells are text and are escaped; those after the first are set to the right where `numbers`.
std::string table(const Row& head, const std::vector<Row>& rows, bool numbers);

// A PNG file within the page itself. base::RunError where it cannot be read.
std::string image(const std::filesystem::path& png, const std::string& caption);

// A whole document that needs no other file.
std::string document(const std::string& title, const std::string& body);

}  // namespace shmoo::run::html
