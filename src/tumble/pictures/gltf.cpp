/// \file
/// \brief Nodes, materials and animations of a glTF file.
#include "tumble/pictures/gltf.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/pictures/gltf_buffer.hpp"
#include "tumble/pictures/gltf_tracks.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/world_picture.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace tumble {
namespace {

using Use = GltfBuffer::Use;

constexpr std::uint32_t kGround = 0xe4e1da;
constexpr double kGroundShare = 1.5;   // its half edge over that of the bodies' extent
constexpr double kGroundThick = 0.01;  // over its edge

// Writes the first numbers of a list.
void write_list(Json& json, std::string_view name, const std::vector<float>& numbers,
                std::size_t count) {
  json.key(name).begin_list();
  for (std::size_t k = 0; k < count; ++k) json.item(static_cast<double>(numbers[k]));
  json.end_list();
}

// From sRGB to linear light, which glTF requires.
double light_of(std::uint32_t colour, unsigned shift) {
  const double share = static_cast<double>(colour >> shift & 0xffU) / 255.0;
  return share <= 0.04045 ? share / 12.92 : elementary::pow((share + 0.055) / 1.055, 2.4);
}

class Writer {
 public:
  Writer(const RecordedRun& run, std::span<const RecordedFrame> frames, double speed);
  std::string text();

 private:
  struct Node {
    std::string name;
    std::uint32_t colour = 0;
    std::vector<float> scale, position, orientation;
  };
  struct Channel {
    std::int64_t node = 0;
    std::string_view path;
    std::int64_t times = 0, values = 0;
    std::string_view way = "LINEAR";
  };

  void add_box();
  void add_body(const SceneBox& box, std::uint32_t colour, const GltfTrack& track);
  void add_visibility(const std::vector<float>& scale, const std::vector<char>& there);
  void add_ground(const std::vector<std::optional<GltfTrack>>& tracks);
  void write_meshes(Json& json) const;
  void write_materials(Json& json) const;
  void write_nodes(Json& json) const;
  void write_animation(Json& json) const;

  std::string title_;
  GltfBuffer buffer_;
  std::int64_t points_ = 0, normals_ = 0, triangles_ = 0, times_ = 0;  // accessors
  std::vector<float> seconds_;                                         // of keys
  std::vector<Node> nodes_;
  std::vector<Channel> channels_;
  std::map<std::uint32_t, std::pair<std::int64_t, std::string>> materials_;  // by colour
};

Writer::Writer(const RecordedRun& run, std::span<const RecordedFrame> frames, double speed)
    : title_(run.scene.title) {
  add_box();
  for (const RecordedFrame& frame : frames)
    seconds_.push_back(static_cast<float>((frame.time - frames.front().time) / speed));
  times_ = buffer_.add(Use::keys, 1, seconds_, true);
  World world;  // for the colours: all bodies of the run
  for (const SceneBox& box : run.scene.boxes)
    world.add(properties_of(box), make_state(properties_of(box), box.position_w), box.name);
  const std::vector<PictureBox> pictures = picture_boxes(world);
  const std::vector<std::optional<GltfTrack>> tracks = gltf_tracks(run, frames);
  for (std::size_t k = 0; k < tracks.size(); ++k)
    if (tracks[k]) add_body(run.scene.boxes[k], pictures[k].colour, *tracks[k]);
  require::that(!nodes_.empty(), "no box is in these frames: choose others");
  if (run.scene.ground) add_ground(tracks);
}

// Four corners for each face, so that each has its own normal.
void Writer::add_box() {
  std::vector<float> points, normals;
  std::vector<std::uint16_t> triangles;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double out = side % 2 == 0 ? -1.0 : 1.0;
    const auto first = static_cast<std::uint16_t>(4 * side);
    for (const auto& [u, v] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      Vec3 corner = 0.5 * out * Vec3::Unit(axis);
      corner[(axis + 1) % 3] = 0.5 * u * out;  // counter-clockwise from outside
      corner[(axis + 2) % 3] = 0.5 * v;
      add_numbers(corner, points);
      add_numbers(out * Vec3::Unit(axis), normals);
    }
    for (const int corner : {0, 1, 2, 0, 2, 3})
      triangles.push_back(static_cast<std::uint16_t>(first + corner));
  }
  points_ = buffer_.add(Use::vertices, 3, points, true);
  normals_ = buffer_.add(Use::vertices, 3, normals, false);
  triangles_ = buffer_.add(triangles);
}

void Writer::add_body(const SceneBox& box, std::uint32_t colour, const GltfTrack& track) {
  const auto number = static_cast<std::int64_t>(nodes_.size());
  Node node{box.name, colour, {}, {}, {}};
  add_numbers(box.size, node.scale);
  node.position.assign(track.positions.begin(), track.positions.begin() + 3);
  node.orientation.assign(track.orientations.begin(), track.orientations.begin() + 4);
  materials_.try_emplace(colour, static_cast<std::int64_t>(materials_.size()),
                         (box.fixed ? "fixed " : "movable ") + colour_text(colour));
  if (track.moves) {
    channels_.push_back(
        {number, "translation", times_, buffer_.add(Use::keys, 3, track.positions, false)});
    channels_.push_back(
        {number, "rotation", times_, buffer_.add(Use::keys, 4, track.orientations, false)});
  }
  const std::vector<float> scale = node.scale;
  if (track.there.front() == 0) node.scale.assign(3, 0.0F);
  nodes_.push_back(std::move(node));
  if (std::count(track.there.begin(), track.there.end(), 0) > 0) add_visibility(scale, track.there);
}

