/// \file
/// \brief glTF files read back: their structure, and the poses at their keys.
#include "tumble/pictures/gltf.hpp"

#include "live/json.hpp"
#include "support/test.hpp"

#include <cstring>

using test::JsonReader;
using test::JsonValue;

namespace {

std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out += static_cast<char>(bits >> count & 0xffU);
  }
  return out;
}

std::size_t whole(const JsonValue& value) { return static_cast<std::size_t>(value.number); }

// A glTF file as a viewer reads it; requirements of the specification are checked on the way.
struct Read {
  explicit Read(const std::string& text) : json(JsonReader::read(text)) {
    CHECK(json.at("asset").at("version").text == "2.0");
    const JsonValue& buffer = json.at("buffers").items.at(0);
    const std::string head = "data:application/octet-stream;base64,";
    REQUIRE(buffer.at("uri").text.starts_with(head));
    bytes = from_base64(buffer.at("uri").text.substr(head.size()));
    CHECK(bytes.size() == whole(buffer.at("byteLength")));
    for (const JsonValue& view : json.at("bufferViews").items)
      CHECK(whole(view.at("byteOffset")) + whole(view.at("byteLength")) <= bytes.size());
    for (std::size_t k = 0; k < json.at("accessors").items.size(); ++k) rows(k);
  }

  static std::size_t columns_of(const JsonValue& accessor) {
    const std::string& type = accessor.at("type").text;
    return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
  }

  // The numbers of an accessor, within their view and with its bounds.
  std::vector<double> rows(std::size_t number) const {
    const JsonValue& accessor = json.at("accessors").items.at(number);
    const JsonValue& view = json.at("bufferViews").items.at(whole(accessor.at("bufferView")));
    const std::size_t columns = columns_of(accessor);
    const bool single = whole(accessor.at("componentType")) == 5126;
    CHECK((single || whole(accessor.at("componentType")) == 5123));
    const std::size_t size = single ? 4 : 2;
    const std::size_t count = whole(accessor.at("count")) * columns;
    const std::size_t offset = whole(accessor.at("byteOffset"));
    CHECK(count > 0);
    CHECK(offset % size == 0);
    CHECK((whole(view.at("byteOffset")) + offset) % size == 0);
    REQUIRE(offset + count * size <= whole(view.at("byteLength")));
    std::vector<double> out;
    for (std::size_t k = 0; k < count; ++k) {
      const char* at = bytes.data() + whole(view.at("byteOffset")) + offset + k * size;
      float value = 0.0F;
      std::uint16_t index = 0;
      if (single) std::memcpy(&value, at, 4);
      if (!single) std::memcpy(&index, at, 2);
      out.push_back(single ? static_cast<double>(value) : index);
      CHECK(std::isfinite(out.back()));
    }
    if (accessor.fields.count("min") > 0) {
      for (std::size_t c = 0; c < columns; ++c) {
        double low = out[c], high = out[c];
        for (std::size_t k = c; k < count; k += columns) {
          low = std::min(low, out[k]);
          high = std::max(high, out[k]);
        }
        CHECK(accessor.at("min").items.at(c).number == low);
        CHECK(accessor.at("max").items.at(c).number == high);
      }
    }
    return out;
  }

  std::size_t node(const std::string& name) const {
    const auto& nodes = json.at("nodes").items;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (nodes[k].at("name").text == name) return k;
    throw std::runtime_error("no node " + name);
  }

  // The sampler of a property of a node; null if there is none.
  const JsonValue* sampler(std::size_t node, const std::string& path) const {
    if (json.fields.count("animations") == 0) return nullptr;
    const JsonValue& animation = json.at("animations").items.at(0);
    for (const JsonValue& channel : animation.at("channels").items)
      if (whole(channel.at("target").at("node")) == node &&
          channel.at("target").at("path").text == path)
        return &animation.at("samplers").items.at(whole(channel.at("sampler")));
    return nullptr;
  }

  JsonValue json;
  std::string bytes;
};

