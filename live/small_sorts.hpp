/// \file
/// \brief Included before everything else in the module of the live page: sorts that are small.
///
/// The library sorts some forty kinds of things. Unrolled and inlined as the standard library has them, sorts
/// would be a fifteenth of the module, and no step of a simulation is spent on sorting to speak of. So in the
/// module std::sort is Shell's, and std::stable_sort merges halves through a copy. What the library sorts has
/// no ties where their order shows, so the results are the same; live/check compares their hashes.
#pragma once

#pragma clang attribute push(__attribute__((minsize)), apply_to = function)
#include <algorithm>
#include <utility>
#include <vector>

namespace tumble::live {

/// Sorts in place (Shell 1959, with Gonnet's ratio of gaps).
/// \param begin the first
/// \param end   after the last
/// \param less  whether one comes before another; without ties
template <class Iterator, class Less>
void sort(Iterator begin, Iterator end, Less less) {
  const auto count = end - begin;
  for (auto gap = count / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11) {
    for (auto k = gap; k < count; ++k) {
      auto moved = std::move(begin[k]);
      auto place = k;
      for (; place >= gap && less(moved, begin[place - gap]); place -= gap)
        begin[place] = std::move(begin[place - gap]);
      begin[place] = std::move(moved);
    }
  }
}

/// Sorts by merging halves, the lower one through a copy.
/// \param begin the first
/// \param end   after the last
/// \param less  whether one comes before another; what ties stays in order
template <class Iterator, class Less>
void stable_sort(Iterator begin, Iterator end, Less less) {
  if (end - begin < 2) return;
  const Iterator middle = begin + (end - begin) / 2;
  tumble::live::stable_sort(begin, middle, less);
  tumble::live::stable_sort(middle, end, less);
  std::vector lower(begin, middle);
  auto next = lower.begin();
  for (Iterator upper = middle; next != lower.end(); ++begin)
    *begin = std::move(upper != end && less(*upper, *next) ? *upper++ : *next++);
}

}  // namespace tumble::live

// More specialised than the standard library's own, so these are chosen.
/// \cond
namespace std {
template <class T, class Less>
void sort(T* begin, T* end, Less less) {
  tumble::live::sort(begin, end, less);
}
template <class T>
void sort(T* begin, T* end) {
  tumble::live::sort(begin, end, std::less<T>());
}
template <class T, class Less>
void sort(__wrap_iter<T*> begin, __wrap_iter<T*> end, Less less) {
  tumble::live::sort(begin, end, less);
}
template <class T>
void sort(__wrap_iter<T*> begin, __wrap_iter<T*> end) {
  tumble::live::sort(begin, end, std::less<T>());
}
template <class T, class Less>
void stable_sort(__wrap_iter<T*> begin, __wrap_iter<T*> end, Less less) {
  tumble::live::stable_sort(begin, end, less);
}
}  // namespace std
/// \endcond
#pragma clang attribute pop
