#include "run/hdf5.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace shmoo::run::h5 {
namespace {

// The innermost description on the library's error stack, which names the system's reason where there is one.
std::string innermost_reason() {
  std::string reason;
  const auto take = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    if (error->desc != nullptr && *error->desc != '\0') *static_cast<std::string*>(out) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, take, &reason);
  H5Eclear2(H5E_DEFAULT);
  return reason.empty() ? "unknown reason" : reason;
}

void quiet_library() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

// Makes the file's bytes, or a folder's names, survive a crash of the machine.
void force_to_disk(const std::filesystem::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags);
  const bool good = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int reason = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!good) throw base::RunError(fmt::format("cannot force {} to the disk: {}", path.string(), std::strerror(reason)));
}

}  // namespace

std::size_t volume(const Dims& dims) {
  std::size_t product = 1;
  for (const auto d : dims) product *= d;
  return product;
}

void fail(const std::string& doing) { throw base::RunError(fmt::format("cannot {}: {}", doing, innermost_reason())); }

void check(herr_t status, const std::string& doing) {
  if (status < 0) fail(doing);
}

Handle::Handle(hid_t id, const std::string& doing) : id_(id) {
  if (id < 0) fail(doing);
}

Handle open_for_reading(const std::filesystem::path& path) {
  quiet_library();
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), fmt::format("open {}", path.string())};
}

void write_whole_file(const std::filesystem::path& path, const std::function<void(hid_t)>& write) {
  quiet_library();
  auto part = path;
  part += ".part";
  try {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), "prepare a file");
    check(H5Pset_fclose_degree(access, H5F_CLOSE_SEMI), "prepare a file");
    const hid_t file = H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    if (file < 0) fail(fmt::format("create {}", part.string()));
    try {
      write(file);
      check(H5Fflush(file, H5F_SCOPE_GLOBAL), fmt::format("write {}", part.string()));
    } catch (...) {
      H5Fclose(file);
      throw;
    }
    check(H5Fclose(file), fmt::format("write {}", part.string()));
    force_to_disk(part, O_RDONLY);
    std::filesystem::rename(part, path);
    force_to_disk(path.has_parent_path() ? path.parent_path() : std::filesystem::path("."), O_RDONLY | O_DIRECTORY);
  } catch (const std::filesystem::filesystem_error& error) {
    throw base::RunError(error.what());
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

bool exists(hid_t parent, const std::string& path) {
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(parent, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

Strings children(hid_t parent, const std::string& path) {
  Strings names;
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<Strings*>(out)->emplace_back(name);
    return 0;
  };
  const auto group = open(parent, path);
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names), fmt::format("list {}", path));
  return names;
}

Handle make_group(hid_t parent, const std::string& path) {
  const auto doing = fmt::format("create group {}", path);
  const Handle on_the_way(H5Pcreate(H5P_LINK_CREATE), doing);
  check(H5Pset_create_intermediate_group(on_the_way, 1), doing);
  const Handle how(H5Pcreate(H5P_GROUP_CREATE), doing);
  check(H5Pset_obj_track_times(how, false), doing);
  return {H5Gcreate2(parent, path.c_str(), on_the_way, how, H5P_DEFAULT), doing};
}

Handle open(hid_t parent, const std::string& path) {
  return {H5Oopen(parent, path.c_str(), H5P_DEFAULT), fmt::format("open {}", path)};
}

void link(hid_t file, const std::string& existing, const std::string& path) {
  check(H5Lcreate_hard(file, existing.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        fmt::format("link {}", path));
}

Dims dims(hid_t parent, const std::string& path) {
  const auto dataset = open(parent, path);
  const Handle space(H5Dget_space(dataset), fmt::format("read the shape of {}", path));
  Dims out(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, out.data(), nullptr);
  return out;
}

}  // namespace shmoo::run::h5
