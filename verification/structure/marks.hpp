/// \file
/// \brief Marks that tie lines of source to lines of the thesis's listings.
#pragma once

#include "structure/source_tree.hpp"

#include <map>
#include <set>

namespace tumble::structure {

/// A region of source between a mark and its twin.
struct MarkedRegion {
  std::string path;    ///< the file
  std::size_t from{};  ///< line of the first mark
  std::size_t to{};    ///< line of the second
  std::string name;    ///< a listing's name, or a section such as "S4.3" or "S4.3:what"
  int first_line = 0;  ///< of the listing; 0 for a section
  int last_line = 0;   ///< of the listing; 0 for a section
};

/// Finds the marks, lines with nothing but `// [NAME:from-to]`, `// [NAME:line]`, `// [S4.3]` or
/// `// [S4.3:what]`.
/// \param files       C++ files
/// \param complaints  gets one for a mark without twin, within another one, or ending before its
///                    beginning
/// \return all regions
std::vector<MarkedRegion> marked_regions(const std::vector<SourceFile>& files,
                                         Complaints& complaints);

/// One listing of the thesis's appendix A.
struct Listing {
  std::string name;     ///< as in marks
  int lines = 0;        ///< how many numbered lines it has
  std::string pending;  ///< the chapter that it waits for; empty if it must be covered
};

/// Checks that each listing is covered line by line, twice: in the source that follows what was
/// meant, and in files named *_as_printed.cpp; or that it is pending and has no marks at all.
/// \param regions   from marked_regions()
/// \param listings  all that there are
/// \return a complaint for each line that is missing, and for each pending listing with marks and
///         each mark of a listing or line that does not exist
Complaints listing_gaps(const std::vector<MarkedRegion>& regions,
                        const std::vector<Listing>& listings);

}  // namespace tumble::structure
