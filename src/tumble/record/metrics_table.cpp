/// \file
/// \brief The columns of metrics.csv.
#include "tumble/record/metrics_table.hpp"

#include <array>

namespace tumble {
namespace {

using M = Metrics;
using R = StepReport;

double number(std::int64_t count) { return static_cast<double>(count); }  // exact below 2^53

constexpr std::array kColumns = {
    MetricsColumn{"kinetic_J", false, [](const M& m, const R&) { return m.kinetic; }},
    MetricsColumn{"potential_J", false, [](const M& m, const R&) { return m.potential; }},
    MetricsColumn{"total_J", false, [](const M& m, const R&) { return m.kinetic + m.potential; }},
    MetricsColumn{"booked_restitution_J", false,
                  [](const M& m, const R&) { return m.booked.restitution; }},
    MetricsColumn{"booked_friction_J", false,
                  [](const M& m, const R&) { return m.booked.friction; }},
    MetricsColumn{"booked_damping_J", false, [](const M& m, const R&) { return m.booked.damping; }},
    MetricsColumn{"booked_repair_J", false, [](const M& m, const R&) { return m.booked.repair; }},
    MetricsColumn{"energy_error_J", false, [](const M& m, const R&) { return m.energy_error; }},
    MetricsColumn{"energy_error_mgL", false,
                  [](const M& m, const R&) { return m.energy_error_share; }},
    MetricsColumn{"momentum_x_kg_m_s", false,
                  [](const M& m, const R&) { return m.momentum_w.x(); }},
    MetricsColumn{"momentum_y_kg_m_s", false,
                  [](const M& m, const R&) { return m.momentum_w.y(); }},
    MetricsColumn{"momentum_z_kg_m_s", false,
                  [](const M& m, const R&) { return m.momentum_w.z(); }},
    MetricsColumn{"angular_momentum_x_kg_m2_s", false,
                  [](const M& m, const R&) { return m.angular_momentum_w.x(); }},
    MetricsColumn{"angular_momentum_y_kg_m2_s", false,
                  [](const M& m, const R&) { return m.angular_momentum_w.y(); }},
    MetricsColumn{"angular_momentum_z_kg_m2_s", false,
                  [](const M& m, const R&) { return m.angular_momentum_w.z(); }},
    MetricsColumn{"contacts", true, [](const M&, const R& r) { return number(r.contacts); }},
    MetricsColumn{"collisions", true, [](const M&, const R& r) { return number(r.events); }},
    MetricsColumn{"deepest_overlap_m", false,
                  [](const M& m, const R&) { return m.deepest_overlap; }},
    MetricsColumn{"chatter_amplitude_m", false,
                  [](const M& m, const R&) { return m.chatter.amplitude; }},
    MetricsColumn{"chatter_acceleration", false,
                  [](const M& m, const R&) { return m.chatter.acceleration; }},
    MetricsColumn{"chatter_bodies", true,
                  [](const M& m, const R&) { return number(m.chatter.bodies); }},
    MetricsColumn{"fastest_m_s", false, [](const M& m, const R&) { return m.fastest; }},
    MetricsColumn{"asleep", true, [](const M& m, const R&) { return number(m.asleep); }},
    MetricsColumn{"iterations", true, [](const M&, const R& r) { return number(r.iterations); }},
    MetricsColumn{"pivots", true, [](const M&, const R& r) { return number(r.pivots); }},
    MetricsColumn{"impulses", true, [](const M&, const R& r) { return number(r.impulses); }},
    MetricsColumn{"pair_tests", true, [](const M&, const R& r) { return number(r.pair_tests); }},
    MetricsColumn{"integrations", true,
                  [](const M&, const R& r) { return number(r.integrations); }},
    MetricsColumn{"searches", true, [](const M&, const R& r) { return number(r.searches); }},
    MetricsColumn{"rewinds", true, [](const M&, const R& r) { return number(r.rewinds); }},
    MetricsColumn{"restarts", true, [](const M&, const R& r) { return number(r.restarts); }},
    MetricsColumn{"fallbacks", true, [](const M&, const R& r) { return number(r.fallbacks); }},
};

}  // namespace

std::span<const MetricsColumn> metrics_columns() { return kColumns; }

}  // namespace tumble
