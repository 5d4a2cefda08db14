// SPDX-License-Identifier: MIT
// The arrays of the core. Large blocks of memory all begin at the same place of a page, and a loop that walks through twenty
// of them side by side then fights for the few lines of the first-level cache that serve this place. These arrays begin at
// different places, one cache line apart from the next.
#pragma once

#include "dem_min/large_pages.hpp"

#include <atomic>
#include <cstddef>
#include <new>
#include <vector>

namespace dem_min {

template <class T>
struct Staggered {
    using value_type = T;
    Staggered() = default;
    template <class U>
    Staggered(const Staggered<U>&) {}

    T* allocate(std::size_t n) {
        const std::size_t wanted = n * sizeof(T);
        if (wanted < smallest_block)
            return static_cast<T*>(::operator new (wanted, std::align_val_t{line}));
        const std::size_t shift = line * (1 + next++ % places);
        auto* const array = static_cast<std::byte*>(take_block(wanted + most)) + shift;
        *reinterpret_cast<std::size_t*>(array - sizeof(std::size_t)) = shift;
        return reinterpret_cast<T*>(array);
    }
    void deallocate(T* array, std::size_t n) {
        auto* const bytes = reinterpret_cast<std::byte*>(array);
        if (n * sizeof(T) < smallest_block)
            return ::operator delete (bytes, std::align_val_t{line});
        const std::size_t shift = *reinterpret_cast<std::size_t*>(bytes - sizeof(std::size_t));
        give_back_block(bytes - shift, n * sizeof(T) + most);
    }
    friend bool operator==(const Staggered&, const Staggered&) { return true; }

  private:
    static constexpr std::size_t line = 64;    // bytes
    static constexpr std::size_t places = 31;  // odd, so that growing arrays do not fall in step
    static constexpr std::size_t most = line * places;
    static inline std::atomic<std::size_t> next{0};
};

using Array = std::vector<double, Staggered<double>>;

}  // namespace dem_min
