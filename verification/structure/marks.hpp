/// \file
/// \brief Marks that tie lines of source to lines of the thesis's listings.
#pragma once

#include "driver/marks.hpp"
#include "structure/source_tree.hpp"

#include <map>
#include <set>

namespace tumble::structure {

using chapters::MarkedRegion;

/// Finds the marks of many files: see chapters::marked_regions().
/// \param files       C++ files
/// \param complaints  gets one for each mark that is wrong
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
/// meant, and in folders named as_printed; or that it is pending and has no marks at all.
/// \param regions   from marked_regions()
/// \param listings  all that there are
/// \return a complaint for each line that is missing, and for each pending listing with marks and
///         each mark of a listing or line that does not exist
Complaints listing_gaps(const std::vector<MarkedRegion>& regions,
                        const std::vector<Listing>& listings);

}  // namespace tumble::structure
