/// \file
/// \brief The options of the sub-commands, and what their help says at its end.
#pragma once

#include "request.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace tumble::app {

/// Refuses a word that is no number.
CLI::Validator number();

/// Refuses a word that is no whole number.
/// \param most the largest one that is taken; the smallest is 0
CLI::Validator whole(std::uint64_t most);

/// Refuses a word without letters, as an unset variable of a shell leaves it.
CLI::Validator not_empty();

/// Adds an option that takes items separated by commas, none of them empty.
/// \param option  with its dashes
/// \param help    what it means
/// \param take    called with each item, from first to last
void add_list(CLI::App& command, const std::string& option, const std::string& help,
              const std::function<void(const std::string&)>& take);

/// Adds the options about recording.
/// \param run     `tumble run` or `tumble view`
void add_recording_options(CLI::App& run, Request& request);

/// Adds the choice of a sampled motion.
/// \param command `tumble view` or `tumble render`
void add_motion_option(CLI::App& command, std::optional<int>& motion);

/// Adds the scene and the options of every command that runs it.
/// \param command `tumble run`, `tumble compare`, `tumble sample` or `tumble view`
void add_run_options(CLI::App& command, Request& request);

/// Adds what `tumble sample` has beside the scene.
void add_sample_options(CLI::App& command, Request& request, SampleRequest& sample);

/// Adds the options of `tumble render`.
void add_render_options(CLI::App& command, RenderRequest& request);

/// The end of the help on scenes: examples, and the format of a scene file.
inline constexpr const char* kSceneHelp =
    "Examples:\n"
    "  tumble run dice --duration 2 --set count=3\n"
    "  tumble run stack --technique damped --dt 0.01\n"
    "  tumble view mine.toml\n"
    "A scene file is TOML, with a table [[box]] for each box: size, position, mass and more.\n"
    "  tumble scenes two_boxes --toml > mine.toml   writes one to start from\n"
    "All keys: site/how_to_read.md of the sources (in the book: How to read, Scene files).\n";

/// The end of the help of `tumble sample`.
inline constexpr const char* kSampleHelp =
    "Examples:\n"
    "  tumble sample examples/scenes/bowling.toml --duration 3\n"
    "  tumble sample bowling.toml --samples 20 --chains 8 --out found\n"
    "  tumble sample bowling.toml --samples 40 --chains 8 --out found --resume   continues\n"
    "  tumble view found --motion 2\n"
    "Wishes are tables [[wish]] in the scene file, with a body and one of these kinds:\n"
    "  face_up, ends_in, topples, stands, moves, stays\n"
    "All keys: site/how_to_read.md of the sources (in the book: How to read, Wishes).\n";

/// The end of the help of `tumble render`.
inline constexpr const char* kRenderHelp =
    "Examples:\n"
    "  tumble render runs/dice-contact_damped --as gif\n"
    "  tumble render runs/dice-contact_damped --as png --strip 0,0.5,1\n"
    "  tumble view runs/dice-contact_damped          opens it in the browser\n";

/// The end of the help of the command itself.
inline constexpr const char* kHelp =
    "Begin with:\n"
    "  tumble scenes          the built-in scenes\n"
    "  tumble view pyramid    simulate one and see it in the browser\n"
    "  tumble run --help      more examples, and how to write a scene of your own\n";

}  // namespace tumble::app
