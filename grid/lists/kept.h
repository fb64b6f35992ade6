/// \file
/// What a thread keeps from one call to the next.
#pragma once

namespace quoin::grid {

/// The thread's T, made when it is first asked for. Null when the thread has ended what it keeps: destructors of static
/// objects may call the library still.
template <class T>
T* kept_by_thread() {
  static thread_local bool is_over = false;
  struct Kept {
    T value = {};
    ~Kept() { is_over = true; }
  };
  if (is_over) return nullptr;
  static thread_local Kept kept;
  return &kept.value;
}

}  // namespace quoin::grid