// Three boxes and the ground: one never moves, one spins, one appears and disappears.
RecordedRun three_boxes() {
  RecordedRun run;
  run.scene.title = "three \"boxes\"";
  run.scene.ground = SceneGround{};
  run.scene.boxes.resize(3);
  run.scene.boxes[0] = {.name = "wall", .size = Vec3(4.0, 1.0, 0.5), .fixed = true};
  run.scene.boxes[1] = {.name = "top", .size = Vec3(1.0, 2.0, 3.0)};
  run.scene.boxes[2] = {.name = "guest", .size = Vec3(0.5, 0.5, 0.5)};
  Random random(3);
  const Vec3 axis_w = random.direction();
  for (int k = 0; k < 9; ++k) {
    RecordedFrame frame{2.0 + 0.125 * k, {}};
    const auto add = [&](int box, const Vec3& position_w, const Quat& orientation_wb) {
      RecordedPose pose{.box = box, .position_w = position_w, .orientation_wb = orientation_wb};
      frame.poses.push_back(pose);
    };
    add(0, Vec3(0.0, 0.5, -3.0), Quat::Identity());
    // Just over a turn, with signs as a filter may produce them.
    Quat turned = rotation_from_vector(0.8 * k * axis_w);
    if (k % 3 == 1) turned.coeffs() *= -1.0;
    add(1, Vec3(0.1 * k, 3.0 - 0.2 * k, 0.0), turned);
    if (k >= 3 && k < 6) add(2, Vec3(2.0, 0.1 * k, 1.0), Quat::Identity());
    run.frames.push_back(frame);
  }
  return run;
}

}  // namespace

TEST_CASE("A glTF file that is read back has the poses of the trajectory at its keys",
          "[exact][picture]") {
  const RecordedRun run = three_boxes();
  const Read read(to_gltf(run, run.frames, 0.5));
  CHECK(read.json.at("scenes").items.at(0).at("name").text == "three \"boxes\"");
  CHECK(read.json.at("nodes").items.size() == 4);  // with the ground
  CHECK(read.json.at("scenes").items.at(0).at("nodes").items.size() == 4);

  const std::size_t top = read.node("top");
  const JsonValue* moves = read.sampler(top, "translation");
  const JsonValue* turns = read.sampler(top, "rotation");
  REQUIRE(moves != nullptr);
  REQUIRE(turns != nullptr);
  CHECK(moves->at("interpolation").text == "LINEAR");
  CHECK(turns->at("interpolation").text == "LINEAR");
  const std::vector<double> times = read.rows(whole(moves->at("input")));
  const std::vector<double> places = read.rows(whole(moves->at("output")));
  const std::vector<double> turned = read.rows(whole(turns->at("output")));
  REQUIRE(times.size() == run.frames.size());
  REQUIRE(places.size() == 3 * times.size());
  REQUIRE(turned.size() == 4 * times.size());
  Quat before = Quat::Identity();
  for (std::size_t k = 0; k < times.size(); ++k) {
    // From 0, at half speed; eighths of a second are exact.
    CHECK(times[k] == 2.0 * (run.frames[k].time - 2.0));
    const RecordedPose& pose = run.frames[k].poses.at(1);
    for (std::size_t c = 0; c < 3; ++c)  // [m] single precision of numbers up to 3
      CHECK(std::abs(places[3 * k + c] - pose.position_w[static_cast<int>(c)]) <= 2e-7);
    const Quat q(turned[4 * k + 3], turned[4 * k], turned[4 * k + 1], turned[4 * k + 2]);
    CHECK(std::abs(q.norm() - 1.0) <= 1e-7);  // [-] likewise
    CHECK(angle_between(q.normalized(), pose.orientation_wb) <= 5e-7);
    CHECK(q.dot(before) > 0.0);
    before = q;
  }
}

TEST_CASE("In a glTF file boxes have sizes and colours and come and go in steps",
          "[unit][picture]") {
  const RecordedRun run = three_boxes();
  const Read read(to_gltf(run, run.frames));
  const auto& nodes = read.json.at("nodes").items;
  const auto scale = [&](std::size_t node) {
    std::vector<double> out;
    for (const JsonValue& item : nodes[node].at("scale").items) out.push_back(item.number);
    return out;
  };
  const auto material = [&](std::size_t node) {
    const JsonValue& mesh = read.json.at("meshes").items.at(whole(nodes[node].at("mesh")));
    const JsonValue& primitive = mesh.at("primitives").items.at(0);
    return read.json.at("materials").items.at(whole(primitive.at("material"))).at("name").text;
  };
  CHECK(scale(read.node("top")) == std::vector<double>{1.0, 2.0, 3.0});
  CHECK(scale(read.node("wall")) == std::vector<double>{4.0, 1.0, 0.5});
  CHECK_THAT(material(read.node("top")), Contains("movable"));
  CHECK_THAT(material(read.node("wall")), Contains("fixed"));
  CHECK(material(read.node("ground")) == "ground");
  const double top = nodes[read.node("ground")].at("translation").items.at(1).number +
                     0.5 * scale(read.node("ground"))[1];
  CHECK(std::abs(top) <= 1e-7);  // [m] the ground is at 0
  for (const char* path : {"translation", "rotation", "scale"}) {
    CHECK(read.sampler(read.node("wall"), path) == nullptr);
    CHECK(read.sampler(read.node("ground"), path) == nullptr);
  }
  CHECK(read.sampler(read.node("top"), "scale") == nullptr);
  const JsonValue* seen = read.sampler(read.node("guest"), "scale");
  REQUIRE(seen != nullptr);
  CHECK(seen->at("interpolation").text == "STEP");
  CHECK(read.rows(whole(seen->at("input"))) == std::vector<double>{0.0, 0.375, 0.75});
  CHECK(read.rows(whole(seen->at("output"))) ==
        std::vector<double>{0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.0, 0.0, 0.0});
  CHECK(scale(read.node("guest")) == std::vector<double>{0.0, 0.0, 0.0});
}

