// SPDX-License-Identifier: MIT
#include "dem_min/large_pages.hpp"

#include <array>
#include <bit>
#include <mutex>
#include <new>
#include <sys/mman.h>
#include <vector>

namespace dem_min {
namespace {

constexpr std::size_t page = std::size_t{2} << 20, chunk = 4 * page;  // bytes
constexpr std::size_t largest_class = page;                           // larger blocks stand alone

// Four sizes in each doubling, so that no more than a fifth of a block is waste.
struct Class {
    std::size_t index, bytes;
};

Class class_of(std::size_t bytes) {
    const auto doubling = static_cast<std::size_t>(std::bit_width(bytes - 1)) - 1;
    const std::size_t quarter = std::size_t{1} << (doubling - 2);
    const std::size_t quarters = (bytes + quarter - 1) / quarter;  // 5 to 8
    return {4 * doubling + quarters - 5, quarters * quarter};
}

void* map_pages(std::size_t bytes) {
    void* const pages = ::operator new (bytes, std::align_val_t{page});
    madvise(pages, bytes, MADV_HUGEPAGE);  // where the system declines, small pages do as well
    return pages;
}

struct Pool {
    std::mutex mutex;
    std::array<std::vector<void*>, 128> free;  // [classes]
    std::byte* next = nullptr;
    std::size_t left = 0;  // bytes from there to the end of the chunk
};

// Chunks are kept until the program ends: arrays may live until then too.
Pool& pool() {
    static Pool* const one = new Pool;
    return *one;
}

std::size_t whole_pages(std::size_t bytes) { return (bytes + page - 1) / page * page; }

}  // namespace

void* take_block(std::size_t bytes) {
    if (bytes > largest_class) return map_pages(whole_pages(bytes));
    const Class size = class_of(bytes);
    Pool& p = pool();
    const std::lock_guard<std::mutex> lock(p.mutex);
    std::vector<void*>& free = p.free[size.index];
    if (!free.empty()) {
        void* const block = free.back();
        free.pop_back();
        return block;
    }
    if (p.left < size.bytes) {
        p.next = static_cast<std::byte*>(map_pages(chunk)), p.left = chunk;
    }
    void* const block = p.next;
    p.next += size.bytes, p.left -= size.bytes;
    return block;
}

void give_back_block(void* block, std::size_t bytes) {
    if (bytes > largest_class) {
        ::operator delete (block, std::align_val_t{page});
        return;
    }
    Pool& p = pool();
    const std::lock_guard<std::mutex> lock(p.mutex);
    p.free[class_of(bytes).index].push_back(block);
}

}  // namespace dem_min
