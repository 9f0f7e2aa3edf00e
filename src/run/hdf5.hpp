#pragma once
// HDF5 in few words: handles that close themselves, datasets of numbers and text, attributes, and files that appear
// whole or not at all. Every failure is a base::RunError that quotes the library's innermost reason.
#include <hdf5.h>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace shmoo::run::h5 {

using Dims = std::vector<hsize_t>;
using Strings = std::vector<std::string>;

std::size_t volume(const Dims& dims);  // product

// Owns one identifier of any kind.
class Handle {
 public:
  Handle(hid_t id, const std::string& doing);  // throws where id < 0
  ~Handle() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
};

// [[noreturn]] with the library's reason.
[[noreturn]] void fail(const std::string& doing);
void check(herr_t status, const std::string& doing);

Handle open_for_reading(const std::filesystem::path& path);

// Writes PATH.part beside `path`, forces it to the disk and renames it into place, so that `path` at any moment holds a
// complete file, old or new. On failure the old file stays and the .part file is removed.
void write_whole_file(const std::filesystem::path& path, const std::function<void(hid_t)>& write);

// Objects. Times of objects are not tracked, so that equal contents are equal files. `path` may name groups on its way.
bool exists(hid_t parent, const std::string& path);
Strings children(hid_t parent, const std::string& path);  // in order of name
Handle make_group(hid_t parent, const std::string& path);
Handle open(hid_t parent, const std::string& path);                           // a group or dataset
void link(hid_t file, const std::string& existing, const std::string& path);  // a second name of the same object
Dims dims(hid_t parent, const std::string& path);

template <class T>
concept Number = std::same_as<T, double> || std::same_as<T, std::int64_t> || std::same_as<T, std::uint64_t> ||
    std::same_as<T, std::uint32_t> || std::same_as<T, std::int32_t> || std::same_as<T, std::uint8_t>;

// Datasets larger than a few kilobytes are chunked and compressed. Real numbers that were never written are NaN.
template <Number T>
Handle make_dataset(hid_t parent, const std::string& path, const Dims& dims);
template <Number T>
Handle write(hid_t parent, const std::string& path, const Dims& dims, std::span<const T> data);
Handle write_text(hid_t parent, const std::string& path, const std::string& text);
Handle write_texts(hid_t parent, const std::string& path, const Strings& texts);

// A block of consecutive values: data fills the rows [start[0], start[0] + count[0]) x ... of the dataset.
template <Number T>
void write_block(hid_t dataset, const Dims& start, const Dims& count, std::span<const T> data);

template <Number T>
std::vector<T> read(hid_t parent, const std::string& path);
template <Number T>
std::vector<T> read_block(hid_t parent, const std::string& path, const Dims& start, const Dims& count);
std::string read_text(hid_t parent, const std::string& path);
Strings read_texts(hid_t parent, const std::string& path);

// Attributes: text, texts, numbers (a vector; scalars are vectors of one).
void set(hid_t object, const std::string& name, const std::string& text);
void set(hid_t object, const std::string& name, const Strings& texts);
void set(hid_t object, const std::string& name, double value);
void set(hid_t object, const std::string& name, std::int64_t value);
void set(hid_t object, const std::string& name, std::uint64_t value);
void set(hid_t object, const std::string& name, const std::vector<double>& values);
bool has(hid_t object, const std::string& name);
std::string get_text(hid_t object, const std::string& name);
Strings get_texts(hid_t object, const std::string& name);
std::vector<double> get_numbers(hid_t object, const std::string& name);
double get_number(hid_t object, const std::string& name);
std::uint64_t get_whole(hid_t object, const std::string& name);

}  // namespace shmoo::run::h5
