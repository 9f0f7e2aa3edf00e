// Datasets and attributes.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "run/hdf5.hpp"

namespace shmoo::run::h5 {
namespace {

template <class T>
hid_t type_of() {
  if constexpr (std::same_as<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::same_as<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::same_as<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  if constexpr (std::same_as<T, std::uint32_t>) return H5T_NATIVE_UINT32;
  if constexpr (std::same_as<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::same_as<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), "make a text type");
  check(H5Tset_size(type, H5T_VARIABLE), "make a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  return type;
}

Handle space_of(const Dims& dims) {
  if (dims.empty()) return {H5Screate(H5S_SCALAR), "make a scalar"};
  return {H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr), "make a shape"};
}

// Chunks of at most 2^17 values, cut along the leading dimensions.
Dims chunk_of(const Dims& dims) {
  Dims chunk = dims;
  for (std::size_t a = 0; a < chunk.size() && volume(chunk) > (1u << 17); ++a) {
    const auto rest = volume(chunk) / chunk[a];
    chunk[a] = std::max<hsize_t>(1, (1u << 17) / std::max<std::size_t>(1, rest));
  }
  return chunk;
}

Handle create(hid_t parent, const std::string& path, hid_t type, const Dims& dims, bool compress) {
  const auto doing = fmt::format("create {}", path);
  const Handle on_the_way(H5Pcreate(H5P_LINK_CREATE), doing);
  check(H5Pset_create_intermediate_group(on_the_way, 1), doing);
  const Handle how(H5Pcreate(H5P_DATASET_CREATE), doing);
  check(H5Pset_obj_track_times(how, false), doing);
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (type == H5T_NATIVE_DOUBLE) check(H5Pset_fill_value(how, type, &nothing), doing);
  if (compress && volume(dims) > 512) {
    const auto chunk = chunk_of(dims);
    check(H5Pset_chunk(how, static_cast<int>(chunk.size()), chunk.data()), doing);
    check(H5Pset_shuffle(how), doing);
    check(H5Pset_deflate(how, 1), doing);
  }
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS), doing);
  check(H5Pset_chunk_cache(access, 521, 16u << 20, 1.0), doing);  // slices of several datasets are written in turn
  const auto space = space_of(dims);
  return {H5Dcreate2(parent, path.c_str(), type, space, on_the_way, how, access), doing};
}

std::vector<const char*> pointers(const Strings& texts) {
  std::vector<const char*> out;
  for (const auto& text : texts) out.push_back(text.c_str());
  return out;
}

Strings take_texts(hid_t type, hid_t space, const std::function<herr_t(char**)>& read, const std::string& doing) {
  std::vector<char*> raw(static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space))));
  if (raw.empty()) return {};
  check(read(raw.data()), doing);
  Strings out;
  for (const auto* text : raw) out.emplace_back(text == nullptr ? "" : text);
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data());
  return out;
}

template <class Value>
void set_numbers(hid_t object, const std::string& name, const Dims& dims, const Value* values) {
  const auto doing = fmt::format("write attribute {}", name);
  const auto space = space_of(dims);
  const Handle attribute(H5Acreate2(object, name.c_str(), type_of<Value>(), space, H5P_DEFAULT, H5P_DEFAULT), doing);
  check(H5Awrite(attribute, type_of<Value>(), values), doing);
}

void set_texts(hid_t object, const std::string& name, const Dims& dims, const Strings& texts) {
  const auto doing = fmt::format("write attribute {}", name);
  const auto space = space_of(dims);
  const auto type = text_type();
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), doing);
  if (!texts.empty()) check(H5Awrite(attribute, type, pointers(texts).data()), doing);
}

Handle open_attribute(hid_t object, const std::string& name) {
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), fmt::format("read attribute {}", name)};
}

}  // namespace

template <Number T>
Handle make_dataset(hid_t parent, const std::string& path, const Dims& dims) {
  return create(parent, path, type_of<T>(), dims, true);
}

template <Number T>
Handle write(hid_t parent, const std::string& path, const Dims& dims, std::span<const T> data) {
  if (data.size() != volume(dims))
    throw std::logic_error(fmt::format("{}: {} values for a shape of {}", path, data.size(), volume(dims)));
  auto dataset = make_dataset<T>(parent, path, dims);
  if (!data.empty())
    check(H5Dwrite(dataset, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()), fmt::format("write {}", path));
  return dataset;
}

Handle write_text(hid_t parent, const std::string& path, const std::string& text) {
  const auto type = text_type();
  auto dataset = create(parent, path, type, {}, false);
  const char* pointer = text.c_str();
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &pointer), fmt::format("write {}", path));
  return dataset;
}

