// SPDX-License-Identifier: MIT
// The arrays of the core. Large blocks of memory all begin at the same place of a page, and a loop that walks through twenty
// of them side by side then fights for the few lines of the first-level cache that serve this place. These arrays begin at
// different places, one cache line apart from the next.
#pragma once

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
        const std::size_t shift = wanted < large ? line : line * (1 + next++ % places);
        auto* const block =
            static_cast<std::byte*>(::operator new (wanted + shift, std::align_val_t{line}));
        auto* const array = block + shift;
        *reinterpret_cast<std::size_t*>(array - sizeof(std::size_t)) = shift;
        return reinterpret_cast<T*>(array);
    }
    void deallocate(T* array, std::size_t) {
        auto* const bytes = reinterpret_cast<std::byte*>(array);
        const std::size_t shift = *reinterpret_cast<std::size_t*>(bytes - sizeof(std::size_t));
        ::operator delete (bytes - shift, std::align_val_t{line});
    }
    friend bool operator==(const Staggered&, const Staggered&) { return true; }

  private:
    static constexpr std::size_t line = 64,
                                 places =
                                     31;  // bytes; odd, so that growing arrays do not fall in step
    static constexpr std::size_t large = 32768;  // bytes; smaller blocks lie anywhere in a page
    static inline std::atomic<std::size_t> next{0};
};

using Array = std::vector<double, Staggered<double>>;

}  // namespace dem_min
