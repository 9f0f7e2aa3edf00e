#pragma once
// Lays out what a scene records and sends states and pictures of the flow to a sink.
#include <array>
#include <vector>

#include "coupling/frame.hpp"
#include "coupling/geometry.hpp"
#include "coupling/record.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

template <int D>
class Recorder {
 public:
  // `chemistry_shared`, `flow_shared`: the same in every realisation. Throws base::InputError for a name in run.record
  // that this scene does not have.
  Recorder(const scene::Scene& scene, const rdme::Network& network, const Geometry<D>& geometry,
           std::array<std::size_t, 3> cells, std::vector<double> times, bool chemistry_shared, bool flow_shared);

  const RecordLayout& layout() const { return layout_; }

  // Each at the end of the frame's interval.
  void chemistry(std::size_t time, const rdme::State& state, const Frame<D>& frame, RecordSink& sink) const;
  void volume(std::size_t time, const Frame<D>& frame, RecordSink& sink) const;
  void flow(std::size_t time, const FlowPicture<D>& picture, RecordSink& sink) const;

 private:
  enum class Source { species, volume, position, velocity, density, pressure, particle };
  struct FieldSource {
    Source source;
    int species = -1;
  };
  void add_field(FieldInfo info, FieldSource source);
  void add_chemistry_fields(const rdme::Network& network, bool shared, bool flow_shared);
  void add_flow_fields(bool shared);
  void refuse_unknown_names() const;

  const scene::Scene& scene_;
  const Geometry<D>& geometry_;
  const std::vector<std::uint16_t>& material_;
  RecordLayout layout_;
  std::vector<FieldSource> sources_;
  std::vector<std::string> available_;
};

extern template class Recorder<1>;
extern template class Recorder<2>;
extern template class Recorder<3>;

}  // namespace shmoo::coupling
