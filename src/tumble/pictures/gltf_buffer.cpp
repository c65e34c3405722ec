/// \file
/// \brief Numbers as bytes, and these as text.
#include "tumble/pictures/gltf_buffer.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace tumble {
namespace {

// Constants of glTF, from OpenGL.
constexpr std::int64_t kFloat = 5126, kUnsignedShort = 5123;
constexpr std::int64_t kArrayBuffer = 34962, kElementArrayBuffer = 34963;

std::string base64(const std::string& bytes) {
  constexpr const char* letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U | (k < there ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= there ? letters[three >> (18U - 6U * k) & 0x3fU] : '=';
  }
  return out;
}

}  // namespace

// Views of vertices have one accessor each, so that they need no stride; all of them are aligned to four
// bytes.
GltfBuffer::View& GltfBuffer::view_for(Use use) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
  if (use == Use::keys && !views_.empty() && views_.back().use == use) return views_.back();
  views_.push_back({bytes_.size(), 0, use});
  return views_.back();
}

void GltfBuffer::put(std::uint32_t number, int bytes) {
  for (int k = 0; k < bytes; ++k, number >>= 8U) bytes_ += static_cast<char>(number & 0xffU);
}

std::int64_t GltfBuffer::add(Use use, int columns, const std::vector<float>& numbers, bool bounds) {
  const auto width = static_cast<std::size_t>(columns);
  assert(!numbers.empty() && numbers.size() % width == 0);
  View& view = view_for(use);
  Accessor accessor{.view = views_.size() - 1,
                    .offset = bytes_.size() - view.offset,
                    .rows = numbers.size() / width,
                    .columns = columns};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &numbers[k], sizeof bits);
    put(bits, 4);
    if (!bounds) continue;
    if (k < width) {
      accessor.low.push_back(numbers[k]);
      accessor.high.push_back(numbers[k]);
    }
    accessor.low[k % width] = std::min(accessor.low[k % width], numbers[k]);
    accessor.high[k % width] = std::max(accessor.high[k % width], numbers[k]);
  }
  view.length = bytes_.size() - view.offset;
  accessors_.push_back(std::move(accessor));
  return static_cast<std::int64_t>(accessors_.size()) - 1;
}

std::int64_t GltfBuffer::add(const std::vector<std::uint16_t>& numbers) {
  View& view = view_for(Use::indices);
  Accessor accessor{.view = views_.size() - 1, .rows = numbers.size(), .columns = 1, .whole = true};
  for (const std::uint16_t number : numbers) put(number, 2);
  view.length = bytes_.size() - view.offset;
  accessors_.push_back(std::move(accessor));
  return static_cast<std::int64_t>(accessors_.size()) - 1;
}

void GltfBuffer::write(Json& json) const {
  json.key("accessors").begin_list();
  for (const Accessor& accessor : accessors_) {
    json.begin().field("bufferView", static_cast<std::int64_t>(accessor.view));
    json.field("byteOffset", static_cast<std::int64_t>(accessor.offset));
    json.field("componentType", accessor.whole ? kUnsignedShort : kFloat);
    json.field("count", static_cast<std::int64_t>(accessor.rows));
    json.field("type", std::string_view(accessor.columns == 1   ? "SCALAR"
                                        : accessor.columns == 3 ? "VEC3"
                                                                : "VEC4"));
    if (!accessor.low.empty()) {
      json.key("min").begin_list();
      for (const float number : accessor.low) json.item(static_cast<double>(number));
      json.end_list().key("max").begin_list();
      for (const float number : accessor.high) json.item(static_cast<double>(number));
      json.end_list();
    }
    json.end();
  }
  json.end_list().key("bufferViews").begin_list();
  for (const View& view : views_) {
    json.begin().field("buffer", std::int64_t{0});
    json.field("byteOffset", static_cast<std::int64_t>(view.offset));
    json.field("byteLength", static_cast<std::int64_t>(view.length));
    if (view.use == Use::vertices) json.field("target", kArrayBuffer);
    if (view.use == Use::indices) json.field("target", kElementArrayBuffer);
    json.end();
  }
  json.end_list().key("buffers").begin_list().begin();
  json.field("byteLength", static_cast<std::int64_t>(bytes_.size()));
  json.field("uri", std::string_view("data:application/octet-stream;base64," + base64(bytes_)));
  json.end().end_list();
}

}  // namespace tumble
