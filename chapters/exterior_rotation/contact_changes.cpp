/// \file
/// \brief Changes of contact in a run, and which of them another run does not have.
#include "exterior_rotation/contact_changes.hpp"

#include <algorithm>
#include <cstdlib>

namespace tumble::chapters {

std::vector<ContactChange> changes_of(const std::vector<std::vector<ContactSet>>& looks) {
  std::vector<ContactChange> changes;
  for (std::size_t n = 1; n < looks.size(); ++n) {
    for (std::size_t j = 0; j < looks[n].size(); ++j) {
      const ContactSet& before = looks[n - 1][j];
      const ContactSet& now = looks[n][j];
      ContactChange change{static_cast<int>(n), static_cast<int>(j)};
      if (now.touching != before.touching) {
        change.kind = (now.touching & ~before.touching) != 0 ? ChangeKind::found : ChangeKind::lost;
        change.touching = now.touching;
        changes.push_back(change);
      }
      if (now.overlapped == before.overlapped) continue;
      change.kind = now.overlapped ? ChangeKind::overlap : ChangeKind::cleared;
      change.touching = 0;
      changes.push_back(change);
    }
  }
  return changes;
}

std::vector<ContactChange> changes_not_in(const std::vector<ContactChange>& changes,
                                          const std::vector<ContactChange>& other, int within) {
  std::vector<char> used(other.size(), 0);
  std::vector<ContactChange> left;
  for (const ContactChange& change : changes) {
    std::size_t k = 0;
    while (k < other.size() && (used[k] != 0 || !change.same(other[k]) ||
                                std::abs(change.step - other[k].step) > within))
      ++k;
    if (k == other.size())
      left.push_back(change);
    else
      used[k] = 1;
  }
  return left;
}

}  // namespace tumble::chapters
