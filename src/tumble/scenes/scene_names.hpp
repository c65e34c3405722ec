/// \file
/// \brief Names of the boxes and of the joints of a scene.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble {

/// The longest name [bytes] of a box or a joint. Each row of a table has it, and readers of tables limit rows.
inline constexpr std::size_t kLongestName = 1000;

/// Makes sure that names are printable, not too long, and each is one's own; what has none gets one. Files and messages identify by names; a
/// line break in one would break rows.
/// \param all     boxes or joints, each with a `name`
/// \param word    what one is called; with a number it is the name of what has none
/// \param several what more of them are called
/// \param ground  whether "ground" is taken
/// \param refuse  receives the place and the message about its name; throws
template <class Named, class Refuse>
void settle_names(std::vector<Named>& all, const std::string& word, std::string_view several,
                  bool ground, const Refuse& refuse) {
  std::set<std::string_view> taken;  // of the boxes' own texts
  if (ground) taken.insert("ground");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    if (name.size() > kLongestName)
      refuse(i, ": " + std::to_string(name.size()) + " bytes: expected at most " +
                    std::to_string(kLongestName));
    for (const char c : name)
      if (static_cast<unsigned char>(c) < 0x20U || c == 0x7f)
        refuse(i, ": contains a control character: expected printable characters");
    if (name.empty() || taken.insert(name).second) continue;
    const bool of_ground = ground && name == "ground";
    refuse(i, " = " + name + (of_ground ? ": the ground has" : ": two ") +
                  (of_ground ? "" : std::string(several) + " have") +
                  " this name: choose another one");
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t number = i + 1; all[i].name.empty(); ++number) {
      std::string candidate = word + std::to_string(number);
      if (taken.contains(candidate)) continue;
      all[i].name = std::move(candidate);
      taken.insert(all[i].name);
    }
}

}  // namespace tumble
