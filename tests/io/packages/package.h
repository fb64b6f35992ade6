/// \file
/// Packages for the tests of 3MF and AMF: what others would write, by this room's archives, and a second reader of
/// such archives, which knows central directories alone.
#pragma once

#include <string>
#include <vector>

#include "io/packages/zip.h"

namespace quoin::io::test {

inline const std::string core_space = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

inline std::string relationships(const std::string& target = "/3D/3dmodel.model") {
  return "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
         "<Relationship Id=\"r\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\"" +
         target + "\"/></Relationships>";
}

/// A package of one model part.
inline std::string package(const std::string& model) {
  return write_zip({{"_rels/.rels", relationships()}, {"3D/3dmodel.model", model}});
}

/// A tetrahedron of the given size, from the origin.
inline std::string tetrahedron_text(const std::string& size = "1") {
  return "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"" + size +
         "\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"" + size + "\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"" + size +
         "\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
         "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"2\" v2=\"0\" v3=\"3\"/></triangles></mesh>";
}

inline std::string model_text(const std::string& resources, const std::string& build,
                              const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?><model xmlns=\"" + core_space + "\" " + attributes + "><resources>" + resources +
         "</resources><build>" + build + "</build></model>";
}

inline std::string object_text(int id, const std::string& content, const std::string& attributes = "") {
  return "<object id=\"" + std::to_string(id) + "\" " + attributes + ">" + content + "</object>";
}

inline std::string components_text(const std::vector<int>& ids) {
  std::string text = "<components>";
  for (const int id : ids) text += "<component objectid=\"" + std::to_string(id) + "\"/>";
  return text + "</components>";
}

}  // namespace quoin::io::test
