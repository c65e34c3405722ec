/// \file
/// \brief Words that a reader of comments, messages and test names would have to decode.
#pragma once

#include "structure/source_tree.hpp"

namespace tumble::structure {

/// Words in comments and texts of C++ that have a plainer one.
///
/// A body is "it", so who, whom, whoever, nobody and somebody are refused; tell and told (classify, report,
/// detect, show), let go (release), parting (separating), slip where a misprint is meant; "what is" in
/// documentation, and a brief that begins with What or Who, where a noun phrase says it.
/// \param files  C++ files
/// \return a complaint for each word, with the plainer one
Complaints old_dialect(const std::vector<SourceFile>& files);

}  // namespace tumble::structure
