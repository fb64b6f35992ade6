// Memory for GMP where the system has none.
#include <gmp.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>

#include "c/handles.h"

using namespace quoin::c;

namespace {

/// A stack of blocks. What is given back below the top is free when all above it is.
class Reserve {
 public:
  explicit Reserve(std::size_t size) : bytes_(new std::byte[size]), size_(size) {}

  bool holds(const void* block) const {
    const auto* at = static_cast<const std::byte*>(block);
    return std::greater_equal<>()(at, bytes_.get()) && std::less<>()(at, bytes_.get() + size_);
  }

  /// nullptr where no room is left.
  void* take(std::size_t size) {
    const std::lock_guard lock(changing_);
    const std::size_t whole = sizeof(Block) + (size + alignment - 1) / alignment * alignment;
    if (size > size_ || whole > size_ - used_) return nullptr;
    new (bytes_.get() + used_) Block{top_, true};
    top_ = used_;
    used_ += whole;
    return bytes_.get() + top_ + sizeof(Block);
  }

  void give_back(void* block) {
    const std::lock_guard lock(changing_);
    reinterpret_cast<Block*>(static_cast<std::byte*>(block) - sizeof(Block))->is_taken = false;
    while (used_ > 0 && !at(top_).is_taken) {
      used_ = top_;
      top_ = at(top_).below;
    }
  }

 private:
  static constexpr std::size_t alignment = alignof(std::max_align_t);
  struct alignas(alignment) Block {
    std::size_t below;  // where the block below this one begins
    bool is_taken;
  };
  const Block& at(std::size_t begin) const { return *reinterpret_cast<const Block*>(bytes_.get() + begin); }

  std::mutex changing_;
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_, used_ = 0, top_ = 0;
};

/// Never destroyed: GMP may be used while static objects are.
Reserve* reserve = nullptr;
std::mutex installing;

/// GMP cannot be thrown through: what it says then is its own.
[[noreturn]] void end_without_memory(std::size_t size) {
  std::fprintf(stderr, "GNU MP: Cannot allocate memory (size=%zu)\n", size);
  std::abort();
}

void* allocate(std::size_t size) {
  void* made = std::malloc(size);
  if (!made) made = reserve->take(size);
  if (!made) end_without_memory(size);
  return made;
}

void release(void* old, std::size_t) {
  if (reserve->holds(old))
    reserve->give_back(old);
  else
    std::free(old);
}

void* reallocate(void* old, std::size_t old_size, std::size_t size) {
  if (!reserve->holds(old))
    if (void* made = std::realloc(old, size)) return made;

  void* made = allocate(size);
  std::memcpy(made, old, std::min(old_size, size));
  release(old, old_size);
  return made;
}

}  // namespace

quoin_code quoin_reserve_for_gmp(size_t bytes, quoin_error* error) {
  return guarded(error, [&] {
    const std::lock_guard lock(installing);
    demand(reserve == nullptr, "there is a reserve already", "bytes");
    reserve = new Reserve(bytes);
    ::mp_set_memory_functions(allocate, reallocate, release);
  });
}
