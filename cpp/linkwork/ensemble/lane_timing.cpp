#include "linkwork/ensemble/lane_timing.hpp"

#include <algorithm>
#include <barrier>
#include <chrono>
#include <memory>
#include <thread>

#include "linkwork/math/error.hpp"
#include "linkwork/math/instruction_set.hpp"

namespace linkwork {
namespace {

/// Packs of `width` mechanisms each, evaluated once.
struct FullPacks {
  FullPacks(const std::vector<Dynamics*>& dynamics, const InstructionSet& widest) : structure(*dynamics.front()) {
    const int width = lane_count(widest);
    for (std::size_t first = 0; first < dynamics.size(); first += width) {
      std::vector<Lane*> own;
      for (std::size_t k = first; k < first + width; ++k) {
        lanes.push_back(std::make_unique<Lane>(*dynamics[k], steps));
        own.push_back(lanes.back().get());
      }
      packs.push_back(std::make_unique<LanePack>(structure, widest, own, euler, steps));
      packs.back()->evaluate_start(1);
    }
  }

  LaneStructure structure;
  ButcherTableau euler{"", 1, MatrixXd::Zero(1, 1), VectorXd::Ones(1), VectorXd::Zero(1)};
  FixedSteps steps{0.0, 1.0, 1};
  std::vector<std::unique_ptr<Lane>> lanes;
  std::vector<std::unique_ptr<LanePack>> packs;
};

/// Wall time of so many evaluations by each pack on a thread of its own, from the first to begin to the last to end [s].
double seconds_of(FullPacks& all, int repetitions) {
  using Clock = std::chrono::steady_clock;
  std::barrier together(std::ssize(all.packs));
  std::vector<Clock::time_point> begun(all.packs.size()), ended(all.packs.size());
  std::vector<std::thread> workers;
  for (std::size_t k = 0; k < all.packs.size(); ++k)
    workers.emplace_back([&, k] {
      const OnePath path(true);
      together.arrive_and_wait();
      begun[k] = Clock::now();
      all.packs[k]->evaluate_start(repetitions);
      ended[k] = Clock::now();
    });
  for (std::thread& worker : workers) worker.join();
  const std::chrono::duration<double> spent =
      *std::max_element(ended.begin(), ended.end()) - *std::min_element(begun.begin(), begun.end());
  return spent.count();
}

}  // namespace

int lane_count(const InstructionSet& widest) { return lane_kernels(widest).width; }

LaneTiming time_lanes(const std::vector<Dynamics*>& dynamics, int repetitions, int threads,
                      const InstructionSet& widest) {
  const int width = lane_count(widest);
  if (threads < 1 || static_cast<int>(dynamics.size()) != threads * width)
    throw OptionError("lanes", "give " + std::to_string(width) + " mechanisms for each thread");
  for (const Dynamics* it : dynamics)
    if (const std::string why = LaneStructure::refusal(*it); !why.empty()) throw OptionError("lanes", why);
  const OnePath path(true);
  FullPacks all(dynamics, widest);
  LaneTiming out{threads * width, seconds_of(all, repetitions) / repetitions, {}};
  for (const auto& pack : all.packs)
    for (int l = 0; l < width; ++l) out.v_dot.push_back(pack->accelerations(l));
  return out;
}

}  // namespace linkwork
