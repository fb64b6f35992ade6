/// \file
/// glTF documents by hand, for the tests.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace quoin::io::test {

inline std::string word(std::uint32_t value) {
  std::string out;
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  return out;
}

inline std::string bytes_of(const std::vector<float>& values) {
  std::string out;
  for (const float v : values) out += word(std::bit_cast<std::uint32_t>(v));
  return out;
}

inline std::string glb(std::string json, const std::string& binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(28 + json.size() + binary.size())) +
         word(static_cast<std::uint32_t>(json.size())) + "JSON" + json +
         word(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
}

/// Four points, and the indices of a tetrahedron in 16 bits.
inline std::string tetrahedron_buffer() {
  std::string out = bytes_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (const char i : {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}) out += std::string{i, '\0'};
  return out;
}

/// A document of that buffer; `nodes` and what else the root has are given.
inline std::string document(const std::string& nodes, const std::string& primitive = R"("indices":1)",
                            const std::string& rest = "", const std::string& buffer = "") {
  return R"({"asset":{"version":"2.0"},"nodes":[)" + nodes +
         R"(],"meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0,"NORMAL":0},)" + primitive +
         R"(}]}],"buffers":[{"byteLength":72)" + buffer + R"(}],"bufferViews":[{"buffer":0,"byteLength":48},)" +
         R"({"buffer":0,"byteOffset":48,"byteLength":24}],"accessors":[)" +
         R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)" +
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}])" + rest + "}";
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos) << from;
  return text.replace(text.find(from), from.size(), to);
}

/// A document of one mesh and one node that places it, with lists of the root by their texts. The first buffer is the
/// chunk of a GLB.
inline std::string document_of(const std::string& primitives, const std::string& accessors, const std::string& views,
                               std::size_t size, const std::string& node = "") {
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0)" + node + R"(}],"meshes":[{"primitives":[)" + primitives +
         R"(]}],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views + R"(],"buffers":[{"byteLength":)" +
         std::to_string(size) + "}]}";
}

/// A GLB of a tetrahedron whose twelve coordinates are integers of so many bytes, points 8 bytes apart.
inline std::string quantised(const std::vector<int>& coordinates, int component, bool is_normalized,
                             const std::string& node = "") {
  std::string buffer;
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    std::string point;
    for (std::size_t k = 0; k < 3; ++k)
      point += word(static_cast<std::uint32_t>(coordinates[i + k])).substr(0, component < 5122 ? 1 : 2);
    point.resize(8);
    buffer += point;
  }
  buffer += std::string("\0\2\1\0\1\3\1\2\3\2\0\3", 12);
  return glb(document_of(R"({"attributes":{"POSITION":0},"indices":1})",
                         R"({"bufferView":0,"count":4,"type":"VEC3","componentType":)" + std::to_string(component) +
                             (is_normalized ? R"(,"normalized":true)" : "") +
                             R"(},{"bufferView":1,"count":12,"type":"SCALAR","componentType":5121})",
                         R"({"buffer":0,"byteLength":32,"byteStride":8},{"buffer":0,"byteOffset":32,"byteLength":12})",
                         buffer.size(), node),
             buffer);
}

}  // namespace quoin::io::test
