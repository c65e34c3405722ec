/// \file
/// \brief The hash against FNV-1a over bytes.
#include "tumble/base/state_hash.hpp"

#include "support/test.hpp"

namespace {

// FNV-1a as published: over bytes.
std::uint64_t fnv1a(const std::vector<unsigned char>& bytes) {
  std::uint64_t hash = 14695981039346656037U;
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211U;
  return hash;
}

template <typename Number>
std::uint64_t hash_of(Number value) {
  StateHash hash;
  hash.add(value);
  return hash.value();
}

}  // namespace

TEST_CASE("The byte loop that judges the hash passes the published vectors", "[exact][hash]") {
  CHECK(fnv1a({}) == 0xcbf29ce484222325U);
  CHECK(fnv1a({'a'}) == 0xaf63dc4c8601ec8cU);
  CHECK(fnv1a({'f', 'o', 'o', 'b', 'a', 'r'}) == 0x85944171f73967e8U);
}

TEST_CASE("The hash is FNV-1a over the bytes, the lowest first", "[exact][hash]") {
  CHECK(StateHash().value() == fnv1a({}));
  const std::uint64_t word = 0x0123456789abcdefU;
  CHECK(hash_of(word) == fnv1a({0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01}));
  CHECK(hash_of(1.0) == fnv1a({0, 0, 0, 0, 0, 0, 0xf0, 0x3f}));  // 0x3ff0000000000000
  StateHash hash;
  hash.add(word);
  hash.add(1.0);
  CHECK(hash.value() ==
        fnv1a({0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01, 0, 0, 0, 0, 0, 0, 0xf0, 0x3f}));
}

TEST_CASE("Vectors are hashed x first, quaternions w first", "[exact][hash]") {
  StateHash numbers;
  for (const double value : {1.0, 2.0, 3.0, 4.0}) numbers.add(value);
  StateHash parts;
  parts.add(1.0);
  parts.add(Vec3(2.0, 3.0, 4.0));
  CHECK(parts.value() == numbers.value());
  CHECK(hash_of(Quat(1.0, 2.0, 3.0, 4.0)) == numbers.value());
}

TEST_CASE("The hash sees the sign of zero, the last bit, the order and a NaN", "[unit][hash]") {
  CHECK(hash_of(0.0) != hash_of(-0.0));
  CHECK(hash_of(1.0) != hash_of(1.0 + std::numeric_limits<double>::epsilon()));
  CHECK(hash_of(Vec3(1.0, 2.0, 3.0)) != hash_of(Vec3(2.0, 1.0, 3.0)));
  CHECK(hash_of(0.0) != hash_of(kNan));
}

TEST_CASE("The printed hash has 16 digits, leading zeros included", "[unit][hash]") {
  CHECK(StateHash().text() == "cbf29ce484222325");
  // Every digit must be where the number has it.
  StateHash hash;
  for (std::uint64_t i = 0; i < 100; ++i) {
    hash.add(i);
    CHECK(hash.text().size() == 16);
    CHECK(std::stoull(hash.text(), nullptr, 16) == hash.value());
  }
}
