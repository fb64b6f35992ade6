#include "io/packages/xml.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <type_traits>

#include <expat.h>

#include "io/scanner.h"

namespace quoin::io {
namespace {

/// Between namespace and name: no URI has a blank.
constexpr char separator = ' ';
constexpr int max_depth = 256;

std::pair<std::string_view, std::string_view> parted(std::string_view name) {
  const std::size_t at = name.rfind(separator);
  return at == std::string_view::npos ? std::pair{std::string_view(), name}
                                      : std::pair{name.substr(0, at), name.substr(at + 1)};
}

/// What expat calls. Exceptions do not pass through its frames: they wait here.
struct Reading {
  XmlHandler& handler;
  XML_Parser parser;
  int depth = 0;
  bool stopped = false;
  std::exception_ptr exception = {};

  template <class Work>
  void call(Work&& work) noexcept {
    if (stopped) return;
    try {
      if (work()) return;
    } catch (...) {
      exception = std::current_exception();
    }
    stopped = true;
    XML_StopParser(parser, XML_FALSE);
  }
};

void opened(void* user, const XML_Char* name, const XML_Char** attributes) {
  auto& reading = *static_cast<Reading*>(user);
  reading.call([&] {
    if (++reading.depth > max_depth)
      return reading.handler.fail(ErrorCode::bad_syntax, "elements are nested more than 256 levels deep");
    return reading.handler.open(XmlElement(name, attributes));
  });
}

void closed(void* user, const XML_Char*) {
  auto& reading = *static_cast<Reading*>(user);
  --reading.depth;
  reading.call([&] { return reading.handler.close(); });
}

void bound(void* user, const XML_Char* prefix, const XML_Char* space) {
  auto& reading = *static_cast<Reading*>(user);
  const auto text = [](const XML_Char* word) { return word == nullptr ? std::string_view() : std::string_view(word); };
  reading.call([&] { return reading.handler.prefix(text(prefix), text(space)); });
}

void said(void* user, const XML_Char* text, int size) {
  auto& reading = *static_cast<Reading*>(user);
  reading.call([&] { return reading.handler.text({text, static_cast<std::size_t>(size)}); });
}

void declared(void* user, const XML_Char*, int, const XML_Char*, int, const XML_Char*, const XML_Char*, const XML_Char*,
              const XML_Char*) {
  auto& reading = *static_cast<Reading*>(user);
  reading.call(
      [&] { return reading.handler.fail(ErrorCode::bad_syntax, "entities that the text declares are not read"); });
}

std::string place(XML_Parser parser, const std::string& part) {
  return (part.empty() ? "" : part + ", ") + "line " + std::to_string(XML_GetCurrentLineNumber(parser));
}

}  // namespace

XmlElement::XmlElement(std::string_view name, const char* const* attributes) : attributes_(attributes) {
  std::tie(space_, name_) = parted(name);
}

std::optional<std::string_view> XmlElement::attribute(std::string_view name, std::string_view space) const {
  // One without a namespace stands as it is.
  for (const char* const* at = attributes_; *at != nullptr; at += 2)
    if (space.empty() ? *at == name : parted(*at) == std::pair{space, name}) return at[1];
  return std::nullopt;
}

bool XmlHandler::fail(ErrorCode code, std::string message) {
  error_ = Error{code, std::move(message)};
  return false;
}

bool XmlHandler::number(std::string_view text, double& out) {
  Scanner scanner(text);
  scanner.skip_space();
  double value = 0;
  if (scanner.number(value)) {
    scanner.skip_space();
    if (scanner.at_end()) {
      out = value;
      return true;
    }
  }
  const ErrorCode code = scanner.take_error().code;
  return code == ErrorCode::non_finite
             ? fail(code, "this number is not finite in double precision")
             : fail(ErrorCode::bad_number, "\"" + std::string(text.substr(0, 40)) + "\" is not a decimal number");
}

bool XmlHandler::index(std::string_view text, std::uint32_t& out) {
  Scanner scanner(text);
  std::int64_t value = 0;
  scanner.skip_space();
  const bool is_read = scanner.integer(value);
  scanner.skip_space();
  if (!is_read || !scanner.at_end())
    return fail(ErrorCode::bad_number, "\"" + std::string(text.substr(0, 40)) + "\" is not an integer");
  if (value < 0 || value > std::numeric_limits<std::uint32_t>::max())
    return fail(ErrorCode::bad_index, "an index is negative or beyond 32 bits");
  out = static_cast<std::uint32_t>(value);
  return true;
}

Result<void> read_xml(std::string_view text, XmlHandler& handler, const std::string& part) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(
      XML_ParserCreateNS(nullptr, separator), XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Reading reading{handler, parser.get()};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), opened, closed);
  XML_SetCharacterDataHandler(parser.get(), said);
  XML_SetStartNamespaceDeclHandler(parser.get(), bound);
  XML_SetEntityDeclHandler(parser.get(), declared);

  // expat counts in int.
  constexpr std::size_t piece = std::size_t{1} << 24;
  XML_Status status = XML_STATUS_OK;
  for (bool last = false; status == XML_STATUS_OK && !last;) {
    const std::string_view front = text.substr(0, piece);
    text.remove_prefix(front.size());
    last = text.empty();
    status = XML_Parse(parser.get(), front.data(), static_cast<int>(front.size()), last ? 1 : 0);
  }

  if (reading.exception) std::rethrow_exception(reading.exception);
  if (reading.stopped) {
    Error error = handler.take_error();
    if (error.where.empty()) error.where = place(parser.get(), part);
    return error;
  }
  if (status == XML_STATUS_OK) return {};
  const XML_Error code = XML_GetErrorCode(parser.get());
  if (code == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
  const bool is_cut = code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN;
  return Error{is_cut ? ErrorCode::truncated : ErrorCode::bad_syntax,
               std::string("this is no XML: ") + XML_ErrorString(code),
               {},
               place(parser.get(), part)};
}

std::string_view first_element(std::string_view text) {
  const auto skip_past = [&](std::string_view end) {
    const std::size_t at = text.find(end);
    text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
  };
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.starts_with("<?")) {
      skip_past("?>");
    } else if (text.starts_with("<!--")) {
      skip_past("-->");
    } else if (text.starts_with("<!")) {
      skip_past(">");
    } else {
      break;
    }
  }
  if (!text.starts_with('<')) return {};
  const std::string_view name = text.substr(1, text.find_first_of(" \t\r\n/>", 1) - 1);
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out.push_back(c);
    }
  return out;
}

}  // namespace quoin::io