Handle write_texts(hid_t parent, const std::string& path, const Strings& texts) {
  const auto type = text_type();
  auto dataset = create(parent, path, type, {texts.size()}, false);
  if (!texts.empty())
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers(texts).data()),
          fmt::format("write {}", path));
  return dataset;
}

template <Number T>
void write_block(hid_t dataset, const Dims& start, const Dims& count, std::span<const T> data) {
  if (data.empty()) return;
  const Handle in_file(H5Dget_space(dataset), "write a block");
  check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), "write a block");
  const auto in_memory = space_of(count);
  check(H5Dwrite(dataset, type_of<T>(), in_memory, in_file, H5P_DEFAULT, data.data()), "write a block");
}

template <Number T>
std::vector<T> read(hid_t parent, const std::string& path) {
  std::vector<T> data(volume(dims(parent, path)));
  const auto dataset = open(parent, path);
  if (!data.empty())
    check(H5Dread(dataset, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()), fmt::format("read {}", path));
  return data;
}

template <Number T>
std::vector<T> read_block(hid_t parent, const std::string& path, const Dims& start, const Dims& count) {
  const auto doing = fmt::format("read a block of {}", path);
  std::vector<T> data(volume(count));
  if (data.empty()) return data;
  const auto dataset = open(parent, path);
  const Handle in_file(H5Dget_space(dataset), doing);
  check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), doing);
  const auto in_memory = space_of(count);
  check(H5Dread(dataset, type_of<T>(), in_memory, in_file, H5P_DEFAULT, data.data()), doing);
  return data;
}

Strings read_texts(hid_t parent, const std::string& path) {
  const auto dataset = open(parent, path);
  const Handle space(H5Dget_space(dataset), fmt::format("read {}", path));
  const auto type = text_type();
  return take_texts(
      type, space, [&](char** raw) { return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw); },
      fmt::format("read {}", path));
}

std::string read_text(hid_t parent, const std::string& path) { return read_texts(parent, path).at(0); }

void set(hid_t object, const std::string& name, const std::string& text) { set_texts(object, name, {}, {text}); }
void set(hid_t object, const std::string& name, const Strings& texts) {
  set_texts(object, name, {texts.size()}, texts);
}
void set(hid_t object, const std::string& name, double value) { set_numbers(object, name, {}, &value); }
void set(hid_t object, const std::string& name, std::int64_t value) { set_numbers(object, name, {}, &value); }
void set(hid_t object, const std::string& name, std::uint64_t value) { set_numbers(object, name, {}, &value); }
void set(hid_t object, const std::string& name, const std::vector<double>& values) {
  set_numbers(object, name, {values.size()}, values.data());
}

bool has(hid_t object, const std::string& name) { return H5Aexists(object, name.c_str()) > 0; }

Strings get_texts(hid_t object, const std::string& name) {
  const auto attribute = open_attribute(object, name);
  const Handle space(H5Aget_space(attribute), fmt::format("read attribute {}", name));
  const auto type = text_type();
  return take_texts(
      type, space, [&](char** raw) { return H5Aread(attribute, type, raw); }, fmt::format("read attribute {}", name));
}

std::string get_text(hid_t object, const std::string& name) { return get_texts(object, name).at(0); }

std::vector<double> get_numbers(hid_t object, const std::string& name) {
  const auto attribute = open_attribute(object, name);
  const Handle space(H5Aget_space(attribute), fmt::format("read attribute {}", name));
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  if (!values.empty())
    check(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()), fmt::format("read attribute {}", name));
  return values;
}

double get_number(hid_t object, const std::string& name) { return get_numbers(object, name).at(0); }

std::uint64_t get_whole(hid_t object, const std::string& name) {
  std::uint64_t value = 0;
  check(H5Aread(open_attribute(object, name), H5T_NATIVE_UINT64, &value), fmt::format("read attribute {}", name));
  return value;
}

#define SHMOO_NUMBER(T)                                                                 \
  template Handle make_dataset<T>(hid_t, const std::string&, const Dims&);              \
  template Handle write<T>(hid_t, const std::string&, const Dims&, std::span<const T>); \
  template void write_block<T>(hid_t, const Dims&, const Dims&, std::span<const T>);    \
  template std::vector<T> read<T>(hid_t, const std::string&);                           \
  template std::vector<T> read_block<T>(hid_t, const std::string&, const Dims&, const Dims&);
SHMOO_NUMBER(double)
SHMOO_NUMBER(std::int64_t)
SHMOO_NUMBER(std::uint64_t)
SHMOO_NUMBER(std::uint32_t)
SHMOO_NUMBER(std::int32_t)
SHMOO_NUMBER(std::uint8_t)
#undef SHMOO_NUMBER

}  // namespace shmoo::run::h5
