/// \file
/// What every function of the C API does around its work: arguments, errors, structs of several versions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string_view>

#include "quoin/quoin.h"
#include "quoin/quoin_c.h"

namespace quoin::c {

/// An argument that the contract of the header does not allow.
struct BadArgument {
  const char* message;
  const char* where;
};

inline void demand(bool holds, const char* message, const char* where) {
  if (!holds) throw BadArgument{message, where};
}
inline void demand(const void* pointer, const char* where) {
  demand(pointer != nullptr, "the argument is NULL", where);
}

/// An index that must be below a count.
inline void demand_below(std::uint64_t index, std::uint64_t count, const char* where) {
  demand(index < count, "the index is not below the count", where);
}

/// One of the first `count` enumerators, as C callers may pass any number.
template <class To, class From>
To enumerator(From value, int count, const char* where) {
  const auto number = static_cast<long long>(value);
  demand(number >= 0 && number < count, "there is no such enumerator", where);
  return static_cast<To>(number);
}

quoin_code code_of(ErrorCode code);
/// Fills the caller's error, if any, without allocating. Returns the code.
quoin_code fail(quoin_error* error, quoin_code code, std::string_view message, std::string_view file = {},
                std::string_view where = {}) noexcept;

/// The code of work(), which throws where it fails: nothing passes beyond this.
template <class Work>
quoin_code guarded(quoin_error* error, Work&& work) noexcept {
  if (error) *error = quoin_error{};
  try {
    work();
    return QUOIN_OK;
  } catch (const BadArgument& e) {
    return fail(error, QUOIN_BAD_ARGUMENT, e.message, {}, e.where);
  } catch (const Exception& e) {
    return fail(error, code_of(e.error().code), e.error().message, e.error().file, e.error().where);
  } catch (const std::bad_alloc&) {
    return fail(error, QUOIN_OUT_OF_MEMORY, "memory is exhausted");
  } catch (const std::length_error&) {
    return fail(error, QUOIN_OUT_OF_MEMORY, "a list would be longer than memory is");
  } catch (const std::exception& e) {
    return fail(error, QUOIN_INTERNAL_DEFECT, e.what());
  } catch (...) {
    return fail(error, QUOIN_INTERNAL_DEFECT, "an exception of an unknown type");
  }
}

/// The same for a function that hands out one thing: `*out` is 0 unless work() sets it.
template <class Out, class Work>
quoin_code guarded(Out* out, quoin_error* error, Work&& work) noexcept {
  if (out) *out = Out{};
  return guarded(error, [&] {
    demand(out, "out");
    work();
  });
}

/// A struct that the caller's version may have less of than ours, the rest being 0; all 0 of NULL.
template <class Struct>
Struct taken(const Struct* given, const char* where) {
  Struct own{};
  if (!given) return own;
  demand(given->size >= sizeof(given->size), "the struct has no size", where);
  std::memcpy(&own, given, std::min(given->size, sizeof(own)));
  return own;
}

/// Before the work: a struct to be filled has a size.
template <class Struct>
void demand_size(const Struct* out, const char* where) {
  demand(!out || out->size >= sizeof(out->size), "the struct has no size", where);
}

/// As much of a struct as the caller's version has; nothing for NULL.
template <class Struct>
void give(Struct own, Struct* out) {
  if (!out) return;
  own.size = out->size;
  std::memcpy(out, &own, std::min(out->size, sizeof(own)));
}

/// A copy for quoin_text_free.
char* text(std::string_view value);

}  // namespace quoin::c
