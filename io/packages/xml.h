/// \file
/// XML texts, read from front to back; the parser is expat. Entities that a text declares itself are refused.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "quoin/result.h"

namespace quoin::io {

/// An element as it opens. Views live as long as the call.
class XmlElement {
 public:
  XmlElement(std::string_view name, const char* const* attributes);

  /// The namespace, empty for none, and the name without a prefix.
  std::string_view space() const { return space_; }
  std::string_view name() const { return name_; }
  /// An attribute without a namespace, or with one.
  std::optional<std::string_view> attribute(std::string_view name, std::string_view space = {}) const;

 private:
  std::string_view space_, name_;
  const char* const* attributes_;
};

/// What a text says, in its order. Methods return false to stop, after `fail`.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  virtual bool open(const XmlElement& element) = 0;
  virtual bool close() = 0;
  /// A prefix that the next element declares; empty for the default.
  virtual bool prefix(std::string_view, std::string_view /* space */) { return true; }
  /// Text of the innermost element, in pieces.
  virtual bool text(std::string_view) { return true; }

  /// Records why the reading stops, and returns false.
  bool fail(ErrorCode code, std::string message);
  /// A number of an attribute or text, blanks around it. `out` stays where it fails. Errors: "bad-number",
  /// "non-finite".
  bool number(std::string_view text, double& out);
  /// An index. Errors: "bad-number" where it is no integer, "bad-index" where it is negative or beyond 32 bits.
  bool index(std::string_view text, std::uint32_t& out);

  Error take_error() { return std::move(error_); }

 private:
  Error error_;
};

/// Reads a whole text. `part` names it in errors where it is not the file: "3D/3dmodel.model".
/// Errors (with `where` = line): "bad-syntax", also for more than 256 levels and for entities; those of the handler.
Result<void> read_xml(std::string_view text, XmlHandler& handler, const std::string& part = {});

/// The name of the first element of a text, without a prefix; empty where the text begins otherwise.
std::string_view first_element(std::string_view text);

/// Text as it stands in an attribute.
std::string xml_escaped(std::string_view text);

}  // namespace quoin::io