TEST_CASE("The box of a glTF file is closed and its faces look outwards", "[exact][picture]") {
  const RecordedRun run = three_boxes();
  const Read read(to_gltf(run, std::span(run.frames).first(1)));
  CHECK(read.json.fields.count("animations") == 0);  // one frame does not move
  std::set<std::size_t> used;
  for (const JsonValue& mesh : read.json.at("meshes").items) {
    const JsonValue& primitive = mesh.at("primitives").items.at(0);
    used.insert(whole(primitive.at("indices")));
    const auto points = read.rows(whole(primitive.at("attributes").at("POSITION")));
    const auto normals = read.rows(whole(primitive.at("attributes").at("NORMAL")));
    const auto corners = read.rows(whole(primitive.at("indices")));
    REQUIRE(points.size() == 72);
    REQUIRE(corners.size() == 36);
    const auto vector_at = [](const std::vector<double>& list, double k) {
      const auto at = 3 * static_cast<std::size_t>(k);
      return Vec3(list.at(at), list.at(at + 1), list.at(at + 2));
    };
    double volume = 0.0;
    for (std::size_t k = 0; k < 36; k += 3) {
      const Vec3 a = vector_at(points, corners[k]), b = vector_at(points, corners[k + 1]),
                 c = vector_at(points, corners[k + 2]);
      CHECK((b - a).cross(c - a).normalized() == vector_at(normals, corners[k]));
      volume += a.dot(b.cross(c)) / 6.0;
    }
    CHECK(volume == near(1.0, 1e-12));
  }
  CHECK(used.size() == 1);  // one box for all
}

TEST_CASE("Frames that make no animation are refused", "[unit][picture]") {
  RecordedRun run = three_boxes();
  CHECK_THROWS_WITH(to_gltf(run, std::span<const RecordedFrame>()), Contains("no frames"));
  CHECK_THROWS_WITH(to_gltf(run, run.frames, 0.0), Contains("speed"));
  std::swap(run.frames[1], run.frames[2]);
  CHECK_THROWS_WITH(to_gltf(run, run.frames), Contains("frame 2 at 2.125 s"));
  run.frames = {RecordedFrame{0.0, {}}};
  CHECK_THROWS_WITH(to_gltf(run, run.frames), Contains("no box is in these frames"));
}

TEST_CASE(
    "Between recorded frames boxes are interpolated linearly, and boxes of one frame alone are "
    "absent",
    "[exact][picture]") {
  const RecordedRun run = three_boxes();
  const RecordedFrame at = frame_at(run, 2.25);
  CHECK(at.time == 2.25);
  CHECK(at.poses.size() == 2);
  CHECK(at.poses[1].position_w == run.frames[2].poses[1].position_w);
  CHECK(at.poses[1].orientation_wb.coeffs() == run.frames[2].poses[1].orientation_wb.coeffs());
  const RecordedFrame between = frame_at(run, 2.25 + 0.25 * 0.125);
  CHECK(between.poses.size() == 2);  // the guest appears with the next frame
  const Vec3 expected_w = Vec3(0.1 * 2.25, 3.0 - 0.2 * 2.25, 0.0);
  CHECK((between.poses[1].position_w - expected_w).norm() <= 1e-15);  // [m] rounding
  const Quat& from = run.frames[2].poses[1].orientation_wb;
  // [rad] rounding: a quarter of the rotation by 0.8 rad.
  CHECK(std::abs(angle_between(from, between.poses[1].orientation_wb) - 0.2) <= 1e-14);
  CHECK(frame_at(run, 2.0 + 3.5 * 0.125).poses.size() == 3);
  CHECK(frame_at(run, 3.0).poses.size() == 2);
  CHECK_THROWS_WITH(frame_at(run, 1.99), Contains("recorded from 2 to 3 s"));
  CHECK_THROWS_AS(frame_at(run, kNan), std::invalid_argument);
}
