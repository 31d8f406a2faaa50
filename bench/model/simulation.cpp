#include "simulation.hpp"

#include <algorithm>

#include "../../core/support/announcement.hpp"

namespace pardel::bench {
namespace {

class Clocks {
 public:
  Clocks(int ranks, const RankCosts& costs, const Network& network)
      : ranks_(ranks),
        costs_(costs),
        network_(network),
        clock_(static_cast<std::size_t>(ranks), costs.before + costs.divide) {
    p_.before = costs.before;
    p_.divide = costs.divide;
  }

  void take(const Step& step) {
    work(step);
    wait();
    const double announced = network_.all_to_all(ranks_, sizeof(Announcement));
    for (double& clock : clock_) clock += announced;
    p_.announcements += announced;
    if (step.is_sum()) return sum(static_cast<double>(step.bytes));
    for (std::size_t rank = 0; rank < step.traffic.size(); ++rank) receive(rank, step.traffic[rank]);
  }

  [[nodiscard]] Prediction finish() {
    wait();
    p_.seconds = clock_.front();
    for (double* part : {&p_.work, &p_.messages, &p_.waiting, &p_.transfer}) *part /= ranks_;
    return p_;
  }

 private:
  void work(const Step& step) {
    if (step.kind == Step::Kind::changes) {
      for (double& clock : clock_) clock += costs_.phase;
      p_.phases += costs_.phase;
    }
    for (std::size_t rank = 0; rank < step.work.size(); ++rank) {
      clock_[rank] += step.work[rank];
      p_.work += step.work[rank];
    }
    for (std::size_t rank = 0; rank < step.selection.size(); ++rank) {
      clock_[rank] += step.selection[rank];
      p_.messages += step.selection[rank];
    }
    for (std::size_t rank = 0; rank < step.traffic.size(); ++rank) {
      const double written = costs_.write_byte * static_cast<double>(step.traffic[rank].bytes_out);
      clock_[rank] += written;
      p_.messages += written;
    }
  }
  void wait() {
    const double last = *std::ranges::max_element(clock_);
    for (double& clock : clock_) {
      p_.waiting += last - clock;
      clock = last;
    }
  }
  void sum(double bytes) {
    const double taken = network_.all_reduce(ranks_, bytes);
    for (double& clock : clock_) clock += taken;
    p_.sums += taken;
  }
  void receive(std::size_t rank, const Traffic& traffic) {
    const double transfer = network_.messages(traffic);
    const double read = costs_.read_byte * static_cast<double>(traffic.bytes_in);
    clock_[rank] += transfer + read;
    p_.transfer += transfer;
    p_.messages += read;
  }

  int ranks_;
  RankCosts costs_;
  Network network_;
  std::vector<double> clock_;
  Prediction p_;
};

}  // namespace

std::vector<Step> repeated(const std::vector<Step>& steps, int traced_ranks, int ranks, std::uint64_t cells) {
  const auto traced = static_cast<std::size_t>(traced_ranks), wanted = static_cast<std::size_t>(ranks);
  std::vector<Step> all;
  for (const Step& step : steps) {
    Step& more = all.emplace_back(Step{.kind = step.kind, .bytes = step.bytes});
    if (step.kind == Step::Kind::cell_sum) more.bytes = sizeof(std::uint64_t) * cells;
    if (step.kind == Step::Kind::rank_sum) more.bytes = sizeof(std::uint64_t) * wanted;
    for (std::size_t rank = 0; rank < wanted; ++rank) {
      if (!step.work.empty()) more.work.push_back(step.work[rank % traced]);
      if (!step.selection.empty()) more.selection.push_back(step.selection[rank % traced]);
      if (!step.traffic.empty()) more.traffic.push_back(step.traffic[rank % traced]);
    }
    if (step.kind == Step::Kind::piece)
      for (Traffic& t : more.traffic) t.messages_out = t.messages_in = static_cast<std::uint32_t>(ranks - 1);
  }
  return all;
}

Prediction simulate(int ranks, const std::vector<Step>& steps, const RankCosts& costs, const Network& network) {
  Clocks clocks(ranks, costs, network);
  for (const Step& step : steps) clocks.take(step);
  return clocks.finish();
}

}  // namespace pardel::bench
