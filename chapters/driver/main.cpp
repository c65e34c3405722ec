/// \file
/// \brief The program that computes the figures of one chapter, TUMBLE_CHAPTER.
#include "driver/driver.hpp"

// Computes the chapter's figures; see run_chapter() for the options.
int main(int argc, char** argv) {
  return tumble::chapters::run_chapter(argc, argv, TUMBLE_CHAPTER, TUMBLE_CHAPTER_FOLDER);
}
