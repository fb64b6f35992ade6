/// \file
/// What every public header needs first: a compiler that reads C++20, and QUOIN_API.
#pragma once

#if defined(_MSVC_LANG)
#define QUOIN_LANGUAGE _MSVC_LANG
#else
#define QUOIN_LANGUAGE __cplusplus
#endif
#if QUOIN_LANGUAGE < 202002L
#error "Quoin needs C++20: compile with -std=c++20 or later (CMake: target_compile_features(... cxx_std_20))"
#endif
#undef QUOIN_LANGUAGE

/// Marks what a shared library of Quoin exports; everything else of the library is hidden.
#if defined(__GNUC__)
#define QUOIN_API __attribute__((visibility("default")))
#else
#define QUOIN_API
#endif
