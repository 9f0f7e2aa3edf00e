// VTK XML PolyData (VTK File Formats, "XML File Formats"): appended raw blocks, each preceded by its size as UInt64.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

#include "base/error.hpp"
#include "run/export/export.hpp"

namespace shmoo::run {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");

// Collects arrays; the XML part names their offsets into the raw part.
class Appended {
 public:
  template <class T>
  std::string array(const char* type, const std::string& name, std::size_t components, const std::vector<T>& data) {
    const auto offset = raw_.size();
    const std::uint64_t bytes = data.size() * sizeof(T);
    raw_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    raw_.append(reinterpret_cast<const char*>(data.data()), bytes);
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type,
        name, components, offset);
  }
  const std::string& raw() const { return raw_; }

 private:
  std::string raw_;
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

// Vectors get three components, so that ParaView offers glyphs and stream lines.
std::string field_array(Appended& appended, const std::string& name, const Entry& entry,
                        const std::vector<double>& values) {
  const auto components = entry.shape.size() > 1 ? entry.shape[1] : 1;
  if (components == 1 || components == 3) return appended.array("Float64", escaped(name), components, values);
  const auto points = values.size() / components;
  std::vector<double> padded(3 * points, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) padded[i / components * 3 + i % components] = values[i];
  return appended.array("Float64", escaped(name), 3, padded);
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw base::RunError(fmt::format("cannot write {}", path.string()));
}

std::string point_data(const ResultFile& result, std::size_t time, Appended& appended) {
  std::string xml = appended.array("Int32", "material", 1, result.material);
  std::vector<std::int64_t> id(result.material.size());
  for (std::size_t i = 0; i < id.size(); ++i) id[i] = static_cast<std::int64_t>(i);
  xml += appended.array("Int64", "id", 1, id);
  for (const auto& field : result.fields) {
    if (field.name == "position" || field.shape.empty() || field.shape[0] != result.material.size()) continue;
    const auto slice = result.field_slice(field, time);
    xml += field_array(appended, field.name, field, slice.mean);
    if (!slice.deviation.empty()) xml += field_array(appended, field.name + "_deviation", field, slice.deviation);
  }
  return xml;
}

std::string poly_data(const ResultFile& result, std::size_t time) {
  const auto n = result.material.size();
  Appended appended;
  auto positions = result.positions(time);
  std::vector<std::int64_t> connectivity, offsets;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isnan(positions[3 * i])) {  // nothing is there now: a point that no vertex shows
      std::copy(result.lower.begin(), result.lower.end(), positions.begin() + std::ptrdiff_t(3 * i));
      continue;
    }
    connectivity.push_back(static_cast<std::int64_t>(i));
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  xml += fmt::format("<FieldData>\n{}</FieldData>\n", [&] {
    auto array = appended.array("Float64", "TimeValue", 1, std::vector<double>{result.times[time]});
    return array.insert(array.find(" format="), " NumberOfTuples=\"1\"");
  }());
  xml += fmt::format(
      "<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{1}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      n, connectivity.size());
  xml += "<Points>\n" + appended.array("Float64", "position", 3, positions) + "</Points>\n";
  xml += "<Verts>\n" + appended.array("Int64", "connectivity", 1, connectivity) +
         appended.array("Int64", "offsets", 1, offsets) + "</Verts>\n";
  xml += "<PointData>\n" + point_data(result, time, appended) + "</PointData>\n</Piece>\n</PolyData>\n";
  return xml + "<AppendedData encoding=\"raw\">\n_" + appended.raw() + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw base::InputError(fmt::format("cannot make the folder {}: {}", folder.string(),
                                       error ? error.message() : "something else has that name"));
  }
}

std::vector<std::filesystem::path> export_vtk(const ResultFile& result, const std::filesystem::path& folder) {
  make_folder(folder);
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t t = 0; t < result.times.size(); ++t) {
    const auto name = fmt::format("particles_{:05}.vtp", t);
    write_file(folder / name, poly_data(result, t));
    collection += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"0\" file=\"{}\"/>\n", result.times[t], name);
  }
  const auto path = folder / "result.pvd";
  write_file(path, collection + "</Collection>\n</VTKFile>\n");
  return {path};
}

}  // namespace shmoo::run
