// The schema of shapes.
#include "scene/forms.hpp"
#include "scene/schema.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

Key center_key() { return {"center", {position()}, true, "", "its centre"}; }

std::vector<Key> ball_keys() {
  return {center_key(),
          {"diameter", {quantity(dimensions::length, positive)}, false, "", "its diameter, or"},
          {"radius", {quantity(dimensions::length, positive)}, false, "", "its radius"}};
}

std::vector<Key> shell_keys() {
  const Form pair = list({quantity(dimensions::length, not_negative)}, 2, 2);
  return {center_key(),
          {"diameter", {pair}, false, "", "inner and outer diameter, or"},
          {"radius", {pair}, false, "", "inner and outer radius"}};
}

std::vector<Key> half_space_keys() {
  return {{"point", {position()}, true, "", "a point of its surface"},
          {"normal", {per_axis({number(any)})}, true, "", "direction that points out of it"}};
}

std::vector<Key> corner_keys(std::string_view meaning) {
  return {{"corners", {list({list({quantity(dimensions::length, any)}, 2, 2)}, 3, 100000)}, true, "", meaning}};
}

}  // namespace

const std::vector<ShapeTable>& shape_tables() {
  static const std::vector<ShapeTable> shapes{
      {"box",
       {1, 2, 3},
       {{"lower", {position()}, true, "", "lower corner"}, {"upper", {position()}, true, "", "upper corner"}}},
      {"disk", {2}, ball_keys()},
      {"ball", {1, 2, 3}, ball_keys()},
      {"ring", {2}, shell_keys()},
      {"shell", {1, 2, 3}, shell_keys()},
      {"half_plane", {2}, half_space_keys()},
      {"half_space", {1, 2, 3}, half_space_keys()},
      {"polygon", {2}, corner_keys("corners in order; the last is joined to the first")},
      {"revolved",
       {3},
       corner_keys("corners of the outline in order, each its place along the x axis and its distance from that; the "
                   "last is joined to the first. The outline is turned about the x axis, y = z = 0: lay the domain "
                   "round it by its `origin`")},
      {"union", {1, 2, 3}, {{"of", {list({subtable("part")}, 1)}, true, "", "shapes that together make it"}}},
      {"difference",
       {1, 2, 3},
       {{"from", {subtable("part")}, true, "", "the shape that is cut"},
        {"without", {subtable("part")}, true, "", "the shape that is cut away"}}}};
  return shapes;
}

const Key& shape_key() {
  static const Key key{"shape",
                       {choice({"box", "disk", "ball", "ring", "shell", "half_plane", "half_space", "polygon",
                                "revolved", "union", "difference"})},
                       true,
                       "",
                       "the kind of shape; its own keys follow"};
  return key;
}

}  // namespace shmoo::scene