// Adds a key wherever a body appears or disappears.
void Writer::add_visibility(const std::vector<float>& scale, const std::vector<char>& there) {
  std::vector<float> times, scales;
  for (std::size_t k = 0; k < there.size(); ++k) {
    if (k > 0 && there[k] == there[k - 1]) continue;
    times.push_back(seconds_[k]);
    for (const float edge : scale) scales.push_back(there[k] != 0 ? edge : 0.0F);
  }
  channels_.push_back({static_cast<std::int64_t>(nodes_.size()) - 1, "scale",
                       buffer_.add(Use::keys, 1, times, true),
                       buffer_.add(Use::keys, 3, scales, false), "STEP"});
}

void Writer::add_ground(const std::vector<std::optional<GltfTrack>>& tracks) {
  std::array<float, 2> low{}, high{};  // x and z
  bool first = true;
  for (const std::optional<GltfTrack>& track : tracks) {
    for (std::size_t k = 0; track && k < track->positions.size(); k += 3) {
      for (const std::size_t axis : {0U, 1U}) {
        const float value = track->positions[k + 2 * axis];
        low[axis] = first ? value : std::min(low[axis], value);
        high[axis] = first ? value : std::max(high[axis], value);
      }
      first = false;
    }
  }
  double largest = 0.0;  // [m] of the bodies' scales
  for (const Node& node : nodes_)
    for (const float edge : node.scale) largest = std::max(largest, static_cast<double>(edge));
  const double edge =
      2.0 * kGroundShare *
      (largest + 0.5 * static_cast<double>(std::max(high[0] - low[0], high[1] - low[1])));
  Node node{"ground", kGround, {}, {}, {0.0F, 0.0F, 0.0F, 1.0F}};
  add_numbers(Vec3(edge, kGroundThick * edge, edge), node.scale);
  add_numbers(Vec3(0.5 * static_cast<double>(low[0] + high[0]), -0.5 * kGroundThick * edge,
                   0.5 * static_cast<double>(low[1] + high[1])),
              node.position);
  materials_.try_emplace(kGround, static_cast<std::int64_t>(materials_.size()), "ground");
  nodes_.push_back(std::move(node));
}

void Writer::write_nodes(Json& json) const {
  json.key("nodes").begin_list();
  for (const Node& node : nodes_) {
    json.begin().field("name", std::string_view(node.name));
    json.field("mesh", materials_.at(node.colour).first);
    write_list(json, "translation", node.position, 3);
    write_list(json, "rotation", node.orientation, 4);
    write_list(json, "scale", node.scale, 3);
    json.end();
  }
  json.end_list();
}

// The same box in each colour: mesh and material have the same index.
void Writer::write_meshes(Json& json) const {
  json.key("meshes").begin_list();
  for (std::size_t k = 0; k < materials_.size(); ++k) {
    json.begin().field("name", std::string_view("box")).key("primitives").begin_list().begin();
    json.key("attributes").begin().field("POSITION", points_).field("NORMAL", normals_).end();
    json.field("indices", triangles_).field("material", static_cast<std::int64_t>(k));
    json.end().end_list().end();
  }
  json.end_list();
}

void Writer::write_materials(Json& json) const {
  std::vector<std::pair<std::uint32_t, std::string>> ordered(materials_.size());
  for (const auto& [colour, material] : materials_)
    ordered[static_cast<std::size_t>(material.first)] = {colour, material.second};
  json.key("materials").begin_list();
  for (const auto& [colour, name] : ordered) {
    json.begin().field("name", std::string_view(name)).key("pbrMetallicRoughness").begin();
    json.key("baseColorFactor").begin_list();
    for (const unsigned shift : {16U, 8U, 0U}) json.item(light_of(colour, shift));
    json.item(1.0).end_list();
    json.field("metallicFactor", 0.0).field("roughnessFactor", 0.8).end().end();
  }
  json.end_list();
}

void Writer::write_animation(Json& json) const {
  if (channels_.empty()) return;
  json.key("animations").begin_list().begin().field("name", std::string_view("run"));
  json.key("channels").begin_list();
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    json.begin().field("sampler", static_cast<std::int64_t>(k)).key("target").begin();
    json.field("node", channels_[k].node).field("path", channels_[k].path).end().end();
  }
  json.end_list().key("samplers").begin_list();
  for (const Channel& channel : channels_) {
    json.begin().field("input", channel.times).field("output", channel.values);
    json.field("interpolation", channel.way).end();
  }
  json.end_list().end().end_list();
}

std::string Writer::text() {
  Json json;
  json.begin().key("asset").begin().field("version", std::string_view("2.0"));
  json.field("generator", std::string_view("Tumble")).end();
  json.field("scene", std::int64_t{0}).key("scenes").begin_list().begin();
  json.field("name", std::string_view(title_)).key("nodes").begin_list();
  for (std::size_t k = 0; k < nodes_.size(); ++k) json.item(static_cast<double>(k));
  json.end_list().end().end_list();
  write_nodes(json);
  write_meshes(json);
  write_materials(json);
  write_animation(json);
  buffer_.write(json);
  return json.end().text();
}

}  // namespace

std::string to_gltf(const RecordedRun& run, std::span<const RecordedFrame> frames, double speed) {
  require::that(!frames.empty(), "no frames: give at least one");
  require::positive(speed, "speed");
  for (std::size_t k = 1; k < frames.size(); ++k)
    require::that(frames[k].time > frames[k - 1].time,
                  "frame " + std::to_string(k) + " at " + shortest_text(frames[k].time) +
                      " s: expected a time after that of the frame before");
  return Writer(run, frames, speed).text();
}

}  // namespace tumble
