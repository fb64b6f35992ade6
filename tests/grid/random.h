/// \file
/// Seeds of the random tests of this room.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

/// A generator seeded by the environment variable QUOIN_SEED, else by chance; the seed is printed.
inline std::mt19937_64 seeded_generator() {
  const char* const given = std::getenv("QUOIN_SEED");
  const std::uint64_t seed = given != nullptr ? std::stoull(given) : std::random_device{}();
  std::cout << "QUOIN_SEED=" << seed << "\n";
  return std::mt19937_64(seed);
}
